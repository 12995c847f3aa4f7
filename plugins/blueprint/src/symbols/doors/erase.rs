//! The pixels that draw a doorway: arcs, leaves, and lines through the opening; never the wall beside it.

use super::pairs::Doorway;
use super::swing::Swing;
use super::wall::Faces;
use crate::mask::Mask;
use crate::symbols::plane::{Plane, distance, dot};

/// A leaf drawn as a box is no thicker than this share of its length.
const PANEL: f64 = 0.1;

/// Adds what draws the doorway.
pub fn doorway(plane: &Plane, ink: &Mask, doorway: &Doorway, wall: &Faces, erase: &mut Mask) {
    let drawn = Drawn { doorway, wall, slack: 1.0 };
    let scale = f64::from(plane.factor);
    let reach = 2.0 * doorway.leaves.iter().map(|l| l.radius).fold(doorway.width, f64::max);
    let middle = doorway.at(doorway.width / 2.0, 0.0);
    let range = |at: f64, end: u32| {
        let clamp = |v: f64| (v * scale).clamp(0.0, f64::from(end)) as u32;
        clamp(at - reach)..clamp(at + reach)
    };
    for y in range(middle[1], ink.height) {
        for x in range(middle[0], ink.width) {
            let i = y as usize * ink.width as usize + x as usize;
            let place = [f64::from(x) + 0.5, f64::from(y) + 0.5].map(|v| v / scale);
            if ink.set[i] && drawn.is_at(place) {
                erase.set[i] = true;
            }
        }
    }
}

struct Drawn<'a> {
    doorway: &'a Doorway,
    wall: &'a Faces,
    slack: f64,
}

impl Drawn<'_> {
    fn is_at(&self, p: [f64; 2]) -> bool {
        let from = [p[0] - self.doorway.from[0], p[1] - self.doorway.from[1]];
        let (along, across) = (dot(from, self.doorway.along), dot(from, self.doorway.across));
        if across <= self.wall.high + self.slack {
            return self.is_in_opening(along, across);
        }
        self.doorway.leaves.iter().any(|leaf| self.is_on(leaf, p))
    }

    fn is_in_opening(&self, along: f64, across: f64) -> bool {
        let within = along > self.slack && along < self.doorway.width - self.slack;
        within && across >= self.wall.low - self.slack
    }

    fn is_on(&self, leaf: &Swing, p: [f64; 2]) -> bool {
        let from = [p[0] - leaf.hinge[0], p[1] - leaf.hinge[1]];
        let r = leaf.radius;
        let width = 2.0 + 0.03 * r;
        let between = dot(from, leaf.along) > -width && dot(from, leaf.across()) > 0.0;
        let arc = (distance(p, leaf.hinge) - r).abs() <= width && between && self.is_within(leaf, from);
        let (out, side) = (dot(from, leaf.into), [leaf.into[1], -leaf.into[0]]);
        // The box of a leaf lies towards the opening.
        let side = if dot(side, leaf.along) >= 0.0 { side } else { [-side[0], -side[1]] };
        let beside = dot(from, side);
        arc || (out > 0.0 && out < r + width && beside > -2.0 && beside < (PANEL * r).max(2.0))
    }

    /// Whether a direction lies between the closed and the open leaf, or hardly beyond.
    fn is_within(&self, leaf: &Swing, from: [f64; 2]) -> bool {
        let angle = |v: [f64; 2]| dot(v, leaf.across()).atan2(dot(v, leaf.along));
        angle(from) <= angle(leaf.into) + 0.1
    }
}
