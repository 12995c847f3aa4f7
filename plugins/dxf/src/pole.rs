//! The pole of inaccessibility: the point of a polygon farthest from its rings, after Agafonkin, "A new algorithm for
//! finding a visual center of a polygon" (2016).

use planform_sdk::{Point, Polygon};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The search ends when no cell could be better by this share of the polygon's smaller extent.
const PRECISION: f64 = 0.01;
/// The most squares looked at, however odd the polygon.
const MAX_CELLS: usize = 2000;
/// The most point-to-edge distances, so that a ring of very many points is not looked at too often.
const MAX_DISTANCES: usize = 20_000_000;

/// A point inside and its distance to the nearest ring, metres. `None` if no point lies inside.
pub fn pole(polygon: &Polygon) -> Option<(Point, f64)> {
    let mut best = Cell::new(polygon, scanline_point(polygon)?, 0.0);
    let (lo, hi) = extent(&polygon.exterior)?;
    let side = (hi.x - lo.x).min(hi.y - lo.y);
    let mut heap =
        BinaryHeap::from([Cell::new(polygon, lo.midpoint(hi), (hi.x - lo.x).max(hi.y - lo.y) / 2.0)]);
    for _ in 0..cell_limit(polygon) {
        let Some(cell) = heap.pop().filter(|c| c.most > best.distance + PRECISION * side) else { break };
        if cell.distance > best.distance {
            best = cell;
        }
        heap.extend(cell.quarters(polygon));
    }
    (best.distance > 0.0).then_some((best.middle, best.distance))
}

fn cell_limit(polygon: &Polygon) -> usize {
    let points: usize = polygon.rings().map(<[_]>::len).sum();
    MAX_CELLS.min(MAX_DISTANCES / points.max(1)).max(1)
}

/// A square of the search.
#[derive(Clone, Copy)]
struct Cell {
    middle: Point,
    /// Half its side.
    half: f64,
    /// Distance from its middle to the nearest ring, negative outside.
    distance: f64,
    /// The most distance that any of its points can have.
    most: f64,
}

impl Cell {
    fn new(polygon: &Polygon, middle: Point, half: f64) -> Self {
        let distance = signed_distance(polygon, middle);
        Self { middle, half, distance, most: distance + half * std::f64::consts::SQRT_2 }
    }

    fn quarters(self, polygon: &Polygon) -> [Self; 4] {
        let h = self.half / 2.0;
        [(-h, -h), (h, -h), (-h, h), (h, h)]
            .map(|(dx, dy)| Self::new(polygon, Point::new(self.middle.x + dx, self.middle.y + dy), h))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.most.total_cmp(&other.most)
    }
}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}

fn signed_distance(polygon: &Polygon, p: Point) -> f64 {
    let distance =
        polygon.rings().flat_map(edges).map(|(a, b)| distance_to(p, a, b)).fold(f64::MAX, f64::min);
    if polygon.contains(p) { distance } else { -distance }
}

fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

fn distance_to(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let squared = dx * dx + dy * dy;
    let t = if squared > 0.0 { ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared } else { 0.0 };
    let t = t.clamp(0.0, 1.0);
    p.distance(Point::new(a.x + t * dx, a.y + t * dy))
}

fn extent(ring: &[Point]) -> Option<(Point, Point)> {
    let &first = ring.first()?;
    Some(ring.iter().fold((first, first), |(lo, hi), p| {
        (Point::new(lo.x.min(p.x), lo.y.min(p.y)), Point::new(hi.x.max(p.x), hi.y.max(p.y)))
    }))
}

/// A point that lies inside for sure, however thin the polygon: the middle of the widest stretch inside, on the
/// horizontal line half way through the broadest gap between the heights of the corners.
fn scanline_point(polygon: &Polygon) -> Option<Point> {
    let mut heights: Vec<f64> = polygon.rings().flatten().map(|p| p.y).collect();
    heights.sort_by(f64::total_cmp);
    let gap = heights.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let y = f64::midpoint(gap[0], gap[1]);
    let mut crossings: Vec<f64> = polygon.rings().flat_map(edges).filter_map(|e| crossing(e, y)).collect();
    crossings.sort_by(f64::total_cmp);
    let widest = crossings.chunks_exact(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    Some(Point::new(f64::midpoint(widest[0], widest[1]), y))
}

fn crossing((a, b): (Point, Point), y: f64) -> Option<f64> {
    ((a.y > y) != (b.y > y)).then(|| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Point> {
        ring(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
    }

    #[test]
    fn pole_of_a_square_is_its_middle() {
        let (p, r) = pole(&Polygon::new(rectangle(0.0, 0.0, 4.0, 4.0), vec![])).unwrap();
        assert!(p.distance(Point::new(2.0, 2.0)) < 0.1 && (r - 2.0).abs() < 0.05, "{p:?} {r}");
    }

    #[test]
    fn pole_lies_in_the_broad_leg_of_an_l() {
        let l = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 1.0], [4.0, 1.0], [4.0, 5.0], [0.0, 5.0]]);
        let (p, r) = pole(&Polygon::new(l, vec![])).unwrap();
        assert!(p.x < 4.0 && r > 1.9, "{p:?} {r}");
    }

    #[test]
    fn pole_avoids_a_hole_in_the_middle() {
        let polygon = Polygon::new(rectangle(0.0, 0.0, 6.0, 6.0), vec![rectangle(2.0, 2.0, 4.0, 4.0)]);
        let (p, r) = pole(&polygon).unwrap();
        assert!(polygon.contains(p) && r > 0.9, "{p:?} {r}");
    }

    #[test]
    fn pole_of_a_sliver_lies_inside() {
        let sliver = Polygon::new(ring(&[[0.0, 0.0], [100.0, 100.0], [100.0, 100.001]]), vec![]);
        assert!(sliver.contains(pole(&sliver).unwrap().0));
    }

    #[test]
    fn a_flat_ring_has_no_pole() {
        assert!(pole(&Polygon::new(ring(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), vec![])).is_none());
        assert!(pole(&Polygon::default()).is_none());
    }
}
