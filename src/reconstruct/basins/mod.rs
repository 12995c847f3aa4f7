//! The method `basins`: free space cut into basins, basins merged to rooms by the evidence of walls, clearance and
//! shape.
//!
//! Rooms are what people divide by doors, and doors are where free space is narrow: nearly every true boundary
//! between rooms lies on a boundary between two basins of the clearance. Which of them do is decided jointly: the
//! basins are merged pair by pair, the surest first, and every merge changes the evidence on the boundaries around.

mod aligned;
pub mod clearance;
mod doors;
pub mod evidence;
pub mod explored;
pub mod hull;
mod layout;
pub mod merge;
pub mod model;
pub mod passage;
mod pockets;
pub mod regions;
mod slopes;
pub mod space;
mod stated;
pub mod watershed;
mod weights;

use super::Params;
use super::raster::Mask;
use super::shown::Shown;
use clearance::Clearance;
use passage::View;
use planform_sdk::{Cell, Grid};
use regions::Regions;
use space::Space;
use stated::{Chambers, Stated};
use std::collections::{BTreeMap, BTreeSet};
use watershed::Basins;

pub use explored::Explored;
pub use layout::reconstruct;
pub use merge::Merge;
pub use space::Furniture;

/// A map's free space cut into basins.
pub struct Cut {
    /// The free space.
    pub space: Space,
    /// Its clearance.
    pub clearance: Clearance,
    /// Its basins.
    pub basins: Basins,
    /// Metres of known door between two basins, the smaller first.
    doors: BTreeMap<(u32, u32), f64>,
    /// The basins that something is written in.
    named: BTreeSet<u32>,
    /// What the stated openings make of the basins.
    stated: Option<Stated>,
}

/// A room is at least this large, square metres.
const SMALLEST: f64 = 0.5;

/// Cells that no room owns go to the nearest one within this distance, metres.
const NEAR: f64 = 0.6;

impl Cut {
    /// Cuts the free space of a grid, if it has any.
    pub fn of_grid(grid: &Grid, params: &Params) -> Option<Self> {
        let is_free = |c: Cell| c.occupancy().is_some_and(|o| o <= params.contour.free);
        let free = Mask::of_grid(grid, is_free);
        Space::of_mask(&free, grid.resolution(), &params.furniture, &[]).map(Self::of_space)
    }

    /// Cuts a space.
    pub fn of_space(space: Space) -> Self {
        Self::of_shown(space, &Shown::default())
    }

    /// Cuts a space of which a document shows this, along its doors in any case.
    pub fn of_shown(space: Space, shown: &Shown) -> Self {
        let clearance = clearance::measure(&space);
        let chambers = shown.openings.as_ref().map(|o| Chambers::of(&space, o));
        let lines = match &chambers {
            Some(chambers) => chambers.on_line.clone(),
            None => doors::cells(&space, &shown.doors),
        };
        let mut basins = watershed::cut(&space, &clearance, &lines);
        if let Some(chambers) = &chambers {
            chambers.share_out(&space, &mut basins.label);
        }
        let doors = doors::between(&space, &basins.label, &shown.doors);
        let named = doors::under(&space, &basins.label, &shown.labels);
        let stated = chambers.map(|c| c.of_basins(&space, &basins));
        Self { space, clearance, basins, doors, named, stated }
    }

    /// One region for each basin.
    pub fn regions<'a>(&self, view: &'a View<'a>) -> Regions<'a> {
        let mut regions = Regions::of_basins(view, &self.basins);
        regions.know_doors(&self.doors);
        regions.know_names(&self.named);
        if let Some(stated) = &self.stated {
            regions.know_openings(stated);
        }
        regions
    }

    /// What the evidence is read from.
    pub fn view(&self) -> View<'_> {
        View::new(&self.space, &self.clearance)
    }

    /// The room of every cell of the space, also of cells that are not free, from 1; 0 is none.
    pub fn grown_labels(&self, regions: &Regions<'_>) -> Vec<u32> {
        let numbers = self.numbers(regions);
        let labels: Vec<u32> = self.basins.label.iter().map(|&b| numbers[b as usize]).collect();
        self.space.grown(&labels, NEAR)
    }

    /// The room of every cell of the grid, from 1; 0 is none.
    pub fn rooms(&self, regions: &Regions<'_>, grid: &Grid) -> Vec<u32> {
        let numbers = self.numbers(regions);
        self.on_grid(grid, |i| numbers[self.basins.label[i] as usize])
    }

    /// The room of every basin.
    fn numbers(&self, regions: &Regions<'_>) -> Vec<u32> {
        let mut numbers = vec![0; self.basins.count as usize + 1];
        let rooms = regions.all().filter(|(_, r)| r.area >= SMALLEST);
        for ((_, region), number) in rooms.zip(1..) {
            for &basin in &region.basins {
                numbers[basin as usize] = number;
            }
        }
        numbers
    }

    /// Values of the grid's cells brought to the cells of the space; 0 on its border.
    pub fn on_space(&self, grid: &Grid, values: &[u32]) -> Vec<u32> {
        let (space, k) = (&self.space, self.space.fineness);
        let mut out = vec![0; space.free.len()];
        for row in 1..space.height - 1 {
            for column in 1..space.width - 1 {
                let (x, y) = ((column - 1) / k + space.corner.0, (row - 1) / k + space.corner.1);
                out[row * space.width + column] = values[y * grid.width() as usize + x];
            }
        }
        out
    }

    /// Values of the space's cells brought back to the cells of the grid.
    pub fn on_grid(&self, grid: &Grid, value: impl Fn(usize) -> u32) -> Vec<u32> {
        let (space, k) = (&self.space, self.space.fineness);
        let (width, height) = (grid.width() as usize, grid.height() as usize);
        let mut out = vec![0; width * height];
        // Every cell of the grid has the value of the cell in its middle.
        let rows = (1..space.height - 1).skip(k / 2).step_by(k);
        for (row, y) in rows.zip(space.corner.1..height) {
            let cells = row * space.width + 1..(row + 1) * space.width - 1;
            let target = &mut out[y * width + space.corner.0..(y + 1) * width];
            for (o, cell) in target.iter_mut().zip(cells.skip(k / 2).step_by(k)) {
                *o = value(cell);
            }
        }
        out
    }
}
