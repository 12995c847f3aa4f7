//! The occupancy grid, as in ROS `nav_msgs/OccupancyGrid`.

use crate::{Point, Pose};
use thiserror::Error;

/// The most cells a grid may have: 2^27, about 580 m square at 0.05 m.
pub const MAX_CELLS: u64 = 1 << 27;

/// The most columns or rows a grid may have: 65536, about 3.3 km at 0.05 m.
pub const MAX_SIDE: u32 = 1 << 16;

/// The resolutions a grid may have, metres per cell. Outside of it no building is drawn, and numbers lose digits.
const RESOLUTIONS: std::ops::RangeInclusive<f64> = 1e-4..=1e3;

/// The farthest that a grid may lie from the map frame's origin, metres.
const MAX_DISTANCE: f64 = 1e9;

/// What is known of one cell: an occupancy of 0 (free) to 100 (occupied) percent, or nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(transparent)]
pub struct Cell(i8);

impl Cell {
    /// Nothing is known of the cell.
    pub const UNKNOWN: Self = Self(-1);
    /// Surely free.
    pub const FREE: Self = Self(0);
    /// Surely occupied.
    pub const OCCUPIED: Self = Self(100);

    /// A cell occupied to this many percent; more than 100 counts as 100.
    pub const fn percent(occupancy: u8) -> Self {
        Self(if occupancy > 100 { 100 } else { occupancy as i8 })
    }

    /// The cell that `nav_msgs/OccupancyGrid` writes as this number: 0 to 100, or -1 for unknown. Others mean nothing.
    ///
    /// ```
    /// # use planform_sdk::Cell;
    /// assert_eq!(Cell::of_ros(-1), Some(Cell::UNKNOWN));
    /// assert_eq!(Cell::of_ros(101), None);
    /// ```
    pub const fn of_ros(value: i8) -> Option<Self> {
        if value >= -1 && value <= 100 { Some(Self(value)) } else { None }
    }

    /// The number that `nav_msgs/OccupancyGrid` writes for this cell.
    pub const fn to_ros(self) -> i8 {
        self.0
    }

    /// Percent occupied, or `None` when unknown.
    pub const fn occupancy(self) -> Option<u8> {
        if self.0 < 0 { None } else { Some(self.0 as u8) }
    }

    /// Whether nothing is known of the cell.
    pub const fn is_unknown(self) -> bool {
        self.0 < 0
    }
}

/// An occupancy grid and its place in the map frame.
///
/// Cells are stored row by row, **row 0 at the bottom** (smallest y), column 0 at the left, as in ROS. The cell
/// (column, row) covers `[column, column + 1] x [row, row + 1]` in cell coordinates, and `origin` is the pose of the
/// cell coordinates' (0, 0), the outer corner of the lower left cell.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    width: u32,
    height: u32,
    resolution: f64,
    origin: Pose,
    cells: Vec<Cell>,
}

/// Why a grid could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum GridError {
    /// No row or no column.
    #[error("the grid has no cells ({width} x {height})")]
    Empty {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// More cells than [`MAX_CELLS`], or a side longer than [`MAX_SIDE`].
    #[error(
        "the grid is too large: {width} x {height} cells; the most are {MAX_CELLS} in all and {MAX_SIDE} a side"
    )]
    TooLarge {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// As many cells as width times height are needed.
    #[error("the grid has {found} cells where width times height is {expected}")]
    CellCount {
        /// Cells given.
        found: usize,
        /// Cells needed.
        expected: usize,
    },
    /// The resolution is no number of metres that a cell can have.
    #[error("the resolution must be a positive number of metres per cell, from 0.0001 to 1000, not {0}")]
    Resolution(f64),
    /// The origin is not a finite pose, or too far away.
    #[error("the origin must be three finite numbers of at most 1e9 m, not ({}, {}, {})", .0.x, .0.y, .0.yaw)]
    Origin(Pose),
}

