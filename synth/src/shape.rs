//! Rooms as rings in metres: traced from the lattice, their outer corners cut and their outer walls bent.

use crate::draft::Draft;
use crate::lattice::{LatticeRing, Rect, metres};
use crate::params::{BuildingParams, RoomKind};
use crate::rng::Rng;
use planform_sdk::Point;
use std::f64::consts::PI;

/// One room of a plan, along the centre lines of its walls.
#[derive(Debug, Clone)]
pub(crate) struct Shape {
    /// The exterior counter-clockwise, then the holes clockwise.
    pub(crate) rings: Vec<Vec<Point>>,
    pub(crate) kind: RoomKind,
    /// The room through which alone it shall be reached.
    pub(crate) access: Option<usize>,
}

impl Shape {
    /// The same shape with every point moved by `f`; `mirrored` when `f` turns left into right.
    pub(crate) fn map(&mut self, mirrored: bool, f: impl Fn(Point) -> Point) {
        for ring in &mut self.rings {
            for p in ring.iter_mut() {
                *p = f(*p);
            }
            if mirrored {
                ring.reverse();
            }
        }
    }
}

/// The rooms of a draft, some of their outer corners cut and some outer walls round.
pub(crate) fn trace(draft: &Draft, params: &BuildingParams, rng: &mut Rng) -> Vec<Shape> {
    let mut shapes = Vec::with_capacity(draft.rooms.len());
    for (i, room) in draft.rooms.iter().enumerate() {
        let rings = draft.lattice.trace(room.frame, i as u16 + 1);
        let plain = room.kind == RoomKind::Corridor || rings.len() > 1;
        let rings = rings.iter().map(|ring| {
            if plain { ring.iter().copied().map(metres).collect() } else { bend(draft, ring, params, rng) }
        });
        shapes.push(Shape { rings: rings.collect(), kind: room.kind, access: room.access });
    }
    shapes
}

/// What becomes of one corner and of the side that follows it.
#[derive(Clone, Copy, PartialEq)]
enum Corner {
    Plain,
    /// Cut off, this far back along the side before and the side after, metres.
    Cut(f64, f64),
}

fn bend(draft: &Draft, ring: &LatticeRing, params: &BuildingParams, rng: &mut Rng) -> Vec<Point> {
    let n = ring.len();
    let at = |i: usize| ring[i % n];
    let corners: Vec<Corner> =
        (0..n).map(|i| corner(draft, [at(i + n - 1), at(i), at(i + 1)], params, rng)).collect();
    let mut points = Vec::new();
    for i in 0..n {
        let (before, here, after) = (metres(at(i + n - 1)), metres(at(i)), metres(at(i + 1)));
        match corners[i] {
            Corner::Plain => points.push(here),
            Corner::Cut(a, b) => points.extend([towards(here, before, a), towards(here, after, b)]),
        }
        let plain = corners[i] == Corner::Plain && corners[(i + 1) % n] == Corner::Plain;
        if plain && rng.chance(params.bays) {
            points.extend(bay(draft, at(i), at(i + 1), rng));
        }
    }
    points
}

fn towards(from: Point, to: Point, distance: f64) -> Point {
    let t = distance / from.distance(to);
    Point::new(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t)
}

/// Cuts a convex corner of the building at times, when both its sides are outer walls and long enough.
fn corner(draft: &Draft, [a, b, c]: [(i32, i32); 3], params: &BuildingParams, rng: &mut Rng) -> Corner {
    let cross = (b.0 - a.0) * (c.1 - b.1) - (b.1 - a.1) * (c.0 - b.0);
    let sides = [length(a, b), length(b, c)];
    let outer = || is_open(draft, a, b, 15) && is_open(draft, b, c, 15) && is_alone(draft, b);
    if cross <= 0 || sides.iter().any(|&l| l < 32) || !rng.chance(params.chamfers) || !outer() {
        return Corner::Plain;
    }
    let [first, second] = sides.map(|l| rng.range((0.9, f64::from(l) * 0.055)));
    Corner::Cut(first, second)
}

fn length(a: (i32, i32), b: (i32, i32)) -> i32 {
    (a.0 - b.0).abs() + (a.1 - b.1).abs()
}

/// Whether only one of the four cells around the corner is painted.
fn is_alone(draft: &Draft, (x, y): (i32, i32)) -> bool {
    let around = [(x - 1, y - 1), (x, y - 1), (x - 1, y), (x, y)];
    around.iter().filter(|&&(x, y)| draft.lattice.label(x, y) != 0).count() == 1
}

