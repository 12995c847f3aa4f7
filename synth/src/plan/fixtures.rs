//! Stairs, lifts, toilets and basins: what is fixed to the building and has a symbol.

use super::drawing::{Drawing, block};
use super::places::{against_wall, anywhere};
use super::rooms::Purpose;
use super::surface::{WHITE, arc, circle};
use crate::furniture::{Block, extent};
use planform_sdk::{Point, Room};
use std::f64::consts::{PI, TAU};

/// How this plan draws what is fixed.
struct Hand {
    /// Metres from step to step.
    tread: f64,
    /// Whether an arrow shows the way up.
    arrow: bool,
    /// Whether a lift's box has both diagonals in a second box.
    cabin: bool,
    toilet: (f64, f64),
    tank: f64,
    sink: (f64, f64),
    round_sink: bool,
}

pub(super) fn draw(drawing: &mut Drawing, purposes: &[Purpose]) {
    let rng = &mut drawing.rng;
    let hand = Hand {
        tread: rng.range((0.25, 0.31)),
        arrow: rng.chance(0.7),
        cabin: rng.chance(0.5),
        toilet: (rng.range((0.36, 0.44)), rng.range((0.6, 0.75))),
        tank: rng.range((0.16, 0.24)),
        sink: (rng.range((0.5, 0.65)), rng.range((0.4, 0.5))),
        round_sink: rng.chance(0.5),
    };
    let rooms = drawing.site.layout.rooms.clone();
    for (room, &purpose) in rooms.iter().zip(purposes) {
        match purpose {
            Purpose::Stairs => stairs(drawing, room, &hand),
            Purpose::Lift => lift(drawing, room, &hand),
            Purpose::Wet => wet(drawing, room, &hand),
            _ => {}
        }
    }
}

/// Two flights beside each other, or a straight one along a wall; where neither has its place there is a store.
fn stairs(drawing: &mut Drawing, room: &Room, hand: &Hand) {
    let Some(size) = extent(&room.inner.exterior).map(|e| e.size) else { return };
    let (long, short) = (size.0.max(size.1), size.0.min(size.1));
    let width = drawing.rng.range((1.0, 1.35)).min(short - 0.2);
    let most = ((long - 0.3) / hand.tread).floor().clamp(5.0, 15.0);
    for share in [0.85, 0.7, 0.5] {
        let steps = (most * share).round().max(5.0);
        for flights in [2, 1] {
            let size = (steps * hand.tread, if flights == 2 { 2.0 * width + 0.12 } else { width });
            if let Some(place) = against_wall(drawing, room, size, 0.15, Drawing::put) {
                return climb(drawing, &place, width, steps as i32, hand);
            }
        }
    }
    let name = drawing.names.iter_mut().find(|n| n.room == room.id).and_then(|n| n.name.as_mut());
    if let Some(name) = name {
        *name = if drawing.look.upper_case { "STORE".into() } else { "Store".into() };
    }
}

fn climb(drawing: &mut Drawing, place: &Block, width: f64, steps: i32, hand: &Hand) {
    let half = |v: f64| block(place.at(0.0, v), place.along, 2.0 * place.half_length, width);
    let v = place.half_depth - width / 2.0;
    if v > 0.01 {
        flight(drawing, &half(-v), steps, hand.arrow, 1.0);
        flight(drawing, &half(v), steps, hand.arrow, -1.0);
    } else {
        flight(drawing, place, steps, hand.arrow, 1.0);
    }
    drawing.tell("stairs", place, vec![]);
}

fn flight(drawing: &mut Drawing, place: &Block, steps: i32, arrow: bool, up: f64) {
    let thin = drawing.thin();
    let (l, d) = (place.half_length, place.half_depth);
    for i in 0..=steps {
        let u = l * (2.0 * f64::from(i) / f64::from(steps) - 1.0);
        drawing.picture.line(&[place.at(u, -d), place.at(u, d)], thin);
    }
    for v in [-d, d] {
        drawing.picture.line(&[place.at(-l, v), place.at(l, v)], thin);
    }
    if arrow {
        let tip = up * (l - 0.1);
        drawing.picture.line(&[place.at(-up * (l - 0.15), 0.0), place.at(tip, 0.0)], thin);
        let head = [place.at(tip - up * 0.22, 0.1), place.at(tip, 0.0), place.at(tip - up * 0.22, -0.1)];
        drawing.picture.line(&head, thin);
    }
}

/// A box with both diagonals, most of the room wide.
fn lift(drawing: &mut Drawing, room: &Room, hand: &Hand) {
    let Some(size) = extent(&room.inner.exterior).map(|e| e.size) else { return };
    for share in [0.85, 0.7, 0.55] {
        let (long, deep) = ((size.0 * share).min(2.4), (size.1 * share).min(2.2));
        if long.min(deep) < 0.95 {
            return;
        }
        let place = against_wall(drawing, room, (long, deep), 0.05, Drawing::take);
        if let Some(place) = place {
            cabin(drawing, &place, hand.cabin);
            return;
        }
    }
}

