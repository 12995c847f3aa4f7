//! A yes or no for every cell of a grid, and what the steps ask of it.

use planform_sdk::{Cell, Grid, Point};

/// One bit of knowledge for each cell, row by row from the bottom.
#[derive(Debug, Clone, PartialEq)]
pub struct Mask {
    width: usize,
    height: usize,
    bits: Vec<bool>,
}

impl Mask {
    /// The cells of the grid for which `is` holds.
    pub fn of_grid(grid: &Grid, is: impl Fn(Cell) -> bool) -> Self {
        let bits = grid.cells().iter().map(|&c| is(c)).collect();
        Self { width: grid.width() as usize, height: grid.height() as usize, bits }
    }

    /// A mask of this size; bits that are missing are unset.
    pub fn new(width: usize, height: usize, mut bits: Vec<bool>) -> Self {
        bits.resize(width * height, false);
        Self { width, height, bits }
    }

    /// A mask of the same size with other bits.
    pub fn with_bits(&self, bits: Vec<bool>) -> Self {
        debug_assert_eq!(bits.len(), self.bits.len());
        Self { bits, ..*self }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// All bits, row by row from the bottom.
    pub fn bits(&self) -> &[bool] {
        &self.bits
    }

    /// The bit in this column and row; `false` outside.
    pub fn get(&self, column: i64, row: i64) -> bool {
        self.index(column, row).is_some_and(|i| self.bits[i])
    }

    /// Index of a cell, or `None` outside.
    pub fn index(&self, column: i64, row: i64) -> Option<usize> {
        let inside = (0..self.width as i64).contains(&column) && (0..self.height as i64).contains(&row);
        inside.then(|| row as usize * self.width + column as usize)
    }

    /// The bit of the cell that holds the point, in cell coordinates; `false` outside.
    pub fn at(&self, p: Point) -> bool {
        self.get(p.x.floor() as i64, p.y.floor() as i64)
    }

    /// How many bits are set.
    #[cfg(test)]
    pub fn count(&self) -> usize {
        self.bits.iter().filter(|&&b| b).count()
    }

    /// The set cells as (column, row), row by row.
    pub fn cells(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.bits.iter().enumerate().filter(|(_, b)| **b).map(|(i, _)| (i % self.width, i / self.width))
    }

    /// The box around the set cells, or `None` if there are none.
    pub fn extent(&self) -> Option<Extent> {
        self.cells().map(Extent::of).reduce(Extent::join)
    }

    /// Sets every cell that the other mask sets.
    pub fn or(&self, other: &Self) -> Self {
        self.with_bits(self.bits.iter().zip(&other.bits).map(|(a, b)| *a || *b).collect())
    }

    /// Unsets every cell that the other mask sets.
    pub fn without(&self, other: &Self) -> Self {
        self.with_bits(self.bits.iter().zip(&other.bits).map(|(a, b)| *a && !b).collect())
    }

    /// The connected components of the set cells: for each cell the number of its component from 0, and for each
    /// component its size in cells. `corners` joins cells that touch at a corner.
    pub fn components(&self, corners: bool) -> Components {
        let mut label = vec![Components::NONE; self.bits.len()];
        let mut sizes = Vec::new();
        let mut queue = Vec::new();
        let steps: &[(i64, i64)] = if corners { &EIGHT } else { &EIGHT[..4] };
        for start in 0..self.bits.len() {
            if !self.bits[start] || label[start] != Components::NONE {
                continue;
            }
            let name = sizes.len() as u32;
            label[start] = name;
            queue.push(start);
            let mut size = 0;
            while let Some(i) = queue.pop() {
                size += 1;
                let (column, row) = ((i % self.width) as i64, (i / self.width) as i64);
                for (dx, dy) in steps {
                    if let Some(j) = self.index(column + dx, row + dy)
                        && self.bits[j]
                        && label[j] == Components::NONE
                    {
                        label[j] = name;
                        queue.push(j);
                    }
                }
            }
            sizes.push(size);
        }
        Components { label, sizes }
    }
}

/// A box of cells: its lowest and its highest column and row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// Lowest column and row.
    pub low: (usize, usize),
    /// Highest column and row.
    pub high: (usize, usize),
}

impl Extent {
    /// The box of one cell.
    pub fn of(cell: (usize, usize)) -> Self {
        Self { low: cell, high: cell }
    }

    /// The box around both.
    pub fn join(self, other: Self) -> Self {
        let low = (self.low.0.min(other.low.0), self.low.1.min(other.low.1));
        Self { low, high: (self.high.0.max(other.high.0), self.high.1.max(other.high.1)) }
    }

    /// Length of the diagonal, in cells.
    pub fn diagonal(self) -> f64 {
        let side = |low: usize, high: usize| (high + 1 - low) as f64;
        side(self.low.0, self.high.0).hypot(side(self.low.1, self.high.1))
    }
}

/// Steps to the four neighbours, then to the four at the corners.
const EIGHT: [(i64, i64); 8] = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1)];

/// The connected components of a mask.
#[derive(Debug, Clone, PartialEq)]
pub struct Components {
    /// For each cell the number of its component, or [`Components::NONE`].
    pub label: Vec<u32>,
    /// For each component its number of cells.
    pub sizes: Vec<usize>,
}

impl Components {
    /// The label of a cell in no component.
    pub const NONE: u32 = u32::MAX;
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use planform_sdk::Pose;

    /// A mask from a picture, the top row first; `#` is set.
    pub fn mask(rows: &[&str]) -> Mask {
        let cells = rows
            .iter()
            .rev()
            .flat_map(|r| r.bytes())
            .map(|b| if b == b'#' { Cell::OCCUPIED } else { Cell::FREE })
            .collect();
        let grid = Grid::new(rows[0].len() as u32, rows.len() as u32, 1.0, Pose::default(), cells).unwrap();
        Mask::of_grid(&grid, |c| c == Cell::OCCUPIED)
    }

    #[test]
    fn corners_join_only_when_asked() {
        let m = mask(&["#..", ".#.", "..#"]);
        assert_eq!(m.components(false).sizes, [1, 1, 1]);
        assert_eq!(m.components(true).sizes, [3]);
    }

    #[test]
    fn the_extent_is_around_all_set_cells() {
        let extent = mask(&["....", ".#..", "...#"]).extent().unwrap();
        assert_eq!((extent.low, extent.high), ((1, 0), (3, 1)));
        assert!((extent.diagonal() - 13f64.sqrt()).abs() < 1e-12);
        assert_eq!(mask(&["...."]).extent(), None);
    }

    #[test]
    fn outside_is_unset() {
        let m = mask(&["##"]);
        assert!(m.get(1, 0) && !m.get(2, 0) && !m.get(0, -1));
    }
}
