//! The words in the rooms: name, number, size.

use super::drawing::{Drawing, Line, block};
use super::look::{Numbers, Sizes};
use super::rooms::Purpose;
use super::surface::circle;
use super::truth::{PlanName, PlanTextRole};
use crate::furniture::{Block, extent};
use planform_sdk::{Point, Room, RoomId, bounds};
use std::f64::consts::{FRAC_PI_2, PI};

/// From one baseline to the next, in heights of a capital.
const LEADING: f64 = 1.75;
/// Space around a label, in heights of a capital.
const AROUND: f64 = 0.5;

/// A line of a label: what it says, its role, and its size in that of a name.
type Part = (String, PlanTextRole, f64);

/// Writes in every room that has the space for it, and forgets the names that are not written.
pub(super) fn draw(drawing: &mut Drawing, purposes: &[Purpose]) {
    let rooms = drawing.site.layout.rooms.clone();
    let mut names = std::mem::take(&mut drawing.names);
    for ((room, name), &purpose) in rooms.iter().zip(&mut names).zip(purposes) {
        name.area = size(drawing, room, purpose);
        label(drawing, room, name);
    }
    names.retain(|n| n.name.is_some() || n.number.is_some() || n.area.is_some());
    drawing.names = names;
}

/// Tries the whole label in all directions, then with less of it; what is not written is taken out of the name.
fn label(drawing: &mut Drawing, room: &Room, name: &mut PlanName) {
    let upright = [0.0, FRAC_PI_2];
    let turned = [FRAC_PI_2, PI, -FRAC_PI_2];
    let angles: Vec<f64> = if drawing.rng.chance(drawing.look.turned_words) {
        vec![turned[drawing.rng.index(3)]]
    } else {
        upright.to_vec()
    };
    for keep in [3, 2, 1] {
        let mut less = name.clone();
        if keep < 3 {
            less.area = None;
        }
        if keep < 2 && less.name.is_some() {
            less.number = None;
        }
        for broken in [false, true] {
            let parts = parts(&less, broken);
            if angles.iter().any(|&angle| fits(drawing, room, &parts, angle)) {
                *name = less;
                return;
            }
        }
    }
    (name.name, name.number, name.area) = (None, None, None);
}

/// The lines of a label; `broken` puts every word of the name on its own.
fn parts(name: &PlanName, broken: bool) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    if let Some(text) = &name.name {
        let words: Vec<&str> = if broken { text.split(' ').collect() } else { vec![text] };
        parts.extend(words.into_iter().map(|w| (w.to_owned(), PlanTextRole::Name, 1.0)));
    }
    parts.extend(name.number.iter().map(|n| (n.clone(), PlanTextRole::Number, 1.0)));
    parts.extend(name.area.iter().map(|a| (a.clone(), PlanTextRole::Area, 0.92)));
    parts
}

/// Writes the label where it fits the room, as near to its middle as may be.
fn fits(drawing: &mut Drawing, room: &Room, parts: &[Part], angle: f64) -> bool {
    let capital = drawing.view.mm(drawing.look.capital);
    let width = |d: &Drawing, (text, role, size): &Part| {
        let line = d.line(text, capital * size, *role);
        d.measure(&line).0 + if *role == PlanTextRole::Number { mark(d) * 2.0 * capital } else { 0.0 }
    };
    let wide = parts.iter().map(|p| width(drawing, p)).fold(0.0, f64::max) + 2.0 * AROUND * capital;
    let mut high = (LEADING * parts.len() as f64 - 0.75 + 2.0 * AROUND) * capital;
    if parts.iter().any(|p| p.1 == PlanTextRole::Number) {
        high += 2.0 * mark(drawing) * capital;
    }
    let along = (angle.cos(), angle.sin());
    let Some(mut place) = place(drawing, room, along, wide, high) else { return false };
    if drawing.rng.chance(drawing.look.touching) {
        place = touching(drawing, room, place, AROUND * capital);
    }
    drawing.taken.push(place);
    write(drawing, room.id, parts, &place, angle);
    true
}

/// How far a circle or a box stands off the number in it, in heights of a capital.
fn mark(drawing: &Drawing) -> f64 {
    match drawing.look.numbers {
        Numbers::Circled | Numbers::Boxed => 0.7,
        _ => 0.0,
    }
}

