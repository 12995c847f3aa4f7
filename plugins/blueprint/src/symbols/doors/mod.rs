//! Doors that swing: quarter circles that a leaf draws from one jamb to the other. Arcs are found as curved strokes, and
//! where they are dashed or broken by the leaf's line; each is then held against what a door must have: a leaf or a
//! wall at either end, and an opening between.

mod erase;
mod pairs;
mod swing;
mod wall;

use super::plane::{Plane, Vec2};
use super::strokes::{self, Segment};
use super::thin::Chain;
use crate::found::{SheetLeaf, SheetSymbol};
use crate::mask::Mask;
use pairs::Doorway;
pub use swing::Swing;

/// The doors of a plane whose arcs' radius lies within the range, pixels of the plane.
pub fn find(plane: &Plane, chains: &[Chain], segments: &[Segment], radii: [f64; 2]) -> Vec<Swing> {
    let mut found: Vec<Swing> = strokes::curves(chains, radii)
        .iter()
        .filter_map(|c| swing::of_arc(plane, c.centre, c.radius, Some(c.through), radii))
        .collect();
    for leaf in segments.iter().filter(|s| (radii[0] * 0.8..=radii[1]).contains(&s.length())) {
        for (hinge, open) in [(leaf.a, leaf.b), (leaf.b, leaf.a)] {
            found.extend(swing::of_leaf(plane, hinge, open, radii));
        }
    }
    best(found)
}

/// Doors of one building are alike: those whose leaf is much shorter or longer than what most speaks for are something
/// else.
pub fn alike(mut swings: Vec<Swing>) -> Vec<Swing> {
    let Some(usual) = usual_radius(&swings) else { return swings };
    swings.retain(|s| (ALIKE[0]..=ALIKE[1]).contains(&(s.radius / usual)));
    swings
}

/// Leaves within this range of the usual radius are of doors of the same building.
const ALIKE: [f64; 2] = [0.6, 1.6];

/// The radius that has the most doors near it; sure ones and large ones count for more, as little arcs are many.
fn usual_radius(swings: &[Swing]) -> Option<f64> {
    let weight = |s: &Swing| (s.score - 0.5).max(0.0) * s.radius;
    let near = |a: &Swing| {
        swings.iter().filter(|b| (b.radius / a.radius).ln().abs() < 0.18).map(weight).sum::<f64>()
    };
    swings.iter().max_by(|a, b| near(a).total_cmp(&near(b))).map(|s| s.radius)
}

/// The best of those that lie over each other, or take a better one's arc for a leaf.
fn best(mut found: Vec<Swing>) -> Vec<Swing> {
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<Swing> = Vec::new();
    for swing in found {
        if kept.iter().all(|k| !k.is_over(&swing) && !swing.leaf_is_on_arc(k)) {
            kept.push(swing);
        }
    }
    kept
}

/// The doors that leaves make, alone or two by two, in pixels of the sheet, and what draws them.
pub fn doors(plane: &Plane, ink: &Mask, swings: &[Swing], erase: &mut Mask) -> Vec<SheetSymbol> {
    let doorways = pairs::doorways(swings);
    doorways.iter().filter_map(|doorway| door(plane, ink, doorway, erase)).collect()
}

fn door(plane: &Plane, ink: &Mask, doorway: &Doorway, erase: &mut Mask) -> Option<SheetSymbol> {
    let wall = wall::of(plane, doorway);
    if !erase::doorway(plane, ink, doorway, &wall, erase) {
        return None;
    }
    let scale = f64::from(plane.factor);
    let on_sheet = |p: Vec2| p.map(|v| v * scale);
    let leaf = |s: &Swing| SheetLeaf {
        hinge: on_sheet(s.hinge),
        closed: on_sheet(s.closed()),
        open: on_sheet(s.open()),
    };
    Some(SheetSymbol {
        kind: if doorway.leaves.len() == 2 { "double-door" } else { "door" }.into(),
        centre: on_sheet(doorway.at(doorway.width / 2.0, wall.middle())),
        angle: doorway.along[1].atan2(doorway.along[0]),
        width: doorway.width * scale,
        height: wall.thickness() * scale,
        score: doorway.leaves.iter().map(|l| l.score).sum::<f64>() / doorway.leaves.len() as f64,
        leaves: doorway.leaves.iter().map(leaf).collect(),
    })
}
