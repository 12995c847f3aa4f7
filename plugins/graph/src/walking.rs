//! How far it is from one point of a room to another.
//!
//! Shortest ways among obstacles run from corner to corner (Lozano-Pérez and Wesley, "An algorithm for planning
//! collision-free paths among polyhedral obstacles", 1979), of which only those count that point into the floor.
//! Dijkstra's algorithm finds them in the graph of the corners that see each other.

use crate::place::{edges, nearest};
use planform_sdk::{Point, Polygon};

/// How far from a corner one walks around it, metres.
const CLEARANCE: f64 = 0.001;

/// The most corners to walk around in one room. In a room with more, the smallest are cut off.
const MOST_CORNERS: usize = 300;

/// The floor of a room, to walk on.
pub struct Floor {
    polygon: Polygon,
    /// Beside each corner that points into the floor.
    corners: Vec<Point>,
    /// For each pair of corners the distance between them if they see each other.
    between: Vec<f64>,
}

impl Floor {
    /// The floor within these outlines.
    pub fn new(polygon: &Polygon) -> Self {
        let mut polygon = polygon.clone();
        let mut corners = corners(&polygon);
        let mut detail = CLEARANCE;
        while corners.len() > MOST_CORNERS {
            polygon = without_detail(&polygon, detail);
            corners = self::corners(&polygon);
            detail *= 2.0;
        }
        let mut floor = Self { polygon, corners, between: vec![] };
        let corners = &floor.corners;
        let pairs = corners.iter().flat_map(|&a| corners.iter().map(move |&b| (a, b)));
        floor.between = pairs.map(|(a, b)| floor.straight(a, b)).collect();
        floor
    }

    /// The lengths of the shortest ways from one point of the floor to these others, metres.
    ///
    /// A point that no way leads to, in a niche narrower than can be walked in, is as far as the crow flies.
    pub fn distances(&self, from: Point, to: &[Point]) -> Vec<f64> {
        let reached = self.to_corners(from);
        let around = |to: Point| {
            let ways = reached.iter().zip(&self.corners).filter(|(far, _)| far.is_finite());
            ways.map(|(far, &corner)| far + self.straight(corner, to)).fold(f64::INFINITY, f64::min)
        };
        let distance = |&to: &Point| {
            let far = self.straight(from, to).min(around(to));
            if far.is_finite() { far } else { from.distance(to) }
        };
        to.iter().map(distance).collect()
    }

    /// How far it is to every corner, by Dijkstra's algorithm.
    fn to_corners(&self, from: Point) -> Vec<f64> {
        let count = self.corners.len();
        let mut far: Vec<f64> = self.corners.iter().map(|&c| self.straight(from, c)).collect();
        let mut done = vec![false; count];
        loop {
            let open = (0..count).filter(|&i| !done[i] && far[i].is_finite());
            let Some(next) = open.min_by(|&a, &b| far[a].total_cmp(&far[b])) else { return far };
            done[next] = true;
            for other in 0..count {
                far[other] = far[other].min(far[next] + self.between[next * count + other]);
            }
        }
    }

    /// The distance between two points of the floor that see each other; infinite for others.
    fn straight(&self, a: Point, b: Point) -> f64 {
        let blocked = self.polygon.rings().flat_map(edges).any(|edge| meet((a, b), edge));
        if blocked { f64::INFINITY } else { a.distance(b) }
    }
}

/// The point of a floor where somebody comes to stand who enters it from here, a little inside of it.
pub fn entry(floor: &Polygon, from: Point) -> Point {
    if floor.contains(from) {
        return from;
    }
    let on_rings = floor.rings().flat_map(edges).map(|(a, b)| nearest(from, a, b));
    let foot = on_rings.min_by(|a, b| from.distance(*a).total_cmp(&from.distance(*b))).unwrap_or(from);
    let step = CLEARANCE / from.distance(foot).max(CLEARANCE);
    Point::new(foot.x + (foot.x - from.x) * step, foot.y + (foot.y - from.y) * step)
}

/// A little inside of each corner of the outline that points into the floor. The floor is to the left of all rings.
fn corners(polygon: &Polygon) -> Vec<Point> {
    let of_ring = |ring: &[Point]| {
        let count = ring.len();
        let corner = |i: usize| inside_of(ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]);
        (0..count).filter_map(corner).filter(|&p| polygon.contains(p)).collect::<Vec<_>>()
    };
    polygon.rings().flat_map(of_ring).collect()
}

