//! The polygon of a set of faces: what the merged faces of a room enclose.

use super::arrangement::{Arrangement, Edge, VertexId};
use planform_sdk::{Point, Polygon, ring_signed_area};
use std::collections::BTreeMap;

/// A vertex of an outline and the line of the side that begins there; none is the border of the area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Where it is, metres.
    pub at: Point,
    /// The line of the side to the next corner.
    pub line: Option<usize>,
}

/// A polygon that knows the lines its sides lie on. The inside is to the left of every side.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The outer ring, then the holes.
    pub rings: Vec<Vec<Corner>>,
}

impl Outline {
    /// The polygon without the lines.
    pub fn polygon(&self) -> Polygon {
        let mut rings = self.rings.iter().map(|r| points(r));
        Polygon { exterior: rings.next().unwrap_or_default(), holes: rings.collect() }
    }

    /// All sides: begin, end, line.
    pub fn sides(&self) -> impl Iterator<Item = (Point, Point, Option<usize>)> + '_ {
        let side = |r: &'_ Vec<Corner>, i: usize| (r[i].at, r[(i + 1) % r.len()].at, r[i].line);
        self.rings.iter().flat_map(move |r| (0..r.len()).map(move |i| side(r, i)))
    }
}

fn points(ring: &[Corner]) -> Vec<Point> {
    ring.iter().map(|c| c.at).collect()
}

/// The polygon that the faces of each group make. `group` tells each face's group, from 0; a group hangs together by
/// edges. Holes are other groups and outside faces within it.
pub fn outlines(arrangement: &Arrangement, edges: &[Edge], group: &[Option<usize>]) -> Vec<Outline> {
    let count = group.iter().flatten().max().map_or(0, |m| m + 1);
    let mut sides: Vec<BTreeMap<VertexId, Vec<Step>>> = vec![BTreeMap::new(); count];
    for edge in edges {
        let (left, right) = (group[edge.left], edge.right.and_then(|f| group[f]));
        if left == right {
            continue;
        }
        let [a, b] = edge.ends;
        if let Some(g) = left {
            sides[g].entry(a).or_default().push(Step { to: b, line: edge.line });
        }
        if let Some(g) = right {
            sides[g].entry(b).or_default().push(Step { to: a, line: edge.line });
        }
    }
    sides.into_iter().map(|s| outline_of(arrangement, s)).collect()
}

/// From a vertex to the next one, with the group to the left.
#[derive(Debug, Clone, Copy)]
struct Step {
    to: VertexId,
    line: Option<usize>,
}

fn outline_of(arrangement: &Arrangement, mut sides: BTreeMap<VertexId, Vec<Step>>) -> Outline {
    let mut rings = Vec::new();
    while let Some((&start, _)) = sides.first_key_value() {
        rings.extend(simple_rings(&trace(start, &mut sides)));
    }
    let corners = |ring: Vec<(VertexId, Option<usize>)>| -> Vec<Corner> {
        straighten(ring).into_iter().map(|(v, line)| Corner { at: arrangement.vertices[v], line }).collect()
    };
    assemble(rings.into_iter().map(corners).filter(|r| r.len() > 2).collect())
}

/// Follows the sides from a vertex until it is reached again: each vertex with the line of the side that begins
/// there. The sides are taken out.
fn trace(start: VertexId, sides: &mut BTreeMap<VertexId, Vec<Step>>) -> Vec<(VertexId, Option<usize>)> {
    let mut walk = Vec::new();
    let mut at = start;
    while let Some(steps) = sides.get_mut(&at) {
        let Some(step) = steps.pop() else { break };
        if steps.is_empty() {
            sides.remove(&at);
        }
        walk.push((at, step.line));
        at = step.to;
        if at == start {
            break;
        }
    }
    walk
}

/// Cuts a closed walk at the vertices that it visits more than once.
fn simple_rings(walk: &[(VertexId, Option<usize>)]) -> Vec<Vec<(VertexId, Option<usize>)>> {
    let mut rings = Vec::new();
    let mut stack: Vec<(VertexId, Option<usize>)> = Vec::new();
    for &(vertex, line) in walk {
        if let Some(i) = stack.iter().position(|s| s.0 == vertex) {
            rings.push(stack.split_off(i));
        }
        stack.push((vertex, line));
    }
    rings.push(stack);
    rings
}

