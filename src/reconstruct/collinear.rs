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
    /// Which two segments of a cluster have to be that near.
    pub linkage: Linkage,
}

impl Default for Collinear {
    fn default() -> Self {
        Self { distance: 0.9, linkage: Linkage::Complete }
    }
}

/// Which two segments of a cluster have to be near each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Linkage {
    /// Any two.
    Complete,
    /// Each and the next one: a cluster may grow from wall to wall over what stands between.
    Single,
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
    directions.iter().flat_map(|d| split(d, params)).collect()
}

fn split(direction: &Direction, params: &Collinear) -> Vec<Collinears> {
    let angle = direction.angle;
    let mut sorted: Vec<(f64, Segment)> =
        direction.segments.iter().map(|s| (offset(s.midpoint(), angle), *s)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut clusters: Vec<Collinears> = Vec::new();
    let mut reference = f64::NEG_INFINITY;
    for (at, segment) in sorted {
        match clusters.last_mut() {
            Some(cluster) if at - reference < params.distance => {
                cluster.segments.push(segment);
                if params.linkage == Linkage::Single {
                    reference = at;
                }
            }
            _ => {
                clusters.push(Collinears { angle, segments: vec![segment] });
                reference = at;
            }
        }
    }
    clusters
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(linkage: Linkage) -> Vec<usize> {
        let at = |y: f64| Segment::new(Point::new(0.0, y), Point::new(2.0, y));
        let segments = [0.0, 0.5, 1.0, 1.5, 4.0].map(at).to_vec();
        let clusters = cluster(&[Direction { angle: 0.0, segments }], &Collinear { distance: 0.9, linkage });
        clusters.iter().map(|c| c.segments.len()).collect()
    }

    #[test]
    fn a_cluster_is_no_wider_than_the_distance() {
        assert_eq!(counts(Linkage::Complete), [2, 2, 1]);
    }

    #[test]
    fn single_linkage_chains() {
        assert_eq!(counts(Linkage::Single), [4, 1]);
    }
}
