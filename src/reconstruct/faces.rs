//! The faces between the representative lines, and which of them share an edge.
//!
//! The area is a rectangle that one line after the other splits. On which side of a line a vertex lies is decided
//! once for each vertex and line, and a vertex nearer than [`TOUCH`] lies on it; an edge that a line crosses gets one
//! new vertex that both its faces share. So whatever the lines (near-parallel, coincident, many through one point),
//! the faces always tile the rectangle and share their vertices by number.

use super::lines::Line;
use super::raster::Mask;
use planform_sdk::{Point, Polygon, ring_signed_area};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::Range;

/// Which faces lie outside.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Faces {
    /// The threshold delta of the paper: a face with a smaller share of its area in the inner area is external.
    /// 0 to 1.
    pub inner_share: f64,
    /// How far beyond the inner area the lines are drawn. Metres.
    pub margin: f64,
    /// The most faces; a map with more is refused.
    pub max_count: usize,
}

impl Default for Faces {
    fn default() -> Self {
        Self { inner_share: 0.3, margin: 1.0, max_count: 500_000 }
    }
}

/// A vertex nearer to a line than this lies on it, metres.
const TOUCH: f64 = 1e-6;

/// Number of a vertex.
pub type VertexId = usize;

/// One side of a face, from its vertex to the next one's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// Where the side begins.
    pub from: VertexId,
    /// The line it lies on; none is the rectangle's border.
    pub line: Option<usize>,
}

/// A convex face: its sides, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The sides.
    pub sides: Vec<Side>,
}

/// The faces that lines make of a rectangle.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// The vertices, metres.
    pub vertices: Vec<Point>,
    /// The faces.
    pub faces: Vec<Face>,
}

/// An edge between two faces, or between a face and the outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its ends; the face `left` has them in this order.
    pub ends: [VertexId; 2],
    /// The face to its left.
    pub left: usize,
    /// The face to its right.
    pub right: Option<usize>,
    /// The line it lies on.
    pub line: Option<usize>,
}

impl Face {
    /// The sides as (begin, end, line).
    pub fn edges(&self) -> impl Iterator<Item = (VertexId, VertexId, Option<usize>)> + '_ {
        let n = self.sides.len();
        (0..n).map(move |i| (self.sides[i].from, self.sides[(i + 1) % n].from, self.sides[i].line))
    }
}

