//! Walls as the cells of an occupancy grid.

use super::Walls;
use planform_sdk::Cell;

/// The cells of a grid that shows the walls: what [`Grid::new`](planform_sdk::Grid::new) asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// Columns.
    pub columns: u32,
    /// Rows.
    pub rows: u32,
    /// Metres per cell.
    pub resolution: f64,
    /// The cells, row by row from the **bottom**, as grids have them.
    pub cells: Vec<Cell>,
    /// How many pixels a cell is wide; the grid's lower left corner is that of the sheet.
    pub pixels: u32,
}

/// Cells are about this large, metres: half of the thinnest wall.
const SIZE: f64 = 0.05;

/// The most cells.
const MOST: u64 = 4_000_000;

/// The walls as cells: occupied where any pixel is, so that thin walls stay closed; unknown outside of the building.
/// A cell is a whole number of pixels wide.
pub fn cells(walls: &Walls, metres_per_pixel: f64) -> Cells {
    let (width, height) = (walls.occupied.width, walls.occupied.height);
    let mut pixels = (SIZE / metres_per_pixel).round().clamp(1.0, f64::from(width.max(1))) as u32;
    let count = |p: u32| u64::from(width.div_ceil(p)) * u64::from(height.div_ceil(p));
    while count(pixels) > MOST {
        pixels += 1;
    }
    let (columns, rows) = (width.div_ceil(pixels), height.div_ceil(pixels));
    let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let cells = cells.map(|(column, row)| cell(walls, column, row, pixels)).collect();
    Cells { columns, rows, resolution: metres_per_pixel * f64::from(pixels), cells, pixels }
}

/// The cell in this column and row, the latter from the bottom.
fn cell(walls: &Walls, column: u32, row: u32, pixels: u32) -> Cell {
    let (occupied, inside) = (&walls.occupied, &walls.inside);
    let (left, low) = (i64::from(column * pixels), i64::from(occupied.height) - i64::from(row * pixels));
    let mut within = 0;
    for y in low - i64::from(pixels)..low {
        for x in left..left + i64::from(pixels) {
            if occupied.get(x, y) {
                return Cell::OCCUPIED;
            }
            within += u32::from(inside.get(x, y));
        }
    }
    if 2 * within >= pixels * pixels { Cell::FREE } else { Cell::UNKNOWN }
}
