//! Which rooms are corridors.
//!
//! The tagging calls a walled, connecting way a corridor. So a room is one if it is long, narrow and leads somewhere:
//!
//! * as long and wide as the rectangle of its area and its outline's length, it is at least [`RATIO`] times as long as
//!   wide, which holds for corridors round corners as well, and
//! * that width is no more than [`WIDTH`], or it would be a hall, and
//! * openings lead to at least [`NEIGHBOURS`] other rooms, or it would be a closet.

use planform_sdk::{Layout, Point, Room};
use std::collections::BTreeSet;

/// Least length of a corridor, in widths.
const RATIO: f64 = 4.0;

/// Largest width of a corridor, metres.
const WIDTH: f64 = 4.0;

/// Fewest rooms that a corridor joins.
const NEIGHBOURS: usize = 2;

/// Whether the room is a corridor.
pub fn is_corridor(room: &Room, layout: &Layout) -> bool {
    // The floor, whatever outline is written: a thick wall makes no corridor wider.
    let (length, width) = sides(room.inner.area(), perimeter(&room.inner.exterior));
    length >= RATIO * width && width <= WIDTH && neighbours(room, layout) >= NEIGHBOURS
}

/// The sides of the rectangle of this area and perimeter, the longer one first; a square where there is none.
fn sides(area: f64, perimeter: f64) -> (f64, f64) {
    let half = perimeter / 2.0;
    let root = (half * half - 4.0 * area).max(0.0).sqrt();
    ((half + root) / 2.0, (half - root) / 2.0)
}

fn perimeter(ring: &[Point]) -> f64 {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, &b)| a.distance(b)).sum()
}

fn neighbours(room: &Room, layout: &Layout) -> usize {
    let openings = layout.openings.iter().filter(|o| o.rooms.contains(&room.id));
    openings.flat_map(|o| o.rooms).filter(|&other| other != room.id).collect::<BTreeSet<_>>().len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, OpeningKind, Polygon, RoomState, Segment};

    /// A room with this outline, with doors to so many others.
    fn judged(outline: &[[f64; 2]], doors: u32) -> bool {
        let inner = Polygon::new(outline.iter().copied().map(Point::from).collect(), vec![]);
        let centre = inner.clone();
        let room = Room { id: 1, name: None, stated_area: None, state: RoomState::Complete, centre, inner };
        let door = |n| Opening { kind: OpeningKind::Door, segment: Segment::default(), rooms: [1, n + 2] };
        let layout = Layout {
            rooms: vec![room.clone()],
            openings: (0..doors).map(door).collect(),
            ..Layout::default()
        };
        is_corridor(&room, &layout)
    }

    fn rectangle(length: f64, width: f64) -> [[f64; 2]; 4] {
        [[0.0, 0.0], [length, 0.0], [length, width], [0.0, width]]
    }

    #[test]
    fn long_narrow_and_leading_on() {
        assert!(judged(&rectangle(10.0, 2.0), 2));
        assert!(judged(&rectangle(8.1, 2.0), 2));
        assert!(!judged(&rectangle(7.9, 2.0), 2), "not long enough");
        assert!(!judged(&rectangle(40.0, 4.1), 2), "a hall");
        assert!(!judged(&rectangle(10.0, 2.0), 1), "a closet");
    }

    #[test]
    fn round_corners_too() {
        let l = [[0.0, 0.0], [9.0, 0.0], [9.0, 2.0], [2.0, 2.0], [2.0, 9.0], [0.0, 9.0]];
        assert!(judged(&l, 3));
    }

    #[test]
    fn nothing_is_no_corridor() {
        assert!(!judged(&[], 0));
    }
}
