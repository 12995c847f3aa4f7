//! Free places in a room: along its walls, and in its middle.

use super::drawing::{Drawing, block};
use crate::furniture::{Block, Extent, extent};
use planform_sdk::{Point, Room};

/// Takes a place if it is free: [`Drawing::take`] for what is drawn, [`Drawing::put`] for what stands there.
type Take = fn(&mut Drawing, &Room, Block, f64) -> bool;

const TRIES: u32 = 14;

/// What is fixed to a wall keeps this far from it, metres: the thickness of a line.
const OFF_WALL: f64 = 0.04;

/// Takes a place with its back to a wall: the wall is at the block's lower side (v < 0). `around` is kept free too.
pub(super) fn against_wall(
    drawing: &mut Drawing,
    room: &Room,
    (wide, deep): (f64, f64),
    around: f64,
    take: Take,
) -> Option<Block> {
    let ring = &room.inner.exterior;
    let sides: Vec<(Point, Point)> = ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)).collect();
    let sides: Vec<_> = sides.into_iter().filter(|(a, b)| a.distance(*b) > wide + 0.1).collect();
    for _ in 0..TRIES {
        let &(a, b) = sides.get(drawing.rng.index(sides.len()))?;
        let length = a.distance(b);
        let (x, y) = ((b.x - a.x) / length, (b.y - a.y) / length);
        let slack = length - wide - 2.0 * OFF_WALL;
        // Things like to stand in corners.
        let u = match drawing.rng.index(4) {
            0 => 0.0,
            1 => slack,
            _ => drawing.rng.range((0.0, slack.max(0.01))),
        } + wide / 2.0
            + OFF_WALL;
        let v = deep / 2.0 + OFF_WALL;
        let place = block(Point::new(a.x + x * u - y * v, a.y + y * u + x * v), (x, y), wide, deep);
        if take(drawing, room, place, around) {
            return Some(place);
        }
    }
    None
}

/// Takes a place anywhere in the room, its sides parallel to the room's.
pub(super) fn anywhere(
    drawing: &mut Drawing,
    room: &Room,
    (wide, deep): (f64, f64),
    around: f64,
    take: Take,
) -> Option<Block> {
    let Extent { corner, along: (x, y), size } = extent(&room.inner.exterior)?;
    for _ in 0..TRIES {
        let (u, v) = (drawing.rng.range((0.0, size.0)), drawing.rng.range((0.0, size.1)));
        let along = if drawing.rng.chance(0.5) { (x, y) } else { (-y, x) };
        let place = block(Point::new(corner.x + x * u - y * v, corner.y + y * u + x * v), along, wide, deep);
        if take(drawing, room, place, around) {
            return Some(place);
        }
    }
    None
}
