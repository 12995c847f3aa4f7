//! A traced ring split into nearly straight pieces: the method of Ramer, and of Douglas and Peucker (1973), and then
//! joined again where one line does for two pieces.

use super::Labelled;
use super::carrier::Carrier;
use super::trace::{Ring, beyond, corner_point};
use planform_sdk::Point;
use std::f64::consts::PI;

/// A ring's points in metres, and where on it each piece runs.
#[derive(Debug, Clone)]
pub struct Track {
    /// The ring, in cells.
    pub ring: Ring,
    /// One for each cell's side, metres.
    pub points: Vec<Point>,
    /// In the order of the ring.
    pub pieces: Vec<Piece>,
}

/// A nearly straight part of a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Index of its first point.
    pub from: usize,
    /// How many cells' sides it is long.
    pub sides: usize,
    /// The line it lies on.
    pub line: Carrier,
    /// The main direction that it is parallel to, if it is.
    pub bearing: Option<usize>,
}

impl Track {
    /// The pieces of a ring: no point is farther than the tolerance from its piece.
    pub fn of(ring: &Ring, resolution: f64, tolerance: f64) -> Self {
        let points: Vec<Point> = ring.iter().map(|&corner| corner_point(corner, resolution)).collect();
        let breaks = breaks(&points, tolerance);
        let mut track = Self { ring: ring.clone(), points, pieces: Vec::new() };
        let n = track.points.len();
        for (i, &from) in breaks.iter().enumerate() {
            let to = breaks[(i + 1) % breaks.len()];
            let piece = track.piece(from, (to + n - from - 1) % n + 1);
            track.pieces.push(piece);
        }
        track.join(tolerance);
        track
    }

    /// A point of the ring; the index may run around.
    pub fn at(&self, i: usize) -> Point {
        self.points[i % self.points.len()]
    }

    /// The point where a piece ends.
    pub fn end(&self, piece: &Piece) -> Point {
        self.at(piece.from + piece.sides)
    }

    /// Length of a piece from end to end, metres.
    pub fn length(&self, piece: &Piece) -> f64 {
        self.at(piece.from).distance(self.end(piece))
    }

    /// The room beyond most of a piece's sides.
    pub fn across(&self, piece: &Piece, label: &[u32], input: &Labelled<'_>) -> Option<usize> {
        let n = self.ring.len();
        let other = |i: usize| {
            let (c, r) = beyond(self.ring[i % n], self.ring[(i + 1) % n]);
            input.room(label, c, r)
        };
        let mut others: Vec<u32> =
            (piece.from..piece.from + piece.sides).map(other).filter(|&l| l > 0).collect();
        others.sort_unstable();
        let middle = *others.get(others.len() / 2)?;
        let most = others.iter().filter(|&&l| l == middle).count();
        (2 * most > piece.sides).then(|| middle as usize - 1)
    }

    /// The middles of a piece's sides.
    pub fn middles(&self, from: usize, sides: usize) -> impl Iterator<Item = Point> + Clone + '_ {
        (from..from + sides).map(|i| self.at(i).midpoint(self.at(i + 1)))
    }

    /// A piece with its own best line.
    fn piece(&self, from: usize, sides: usize) -> Piece {
        Piece { from, sides, line: self.fit(from, sides), bearing: None }
    }

    /// The line with the least squared distances from the sides' middles, through the median of their offsets: what
    /// stands along a wall does not move it.
    fn fit(&self, from: usize, sides: usize) -> Carrier {
        let (a, b) = (self.at(from), self.at(from + sides));
        let chord = (b.y - a.y).atan2(b.x - a.x);
        let angle = principal_angle(self.middles(from, sides));
        // The principal axis has no sense; the chord has.
        let turned = if (angle - chord).cos() < 0.0 { angle + PI } else { angle };
        let close = (turned - chord).cos() > 0.8;
        self.through_median(from, sides, if close { turned } else { chord })
    }

    /// The line of this angle through the median of the offsets of the sides' middles.
    pub fn through_median(&self, from: usize, sides: usize, angle: f64) -> Carrier {
        let base = Carrier::new(angle, 0.0);
        let mut offsets: Vec<f64> = self.middles(from, sides).map(|p| base.side(p)).collect();
        base.moved(super::super::walls::median(&mut offsets).unwrap_or(0.0))
    }

    /// Joins neighbours as long as one line within the tolerance does for both; the best pair of a round first.
    fn join(&mut self, tolerance: f64) {
        let mut i = 0;
        let mut kept = 0;
        while self.pieces.len() > 3 && kept < self.pieces.len() {
            let n = self.pieces.len();
            let (a, b) = (self.pieces[i % n], self.pieces[(i + 1) % n]);
            let both = self.piece(a.from, a.sides + b.sides);
            let straight = (b.line.angle - a.line.angle).cos() > 0.8;
            if straight && self.deviation(&both) <= 0.6 * tolerance {
                self.pieces[i % n] = both;
                self.pieces.remove((i + 1) % n);
                i = if (i + 1) % n == 0 { i - 1 } else { i } % (n - 1);
                kept = 0;
            } else {
                i = (i + 1) % n;
                kept += 1;
            }
        }
    }

    /// The largest distance of a piece's sides from its line.
    fn deviation(&self, piece: &Piece) -> f64 {
        self.middles(piece.from, piece.sides).map(|p| piece.line.side(p).abs()).fold(0.0, f64::max)
    }
}