/// A free place of this size, as near to the middle of the room's box as may be.
fn place(drawing: &mut Drawing, room: &Room, along: (f64, f64), wide: f64, high: f64) -> Option<Block> {
    let (low, high_corner) = bounds(room.inner.exterior.iter().copied())?;
    let middle = low.midpoint(high_corner);
    let jitter = drawing.rng.range((-0.1, 0.1)) * (high_corner.x - low.x).min(3.0);
    let mut tries: Vec<Point> = Vec::new();
    const N: i32 = 9;
    for i in -N..=N {
        for j in -N..=N {
            let share = |k: i32| f64::from(k) / f64::from(2 * N);
            tries.push(Point::new(
                middle.x + jitter + share(i) * (high_corner.x - low.x),
                middle.y + share(j) * (high_corner.y - low.y),
            ));
        }
    }
    tries.sort_by(|p, q| p.distance(middle).total_cmp(&q.distance(middle)));
    let blocks = tries.into_iter().map(|p| block(p, along, wide, high));
    blocks.into_iter().find(|b| drawing.is_free(room, b))
}

/// The place moved up to a wall, or to what else is there, so that nothing of the space `around` the ink is left.
fn touching(drawing: &mut Drawing, room: &Room, place: Block, around: f64) -> Block {
    let (half_length, half_depth) = (place.half_length - around, place.half_depth - around);
    let (u, v) = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)][drawing.rng.index(4)];
    let step = drawing.view.metres_per_pixel() / 2.0;
    let moved = |i: u32| {
        let by = step * f64::from(i);
        Block { middle: place.at(u * by, v * by), half_length, half_depth, ..place }
    };
    let steps = (0..2000).take_while(|&i| drawing.is_free(room, &moved(i))).last();
    Block { half_length: place.half_length, half_depth: place.half_depth, ..moved(steps.unwrap_or(0)) }
}

fn write(drawing: &mut Drawing, room: RoomId, parts: &[Part], place: &Block, angle: f64) {
    let capital = drawing.view.mm(drawing.look.capital);
    let step = LEADING * capital;
    let count = parts.len() as f64;
    let mut v = (count - 1.0) / 2.0 * step;
    let centred = drawing.look.turned_words > 0.0 || drawing.look.thresholds || room.is_multiple_of(2);
    let left = -place.half_length + AROUND * capital;
    for (text, role, size) in parts {
        let line = Line { room: Some(room), ..drawing.line(text, capital * size, *role) };
        let (wide, high) = drawing.measure(&line);
        let marked = *role == PlanTextRole::Number && mark(drawing) > 0.0;
        if marked {
            v -= mark(drawing) * capital;
        }
        let u = if centred || marked { 0.0 } else { left + wide / 2.0 };
        let middle = place.at(u, v);
        drawing.write(line, middle, angle);
        if marked {
            mark_number(drawing, &block(middle, place.along, wide, high), capital);
            v -= mark(drawing) * capital;
        }
        v -= step;
    }
}

/// The circle or the box around a number.
fn mark_number(drawing: &mut Drawing, ink: &Block, capital: f64) {
    let thin = drawing.thin();
    if drawing.look.numbers == Numbers::Circled {
        let radius = ink.radius() + 0.4 * capital;
        drawing.picture.rings([circle(ink.middle, radius).as_slice()], thin);
    } else {
        let (half_length, half_depth) = (ink.half_length + 0.5 * capital, ink.half_depth + 0.5 * capital);
        let frame = Block { half_length, half_depth, ..*ink };
        drawing.picture.rings([frame.corners().as_slice()], thin);
    }
}

/// What is written of a room's size.
fn size(drawing: &mut Drawing, room: &Room, purpose: Purpose) -> Option<String> {
    let box_of = extent(&room.inner.exterior)?;
    let (long, short) = (box_of.size.0, box_of.size.1);
    let rectangular = room.area() > 0.97 * long * short;
    let plain = !matches!(purpose, Purpose::Corridor | Purpose::Lift | Purpose::Stairs);
    match drawing.look.sizes {
        Sizes::None => None,
        Sizes::Area => Some(format!("{:.1} {}", room.area(), drawing.look.area_unit)),
        Sizes::Feet if rectangular && plain => Some(format!("{} x {}", feet(long), feet(short))),
        Sizes::Sides if rectangular && plain => Some(format!("{long:.2} x {short:.2}")),
        Sizes::Feet | Sizes::Sides => None,
    }
}

/// Feet and inches: 13'6, or 11' where there are no inches.
pub(super) fn feet(metres: f64) -> String {
    let inches = (metres / 0.0254).round() as i64;
    match (inches / 12, inches % 12) {
        (feet, 0) => format!("{feet}'"),
        (feet, inches) => format!("{feet}'{inches}"),
    }
}
