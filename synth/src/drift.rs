//! What a robot believes of its pose: two kinds of error.

use crate::rng::Rng;
use crate::scan_params::{Noise, within};
use planform_sdk::Pose;

/// What SLAM leaves of the pose's error: it wanders, but does not grow.
#[derive(Default)]
pub(crate) struct Drift {
    x: f64,
    y: f64,
    yaw: f64,
}

impl Drift {
    pub(crate) fn wander(&mut self, noise: &Noise, travelled: f64, rng: &mut Rng) {
        let keep = (-travelled / noise.drift_length.max(0.1)).exp();
        let mut walk = |value: f64, spread: f64| {
            let spread = within(spread, 0.0, 1.0);
            let next = keep * value + (1.0 - keep * keep).sqrt() * spread * rng.gauss();
            next.clamp(-2.5 * spread, 2.5 * spread)
        };
        self.x = walk(self.x, noise.drift_position);
        self.y = walk(self.y, noise.drift_position);
        self.yaw = walk(self.yaw, noise.drift_yaw);
    }

    pub(crate) fn moved(&self, pose: Pose) -> Pose {
        Pose { x: pose.x + self.x, y: pose.y + self.y, yaw: pose.yaw + self.yaw }
    }
}

/// The way over which an error gains its spread, metres.
const WAY: f64 = 100.0;

/// What dead reckoning adds up: the errors of heading and position gain with the way, and a wrong heading leads every
/// further step astray.
pub(crate) struct Growth {
    rng: Rng,
    x: f64,
    y: f64,
    yaw: f64,
}

impl Growth {
    /// Draws from a stream of its own, so that it changes nothing else of the scan.
    pub(crate) fn new(seed: u64) -> Self {
        Self { rng: Rng::new(seed, 102), x: 0.0, y: 0.0, yaw: 0.0 }
    }

    /// The robot went on by `(dx, dy)`, metres.
    pub(crate) fn follow(&mut self, noise: &Noise, (dx, dy): (f64, f64)) {
        let root = (dx.hypot(dy) / WAY).sqrt();
        let mut gain = |spread: f64| within(spread, 0.0, 1.0) * root * self.rng.gauss();
        self.yaw += gain(noise.growth_yaw);
        let (sin, cos) = self.yaw.sin_cos();
        self.x += cos * dx - sin * dy - dx + gain(noise.growth_position);
        self.y += sin * dx + cos * dy - dy + gain(noise.growth_position);
    }

    pub(crate) fn moved(&self, pose: Pose) -> Pose {
        Pose { x: pose.x + self.x, y: pose.y + self.y, yaw: pose.yaw + self.yaw }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where robots believe to be after 100 m along x in steps of 0.5 m.
    fn after_100_m(noise: &Noise) -> Vec<Pose> {
        let drive = |seed| {
            let mut growth = Growth::new(seed);
            (0..200).for_each(|_| growth.follow(noise, (0.5, 0.0)));
            growth.moved(Pose { x: 100.0, y: 0.0, yaw: 0.0 })
        };
        (0..400).map(drive).collect()
    }

    fn spread(of: impl Fn(&Pose) -> f64, poses: &[Pose]) -> f64 {
        (poses.iter().map(|p| of(p).powi(2)).sum::<f64>() / poses.len() as f64).sqrt()
    }

    #[test]
    fn without_growth_the_robot_knows_where_it_is() {
        let exact = Pose { x: 100.0, y: 0.0, yaw: 0.0 };
        assert!(after_100_m(&Noise::heavy()).iter().all(|&p| p == exact));
    }

    #[test]
    fn errors_have_their_spread_after_100_m() {
        let position = after_100_m(&Noise { growth_position: 0.3, ..Noise::none() });
        for wrong in [spread(|p| p.x - 100.0, &position), spread(|p| p.y, &position)] {
            assert!((wrong - 0.3).abs() < 0.04, "{wrong}");
        }
        let yaw = after_100_m(&Noise { growth_yaw: 0.02, ..Noise::none() });
        assert!((spread(|p| p.yaw, &yaw) - 0.02).abs() < 0.003);
        // A random walk of the heading, summed up along the way: its spread times the way over the root of 3.
        assert!((spread(|p| p.y, &yaw) - 0.02 * 100.0 / 3f64.sqrt()).abs() < 0.15);
    }
}
