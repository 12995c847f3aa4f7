//! Segments clustered by the angle of their lines: mean shift (Cheng, "Mean Shift, Mode Seeking, and Clustering",
//! 1995) on the half circle.

use planform_sdk::Segment;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// How alike the angles of a cluster are.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Directions {
    /// Radius of the mean-shift kernel: the largest difference of angle that draws. Radians; 0.2145 rad is a
    /// bandwidth of 0.023 in 1 - cos.
    pub bandwidth: f64,
    /// Modes nearer than this are one. Radians.
    pub merge: f64,
    /// A direction that carries a smaller share of the segments' length is dropped, with its segments. 0 to 1.
    pub min_share: f64,
}

impl Default for Directions {
    fn default() -> Self {
        Self { bandwidth: 0.2145, merge: 0.01, min_share: 0.0 }
    }
}

/// Segments of one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// The angle of their lines, radians in [0, pi).
    pub angle: f64,
    /// The segments.
    pub segments: Vec<Segment>,
}

/// Bins of the half circle on which the shift runs: 0.1 degrees each.
const BINS: usize = 1800;

/// Clusters the segments by angle; by rising angle.
pub fn cluster(segments: &[Segment], params: &Directions) -> Vec<Direction> {
    let weights = histogram(segments);
    let ends = ends(&weights, params.bandwidth);
    let modes = modes(&weights, &ends, params.merge);
    let mut clusters: Vec<Direction> =
        modes.iter().map(|&angle| Direction { angle, segments: Vec::new() }).collect();
    for segment in segments {
        if let Some(i) = nearest(&modes, ends[bin(line_angle(segment))]) {
            clusters[i].segments.push(*segment);
        }
    }
    let total: f64 = segments.iter().map(Segment::length).sum();
    clusters.retain(|c| c.length() > 0.0 && c.length() >= params.min_share * total);
    clusters
}

impl Direction {
    fn length(&self) -> f64 {
        self.segments.iter().map(Segment::length).sum()
    }
}

/// The angle of a segment's line, in [0, pi).
pub fn line_angle(segment: &Segment) -> f64 {
    wrap(segment.angle())
}

/// The angle in [0, pi) of the same line.
pub fn wrap(angle: f64) -> f64 {
    let wrapped = angle.rem_euclid(PI);
    if wrapped >= PI { 0.0 } else { wrapped }
}

/// The signed difference of two lines' angles, in [-pi/2, pi/2).
pub fn difference(a: f64, b: f64) -> f64 {
    (a - b + PI / 2.0).rem_euclid(PI) - PI / 2.0
}

fn bin(angle: f64) -> usize {
    (angle / PI * BINS as f64).round() as usize % BINS
}

/// Length of the segments at each angle. Long segments know their angle better, so they weigh more.
fn histogram(segments: &[Segment]) -> Vec<f64> {
    let mut weights = vec![0.0; BINS];
    for s in segments {
        weights[bin(line_angle(s))] += s.length();
    }
    weights
}

/// For each bin where the mean shift from it ends.
fn ends(weights: &[f64], bandwidth: f64) -> Vec<f64> {
    let start = |bin: usize| bin as f64 * PI / BINS as f64;
    (0..BINS).map(|b| if weights[b] > 0.0 { shift(start(b), weights, bandwidth) } else { start(b) }).collect()
}

/// Where the mean shift from this angle ends.
fn shift(start: f64, weights: &[f64], bandwidth: f64) -> f64 {
    let step = PI / BINS as f64;
    let reach = (bandwidth / step).ceil() as i64;
    let mut at = start;
    for _ in 0..200 {
        let middle = (at / step).round() as i64;
        let (mut sum, mut moment) = (0.0, 0.0);
        for bin in middle - reach..=middle + reach {
            let weight = weights[bin.rem_euclid(BINS as i64) as usize];
            if weight <= 0.0 {
                continue;
            }
            let d = difference(bin as f64 * step, at);
            let x = (1.0 - d.cos()) / (1.0 - bandwidth.cos());
            if x < 1.0 {
                let pull = weight * (1.0 - x) * (1.0 - x);
                sum += pull;
                moment += pull * d;
            }
        }
        if sum == 0.0 || (moment / sum).abs() < 1e-6 {
            break;
        }
        at = wrap(at + moment / sum);
    }
    at
}

/// The distinct ends of all shifts, by rising angle; modes that are close are averaged by their weight.
fn modes(weights: &[f64], ends: &[f64], merge: f64) -> Vec<f64> {
    let mut ends: Vec<(f64, f64)> =
        ends.iter().zip(weights).filter(|(_, w)| **w > 0.0).map(|(e, w)| (*e, *w)).collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut groups: Vec<Vec<(f64, f64)>> = Vec::new();
    for end in ends {
        match groups.last_mut() {
            Some(group) if end.0 - group[group.len() - 1].0 < merge => group.push(end),
            _ => groups.push(vec![end]),
        }
    }
    join_around(&mut groups, merge);
    let mut modes: Vec<f64> = groups.iter().map(|g| mean(g)).collect();
    modes.sort_by(f64::total_cmp);
    modes
}

/// The first and the last group may be one, over the end of the half circle.
fn join_around(groups: &mut Vec<Vec<(f64, f64)>>, merge: f64) {
    if groups.len() < 2 {
        return;
    }
    let first = groups[0][0].0;
    let last = groups[groups.len() - 1].iter().map(|e| e.0).fold(0.0, f64::max);
    if first + PI - last < merge
        && let Some(tail) = groups.pop()
    {
        groups[0].extend(tail);
    }
}

fn mean(group: &[(f64, f64)]) -> f64 {
    let base = group[0].0;
    let weight: f64 = group.iter().map(|(_, w)| w).sum();
    let moment: f64 = group.iter().map(|(a, w)| w * difference(*a, base)).sum();
    wrap(base + moment / weight.max(f64::MIN_POSITIVE))
}

fn nearest(modes: &[f64], angle: f64) -> Option<usize> {
    let distance = |i: &usize| difference(modes[*i], angle).abs();
    (0..modes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Point;

    fn at(angle: f64, length: f64) -> Segment {
        Segment::new(Point::new(0.0, 0.0), Point::new(length * angle.cos(), length * angle.sin()))
    }

    #[test]
    fn angles_fall_into_their_directions() {
        let segments = [at(0.01, 3.0), at(-0.01, 3.0), at(PI / 2.0, 2.0), at(0.8, 1.0)];
        let found = cluster(&segments, &Directions::default());
        assert_eq!(found.iter().map(|d| d.segments.len()).collect::<Vec<_>>(), [2, 1, 1]);
        assert!(difference(found[0].angle, 0.0).abs() < 2e-3);
    }

    #[test]
    fn the_half_circle_is_closed() {
        let segments = [at(PI - 0.002, 3.0), at(0.002, 3.0)];
        assert_eq!(cluster(&segments, &Directions::default()).len(), 1);
    }

    #[test]
    fn faint_directions_can_be_dropped() {
        let segments = [at(0.0, 10.0), at(0.8, 0.5)];
        let params = Directions { min_share: 0.1, ..Directions::default() };
        assert_eq!(cluster(&segments, &params).len(), 1);
    }
}
