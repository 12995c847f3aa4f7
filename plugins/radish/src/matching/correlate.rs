//! The pose within a window in which a sweep's echoes fall best on a submap: exhaustive but quick, by branch and bound
//! over ever finer grids (Olson 2009; Hess et al., "Real-time loop closure in 2D LIDAR SLAM", ICRA 2016).

use super::submap::{Submap, Turn};
use super::sweep::Vector;
use crate::log::Pose;
use std::collections::BinaryHeap;

/// Where to search, and how much worse a pose is for its distance from the one expected.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// The farthest that the place may be off along x and along y, metres.
    pub shift: f64,
    /// The farthest that the heading may be off, radians.
    pub turn: f64,
    /// The step between headings, radians.
    pub turn_step: f64,
    /// The distance and the turn that cost one penalty: metres, radians.
    pub deviation: (f64, f64),
    /// What a pose loses at that distance, as a share of the greatest score.
    pub penalty: f64,
    /// Poses with a score below this one are not looked for.
    pub least: f64,
}

/// The most sets of poses that are scored before the search gives up.
const EFFORT: usize = 200_000;

/// The most points that are looked at; of more, each second, third, and so on.
const POINTS: usize = 240;

/// Scores are compared as whole numbers of this part.
const UNIT: f64 = 1e6;

/// A set of poses: the same heading, and a square of places.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Branch {
    /// No pose of the set scores more.
    bound: i64,
    /// Lower is searched first among equals; then all fields decide, so that the order never depends on chance.
    finer: std::cmp::Reverse<u32>,
    heading: usize,
    x: i32,
    y: i32,
}

struct Search<'a> {
    submap: &'a Submap,
    window: Window,
    /// The cells of the points for each heading.
    headings: Vec<(f64, Vec<[i32; 2]>)>,
}

/// The best pose around the one expected and its mean likelihood from 0 to 1, without the penalty; none if no pose
/// scores enough. The points are in the laser's frame.
pub fn correlate(submap: &Submap, points: &[Vector], expected: Pose, window: Window) -> Option<(Pose, f64)> {
    if points.is_empty() {
        return None;
    }
    let steps = (window.turn / window.turn_step).ceil() as i32;
    let turns = (-steps..=steps).map(|i| f64::from(i) * window.turn_step);
    let every = points.len().div_ceil(POINTS).max(1);
    let cells = |turn: f64| {
        let at = Turn::of(Pose { theta: expected.theta + turn, ..expected });
        (turn, points.iter().step_by(every).map(|p| submap.cell(at.place(*p))).collect())
    };
    let search = Search { submap, window, headings: turns.map(cells).collect() };
    let best = search.best()?;
    let step = |cells: i32| f64::from(cells) * submap.resolution;
    let (x, y) = (expected.x + step(best.x), expected.y + step(best.y));
    let pose = Pose { x, y, theta: expected.theta + search.headings.get(best.heading)?.0 };
    Some((pose, search.likelihood(0, &best)))
}

impl Search<'_> {
    fn best(&self) -> Option<Branch> {
        let mut open: BinaryHeap<Branch> = self.roots().collect();
        let mut effort = 0;
        while let Some(branch) = open.pop() {
            if branch.finer.0 == 0 || effort > EFFORT {
                return (branch.finer.0 == 0).then_some(branch);
            }
            effort += 4;
            open.extend(self.split(&branch));
        }
        None
    }

    fn roots(&self) -> impl Iterator<Item = Branch> {
        let level = self.submap.top();
        let side = 1_i32 << level;
        let half = (self.window.shift / self.submap.resolution).ceil() as i32;
        let starts = move || (0..=(2 * half) / side).map(move |i| i * side - half);
        let headings = 0..self.headings.len();
        headings.flat_map(move |heading| {
            starts().flat_map(move |y| starts().filter_map(move |x| self.branch(level, heading, x, y)))
        })
    }

    fn split(&self, branch: &Branch) -> impl Iterator<Item = Branch> {
        let level = branch.finer.0 - 1;
        let side = 1_i32 << level;
        let (heading, x, y) = (branch.heading, branch.x, branch.y);
        [(0, 0), (side, 0), (0, side), (side, side)]
            .into_iter()
            .filter_map(move |(dx, dy)| self.branch(level, heading, x + dx, y + dy))
    }

    /// The set of poses, unless all score too little.
    fn branch(&self, level: u32, heading: usize, x: i32, y: i32) -> Option<Branch> {
        let mut branch = Branch { bound: 0, finer: std::cmp::Reverse(level), heading, x, y };
        let likelihood = self.likelihood(level, &branch);
        if likelihood < self.window.least {
            return None;
        }
        branch.bound = ((likelihood - self.penalty(level, &branch)) * UNIT) as i64;
        Some(branch)
    }

    fn likelihood(&self, level: u32, branch: &Branch) -> f64 {
        let Some((_, cells)) = self.headings.get(branch.heading) else { return 0.0 };
        let at = |c: &[i32; 2]| {
            u64::from(self.submap.likelihood(
                level,
                c[0].saturating_add(branch.x),
                c[1].saturating_add(branch.y),
            ))
        };
        cells.iter().map(at).sum::<u64>() as f64 / (255.0 * cells.len() as f64)
    }

    /// The least penalty of the set's poses.
    fn penalty(&self, level: u32, branch: &Branch) -> f64 {
        let side = (1_i32 << level) - 1;
        let off = |low: i32| f64::from(0.clamp(low, low + side)) * self.submap.resolution;
        let shift = off(branch.x).hypot(off(branch.y)) / self.window.deviation.0;
        let turn = self.headings.get(branch.heading).map_or(0.0, |h| h.0) / self.window.deviation.1;
        self.window.penalty * (shift * shift + turn * turn)
    }
}
