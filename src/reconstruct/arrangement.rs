//! The faces that the representative lines make of a rectangle.
//!
//! One line after the other splits the rectangle. On which side of a line a vertex lies is decided once for each vertex
//! and line, and a vertex nearer than [`TOUCH`] lies on it; an edge that a line crosses gets one new vertex that both its
//! faces share. So whatever the lines (near-parallel, coincident, many through one point), the faces always tile the
//! rectangle and share their vertices by number.
//!
//! The faces are kept as half-edges (Muller and Preparata, "Finding the intersection of two convex polyhedra", 1978). A
//! line is followed from the border through the faces that it meets, and no others are looked at: by the zone theorem
//! (Chazelle, Guibas and Lee, "The power of geometric duality", 1985) the work of all lines grows as the faces do.

use super::lines::Line;
use planform_sdk::{Point, Polygon};

/// A vertex nearer to a line than this lies on it, metres.
const TOUCH: f64 = 1e-6;

/// Number of a vertex.
pub type VertexId = usize;

/// The line of a side that lies on the rectangle's border, and the face beyond it.
const NONE: u32 = u32::MAX;

/// One side of a face; its twin, the same side of the face beyond, has the number that differs in the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Half {
    /// The vertex where it begins.
    from: u32,
    /// The sides of the same face after it and before it, counter-clockwise.
    next: u32,
    before: u32,
    /// The face to its left.
    face: u32,
    line: u32,
}

/// The faces that lines make of a rectangle.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    /// The vertices, metres.
    pub vertices: Vec<Point>,
    halves: Vec<Half>,
    /// The first side of each face.
    first: Vec<u32>,
    /// A side of the outside.
    outer: u32,
    marks: Marks,
}

/// What is known of vertices and faces for the line that is at work: marked with its turn, so that nothing has to be
/// cleared.
#[derive(Debug, Clone, Default)]
struct Marks {
    turn: u32,
    signs: Vec<(u32, i8)>,
    faces: Vec<u32>,
}

/// What was marked on the way does not make two arrangements different.
impl PartialEq for Marks {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// An edge between two faces, or between a face and the outside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Its ends; the face `left` has them in this order.
    pub ends: [VertexId; 2],
    /// The face to its left, the one with the smaller number.
    pub left: usize,
    /// The face to its right.
    pub right: Option<usize>,
    /// The line it lies on; none is the rectangle's border.
    pub line: Option<usize>,
}

