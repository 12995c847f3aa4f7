//! Buildings with any number of walls that do not line up: each room has four representative lines of its own.

use crate::picture::{FREE, Picture, WALL};

/// Side of a cell, metres.
pub const RESOLUTION: f64 = 0.2;

/// Cells from one line to the next of the same direction: 1 m, which is more than what one line draws together.
const PITCH: usize = 5;

/// Cells of a room's side, walls included: the lines of its two walls are 9 m apart, an odd number, and begin at an
/// even one.
const SIDE: usize = 46;

/// Where the door begins and ends, cells along the wall: 1 m wide.
const DOOR: (usize, usize) = (20, 25);

/// So many square rooms, of which no two have a line in common.
pub fn rooms(count: usize) -> Picture {
    let side = PITCH * (2 * count + 2) + SIDE;
    let corners = corners(count);
    let mut picture = Picture::unknown(side, side);
    // Rooms may overlap, and all their walls have to be seen: floors first.
    for &(x, y) in &corners {
        picture.fill((x, x + SIDE), (y, y + SIDE), FREE);
    }
    for &(x, y) in &corners {
        walls(&mut picture, x, y);
    }
    picture
}

fn walls(picture: &mut Picture, x: usize, y: usize) {
    let (right, end) = (x + SIDE - 1, y + SIDE - 1);
    picture.fill((x, x + SIDE), (y, y + 1), WALL);
    picture.fill((x, x + SIDE), (end, end + 1), WALL);
    picture.fill((x, x + 1), (y, y + SIDE), WALL);
    picture.fill((right, right + 1), (y, y + SIDE), WALL);
    picture.fill((x + DOOR.0, x + DOOR.1), (y, y + 1), FREE);
}

/// The rooms' corners: in x one after the other, in y as well, but in another order.
fn corners(count: usize) -> Vec<(usize, usize)> {
    let at = |number: usize| PITCH + 2 * PITCH * number;
    shuffled(count).into_iter().enumerate().map(|(x, y)| (at(x), at(y))).collect()
}

/// The numbers below `count` in a random order, always the same.
fn shuffled(count: usize) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    // Knuth's linear congruential generator, of which the high bits are good.
    let mut state = 1_u64;
    for i in (1..count).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        numbers.swap(i, (state >> 33) as usize % (i + 1));
    }
    numbers
}