/// Drops the vertices between two sides on the same line.
fn straighten(ring: Vec<(VertexId, Option<usize>)>) -> Vec<(VertexId, Option<usize>)> {
    let n = ring.len();
    let bends = |i: usize| ring[i].1.is_none() || ring[i].1 != ring[(i + n - 1) % n].1;
    (0..n).filter(|&i| bends(i)).map(|i| ring[i]).collect()
}

/// The counter-clockwise ring is the exterior, the clockwise ones are its holes. Faces that hang together by edges
/// have one exterior; should rounding make a second one, it is smaller than any room.
fn assemble(rings: Vec<Vec<Corner>>) -> Outline {
    let area = |r: &Vec<Corner>| ring_signed_area(&points(r));
    let (outer, holes): (Vec<_>, Vec<_>) = rings.into_iter().partition(|r| area(r) > 0.0);
    let exterior = outer.into_iter().max_by(|a, b| area(a).total_cmp(&area(b)));
    Outline { rings: exterior.into_iter().chain(holes).collect() }
}

#[cfg(test)]
mod tests {
    use super::super::lines::Line;
    use super::*;
    use std::f64::consts::PI;

    /// A square of side 3 in nine unit faces.
    fn nine() -> Arrangement {
        let line = |angle, offset| Line { angle, offset, covered: vec![], support: 1.0 };
        let lines: Vec<Line> =
            [0.0, 1.0, 2.0, 3.0].iter().flat_map(|&o| [line(0.0, o), line(PI / 2.0, -o)]).collect();
        Arrangement::of_lines(Point::new(-1.0, -1.0), Point::new(4.0, 4.0), &lines, usize::MAX).unwrap()
    }

    fn face_at(a: &Arrangement, x: f64, y: f64) -> usize {
        (0..a.count()).find(|&f| a.polygon(f).contains(Point::new(x, y))).unwrap()
    }

    fn outline(a: &Arrangement, chosen: &[(f64, f64)]) -> Vec<Polygon> {
        let chosen: Vec<usize> = chosen.iter().map(|&(x, y)| face_at(a, x, y)).collect();
        let group: Vec<_> = (0..a.count()).map(|f| chosen.contains(&f).then_some(0)).collect();
        outlines(a, &a.edges(), &group).iter().map(Outline::polygon).collect()
    }

    #[test]
    fn merged_faces_lose_their_inner_vertices() {
        let p = outline(&nine(), &[(0.5, 0.5), (1.5, 0.5), (2.5, 0.5)]);
        assert_eq!((p.len(), p[0].exterior.len()), (1, 4));
        assert!((p[0].area() - 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_ring_of_faces_has_a_hole() {
        let ring: Vec<(f64, f64)> =
            (0..9).filter(|i| *i != 4).map(|i| (f64::from(i % 3) + 0.5, f64::from(i / 3) + 0.5)).collect();
        let p = outline(&nine(), &ring);
        assert_eq!((p.len(), p[0].holes.len()), (1, 1));
        assert!((p[0].area() - 8.0).abs() < 1e-9);
    }

    #[test]
    fn a_hole_that_touches_the_outline_stays_a_ring_of_its_own() {
        let a = nine();
        // All but the middle face and a corner face, which touch at one vertex.
        let all: Vec<(f64, f64)> = (0..9)
            .filter(|i| ![4, 0].contains(i))
            .map(|i| (f64::from(i % 3) + 0.5, f64::from(i / 3) + 0.5))
            .collect();
        let p = outline(&a, &all);
        assert!((p[0].area() - 7.0).abs() < 1e-9);
        for ring in p.iter().flat_map(Polygon::rings) {
            let mut seen: Vec<[f64; 2]> = ring.iter().map(|&q| q.into()).collect();
            seen.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            seen.dedup();
            assert_eq!(seen.len(), ring.len());
        }
    }
}
