//! Maps with their truth for training: any building, seen by any robot or drawn by hand, at any resolution.

use crate::building::Building;
use crate::params::BuildingParams;
use crate::raster::{Labels, Outline};
use crate::rng::Rng;
use crate::scan_params::ScanParams;
use crate::shrink::shrunk;
use planform_sdk::{Grid, GridError, Layout, Point, Pose};

/// A map and what is true of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The map.
    pub grid: Grid,
    /// The room of every cell of the map, up to the middle of the walls.
    pub labels: Labels,
    /// The layout in the map's frame.
    pub layout: Layout,
}

/// How the map comes about.
struct Making {
    /// Whether it is the exact raster and not a robot's map.
    exact: bool,
    resolution: f64,
    shrink: u32,
    /// By this factor the map's scale is wrong, as it is where nobody wrote it down.
    stretch: f64,
}

impl Making {
    fn draw(seed: u64) -> Self {
        let mut rng = Rng::new(seed, 202);
        let exact = rng.chance(0.5);
        let (resolution, shrink) = match rng.index(10) {
            0 | 1 => (0.05, 3 + rng.index(4) as u32),
            2 => (0.07, 1),
            3 => (0.1, 1),
            _ => (0.05, 1),
        };
        let stretch = if shrink == 1 { rng.range((0.8, 1.35)) } else { 1.0 };
        Self { exact, resolution, shrink, stretch }
    }
}

impl Sample {
    /// The sample of this seed, of a [varied building](BuildingParams::varied).
    ///
    /// # Errors
    /// When a building is too large for a grid, which none of this crate is.
    pub fn draw(seed: u64) -> Result<Self, GridError> {
        let building = Building::generate(seed, &BuildingParams::varied(seed));
        let Making { exact, resolution, shrink, stretch } = Making::draw(seed);
        let grid = if exact {
            building.clean_grid(resolution)?
        } else {
            building.scan(&ScanParams { resolution, ..ScanParams::varied(seed) })?.grid
        };
        let labels = building.labels(resolution, Outline::Centre)?.shrunk(shrink);
        let grid = stretched(&shrunk(&grid, shrink)?, stretch)?;
        Ok(Self { grid, labels, layout: stretched_layout(building.layout(), stretch) })
    }
}

fn stretched(grid: &Grid, factor: f64) -> Result<Grid, GridError> {
    let Pose { x, y, yaw } = grid.origin();
    let origin = Pose { x: x * factor, y: y * factor, yaw };
    Grid::new(grid.width(), grid.height(), grid.resolution() * factor, origin, grid.cells().to_vec())
}

fn stretched_layout(layout: &Layout, factor: f64) -> Layout {
    let mut layout = layout.clone();
    let stretch = |p: &mut Point| *p = Point::new(p.x * factor, p.y * factor);
    for polygon in layout.rooms.iter_mut().flat_map(|r| [&mut r.inner, &mut r.centre]) {
        polygon.exterior.iter_mut().chain(polygon.holes.iter_mut().flatten()).for_each(stretch);
    }
    for wall in &mut layout.walls {
        [&mut wall.line.a, &mut wall.line.b].into_iter().for_each(stretch);
        wall.thickness *= factor;
    }
    let segments = layout.openings.iter_mut().map(|o| &mut o.segment);
    segments.flat_map(|s| [&mut s.a, &mut s.b]).for_each(stretch);
    layout
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Cell;

    #[test]
    fn the_seed_decides() {
        assert_eq!(Sample::draw(6).unwrap(), Sample::draw(6).unwrap());
        assert_ne!(Sample::draw(6).unwrap().grid, Sample::draw(7).unwrap().grid);
    }

    #[test]
    fn every_way_of_making_a_map_is_drawn() {
        let all: Vec<Making> = (0..60).map(Making::draw).collect();
        assert!(all.iter().any(|m| m.exact) && all.iter().any(|m| !m.exact));
        assert!(all.iter().any(|m| m.shrink > 1) && all.iter().any(|m| m.resolution > 0.09));
        assert!(all.iter().any(|m| m.stretch < 0.9) && all.iter().any(|m| m.stretch > 1.2));
    }

    #[test]
    fn layout_labels_and_grid_agree() {
        for seed in 0..6 {
            let Sample { grid, labels, layout } = Sample::draw(seed).unwrap();
            assert_eq!((grid.width(), grid.height()), (labels.width, labels.height));
            let (mut inside, mut same, mut free) = (0, 0, 0);
            for row in (0..grid.height()).step_by(9) {
                for column in (0..grid.width()).step_by(9) {
                    let i = (row * grid.width() + column) as usize;
                    let p = grid.to_map(Point::new(f64::from(column) + 0.5, f64::from(row) + 0.5));
                    let Some(room) = layout.rooms.iter().find(|r| r.inner.contains(p)) else { continue };
                    inside += 1;
                    same += usize::from(labels.rooms[i] == room.id);
                    free += usize::from(grid.cells()[i] == Cell::FREE);
                }
            }
            assert!(same * 100 >= inside * 97 && free * 10 > inside, "seed {seed}: {inside} {same} {free}");
        }
    }
}
