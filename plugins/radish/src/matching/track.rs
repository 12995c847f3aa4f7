//! From scan to scan: each is laid over those shortly before it, from where odometry expects it.

use super::MatchingParams;
use super::align::align;
use super::correlate::{Window, correlate};
use super::graph::{Edge, Graph};
use super::odometry;
use super::submap::Submap;
use super::sweep::Sweep;
use super::unmeasured;
use crate::log::{Pose, Scan};
use nalgebra::{Matrix3, Vector3};

/// Fewer echoes tell nothing of a pose.
const FEWEST_ECHOES: usize = 15;

/// A mean likelihood below this one sends the search farther out.
const GOOD: f64 = 0.55;

/// By how much more likelihood a pose farther out is preferred.
const BETTER: f64 = 0.1;

/// A mean likelihood below this one is no match.
const POOR: f64 = 0.3;

/// What a pose loses at one standard deviation of odometry, as a share of the greatest score.
const PENALTY: f64 = 0.01;

/// The path of the laser as the scans themselves tell it, bit by bit.
pub struct Track {
    /// The pose of each scan.
    pub poses: Vec<Pose>,
    /// The scans that are matched, some way apart; between them is odometry alone.
    pub keys: Vec<Key>,
    /// The poses of the keys, and the steps from each to the next.
    pub graph: Graph,
}

/// A scan that is matched.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its number in the log.
    pub scan: usize,
    /// Its echoes.
    pub sweep: Sweep,
}

/// How far off odometry may be for one step: standard deviations, metres and radians.
#[derive(Clone, Copy, Debug)]
struct Doubt {
    shift: f64,
    turn: f64,
    /// Whether there is odometry.
    measured: bool,
}

impl Track {
    /// Follows the scans. `odometry` has one pose for each, or is absent.
    pub fn follow(
        scans: &[Scan],
        odometry: Option<&[Pose]>,
        params: &MatchingParams,
        progress: &mut dyn FnMut(f64),
    ) -> Self {
        let start = odometry.and_then(|o| o.first().copied()).unwrap_or(Pose::IDENTITY);
        let mut track = Self::begin(scans.first(), start, params);
        for (i, scan) in scans.iter().enumerate().skip(1) {
            let step = track.keys.last().and_then(|key| Some(odometry?[key.scan].to(odometry?[i])));
            track.add(i, scan, step.filter(|s| odometry::is_step(*s)), params);
            progress((i + 1) as f64 / scans.len() as f64);
        }
        track
    }

    fn begin(first: Option<&Scan>, start: Pose, params: &MatchingParams) -> Self {
        let keys: Vec<Key> =
            first.iter().map(|scan| Key { scan: 0, sweep: Sweep::of(scan, params.reach) }).collect();
        let poses = vec![start; keys.len()];
        Self { poses: poses.clone(), keys, graph: Graph { poses, edges: vec![] } }
    }

    /// Adds a scan; `step` is what odometry says of the way from the last key to here, if it says anything.
    fn add(&mut self, i: usize, scan: &Scan, step: Option<Pose>, params: &MatchingParams) {
        let Some(last) = self.graph.poses.last().copied() else { return };
        let expected = last.then(step.unwrap_or_else(|| self.onwards()));
        if step.is_some_and(|step| params.is_short(step)) {
            return self.poses.push(expected);
        }
        let sweep = Sweep::of(scan, params.reach);
        let doubt = step.map_or(Doubt::UNMEASURED, Doubt::of);
        let (pose, information) = self.place(&sweep, expected, doubt, params);
        self.poses.push(pose);
        let step = last.to(pose);
        if !params.is_short(step) {
            let from = self.keys.len() - 1;
            self.graph.edges.push(Edge { from, to: from + 1, step, information, closes: false });
            self.graph.poses.push(pose);
            self.keys.push(Key { scan: i, sweep });
        }
    }

    /// The step to expect where nothing is measured: ahead, as far as last time.
    fn onwards(&self) -> Pose {
        let x = self.graph.edges.last().map_or(0.0, |edge| edge.step.x.clamp(0.0, 2.0));
        Pose { x, ..Pose::IDENTITY }
    }

    /// The pose of a sweep, and the inverse of its covariance.
    fn place(
        &self,
        sweep: &Sweep,
        expected: Pose,
        doubt: Doubt,
        params: &MatchingParams,
    ) -> (Pose, Matrix3<f64>) {
        let prior = doubt.information();
        if sweep.points.len() < FEWEST_ECHOES {
            return (expected, prior);
        }
        let submap = self.recent(expected, params);
        let near = doubt.window(3.0);
        let mut found = correlate(&submap, &sweep.points, expected, near);
        if found.is_none_or(|(_, score)| score < GOOD) {
            let wide = correlate(&submap, &sweep.points, expected, doubt.window(8.0));
            found = wide.filter(|w| found.is_none_or(|f| w.1 > f.1 + BETTER)).or(found);
        }
        let Some((start, _)) = found.filter(|(_, score)| *score >= POOR) else { return (expected, prior) };
        let fit = if doubt.measured {
            align(&submap, sweep, start, expected, &prior)
        } else {
            let last = self.graph.poses.last().copied().unwrap_or(expected);
            unmeasured::likeliest(&submap, sweep, start, &self.graph.edges, last, &prior)
        };
        (fit.pose, fit.information)
    }

    fn recent(&self, middle: Pose, params: &MatchingParams) -> Submap {
        let first = self.keys.len().saturating_sub(params.recent);
        let scans =
            self.keys[first..].iter().map(|k| &k.sweep).zip(self.graph.poses[first..].iter().copied());
        Submap::of(scans, middle, params.resolution, params.spread)
    }
}

impl Doubt {
    /// Of a step that nothing but the scans can tell.
    const UNMEASURED: Self = Self { shift: 0.8, turn: 0.4, measured: false };

    /// Of a step by odometry.
    fn of(step: Pose) -> Self {
        let (way, turn) = (step.x.hypot(step.y), Pose::IDENTITY.turn(step).abs());
        let shift = 0.05 + 0.1 * way + 0.05 * turn;
        Self { shift, turn: 0.03 + 0.02 * way + 0.25 * turn, measured: true }
    }

    fn information(self) -> Matrix3<f64> {
        let (shift, turn) = (self.shift.powi(-2), self.turn.powi(-2));
        Matrix3::from_diagonal(&Vector3::new(shift, shift, turn))
    }

    /// A window of this many standard deviations.
    fn window(self, times: f64) -> Window {
        let (shift, turn) = ((times * self.shift).min(4.0), (times * self.turn).min(1.6));
        let deviation = (self.shift, self.turn);
        Window { shift, turn, turn_step: 0.01, deviation, penalty: PENALTY, least: 0.0 }
    }
}
