//! What is varied.

use crate::trial::Trial;

/// One thing that makes maps worse, or only different.
pub struct Factor {
    /// What it is, for people.
    pub name: &'static str,
    /// What the values are.
    pub unit: &'static str,
    /// The values, each of which is tried.
    pub values: &'static [f64],
    /// Sets a value.
    pub set: fn(&mut Trial, f64),
}

/// All of them, as they are plotted: three in a row.
pub const FACTORS: [Factor; 6] = [
    Factor {
        name: "Range noise",
        unit: "standard deviation of a range, m",
        values: &[0.0, 0.02, 0.04, 0.06, 0.08, 0.1],
        set: |trial, value| trial.scan.noise.range = value,
    },
    Factor {
        name: "Pose drift",
        unit: "error gained over 100 m of way, m (and 0.1 rad for each m)",
        values: &[0.0, 0.05, 0.1, 0.2, 0.3, 0.4],
        set: |trial, value| {
            trial.scan.noise.growth_position = value;
            trial.scan.noise.growth_yaw = value / 10.0;
        },
    },
    Factor {
        name: "Furniture",
        unit: "density, from none to crowded",
        values: &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0],
        set: |trial, value| trial.scan.furniture = value,
    },
    Factor {
        name: "Rotation",
        unit: "direction of the building's axes, degrees",
        values: &[0.0, 7.5, 15.0, 22.5, 30.0, 37.5, 45.0, 52.5, 60.0, 67.5, 75.0, 82.5, 90.0],
        set: |trial, value| trial.building.yaw = Some(value.to_radians()),
    },
    Factor {
        name: "Resolution",
        unit: "side of a cell, m",
        values: &[0.025, 0.05, 0.075, 0.1],
        set: |trial, value| trial.scan.resolution = value,
    },
    Factor {
        name: "Share explored",
        unit: "rooms that the robot entered, of all",
        values: &[1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3],
        set: |trial, value| trial.scan.unexplored = 1.0 - value,
    },
];
