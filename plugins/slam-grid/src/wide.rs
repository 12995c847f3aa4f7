//! Whether pixels of a band of greys lie in areas that are wider than any wall.

use crate::grey::Grey;
use crate::unknown_grey::Band;
use planform_sdk::runs::leading;
use std::ops::Range;

/// Whether at least `least` pixels lie in the middle of a square, cut off at the picture's border, that the band fills.
/// `greys` are rows of this width, and the square reaches `radius` pixels, at most 100, to each side of its middle.
/// Looks no further than it has to.
pub fn reaches(least: u64, greys: &[Grey], width: usize, radius: u8, band: Band) -> bool {
    let mut columns = Columns::new(width, radius);
    let of_picture = greys.chunks(width).any(|row| {
        columns.add(row, band);
        columns.middles >= least
    });
    // Beyond the border all is filled.
    of_picture
        || (0..radius).any(|_| {
            columns.grow(0..width);
            columns.middles >= least
        })
}

/// What is known of a picture's columns above some row.
struct Columns {
    radius: u8,
    /// How many rows up to here are filled to both sides, 255 standing for all numbers from there on: beyond the border
    /// all rows are.
    filled: Vec<u8>,
    /// How many squares ended so far.
    middles: u64,
}

impl Columns {
    fn new(width: usize, radius: u8) -> Self {
        Self { radius, filled: vec![radius; width], middles: 0 }
    }

    /// Goes on to this row.
    fn add(&mut self, row: &[Grey], band: Band) {
        let greys = band.greys();
        let (mut from, mut known) = (0, 0);
        while from < row.len() {
            let start = from + leading(&row[from..], |grey| !greys.contains(grey));
            from = start + leading(&row[start..], |grey| greys.contains(grey));
            let inner = self.inner(start..from, row.len());
            if !inner.is_empty() {
                self.filled[known..inner.start].fill(0);
                known = inner.end;
                self.grow(inner);
            }
        }
        self.filled[known..].fill(0);
    }

    /// The part of a run of pixels that is far enough from both its ends; at the picture's border it does not end.
    fn inner(&self, run: Range<usize>, width: usize) -> Range<usize> {
        let radius = usize::from(self.radius);
        let start = if run.start == 0 { 0 } else { run.start + radius };
        let end = if run.end == width { width } else { run.end.saturating_sub(radius) };
        start..end
    }

    /// One more row of these columns is filled to both sides.
    fn grow(&mut self, columns: Range<usize>) {
        let side = 2 * self.radius + 1;
        // In parts whose count fits a byte, which is the width of what is counted.
        for part in self.filled[columns].chunks_mut(usize::from(u8::MAX)) {
            let mut middles = 0_u8;
            for filled in part {
                *filled = filled.saturating_add(1);
                middles += u8::from(*filled >= side);
            }
            self.middles += u64::from(middles);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The same by looking at every pixel of every square.
    fn middles(greys: &[Grey], width: usize, radius: u8, band: Band) -> u64 {
        let (height, radius) = (greys.len() / width, usize::from(radius));
        let around = |at: usize, end: usize| at.saturating_sub(radius)..(at + radius + 1).min(end);
        let is_in = |x: usize, y: usize| greys[y * width + x].shade().is_some_and(|g| band.contains(g));
        let is_middle =
            |i: &usize| around(i / width, height).all(|y| around(i % width, width).all(|x| is_in(x, y)));
        (0..greys.len()).filter(is_middle).count() as u64
    }

    fn exactly(count: u64, greys: &[Grey], width: usize, radius: u8, band: Band) -> bool {
        reaches(count, greys, width, radius, band) && !reaches(count + 1, greys, width, radius, band)
    }

    #[test]
    fn squares_are_cut_off_at_the_border() {
        let band = Band::around(100, 0);
        assert!(exactly(12, &[Grey::of(100); 12], 4, 2, band));
        let mut greys = [Grey::of(100); 49];
        greys[24] = Grey::CLEAR;
        // Around the gap in the middle of 7 x 7, a square of 5 x 5 has a filled square no more.
        assert!(exactly(49 - 25, &greys, 7, 2, band));
        assert!(exactly(0, &greys, 7, 50, band));
    }

    #[test]
    fn large_areas_are_counted_to_the_last_pixel() {
        let greys = vec![Grey::of(205); 700 * 300];
        assert!(exactly(700 * 300, &greys, 700, 5, Band::around(205, 2)));
    }

    proptest! {
        #[test]
        fn as_many_as_squares_are_filled(
            gaps in proptest::collection::vec((0..600_usize, any::<bool>()), 0..12),
            width in 1..40_usize,
            radius in 0..5_u8,
        ) {
            let mut greys = vec![Grey::of(205); 600 / width * width];
            for (at, clear) in gaps {
                let at = at % greys.len();
                greys[at] = if clear { Grey::CLEAR } else { Grey::of(90) };
            }
            let band = Band::around(205, 3);
            prop_assert!(exactly(middles(&greys, width, radius, band), &greys, width, radius, band));
        }
    }
}
