//! Segments of one direction clustered by their distance: those along one wall come together.

use super::directions::Direction;
use planform_sdk::{Point, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// When two segments lie along one line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Collinear {
    /// The line distance threshold of the paper: the largest distance of the parallel lines through two segments'
    /// middles that puts both in one cluster. Metres.
    pub distance: f64,
}

impl Default for Collinear {
    fn default() -> Self {
        Self { distance: 0.9 }
    }
}

/// Segments along one line.
#[derive(Debug, Clone, PartialEq)]
pub struct Collinears {
    /// The angle of their direction, radians in [0, pi).
    pub angle: f64,
    /// The segments.
    pub segments: Vec<Segment>,
}

/// Signed distance of the line through `p` with this angle from the origin, metres.
pub fn offset(p: Point, angle: f64) -> f64 {
    p.y * angle.cos() - p.x * angle.sin()
}

/// Splits every direction into its spatial clusters.
pub fn cluster(directions: &[Direction], params: &Collinear) -> Vec<Collinears> {
    directions.iter().flat_map(|d| split(d, params.distance)).collect()
}

fn split(direction: &Direction, distance: f64) -> Vec<Collinears> {
    let angle = direction.angle;
    let mut sorted: Vec<(f64, Segment)> =
        direction.segments.iter().map(|s| (offset(s.midpoint(), angle), *s)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut clusters: Vec<Collinears> = Vec::new();
    let mut first = f64::NEG_INFINITY;
    for (at, segment) in sorted {
        match clusters.last_mut() {
            Some(cluster) if at - first < distance => cluster.segments.push(segment),
            _ => {
                clusters.push(Collinears { angle, segments: vec![segment] });
                first = at;
            }
        }
    }
    clusters
}
