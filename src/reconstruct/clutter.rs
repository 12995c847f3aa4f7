//! Isolated obstacle cells are clustered and removed (section IV-B of the paper): furniture, people, noise.
//!
//! The clustering is DBSCAN (Ester et al. 1996) on the cells' middles. Walls hang together over metres; what hangs
//! together over less stands alone in a room and is no part of the building.

use super::ReconstructError;
use super::raster::{Extent, Mask};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How isolated obstacle cells are found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Clutter {
    /// DBSCAN's radius: obstacle cells nearer than this hang together. Metres.
    pub radius: f64,
    /// DBSCAN's least number of neighbours of a core cell, itself included.
    pub min_points: usize,
    /// A cluster whose bounding box has a shorter diagonal is clutter. Metres; 0 keeps everything.
    pub extent: f64,
}

impl Default for Clutter {
    fn default() -> Self {
        Self { radius: 0.1, min_points: 1, extent: 1.0 }
    }
}

/// The largest radius in cells: the work grows with its square.
const MAX_RADIUS: f64 = 25.0;

/// The obstacle cells that are not clutter. `resolution` in metres per cell.
pub fn remove(obstacles: &Mask, resolution: f64, params: &Clutter) -> Result<Mask, ReconstructError> {
    if params.extent <= 0.0 {
        return Ok(obstacles.clone());
    }
    let radius = (params.radius / resolution).max(1.5);
    if radius > MAX_RADIUS {
        return Err(ReconstructError::Parameter {
            name: "clutter.radius".into(),
            value: params.radius,
            advice: format!(
                "at {resolution} m per cell give at most {}; is the resolution right?",
                MAX_RADIUS * resolution
            ),
        });
    }
    let clusters = dbscan(obstacles, radius, params.min_points);
    let mut boxes: Vec<Option<Extent>> = vec![None; clusters.count];
    for (column, row) in obstacles.cells() {
        if let Some(c) = clusters.of[row * obstacles.width() + column] {
            let cell = Extent::of((column, row));
            boxes[c] = Some(boxes[c].map_or(cell, |b| b.join(cell)));
        }
    }
    let large = |c: usize| boxes[c].is_some_and(|b| b.diagonal() * resolution >= params.extent);
    let keep = |i: usize| clusters.of[i].is_some_and(large);
    Ok(obstacles.with_bits((0..obstacles.bits().len()).map(keep).collect()))
}

/// The cluster of each cell; noise and free cells have none.
struct Clusters {
    of: Vec<Option<usize>>,
    count: usize,
}

/// DBSCAN of the set cells, `radius` in cells.
fn dbscan(cells: &Mask, radius: f64, min_points: usize) -> Clusters {
    let disc = disc(radius);
    let core = |i: usize| min_points <= 1 || neighbours(cells, &disc, i).count() >= min_points;
    let is_core: Vec<bool> = (0..cells.bits().len()).map(|i| cells.bits()[i] && core(i)).collect();
    let mut clusters = Clusters { of: vec![None; is_core.len()], count: 0 };
    let mut queue = Vec::new();
    for start in 0..is_core.len() {
        if !is_core[start] || clusters.of[start].is_some() {
            continue;
        }
        clusters.of[start] = Some(clusters.count);
        queue.push(start);
        while let Some(i) = queue.pop() {
            for j in neighbours(cells, &disc, i) {
                if clusters.of[j].is_none() {
                    clusters.of[j] = Some(clusters.count);
                    // A border cell belongs to the cluster that reaches it first and does not spread it.
                    if is_core[j] {
                        queue.push(j);
                    }
                }
            }
        }
        clusters.count += 1;
    }
    clusters
}

fn disc(radius: f64) -> Vec<(i64, i64)> {
    let r = radius.floor() as i64;
    let inside = |(dx, dy): &(i64, i64)| ((dx * dx + dy * dy) as f64) <= radius * radius;
    (-r..=r).flat_map(|dy| (-r..=r).map(move |dx| (dx, dy))).filter(inside).collect()
}

fn neighbours<'a>(cells: &'a Mask, disc: &'a [(i64, i64)], i: usize) -> impl Iterator<Item = usize> + 'a {
    let (column, row) = ((i % cells.width()) as i64, (i / cells.width()) as i64);
    disc.iter().filter_map(move |(dx, dy)| cells.index(column + dx, row + dy)).filter(|&j| cells.bits()[j])
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;

    #[test]
    fn small_clusters_go_and_walls_stay() {
        let m = mask(&["..........", ".##.......", "..........", "##########"]);
        let kept = remove(&m, 1.0, &Clutter { radius: 1.0, min_points: 1, extent: 5.0 }).unwrap();
        assert_eq!(kept, mask(&["..........", "..........", "..........", "##########"]));
    }

    #[test]
    fn noise_is_clutter() {
        let m = mask(&["#.........", "..........", "##########"]);
        let kept = remove(&m, 1.0, &Clutter { radius: 1.0, min_points: 2, extent: 0.5 }).unwrap();
        assert_eq!(kept.count(), 10);
    }

    #[test]
    fn no_extent_keeps_everything() {
        let m = mask(&["#.#"]);
        assert_eq!(remove(&m, 1.0, &Clutter { extent: 0.0, ..Clutter::default() }), Ok(m));
    }
}