impl Arrangement {
    /// The rectangle between two corners, undivided.
    pub fn new(low: Point, high: Point) -> Self {
        let vertices = vec![low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)];
        let sides = (0..4).map(|from| Side { from, line: None }).collect();
        Self { vertices, faces: vec![Face { sides }] }
    }

    /// The rectangle split by all the lines; none if there are more than `most` faces.
    pub fn of_lines(low: Point, high: Point, lines: &[Line], most: usize) -> Option<Self> {
        let mut arrangement = Self::new(low, high);
        for (i, line) in lines.iter().enumerate() {
            arrangement.split(i, line, |_| true);
            if arrangement.faces.len() > most {
                return None;
            }
        }
        Some(arrangement)
    }

    /// Splits the faces of the selection with a line, which gets this number. A face keeps its number for its part
    /// to the left of the line; the parts to the right are new.
    pub fn split(&mut self, number: usize, line: &Line, selected: impl Fn(usize) -> bool) {
        let mut signs: Vec<i8> = self.vertices.iter().map(|&v| sign(line.side(v))).collect();
        let cuts = self.cut_edges(line, &mut signs, &selected);
        if !cuts.is_empty() {
            self.insert(&cuts);
        }
        for i in 0..self.faces.len() {
            if selected(i)
                && let Some((left, right)) = divide(&self.faces[i], &signs, number)
            {
                self.faces[i] = left;
                self.faces.push(right);
            }
        }
    }

    /// New vertices where the line crosses an edge of a selected face.
    fn cut_edges(
        &mut self,
        line: &Line,
        signs: &mut Vec<i8>,
        selected: &impl Fn(usize) -> bool,
    ) -> BTreeMap<[VertexId; 2], VertexId> {
        let mut cuts = BTreeMap::new();
        for (_, face) in self.faces.iter().enumerate().filter(|(i, _)| selected(*i)) {
            for (a, b, _) in face.edges() {
                if signs[a] * signs[b] >= 0 {
                    continue;
                }
                let key = [a.min(b), a.max(b)];
                cuts.entry(key).or_insert_with(|| {
                    self.vertices.push(crossing(line, self.vertices[key[0]], self.vertices[key[1]]));
                    signs.push(0);
                    self.vertices.len() - 1
                });
            }
        }
        cuts
    }

    /// Puts the new vertices into the sides of every face that has the edge.
    fn insert(&mut self, cuts: &BTreeMap<[VertexId; 2], VertexId>) {
        for face in &mut self.faces {
            let n = face.sides.len();
            let mut sides = Vec::with_capacity(n + 2);
            for i in 0..n {
                let (side, to) = (face.sides[i], face.sides[(i + 1) % n].from);
                sides.push(side);
                if let Some(&from) = cuts.get(&[side.from.min(to), side.from.max(to)]) {
                    sides.push(Side { from, line: side.line });
                }
            }
            face.sides = sides;
        }
    }

    /// All edges, ordered by their vertices.
    pub fn edges(&self) -> Vec<Edge> {
        let mut edges: BTreeMap<[VertexId; 2], Edge> = BTreeMap::new();
        for (i, face) in self.faces.iter().enumerate() {
            for (a, b, line) in face.edges() {
                edges.entry([a.min(b), a.max(b)]).and_modify(|e| e.right = Some(i)).or_insert(Edge {
                    ends: [a, b],
                    left: i,
                    right: None,
                    line,
                });
            }
        }
        edges.into_values().collect()
    }

    /// The outline of a face.
    pub fn ring(&self, face: usize) -> Vec<Point> {
        self.faces[face].sides.iter().map(|s| self.vertices[s.from]).collect()
    }

    /// The face as a polygon.
    pub fn polygon(&self, face: usize) -> Polygon {
        Polygon { exterior: self.ring(face), holes: Vec::new() }
    }
}

/// The external faces that lie within a wall between rooms: narrower than `width` on average, and bounded by faces of
/// the selection for four fifths of their outline. Two lines along the faces of one thick wall make such ones.
pub fn within_walls(
    arrangement: &Arrangement,
    edges: &[Edge],
    width: f64,
    member: impl Fn(usize) -> bool,
) -> Vec<usize> {
    let (mut outline, mut shared) = (vec![0.0; arrangement.faces.len()], vec![0.0; arrangement.faces.len()]);
    for edge in edges {
        let length = arrangement.vertices[edge.ends[0]].distance(arrangement.vertices[edge.ends[1]]);
        for (face, other) in [(Some(edge.left), edge.right), (edge.right, Some(edge.left))] {
            let Some(face) = face else { continue };
            outline[face] += length;
            shared[face] += if other.is_some_and(&member) { length } else { 0.0 };
        }
    }
    let narrow = |f: usize| 2.0 * ring_signed_area(&arrangement.ring(f)) < width * outline[f];
    (0..outline.len()).filter(|&f| !member(f) && narrow(f) && shared[f] >= 0.8 * outline[f]).collect()
}

/// For each face the share of its cells that the mask sets; a face that holds no cell's middle has 0.
pub fn shares(arrangement: &Arrangement, mask: &Mask, resolution: f64) -> Vec<f64> {
    let sums = RowSums::of(mask);
    (0..arrangement.faces.len()).map(|f| sums.share(&arrangement.ring(f), resolution)).collect()
}

