//! Leaves that close a doorway together.

use super::swing::Swing;
use crate::symbols::plane::{Vec2, direction, distance, dot, moved};

/// A leaf without a jamb at its closed end is one of two, or none.
const LEAST_JAMB: f64 = 0.4;

/// An opening with the one or two leaves that close it.
#[derive(Debug, Clone, PartialEq)]
pub struct Doorway {
    /// The leaves.
    pub leaves: Vec<Swing>,
    /// The jamb from which it is measured.
    pub from: Vec2,
    /// The unit vector along the wall.
    pub along: Vec2,
    /// The unit vector across the wall, to the side that leaves open to.
    pub across: Vec2,
    /// From jamb to jamb.
    pub width: f64,
}

impl Doorway {
    /// The point so far along and across the wall.
    pub fn at(&self, along: f64, across: f64) -> Vec2 {
        moved(moved(self.from, self.along, along), self.across, across)
    }

    fn single(leaf: &Swing) -> Self {
        let Swing { hinge, radius, along, .. } = *leaf;
        Self { leaves: vec![*leaf], from: hinge, along, across: leaf.across(), width: radius }
    }

    fn double(a: &Swing, b: &Swing) -> Self {
        let (along, width) = direction(a.hinge, b.hinge);
        Self { leaves: vec![*a, *b], from: a.hinge, along, across: a.across(), width }
    }
}

/// All leaves as doorways, in the order of their first leaf.
pub fn doorways(leaves: &[Swing]) -> Vec<Doorway> {
    let mut taken = vec![false; leaves.len()];
    let mut found = Vec::new();
    for (i, leaf) in leaves.iter().enumerate() {
        if taken[i] {
            continue;
        }
        let partner = (i + 1..leaves.len()).filter(|&j| !taken[j] && meet(leaf, &leaves[j]));
        let gap = |j: &usize| distance(leaf.closed(), leaves[*j].closed());
        match partner.min_by(|a, b| gap(a).total_cmp(&gap(b))) {
            Some(j) => {
                taken[j] = true;
                found.push(Doorway::double(leaf, &leaves[j]));
            }
            None if leaf.jamb >= LEAST_JAMB => found.push(Doorway::single(leaf)),
            None => {}
        }
    }
    found
}

/// Whether two leaves close towards each other.
fn meet(a: &Swing, b: &Swing) -> bool {
    let r = a.radius.min(b.radius);
    let opposite = dot(a.along, b.along) < -0.9;
    opposite && distance(a.closed(), b.closed()) < 0.45 * r && a.radius.max(b.radius) < 2.5 * r
}