fn cabin(drawing: &mut Drawing, place: &Block, double: bool) {
    let thin = drawing.thin();
    drawing.picture.shape(&place.corners(), Some(WHITE), thin);
    let inner = if double {
        let inner =
            Block { half_length: place.half_length - 0.1, half_depth: place.half_depth - 0.1, ..*place };
        drawing.picture.rings([inner.corners().as_slice()], thin);
        inner
    } else {
        *place
    };
    let [a, b, c, d] = corners(&inner);
    drawing.picture.line(&[a, c], thin);
    drawing.picture.line(&[b, d], thin);
    drawing.tell("lift", place, vec![]);
}

fn corners(b: &Block) -> [Point; 4] {
    let (l, d) = (b.half_length, b.half_depth);
    [b.at(-l, -d), b.at(l, -d), b.at(l, d), b.at(-l, d)]
}

fn wet(drawing: &mut Drawing, room: &Room, hand: &Hand) {
    let most = (room.area() / 3.0).clamp(1.0, 4.0) as u32;
    for _ in 0..1 + drawing.rng.index(most as usize) {
        if let Some(place) = against_wall(drawing, room, hand.toilet, 0.12, Drawing::put) {
            toilet(drawing, &place, hand);
        }
    }
    for _ in 0..1 + drawing.rng.index(most as usize) {
        if let Some(place) = against_wall(drawing, room, hand.sink, 0.1, Drawing::put) {
            basin(drawing, &place, hand.round_sink);
        }
    }
}

/// A tank at the wall, and an oval bowl with its seat.
fn toilet(drawing: &mut Drawing, place: &Block, hand: &Hand) {
    let thin = drawing.thin();
    let (l, d) = (place.half_length, place.half_depth);
    let tank = [place.at(-l, -d), place.at(l, -d), place.at(l, -d + hand.tank), place.at(-l, -d + hand.tank)];
    drawing.picture.shape(&tank, Some(WHITE), thin);
    let half = d - hand.tank / 2.0;
    let bowl =
        |share: f64| arc(|u, v| place.at(0.9 * share * l * u, hand.tank / 2.0 + share * half * v), 0.0, TAU);
    drawing.picture.shape(&bowl(1.0), Some(WHITE), thin);
    if hand.cabin {
        drawing.picture.rings([bowl(0.72).as_slice()], thin);
    }
    drawing.tell("toilet", place, vec![]);
}

/// A basin: a box or a half round one with an oval in it, and the tap.
pub(super) fn basin(drawing: &mut Drawing, place: &Block, round: bool) {
    let thin = drawing.thin();
    let (l, d) = (place.half_length, place.half_depth);
    let outer = if round {
        let mut ring = arc(|u, v| place.at(l * u, -d + 2.0 * d * v), 0.0, PI);
        ring.push(place.at(-l, -d));
        ring
    } else {
        place.corners()
    };
    drawing.picture.shape(&outer, Some(WHITE), thin);
    let bowl = arc(|u, v| place.at(0.72 * l * u, 0.08 * d + 0.58 * d * v), 0.0, TAU);
    drawing.picture.rings([bowl.as_slice()], thin);
    let tap = circle(place.at(0.0, -0.75 * d), 0.04);
    drawing.picture.shape(&tap, None, thin);
    drawing.tell("sink", place, vec![]);
}

/// A kitchen's counter with its sink and a stove.
pub(super) fn counter(drawing: &mut Drawing, room: &Room) {
    let length = drawing.rng.range((1.8, 3.2));
    let Some(place) = against_wall(drawing, room, (length, 0.6), 0.05, Drawing::put) else { return };
    let thin = drawing.thin();
    drawing.picture.shape(&place.corners(), Some(WHITE), thin);
    let sink = block(place.at(-length / 4.0, 0.0), place.along, 0.6, 0.45);
    basin(drawing, &sink, false);
    let stove = block(place.at(length / 2.0 - 0.35, 0.0), place.along, 0.56, 0.52);
    drawing.picture.rings([stove.corners().as_slice()], thin);
    for (u, v) in [(-0.13, -0.12), (0.13, -0.12), (0.13, 0.12), (-0.13, 0.12)] {
        drawing.picture.rings([circle(stove.at(u, v), 0.08).as_slice()], thin);
    }
}

/// A table that people sit around; see [`furnish`](super::furnish).
pub(super) fn round_table(drawing: &mut Drawing, room: &Room, radius: f64) -> Option<Block> {
    let place = anywhere(drawing, room, (2.0 * radius + 1.0, 2.0 * radius + 1.0), 0.0, Drawing::put)?;
    let thin = drawing.thin();
    drawing.picture.shape(&circle(place.middle, radius), Some(WHITE), thin);
    Some(place)
}
