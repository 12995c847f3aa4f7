//! Doors: leaves and their arcs, sliding leaves, thresholds.

use super::drawing::{Drawing, block};
use super::gaps::{Gap, Purpose};
use super::look::LeafStyle;
use super::surface::{Pen, WHITE, arc};
use super::truth::PlanLeaf;
use crate::params::RoomKind;
use planform_sdk::Point;
use std::f64::consts::FRAC_PI_2;

/// One leaf: from its hinge along the gap, and the way it opens.
#[derive(Debug, Clone, Copy)]
struct Leaf {
    hinge: Point,
    /// Unit vector from the hinge to the closed end.
    along: (f64, f64),
    /// Unit vector to the open end.
    into: (f64, f64),
    width: f64,
}

impl Leaf {
    fn at(&self, u: f64, v: f64) -> Point {
        let ((ax, ay), (nx, ny)) = (self.along, self.into);
        Point::new(self.hinge.x + ax * u + nx * v, self.hinge.y + ay * u + ny * v)
    }

    fn told(&self) -> PlanLeaf {
        PlanLeaf { hinge: self.hinge, closed: self.at(self.width, 0.0), open: self.at(0.0, self.width) }
    }
}

/// Draws all doors, and keeps the floor free that their leaves sweep, and the ways that people need.
pub(super) fn draw(drawing: &mut Drawing, gaps: &[Gap]) {
    for gap in gaps.iter().filter(|g| g.purpose != Purpose::Window) {
        keep_clear(drawing, gap);
        match gap.purpose {
            Purpose::Door => swinging(drawing, gap, 1),
            Purpose::DoubleDoor => swinging(drawing, gap, 2),
            Purpose::SlidingDoor => sliding(drawing, gap),
            Purpose::Passage | Purpose::Window => {}
        }
    }
}

fn keep_clear(drawing: &mut Drawing, gap: &Gap) {
    let width = gap.segment.length();
    let leaf = if gap.purpose == Purpose::DoubleDoor { width / 2.0 } else { width.min(1.2) };
    let deep = gap.depth + 2.0 * (leaf + 0.08);
    drawing.ways.push(block(gap.segment.midpoint(), gap.axes().0, width + 0.16, deep));
}

fn swinging(drawing: &mut Drawing, gap: &Gap, leaves: u32) {
    let left = opens_left(drawing, gap);
    let width = gap.segment.length();
    let sign = if left { 1.0 } else { -1.0 };
    let ((ax, ay), (nx, ny)) = gap.axes();
    let (v, into) = (sign * gap.depth / 2.0, (sign * nx, sign * ny));
    let from_first = Leaf { hinge: gap.at(0.0, v), along: (ax, ay), into, width };
    let from_second = Leaf { hinge: gap.at(width, v), along: (-ax, -ay), into, width };
    let both = if leaves == 2 {
        let half = width / 2.0;
        vec![Leaf { width: half, ..from_first }, Leaf { width: half, ..from_second }]
    } else {
        vec![if drawing.rng.chance(0.5) { from_first } else { from_second }]
    };
    both.iter().for_each(|leaf| swing(drawing, leaf));
    let swept =
        both.iter().map(|l| block(l.at(l.width / 2.0, l.width / 2.0), l.along, l.width + 0.1, l.width + 0.1));
    drawing.taken.extend(swept);
    if drawing.look.thresholds {
        let thin = drawing.thin();
        drawing.picture.line(&[gap.at(0.0, v), gap.at(width, v)], thin);
    }
    let kind = if leaves == 2 { "double-door" } else { "door" };
    let opening = block(gap.segment.midpoint(), gap.axes().0, width, gap.depth);
    drawing.tell(kind, &opening, both.iter().map(Leaf::told).collect());
}

/// Doors of rooms open into the room mostly, those to the outside outwards mostly.
fn opens_left(drawing: &mut Drawing, gap: &Gap) -> bool {
    let corridor = |id: Option<u32>| {
        id.and_then(|id| drawing.site.room(id)).is_none_or(|r| drawing.site.kind(r) == RoomKind::Corridor)
    };
    let chance = match gap.rooms.map(corridor) {
        [true, true] if gap.rooms[1].is_none() => 0.25,
        [true, false] => 0.12,
        [false, true] => 0.88,
        _ => 0.5,
    };
    drawing.rng.chance(chance)
}

fn swing(drawing: &mut Drawing, leaf: &Leaf) {
    let thin = drawing.thin();
    let swept = arc(|u, v| leaf.at(leaf.width * u, leaf.width * v), 0.0, FRAC_PI_2);
    drawing.picture.line(&swept, thin);
    match drawing.look.leaf {
        LeafStyle::Line => {
            let bold = Pen { width: thin.width * 1.5, ..thin };
            drawing.picture.line(&[leaf.at(0.0, 0.0), leaf.at(0.0, leaf.width)], bold);
        }
        LeafStyle::Panel(thick) => {
            let panel = [(0.0, 0.0), (thick, 0.0), (thick, leaf.width), (0.0, leaf.width)];
            drawing.picture.shape(&panel.map(|(u, v)| leaf.at(u, v)), Some(WHITE), thin);
        }
    }
}

/// Two leaves that overlap a little, one behind the other in the wall.
fn sliding(drawing: &mut Drawing, gap: &Gap) {
    let (thin, width) = (drawing.thin(), gap.segment.length());
    let thick = (gap.depth * 0.3).clamp(0.03, 0.07);
    let overlap = width * drawing.rng.range((0.03, 0.08));
    let halves = [(0.0, width / 2.0 + overlap, thick), (width / 2.0 - overlap, width, 0.0)];
    for (from, to, top) in halves {
        let low = top - thick;
        let panel = [gap.at(from, low), gap.at(to, low), gap.at(to, top), gap.at(from, top)];
        drawing.picture.shape(&panel, Some(WHITE), thin);
    }
    let opening = block(gap.segment.midpoint(), gap.axes().0, width, gap.depth);
    drawing.tell("sliding-door", &opening, vec![]);
}
