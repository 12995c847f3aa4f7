//! How the outlines of walls meet where the walls do.
//!
//! Around the point where walls end, each wall's left face is drawn out to the right face of the next wall, counting
//! counter-clockwise. So the outlines touch without gap or overlap, be it a corner, a T or a crossing.

use planform_sdk::{Point, Wall};
use std::collections::BTreeMap;

/// Ends of walls nearer than about this meet, metres.
const SAME_PLACE: f64 = 1e-3;
/// Faces drawn out farther than this many half thicknesses are cut off: the walls are all but parallel.
const MITRE_LIMIT: f64 = 4.0;
/// Sine of the angle below which walls count as parallel.
const PARALLEL: f64 = 0.05;

/// The place where a wall ends, on a grid.
type Place = [i64; 2];

/// One wall seen from one of its ends.
#[derive(Debug, Clone, Copy)]
pub struct End {
    pub at: Point,
    /// Unit vector from the end into the wall.
    pub into: Point,
    /// Half the wall's thickness, metres.
    pub half: f64,
}

/// All ends of walls, by place; around each place counter-clockwise.
pub struct Joints(BTreeMap<Place, Vec<End>>);

impl Joints {
    pub fn new(walls: &[Wall]) -> Self {
        let mut places: BTreeMap<Place, Vec<End>> = BTreeMap::new();
        for end in walls.iter().filter_map(ends).flatten() {
            places.entry(place(end.at)).or_default().push(end);
        }
        for ends in places.values_mut() {
            ends.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
        }
        Self(places)
    }

    /// The corners of a wall's outline at this end, from the left face to the right one as seen into the wall. Faces
    /// are shortened by at most `longest_cut` metres.
    pub fn corners(&self, end: &End, longest_cut: f64) -> Vec<Point> {
        let others = self.0.get(&place(end.at)).map_or(&[][..], Vec::as_slice);
        let here = others.iter().position(|o| o.into == end.into && o.half == end.half);
        let (Some(here), count @ 2..) = (here, others.len()) else { return butt(end) };
        let cut = |other: &End, side: f64| cut_off(end, other, side, longest_cut);
        let left = cut(&others[(here + 1) % count], 1.0);
        let right = cut(&others[(here + count - 1) % count], -1.0);
        let middle = (count > 2).then_some(end.at);
        [Some(beside(end, left, 1.0)), middle, Some(beside(end, right, -1.0))].into_iter().flatten().collect()
    }
}

/// The corners of an end that meets nothing.
pub fn butt(end: &End) -> Vec<Point> {
    vec![beside(end, 0.0, 1.0), beside(end, 0.0, -1.0)]
}

/// The ends of a wall at the start and at the end of its line; `None` for a wall with no extent.
pub fn ends(wall: &Wall) -> Option<[End; 2]> {
    let (a, b, length) = (wall.line.a, wall.line.b, wall.line.length());
    let half = wall.thickness / 2.0;
    let into = Point::new((b.x - a.x) / length, (b.y - a.y) / length);
    let back = Point::new(-into.x, -into.y);
    (length > SAME_PLACE && half > 0.0)
        .then_some([End { at: a, into, half }, End { at: b, into: back, half }])
}

/// How far into the wall its face on one side (1 left, -1 right) meets the neighbour's face.
fn cut_off(end: &End, neighbour: &End, side: f64, longest: f64) -> f64 {
    let (u, v) = (end.into, neighbour.into);
    let sine = u.x * v.y - u.y * v.x;
    let cosine = u.x * v.x + u.y * v.y;
    let cut = side * (neighbour.half + end.half * cosine) / sine;
    let farthest = MITRE_LIMIT * end.half.max(neighbour.half);
    if sine.abs() < PARALLEL || cut.abs() > farthest || cut > longest { 0.0 } else { cut }
}

/// The point on the face of one side (1 left, -1 right), this far into the wall.
fn beside(end: &End, along: f64, side: f64) -> Point {
    let (u, h) = (end.into, end.half * side);
    Point::new(end.at.x + u.x * along - u.y * h, end.at.y + u.y * along + u.x * h)
}

fn angle(end: &End) -> f64 {
    end.into.y.atan2(end.into.x)
}

fn place(p: Point) -> Place {
    [p.x, p.y].map(|v| (v / SAME_PLACE).round() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Segment;

    fn wall(a: [f64; 2], b: [f64; 2], thickness: f64) -> Wall {
        Wall { line: Segment::new(a.into(), b.into()), thickness, weight: 1.0, rooms: [None, None] }
    }

    fn corners(walls: &[Wall]) -> Vec<Point> {
        Joints::new(walls).corners(&ends(&walls[0]).unwrap()[0], 10.0)
    }

    fn assert_near(points: &[Point], expected: &[[f64; 2]]) {
        assert_eq!(points.len(), expected.len(), "{points:?}");
        for (p, e) in points.iter().zip(expected) {
            assert!(p.distance((*e).into()) < 1e-9, "{points:?} {expected:?}");
        }
    }

    #[test]
    fn a_corner_is_mitred() {
        let walls = [wall([0.0, 0.0], [5.0, 0.0], 0.2), wall([0.0, 0.0], [0.0, 5.0], 0.4)];
        assert_near(&corners(&walls), &[[0.2, 0.1], [-0.2, -0.1]]);
    }

    #[test]
    fn the_stem_of_a_t_ends_at_the_bar() {
        let stem = wall([0.0, 0.0], [0.0, 5.0], 0.2);
        let bar = [wall([0.0, 0.0], [5.0, 0.0], 0.2), wall([-5.0, 0.0], [0.0, 0.0], 0.2)];
        assert_near(
            &corners(&[stem, bar[0].clone(), bar[1].clone()]),
            &[[-0.1, 0.1], [0.0, 0.0], [0.1, 0.1]],
        );
    }

    #[test]
    fn free_and_straight_ends_are_square() {
        let square = [[0.0, 0.1], [0.0, -0.1]];
        let alone = wall([0.0, 0.0], [5.0, 0.0], 0.2);
        assert_near(&corners(std::slice::from_ref(&alone)), &square);
        assert_near(&corners(&[alone, wall([-5.0, 0.0], [0.0, 0.0], 0.2)]), &square);
    }

    #[test]
    fn a_sharp_corner_is_no_spike() {
        let walls = [wall([0.0, 0.0], [5.0, 0.0], 0.2), wall([0.0, 0.0], [5.0, 0.5], 0.2)];
        assert!(corners(&walls).iter().all(|p| p.distance(Point::default()) < 1.0));
    }
}