impl Grid {
    /// A grid of `width` columns and `height` rows; `resolution` in metres per cell; `cells` row by row from the
    /// bottom.
    pub fn new(
        width: u32,
        height: u32,
        resolution: f64,
        origin: Pose,
        cells: Vec<Cell>,
    ) -> Result<Self, GridError> {
        let expected = Self::check_size(width, height)?;
        if cells.len() != expected {
            return Err(GridError::CellCount { found: cells.len(), expected });
        }
        if !RESOLUTIONS.contains(&resolution) {
            return Err(GridError::Resolution(resolution));
        }
        if ![origin.x, origin.y, origin.yaw].iter().all(|v| v.abs() <= MAX_DISTANCE) {
            return Err(GridError::Origin(origin));
        }
        Ok(Self { width, height, resolution, origin, cells })
    }

    /// The number of cells of a grid of this size, if it is allowed. To be asked before memory is taken.
    pub fn check_size(width: u32, height: u32) -> Result<usize, GridError> {
        let cells = u64::from(width) * u64::from(height);
        if cells == 0 {
            return Err(GridError::Empty { width, height });
        }
        if cells > MAX_CELLS || width.max(height) > MAX_SIDE {
            return Err(GridError::TooLarge { width, height });
        }
        Ok(cells as usize)
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Metres per cell.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Pose of the lower left corner of the lower left cell in the map frame.
    pub fn origin(&self) -> Pose {
        self.origin
    }

    /// All cells, row by row from the bottom.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// The cell in this column (from the left) and row (from the bottom), unknown outside the grid.
    pub fn cell(&self, column: i64, row: i64) -> Cell {
        let inside =
            (0..i64::from(self.width)).contains(&column) && (0..i64::from(self.height)).contains(&row);
        if inside { self.cells[row as usize * self.width as usize + column as usize] } else { Cell::UNKNOWN }
    }

    /// From cell coordinates to metres in the map frame.
    pub fn to_map(&self, p: Point) -> Point {
        let (sin, cos) = self.origin.yaw.sin_cos();
        let (x, y) = (p.x * self.resolution, p.y * self.resolution);
        Point::new(self.origin.x + cos * x - sin * y, self.origin.y + sin * x + cos * y)
    }

    /// From metres in the map frame to cell coordinates.
    pub fn to_cells(&self, p: Point) -> Point {
        let (sin, cos) = self.origin.yaw.sin_cos();
        let (x, y) = (p.x - self.origin.x, p.y - self.origin.y);
        Point::new((cos * x + sin * y) / self.resolution, (cos * y - sin * x) / self.resolution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn to_map_and_back() {
        let origin = Pose { x: -3.0, y: 2.0, yaw: 0.7 };
        let g = Grid::new(2, 1, 0.05, origin, vec![Cell::FREE, Cell::UNKNOWN]).unwrap();
        let p = Point::new(1.25, 0.5);
        assert!(g.to_cells(g.to_map(p)).distance(p) < 1e-9);
        assert_eq!(g.to_map(Point::new(0.0, 0.0)), Point::new(-3.0, 2.0));
    }

    #[test]
    fn outside_is_unknown() {
        let g = Grid::new(1, 1, 1.0, Pose::default(), vec![Cell::FREE]).unwrap();
        assert_eq!(g.cell(0, 0), Cell::FREE);
        assert_eq!(g.cell(-1, 0), Cell::UNKNOWN);
        assert_eq!(g.cell(0, 1), Cell::UNKNOWN);
    }

    #[test]
    fn refuses_what_makes_no_grid() {
        let bad = |w, h, r| Grid::new(w, h, r, Pose::default(), vec![Cell::FREE]).unwrap_err();
        assert!(matches!(bad(0, 1, 1.0), GridError::Empty { .. }));
        assert!(matches!(bad(60_000, 60_000, 1.0), GridError::TooLarge { .. }));
        assert!(matches!(bad(100_000, 1, 1.0), GridError::TooLarge { .. }));
        assert!(matches!(bad(1, 2, 1.0), GridError::CellCount { found: 1, expected: 2 }));
        for r in [0.0, -0.05, f64::NAN, f64::INFINITY, 1e300, 1e-300] {
            assert!(matches!(bad(1, 1, r), GridError::Resolution(_)));
        }
    }
}
