//! What interrupts a wall: doors, passages, entrances from outside, windows.

use super::drawing::Drawing;
use super::look::WallStyle;
use super::rooms::Purpose as Use;
use crate::params::RoomKind;
use crate::raster::band;
use crate::rng::Rng;
use planform_sdk::{OpeningKind, Point, RoomId, Segment, Wall};

/// Wall between two windows, or between a window and the end of its wall, metres.
const PIER: f64 = 0.45;

/// What a gap is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Door,
    DoubleDoor,
    SlidingDoor,
    Passage,
    Window,
}

/// A gap in a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gap {
    pub(super) purpose: Purpose,
    /// From jamb to jamb, along the wall's middle.
    pub(super) segment: Segment,
    /// The wall's thickness.
    pub(super) depth: f64,
    /// The rooms on its left and on its right.
    pub(super) rooms: [Option<RoomId>; 2],
}

impl Gap {
    /// Unit vectors along the gap and to its left.
    pub(super) fn axes(&self) -> ((f64, f64), (f64, f64)) {
        let (Segment { a, b }, l) = (self.segment, self.segment.length().max(1e-9));
        let (x, y) = ((b.x - a.x) / l, (b.y - a.y) / l);
        ((x, y), (-y, x))
    }

    /// The point `u` from the first jamb and `v` to the left of the wall's middle.
    pub(super) fn at(&self, u: f64, v: f64) -> Point {
        let (((x, y), (nx, ny)), a) = (self.axes(), self.segment.a);
        Point::new(a.x + x * u + nx * v, a.y + y * u + ny * v)
    }

    /// The part of the wall that is missing.
    pub(super) fn body(&self) -> [Point; 4] {
        band(&self.segment, self.depth / 2.0, 0.0)
    }
}

/// All gaps in the building's walls, those from outside included.
pub(super) fn plan(drawing: &mut Drawing, uses: &[Use]) -> Vec<Gap> {
    let mut gaps = inside(drawing, uses);
    entrances(drawing, &mut gaps);
    windows(drawing, &mut gaps);
    gaps
}

fn inside(drawing: &mut Drawing, uses: &[Use]) -> Vec<Gap> {
    let Drawing { site, look, rng, .. } = drawing;
    let openings = site.layout.openings.iter().zip(&site.depths);
    let lift = |id: RoomId| uses.get(id as usize - 1) == Some(&Use::Lift);
    let gap = |(o, &depth): (&planform_sdk::Opening, &f64)| {
        let purpose = match o.kind {
            OpeningKind::Passage => Purpose::Passage,
            OpeningKind::Door if o.width() > 2.2 => Purpose::Passage,
            OpeningKind::Door if o.width() > 1.35 => Purpose::DoubleDoor,
            OpeningKind::Door if o.rooms.into_iter().any(lift) => Purpose::SlidingDoor,
            OpeningKind::Door if rng.chance(look.sliding) => Purpose::SlidingDoor,
            OpeningKind::Door => Purpose::Door,
        };
        let left = side(o.segment, site.room(o.rooms[0]).map(|r| &r.centre));
        let [first, second] = o.rooms.map(Some);
        let rooms = if left { [first, second] } else { [second, first] };
        Gap { purpose, segment: o.segment, depth, rooms }
    };
    openings.map(gap).collect()
}

/// Whether the polygon lies to the left of the segment.
fn side(segment: Segment, polygon: Option<&planform_sdk::Polygon>) -> bool {
    let gap = Gap { purpose: Purpose::Passage, segment, depth: 0.0, rooms: [None; 2] };
    polygon.is_some_and(|p| p.contains(gap.at(segment.length() / 2.0, 0.05)))
}

/// One or two doors to the outside, where a corridor has an outer wall that is long enough, or else a room.
fn entrances(drawing: &mut Drawing, gaps: &mut Vec<Gap>) {
    let corridor = |d: &Drawing, w: &Wall| {
        let room = w.rooms[0].and_then(|id| d.site.room(id));
        room.is_some_and(|r| d.site.kind(r) == RoomKind::Corridor)
    };
    let outer = drawing.site.layout.walls.iter().filter(|w| w.rooms[1].is_none() && w.line.length() > 2.0);
    let (mut walls, mut others): (Vec<Wall>, Vec<Wall>) = outer.cloned().partition(|w| corridor(drawing, w));
    drawing.rng.shuffle(&mut walls);
    drawing.rng.shuffle(&mut others);
    others.truncate(1);
    let count = 1 + drawing.rng.index(2);
    for wall in walls.iter().chain(&others).take(count) {
        let room = wall.line.length() - 0.8;
        let double = room > 1.6 && drawing.rng.chance(0.5);
        let width = if double { drawing.rng.range((1.5, room.min(1.9))) } else { 0.95_f64.min(room) };
        let from = 0.4 + drawing.rng.range((0.0, room - width));
        let purpose = if double { Purpose::DoubleDoor } else { Purpose::Door };
        let gap = part(wall, from, width, purpose);
        if !gaps.iter().any(|g| near(g, &gap)) {
            gaps.push(gap);
        }
    }
}

fn part(wall: &Wall, from: f64, width: f64, purpose: Purpose) -> Gap {
    let whole = Gap { purpose, segment: wall.line, depth: wall.thickness, rooms: wall.rooms };
    Gap { segment: Segment::new(whole.at(from, 0.0), whole.at(from + width, 0.0)), ..whole }
}

fn near(a: &Gap, b: &Gap) -> bool {
    let reach = (a.segment.length() + b.segment.length()) / 2.0 + PIER;
    a.segment.midpoint().distance(b.segment.midpoint()) < reach
}

/// Windows along the outer walls, evenly spaced in each wall.
fn windows(drawing: &mut Drawing, gaps: &mut Vec<Gap>) {
    let usual = drawing.rng.range((0.9, 1.8));
    let outer: Vec<Wall> =
        drawing.site.layout.walls.iter().filter(|w| w.rooms[1].is_none()).cloned().collect();
    for wall in outer {
        let end = wall.thickness / 2.0 + PIER;
        let room = wall.line.length() - 2.0 * end;
        let width = if room < usual { room } else { usual };
        if width < 0.7 {
            continue;
        }
        let count = ((room + PIER) / (width + PIER + pier(&mut drawing.rng))).floor().max(1.0);
        let pitch = room / count;
        for i in 0..count as i32 {
            let from = end + pitch * (f64::from(i) + 0.5) - width / 2.0;
            let gap = part(&wall, from, width, Purpose::Window);
            let wanted = drawing.rng.chance(drawing.look.windows) && is_plain(drawing, &gap);
            if wanted && !gaps.iter().any(|g| near(g, &gap)) {
                gaps.push(gap);
            }
        }
    }
}

fn pier(rng: &mut Rng) -> f64 {
    rng.range((0.2, 1.6))
}

/// Whether no short wall or column meets the wall there, and the wall can show a window.
fn is_plain(drawing: &Drawing, gap: &Gap) -> bool {
    let middle = gap.segment.midpoint();
    let reach = gap.segment.length() / 2.0 + gap.depth;
    let corners = || drawing.site.solids.iter().flat_map(|s| &s.exterior);
    let thick = gap.depth > 3.0 * drawing.view.metres_per_pixel() || drawing.look.wall != WallStyle::Lines;
    thick && corners().all(|p| p.distance(middle) > reach)
}
