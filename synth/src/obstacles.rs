//! What a laser can hit: wall faces with their openings, panes, furniture; indexed for fast ray casts.

use crate::building::Building;
use crate::raster::band;
use planform_sdk::{Point, Polygon, RoomId, Segment, Wall};

/// Side of a bucket of the index, metres.
const BUCKET: f64 = 0.5;
/// Longer faces are cut, so that each piece lies in few buckets, metres.
const PIECE: f64 = 0.8;

/// A piece of an obstacle's outline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Face {
    pub(crate) segment: Segment,
    /// Whether rays may pass.
    pub(crate) glass: bool,
}

/// Gaps in the walls, beyond the layout's own openings.
pub(crate) struct Gaps<'a> {
    /// Indices of openings whose door is closed.
    pub(crate) closed: &'a [usize],
    /// Windows in outer walls with the wall's thickness.
    pub(crate) windows: &'a [(Segment, f64)],
}

/// All faces of a building.
pub(crate) struct Obstacles {
    faces: Vec<Face>,
    lo: Point,
    columns: usize,
    rows: usize,
    /// `items[starts[b]..starts[b + 1]]` are the faces that may touch bucket `b`.
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Obstacles {
    pub(crate) fn new(building: &Building, gaps: &Gaps, furniture: &[Polygon]) -> Self {
        let mut faces = wall_faces(building, gaps);
        for solid in building.solids().iter().chain(furniture) {
            let ring = &solid.exterior;
            faces.extend(ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| opaque(a, b)));
        }
        Self::index(faces.into_iter().flat_map(pieces).collect())
    }

    pub(crate) fn faces(&self) -> &[Face] {
        &self.faces
    }

    fn index(faces: Vec<Face>) -> Self {
        let ends = || faces.iter().flat_map(|f| [f.segment.a, f.segment.b]);
        let lo = ends().fold(Point::new(f64::MAX, f64::MAX), |m, p| Point::new(m.x.min(p.x), m.y.min(p.y)));
        let hi = ends().fold(lo, |m, p| Point::new(m.x.max(p.x), m.y.max(p.y)));
        let count = |from: f64, to: f64| ((to - from) / BUCKET).max(0.0) as usize + 1;
        let (columns, rows) = (count(lo.x, hi.x), count(lo.y, hi.y));
        let mut buckets: Vec<Vec<u32>> = vec![Vec::new(); columns * rows];
        for (i, face) in faces.iter().enumerate() {
            let (a, b) = (face.segment.a, face.segment.b);
            let span = |p: f64, q: f64, from: f64| {
                let cell = |v: f64| ((v - from) / BUCKET).max(0.0) as usize;
                cell(p.min(q) - 1e-9)..=cell(p.max(q) + 1e-9)
            };
            for row in span(a.y, b.y, lo.y).filter(|&r| r < rows) {
                for column in span(a.x, b.x, lo.x).filter(|&c| c < columns) {
                    buckets[row * columns + column].push(i as u32);
                }
            }
        }
        let mut starts = vec![0];
        for bucket in &buckets {
            starts.push(starts[starts.len() - 1] + bucket.len() as u32);
        }
        Self { faces, lo, columns, rows, starts, items: buckets.concat() }
    }

    /// Distance from `from` along the unit vector `(dx, dy)` to the nearest face within `reach` that does not let
    /// the ray pass; `passes` is asked at each pane.
    pub(crate) fn cast(
        &self,
        from: Point,
        (dx, dy): (f64, f64),
        reach: f64,
        mut passes: impl FnMut() -> bool,
    ) -> Option<f64> {
        let (x, y) = ((from.x - self.lo.x) / BUCKET, (from.y - self.lo.y) / BUCKET);
        let mut walk = Walk::new((x, y), (dx, dy));
        let (mut best, mut pane) = (f64::MAX, f64::MAX);
        loop {
            if let Some(bucket) = self.bucket(walk.cell) {
                for face in bucket.iter().map(|&i| &self.faces[i as usize]) {
                    let Some(d) = hit(&face.segment, from, (dx, dy)) else { continue };
                    let nearest = if face.glass { &mut pane } else { &mut best };
                    *nearest = nearest.min(d);
                }
            } else if walk.has_left(self.columns, self.rows, (dx, dy)) {
                break;
            }
            let end = walk.next() * BUCKET;
            if best <= end || end > reach {
                break;
            }
        }
        if pane < best && !passes() {
            best = pane;
        }
        (best <= reach).then_some(best)
    }

