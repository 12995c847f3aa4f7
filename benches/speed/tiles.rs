//! Maps of any size: the same office floor again and again.

use crate::picture::{FREE, Picture, UNKNOWN, WALL};
use planform_sdk::{Cell, Grid};
use planform_synth::{Building, BuildingParams, ScanParams, Size};

/// The building: 16 rooms, which fit into a tile with some unknown space around them.
const SEED: u64 = 15;

/// Columns and rows of a tile: 0.2 megapixels.
const TILE: (usize, usize) = (500, 400);

/// Side of a cell, metres.
pub const RESOLUTION: f64 = 0.05;

/// The map that a robot made of the building.
pub fn building() -> Grid {
    let building = Building::generate(SEED, &BuildingParams::of_size(Size::Office));
    let scan = ScanParams { seed: SEED, resolution: RESOLUTION, ..ScanParams::default() };
    building.scan(&scan).unwrap().grid
}

/// So many columns and rows of tiles.
pub fn tiled(building: &Grid, columns: usize, rows: usize) -> Picture {
    let tile = tile(building);
    let greys = (0..rows * TILE.1).flat_map(|y| row(&tile, y % TILE.1).repeat(columns)).collect();
    Picture { width: columns * TILE.0, height: rows * TILE.1, greys }
}

fn tile(building: &Grid) -> Picture {
    let (width, height) = (building.width() as usize, building.height() as usize);
    assert!(width <= TILE.0 && height <= TILE.1, "the building of {width} x {height} cells fits no tile");
    let (left, top) = ((TILE.0 - width) / 2, (TILE.1 - height) / 2);
    let mut tile = Picture::unknown(TILE.0, TILE.1);
    for (y, cells) in building.cells().chunks_exact(width).rev().enumerate() {
        let begin = (top + y) * TILE.0 + left;
        tile.greys[begin..begin + width].iter_mut().zip(cells).for_each(|(g, &c)| *g = grey(c));
    }
    tile
}

fn row(tile: &Picture, y: usize) -> &[u8] {
    &tile.greys[y * TILE.0..(y + 1) * TILE.0]
}

fn grey(cell: Cell) -> u8 {
    match cell.occupancy() {
        None => UNKNOWN,
        Some(percent) if percent >= 65 => WALL,
        Some(_) => FREE,
    }
}
