//! Puts walls and doors onto the outlines of the rooms that they belong to.
//!
//! A wall's line is where the wall was measured, and an outline runs along the line that the whole building has there,
//! which may be some centimetres, at times decimetres, beside it. On a map the two must be one line: a door beside an
//! outline leads nowhere.

use crate::grain::Grain;
use crate::thread::TOLERANCE;
use planform_sdk::RoomId;
use std::collections::{BTreeMap, BTreeSet};

/// How far a wall or a door may lie beside its outline, millimetres.
const REACH: f64 = 1000.0;

/// How far from a corner a wall may end and still meet it, millimetres.
const CORNER_REACH: f64 = 500.0;

/// How far a wall or door may be turned from its outline: the sine of 20 degrees.
const TURN: f64 = 0.342;

/// The rings of all rooms, and their corners.
pub struct Outlines<'a> {
    rooms: BTreeMap<RoomId, &'a [Vec<Grain>]>,
    corners: BTreeSet<Grain>,
}

type Edge = (Grain, Grain);

impl<'a> Outlines<'a> {
    /// The outlines of these rooms.
    pub fn new(rooms: impl IntoIterator<Item = (RoomId, &'a [Vec<Grain>])>) -> Self {
        let rooms: BTreeMap<_, _> = rooms.into_iter().collect();
        let corners = rooms.values().copied().flatten().flatten().copied().collect();
        Self { rooms, corners }
    }

    /// The wall between these rooms, on the outline that it runs along and from corner to corner where it ends near
    /// them. A wall that no outline is near to stays where it is.
    pub fn wall(&self, ends: [Grain; 2], rooms: [Option<RoomId>; 2]) -> [Grain; 2] {
        let edges = rooms.into_iter().flatten().flat_map(|room| self.edges(room));
        let near = edges.filter_map(|edge| Some((distance(middle(ends), edge, ends)?, edge)));
        let Some((_, edge)) = near.min_by(|p, q| p.0.total_cmp(&q.0)) else { return ends };
        let feet = ends.map(|end| foot(end, edge));
        let met = feet.map(|foot| self.corner(foot, edge).unwrap_or(foot));
        if met[0] == met[1] { feet } else { met }
    }

    /// The node of an opening with these jambs, on the outlines of both rooms if they have an edge in common there.
    pub fn door(&self, jambs: [Grain; 2], rooms: [RoomId; 2]) -> Grain {
        let middle = middle(jambs);
        let [ours, theirs] = rooms.map(|room| self.edges(room).collect::<Vec<_>>());
        let near =
            ours.iter().filter_map(|&edge| Some((distance(middle, edge, jambs)?, foot_within(middle, edge))));
        let alone = |foot: Grain| !theirs.iter().any(|&edge| is_on(foot, edge));
        near.min_by(|p, q| alone(p.1).cmp(&alone(q.1)).then(p.0.total_cmp(&q.0)))
            .map_or(middle, |(_, foot)| foot)
    }

    /// The nearest corner on the edge's line within reach: of any room, for a wall may end where the next one begins.
    fn corner(&self, p: Grain, edge: Edge) -> Option<Grain> {
        let reach = CORNER_REACH as i64;
        let west = Grain { x: p.x - reach, y: i64::MIN };
        let east = Grain { x: p.x + reach, y: i64::MAX };
        let near = self.corners.range(west..=east).map(|&corner| (length(p, corner), corner));
        let near = near.filter(|&(distance, corner)| distance <= CORNER_REACH && is_on_line(corner, edge));
        near.min_by(|p, q| p.0.total_cmp(&q.0)).map(|(_, corner)| corner)
    }

    fn edges(&self, room: RoomId) -> impl Iterator<Item = Edge> {
        let rings = self.rooms.get(&room).copied().unwrap_or_default();
        rings.iter().flat_map(|ring| ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)))
    }
}

fn middle([a, b]: [Grain; 2]) -> Grain {
    Grain { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }
}

/// How far the point is from the edge, if that is within reach and the edge runs along the segment.
fn distance(p: Grain, edge: Edge, along: [Grain; 2]) -> Option<f64> {
    let distance = length(p, foot_within(p, edge));
    (distance <= REACH && is_along(along, edge)).then_some(distance)
}