    fn bucket(&self, (column, row): (i64, i64)) -> Option<&[u32]> {
        let (column, row) = (usize::try_from(column).ok()?, usize::try_from(row).ok()?);
        if column >= self.columns || row >= self.rows {
            return None;
        }
        let b = row * self.columns + column;
        self.items.get(self.starts[b] as usize..self.starts[b + 1] as usize)
    }
}

/// Steps from cell to cell along a ray (Amanatides and Woo 1987). Lengths are in cells.
pub(crate) struct Walk {
    pub(crate) cell: (i64, i64),
    step: (i64, i64),
    next: (f64, f64),
    delta: (f64, f64),
}

impl Walk {
    pub(crate) fn new((x, y): (f64, f64), (dx, dy): (f64, f64)) -> Self {
        let axis = |p: f64, d: f64| {
            let cell = p.floor();
            if d > 0.0 {
                (1, (cell + 1.0 - p) / d, 1.0 / d)
            } else if d < 0.0 {
                (-1, (cell - p) / d, -1.0 / d)
            } else {
                (0, f64::INFINITY, f64::INFINITY)
            }
        };
        let ((sx, nx, ex), (sy, ny, ey)) = (axis(x, dx), axis(y, dy));
        Self { cell: (x.floor() as i64, y.floor() as i64), step: (sx, sy), next: (nx, ny), delta: (ex, ey) }
    }

    /// Goes to the next cell; returns how far along the ray that is.
    pub(crate) fn next(&mut self) -> f64 {
        if self.next.0 < self.next.1 {
            let at = self.next.0;
            self.cell.0 += self.step.0;
            self.next.0 += self.delta.0;
            at
        } else {
            let at = self.next.1;
            self.cell.1 += self.step.1;
            self.next.1 += self.delta.1;
            at
        }
    }

    /// Whether the ray is outside and will not come back.
    fn has_left(&self, columns: usize, rows: usize, (dx, dy): (f64, f64)) -> bool {
        let gone = |c: i64, d: f64, n: usize| (c < 0 && d <= 0.0) || (c >= n as i64 && d >= 0.0);
        gone(self.cell.0, dx, columns) || gone(self.cell.1, dy, rows)
    }
}

fn hit(s: &Segment, from: Point, (dx, dy): (f64, f64)) -> Option<f64> {
    let (ex, ey) = (s.b.x - s.a.x, s.b.y - s.a.y);
    let (ax, ay) = (s.a.x - from.x, s.a.y - from.y);
    let cross = dx * ey - dy * ex;
    if cross.abs() < 1e-12 {
        return None;
    }
    let (t, u) = ((ax * ey - ay * ex) / cross, (ax * dy - ay * dx) / cross);
    (t >= 0.0 && (-1e-9..=1.0 + 1e-9).contains(&u)).then_some(t)
}

fn opaque(a: Point, b: Point) -> Face {
    Face { segment: Segment::new(a, b), glass: false }
}

fn pieces(face: Face) -> impl Iterator<Item = Face> {
    let Segment { a, b } = face.segment;
    let n = (a.distance(b) / PIECE).ceil().clamp(1.0, 1e5) as u32;
    let at = move |i: u32| {
        let t = f64::from(i) / f64::from(n);
        Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t)
    };
    (0..n).map(move |i| Face { segment: Segment::new(at(i), at(i + 1)), ..face })
}

/// The faces of all walls, with gaps for openings and windows, the gaps' jambs, and what fills them.
fn wall_faces(building: &Building, gaps: &Gaps) -> Vec<Face> {
    let doors: Vec<(Segment, f64)> = building.openings().map(|(o, depth)| (o.segment, depth)).collect();
    let cuts: Vec<(Segment, f64)> = doors.iter().chain(gaps.windows).copied().collect();
    let mut faces = Vec::new();
    for room in &building.layout().rooms {
        for ring in room.inner.rings() {
            let sides = ring.iter().zip(ring.iter().cycle().skip(1));
            sides.for_each(|(&a, &b)| faces.extend(cut(Segment::new(a, b), &cuts)));
        }
    }
    for wall in building.layout().walls.iter().filter(|w| w.rooms.contains(&None)) {
        faces.extend(cut(outer_face(wall), &cuts));
    }
    for (segment, depth) in &cuts {
        let [a, b, c, d] = band(segment, depth / 2.0, 0.0);
        faces.extend([opaque(a, d), opaque(b, c)]);
    }
    let closed = gaps.closed.iter().filter_map(|&i| doors.get(i));
    faces.extend(closed.map(|(s, _)| Face { segment: *s, glass: false }));
    faces.extend(gaps.windows.iter().map(|(s, _)| Face { segment: *s, glass: true }));
    faces
}

