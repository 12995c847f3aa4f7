//! Ink that lies together, seen through a coarse grid of cells.

use super::morphology;
use crate::mask::Mask;

/// Cells along a sheet's longer side.
const CELLS: u32 = 400;

/// A sheet's ink by cells: a cell is set where there is any.
pub struct Cells {
    /// Pixels along a cell's side.
    pub side: usize,
    /// The cells.
    pub set: Mask,
}

/// Columns or rows from the first to the last, both included.
pub type Span = [usize; 2];

/// Cells that lie together.
#[derive(Debug, Clone)]
pub struct Cluster {
    /// Their columns.
    pub columns: Span,
    /// Their rows.
    pub rows: Span,
    /// Their numbers, row by row.
    pub cells: Vec<usize>,
}

impl Cells {
    /// The cells of a sheet.
    pub fn of(ink: &Mask) -> Self {
        let side = ink.width.max(ink.height).div_ceil(CELLS).max(1);
        let mut set = Mask::empty(ink.width.div_ceil(side), ink.height.div_ceil(side));
        let (side, columns) = (side as usize, set.width as usize);
        for (y, row) in ink.set.chunks_exact((ink.width as usize).max(1)).enumerate() {
            let cells = &mut set.set[y / side * columns..][..columns];
            row.chunks(side).zip(cells).for_each(|(pixels, cell)| *cell |= pixels.contains(&true));
        }
        Self { side, set }
    }

    /// The clusters of cells with at most `2 * reach` empty ones between them, in the order of their first
    /// cells.
    pub fn clusters(&self, reach: u32) -> Vec<Cluster> {
        let width = self.set.width as usize;
        let mut open = morphology::grown(&self.set, reach);
        let mut clusters = vec![];
        for start in 0..open.set.len() {
            if open.set[start] {
                let cells = flood(&mut open, start).into_iter().filter(|&c| self.set.set[c]).collect();
                clusters.extend(Cluster::new(cells, width));
            }
        }
        clusters
    }
}

impl Cluster {
    fn new(mut cells: Vec<usize>, width: usize) -> Option<Self> {
        cells.sort_unstable();
        let span = |place: &dyn Fn(usize) -> usize| -> Option<Span> {
            Some([cells.iter().map(|&c| place(c)).min()?, cells.iter().map(|&c| place(c)).max()?])
        };
        Some(Self { columns: span(&|c| c % width)?, rows: span(&|c| c / width)?, cells })
    }

    /// Extent along the columns and along the rows, in cells.
    pub fn size(&self) -> [usize; 2] {
        [self.columns[1] - self.columns[0] + 1, self.rows[1] - self.rows[0] + 1]
    }

    /// Cells within its bounding box.
    pub fn area(&self) -> usize {
        self.size().iter().product()
    }

    /// Whether the other's bounding box lies within this one's, at least `margin` cells from its sides.
    pub fn encloses(&self, other: &Self, margin: usize) -> bool {
        let within = |o: Span, i: Span| i[0] >= o[0] + margin && i[1] + margin <= o[1];
        within(self.columns, other.columns) && within(self.rows, other.rows)
    }

    /// Whether the bounding boxes have nothing in common.
    pub fn is_beside(&self, other: &Self) -> bool {
        let apart = |a: Span, b: Span| a[1] < b[0] || b[1] < a[0];
        apart(self.columns, other.columns) || apart(self.rows, other.rows)
    }

    /// Its own cells in a mask of its bounding box.
    pub fn mask(&self, width: usize) -> Mask {
        let [w, h] = self.size();
        let mut mask = Mask::empty(w as u32, h as u32);
        for &cell in &self.cells {
            mask.set[(cell / width - self.rows[0]) * w + cell % width - self.columns[0]] = true;
        }
        mask
    }
}

/// Takes a connected part off a mask, and returns its places.
pub fn flood(open: &mut Mask, start: usize) -> Vec<usize> {
    let (width, height) = (open.width as usize, open.height as usize);
    open.set[start] = false;
    let mut part = vec![start];
    let mut next = 0;
    while let Some(&place) = part.get(next) {
        next += 1;
        let (x, y) = (place % width, place / width);
        let near = [(x > 0, 1, 0), (x + 1 < width, 0, 1), (y > 0, width, 0), (y + 1 < height, 0, width)];
        for (inside, less, more) in near {
            if inside && open.set[place + more - less] {
                open.set[place + more - less] = false;
                part.push(place + more - less);
            }
        }
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_is_one_cluster() {
        let mut ink = Mask::empty(100, 60);
        [(10, 10), (13, 10), (40, 50)].into_iter().for_each(|(x, y)| ink.set[y * 100 + x] = true);
        let clusters = Cells::of(&ink).clusters(1);
        assert_eq!(clusters.len(), 2);
        assert_eq!((clusters[0].columns, clusters[0].rows), ([10, 13], [10, 10]));
        assert!(clusters[0].is_beside(&clusters[1]));
        assert!(Cells::of(&Mask::empty(0, 0)).clusters(1).is_empty());
    }
}
