//! Finds the greys that mean unknown in a bare picture.
//!
//! Every mapping program has its own grey for unknown (205, 128, 178, 230, ...), and drawings have other greys too:
//! smoothed edges, the insides of walls, furniture. The rule that tells them apart: **unknown comes in areas that are
//! wider than any wall.**
//!
//! A grey is unknown if it is a peak of the histogram between 90 and 239, if some pixels are clearly lighter (or else
//! it is the paper), and if at least 3 percent of all pixels lie in the middle of a square of half a metre that is
//! filled with it. Several greys may be. A picture of nothing but the three greys of `map_saver` (0, 205, 254)
//! needs no such proof: its 205 is unknown.

use crate::grey::Grey;
use crate::wide;
use planform_sdk::runs::runs;
use std::ops::RangeInclusive;

/// The greys that can be unknown: darker is a wall, lighter is free.
const MIDDLE: RangeInclusive<u8> = 90..=239;
/// The least share of the pixels that lie in wide areas of an unknown grey.
const WIDE_SHARE: f64 = 0.03;
/// Half the side of the square that makes an area wide, metres: more than half of any wall's thickness.
const WIDE_RADIUS: f64 = 0.25;
/// How much lighter than unknown free space is at least.
const LIGHTER: u8 = 16;
/// The least share of the pixels that are free.
const LIGHTER_SHARE: f64 = 0.001;
/// A band ends where the histogram falls below this share of its peak.
const FOOT: f64 = 0.05;
/// The least and the largest reach of a band on either side of its peak.
const REACH: (u8, u8) = (2, 12);
/// The greys that `map_saver` writes.
const SAVED: [u8; 3] = [0, SAVED_UNKNOWN, 254];
const SAVED_UNKNOWN: u8 = 205;

/// A range of greys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Band {
    low: u8,
    high: u8,
}

impl Band {
    /// All greys that are at most `reach` away from `grey`.
    pub fn around(grey: u8, reach: u8) -> Self {
        Self { low: grey.saturating_sub(reach), high: grey.saturating_add(reach) }
    }

    /// Whether the grey lies in the range.
    pub fn contains(self, grey: u8) -> bool {
        (self.low..=self.high).contains(&grey)
    }

    /// The greys.
    pub fn greys(self) -> RangeInclusive<Grey> {
        Grey::of(self.low)..=Grey::of(self.high)
    }
}

/// The bands of greys that mean unknown, the most frequent first. `greys` are the pixels row by row; `width` is the
/// length of a row and `resolution` metres per pixel.
pub fn find(greys: &[Grey], width: usize, resolution: f64) -> Vec<Band> {
    let histogram = Histogram::of(greys);
    if histogram.is_saved() {
        return vec![Band::around(SAVED_UNKNOWN, 0)];
    }
    let least = (WIDE_SHARE * greys.len() as f64).ceil() as u64;
    let radius = ((WIDE_RADIUS / resolution).round() as u8).clamp(2, 50);
    let mut bands = histogram.peaks(least);
    bands.retain(|&band| wide::reaches(least, greys, width, radius, band));
    bands
}

/// How many pixels have each grey; the last count is of those that are transparent.
struct Histogram([u64; Grey::COUNT]);

impl Histogram {
    fn of(greys: &[Grey]) -> Self {
        let mut counts = [0; Grey::COUNT];
        for run in runs(greys) {
            counts[run[0].index()] += run.len() as u64;
        }
        Self(counts)
    }

    fn count(&self, grey: u8) -> u64 {
        self.0[usize::from(grey)]
    }

    fn sum(&self, low: u8, high: u8) -> u64 {
        (low..=high).map(|g| self.count(g)).sum()
    }

    fn is_saved(&self) -> bool {
        let saved: u64 = SAVED.iter().map(|&g| self.count(g)).sum();
        self.count(SAVED_UNKNOWN) > 0 && saved == self.sum(0, 255)
    }

    /// The bands of at least `least` pixels around the middle peaks, the highest peak first; no two overlap.
    fn peaks(&self, least: u64) -> Vec<Band> {
        let mut greys: Vec<u8> = MIDDLE.filter(|&g| self.is_peak(g)).collect();
        greys.sort_by_key(|&g| std::cmp::Reverse(self.count(g)));
        let mut bands: Vec<Band> = vec![];
        for grey in greys {
            let band = self.band(grey);
            if self.sum(band.low, band.high) >= least && !bands.iter().any(|b| b.contains(grey)) {
                bands.push(band);
            }
        }
        bands
    }

