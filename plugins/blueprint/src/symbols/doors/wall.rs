//! The wall that a doorway is in.

use super::pairs::Doorway;
use crate::symbols::plane::Plane;

/// Where a wall's two faces lie, measured across the wall from the line through the hinges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Faces {
    /// The lower one.
    pub low: f64,
    /// The upper one, on the side that leaves open to.
    pub high: f64,
}

impl Faces {
    /// The wall's middle line.
    pub fn middle(&self) -> f64 {
        (self.low + self.high) / 2.0
    }

    /// From face to face.
    pub fn thickness(&self) -> f64 {
        self.high - self.low
    }
}

/// If no wall can be measured: a twelfth of the width is what light walls have.
const USUAL: f64 = 0.12;

/// The faces as most places beside the doorway show them.
pub fn of(plane: &Plane, doorway: &Doorway) -> Faces {
    let leaf = doorway.leaves[0].radius;
    let beside = [0.1, 0.15, 0.2, 0.25, 0.3].map(|t| t * leaf);
    let places = beside.iter().flat_map(|&t| [-t, doorway.width + t]);
    let mut found: Vec<Faces> = places.filter_map(|along| profile(plane, doorway, along, leaf)).collect();
    found.sort_by(|a, b| a.thickness().total_cmp(&b.thickness()));
    found
        .get(found.len() / 2)
        .copied()
        .unwrap_or(Faces { low: -USUAL / 2.0 * leaf, high: USUAL / 2.0 * leaf })
}

/// What lies across the wall at one place: one run of ink, or two lines with paper or filling between.
fn profile(plane: &Plane, doorway: &Doorway, along: f64, leaf: f64) -> Option<Faces> {
    let step = 0.5;
    let (top, bottom) = (0.3 * leaf, -0.7 * leaf);
    let inked = |d: f64| plane.at(doorway.at(along, d));
    let offsets = (0..).map(|i| top - f64::from(i) * step).take_while(|&d| d >= bottom);
    let mut runs: Vec<Faces> = Vec::new();
    let mut before = false;
    for d in offsets {
        match (inked(d), before) {
            (true, false) => runs.push(Faces { low: d - step, high: d }),
            (true, true) => runs.last_mut()?.low = d - step,
            _ => {}
        }
        before = inked(d);
    }
    let reach = (0.12 * leaf).max(2.0);
    let first = runs.iter().position(|r| r.low <= reach && r.high >= -reach)?;
    let own = runs[first];
    let line = (0.1 * leaf).max(3.0);
    let partner =
        |r: &&Faces| r.thickness() <= line && own.high.max(r.high) - own.low.min(r.low) <= 0.5 * leaf;
    if own.thickness() > line {
        return Some(own);
    }
    let below = runs.get(first + 1).filter(partner);
    let above = first.checked_sub(1).and_then(|i| runs.get(i)).filter(partner);
    let other = below.or(above).unwrap_or(&own);
    Some(Faces { low: own.low.min(other.low), high: own.high.max(other.high) })
}