/// Whether `depth` cells to the right of the side from `a` to `b` are empty.
fn is_open(draft: &Draft, a: (i32, i32), b: (i32, i32), depth: i32) -> bool {
    let (dx, dy) = ((b.0 - a.0).signum(), (b.1 - a.1).signum());
    let (ox, oy) = (dy * depth, -dx * depth);
    let (xs, ys) = ([a.0, b.0, a.0 + ox, b.0 + ox], [a.1, b.1, a.1 + oy, b.1 + oy]);
    let low = |v: [i32; 4]| v.into_iter().fold(i32::MAX, i32::min);
    let high = |v: [i32; 4]| v.into_iter().fold(i32::MIN, i32::max);
    draft.lattice.is_empty(Rect::new(low(xs), low(ys), high(xs), high(ys)))
}

/// The points of a round bay on an outer side, from its foot to its other foot; none when there is no place.
fn bay(draft: &Draft, a: (i32, i32), b: (i32, i32), rng: &mut Rng) -> Vec<Point> {
    let side = f64::from(length(a, b)) / 10.0;
    let chord = rng.range((0.5, 0.8)) * side.min(9.0);
    let sagitta = chord * rng.range((0.2, 0.5));
    if side < 4.0 || !is_open(draft, a, b, (sagitta * 10.0) as i32 + 12) {
        return Vec::new();
    }
    let (p, q) = (metres(a), metres(b));
    let foot = rng.range((0.5, (side - chord - 0.5).max(0.5)));
    let (start, end) = (towards(p, q, foot), towards(p, q, foot + chord));
    arc(start, end, sagitta)
}

/// Points on a circular arc from `a` to `b` that bulges to the right by `sagitta`, both ends included.
fn arc(a: Point, b: Point, sagitta: f64) -> Vec<Point> {
    let chord = a.distance(b);
    let radius = (chord * chord / 4.0 + sagitta * sagitta) / (2.0 * sagitta);
    let half = (chord / (2.0 * radius)).clamp(-1.0, 1.0).asin();
    let half = if sagitta > radius { PI - half } else { half };
    let steps = (2.0 * half * radius / 0.35).ceil().max(6.0) as usize;
    let (ux, uy) = ((b.x - a.x) / chord, (b.y - a.y) / chord);
    let point = |i: usize| {
        let angle = -half + 2.0 * half * i as f64 / steps as f64;
        let (along, out) = (chord / 2.0 + radius * angle.sin(), radius * angle.cos() - (radius - sagitta));
        Point::new(a.x + ux * along + uy * out, a.y + uy * along - ux * out)
    };
    let inner = (1..steps).map(point);
    std::iter::once(a).chain(inner).chain([b]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_bulges_to_the_right_by_its_sagitta() {
        let points = arc(Point::new(0.0, 0.0), Point::new(4.0, 0.0), 1.0);
        let lowest = points.iter().map(|p| p.y).fold(f64::MAX, f64::min);
        assert!((lowest + 1.0).abs() < 0.01, "{lowest}");
        assert!(points.iter().all(|p| p.y <= 1e-9));
        assert_eq!(points[0], Point::new(0.0, 0.0));
    }

    #[test]
    fn every_corner_of_a_lone_room_can_be_cut() {
        let mut draft = Draft::new(200, 200);
        draft.add(Rect::new(50, 50, 120, 110), RoomKind::Room).unwrap();
        let params = BuildingParams { chamfers: 1.0, bays: 0.0, ..BuildingParams::default() };
        let shapes = trace(&draft, &params, &mut Rng::new(1, 0));
        assert_eq!(shapes[0].rings[0].len(), 8);
    }

    #[test]
    fn a_long_outer_side_can_be_round() {
        let mut draft = Draft::new(300, 300);
        draft.add(Rect::new(100, 100, 180, 180), RoomKind::Room).unwrap();
        let params = BuildingParams { chamfers: 0.0, bays: 1.0, ..BuildingParams::default() };
        let shapes = trace(&draft, &params, &mut Rng::new(1, 0));
        assert!(shapes[0].rings[0].len() > 4 * 6);
        assert!(planform_sdk::ring_signed_area(&shapes[0].rings[0]) > 64.0);
    }
}
