//! Scan matching: from laser scans with the odometry of wheels to the poses at which the scans fit each other.
//!
//! 1. Each scan that is some way from the last one is laid over those shortly before it, `track`: by correlative search
//!    around where odometry expects it, then by least squares from points to lines; without odometry also farther
//!    ahead, `unmeasured`.
//! 2. Stretches of the path are laid over older ones nearby, `closure`; what fits becomes a step of a graph of poses,
//!    whose error is then spread over all of it, `graph`.
//! 3. The scans in between follow those that were matched.
//!
//! The system of equations of that graph is solved by our own `eliminate`, as the crates that do it would bring along
//! a C compiler or some fifty other crates, or leave the order of elimination to their callers.

mod align;
mod closure;
mod correlate;
mod eliminate;
mod graph;
mod odometry;
mod submap;
mod sweep;
#[cfg(test)]
mod tests;
mod track;
mod unmeasured;

use crate::log::{Pose, Scan};
use track::Track;

/// How scans are matched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchingParams {
    /// Echoes farther away than this are not used, metres.
    pub reach: f64,
    /// The way after which a scan is matched again, metres.
    pub key_distance: f64,
    /// The turn after which a scan is matched again, radians.
    pub key_turn: f64,
    /// The cells of the grids in which poses are searched, metres.
    pub resolution: f64,
    /// Standard deviation of an echo's place in them, metres.
    pub spread: f64,
    /// How many scans the one to be matched is laid over.
    pub recent: usize,
}

impl Default for MatchingParams {
    fn default() -> Self {
        Self { reach: 30.0, key_distance: 0.3, key_turn: 0.25, resolution: 0.05, spread: 0.1, recent: 15 }
    }
}

impl MatchingParams {
    /// Whether a step is too short to match again.
    fn is_short(&self, step: Pose) -> bool {
        let turn = Pose::IDENTITY.turn(step).abs();
        step.x.hypot(step.y) < self.key_distance && turn < self.key_turn
    }
}

/// The poses that were found, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// One for each scan, the first one as odometry has it: x, y in metres, heading in radians.
    pub poses: Vec<Pose>,
    /// How many scans were laid over others; the rest follow them.
    pub matched: usize,
    /// How many loops were closed.
    pub loops: usize,
    /// Whether the log has odometry. Without it a long straight corridor may come out too short or too long.
    pub odometry: bool,
}

/// The poses at which the scans fit each other, from their odometry (or from their poses, where those are odometry).
/// `progress` is told the share of the work that is done. The same scans give the same poses, whatever the number of
/// threads.
pub fn corrected(scans: &[Scan], params: &MatchingParams, progress: &mut dyn FnMut(f64)) -> Matched {
    corrected_on(planform_sdk::parallel::threads(), scans, params, progress)
}

fn corrected_on(
    threads: usize,
    scans: &[Scan],
    params: &MatchingParams,
    progress: &mut dyn FnMut(f64),
) -> Matched {
    let odometry = odometry::of(scans);
    let track = Track::follow(scans, odometry.as_deref(), params, &mut |done| progress(done / 2.0));
    let mut graph = track.graph.clone();
    let loops =
        closure::close(&track.keys, &mut graph, params, threads, &mut |done| progress(0.5 + done / 2.0));
    let poses = spread(&track, &graph.poses);
    Matched { poses, matched: track.keys.len(), loops, odometry: odometry.is_some() }
}

/// The poses of all scans when the keys have moved here: those between two keys go with the nearer one the more.
fn spread(track: &Track, keys: &[Pose]) -> Vec<Pose> {
    let moved = |key: usize, pose: Pose| keys[key].then(track.graph.poses[key].to(pose));
    let mut key = 0;
    let place = |(scan, pose): (usize, &Pose)| {
        while track.keys.get(key + 1).is_some_and(|next| next.scan <= scan) {
            key += 1;
        }
        let before = moved(key, *pose);
        let Some(next) = track.keys.get(key + 1) else { return before };
        let (from, to) = (track.keys[key].scan, next.scan);
        between(before, moved(key + 1, *pose), (scan - from) as f64 / (to - from) as f64)
    };
    track.poses.iter().enumerate().map(place).collect()
}

/// The pose at this share of the way from one to another.
fn between(a: Pose, b: Pose, share: f64) -> Pose {
    let mix = |a: f64, b: f64| a + share * (b - a);
    Pose { x: mix(a.x, b.x), y: mix(a.y, b.y), theta: a.theta + share * a.turn(b) }
}
