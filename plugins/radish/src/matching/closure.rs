//! Places seen before: stretches of the path are laid over older ones nearby, and those that fit become steps of the
//! graph. A fit far from where the path was believed to be is a claim only, until others claim the same.

use super::MatchingParams;
use super::align::align;
use super::correlate::{Window, correlate};
use super::graph::{Edge, Graph};
use super::submap::{Submap, Turn};
use super::sweep::Sweep;
use super::track::Key;
use crate::log::Pose;
use nalgebra::{Matrix3, Vector3};
use std::cmp::Ordering;
use std::collections::{BTreeSet, BinaryHeap};

/// The way that a path may have taken since a place for it to be no loop, metres.
const LOCAL: f64 = 10.0;

/// How far apart stretches are tried, metres of the path.
const STRIDE: f64 = 1.5;

/// How many keys before one make a stretch with it.
const STRETCH: usize = 5;

/// How many keys to either side of an older one are what the stretch is laid over.
const AROUND: usize = 8;

/// The most places that a stretch is laid over.
const PLACES: usize = 3;

/// The way between two such places, metres.
const APART: f64 = 6.0;

/// The doubt of a place: what it is at least, how it grows with the way since, and what it is at most, metres.
const DOUBT: (f64, f64, f64) = (0.3, 0.025, 10.0);

/// The same of a heading, radians.
const TURN_DOUBT: (f64, f64, f64) = (0.05, 0.004, 0.35);

/// How far apart two places may be and see the same, metres.
const SIGHT: f64 = 4.0;

/// A doubt as small as this leaves nothing to confuse, metres.
const SURE: f64 = 1.0;

/// The least mean likelihood and the least share of points on surfaces of a fit.
const LEAST: (f64, f64) = (0.55, 0.55);

/// The stretches that are tried against one state of the graph.
const BATCH: usize = 8;

/// The way within which claims support each other, metres.
const SUPPORT: f64 = 20.0;

/// How many stretches must claim the same.
const SUPPORTERS: usize = 3;

/// How far claims that support each other may disagree: metres and its growth with the way between; radians.
const AGREE: (f64, f64, f64) = (0.2, 0.03, 0.06);

/// Loops with a larger squared error than this change the graph, in units of their variance.
const STRAIN: f64 = 5.0;

/// How loops add up: the weight of all their echoes, as a share.
const WEIGHT: f64 = 0.2;

/// A loop that was found.
#[derive(Clone, Debug)]
struct Claim {
    edge: Edge,
    /// The doubt with which it was looked for, metres.
    doubt: f64,
}

/// Adds the loops that are found to the graph and optimises it. The number of loops that it keeps is returned.
pub fn close(
    keys: &[Key],
    graph: &mut Graph,
    params: &MatchingParams,
    threads: usize,
    progress: &mut dyn FnMut(f64),
) -> usize {
    let way = way(graph);
    let tries = tries(&way);
    let mut pending: Vec<Claim> = vec![];
    for (done, batch) in tries.chunks(BATCH).enumerate() {
        let claims = in_parallel(threads, batch, |key| claims(*key, keys, graph, &way, params));
        let (sure, doubted): (Vec<_>, Vec<_>) =
            claims.into_iter().flatten().partition(|claim| claim.doubt <= SURE);
        let supported: Vec<_> =
            doubted.into_iter().flat_map(|claim| support(claim, &mut pending, graph, &way)).collect();
        add(graph, sure, supported);
        progress(((done + 1) * BATCH).min(tries.len()) as f64 / tries.len() as f64);
    }
    graph.optimise(true);
    graph.drop_wrong_loops();
    graph.edges.iter().filter(|edge| edge.closes).count()
}

