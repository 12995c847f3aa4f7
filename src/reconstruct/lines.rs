//! One representative line for each spatial cluster: it has the angle of the cluster's direction and goes through
//! the middle of the segments' middle points.

use super::collinear::{Collinears, offset};
use planform_sdk::{Point, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which clusters have a representative line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Lines {
    /// A cluster whose segments are together shorter than this has no line. Metres.
    pub min_support: f64,
    /// The most lines; beyond it the least supported are dropped. The faces grow with its square.
    pub max_count: usize,
}

impl Default for Lines {
    // What is shorter than 1.5 m altogether is a door leaf, a niche or furniture; its line would cut the whole
    // building.
    fn default() -> Self {
        Self { min_support: 1.5, max_count: 600 }
    }
}

/// A representative line: the points p with `p.y * cos(angle) - p.x * sin(angle) = offset`.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Radians in [0, pi).
    pub angle: f64,
    /// Signed distance from the origin, metres.
    pub offset: f64,
    /// Where wall segments project onto it: disjoint intervals of [`Line::along`], rising.
    pub covered: Vec<(f64, f64)>,
    /// Total length of its segments, metres.
    pub support: f64,
}

impl Line {
    /// Signed distance of a point from the line, positive to its left, metres.
    pub fn side(&self, p: Point) -> f64 {
        offset(p, self.angle) - self.offset
    }

    /// Position of a point's projection along the line, metres.
    pub fn along(&self, p: Point) -> f64 {
        p.x * self.angle.cos() + p.y * self.angle.sin()
    }

    /// The point of the line at this position.
    pub fn point(&self, along: f64) -> Point {
        let (sin, cos) = self.angle.sin_cos();
        Point::new(along * cos - self.offset * sin, along * sin + self.offset * cos)
    }

    /// The part of the line within a rectangle, if it runs through it; metres.
    pub fn within(&self, low: Point, high: Point) -> Option<Segment> {
        let corners = [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)];
        let mut ends: Vec<f64> = Vec::new();
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % 4];
            let (da, db) = (self.side(a), self.side(b));
            if (da > 0.0) != (db > 0.0) {
                let t = da / (da - db);
                ends.push(self.along(Point::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))));
            }
        }
        let from = ends.iter().copied().fold(f64::MAX, f64::min);
        let to = ends.iter().copied().fold(f64::MIN, f64::max);
        (from < to).then(|| Segment::new(self.point(from), self.point(to)))
    }

    /// Length of the line's part between two positions that wall segments cover, metres.
    pub fn coverage(&self, from: f64, to: f64) -> f64 {
        let (low, high) = (from.min(to), from.max(to));
        let begin = self.covered.partition_point(|c| c.1 < low);
        self.covered[begin..]
            .iter()
            .take_while(|c| c.0 < high)
            .map(|c| (c.1.min(high) - c.0.max(low)).max(0.0))
            .sum()
    }
}

/// The representative lines of the clusters, in the clusters' order.
pub fn represent(clusters: &[Collinears], params: &Lines) -> Vec<Line> {
    let mut lines: Vec<Line> =
        clusters.iter().map(line).filter(|l| l.support >= params.min_support).collect();
    while lines.len() > params.max_count {
        let weakest = (0..lines.len()).min_by(|&a, &b| lines[a].support.total_cmp(&lines[b].support));
        lines.remove(weakest.unwrap_or(0));
    }
    lines
}

fn line(cluster: &Collinears) -> Line {
    let line = Line {
        angle: cluster.angle,
        offset: interquartile_mean(&cluster.segments, cluster.angle),
        covered: Vec::new(),
        support: cluster.segments.iter().map(Segment::length).sum(),
    };
    let project = |s: &Segment| {
        let (a, b) = (line.along(s.a), line.along(s.b));
        (a.min(b), a.max(b))
    };
    let covered = union(cluster.segments.iter().map(project).collect());
    Line { covered, ..line }
}

