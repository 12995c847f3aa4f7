//! Paper told from ink.
//!
//! Where a stroke is darker than a threshold for the whole page (Otsu 1979) it is ink. A lighter stroke is
//! ink if it is dark for its surroundings: half way between paper and the darkest pixel nearby (after Bernsen
//! 1986), so that fine grey lines are kept while the soft edges of black ones do not make these thicker. How
//! light a stroke can be depends on how noisy the paper is.

use crate::mask::Mask;
use crate::rows;
use image::GrayImage;

/// The page's threshold stays between these whatever its tones are; the paper is 255.
const THRESHOLDS: [u8; 2] = [120, 190];
/// No stroke is lighter than this even on the cleanest paper.
const LIGHTEST: u8 = 222;
/// A stroke is darker than the paper by so many times the paper's noise.
const ABOVE_NOISE: f32 = 6.0;
/// A light stroke's pixel is darker than the paper by at least this share of what the darkest pixel nearby
/// is.
const SHARE: f32 = 0.5;
/// How far "nearby" is, pixels: the soft edge of a stroke is no wider.
const NEAR: usize = 3;

/// The ink of a page whose paper is evenly white.
pub fn ink(grey: &GrayImage) -> Mask {
    let counts = counts(grey);
    let page = otsu(&counts).clamp(THRESHOLDS[0], THRESHOLDS[1]);
    let noise = noise(grey);
    let lightest = (255.0 - ABOVE_NOISE * noise).clamp(f32::from(page), f32::from(LIGHTEST)) as u8;
    let limits: Vec<u8> = (0..=255u8).map(|darkest| limit(darkest, page, lightest)).collect();
    let (width, height) = (grey.width() as usize, grey.height() as usize);
    let mut mask = Mask::empty(grey.width(), grey.height());
    rows::for_each_band(&mut mask.set, width, |first, band| {
        let mut nearby = Darkest::new(grey.as_raw(), width, height);
        for (i, row) in band.chunks_exact_mut(width).enumerate() {
            let tones = &grey.as_raw()[(first + i) * width..];
            let darkest = nearby.around(first + i);
            row.iter_mut().zip(tones).zip(darkest).for_each(|((to, &t), &d)| *to = t < limits[d as usize]);
        }
    });
    mask
}

/// Below which tone a pixel is ink, when the darkest one nearby has this tone.
fn limit(darkest: u8, page: u8, lightest: u8) -> u8 {
    let local = 255.0 - SHARE * (255.0 - f32::from(darkest));
    (local as u8).clamp(page, lightest.max(page))
}

fn counts(grey: &GrayImage) -> [u64; 256] {
    let mut counts = [0; 256];
    // Every third pixel is more than enough, and its cost does not show.
    grey.as_raw().iter().step_by(3).for_each(|&t| counts[t as usize] += 1);
    counts
}

/// The threshold that parts the tones into two groups with the largest variance between them.
fn otsu(counts: &[u64; 256]) -> u8 {
    let total: u64 = counts.iter().sum();
    let sum: f64 = counts.iter().enumerate().map(|(t, &c)| t as f64 * c as f64).sum();
    let (mut below, mut below_sum, mut best, mut threshold) = (0u64, 0.0, 0.0, 128u8);
    for tone in 0..=254u8 {
        below += counts[tone as usize];
        below_sum += f64::from(tone) * counts[tone as usize] as f64;
        let above = total - below;
        if below == 0 || above == 0 {
            continue;
        }
        let apart = below_sum / below as f64 - (sum - below_sum) / above as f64;
        let between = below as f64 * above as f64 * apart * apart;
        if between > best {
            (best, threshold) = (between, tone + 1);
        }
    }
    threshold
}

/// The standard deviation of the paper's tone, from how much its pixels differ from the ones two further on.
pub fn noise(grey: &GrayImage) -> f32 {
    let mut steps = [0u64; 256];
    let paper = |t: u8| t > 200;
    let width = (grey.width() as usize).max(1);
    for row in grey.as_raw().chunks_exact(width).step_by(3) {
        let pairs = row.windows(3).filter(|w| w.iter().all(|&t| paper(t)));
        pairs.for_each(|w| steps[w[0].abs_diff(w[2]) as usize] += 1);
    }
    // Of a normal distribution's differences, 90 % are below 1.645 * sqrt(2) deviations.
    let most = steps.iter().sum::<u64>() * 9 / 10;
    let mut sum = 0;
    let reached = steps.iter().position(|&c| {
        sum += c;
        sum >= most
    });
    reached.unwrap_or(0) as f32 / 2.33
}

/// Walks down the rows and tells of every pixel the darkest one nearby.
struct Darkest<'a> {
    tones: &'a [u8],
    width: usize,
    height: usize,
    /// The last rows, each the least within `NEAR` to both sides.
    rows: Vec<(usize, Vec<u8>)>,
    least: Vec<u8>,
}

impl<'a> Darkest<'a> {
    fn new(tones: &'a [u8], width: usize, height: usize) -> Self {
        Self { tones, width, height, rows: vec![], least: vec![255; width] }
    }

    /// Rows are asked for in order.
    fn around(&mut self, y: usize) -> &[u8] {
        self.rows.retain(|r| r.0 + NEAR >= y);
        let first = self.rows.last().map_or(y.saturating_sub(NEAR), |r| r.0 + 1);
        for next in first..(y + NEAR + 1).min(self.height) {
            let row = &self.tones[next * self.width..(next + 1) * self.width];
            self.rows.push((next, rows::least_within(row, NEAR)));
        }
        self.least.fill(255);
        self.rows.iter().for_each(|(_, row)| rows::lower(&mut self.least, row));
        &self.least
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Luma;

    fn lines(tone: impl Fn(u32, u32) -> u8) -> Mask {
        ink(&GrayImage::from_fn(120, 80, |x, y| Luma([tone(x, y)])))
    }

    #[test]
    fn fine_grey_lines_and_solid_grey_walls_are_ink() {
        let mask = lines(|x, y| match (x, y) {
            (20, _) => 200,
            (40..52, _) => 128,
            (80, _) => 0,
            _ => 255,
        });
        assert!(mask.get(20, 40) && mask.get(45, 40) && mask.get(80, 40));
        assert_eq!(mask.count(), 14 * 80);
    }

    #[test]
    fn soft_edges_do_not_make_black_strokes_thicker() {
        let mask = lines(|x, _| match x {
            50..54 => 10,
            49 | 54 => 200,
            _ => 255,
        });
        assert_eq!(mask.count(), 4 * 80);
    }

    #[test]
    fn noise_is_paper() {
        let noisy = |x: u32, y: u32| 255 - ((x * 7919 + y * 104_729) % 61) as u8 / 2;
        let mask = lines(|x, y| if x == 60 { 20 } else { noisy(x, y) });
        assert_eq!(mask.count(), 80);
    }

    #[test]
    fn blank_and_empty_pages_have_no_ink() {
        assert_eq!(lines(|_, _| 255).count(), 0);
        assert_eq!(ink(&GrayImage::new(0, 0)).count(), 0);
    }
}
