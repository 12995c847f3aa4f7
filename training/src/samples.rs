//! What the model learns from: pairs of regions as the merging meets them, with the truth on whether they are one
//! room.

use crate::maps::Map;
use planform::reconstruct::Params;
use planform::reconstruct::basins::Cut;
use planform::reconstruct::basins::evidence::Evidence;
use planform::reconstruct::basins::merge;
use planform::reconstruct::basins::model::Model;
use planform::reconstruct::basins::regions::Regions;
use std::collections::BTreeMap;

/// One decision.
#[derive(Clone)]
pub struct Sample {
    /// What was known.
    pub evidence: Evidence,
    /// Whether the two are one room.
    pub same: bool,
    /// How much it counts.
    pub weight: f64,
}

/// A map cut into basins, with the true rooms of each.
pub struct Lesson<'a> {
    /// The map.
    pub map: &'a Map,
    /// Its basins.
    pub cut: Cut,
    /// For each basin its cells in each true room; 0 is none.
    truth: Vec<BTreeMap<u32, usize>>,
}

/// A region belongs to a true room that covers at least this share of it.
const BELONGS: f64 = 0.3;

/// What lies outside of all rooms counts as a room of its own from this size on, square metres.
const OUTSIDE: f64 = 2.0;

/// How much more a pair of two rooms counts than a pair of one.
const CUT: f64 = 3.0;

impl<'a> Lesson<'a> {
    /// Cuts a map.
    pub fn of(map: &'a Map) -> Option<Self> {
        let cut = Cut::of_grid(&map.grid, &Params::default())?;
        let on_space = cut.on_space(&map.grid, &map.truth_on_grid());
        let mut truth = vec![BTreeMap::new(); cut.basins.count as usize + 1];
        for (&basin, room) in cut.basins.label.iter().zip(on_space).filter(|(b, _)| **b != 0) {
            *truth[basin as usize].entry(room).or_insert(0) += 1;
        }
        Some(Self { map, cut, truth })
    }

    /// The true room of a region; 0 is none.
    fn room(&self, regions: &Regions<'_>, name: u32) -> u32 {
        let mut cells: BTreeMap<u32, usize> = BTreeMap::new();
        for &basin in regions.get(name).map_or(&[][..], |r| &r.basins) {
            for (room, n) in &self.truth[basin as usize] {
                *cells.entry(*room).or_default() += n;
            }
        }
        let total: usize = cells.values().sum();
        let best = cells.iter().filter(|c| *c.0 != 0).max_by_key(|c| (*c.1, std::cmp::Reverse(*c.0)));
        best.filter(|(_, n)| **n as f64 > BELONGS * total as f64).map_or(0, |b| *b.0)
    }

    /// The decisions on the way to the true rooms, in the order in which the model takes them.
    pub fn samples(&self, model: &Model) -> Vec<Sample> {
        let view = self.cut.view();
        let mut regions = Regions::of_basins(&view, &self.cut.basins);
        let mut samples = Vec::new();
        merge::agglomerate(&mut regions, model, |regions, (a, b), evidence, odds| {
            let area = |r| regions.get(r).map_or(0.0, |r| r.area);
            let (small, rooms) = (area(a).min(area(b)), [self.room(regions, a), self.room(regions, b)]);
            let mut sample = |same, weight: f64| {
                let weight = weight * (1.0 + small / 10.0).sqrt();
                samples.push(Sample { evidence: *evidence, same, weight });
                same
            };
            if rooms.contains(&0) {
                if rooms[0] == rooms[1] || small < OUTSIDE {
                    return odds >= 0.0 && small < 1.0;
                }
                return sample(false, 0.3 * CUT);
            }
            let same = rooms[0] == rooms[1];
            // Easy merges are many, and the hard cuts are what counts.
            sample(same, (small / 3.0).clamp(0.05, 1.0) * if same { 1.0 } else { CUT })
        });
        let all = 1.0 / (1.0 + samples.len() as f64).sqrt();
        samples.iter_mut().for_each(|s| s.weight *= all);
        samples
    }
}