/// The middles of the set cells in a convex ring, metres.
pub fn set_cells(ring: &[Point], mask: &Mask, resolution: f64) -> Vec<Point> {
    let middle = |v: i64| (v as f64 + 0.5) * resolution;
    let inside = rows(ring, resolution).filter(|(row, _)| (0..mask.height() as i64).contains(row));
    inside
        .flat_map(|(row, columns)| {
            let columns = columns.start.max(0)..columns.end.min(mask.width() as i64);
            columns.filter(move |&c| mask.get(c, row)).map(move |c| Point::new(middle(c), middle(row)))
        })
        .collect()
}

/// The cells whose middles lie in a convex ring: each row with its columns.
fn rows(ring: &[Point], resolution: f64) -> impl Iterator<Item = (i64, Range<i64>)> + '_ {
    let first = move |from: f64| (from / resolution - 0.5).ceil() as i64;
    let last = move |to: f64| (to / resolution - 0.5).floor() as i64;
    let (low, high) = ring.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p.y), h.max(p.y)));
    (first(low)..=last(high)).filter_map(move |row| {
        let (left, right) = span(ring, (row as f64 + 0.5) * resolution)?;
        Some((row, first(left)..last(right) + 1))
    })
}

/// For each row the number of set cells before each column.
struct RowSums {
    width: usize,
    height: usize,
    sums: Vec<u32>,
}

impl RowSums {
    fn of(mask: &Mask) -> Self {
        let (width, height) = (mask.width(), mask.height());
        let mut sums = Vec::with_capacity((width + 1) * height);
        for row in mask.bits().chunks(width) {
            let mut sum = 0;
            sums.push(0);
            for bit in row {
                sum += u32::from(*bit);
                sums.push(sum);
            }
        }
        Self { width, height, sums }
    }

    fn share(&self, ring: &[Point], resolution: f64) -> f64 {
        let (mut set, mut all) = (0.0, 0.0);
        for (row, columns) in rows(ring, resolution) {
            all += (columns.end - columns.start).max(0) as f64;
            set += f64::from(self.count(row, columns.start, columns.end));
        }
        if all > 0.0 { set / all } else { 0.0 }
    }

    /// Set cells of a row from one column up to before another.
    fn count(&self, row: i64, from: i64, to: i64) -> u32 {
        if !(0..self.height as i64).contains(&row) || to <= from {
            return 0;
        }
        let sum = |column: i64| {
            self.sums[row as usize * (self.width + 1) + column.clamp(0, self.width as i64) as usize]
        };
        sum(to) - sum(from)
    }
}

/// Where the horizontal line at `y` enters and leaves a convex ring.
fn span(ring: &[Point], y: f64) -> Option<(f64, f64)> {
    let mut span: Option<(f64, f64)> = None;
    for (i, a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        if (a.y > y) != (b.y > y) {
            let x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
            let (low, high) = span.unwrap_or((x, x));
            span = Some((low.min(x), high.max(x)));
        }
    }
    span
}

fn sign(side: f64) -> i8 {
    if side > TOUCH {
        1
    } else if side < -TOUCH {
        -1
    } else {
        0
    }
}

fn crossing(line: &Line, a: Point, b: Point) -> Point {
    let (da, db) = (line.side(a), line.side(b));
    let t = da / (da - db);
    Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
}

