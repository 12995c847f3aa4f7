//! A grid as it comes out of a figure that was made smaller.

use planform_sdk::{Cell, Grid, GridError, Pose};

/// From this percentage on a cell shows whatever else is in its square.
const OCCUPIED: u8 = 50;

/// The grid with `factor` by `factor` cells made one: free when all of them are, occupied when one of them is, else
/// unknown. So walls grow and doors shrink, as they do in a figure. A factor of 0 counts as 1; a strip that is
/// narrower than the factor on the right or on top is left out.
///
/// # Errors
/// When not one whole cell is left.
pub fn shrunk(grid: &Grid, factor: u32) -> Result<Grid, GridError> {
    let factor = factor.max(1);
    let (width, height) = (grid.width() / factor, grid.height() / factor);
    let mut cells = Vec::with_capacity(width as usize * height as usize);
    for row in 0..height {
        cells.extend((0..width).map(|column| merged(grid, factor, column, row)));
    }
    let Pose { x, y, yaw } = grid.origin();
    Grid::new(width, height, grid.resolution() * f64::from(factor), Pose { x, y, yaw }, cells)
}

fn merged(grid: &Grid, factor: u32, column: u32, row: u32) -> Cell {
    let part = |i: u32, d: u32| i64::from(i * factor + d);
    let cell = |dx, dy| grid.cell(part(column, dx), part(row, dy)).occupancy();
    let cells = || (0..factor).flat_map(|dy| (0..factor).map(move |dx| cell(dx, dy)));
    let worst = cells().flatten().max().unwrap_or(0);
    let known = cells().all(|c| c.is_some());
    if known || worst >= OCCUPIED { Cell::percent(worst) } else { Cell::UNKNOWN }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bad_cell_spoils_its_square() {
        let mut cells = vec![Cell::FREE; 6 * 4];
        cells[0] = Cell::OCCUPIED;
        cells[1] = Cell::UNKNOWN;
        cells[3] = Cell::UNKNOWN;
        let grid = Grid::new(6, 4, 0.1, Pose::default(), cells).unwrap();
        let small = shrunk(&grid, 2).unwrap();
        assert_eq!((small.width(), small.height(), small.resolution()), (3, 2, 0.2));
        assert_eq!(small.cells()[..3], [Cell::OCCUPIED, Cell::UNKNOWN, Cell::FREE]);
        assert_eq!(small.cells()[3..], [Cell::FREE; 3]);
        assert!(shrunk(&grid, 9).is_err());
    }
}