/// Adds loops. Those that nobody doubted hardly change the graph and can wait for others, unless they do change it.
fn add(graph: &mut Graph, sure: Vec<Claim>, supported: Vec<Claim>) {
    let news = !supported.is_empty();
    let strained = sure.iter().any(|claim| claim.edge.chi2(&graph.poses) > STRAIN);
    graph.edges.extend(sure.into_iter().chain(supported).map(|claim| claim.edge));
    if news || strained {
        graph.optimise(news);
        graph.drop_wrong_loops();
    }
}

/// The way from the first key to each, metres.
fn way(graph: &Graph) -> Vec<f64> {
    let mut way = vec![0.0];
    for pair in graph.poses.windows(2) {
        way.push(way.last().copied().unwrap_or(0.0) + pair[0].distance(pair[1]));
    }
    way
}

/// The last keys of the stretches to try.
fn tries(way: &[f64]) -> Vec<usize> {
    let mut next = LOCAL;
    let mut tries = vec![];
    for (key, way) in way.iter().enumerate() {
        if *way >= next {
            tries.push(key);
            next = way + STRIDE;
        }
    }
    tries
}

/// What `work` makes of each item, on this many threads, in the items' order.
fn in_parallel<T: Sync, R: Send>(threads: usize, items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let share = items.len().div_ceil(threads.max(1)).max(1);
    std::thread::scope(|scope| {
        let work = &work;
        let parts: Vec<_> = items
            .chunks(share)
            .map(|part| scope.spawn(move || part.iter().map(work).collect::<Vec<_>>()))
            .collect();
        parts.into_iter().flat_map(|part| part.join().unwrap_or_default()).collect()
    })
}

/// The best claim for a stretch.
fn claims(key: usize, keys: &[Key], graph: &Graph, way: &[f64], params: &MatchingParams) -> Vec<Claim> {
    let since = since(key, graph);
    let stretch = stretch(key, keys, graph);
    places(key, &since, graph, way)
        .into_iter()
        .filter_map(|place| claim(key, place, since[place], &stretch, keys, graph, params))
        .collect()
}

/// The shortest way in the graph to each key up to this one, metres: by it doubt grows.
fn since(key: usize, graph: &Graph) -> Vec<f64> {
    let mut beside = vec![vec![]; key + 1];
    for edge in graph.edges.iter().filter(|e| e.from.max(e.to) <= key) {
        let length =
            if edge.closes { 0.2 } else { edge.step.x.hypot(edge.step.y) + 0.2 * edge.step.theta.abs() };
        beside[edge.from].push((edge.to, length));
        beside[edge.to].push((edge.from, length));
    }
    let mut since = vec![f64::INFINITY; key + 1];
    let mut open = BinaryHeap::from([Reached { way: 0.0, key }]);
    while let Some(Reached { way, key }) = open.pop() {
        if way < since[key] {
            since[key] = way;
            open.extend(beside[key].iter().map(|(next, length)| Reached { way: way + length, key: *next }));
        }
    }
    since
}