/// The parts of a face to the left and to the right of a line that runs through two of its vertices; `None` if the
/// line does not run through its inside.
fn divide(face: &Face, signs: &[i8], line: usize) -> Option<(Face, Face)> {
    let n = face.sides.len();
    let sign = |i: usize| signs[face.sides[i % n].from];
    // Where the left part begins: a vertex on the line, followed by one to the left.
    let mut starts = (0..n).filter(|&i| sign(i) == 0 && sign(i + 1) > 0);
    let mut ends = (0..n).filter(|&i| sign(i) == 0 && sign(i + 1) < 0);
    let (start, end) = (starts.next()?, ends.next()?);
    if starts.next().is_some() || ends.next().is_some() {
        return None;
    }
    let part = |from: usize, to: usize| {
        let count = (to + n - from) % n;
        let mut sides: Vec<Side> = (0..count).map(|k| face.sides[(from + k) % n]).collect();
        sides.push(Side { from: face.sides[to].from, line: Some(line) });
        Face { sides }
    };
    // Vertices on the line between the two parts, if there are any, stay with the left one.
    let left_end = (0..n).map(|k| (start + 1 + k) % n).find(|&i| sign(i) <= 0)?;
    let right_end = (0..n).map(|k| (end + 1 + k) % n).find(|&i| sign(i) >= 0)?;
    (left_end == end && right_end == start).then(|| (part(start, end), part(end, start)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn line(angle: f64, offset: f64) -> Line {
        Line { angle, offset, covered: Vec::new(), support: 1.0 }
    }

    fn square(lines: &[Line]) -> Arrangement {
        Arrangement::of_lines(Point::new(0.0, 0.0), Point::new(10.0, 10.0), lines, usize::MAX).unwrap()
    }

    fn check(a: &Arrangement) {
        let areas: Vec<f64> = (0..a.faces.len()).map(|f| ring_signed_area(&a.ring(f))).collect();
        let total: f64 = areas.iter().sum();
        assert!((total - 100.0).abs() < 1e-6, "the faces cover {total} of 100");
        assert!(areas.iter().all(|&area| area > 0.0));
        let border: f64 = a
            .edges()
            .iter()
            .filter(|e| e.right.is_none())
            .map(|e| a.vertices[e.ends[0]].distance(a.vertices[e.ends[1]]))
            .sum();
        assert!((border - 40.0).abs() < 1e-6, "the border is {border} of 40");
    }

    #[test]
    fn a_cross_makes_four_faces() {
        let a = square(&[line(0.0, 4.0), line(PI / 2.0, -6.0)]);
        assert_eq!(a.faces.len(), 4);
        assert_eq!(a.edges().iter().filter(|e| e.right.is_some()).count(), 4);
        check(&a);
    }

    #[test]
    fn coincident_and_concurrent_lines_are_survived() {
        let a = square(&[
            line(0.0, 5.0),
            line(0.0, 5.0),
            line(0.0, 5.0 + 1e-7),
            line(PI / 2.0, -5.0),
            line(PI / 4.0, 0.0),
        ]);
        assert_eq!(a.faces.len(), 6);
        check(&a);
    }

    #[test]
    fn a_fan_of_near_parallel_lines_is_survived() {
        let lines: Vec<Line> =
            (0..40).map(|i| line(1e-4 * f64::from(i), 5.0 + 1e-5 * f64::from(i))).collect();
        check(&square(&lines));
    }

    #[test]
    fn only_selected_faces_are_split() {
        let mut a = square(&[line(0.0, 5.0)]);
        a.split(1, &line(PI / 2.0, -5.0), |f| f == 0);
        assert_eq!(a.faces.len(), 3);
        check(&a);
    }

    #[test]
    fn a_strip_between_rooms_is_within_a_wall() {
        let a = square(&[line(0.0, 4.9), line(0.0, 5.1), line(0.0, 9.8)]);
        let at = |y: f64| (0..4).find(|&f| a.polygon(f).contains(Point::new(5.0, y))).unwrap();
        let rooms = [at(1.0), at(7.0)];
        assert_eq!(within_walls(&a, &a.edges(), 0.5, |f| rooms.contains(&f)), [at(5.0)]);
    }

    proptest::proptest! {
        #[test]
        fn faces_always_tile(lines in proptest::collection::vec((0.0..PI, -10.0..10.0f64), 0..25)) {
            let lines: Vec<Line> = lines.iter().map(|&(a, o)| line(a, o)).collect();
            check(&square(&lines));
        }

        #[test]
        fn faces_tile_for_rounded_lines(lines in proptest::collection::vec((0..8u8, 0..21u8), 0..25)) {
            let lines: Vec<Line> =
                lines.iter().map(|&(a, o)| line(PI / 8.0 * f64::from(a), f64::from(o) - 10.0)).collect();
            check(&square(&lines));
        }
    }
}