impl Arrangement {
    /// The rectangle between two corners, undivided.
    pub fn new(low: Point, high: Point) -> Self {
        let vertices = vec![low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)];
        // Inside runs from corner to corner with even numbers, outside back with odd ones.
        let side = |i: u32| {
            let (next, before) = ((i + 1) % 4, (i + 3) % 4);
            let inner = Half { from: i, next: 2 * next, before: 2 * before, face: 0, line: NONE };
            let outer =
                Half { from: next, next: 2 * before + 1, before: 2 * next + 1, face: NONE, line: NONE };
            [inner, outer]
        };
        let halves = (0..4).flat_map(side).collect();
        Self { vertices, halves, first: vec![0], outer: 1, marks: Marks::default() }
    }

    /// The rectangle split by all the lines; none if there are more than `most` faces.
    pub fn of_lines(low: Point, high: Point, lines: &[Line], most: usize) -> Option<Self> {
        let mut arrangement = Self::new(low, high);
        for (i, line) in lines.iter().enumerate() {
            arrangement.split(i, line, |_| true);
            if arrangement.count() > most {
                return None;
            }
        }
        Some(arrangement)
    }

    /// How many faces there are.
    pub fn count(&self) -> usize {
        self.first.len()
    }

    /// Splits the faces of the selection with a line, which gets this number. A face keeps its number for its part
    /// to the left of the line; the parts to the right are new.
    pub fn split(&mut self, number: usize, line: &Line, selected: impl Fn(usize) -> bool) {
        let line = &Knife::of(line);
        let met = self.met(line, selected);
        for &face in &met {
            for half in self.halves_of(face) {
                let [a, b] = [half, self.next(half)].map(|h| self.halves[h as usize].from);
                if self.sign(a, line) * self.sign(b, line) < 0 {
                    self.cut(half, line);
                }
            }
        }
        for face in met {
            self.divide(face, number as u32, line);
        }
    }

    /// The selected faces that have vertices on the line or on both its sides, by rising number.
    fn met(&mut self, line: &Knife, selected: impl Fn(usize) -> bool) -> Vec<u32> {
        self.marks.turn += 1;
        let turn = self.marks.turn;
        self.marks.faces.resize(self.first.len(), 0);
        let mut found: Vec<u32> = vec![];
        let enter = |marks: &mut Vec<u32>, found: &mut Vec<u32>, face: u32| {
            if face != NONE && std::mem::replace(&mut marks[face as usize], turn) != turn {
                found.push(face);
            }
        };
        let mut start = self.outer;
        let mut at = 0;
        loop {
            for half in self.ring_from(start) {
                if self.is_met(half, line) {
                    enter(&mut self.marks.faces, &mut found, self.halves[half as usize ^ 1].face);
                }
            }
            let Some(&face) = found.get(at) else { break };
            start = self.first[face as usize];
            at += 1;
        }
        found.retain(|&f| selected(f as usize));
        found.sort_unstable();
        found
    }

    /// Whether the line touches a side.
    fn is_met(&mut self, half: u32, line: &Knife) -> bool {
        let [a, b] = [half, half ^ 1].map(|h| self.halves[h as usize].from);
        self.sign(a, line) * self.sign(b, line) <= 0
    }

    /// On which side of the line at work a vertex lies: 1 is left, -1 right, 0 on it.
    fn sign(&mut self, vertex: u32, line: &Knife) -> i8 {
        let (turn, v) = (self.marks.turn, vertex as usize);
        self.marks.signs.resize(self.vertices.len().max(self.marks.signs.len()), (0, 0));
        let (of, known) = self.marks.signs[v];
        if of == turn {
            return known;
        }
        let sign = sign(line.side(self.vertices[v]));
        self.marks.signs[v] = (turn, sign);
        sign
    }

    fn next(&self, half: u32) -> u32 {
        self.halves[half as usize].next
    }

    /// The sides of a face, in order.
    fn halves_of(&self, face: u32) -> Vec<u32> {
        self.ring_from(self.first[face as usize])
    }

    /// The sides of the face, or of the outside, that has this one, from it on.
    fn ring_from(&self, start: u32) -> Vec<u32> {
        let after = |&half: &u32| Some(self.next(half)).filter(|&next| next != start);
        std::iter::successors(Some(start), after).collect()
    }

    /// A new vertex where the line crosses a side.
    fn cut(&mut self, half: u32, line: &Knife) {
        let twin = half ^ 1;
        let [from, to] = [half, twin].map(|h| self.halves[h as usize].from);
        // Always seen from the older vertex, so that it is the same point from both faces.
        let [a, b] = [from.min(to), from.max(to)].map(|v| self.vertices[v as usize]);
        let vertex = self.vertices.len() as u32;
        self.vertices.push(crossing(line, a, b));
        self.marks.signs.push((self.marks.turn, 0));
        let new = self.halves.len() as u32;
        let (half_was, twin_was) = (self.halves[half as usize], self.halves[twin as usize]);
        self.halves.push(Half { from: vertex, before: half, ..half_was });
        self.halves.push(Half { next: twin, ..twin_was });
        self.halves[half_was.next as usize].before = new;
        self.halves[half as usize].next = new;
        self.halves[twin_was.before as usize].next = new + 1;
        self.halves[twin as usize].before = new + 1;
        self.halves[twin as usize].from = vertex;
        // The face beyond begins where it began.
        if let Some(first) = self.first.get_mut(twin_was.face as usize)
            && *first == twin
        {
            *first = new + 1;
        }
    }

    /// Parts a face along the line, if the line runs through two of its vertices and through its inside.
    fn divide(&mut self, face: u32, number: u32, line: &Knife) {
        let halves = self.halves_of(face);
        let signs: Vec<i8> = halves.iter().map(|&h| self.sign(self.halves[h as usize].from, line)).collect();
        let Some((start, end)) = parts(&signs) else { return };
        let (start, end) = (halves[start], halves[end]);
        let (new, right) = (self.halves.len() as u32, self.first.len() as u32);
        let [start_was, end_was] = [start, end].map(|h| self.halves[h as usize]);
        let (left_line, right_line) = (new, new + 1);
        self.halves.push(Half {
            from: end_was.from,
            next: start,
            before: end_was.before,
            face,
            line: number,
        });
        let back =
            Half { from: start_was.from, next: end, before: start_was.before, face: right, line: number };
        self.halves.push(back);
        self.halves[end_was.before as usize].next = left_line;
        self.halves[start as usize].before = left_line;
        self.halves[start_was.before as usize].next = right_line;
        self.halves[end as usize].before = right_line;
        self.first[face as usize] = start;
        self.first.push(end);
        for half in self.halves_of(right) {
            self.halves[half as usize].face = right;
        }
    }

    /// The sides of a face, counter-clockwise: where each begins and ends, and its line.
    pub fn sides(&self, face: usize) -> impl Iterator<Item = (VertexId, VertexId, Option<usize>)> + '_ {
        self.halves_of(face as u32).into_iter().map(|h| {
            let (half, twin) = (self.halves[h as usize], self.halves[h as usize ^ 1]);
            (half.from as usize, twin.from as usize, some(half.line))
        })
    }

    /// All edges, ordered by their vertices.
    pub fn edges(&self) -> Vec<Edge> {
        let ends = |k: &u32| {
            let [a, b] = [2 * k, 2 * k + 1].map(|h| self.halves[h as usize].from);
            (u64::from(a.min(b)) << 32) | u64::from(a.max(b))
        };
        let mut pairs: Vec<(u64, u32)> = (0..self.halves.len() as u32 / 2).map(|k| (ends(&k), k)).collect();
        pairs.sort_unstable();
        pairs.iter().map(|&(_, k)| self.edge(k)).collect()
    }

    fn edge(&self, pair: u32) -> Edge {
        let [one, other] = [2 * pair, 2 * pair + 1].map(|h| self.halves[h as usize]);
        // What lies outside has the largest number.
        let (left, right) = if one.face < other.face { (one, other) } else { (other, one) };
        Edge {
            ends: [left.from as usize, right.from as usize],
            left: left.face as usize,
            right: some(right.face),
            line: some(left.line),
        }
    }

    /// The outline of a face.
    pub fn ring(&self, face: usize) -> Vec<Point> {
        self.sides(face).map(|side| self.vertices[side.0]).collect()
    }

    /// The face as a polygon.
    pub fn polygon(&self, face: usize) -> Polygon {
        Polygon { exterior: self.ring(face), holes: Vec::new() }
    }
}

