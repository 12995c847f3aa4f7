//! A robot followed along a log.

use crate::{Filter, Motion, Sweep, distance, turn};
use planform_sdk::Pose;

/// One moment of a log.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Where the laser is by odometry alone.
    pub odometry: Pose,
    /// Where the laser truly is, in the map frame.
    pub truth: Pose,
    /// What it sees.
    pub sweep: Sweep,
}

/// The filter takes in a sweep after so many metres or radians.
const UPDATE: [f64; 2] = [0.2, 0.2];

/// How far a filter's estimates are from the truth.
#[derive(Debug, Clone, Default)]
pub struct Errors {
    /// Metres, one for each sweep that was taken in.
    pub position: Vec<f64>,
    /// Radians, likewise.
    pub heading: Vec<f64>,
    /// The estimates themselves.
    pub estimates: Vec<Pose>,
}

impl Errors {
    /// Median and 95th percentile of the errors of position, metres, and of heading, radians.
    pub fn summary(&self) -> [f64; 4] {
        let at = |errors: &[f64], share: f64| {
            let mut sorted = errors.to_vec();
            sorted.sort_by(f64::total_cmp);
            let last = sorted.len().saturating_sub(1) as f64;
            sorted.get((last * share).round() as usize).copied().unwrap_or(f64::NAN)
        };
        let of = |errors| [at(errors, 0.5), at(errors, 0.95)];
        let ([a, b], [c, d]) = (of(&self.position), of(&self.heading));
        [a, b, c, d]
    }

    /// The greatest error of position among the last estimates, metres; infinite without any.
    pub fn at_the_end(&self, count: usize) -> f64 {
        let last = self.position.iter().rev().take(count).copied();
        if self.position.is_empty() { f64::INFINITY } else { last.fold(0.0, f64::max) }
    }
}

/// Has the filter take in the frames, and compares its estimates with the truth.
pub fn follow(filter: &mut Filter<'_>, frames: &[Frame]) -> Errors {
    let mut errors = Errors::default();
    let Some(first) = frames.first() else { return errors };
    let mut last = first.odometry;
    for frame in frames {
        let [way, turned] = UPDATE;
        let moved =
            distance(last, frame.odometry) >= way || turn(last.yaw, frame.odometry.yaw).abs() >= turned;
        if !moved {
            continue;
        }
        filter.step(&Motion::between(last, frame.odometry), &frame.sweep);
        last = frame.odometry;
        if let Some(estimate) = filter.estimate() {
            errors.position.push(distance(estimate, frame.truth));
            errors.heading.push(turn(estimate.yaw, frame.truth.yaw).abs());
            errors.estimates.push(estimate);
        }
    }
    errors
}
