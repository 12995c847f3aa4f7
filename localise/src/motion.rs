//! How a robot moves, as far as its odometry tells.

use crate::{Random, distance, then, turn};
use planform_sdk::Pose;

/// A motion by odometry: a turn, a straight way, and another turn (Probabilistic Robotics, 5.4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// The first turn, radians.
    pub first: f64,
    /// The way, metres.
    pub way: f64,
    /// The second turn, radians.
    pub second: f64,
}

/// A way shorter than this has no direction, metres.
const STANDING: f64 = 0.01;

/// How wrong odometry is: the parameters alpha 1 to 4 of the odometry motion model, as standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionNoise {
    /// Of a turn by the turn itself, radians for each radian.
    pub turn_by_turn: f64,
    /// Of a turn by the way, radians for each metre.
    pub turn_by_way: f64,
    /// Of a way by itself, metres for each metre.
    pub way_by_way: f64,
    /// Of a way by the turns, metres for each radian.
    pub way_by_turn: f64,
}

impl Default for MotionNoise {
    fn default() -> Self {
        Self { turn_by_turn: 0.2, turn_by_way: 0.05, way_by_way: 0.15, way_by_turn: 0.05 }
    }
}

impl Motion {
    /// The motion from one pose of odometry to the next.
    pub fn between(from: Pose, to: Pose) -> Self {
        let way = distance(from, to);
        let whole = turn(from.yaw, to.yaw);
        if way < STANDING {
            return Self { first: 0.0, way, second: whole };
        }
        let first = turn(from.yaw, (to.y - from.y).atan2(to.x - from.x));
        Self { first, way, second: turn(first, whole) }
    }

    /// Where the motion leads from this pose.
    pub fn lead(&self, from: Pose) -> Pose {
        let turned = Pose { yaw: from.yaw + self.first, ..from };
        let there = then(turned, Pose { x: self.way, y: 0.0, yaw: 0.0 });
        Pose { yaw: there.yaw + self.second, ..there }
    }

    /// One of the motions that may lie behind this one (table 5.6).
    pub fn sample(&self, noise: &MotionNoise, random: &mut Random) -> Self {
        // Who drives backwards does not turn about for it.
        let size = |turn: f64| turn.abs().min(std::f64::consts::PI - turn.abs());
        let of_turn = |turn: f64| noise.turn_by_turn * size(turn) + noise.turn_by_way * self.way;
        let of_way = noise.way_by_way * self.way + noise.way_by_turn * (size(self.first) + size(self.second));
        Self {
            first: self.first + random.normal(of_turn(self.first)),
            way: self.way + random.normal(of_way),
            second: self.second + random.normal(of_turn(self.second)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_leads_where_it_came_from() {
        let (a, b) = (Pose { x: 1.0, y: 2.0, yaw: 3.0 }, Pose { x: 0.5, y: 2.5, yaw: -2.5 });
        let led = Motion::between(a, b).lead(a);
        assert!(distance(led, b) < 1e-9 && turn(led.yaw, b.yaw).abs() < 1e-9);
    }
}