/// The direction in which points spread most.
fn principal_angle(points: impl Iterator<Item = Point> + Clone) -> f64 {
    let (mut n, mut x, mut y) = (0.0, 0.0, 0.0);
    for p in points.clone() {
        (n, x, y) = (n + 1.0, x + p.x, y + p.y);
    }
    let (x, y) = (x / f64::max(n, 1.0), y / f64::max(n, 1.0));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for p in points {
        let (dx, dy) = (p.x - x, p.y - y);
        (xx, xy, yy) = (xx + dx * dx, xy + dx * dy, yy + dy * dy);
    }
    (2.0 * xy).atan2(xx - yy) / 2.0
}

/// The indices of the points where a ring bends, rising.
fn breaks(points: &[Point], tolerance: f64) -> Vec<usize> {
    let far = |from: Point| farthest(points.iter().map(|p| (p.x - from.x, p.y - from.y))).map(|f| f.0);
    let Some(first) = points.first().and_then(|&p| far(p)) else { return Vec::new() };
    let Some(second) = far(points[first]) else { return Vec::new() };
    let n = points.len();
    let mut found = vec![first, second];
    let mut open = vec![(first, (second + n - first) % n), (second, (first + n - second) % n)];
    while let Some((from, sides)) = open.pop() {
        if let Some(k) = bend(points, from, sides, tolerance) {
            found.push((from + k) % n);
            open.extend([(from, k), ((from + k) % n, sides - k)]);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// How many sides after `from` lies the point that is farthest from the chord, if it is beyond the tolerance.
fn bend(points: &[Point], from: usize, sides: usize, tolerance: f64) -> Option<usize> {
    let n = points.len();
    let (a, b) = (points[from], points[(from + sides) % n]);
    // The ring may go on at its begin.
    let (begin, end) = (from + 1, from + sides.max(1));
    let until = end.min(n);
    let between = points[begin.min(until)..until].iter().chain(&points[begin.max(n) - n..end.max(n) - n]);
    let (k, distance) = farthest(between.map(|&p| from_segment(p, a, b)))?;
    (distance > tolerance).then_some(k + 1)
}

/// The longest of some vectors, of equal ones the last, and its length.
fn farthest(vectors: impl Iterator<Item = (f64, f64)>) -> Option<(usize, f64)> {
    let mut best: Option<(usize, f64)> = None;
    // A root is drawn only of what may be as long.
    let mut least = 0.0;
    for (i, (x, y)) in vectors.enumerate() {
        if x * x + y * y < least {
            continue;
        }
        let length = x.hypot(y);
        if best.is_none_or(|b| length >= b.1) {
            best = Some((i, length));
            least = length * length * (1.0 - 1e-9);
        }
    }
    best
}

/// From the nearest point of a segment to a point.
fn from_segment(p: Point, a: Point, b: Point) -> (f64, f64) {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let square = dx * dx + dy * dy;
    let t = if square > 0.0 { ((p.x - a.x) * dx + (p.y - a.y) * dy) / square } else { 0.0 };
    let t = t.clamp(0.0, 1.0);
    (p.x - (a.x + t * dx), p.y - (a.y + t * dy))
}
