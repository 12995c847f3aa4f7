//! The roomiest place in a polygon: where a label fits best.

use planform_sdk::{Point, Polygon};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Most squares looked at in one polygon.
const MAX_STEPS: usize = 4000;

/// Share of the polygon's extent below which a better place is not worth the search.
const PRECISION: f64 = 0.005;

/// A place in a polygon: an ellipse about `centre` inside the polygon, `radius` high and `aspect` times as wide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// A point inside the polygon.
    pub centre: Point,
    /// Half the ellipse's height, metres.
    pub radius: f64,
}

/// The place for the largest box of this `aspect` (width by height), or `None` in a polygon without an inside.
///
/// Searches the pole of inaccessibility by halving squares, best first (the quadtree search known as polylabel,
/// Agafonkin 2016), in a frame in which the box is a square.
pub fn roomiest(polygon: &Polygon, aspect: f64) -> Option<Spot> {
    let squeeze = |ring: &Vec<Point>| ring.iter().map(|p| Point::new(p.x / aspect, p.y)).collect();
    let squeezed =
        Polygon { exterior: squeeze(&polygon.exterior), holes: polygon.holes.iter().map(squeeze).collect() };
    let seed = inside(&squeezed).map(|p| Square::new(p, 0.0, &squeezed))?;
    let best = search(&squeezed, seed);
    Some(Spot { centre: Point::new(best.centre.x * aspect, best.centre.y), radius: best.distance.max(0.0) })
}

fn search(polygon: &Polygon, seed: Square) -> Square {
    let whole = Square::around(polygon);
    let precision = whole.half * PRECISION;
    let mut best = seed;
    let mut open = BinaryHeap::from([whole]);
    for _ in 0..MAX_STEPS {
        let Some(square) = open.pop() else { break };
        if square.distance > best.distance {
            best = square;
        }
        if square.reach <= best.distance + precision {
            break;
        }
        open.extend(square.quarters(polygon));
    }
    best
}

/// A square of the search.
#[derive(Debug, Clone, Copy)]
struct Square {
    centre: Point,
    /// Half its side.
    half: f64,
    /// From the centre to the polygon's rings, negative outside.
    distance: f64,
    /// The most that `distance` can be anywhere in the square.
    reach: f64,
}

impl Square {
    fn new(centre: Point, half: f64, polygon: &Polygon) -> Self {
        let to_ring = polygon.rings().map(|r| distance_to_ring(centre, r)).fold(f64::INFINITY, f64::min);
        let distance = if polygon.contains(centre) { to_ring } else { -to_ring };
        Self { centre, half, distance, reach: distance + half * std::f64::consts::SQRT_2 }
    }

    fn around(polygon: &Polygon) -> Self {
        let points = || polygon.exterior.iter();
        let span = |values: &dyn Fn(&Point) -> f64| {
            points().map(values).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)))
        };
        let ((x0, x1), (y0, y1)) = (span(&|p| p.x), span(&|p| p.y));
        Self::new(Point::new(x0, y0).midpoint(Point::new(x1, y1)), (x1 - x0).max(y1 - y0) / 2.0, polygon)
    }

    fn quarters(&self, polygon: &Polygon) -> [Self; 4] {
        let (c, h) = (self.centre, self.half / 2.0);
        [(-h, -h), (h, -h), (-h, h), (h, h)]
            .map(|(dx, dy)| Self::new(Point::new(c.x + dx, c.y + dy), h, polygon))
    }
}

impl Ord for Square {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_place =
            || self.centre.x.total_cmp(&other.centre.x).then(self.centre.y.total_cmp(&other.centre.y));
        self.reach.total_cmp(&other.reach).then_with(by_place)
    }
}

impl PartialOrd for Square {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Square {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Square {}

fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

fn distance_to_ring(p: Point, ring: &[Point]) -> f64 {
    edges(ring).map(|(a, b)| distance_to_segment(p, a, b)).fold(f64::INFINITY, f64::min)
}

/// Distance from a point to the segment from `a` to `b`, metres.
pub fn distance_to_segment(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let squared = dx * dx + dy * dy;
    let along = if squared > 0.0 { ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    p.distance(Point::new(a.x + along * dx, a.y + along * dy))
}

/// A point inside: the middle of the widest stretch on a level between two corners, so that even a sliver has one.
fn inside(polygon: &Polygon) -> Option<Point> {
    let mut levels: Vec<f64> = polygon.exterior.iter().map(|p| p.y).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let gaps = levels.windows(2).filter_map(|w| Some((*w.first()?, *w.last()?)));
    let (low, high) = gaps.max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))?;
    let y = low + (high - low) / 2.0;
    let mut crossings: Vec<f64> = polygon.rings().flat_map(edges).filter_map(|e| crossing(e, y)).collect();
    crossings.sort_by(f64::total_cmp);
    let stretches = crossings.chunks_exact(2).filter_map(|c| Some((*c.first()?, *c.last()?)));
    let (left, right) = stretches.max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))?;
    Some(Point::new(left + (right - left) / 2.0, y))
}

fn crossing((a, b): (Point, Point), y: f64) -> Option<f64> {
    ((a.y > y) != (b.y > y)).then(|| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(exterior: &[[f64; 2]], hole: &[[f64; 2]]) -> Polygon {
        let ring = |points: &[[f64; 2]]| points.iter().copied().map(Point::from).collect::<Vec<_>>();
        Polygon::new(ring(exterior), if hole.is_empty() { vec![] } else { vec![ring(hole)] })
    }

    #[test]
    fn square_has_its_middle() {
        let p = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[]);
        let spot = roomiest(&p, 1.0).unwrap();
        assert!(spot.centre.distance(Point::new(2.0, 2.0)) < 0.1 && (spot.radius - 2.0).abs() < 0.05);
    }

    #[test]
    fn wide_label_goes_where_it_is_wide() {
        // A tall shaft 2 m wide beside a flat hall 8 m wide and 1.5 m high.
        let p = polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0, 1.5], [2.0, 1.5], [2.0, 9.0], [0.0, 9.0]], &[]);
        assert!(roomiest(&p, 6.0).unwrap().centre.x > 2.5);
        assert!(roomiest(&p, 0.5).unwrap().centre.x < 1.5);
    }

    #[test]
    fn hole_and_notch_are_outside() {
        let ring = polygon(
            &[[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]],
            &[[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]],
        );
        let u = polygon(
            &[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [8.0, 9.0], [8.0, 1.0], [1.0, 1.0], [1.0, 9.0], [0.0, 9.0]],
            &[],
        );
        for p in [ring, u] {
            let spot = roomiest(&p, 3.0).unwrap();
            assert!(p.contains(spot.centre) && spot.radius > 0.1, "{spot:?}");
        }
    }

    #[test]
    fn sliver_has_an_inside_and_nothing_has_none() {
        let sliver = polygon(&[[0.0, 0.0], [1000.0, 1000.0], [1000.0, 1000.001]], &[]);
        assert!(sliver.contains(roomiest(&sliver, 4.0).unwrap().centre));
        assert_eq!(roomiest(&polygon(&[], &[]), 1.0), None);
        assert_eq!(roomiest(&polygon(&[[0.0, 1.0], [5.0, 1.0], [9.0, 1.0]], &[]), 1.0), None);
    }
}