fn is_along([a, b]: [Grain; 2], edge: Edge) -> bool {
    let moved = Grain { x: edge.0.x + b.x - a.x, y: edge.0.y + b.y - a.y };
    moved.beside(edge.0, edge.1).is_some_and(|(_, off)| off <= TURN * length(a, b))
}

fn length(a: Grain, b: Grain) -> f64 {
    ((a.x - b.x) as f64).hypot((a.y - b.y) as f64)
}

/// The point of the edge's line that is nearest to `p`.
fn foot(p: Grain, edge: Edge) -> Grain {
    p.beside(edge.0, edge.1).map_or(edge.0, |(along, _)| at(along, edge))
}

/// The point of the edge that is nearest to `p`.
fn foot_within(p: Grain, edge: Edge) -> Grain {
    let along = |(along, _): (f64, f64)| at(along.clamp(0.0, length(edge.0, edge.1)), edge);
    p.beside(edge.0, edge.1).map_or(edge.0, along)
}

/// The point so many millimetres along the edge, which has a length.
fn at(along: f64, (a, b): Edge) -> Grain {
    let share = along / length(a, b);
    let between = |a: i64, b: i64| a + ((b - a) as f64 * share).round() as i64;
    Grain { x: between(a.x, b.x), y: between(a.y, b.y) }
}

fn is_on_line(p: Grain, edge: Edge) -> bool {
    p.beside(edge.0, edge.1).is_some_and(|(_, off)| off <= TOLERANCE)
}

fn is_on(p: Grain, edge: Edge) -> bool {
    length(p, foot_within(p, edge)) <= TOLERANCE
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn g(x: i64, y: i64) -> Grain {
        Grain { x, y }
    }

    /// Room 1 to the left of room 2, which is lower.
    fn rings() -> [Vec<Vec<Grain>>; 2] {
        [
            vec![vec![g(0, 0), g(4000, 0), g(4000, 3000), g(0, 3000)]],
            vec![vec![g(4000, 500), g(8000, 500), g(8000, 2500), g(4000, 2500)]],
        ]
    }

    fn fitted<T>(work: impl FnOnce(&Outlines<'_>) -> T) -> T {
        let rings = rings();
        work(&Outlines::new((1..).zip(rings.iter().map(Vec::as_slice))))
    }

    #[test]
    fn walls_lie_on_outlines_and_meet_corners() {
        fitted(|outlines| {
            let both = [Some(1), Some(2)];
            assert_eq!(outlines.wall([g(4060, 480), g(4060, 2560)], both), [g(4000, 500), g(4000, 2500)]);
            assert_eq!(
                outlines.wall([g(-50, 3040), g(2000, 3040)], [None, Some(1)]),
                [g(0, 3000), g(2000, 3000)]
            );
        });
    }

    #[test]
    fn a_short_wall_at_a_corner_keeps_its_length() {
        fitted(|outlines| {
            assert_eq!(outlines.wall([g(100, 10), g(300, 10)], [Some(1), None]), [g(100, 0), g(300, 0)]);
        });
    }

    #[test]
    fn what_no_outline_is_near_to_stays() {
        fitted(|outlines| {
            let across = [g(200, 200), g(1000, 1000)];
            assert_eq!(outlines.wall(across, [Some(1), None]), across);
            assert_eq!(outlines.wall(across, [None, None]), across);
            assert_eq!(outlines.door([g(20_000, 0), g(20_000, 900)], [1, 2]), g(20_000, 450));
        });
    }

    #[test]
    fn doors_lie_where_both_outlines_do() {
        fitted(|outlines| {
            assert_eq!(outlines.door([g(4100, 1000), g(4100, 1900)], [1, 2]), g(4000, 1450));
        });
    }

    #[test]
    fn a_side_of_both_rooms_is_preferred_to_a_nearer_one() {
        let [_, low] = rings();
        let stepped = [g(0, 0), g(4000, 0), g(4000, 3000), g(4300, 3000), g(4300, 5000), g(0, 5000)];
        let stepped = vec![stepped.to_vec()];
        let outlines = Outlines::new([(1, stepped.as_slice()), (2, low.as_slice())]);
        assert_eq!(outlines.door([g(4700, 2400), g(4700, 2580)], [1, 2]), g(4000, 2490));
    }
}
