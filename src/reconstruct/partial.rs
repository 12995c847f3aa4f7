//! Rooms that were not seen whole: which they are, and a wall where no line closes them.

use super::arrangement::{Arrangement, Edge};
use super::boundary::Run;
use super::collinear::offset;
use super::directions::{difference, line_angle};
use super::faces::set_cells;
use super::lines::Line;
use super::paper::Clusters;
use super::raster::Mask;
use planform_sdk::{Point, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_4;

/// What makes a face partial.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Partial {
    /// A face is partial if an edge to an external face has less weight than this, 0 to 1.
    pub weight: f64,
}

impl Default for Partial {
    fn default() -> Self {
        Self { weight: 0.2 }
    }
}

/// Closes every face of the selection that reaches the border of the area with a wall parallel to the segment
/// nearest to the open side, where the seen cells end. The walls' lines are appended to `lines`.
pub fn close(
    arrangement: &mut Arrangement,
    lines: &mut Vec<Line>,
    segments: &[Segment],
    inner: &Mask,
    resolution: f64,
    selected: impl Fn(usize) -> bool,
) {
    for face in (0..arrangement.count()).filter(|&f| selected(f)) {
        let mut open = face;
        for side in border_sides(arrangement, face) {
            let seen = set_cells(&arrangement.ring(open), inner, resolution);
            let Some(line) = closing_line(&side, &seen, segments, resolution) else { continue };
            let parts = arrangement.count();
            arrangement.split(lines.len(), &line, |f| f == open);
            // The left part keeps the face's number.
            if arrangement.count() > parts && seen.iter().any(|&p| line.side(p) < 0.0) {
                open = parts;
            }
            lines.push(line);
        }
    }
}

/// The sides of a face on the border of the area.
fn border_sides(arrangement: &Arrangement, face: usize) -> Vec<Segment> {
    let at = |v: usize| arrangement.vertices[v];
    arrangement.sides(face).filter(|e| e.2.is_none()).map(|(a, b, _)| Segment::new(at(a), at(b))).collect()
}

/// The line at the end of the seen cells towards an open side; the side has the face to its left.
fn closing_line(side: &Segment, seen: &[Point], segments: &[Segment], resolution: f64) -> Option<Line> {
    // A segment across the side would run out of the face instead of closing it.
    let along = |s: &&Segment| difference(line_angle(s), line_angle(side)).abs() <= FRAC_PI_4;
    let distance = |s: &Segment| s.midpoint().distance(side.midpoint());
    let nearest = segments.iter().filter(along).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let angle = nearest.map_or_else(|| line_angle(side), line_angle);
    let outside = offset(side.midpoint(), angle);
    let inside = seen.iter().map(|&p| offset(p, angle));
    let middle = seen.iter().map(|&p| offset(p, angle)).sum::<f64>() / seen.len().max(1) as f64;
    let end = if outside > middle {
        inside.fold(f64::NEG_INFINITY, f64::max) + resolution / 2.0
    } else {
        inside.fold(f64::INFINITY, f64::min) - resolution / 2.0
    };
    end.is_finite().then(|| Line { angle, offset: end, covered: Vec::new(), support: 0.0 })
}

/// For each face whether it is partial: a neighbour of an external face, with too little wall between.
pub fn partial_faces(
    arrangement: &Arrangement,
    edges: &[Edge],
    weights: &[f64],
    params: &Partial,
    member: impl Fn(usize) -> bool,
) -> Vec<bool> {
    let mut partial = vec![false; arrangement.count()];
    for (edge, _) in edges.iter().zip(weights).filter(|(_, w)| **w < params.weight) {
        match (member(edge.left), edge.right.filter(|&f| member(f))) {
            (true, None) => partial[edge.left] = true,
            (false, Some(right)) => partial[right] = true,
            _ => {}
        }
    }
    partial
}

/// For each room whether it has a partial face or a frontier. A face within a wall joins its room late, and can bring
/// a frontier that no partial face has.
pub fn partial_rooms(clusters: &Clusters, runs: &[Run], params: &Partial) -> Vec<bool> {
    let mut result = vec![false; clusters.outlines.len()];
    let faces = clusters.of.iter().zip(&clusters.partial).filter(|(_, p)| **p).map(|(room, _)| *room);
    let frontiers = runs.iter().filter(|r| is_frontier(r, params)).flat_map(|r| r.rooms);
    for room in faces.chain(frontiers).flatten() {
        result[room] = true;
    }
    result
}

/// Whether a run is a frontier: the boundary of a room to the outside, with too little wall.
pub fn is_frontier(run: &Run, params: &Partial) -> bool {
    run.weight < params.weight && (run.rooms[0].is_none() || run.rooms[1].is_none())
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;

    #[test]
    fn an_open_face_is_closed_where_the_seen_cells_end() {
        let mut arrangement = Arrangement::new(Point::new(0.0, 0.0), Point::new(10.0, 4.0));
        let seen = mask(&["..........", "..######..", "..######..", ".........."]);
        let segments = [
            Segment::new(Point::new(8.0, 1.0), Point::new(8.0, 3.0)),
            Segment::new(Point::new(2.0, 1.0), Point::new(8.0, 1.0)),
        ];
        let mut lines = Vec::new();
        close(&mut arrangement, &mut lines, &segments, &seen, 1.0, |_| true);
        let face = (0..arrangement.count())
            .find(|&f| arrangement.polygon(f).contains(Point::new(5.0, 2.0)))
            .unwrap();
        let polygon = arrangement.polygon(face);
        assert!((polygon.area() - 12.0).abs() < 1e-9, "{polygon:?}");
    }

    #[test]
    fn faces_open_to_the_outside_are_partial() {
        let line = |offset, covered| Line { angle: 0.0, offset, covered, support: 1.0 };
        let lines = [line(1.0, vec![]), line(2.0, vec![(0.0, 10.0)])];
        let a =
            Arrangement::of_lines(Point::new(0.0, 0.0), Point::new(10.0, 3.0), &lines, usize::MAX).unwrap();
        let member: Vec<bool> = (0..3).map(|f| a.polygon(f).contains(Point::new(5.0, 1.5))).collect();
        let edges = a.edges();
        let weights = super::super::affinity::weights(&a, &edges, &lines);
        let inside: Vec<Edge> = edges.iter().filter(|e| e.line.is_some()).copied().collect();
        let inside_weights: Vec<f64> =
            edges.iter().zip(&weights).filter(|(e, _)| e.line.is_some()).map(|(_, w)| *w).collect();
        let partial = partial_faces(&a, &inside, &inside_weights, &Partial::default(), |f| member[f]);
        assert_eq!(partial, member);
        let walled = partial_faces(&a, &inside, &[1.0, 1.0], &Partial::default(), |f| member[f]);
        assert_eq!(walled, [false; 3]);
    }
}
