//! Steps that no odometry measured: which of the fits ahead of the last scan is the right one.
//!
//! Along a corridor the mean likelihood of the echoes says little of how far the robot went: walls fit anywhere, and
//! where much is new, much does not fit. When every fit has been refined, the share of the echoes that lie on surfaces
//! tells more, for then a few doors and pillars are hit or missed.

use super::align::{Fit, align};
use super::correlate::{Window, correlate};
use super::graph::Edge;
use super::submap::Submap;
use super::sweep::Sweep;
use crate::log::Pose;
use nalgebra::Matrix3;

/// Where fits are looked for from the last pose on: so many times `APART` ahead, and to the left.
const AHEAD: std::ops::RangeInclusive<i32> = -1..=8;
const LEFT: std::ops::RangeInclusive<i32> = -1..=1;

/// The distance between two such places, metres.
const APART: f64 = 0.5;

/// What is searched around each; the heading is known from a wider search.
const AROUND: Window =
    Window { shift: 0.25, turn: 0.06, turn_step: 0.02, deviation: (1.0, 1.0), penalty: 0.0, least: 0.0 };

/// What an unusual step counts as, in echoes that lie on no surface, as a share.
const UNUSUAL: f64 = 0.03;

/// A turn of this much is a step by itself, radians.
const TURN: f64 = 0.3;

/// Farther back than this is not noise, metres.
const BACK: f64 = 0.2;

/// How far a robot goes until the first steps have shown it, metres.
const FIRST: f64 = 0.5;

/// How many steps show it.
const RECENT: usize = 15;

/// The likeliest of the fits near `start`, which is one of a wider search, and of those ahead of the last pose with its
/// heading.
pub fn likeliest(
    submap: &Submap,
    sweep: &Sweep,
    start: Pose,
    edges: &[Edge],
    last: Pose,
    prior: &Matrix3<f64>,
) -> Fit {
    let (theta, usual) = (last.turn(start), usual(edges));
    let fitted = |pose: Pose| {
        let fit = align(submap, sweep, pose, pose, prior);
        (fit, fit.inliers - UNUSUAL * oddity(last.to(fit.pose), usual))
    };
    let mut best = fitted(start);
    for (ahead, left) in AHEAD.flat_map(|ahead| LEFT.map(move |left| (ahead, left))) {
        let (x, y) = (f64::from(ahead) * APART, f64::from(left) * APART);
        let place = last.then(Pose { x, y, theta });
        let Some((pose, _)) = correlate(submap, &sweep.points, place, AROUND) else { continue };
        let next = fitted(pose);
        if next.1 > best.1 {
            best = next;
        }
    }
    best.0
}

/// How far the robot usually goes in a step ahead, metres.
fn usual(edges: &[Edge]) -> f64 {
    let ahead = edges.iter().rev().map(|edge| edge.step.x).filter(|x| *x > BACK / 2.0);
    let mut ahead: Vec<f64> = ahead.take(RECENT).collect();
    ahead.sort_by(f64::total_cmp);
    ahead.get(ahead.len() / 2).copied().unwrap_or(FIRST)
}

/// How odd a step is, from 0 to 1, and up to 2 if it leads back: robots turn on the spot, or go on as far as they usually
/// do.
fn oddity(step: Pose, usual: f64) -> f64 {
    let turn = Pose::IDENTITY.turn(step).abs();
    let scale = usual + BACK;
    let on = (step.x - usual).abs() / scale;
    let still = step.x.abs() / scale + (1.0 - turn / TURN).max(0.0);
    on.min(still).min(1.0) + f64::from(u8::from(step.x < -BACK))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(x: f64, theta: f64) -> Pose {
        Pose { x, theta, ..Pose::IDENTITY }
    }

    #[test]
    fn to_go_on_or_to_turn_is_usual_and_to_stay_or_go_back_is_not() {
        let odd = |x: f64, theta: f64| oddity(step(x, theta), 1.0);
        assert_eq!((odd(1.0, 0.0), odd(0.0, -0.7)), (0.0, 0.0));
        assert!(odd(0.0, 0.0) > 0.8 && odd(1.5, 0.0) < odd(2.5, 0.0));
        assert!(odd(-1.0, 0.0) > 1.5 && odd(-0.1, 1.0) < 0.2);
    }

    #[test]
    fn the_usual_step_is_that_of_the_last_ones_ahead() {
        let edge = |x: f64| Edge {
            from: 0,
            to: 1,
            step: step(x, 0.0),
            information: Matrix3::zeros(),
            closes: false,
        };
        assert_eq!(usual(&[]), FIRST);
        assert_eq!(usual(&[edge(1.0), edge(0.0), edge(2.0), edge(0.01), edge(1.5)]), 1.5);
        let long_ago = std::iter::repeat_with(|| edge(9.0)).take(20);
        let edges: Vec<_> = long_ago.chain(std::iter::repeat_with(|| edge(0.4)).take(RECENT)).collect();
        assert_eq!(usual(&edges), 0.4);
    }
}
