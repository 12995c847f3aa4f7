//! A plan as a planar partition: rooms that share corners, and the straight runs of wall between two of them.

use crate::shape::Shape;
use planform_sdk::Point;
use std::collections::BTreeMap;

/// Points nearer than this are one corner, metres.
const SAME: f64 = 1e-4;

/// Undirected edge between two corners, the smaller index first.
pub(crate) type Edge = (usize, usize);

/// A straight stretch of wall with the same room on each side all along.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    /// Its corners, in the direction in which `left` is to the left.
    pub(crate) corners: Vec<usize>,
    pub(crate) left: usize,
    /// `None` is outside.
    pub(crate) right: Option<usize>,
}

impl Run {
    pub(crate) fn edges(&self) -> impl Iterator<Item = Edge> {
        self.corners.windows(2).map(|w| edge(w[0], w[1]))
    }

    pub(crate) fn ends(&self) -> [usize; 2] {
        [self.corners[0], self.corners[self.corners.len() - 1]]
    }
}

/// Rooms that share corners and edges exactly.
pub(crate) struct Partition {
    pub(crate) points: Vec<Point>,
    /// For each room its rings of corners; a corner of a neighbour on its wall is a corner of its own.
    pub(crate) rooms: Vec<Vec<Vec<usize>>>,
    /// Every wall once; between two rooms `left` is the smaller index.
    pub(crate) runs: Vec<Run>,
}

/// The same key for both directions.
pub(crate) fn edge(a: usize, b: usize) -> Edge {
    (a.min(b), a.max(b))
}

impl Partition {
    /// Joins shapes whose corners and sides meet. `None` if two of them claim the same side of an edge.
    pub(crate) fn new(shapes: &[Shape]) -> Option<Self> {
        let mut points = Vec::new();
        let mut rooms: Vec<Vec<Vec<usize>>> = Vec::new();
        for shape in shapes {
            let rings = shape.rings.iter().map(|r| r.iter().map(|&p| corner(&mut points, p)).collect());
            rooms.push(rings.collect());
        }
        for ring in rooms.iter_mut().flatten() {
            *ring = with_corners_between(&points, ring);
        }
        let sides = sides(&rooms)?;
        let runs = runs(&points, &rooms, &sides);
        Some(Self { points, rooms, runs })
    }

    pub(crate) fn length(&self, run: &Run) -> f64 {
        let [a, b] = run.ends();
        self.points[a].distance(self.points[b])
    }
}

fn corner(points: &mut Vec<Point>, p: Point) -> usize {
    if let Some(i) = points.iter().position(|q| q.distance(p) < SAME) {
        return i;
    }
    points.push(p);
    points.len() - 1
}

/// The ring with every corner that lies on one of its edges put in between.
fn with_corners_between(points: &[Point], ring: &[usize]) -> Vec<usize> {
    let mut out = Vec::with_capacity(ring.len());
    for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
        out.push(a);
        let mut between: Vec<(f64, usize)> = (0..points.len())
            .filter(|&i| i != a && i != b)
            .filter_map(|i| position_on(points[a], points[b], points[i]).map(|t| (t, i)))
            .collect();
        between.sort_by(|x, y| x.0.total_cmp(&y.0));
        out.extend(between.into_iter().map(|(_, i)| i));
    }
    out
}

/// Where between `a` and `b` the point lies, metres from `a`; `None` when it is off the segment.
fn position_on(a: Point, b: Point, p: Point) -> Option<f64> {
    let length = a.distance(b);
    let (ux, uy) = ((b.x - a.x) / length, (b.y - a.y) / length);
    let (x, y) = (p.x - a.x, p.y - a.y);
    let (along, across) = (x * ux + y * uy, x * uy - y * ux);
    (across.abs() < SAME && along > SAME && along < length - SAME).then_some(along)
}

/// The room to the left of each directed edge.
type Sides = BTreeMap<(usize, usize), usize>;

fn sides(rooms: &[Vec<Vec<usize>>]) -> Option<Sides> {
    let mut sides = Sides::new();
    for (room, rings) in rooms.iter().enumerate() {
        for ring in rings {
            for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                if sides.insert((a, b), room).is_some() {
                    return None;
                }
            }
        }
    }
    Some(sides)
}

fn runs(points: &[Point], rooms: &[Vec<Vec<usize>>], sides: &Sides) -> Vec<Run> {
    let mut runs = Vec::new();
    for (room, rings) in rooms.iter().enumerate() {
        for ring in rings {
            let of_ring = ring_runs(points, ring, room, sides);
            runs.extend(of_ring.into_iter().filter(|r| r.right.is_none_or(|other| other > room)));
        }
    }
    runs
}

fn ring_runs(points: &[Point], ring: &[usize], left: usize, sides: &Sides) -> Vec<Run> {
    let n = ring.len();
    let at = |i: usize| ring[i % n];
    let right = |i: usize| sides.get(&(at(i + 1), at(i))).copied();
    let breaks = |i: usize| {
        right(i + n - 1) != right(i) || !is_straight(points[at(i + n - 1)], points[at(i)], points[at(i + 1)])
    };
    let Some(start) = (0..n).find(|&i| breaks(i)) else { return Vec::new() };
    let mut runs: Vec<Run> = Vec::new();
    for i in start..start + n {
        match runs.last_mut() {
            Some(run) if !breaks(i) => run.corners.push(at(i + 1)),
            _ => runs.push(Run { corners: vec![at(i), at(i + 1)], left, right: right(i) }),
        }
    }
    runs
}

/// Whether the way from `a` over `b` to `c` does not turn.
pub(crate) fn is_straight(a: Point, b: Point, c: Point) -> bool {
    let (ux, uy, vx, vy) = (b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y);
    let cross = ux * vy - uy * vx;
    cross.abs() < 2e-3 * a.distance(b) * b.distance(c) && ux * vx + uy * vy > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::RoomKind;

    fn rect(x0: f64, y0: f64, x1: f64, y1: f64) -> Shape {
        let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Point::from).to_vec();
        Shape { rings: vec![ring], kind: RoomKind::Room, access: None }
    }

    #[test]
    fn neighbours_get_each_others_corners() {
        let shapes = [rect(0.0, 0.0, 9.0, 2.0), rect(0.0, 2.0, 4.0, 5.0), rect(4.0, 2.0, 9.0, 5.0)];
        let partition = Partition::new(&shapes).unwrap();
        assert_eq!(partition.rooms[0][0].len(), 5);
        let inner: Vec<_> = partition.runs.iter().filter_map(|r| r.right.map(|s| (r.left, s))).collect();
        assert_eq!(inner, [(0, 2), (0, 1), (1, 2)]);
        let outer: f64 =
            partition.runs.iter().filter(|r| r.right.is_none()).map(|r| partition.length(r)).sum();
        assert!((outer - 28.0).abs() < 1e-9, "{outer}");
    }

    #[test]
    fn overlapping_rooms_are_refused() {
        assert!(Partition::new(&[rect(0.0, 0.0, 2.0, 2.0), rect(0.0, 0.0, 3.0, 2.0)]).is_none());
    }
}
