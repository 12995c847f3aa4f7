//! Tiny buildings made by hand, axis-parallel and on exact multiples of 0.05 m.

use crate::building::Building;
use crate::doors::Door;
use crate::params::RoomKind;
use crate::partition::Partition;
use crate::shape::Shape;
use planform_sdk::{OpeningKind, Point};

/// Measures of a [`simple`] building, metres. Multiples of 0.1 keep every wall face on a multiple of 0.05.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimpleParams {
    /// Width of a room between the centre lines of its walls.
    pub room_width: f64,
    /// Depth of a room between the centre lines of its walls.
    pub room_depth: f64,
    /// Thickness of all walls.
    pub wall: f64,
    /// Clear width of all doors, which are in the middle of their walls.
    pub door: f64,
}

impl Default for SimpleParams {
    fn default() -> Self {
        Self { room_width: 4.0, room_depth: 5.0, wall: 0.2, door: 1.0 }
    }
}

/// Two rooms side by side with a door between them; the lower left outer corner's centre line is at (0, 0).
pub fn two_rooms() -> Building {
    simple(2, 1, &SimpleParams::default())
}

/// A grid of `columns` by `rows` rooms (each 1 to 20) with a door between any two neighbours. Room 1 is the lower
/// left one, room 2 is to its right.
pub fn simple(columns: usize, rows: usize, params: &SimpleParams) -> Building {
    let (columns, rows) = (columns.clamp(1, 20), rows.clamp(1, 20));
    let (w, d) = (params.room_width, params.room_depth);
    let cells = (0..rows).flat_map(|r| (0..columns).map(move |c| (c as f64, r as f64)));
    let shapes = cells.map(|(c, r)| rectangle(c * w, r * d, (c + 1.0) * w, (r + 1.0) * d, RoomKind::Room));
    build(&shapes.collect::<Vec<_>>(), params, |_, _| true)
}

/// A corridor, room 1, with `n` rooms (1 to 100) along both its sides, each with a door to the corridor only.
pub fn corridor_with_rooms(n: usize) -> Building {
    let n = n.clamp(1, 100);
    let params = SimpleParams::default();
    let below = n.div_ceil(2);
    let width = params.room_width;
    let mut shapes = vec![rectangle(0.0, 0.0, below as f64 * width, 2.0, RoomKind::Corridor)];
    for i in 0..n {
        let (x, y) = if i < below {
            (i as f64 * width, -params.room_depth)
        } else {
            ((i - below) as f64 * width, 2.0)
        };
        shapes.push(rectangle(x, y, x + width, y + params.room_depth, RoomKind::Room));
    }
    build(&shapes, &params, |left, _| left == 0)
}

fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64, kind: RoomKind) -> Shape {
    let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Point::from).to_vec();
    Shape { rings: vec![ring], kind, access: None }
}

fn build(shapes: &[Shape], params: &SimpleParams, joins: impl Fn(usize, usize) -> bool) -> Building {
    let usual = SimpleParams::default();
    let made = assemble(shapes, params, &joins);
    // Walls thicker than a room leave nothing to build: the usual walls then stand in.
    made.or_else(|| assemble(shapes, &usual, &joins)).unwrap_or_else(two_rooms)
}

fn assemble(
    shapes: &[Shape],
    params: &SimpleParams,
    joins: &impl Fn(usize, usize) -> bool,
) -> Option<Building> {
    let partition = Partition::new(shapes)?;
    let thickness = vec![params.wall; partition.runs.len()];
    let doors = (0..partition.runs.len()).filter_map(|run| {
        let wall = &partition.runs[run];
        let from = (partition.length(wall) - params.door) / 2.0;
        let fits = wall.right.is_some_and(|right| joins(wall.left, right)) && from > params.wall / 2.0;
        fits.then_some(Door { run, from, width: params.door, kind: OpeningKind::Door, whole: false })
    });
    Building::assemble(&partition, shapes, &thickness, &doors.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rooms_lie_where_their_measures_say() {
        let building = two_rooms();
        let layout = building.layout();
        assert_eq!(layout.rooms.len(), 2);
        assert_eq!(layout.rooms[0].inner.exterior[0], Point::new(0.1, 0.1));
        assert!((layout.rooms[0].area() - 3.8 * 4.8).abs() < 1e-9);
        assert_eq!(layout.openings.len(), 1);
        assert_eq!(layout.openings[0].rooms, [1, 2]);
        assert!((layout.openings[0].segment.midpoint().y - 2.5).abs() < 1e-9);
    }

    #[test]
    fn every_room_of_a_corridor_has_its_door() {
        let building = corridor_with_rooms(7);
        assert_eq!(building.layout().rooms.len(), 8);
        assert!(building.layout().openings.iter().all(|o| o.rooms[0] == 1));
        assert_eq!(building.layout().openings.len(), 7);
    }

    #[test]
    fn a_grid_of_rooms_has_all_its_doors() {
        let layout = simple(3, 2, &SimpleParams::default()).layout().clone();
        assert_eq!((layout.rooms.len(), layout.openings.len()), (6, 7));
    }

    #[test]
    fn impossible_measures_still_give_a_building() {
        let params = SimpleParams { room_width: 0.0, wall: 9.0, ..SimpleParams::default() };
        assert!(!simple(2, 2, &params).layout().rooms.is_empty());
    }
}
