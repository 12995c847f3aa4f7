//! What a laser log says, and how a CARMEN log is read.

mod fields;
mod geometry;
mod lines;
mod message;
mod odometry;
mod parameters;
mod reader;

pub use reader::{LaserChoice, is_log, read};

/// A pose in the plane: metres, radians counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Metres.
    pub x: f64,
    /// Metres.
    pub y: f64,
    /// Heading, radians counter-clockwise from the x axis; need not be within one turn.
    pub theta: f64,
}

impl Pose {
    /// The origin.
    pub const IDENTITY: Self = Self { x: 0.0, y: 0.0, theta: 0.0 };

    /// The pose that is `step` as seen from this one.
    pub fn then(self, step: Self) -> Self {
        let (sin, cos) = self.theta.sin_cos();
        let (x, y) = (self.x + cos * step.x - sin * step.y, self.y + sin * step.x + cos * step.y);
        Self { x, y, theta: self.theta + step.theta }
    }

    /// The other pose as seen from this one.
    pub fn to(self, other: Self) -> Self {
        let (sin, cos) = self.theta.sin_cos();
        let (x, y) = (other.x - self.x, other.y - self.y);
        Self { x: cos * x + sin * y, y: cos * y - sin * x, theta: other.theta - self.theta }
    }

    /// Metres between the two places.
    pub fn distance(self, other: Self) -> f64 {
        (self.x - other.x).hypot(self.y - other.y)
    }

    /// The turn from this heading to the other's, radians in [-pi, pi].
    pub fn turn(self, other: Self) -> f64 {
        let turned = other.theta - self.theta;
        turned.sin().atan2(turned.cos())
    }
}

/// One sweep of a laser: `ranges[i]` in metres is the beam at `first_angle + i * step`, relative to the laser's
/// heading. A range at or beyond `max_range`, zero, negative or NaN is no echo.
#[derive(Clone, Debug)]
pub struct Scan {
    /// Metres to what each beam hit.
    pub ranges: Vec<f32>,
    /// Direction of the first beam, radians counter-clockwise from the laser's heading.
    pub first_angle: f64,
    /// Turn from one beam to the next, radians.
    pub step: f64,
    /// Where echoes end, metres.
    pub max_range: f64,
    /// The laser's pose as the log's message states it (corrected, in a corrected log).
    pub pose: Pose,
    /// The laser's pose by odometry alone, where the log has it apart from `pose`.
    pub odometry: Option<Pose>,
    /// Seconds, as the message states it; logs exist in which it means nothing.
    pub time: f64,
}

impl Scan {
    /// The beams' directions relative to the laser's heading, radians, and their ranges, metres.
    pub fn beams(&self) -> impl Iterator<Item = (f64, f32)> {
        self.ranges.iter().enumerate().map(|(i, range)| (self.first_angle + i as f64 * self.step, *range))
    }

    /// Whether a range is that of an echo.
    pub fn is_echo(&self, range: f32) -> bool {
        range > 0.0 && f64::from(range) < self.max_range
    }
}

/// A log: its sweeps in the order of their messages.
#[derive(Clone, Debug)]
pub struct Log {
    /// All sweeps that could be read.
    pub scans: Vec<Scan>,
    /// Where the scans' poses come from.
    pub poses: PoseKind,
    /// What the reader should know: one sentence each.
    pub warnings: Vec<String>,
}

/// Where the poses that a log states come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseKind {
    /// Something better than odometry: a map was made of this log before.
    Corrected,
    /// The wheels alone.
    Odometry,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_lead_from_pose_to_pose() {
        let (a, b) = (Pose { x: 1.0, y: -2.0, theta: 2.5 }, Pose { x: -3.0, y: 0.5, theta: -1.0 });
        let again = a.then(a.to(b));
        assert!(again.distance(b) < 1e-12 && again.turn(b).abs() < 1e-12);
        let left = Pose { x: 0.0, y: 0.0, theta: std::f64::consts::FRAC_PI_2 };
        let ahead = left.then(Pose { x: 2.0, ..Pose::IDENTITY });
        assert!(ahead.distance(Pose { x: 0.0, y: 2.0, theta: 0.0 }) < 1e-12);
    }

    #[test]
    fn headings_differ_by_at_most_half_a_turn() {
        let heading = |theta| Pose { theta, ..Pose::IDENTITY };
        assert!((heading(3.0).turn(heading(-3.0)) - (std::f64::consts::TAU - 6.0)).abs() < 1e-12);
        assert!((heading(7.0).turn(heading(0.5)) + 6.5 - std::f64::consts::TAU).abs() < 1e-12);
    }
}
