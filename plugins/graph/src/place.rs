//! Points that stand for rooms.

use planform_sdk::{Point, Polygon};

/// On how many levels of a polygon its roomiest point is looked for.
const LEVELS: u32 = 40;

/// The centre of the area within a polygon; for one without an area the mean of its corners.
pub fn centroid(polygon: &Polygon) -> Point {
    let origin = polygon.exterior.first().copied().unwrap_or_default();
    let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
    for (a, b) in polygon.rings().flat_map(edges) {
        // Relative to a corner: far from the origin the products would lose digits.
        let (ax, ay, bx, by) = (a.x - origin.x, a.y - origin.y, b.x - origin.x, b.y - origin.y);
        let doubled = ax * by - bx * ay;
        area += doubled;
        x += (ax + bx) * doubled;
        y += (ay + by) * doubled;
    }
    let centre = Point::new(origin.x + x / (3.0 * area), origin.y + y / (3.0 * area));
    centre.finite().unwrap_or_else(|_| mean(&polygon.exterior))
}

fn mean(ring: &[Point]) -> Point {
    let count = ring.len().max(1) as f64;
    let sum = ring.iter().fold(Point::default(), |s, p| Point::new(s.x + p.x, s.y + p.y));
    Point::new(sum.x / count, sum.y / count)
}

/// A point on a floor with much room around it: the centroid if no other point has twice its distance to the walls.
pub fn representative(floor: &Polygon) -> Point {
    let centre = centroid(floor);
    let clear = |p: Point| if floor.contains(p) { clearance(floor, p) } else { 0.0 };
    let roomiest = stretches(floor).into_iter().map(|p| (clear(p), p)).max_by(|a, b| a.0.total_cmp(&b.0));
    match roomiest {
        Some((most, point)) if most > 2.0 * clear(centre) => point,
        _ => centre,
    }
}

/// Distance to the nearest wall, metres.
fn clearance(floor: &Polygon, p: Point) -> f64 {
    floor.rings().flat_map(edges).map(|(a, b)| to_segment(p, a, b)).fold(f64::INFINITY, f64::min)
}

/// The middles of the stretches of a floor on several levels.
fn stretches(floor: &Polygon) -> Vec<Point> {
    let heights = || floor.exterior.iter().map(|p| p.y);
    let (low, high) = (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
    let levels = (0..LEVELS).map(|i| low + (high - low) * (f64::from(i) + 0.5) / f64::from(LEVELS));
    levels.flat_map(|y| middles(floor, y)).collect()
}

fn middles(floor: &Polygon, y: f64) -> Vec<Point> {
    let across = floor.rings().flat_map(edges).filter(|(a, b)| (a.y > y) != (b.y > y));
    let mut crossings: Vec<f64> =
        across.map(|(a, b)| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y))).collect();
    crossings.sort_by(f64::total_cmp);
    crossings.chunks_exact(2).map(|pair| Point::new(pair.iter().sum::<f64>() / 2.0, y)).collect()
}

/// The sides of a ring.
pub fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

fn to_segment(p: Point, a: Point, b: Point) -> f64 {
    p.distance(nearest(p, a, b))
}

/// The point of the segment from `a` to `b` that is nearest to `p`.
pub fn nearest(p: Point, a: Point, b: Point) -> Point {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let squared = dx * dx + dy * dy;
    let along = if squared > 0.0 { ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    Point::new(a.x + along * dx, a.y + along * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[[f64; 2]]) -> Polygon {
        Polygon::new(points.iter().copied().map(Point::from).collect(), vec![])
    }

    #[test]
    fn a_square_is_stood_for_by_its_middle() {
        let square = polygon(&[[1e6, 1e6], [1e6 + 4.0, 1e6], [1e6 + 4.0, 1e6 + 4.0], [1e6, 1e6 + 4.0]]);
        let middle = Point::new(1e6 + 2.0, 1e6 + 2.0);
        assert!(centroid(&square).distance(middle) < 1e-6);
        assert!(representative(&square).distance(middle) < 1e-6);
    }

    #[test]
    fn a_corner_room_is_stood_for_by_a_point_inside() {
        let corner = polygon(&[[0., 0.], [10., 0.], [10., 2.], [2., 2.], [2., 10.], [0., 10.]]);
        assert!(!corner.contains(centroid(&corner)));
        let point = representative(&corner);
        assert!(corner.contains(point) && clearance(&corner, point) > 0.8, "{point:?}");
    }

    #[test]
    fn nothing_has_a_point_too() {
        assert_eq!(representative(&Polygon::default()), Point::default());
    }
}
