//! A yes or no for every cell of a grid, and what the steps ask of it.

use super::runs::{Components, Parts, Run, runs};
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
        // Asked once for each value that a cell can have.
        let of_value: [bool; 256] = std::array::from_fn(|v| Cell::of_ros(v as u8 as i8).is_some_and(&is));
        let bits = grid.cells().iter().map(|c| of_value[usize::from(c.to_ros().cast_unsigned())]).collect();
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
        self.runs().flat_map(|run| (run.from..run.to).map(move |column| (column, run.row)))
    }

    /// The runs of set cells, row by row.
    pub fn runs(&self) -> impl Iterator<Item = Run> + '_ {
        runs(&self.bits, self.width, true)
    }

    /// The box around the set cells, or `None` if there are none.
    pub fn extent(&self) -> Option<Extent> {
        let ends = |run: Run| Extent { low: (run.from, run.row), high: (run.to - 1, run.row) };
        self.runs().map(ends).reduce(Extent::join)
    }

    /// Sets every cell that the other mask sets.
    pub fn or(&self, other: &Self) -> Self {
        self.with_bits(self.bits.iter().zip(&other.bits).map(|(a, b)| *a || *b).collect())
    }

    /// Unsets every cell that the other mask does not set.
    pub fn and(&self, other: &Self) -> Self {
        self.with_bits(self.bits.iter().zip(&other.bits).map(|(a, b)| *a && *b).collect())
    }

    /// The cells that have a set one straight beside them, or the outside.
    pub fn beside(&self) -> Self {
        let (width, bits) = (self.width, &self.bits);
        let mut beside = vec![false; bits.len()];
        beside[1..].iter_mut().zip(bits).for_each(|(o, b)| *o |= b);
        beside.iter_mut().zip(&bits[1..]).for_each(|(o, b)| *o |= b);
        beside[width.min(bits.len())..].iter_mut().zip(bits).for_each(|(o, b)| *o |= b);
        beside.iter_mut().zip(&bits[width.min(bits.len())..]).for_each(|(o, b)| *o |= b);
        for row in beside.chunks_exact_mut(width) {
            (row[0], row[width - 1]) = (true, true);
        }
        beside[..width].fill(true);
        beside[bits.len() - width..].fill(true);
        self.with_bits(beside)
    }

    /// Unsets every cell that the other mask sets.
    pub fn without(&self, other: &Self) -> Self {
        self.with_bits(self.bits.iter().zip(&other.bits).map(|(a, b)| *a && !b).collect())
    }

    /// The set cells and all within so many cells of them, straight ahead or over corners.
    pub fn grown(&self, reach: usize) -> Self {
        let width = self.width;
        let mut across = self.bits.clone();
        let rows = across.chunks_exact_mut(width.max(1)).zip(self.bits.chunks_exact(width.max(1)));
        for (out, row) in rows {
            for k in 1..=reach.min(width.saturating_sub(1)) {
                out[k..].iter_mut().zip(row).for_each(|(o, b)| *o |= b);
                out.iter_mut().zip(&row[k..]).for_each(|(o, b)| *o |= b);
            }
        }
        let mut bits = across.clone();
        for k in (1..=reach).map(|k| (k * width).min(across.len())) {
            bits[k..].iter_mut().zip(&across).for_each(|(o, b)| *o |= b);
            bits.iter_mut().zip(&across[k..]).for_each(|(o, b)| *o |= b);
        }
        self.with_bits(bits)
    }

    /// The connected components of the set cells. `corners` joins cells that touch at a corner.
    pub fn components(&self, corners: bool) -> Components {
        Parts::of(&self.bits, self.width, true, corners).components(self.bits.len())
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
    fn a_grown_mask_is_a_square_around_every_cell() {
        let rows = ["#......", ".......", ".......", ".....#.", "......."];
        let m = mask(&rows);
        for reach in 0..8i64 {
            let near = |c: i64, r: i64| {
                m.cells().any(|(x, y)| (x as i64 - c).abs().max((y as i64 - r).abs()) <= reach)
            };
            let grown = m.grown(reach as usize);
            assert!((0..5).all(|r| (0..7).all(|c| grown.get(c, r) == near(c, r))), "{reach}");
        }
    }

    #[test]
    fn what_is_beside_a_cell_or_the_outside() {
        assert_eq!(
            mask(&[".....", ".....", "..#..", ".....", "....."]).beside(),
            mask(&["#####", "#.#.#", "##.##", "#.#.#", "#####"])
        );
        assert_eq!(mask(&["#", "."]).beside().count(), 2);
    }

    #[test]
    fn outside_is_unset() {
        let m = mask(&["##"]);
        assert!(m.get(1, 0) && !m.get(2, 0) && !m.get(0, -1));
    }
}