/// The interquartile mean of the offsets of the segments' middles, each counted by its length. The paper has their
/// median, which lies on one face of a wall, whichever happens to be longer; this is as robust, but lies between two
/// faces that are about equally long.
fn interquartile_mean(segments: &[Segment], angle: f64) -> f64 {
    let mut offsets: Vec<(f64, f64)> =
        segments.iter().map(|s| (offset(s.midpoint(), angle), s.length())).collect();
    offsets.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = offsets.iter().map(|o| o.1).sum();
    let (low, high) = (total * 0.25, total * 0.75);
    let (mut end, mut moment, mut weight) = (0.0, 0.0, 0.0);
    for (at, length) in offsets {
        let begin = end;
        end += length;
        let within = (end.min(high) - begin.max(low)).max(0.0);
        moment += within * at;
        weight += within;
    }
    if weight > 0.0 { moment / weight } else { 0.0 }
}

/// The union of intervals: disjoint, rising.
fn union(mut intervals: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut united: Vec<(f64, f64)> = Vec::new();
    for interval in intervals {
        match united.last_mut() {
            Some(last) if interval.0 <= last.1 => last.1 = last.1.max(interval.1),
            _ => united.push(interval),
        }
    }
    united
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cluster(segments: &[[[f64; 2]; 2]]) -> Collinears {
        let segment = |s: &[[f64; 2]; 2]| Segment::new(s[0].into(), s[1].into());
        Collinears { angle: 0.0, segments: segments.iter().map(segment).collect() }
    }

    #[test]
    fn a_line_knows_where_it_is_covered() {
        let c = cluster(&[[[0.0, 1.0], [2.0, 1.0]], [[1.0, 1.0], [3.0, 1.0]], [[5.0, 1.0], [6.0, 1.0]]]);
        let line = &represent(&[c], &Lines::default())[0];
        assert_eq!((line.offset, line.support), (1.0, 5.0));
        assert_eq!(line.covered, [(0.0, 3.0), (5.0, 6.0)]);
        assert_eq!(line.coverage(2.0, 5.5), 1.5);
        assert_eq!(line.coverage(3.5, 4.5), 0.0);
        assert_eq!(line.coverage(10.0, -10.0), 4.0);
    }

    #[test]
    fn a_line_is_clipped_to_a_rectangle() {
        let line = &represent(&[cluster(&[[[0.0, 1.0], [2.0, 1.0]]])], &Lines::default())[0];
        let (low, high) = (Point::new(-1.0, 0.0), Point::new(5.0, 4.0));
        let part = line.within(low, high).unwrap();
        assert_eq!((part.a, part.b), (Point::new(-1.0, 1.0), Point::new(5.0, 1.0)));
        assert_eq!(line.within(Point::new(0.0, 2.0), high), None);
    }

    #[test]
    fn a_line_lies_between_the_faces_of_its_wall() {
        let faces = [[[0.0, 1.0], [8.2, 1.0]], [[0.2, 1.2], [4.0, 1.2]], [[4.2, 1.2], [8.0, 1.2]]];
        let line = &represent(&[cluster(&faces)], &Lines::default())[0];
        assert!((line.offset - 1.1).abs() < 0.01, "{}", line.offset);
    }

    #[test]
    fn a_stray_segment_does_not_move_a_line() {
        let wall = [[[0.0, 1.0], [8.0, 1.0]], [[8.5, 1.8], [9.5, 1.8]]];
        assert_eq!(represent(&[cluster(&wall)], &Lines::default())[0].offset, 1.0);
    }

    #[test]
    fn the_least_supported_lines_go_first() {
        let clusters = [cluster(&[[[0.0, 0.0], [1.0, 0.0]]]), cluster(&[[[0.0, 3.0], [4.0, 3.0]]])];
        let lines = represent(&clusters, &Lines { max_count: 1, ..Lines::default() });
        assert_eq!(lines.iter().map(|l| l.offset).collect::<Vec<_>>(), [3.0]);
    }
}