/// A line with its direction.
struct Knife {
    sin: f64,
    cos: f64,
    offset: f64,
}

impl Knife {
    fn of(line: &Line) -> Self {
        let (sin, cos) = line.angle.sin_cos();
        Self { sin, cos, offset: line.offset }
    }

    /// Signed distance of a point, positive to the left, metres.
    fn side(&self, p: Point) -> f64 {
        p.y * self.cos - p.x * self.sin - self.offset
    }
}

fn some(number: u32) -> Option<usize> {
    (number != NONE).then_some(number as usize)
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

fn crossing(line: &Knife, a: Point, b: Point) -> Point {
    let (da, db) = (line.side(a), line.side(b));
    let t = da / (da - db);
    Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
}

/// Of a face whose vertices lie so about a line, in order: which vertex the part to the left begins with, and which the
/// part to the right. `None` if the line does not run through its inside.
fn parts(signs: &[i8]) -> Option<(usize, usize)> {
    let n = signs.len();
    let sign = |i: usize| signs[i % n];
    // Where the left part begins: a vertex on the line, followed by one to the left.
    let mut starts = (0..n).filter(|&i| sign(i) == 0 && sign(i + 1) > 0);
    let mut ends = (0..n).filter(|&i| sign(i) == 0 && sign(i + 1) < 0);
    let (start, end) = (starts.next()?, ends.next()?);
    if starts.next().is_some() || ends.next().is_some() {
        return None;
    }
    // Where more vertices lie on the line, it runs along the face.
    let left_end = (0..n).map(|k| (start + 1 + k) % n).find(|&i| sign(i) <= 0)?;
    let right_end = (0..n).map(|k| (end + 1 + k) % n).find(|&i| sign(i) >= 0)?;
    (left_end == end && right_end == start).then_some((start, end))
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::ring_signed_area;
    use std::f64::consts::PI;

    fn line(angle: f64, offset: f64) -> Line {
        Line { angle, offset, covered: Vec::new(), support: 1.0 }
    }

    fn square(lines: &[Line]) -> Arrangement {
        Arrangement::of_lines(Point::new(0.0, 0.0), Point::new(10.0, 10.0), lines, usize::MAX).unwrap()
    }

    fn check(a: &Arrangement) {
        let areas: Vec<f64> = (0..a.count()).map(|f| ring_signed_area(&a.ring(f))).collect();
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
        assert_eq!(a.count(), 4);
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
        assert_eq!(a.count(), 6);
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
        assert_eq!(a.count(), 3);
        check(&a);
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
