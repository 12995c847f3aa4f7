//! Which stretches of a wall its openings take away.

use planform_sdk::{Point, Segment, Wall};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// How far an opening may lie beside a wall's faces and still be cut out of it, metres.
const TOLERANCE: f64 = 0.05;
/// What is left of a wall is drawn if it is longer than this, metres.
const SHORTEST_PIECE: f64 = 1e-3;

/// Openings from jamb to jamb, found by where they lie.
pub struct Openings(RTree<GeomWithData<Rectangle<[f64; 2]>, Segment>>);

impl Openings {
    pub fn new(openings: impl IntoIterator<Item = Segment>) -> Self {
        let boxed = |s: Segment| {
            let (lo, hi) = bounds(&s);
            GeomWithData::new(Rectangle::from_corners([lo.x, lo.y], [hi.x, hi.y]), s)
        };
        Self(RTree::bulk_load(openings.into_iter().map(boxed).collect()))
    }

    /// The stretches of the wall between its openings, as distances from its start, in order.
    pub fn pieces(&self, wall: &Wall) -> Vec<[f64; 2]> {
        let length = wall.line.length();
        let mut gaps = self.gaps(wall);
        gaps.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut pieces = vec![];
        let mut start = 0.0;
        for [from, to] in gaps.into_iter().chain([[length, length]]) {
            if from.min(length) - start > SHORTEST_PIECE {
                pieces.push([start, from.min(length)]);
            }
            start = to.max(start);
        }
        pieces
    }

    fn gaps(&self, wall: &Wall) -> Vec<[f64; 2]> {
        let reach = wall.thickness.max(0.0) / 2.0 + TOLERANCE;
        let (lo, hi) = bounds(&wall.line);
        let around = AABB::from_corners([lo.x - reach, lo.y - reach], [hi.x + reach, hi.y + reach]);
        let near = self.0.locate_in_envelope_intersecting(&around);
        near.filter_map(|o| gap(&wall.line, &o.data, reach)).collect()
    }
}

/// The stretch that the opening takes of the line, if both its ends lie within `reach` of it.
fn gap(line: &Segment, opening: &Segment, reach: f64) -> Option<[f64; 2]> {
    let [(s, side), (t, other_side)] = [opening.a, opening.b].map(|p| along_and_beside(line, p));
    (side.abs() <= reach && other_side.abs() <= reach).then(|| [s.min(t), s.max(t)])
}

/// How far along the line the point lies, and how far to its left.
fn along_and_beside(line: &Segment, p: Point) -> (f64, f64) {
    let length = line.length();
    let (ux, uy) = ((line.b.x - line.a.x) / length, (line.b.y - line.a.y) / length);
    let (px, py) = (p.x - line.a.x, p.y - line.a.y);
    (px * ux + py * uy, ux * py - uy * px)
}

fn bounds(s: &Segment) -> (Point, Point) {
    (Point::new(s.a.x.min(s.b.x), s.a.y.min(s.b.y)), Point::new(s.a.x.max(s.b.x), s.a.y.max(s.b.y)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
        Segment::new(a.into(), b.into())
    }

    fn pieces(openings: &[Segment]) -> Vec<[f64; 2]> {
        let wall =
            Wall { line: segment([0.0, 0.0], [10.0, 0.0]), thickness: 0.2, weight: 1.0, rooms: [None, None] };
        Openings::new(openings.iter().copied()).pieces(&wall)
    }

    #[test]
    fn openings_are_cut_out_in_order() {
        let doors = [segment([7.0, 0.0], [6.0, 0.0]), segment([2.0, 0.01], [3.0, 0.0])];
        assert_eq!(pieces(&doors), [[0.0, 2.0], [3.0, 6.0], [7.0, 10.0]]);
    }

    #[test]
    fn overlapping_and_outlying_openings_are_one_cut() {
        let doors = [
            segment([-1.0, 0.0], [1.0, 0.0]),
            segment([0.5, 0.0], [4.0, 0.0]),
            segment([9.0, 0.0], [12.0, 0.0]),
        ];
        assert_eq!(pieces(&doors), [[4.0, 9.0]]);
    }

    #[test]
    fn openings_of_other_walls_are_left_alone() {
        let doors = [
            segment([2.0, 1.0], [3.0, 1.0]),
            segment([5.0, -0.5], [5.0, 0.5]),
            segment([20.0, 0.0], [21.0, 0.0]),
        ];
        assert_eq!(pieces(&doors), [[0.0, 10.0]]);
    }
}
