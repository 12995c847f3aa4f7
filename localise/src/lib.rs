//! Shows that a robot finds itself on the map of a layout: Monte Carlo localisation after Thrun, Burgard and Fox,
//! "Probabilistic Robotics" (2005), on occupancy grids. A tool for tests and measurements, no part of the program.
//!
//! [`Filter`] follows a robot by its odometry and its laser, from where it is known to be or from anywhere;
//! [`Field`] is the map as the filter needs it; [`World`] simulates a robot with a laser in a known building.

mod field;
mod filter;
mod motion;
mod random;
mod track;
mod world;

pub use field::Field;
pub use filter::{Filter, Params};
pub use motion::{Motion, MotionNoise};
pub use random::Random;
pub use track::{Errors, Frame, follow};
pub use world::{Laser, Walk, World};

use planform_sdk::Pose;

/// One sweep of a laser: `ranges[i]` in metres is the beam at `first_angle + i * step`, radians counter-clockwise from
/// the laser's heading. A range at or beyond `max_range`, zero or NaN is no echo.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// Metres to what each beam hit.
    pub ranges: Vec<f32>,
    /// Direction of the first beam, radians.
    pub first_angle: f64,
    /// Turn from one beam to the next, radians.
    pub step: f64,
    /// Where echoes end, metres.
    pub max_range: f64,
}

/// The pose that is `step` as seen from `from`.
pub fn then(from: Pose, step: Pose) -> Pose {
    let (sin, cos) = from.yaw.sin_cos();
    let (x, y) = (from.x + cos * step.x - sin * step.y, from.y + sin * step.x + cos * step.y);
    Pose { x, y, yaw: from.yaw + step.yaw }
}

/// Metres between two poses' places.
pub fn distance(a: Pose, b: Pose) -> f64 {
    (a.x - b.x).hypot(a.y - b.y)
}

/// The turn from one heading to another, radians in [-pi, pi].
pub fn turn(from: f64, to: f64) -> f64 {
    let turned = to - from;
    turned.sin().atan2(turned.cos())
}
