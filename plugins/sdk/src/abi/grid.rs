//! A grid as it crosses.

use super::PlanformGrid;
use crate::Grid;

impl PlanformGrid {
    /// The grid, to be used as long as it lives: the cells are not copied.
    pub fn of(grid: &Grid) -> Self {
        let origin = grid.origin();
        Self {
            size: size_of::<Self>(),
            width: grid.width(),
            height: grid.height(),
            resolution: grid.resolution(),
            origin_x: origin.x,
            origin_y: origin.y,
            origin_yaw: origin.yaw,
            // A cell is an i8 and nothing else.
            cells: grid.cells().as_ptr().cast(),
            cell_count: grid.cells().len(),
        }
    }
}
