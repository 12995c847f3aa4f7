//! How a robot looks at a building, and how badly.

use std::f64::consts::TAU;

/// How the robot maps.
#[derive(Debug, Clone, PartialEq)]
pub struct ScanParams {
    /// Seed of noise, furniture and of what stays unexplored; independent of the building's.
    pub seed: u64,
    /// Metres per cell.
    pub resolution: f64,
    /// The laser.
    pub laser: Laser,
    /// What goes wrong.
    pub noise: Noise,
    /// How much furniture there is, 0 (none) to 1 (crowded).
    pub furniture: f64,
    /// How many desks and cupboards there are that the laser does not see through, 0 (none) to 1 (crowded).
    pub clutter: f64,
    /// Share of the rooms that the robot does not enter, 0 to 1.
    pub unexplored: f64,
    /// Share of these whose doors are closed, so that nothing of them is seen, 0 to 1. On account of the others the
    /// robot stops early; it has seen into some of them.
    pub closed_doors: f64,
    /// Share of the longer outer walls with a window that lets rays out, 0 to 1.
    pub glass: f64,
    /// What the cells say.
    pub output: Output,
}

impl Default for ScanParams {
    fn default() -> Self {
        Self {
            seed: 0,
            resolution: 0.05,
            laser: Laser::default(),
            noise: Noise::default(),
            furniture: 0.0,
            clutter: 0.0,
            unexplored: 0.0,
            closed_doors: 0.5,
            glass: 0.0,
            output: Output::default(),
        }
    }
}

/// A laser range finder and how often it is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Laser {
    /// Rays per reading.
    pub rays: u32,
    /// Field of view, radians, centred on the direction of travel.
    pub view: f64,
    /// Farther obstacles are not seen, metres; the ray then counts as free up to here.
    pub max_range: f64,
    /// Way between two readings, metres.
    pub stride: f64,
}

impl Default for Laser {
    fn default() -> Self {
        Self { rays: 360, view: TAU, max_range: 20.0, stride: 0.4 }
    }
}

/// Errors of the laser and of the pose. Lengths in metres, angles in radians, all standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Of a range.
    pub range: f64,
    /// Of the robot's position, as SLAM leaves it.
    pub drift_position: f64,
    /// Of the robot's heading, as SLAM leaves it.
    pub drift_yaw: f64,
    /// The way over which the pose's error changes.
    pub drift_length: f64,
    /// Of the error that the robot's position gains over 100 m of way, and that nothing corrects.
    pub growth_position: f64,
    /// Of the error that the robot's heading gains over 100 m of way, and that nothing corrects. The map bends by it.
    pub growth_yaw: f64,
    /// Probability that a ray measures nonsense.
    pub outliers: f64,
}

impl Noise {
    /// A perfect robot.
    pub const fn none() -> Self {
        Self {
            range: 0.0,
            drift_position: 0.0,
            drift_yaw: 0.0,
            drift_length: 12.0,
            growth_position: 0.0,
            growth_yaw: 0.0,
            outliers: 0.0,
        }
    }

    /// A poor robot: bent and double walls, many specks.
    pub const fn heavy() -> Self {
        Self {
            range: 0.03,
            drift_position: 0.07,
            drift_yaw: 0.010,
            drift_length: 15.0,
            outliers: 0.003,
            ..Self::none()
        }
    }
}

impl Default for Noise {
    /// A usual robot.
    fn default() -> Self {
        Self { range: 0.015, drift_position: 0.025, drift_yaw: 0.003, outliers: 0.0005, ..Self::none() }
    }
}

/// What a cell says of the rays that ended in it and those that passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Output {
    /// 0 or 100, by gmapping's default threshold of 25 %.
    #[default]
    Thresholded,
    /// The percentage of rays that ended there.
    Probabilities,
}

/// The value brought into its range; what is no number becomes the least.
pub(crate) fn within(value: f64, least: f64, most: f64) -> f64 {
    if value.is_nan() { least } else { value.clamp(least, most) }
}