/// Beside the corner between two edges, if the way turns right there.
fn inside_of(before: Point, corner: Point, after: Point) -> Option<Point> {
    if turn(before, corner, after) >= 0.0 {
        return None;
    }
    let normal = |a: Point, b: Point| {
        let length = a.distance(b);
        Point::new((a.y - b.y) / length, (b.x - a.x) / length)
    };
    let (m, n) = (normal(before, corner), normal(corner, after));
    let (x, y) = (m.x + n.x, m.y + n.y);
    let length = x.hypot(y);
    let inside = Point::new(corner.x + CLEARANCE * x / length, corner.y + CLEARANCE * y / length);
    inside.finite().ok()
}

/// The outline without corners that stand out from their neighbours by less than `detail` metres.
fn without_detail(polygon: &Polygon, detail: f64) -> Polygon {
    let ring = |ring: &[Point]| {
        let mut kept: Vec<Point> = vec![];
        for (i, &p) in ring.iter().enumerate() {
            let (before, after) = (kept.last().copied(), ring[(i + 1) % ring.len()]);
            if before.is_none_or(|before| p.distance(nearest(p, before, after)) >= detail) {
                kept.push(p);
            }
        }
        kept
    };
    let holes = polygon.holes.iter().map(|h| ring(h)).filter(|h| h.len() >= 3).collect();
    Polygon { exterior: ring(&polygon.exterior), holes }
}

/// Whether two segments have a point in common.
fn meet((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let apart = |p: f64, q: f64, r: f64, s: f64| p.max(q) < r.min(s) || r.max(s) < p.min(q);
    if apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y) {
        return false;
    }
    turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}

/// Positive if the way from `a` over `b` to `c` turns left.
fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    fn distance(floor: &Floor, from: [f64; 2], to: [f64; 2]) -> f64 {
        floor.distances(from.into(), &[to.into()])[0]
    }

    #[test]
    fn the_way_leads_around_the_corner() {
        let corner = ring(&[[0., 0.], [10., 0.], [10., 2.], [2., 2.], [2., 10.], [0., 10.]]);
        let floor = Floor::new(&Polygon::new(corner, vec![]));
        assert!((distance(&floor, [1.0, 1.0], [9.0, 1.0]) - 8.0).abs() < 1e-9);
        let around = 2.0 * 1.0_f64.hypot(7.0);
        assert!((distance(&floor, [9.0, 1.0], [1.0, 9.0]) - around).abs() < 0.01);
    }

    #[test]
    fn the_way_leads_around_a_pillar() {
        let room = ring(&[[0., 0.], [6., 0.], [6., 4.], [0., 4.]]);
        let pillar = ring(&[[2., 1.], [4., 1.], [4., 3.], [2., 3.]]);
        let floor = Floor::new(&Polygon::new(room, vec![pillar]));
        let around = 2.0 + 2.0 * 1.0_f64.hypot(1.0);
        assert!((distance(&floor, [1.0, 2.0], [5.0, 2.0]) - around).abs() < 0.01);
    }

    #[test]
    fn who_enters_stands_on_the_floor() {
        let floor = Polygon::new(ring(&[[0., 0.], [4., 0.], [4., 4.], [0., 4.]]), vec![]);
        let entry = entry(&floor, Point::new(2.0, -0.1));
        assert!(floor.contains(entry) && entry.distance(Point::new(2.0, 0.0)) < 0.002);
    }

    #[test]
    fn a_comb_of_very_many_teeth_is_walked_past() {
        let teeth = (0..2000).flat_map(|i| {
            let x = f64::from(i) * 0.004;
            [[x, 0.002], [x + 0.002, 0.0]]
        });
        let comb: Vec<[f64; 2]> = teeth.chain([[8.0, 3.0], [0.0, 3.0]]).collect();
        let floor = Floor::new(&Polygon::new(ring(&comb), vec![]));
        assert!(floor.corners.len() <= MOST_CORNERS);
        assert!((distance(&floor, [0.5, 1.0], [7.5, 1.0]) - 7.0).abs() < 1e-6);
    }
}