/// The face of an outer wall that looks outside.
fn outer_face(wall: &Wall) -> Segment {
    let [a, b, c, d] = band(&wall.line, wall.thickness / 2.0, 0.0);
    let room: Option<RoomId> = wall.rooms[0];
    if room.is_some() { Segment::new(a, b) } else { Segment::new(d, c) }
}

/// What is left of a face beside the gaps that lie in its wall.
fn cut(face: Segment, gaps: &[(Segment, f64)]) -> Vec<Face> {
    let length = face.length();
    if length < 1e-9 {
        return Vec::new();
    }
    let (ux, uy) = ((face.b.x - face.a.x) / length, (face.b.y - face.a.y) / length);
    let mut spans: Vec<(f64, f64)> = Vec::new();
    for (gap, depth) in gaps {
        let place = |p: Point| {
            let (x, y) = (p.x - face.a.x, p.y - face.a.y);
            (x * ux + y * uy, (x * uy - y * ux).abs())
        };
        let ((s, across_a), (t, across_b)) = (place(gap.a), place(gap.b));
        let in_wall = [across_a, across_b].iter().all(|v| (v - depth / 2.0).abs() < 2e-3);
        if in_wall && s.max(t) > 0.0 && s.min(t) < length {
            spans.push((s.min(t), s.max(t)));
        }
    }
    spans.sort_by(|x, y| x.0.total_cmp(&y.0));
    remaining(length, &spans)
        .into_iter()
        .map(|(s, t)| {
            let at = |d: f64| Point::new(face.a.x + ux * d, face.a.y + uy * d);
            opaque(at(s), at(t))
        })
        .collect()
}

/// The parts of [0, length] outside the sorted spans.
fn remaining(length: f64, spans: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut left = Vec::new();
    let mut at = 0.0;
    for &(from, to) in spans {
        if from > at {
            left.push((at, from));
        }
        at = to.max(at);
    }
    if at < length {
        left.push((at, length));
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::two_rooms;

    fn open() -> Obstacles {
        Obstacles::new(&two_rooms(), &Gaps { closed: &[], windows: &[] }, &[])
    }

    fn range(obstacles: &Obstacles, from: [f64; 2], angle: f64) -> Option<f64> {
        obstacles.cast(from.into(), (angle.cos(), angle.sin()), 20.0, || true)
    }

    #[test]
    fn rays_end_at_wall_faces_and_go_through_doors() {
        let walls = open();
        let near = |found: Option<f64>, wanted: f64| (found.unwrap() - wanted).abs() < 1e-6;
        assert!(near(range(&walls, [1.0, 1.0], 0.0), 2.9), "wall between the rooms");
        assert!(near(range(&walls, [1.0, 2.5], 0.0), 6.9), "through the door");
        assert!(near(range(&walls, [4.0, 2.5], 1.5), 0.5 / 1.5f64.sin()), "the door's jamb");
        assert!(near(range(&walls, [1.0, 1.0], std::f64::consts::PI), 0.9));
    }

    #[test]
    fn a_closed_door_stops_rays() {
        let walls = Obstacles::new(&two_rooms(), &Gaps { closed: &[0], windows: &[] }, &[]);
        assert!((range(&walls, [1.0, 2.5], 0.0).unwrap() - 3.0).abs() < 1e-6);
    }

    #[test]
    fn a_window_lets_some_rays_out() {
        let pane = Segment::new(Point::new(0.0, 3.0), Point::new(0.0, 2.0));
        let walls = Obstacles::new(&two_rooms(), &Gaps { closed: &[], windows: &[(pane, 0.2)] }, &[]);
        assert_eq!(walls.cast(Point::new(1.0, 2.5), (-1.0, 0.0), 20.0, || true), None);
        assert_eq!(walls.cast(Point::new(1.0, 2.5), (-1.0, 0.0), 20.0, || false), Some(1.0));
    }

    #[test]
    fn no_ray_leaves_closed_walls() {
        let walls = open();
        for i in 0..720 {
            assert!(range(&walls, [1.3, 1.7], f64::from(i) * 0.00873).is_some(), "ray {i}");
        }
    }
}
