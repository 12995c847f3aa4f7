//! The boundaries between rooms: straight runs of edges on one line, with the same room on either side.

use super::arrangement::{Arrangement, Edge};
use super::lines::Line;
use planform_sdk::{Point, Segment};
use std::collections::BTreeMap;

/// A straight boundary. It runs in the direction of its line.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The line it lies on; none is the border of the area.
    pub line: Option<usize>,
    /// Where it runs, metres from the grid's corner.
    pub segment: Segment,
    /// Share of it that wall segments cover, 0 to 1.
    pub weight: f64,
    /// The rooms to its left and right; none is outside.
    pub rooms: [Option<usize>; 2],
}

/// The runs of all edges between different rooms and between a room and the outside, line by line.
pub fn runs(
    arrangement: &Arrangement,
    edges: &[Edge],
    weights: &[f64],
    lines: &[Line],
    room: &[Option<usize>],
) -> Vec<Run> {
    let mut by_line: BTreeMap<usize, Vec<Run>> = BTreeMap::new();
    let mut border = Vec::new();
    for (edge, weight) in edges.iter().zip(weights) {
        let rooms = [room[edge.left], edge.right.and_then(|f| room[f])];
        if rooms[0] == rooms[1] {
            continue;
        }
        let [a, b] = edge.ends.map(|v| arrangement.vertices[v]);
        let run = Run { line: edge.line, segment: Segment::new(a, b), weight: *weight, rooms };
        match edge.line {
            Some(l) => by_line.entry(l).or_default().push(orient(run, &lines[l])),
            None => border.push(run),
        }
    }
    let mut runs: Vec<Run> = by_line.into_iter().flat_map(|(l, runs)| join(runs, &lines[l])).collect();
    runs.append(&mut border);
    runs
}

fn orient(run: Run, line: &Line) -> Run {
    if line.along(run.segment.a) <= line.along(run.segment.b) {
        return run;
    }
    Run { segment: Segment::new(run.segment.b, run.segment.a), rooms: [run.rooms[1], run.rooms[0]], ..run }
}

/// Joins runs that follow each other between the same rooms.
fn join(mut runs: Vec<Run>, line: &Line) -> Vec<Run> {
    runs.sort_by(|a, b| line.along(a.segment.a).total_cmp(&line.along(b.segment.a)));
    let mut joined: Vec<Run> = Vec::new();
    for run in runs {
        match joined.last_mut() {
            Some(last) if last.rooms == run.rooms && last.segment.b == run.segment.a => extend(last, &run),
            _ => joined.push(run),
        }
    }
    joined
}

fn extend(run: &mut Run, next: &Run) {
    let (a, b) = (run.segment.length(), next.segment.length());
    run.weight = (run.weight * a + next.weight * b) / (a + b).max(f64::MIN_POSITIVE);
    run.segment.b = next.segment.b;
}

impl Run {
    /// The point at this distance from the run's begin, moved to its left by `left`, metres.
    pub fn point(&self, along: f64, left: f64) -> Point {
        let (sin, cos) = self.segment.angle().sin_cos();
        Point::new(self.segment.a.x + along * cos - left * sin, self.segment.a.y + along * sin + left * cos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn edges_between_the_same_rooms_are_one_run() {
        let line = |angle, offset, covered| Line { angle, offset, covered, support: 1.0 };
        let lines = [line(0.0, 5.0, vec![(0.0, 4.0)]), line(PI / 2.0, -4.0, vec![])];
        let a =
            Arrangement::of_lines(Point::new(0.0, 0.0), Point::new(10.0, 10.0), &lines, usize::MAX).unwrap();
        let edges = a.edges();
        let weights = super::super::affinity::weights(&a, &edges, &lines);
        let above = |f: usize| usize::from(a.ring(f).iter().map(|p| p.y).sum::<f64>() < 20.0);
        let room: Vec<_> = (0..a.count()).map(|f| Some(above(f))).collect();
        let runs = runs(&a, &edges, &weights, &lines, &room);
        let shared: Vec<&Run> =
            runs.iter().filter(|r| r.rooms[0].is_some() && r.rooms[1].is_some()).collect();
        assert_eq!(shared.len(), 1);
        assert_eq!((shared[0].segment.length(), shared[0].rooms), (10.0, [Some(0), Some(1)]));
        assert!((shared[0].weight - 0.4).abs() < 1e-9);
    }
}
