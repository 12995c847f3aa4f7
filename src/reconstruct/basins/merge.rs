//! Regions merged to rooms, the surest pair first. Every merge changes the evidence on all boundaries of the region
//! that it makes, so the decisions depend on each other: a piece of a room that looked like a room of its own joins
//! once its other piece has, and two rooms that would make an odd shape stay apart.

use super::evidence::{self, Evidence};
use super::model::Model;
use super::regions::{Regions, pair};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::cmp::{Ordering, Reverse};
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

/// When two regions are one room.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Merge {
    /// They are if the model gives at least this probability, 0 to 1. Less gives fewer and larger rooms.
    pub probability: f64,
    /// Regions this many times as long as wide are corridors; two corridors that meet without a narrowing are one.
    pub corridor: f64,
    /// There is no narrowing where the clearance is at least this share of what a corridor of that width has, 0 to 1.
    pub unnarrowed: f64,
    /// Corridors go on through a passage that is wider than this: wider than a door. Metres.
    pub door: f64,
    /// They go on through a widening or a junction where the clearance is at least this share, as above, 0 to 1.
    pub through: f64,
    /// A region smaller than this is a nook: part of the likeliest neighbour. Square metres.
    pub nook: f64,
}

impl Default for Merge {
    fn default() -> Self {
        Self { probability: 0.5, corridor: 6.0, unnarrowed: 0.65, door: 1.3, through: 0.55, nook: 1.5 }
    }
}

/// A nook with less than this probability stays alone: it lies behind a wall.
const ALONE: f64 = 0.05;

/// What a known door adds to the log odds that the regions on its sides are one room: it outweighs all else.
const DOOR: f64 = -12.0;

/// What it adds that one of them is likely a piece of the other's room, as the free floor between furniture is.
const PIECE: f64 = 3.0;

/// What it adds that the document states all openings, and none between the two.
const OPEN: f64 = 12.0;

