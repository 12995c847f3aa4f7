//! Whether the symbols were found.

use super::{Count, scaled};
use planform_sdk::{Point, Symbol};
use planform_synth::{PlanLeaf, PlanSymbol, PlanTruth};
use std::collections::BTreeMap;

/// A symbol is found within this share of its larger side, or within the least distance, metres.
const WITHIN: f64 = 0.4;
const LEAST: f64 = 0.25;

/// Symbols of one kind, or of all.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Of the found ones, those that are where such a symbol is.
    pub right: usize,
    pub found: usize,
    pub all: usize,
}

impl Tally {
    /// Of the found symbols the share that is right; 1 of nothing.
    pub fn precision(self) -> f64 {
        Count { right: self.right, all: self.found }.share()
    }

    /// Of the true symbols the share that was found; 1 of nothing.
    pub fn recall(self) -> f64 {
        Count { right: self.right, all: self.all }.share()
    }

    fn add(&mut self, other: Self) {
        self.right += other.right;
        self.found += other.found;
        self.all += other.all;
    }
}

/// The symbols of a plan, by kind.
#[derive(Debug, Clone, Default)]
pub struct Kinds {
    kinds: BTreeMap<String, Tally>,
    /// Of the doors with one leaf that were found, those with their hinge and their swing.
    pub swings: Count,
}

impl Kinds {
    /// Compares what was found, its coordinates times the factor, with the truth.
    pub fn compare(found: &[Symbol], truth: &PlanTruth, factor: f64) -> Self {
        let mut kinds = Self::default();
        for symbol in &truth.symbols {
            kinds.kinds.entry(symbol.kind.clone()).or_default().all += 1;
        }
        let mut pairs = Vec::new();
        for (i, symbol) in found.iter().enumerate() {
            kinds.kinds.entry(symbol.kind.clone()).or_default().found += 1;
            pairs.extend(candidates(symbol, truth, factor).map(|(j, distance)| (distance, i, j)));
        }
        // The nearest pairs first.
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let (mut used, mut met) = (vec![false; found.len()], vec![false; truth.symbols.len()]);
        for (_, i, j) in pairs {
            if !used[i] && !met[j] {
                (used[i], met[j]) = (true, true);
                kinds.count(&found[i], &truth.symbols[j], factor);
            }
        }
        kinds
    }

    fn count(&mut self, found: &Symbol, truth: &PlanSymbol, factor: f64) {
        self.kinds.entry(truth.kind.clone()).or_default().right += 1;
        if let [leaf] = truth.leaves[..] {
            self.swings.all += 1;
            let right = |f: &planform_sdk::DoorLeaf| swings_alike(f, &leaf, factor);
            self.swings.right += usize::from(found.leaves.len() == 1 && found.leaves.iter().all(right));
        }
    }

    /// All kinds together.
    pub fn total(&self) -> Tally {
        let mut total = Tally::default();
        self.kinds.values().for_each(|&t| total.add(t));
        total
    }

    /// The kinds of several plans together.
    pub fn sum<'a>(all: impl Iterator<Item = &'a Self>) -> BTreeMap<String, Tally> {
        let mut sum: BTreeMap<String, Tally> = BTreeMap::new();
        for (kind, &tally) in all.flat_map(|k| &k.kinds) {
            sum.entry(kind.clone()).or_default().add(tally);
        }
        sum
    }
}

/// The true symbols that the found one may be, with their distance.
fn candidates<'a>(
    found: &'a Symbol,
    truth: &'a PlanTruth,
    factor: f64,
) -> impl Iterator<Item = (usize, f64)> + 'a {
    let at = scaled(found.pose.x, found.pose.y, factor);
    let near = truth.symbols.iter().enumerate().filter(|(_, t)| t.kind == found.kind);
    near.filter_map(move |(j, t)| {
        let distance = at.distance(Point::new(t.pose.x, t.pose.y));
        (distance <= (WITHIN * t.width.max(t.height)).max(LEAST)).then_some((j, distance))
    })
}

/// Whether hinge and open end are within half a leaf of where they should be.
fn swings_alike(found: &planform_sdk::DoorLeaf, truth: &PlanLeaf, factor: f64) -> bool {
    let reach = truth.hinge.distance(truth.closed) / 2.0;
    let near = |f: Point, t: Point| scaled(f.x, f.y, factor).distance(t) < reach;
    near(found.hinge, truth.hinge) && near(found.open, truth.open)
}
