//! The drawing that walls are looked for in, as fine as the work needs it.

use super::distance;
use crate::mask::Mask;

/// Pixels are made no larger than this, metres: a thin wall is to be some of them wide.
const COARSEST: f64 = 0.03;

/// The most pixels.
const MOST: usize = 12_000_000;

/// Ink, and how large it is drawn.
pub struct Drawing {
    /// The ink, row by row from the top.
    pub ink: Vec<bool>,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Pixels per metre.
    pub metre: f64,
    /// How many pixels of the sheet one of these is wide.
    pub factor: usize,
}

impl Drawing {
    /// The drawing of a sheet of this scale. A pixel is ink where any of the sheet's is.
    pub fn of_sheet(ink: &Mask, metres_per_pixel: f64) -> Self {
        let fine = (COARSEST / metres_per_pixel).clamp(1.0, 1e4) as usize;
        let factor = (fine..).find(|f| ink.set.len() / (f * f) <= MOST).unwrap_or(fine);
        let columns = (ink.width as usize).div_ceil(factor);
        let rows = (ink.height as usize).div_ceil(factor);
        let metre = 1.0 / (metres_per_pixel * factor as f64);
        Self { ink: coarser(ink, factor), width: columns, height: rows, metre, factor }
    }

    /// What is set on the sheet, of which this is the drawing, as one flag for every pixel of the drawing.
    pub fn of_mask(&self, set: &Mask) -> Vec<bool> {
        coarser(set, self.factor)
    }

    /// A mask of the sheet's size out of one flag for every pixel of the drawing.
    pub fn on_sheet(&self, set: &[bool], like: &Mask) -> Mask {
        let mut out = Mask::empty(like.width, like.height);
        let width = like.width.max(1) as usize;
        for (y, row) in out.set.chunks_mut(width).enumerate() {
            let line = &set[y / self.factor * self.width..][..self.width];
            row.iter_mut().enumerate().for_each(|(x, o)| *o = line[x / self.factor]);
        }
        out
    }

    /// The pixel at a place on the sheet, if it lies on the drawing.
    pub fn at_sheet(&self, place: [f64; 2]) -> Option<usize> {
        self.at(place.map(|c| c / self.factor as f64))
    }

    /// The pixel at a place on the drawing, if it lies there.
    pub fn at(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64;
        inside.then(|| y as usize * self.width + x as usize)
    }

    /// Whether there is ink at a place on the drawing.
    pub fn has_ink(&self, place: [f64; 2]) -> bool {
        self.at(place).is_some_and(|i| self.ink[i])
    }

    /// How far every pixel of paper is from ink: squared, pixels.
    pub fn paper(&self) -> Vec<u32> {
        let paper: Vec<bool> = self.ink.iter().map(|i| !i).collect();
        distance::squared(&paper, self.width)
    }

    /// Whether the pixel lies on the drawing's edge.
    pub fn is_edge(&self, at: usize) -> bool {
        let (x, y) = (at % self.width, at / self.width);
        x == 0 || y == 0 || x + 1 == self.width || y + 1 == self.height
    }

    /// The pixels to the right of this one and below it.
    pub fn after(&self, at: usize) -> impl Iterator<Item = usize> + use<> {
        let right = (at % self.width + 1 < self.width).then_some(at + 1);
        let below = (at / self.width + 1 < self.height).then_some(at + self.width);
        right.into_iter().chain(below)
    }
}

/// One flag for so many pixels either way: whether any of them is set.
fn coarser(mask: &Mask, factor: usize) -> Vec<bool> {
    let columns = (mask.width as usize).div_ceil(factor);
    let mut out = vec![false; columns * (mask.height as usize).div_ceil(factor)];
    for (y, row) in mask.set.chunks(mask.width.max(1) as usize).enumerate() {
        let line = &mut out[y / factor * columns..][..columns];
        row.iter().enumerate().for_each(|(x, &i)| line[x / factor] |= i);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fine_sheets_are_made_coarser_and_keep_thin_lines() {
        let mut ink = Mask::empty(13, 5);
        ink.set[2 * 13 + 7] = true;
        let drawing = Drawing::of_sheet(&ink, 0.01);
        assert_eq!((drawing.width, drawing.height, drawing.factor), (5, 2, 3));
        assert!((drawing.metre - 100.0 / 3.0).abs() < 1e-9);
        let back = drawing.on_sheet(&drawing.ink, &ink);
        assert!(back.get(7, 2) && back.get(6, 0) && !back.get(5, 2) && !back.get(7, 3));
        assert_eq!(back.count(), 9);
    }

    #[test]
    fn coarse_sheets_stay_as_they_are() {
        assert_eq!(Drawing::of_sheet(&Mask::empty(7, 5), 0.15).factor, 1);
    }
}