/// Merges regions until none is left to merge. `seen` is told of every pair in the order in which they are looked
/// at, with its evidence, and decides whether the two are one room.
pub fn agglomerate(
    regions: &mut Regions<'_>,
    model: &Model,
    mut one_room: impl FnMut(&Regions<'_>, (u32, u32), &Evidence, f64) -> bool,
) {
    let mut queue = Queue::default();
    for pair in regions.pairs() {
        queue.push(regions, model, pair);
    }
    while let Some(next) = queue.pop(regions) {
        if !one_room(regions, next.pair, &next.evidence, next.odds) {
            continue;
        }
        let Some(kept) = regions.merge(next.pair.0, next.pair.1) else { continue };
        for other in regions.beside(kept) {
            queue.push(regions, model, pair(kept, other));
        }
    }
}

/// The rooms that the parameters and the model make of the regions.
pub fn rooms(regions: &mut Regions<'_>, model: &Model, params: &Merge) {
    let p = params.probability.clamp(1e-6, 1.0 - 1e-6);
    let least = (p / (1.0 - p)).ln();
    agglomerate(regions, model, |_, _, _, odds| odds >= least);
    join_corridors(regions, params);
    join_through(regions, params);
    absorb_nooks(regions, model, params.nook);
}

/// A pair of regions that waits to be looked at.
struct Waiting {
    odds: f64,
    pair: (u32, u32),
    version: u32,
    evidence: Evidence,
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        self.odds.total_cmp(&other.odds).then_with(|| other.pair.cmp(&self.pair))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Waiting {}

/// The pairs by falling probability. What was pushed again counts as it was pushed last.
#[derive(Default)]
struct Queue {
    heap: BinaryHeap<Waiting>,
    versions: BTreeMap<(u32, u32), u32>,
}

impl Queue {
    fn push(&mut self, regions: &mut Regions<'_>, model: &Model, pair: (u32, u32)) {
        let stated = regions.stated_one(pair.0, pair.1);
        if stated == Some(false) {
            return;
        }
        let Some(evidence) = evidence::weigh(regions, pair.0, pair.1) else { return };
        let door = if regions.door(pair.0, pair.1) { DOOR } else { 0.0 };
        let piece = if regions.likely_one(pair.0, pair.1) { PIECE } else { 0.0 };
        let open = if stated.is_some() { OPEN } else { 0.0 };
        let odds = model.log_odds(&evidence) + door + piece + open;
        let version = self.versions.entry(pair).and_modify(|v| *v += 1).or_default();
        self.heap.push(Waiting { odds, pair, version: *version, evidence });
    }

    fn pop(&mut self, regions: &Regions<'_>) -> Option<Waiting> {
        while let Some(next) = self.heap.pop() {
            let alive = [next.pair.0, next.pair.1].iter().all(|&r| regions.get(r).is_some());
            if alive && self.versions.get(&next.pair) == Some(&next.version) {
                return Some(next);
            }
        }
        None
    }
}

/// Joins corridors that meet without a narrowing, the widest passage first: walls that face each other, crossings and
/// bends cut a corridor by the evidence, but not in the eyes of people.
fn join_corridors(regions: &mut Regions<'_>, params: &Merge) {
    // By the bits of the widths, which rise with positive numbers; of equal ones the first pair comes first.
    let mut waiting: BinaryHeap<(u64, Reverse<(u32, u32)>)> = BinaryHeap::new();
    let wait = |regions: &mut Regions<'_>, waiting: &mut BinaryHeap<_>, pair| {
        let width = relative_width(regions, pair, params.corridor).filter(|&w| w >= params.unnarrowed);
        waiting.extend(width.map(|w| (w.to_bits(), Reverse(pair))));
    };
    for pair in regions.pairs() {
        wait(regions, &mut waiting, pair);
    }
    while let Some((width, Reverse((a, b)))) = waiting.pop() {
        // Every merge changes the widths around: what was found before may be out of date.
        if relative_width(regions, (a, b), params.corridor).map(f64::to_bits) != Some(width) {
            continue;
        }
        let Some(kept) = regions.merge(a, b) else { continue };
        for other in regions.beside(kept) {
            wait(regions, &mut waiting, pair(kept, other));
        }
    }
}

/// The clearance of the widest passage between two regions over half the mean width of the wider one; none if one of
/// them is less elongated than asked for, or if a known door is between them.
fn relative_width(regions: &mut Regions<'_>, (a, b): (u32, u32), elongation: f64) -> Option<f64> {
    if regions.door(a, b) || regions.stated_one(a, b) == Some(false) {
        return None;
    }
    let [wide, width] = [a, b].map(|r| {
        let region = regions.get(r)?;
        // A strip has a mean clearance of a quarter of its width.
        (region.elongation() >= elongation).then_some(2.0 * region.mean_clearance() + 0.02)
    });
    let half = wide?.max(width?);
    Some(evidence::widest(regions.passages(a, b))?.saddle / half)
}

/// A widening or a junction of corridors is at least this elongated.
const STUB: f64 = 1.5;

/// The most regions between two corridors.
const BETWEEN: usize = 3;

/// Joins what corridors run through: junctions and widenings that a corridor enters on one side and leaves on
/// another, each time through more than a door and without much of a narrowing. So a corridor that goes around a
/// courtyard is closed.
fn join_through(regions: &mut Regions<'_>, params: &Merge) {
    let mut links = Links::new();
    for pair in regions.pairs() {
        link(&mut links, regions, pair, params);
    }
    loop {
        let is_corridor = |r: u32| regions.get(r).is_some_and(|r| r.elongation() >= params.corridor);
        let mut from = links.keys().copied().filter(|r| is_corridor(*r));
        let Some(way) = from.find_map(|r| way_through(&links, &is_corridor, r)) else { return };
        let mut kept = way[0];
        for &next in way[1..].iter().filter(|n| **n != way[0]) {
            kept = regions.merge(kept, next).unwrap_or(kept);
        }
        way.iter().for_each(|&region| unlink(&mut links, region));
        for other in regions.beside(kept) {
            link(&mut links, regions, pair(kept, other), params);
        }
    }
}

/// For each region those that corridors may go on to.
type Links = BTreeMap<u32, BTreeSet<u32>>;

/// Links two regions if corridors may go on from one to the other.
fn link(links: &mut Links, regions: &mut Regions<'_>, (a, b): (u32, u32), params: &Merge) {
    let gap = evidence::widest(regions.passages(a, b)).map_or(0.0, |p| p.gap);
    let open = relative_width(regions, (a, b), STUB).is_some_and(|w| w >= params.through);
    if open && gap > params.door {
        links.entry(a).or_default().insert(b);
        links.entry(b).or_default().insert(a);
    }
}

fn unlink(links: &mut Links, region: u32) {
    for other in links.remove(&region).into_iter().flatten() {
        if let Some(others) = links.get_mut(&other) {
            others.remove(&region);
        }
    }
}

/// A shortest way over links from a corridor through other regions to another corridor, or around to the same one.
fn way_through(links: &Links, is_corridor: &dyn Fn(u32) -> bool, from: u32) -> Option<Vec<u32>> {
    let mut ways = vec![vec![from]];
    for between in 0..=BETWEEN {
        let mut longer = Vec::new();
        for way in &ways {
            for &next in links.get(way.last()?).into_iter().flatten() {
                // There and back through one region is no way through.
                let arrived = is_corridor(next) && between >= if next == from { 2 } else { 1 };
                if arrived || (!is_corridor(next) && !way.contains(&next)) {
                    let way = [&way[..], &[next]].concat();
                    if arrived {
                        return Some(way);
                    }
                    longer.push(way);
                }
            }
        }
        ways = longer;
    }
    None
}

/// Gives every nook to its likeliest neighbour, the surest first.
fn absorb_nooks(regions: &mut Regions<'_>, model: &Model, size: f64) {
    let has_nook = |regions: &Regions<'_>, (a, b): (u32, u32)| {
        [a, b].iter().any(|&r| regions.get(r).is_some_and(|r| r.area < size))
    };
    let mut queue = Queue::default();
    for pair in regions.pairs() {
        if has_nook(regions, pair) {
            queue.push(regions, model, pair);
        }
    }
    let least = (ALONE / (1.0 - ALONE)).ln();
    while let Some(next) = queue.pop(regions).filter(|next| next.odds >= least) {
        if !has_nook(regions, next.pair) {
            continue;
        }
        let Some(kept) = regions.merge(next.pair.0, next.pair.1) else { continue };
        for other in regions.beside(kept) {
            if has_nook(regions, pair(kept, other)) {
                queue.push(regions, model, pair(kept, other));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Cut;
    use super::super::space::tests::space;
    use super::*;

    /// The rooms' areas of a map drawn with a cell of 0.1 m, by rising area.
    fn areas(cell: impl Fn(f64, f64) -> bool, width: f64, height: f64) -> Vec<f64> {
        let (columns, rows) = ((width * 10.0) as usize, (height * 10.0) as usize);
        let at = |c: usize, r: usize| cell((c as f64 + 0.5) / 10.0, (r as f64 + 0.5) / 10.0);
        let row = |r: usize| (0..columns).map(|c| if at(c, r) { '.' } else { '#' }).collect::<String>();
        let rows: Vec<String> = (0..rows).rev().map(row).collect();
        let cut = Cut::of_space(space(&rows.iter().map(String::as_str).collect::<Vec<_>>(), 0.1));
        let view = cut.view();
        let mut regions = Regions::of_basins(&view, &cut.basins);
        super::rooms(&mut regions, &Model::default(), &Merge::default());
        let mut areas: Vec<f64> = regions.all().map(|(_, r)| (r.area * 10.0).round() / 10.0).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    fn within(x: f64, y: f64, low: [f64; 2], high: [f64; 2]) -> bool {
        (low[0]..high[0]).contains(&x) && (low[1]..high[1]).contains(&y)
    }

    #[test]
    fn a_door_divides_two_rooms() {
        let found = areas(
            |x, y| {
                within(x, y, [0.0, 0.0], [4.0, 4.0])
                    || within(x, y, [4.2, 0.0], [8.0, 4.0])
                    || within(x, y, [3.9, 1.5], [4.3, 2.4])
            },
            8.0,
            4.0,
        );
        assert_eq!(found.len(), 2, "{found:?}");
    }

    #[test]
    fn pilasters_do_not_divide_a_hall() {
        let pilaster = |x: f64, y: f64| (x % 3.0 - 1.5).abs() < 0.2 && !(0.4..5.6).contains(&y);
        let found = areas(|x, y| !pilaster(x, y), 9.0, 6.0);
        assert_eq!(found.len(), 1, "{found:?}");
    }

    #[test]
    fn a_corridor_around_a_courtyard_is_one_room() {
        // Its corners are wider than its sides.
        let court = |x: f64, y: f64| within(x, y, [2.0, 2.0], [16.0, 12.0]);
        let pier =
            |x: f64, y: f64| within(x, y, [8.0, 0.0], [8.3, 0.4]) || within(x, y, [8.0, 13.6], [8.3, 14.0]);
        assert_eq!(areas(|x, y| !court(x, y) && !pier(x, y), 18.0, 14.0).len(), 1);
    }

    #[test]
    fn a_nook_joins_its_room() {
        // A cabinet stands before the corner.
        let found = areas(|x, y| !within(x, y, [3.8, 0.8], [5.0, 1.4]), 5.0, 4.0);
        assert_eq!(found.len(), 1, "{found:?}");
    }

    #[test]
    fn ways_lead_from_corridor_to_corridor() {
        let links = |pairs: &[(u32, u32)]| {
            let mut links = Links::new();
            for &(a, b) in pairs {
                links.entry(a).or_default().insert(b);
                links.entry(b).or_default().insert(a);
            }
            links
        };
        let corridor = |r: u32| r == 1 || r == 9;
        assert_eq!(way_through(&links(&[(1, 2), (2, 9)]), &corridor, 1), Some(vec![1, 2, 9]));
        assert_eq!(way_through(&links(&[(1, 2), (2, 3), (3, 1)]), &corridor, 1), Some(vec![1, 2, 3, 1]));
        assert_eq!(way_through(&links(&[(1, 2), (2, 3)]), &corridor, 1), None);
        let far = links(&[(1, 2), (2, 3), (3, 4), (4, 5), (5, 9)]);
        assert_eq!(way_through(&far, &corridor, 1), None);
    }
}