/// A key reached by a way; the shortest is the greatest.
struct Reached {
    way: f64,
    key: usize,
}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.way.total_cmp(&self.way).then(other.key.cmp(&self.key))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Reached {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Reached {}

fn doubt(since: f64, (least, growth, most): (f64, f64, f64)) -> f64 {
    (least + growth * since).min(most)
}

/// The older keys that may see what this one sees, the nearest first, and no two from one stretch.
fn places(key: usize, since: &[f64], graph: &Graph, way: &[f64]) -> Vec<usize> {
    let here = graph.poses[key];
    let off = |place: usize| {
        (graph.poses[place].distance(here) - doubt(since[place], DOUBT)).max(0.0)
            + 0.1 * graph.poses[place].distance(here)
    };
    let may = |place: &usize| {
        way[key] - way[*place] > LOCAL
            && graph.poses[*place].distance(here) < doubt(since[*place], DOUBT) + SIGHT
    };
    let mut candidates: Vec<usize> = (0..key).filter(may).collect();
    candidates.sort_by(|a, b| off(*a).total_cmp(&off(*b)).then(a.cmp(b)));
    let mut places: Vec<usize> = vec![];
    for candidate in candidates {
        if places.len() < PLACES && places.iter().all(|p| (way[*p] - way[candidate]).abs() > APART) {
            places.push(candidate);
        }
    }
    places
}

/// The echoes of a key and those before it, as seen from it.
fn stretch(key: usize, keys: &[Key], graph: &Graph) -> Sweep {
    let mut stretch = Sweep::default();
    let first = key.saturating_sub(STRETCH - 1);
    for (Key { sweep, .. }, pose) in keys[first..=key].iter().zip(&graph.poses[first..]) {
        let turn = Turn::of(graph.poses[key].to(*pose));
        stretch.points.extend(sweep.points.iter().map(|p| turn.place(*p)));
        stretch.normals.extend(sweep.normals.iter().map(|n| n.map(|n| turn.direct(n))));
    }
    stretch
}

/// Lays a stretch over an older place.
fn claim(
    key: usize,
    place: usize,
    since: f64,
    stretch: &Sweep,
    keys: &[Key],
    graph: &Graph,
    params: &MatchingParams,
) -> Option<Claim> {
    let (shift, turn) = (doubt(since, DOUBT), doubt(since, TURN_DOUBT));
    let coarse = if shift > SURE { 2.0 } else { 1.0 };
    let last = (place + AROUND).min(key - STRETCH.min(key));
    let around = place.saturating_sub(AROUND)..=last;
    let scans = around.map(|i| (&keys[i].sweep, graph.poses[i]));
    let submap = Submap::of(scans, graph.poses[place], coarse * params.resolution, coarse * params.spread);
    let expected = graph.poses[key];
    let window = Window {
        shift,
        turn,
        turn_step: 0.01 * coarse,
        deviation: (shift, turn),
        penalty: 0.05,
        least: LEAST.0,
    };
    let (start, _) = correlate(&submap, &stretch.points, expected, window)?;
    let prior = Matrix3::from_diagonal(&Vector3::new(shift.powi(-2), shift.powi(-2), turn.powi(-2)));
    let fit = align(&submap, stretch, start, start, &prior);
    let information = fit.information * WEIGHT;
    let edge =
        Edge { from: place, to: key, step: graph.poses[place].to(fit.pose), information, closes: true };
    (fit.inliers >= LEAST.1).then_some(Claim { edge, doubt: shift })
}

/// Notes a claim. If enough stretches claim the same, those claims are returned and no longer pending.
fn support(claim: Claim, pending: &mut Vec<Claim>, graph: &Graph, way: &[f64]) -> Vec<Claim> {
    pending.retain(|p| way[claim.edge.to] - way[p.edge.to] < SUPPORT);
    let (mut alike, others): (Vec<_>, Vec<_>) =
        std::mem::take(pending).into_iter().partition(|p| agree(p, &claim, graph, way));
    alike.push(claim);
    *pending = others;
    if stretches(&alike) >= SUPPORTERS {
        return alike;
    }
    pending.append(&mut alike);
    vec![]
}

/// How many stretches these claims are of.
fn stretches(claims: &[Claim]) -> usize {
    claims.iter().map(|c| c.edge.to).collect::<BTreeSet<_>>().len()
}

/// Whether two claims of different stretches would move the path alike.
fn agree(a: &Claim, b: &Claim, graph: &Graph, way: &[f64]) -> bool {
    let between = (way[a.edge.to] - way[b.edge.to]).abs();
    let moved = |claim: &Claim, pose: Pose| {
        let (from, to) = (graph.poses[claim.edge.from], graph.poses[claim.edge.to]);
        from.then(claim.edge.step).then(to.to(pose))
    };
    let here = graph.poses[b.edge.to];
    let (by_a, by_b) = (moved(a, here), moved(b, here));
    a.edge.to != b.edge.to
        && by_a.distance(by_b) < AGREE.0 + AGREE.1 * between
        && by_a.turn(by_b).abs() < AGREE.2
}