    /// Whether no neighbour is more frequent and enough pixels are clearly lighter.
    fn is_peak(&self, grey: u8) -> bool {
        let count = self.count(grey);
        let free = LIGHTER_SHARE * self.sum(0, 255) as f64;
        count > 0
            && count >= self.count(grey - 1).max(self.count(grey + 1))
            && self.sum(grey + LIGHTER, 255) as f64 >= free.max(1.0)
    }

    /// From the peak down to its feet on both sides: one grey in a drawing, a hill in a JPEG picture.
    fn band(&self, peak: u8) -> Band {
        let foot = FOOT * self.count(peak) as f64;
        let reach = |step: &dyn Fn(u8) -> u8| {
            let far = (1..=REACH.1).take_while(|&d| self.count(step(d)) as f64 >= foot).last();
            far.unwrap_or(0).max(REACH.0)
        };
        Band { low: peak - reach(&|d| peak - d), high: peak + reach(&|d| peak + d) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: usize = 100;

    /// A picture of 100 x 100 pixels, white but for these rectangles [left, top, width, height, grey].
    fn draw(rectangles: &[[usize; 5]]) -> Vec<Grey> {
        let mut pixels = vec![Grey::of(255); WIDTH * WIDTH];
        for &[left, top, width, height, grey] in rectangles {
            for y in top..top + height {
                pixels[y * WIDTH + left..][..width].fill(Grey::of(grey as u8));
            }
        }
        pixels
    }

    fn found(pixels: &[Grey]) -> Vec<Band> {
        find(pixels, WIDTH, 0.05)
    }

    /// Noise as JPEG leaves it: a hill of some greys to either side.
    fn noisy(pixels: &[Grey]) -> Vec<Grey> {
        let mut state = 1_u32;
        let mut step = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as i32 % 5 - 2
        };
        let mut blur = |grey: &Grey| (grey.index() as i32 + step() + step() + step()).clamp(0, 255) as u8;
        pixels.iter().map(|grey| Grey::of(blur(grey))).collect()
    }

    const ROOM: [usize; 5] = [30, 30, 40, 40, 255];

    #[test]
    fn any_grey_around_the_building_is_unknown() {
        for grey in [128, 153, 178, 205, 230] {
            let pixels = draw(&[[0, 0, 100, 100, grey], [28, 28, 44, 44, 0], ROOM]);
            assert_eq!(found(&pixels), [Band::around(grey as u8, 2)]);
        }
    }

    #[test]
    fn noise_widens_the_band() {
        let pixels = noisy(&draw(&[[0, 0, 100, 100, 178], [28, 28, 44, 44, 0], ROOM]));
        let bands = found(&pixels);
        assert_eq!(bands.len(), 1, "{bands:?}");
        assert!((174..=182).all(|g| bands[0].contains(g)), "{bands:?}");
        assert!(!bands[0].contains(190) && !bands[0].contains(166), "{bands:?}");
    }

    #[test]
    fn black_and_white_has_none() {
        assert!(found(&draw(&[[0, 0, 100, 100, 0], ROOM])).is_empty());
        assert!(found(&noisy(&draw(&[[0, 0, 100, 100, 0], ROOM]))).is_empty());
        assert!(found(&draw(&[])).is_empty());
    }

    #[test]
    fn two_greys_are_both_found() {
        let pixels = draw(&[[0, 0, 100, 30, 180], [40, 40, 30, 30, 204]]);
        assert_eq!(found(&pixels), [Band::around(180, 2), Band::around(204, 2)]);
    }

    #[test]
    fn insides_of_walls_and_furniture_are_not_unknown() {
        // Walls of 0.4 m, a tenth of the picture each, and a cupboard.
        let walls = [[0, 30, 100, 8, 170], [0, 60, 100, 8, 137], [20, 80, 14, 14, 204]];
        assert!(found(&draw(&walls)).is_empty());
    }

    #[test]
    fn smoothed_edges_are_not_unknown() {
        let lines: Vec<_> = (0..50).map(|i| [2 * i, 0, 1, 100, 100 + 2 * i]).collect();
        assert!(found(&draw(&lines)).is_empty());
    }

    #[test]
    fn grey_paper_is_not_unknown() {
        assert!(found(&draw(&[[0, 0, 100, 100, 230], [30, 30, 40, 2, 0]])).is_empty());
    }

    #[test]
    fn what_map_saver_wrote_is_known_however_small() {
        let pixels = [0, 205, 254, 254].map(Grey::of);
        assert_eq!(find(&pixels, 2, 0.05), [Band::around(205, 0)]);
        assert_eq!(find(&[Grey::of(205)], 1, 0.05), [Band::around(205, 0)]);
    }
}
