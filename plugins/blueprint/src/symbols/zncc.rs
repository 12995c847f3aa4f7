//! Normalised cross-correlation with the means subtracted (ZNCC): from -1 to 1, 1 if a part of the picture is the template
//! but for brightness and contrast, and 0 where either is blank. With the means left in, blank paper would score
//! nearly 1. The map over a whole picture is computed after J. P. Lewis, "Fast Normalized Cross-Correlation" (1995):
//! the numerator by FFT, the means and variances of the windows by summed-area tables.

use super::soft::Soft;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

/// Windows of less variance than this, per pixel, are blank.
const LEAST_VARIANCE: f64 = 1e-4;

/// The score of two pictures of the same size.
pub fn score(a: &[f32], b: &[f32]) -> f64 {
    let n = a.len().min(b.len()) as f64;
    let mean = |v: &[f32]| v.iter().map(|&x| f64::from(x)).sum::<f64>() / n;
    let (ma, mb) = (mean(a), mean(b));
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for (&x, &y) in a.iter().zip(b) {
        let (x, y) = (f64::from(x) - ma, f64::from(y) - mb);
        ab += x * y;
        aa += x * x;
        bb += y * y;
    }
    if aa.min(bb) < LEAST_VARIANCE * n { 0.0 } else { ab / (aa * bb).sqrt() }
}

/// A picture made ready to be searched for many templates.
pub struct Searched {
    picture_width: usize,
    picture_height: usize,
    width: usize,
    height: usize,
    spectrum: Vec<Complex<f32>>,
    sums: Vec<f64>,
    squares: Vec<f64>,
    rows: [Arc<dyn Fft<f32>>; 2],
    columns: [Arc<dyn Fft<f32>>; 2],
}

impl Searched {
    /// Makes a picture ready; templates will be at most `largest` pixels wide or high.
    pub fn new(picture: &Soft, largest: u32) -> Self {
        let (w, h) = (picture.width as usize, picture.height as usize);
        let (width, height) = (fast_length(w + largest as usize), fast_length(h + largest as usize));
        let mut planner = FftPlanner::new();
        let rows = [planner.plan_fft_forward(width), planner.plan_fft_inverse(width)];
        let columns = [planner.plan_fft_forward(height), planner.plan_fft_inverse(height)];
        let mut it = Self {
            picture_width: w,
            picture_height: h,
            width,
            height,
            spectrum: Vec::new(),
            sums: table(picture, |v| v),
            squares: table(picture, |v| v * v),
            rows,
            columns,
        };
        it.spectrum = it.transformed(picture, 0.0);
        it
    }

    /// The score of the template at every place that holds it whole: column and row are those of its upper left pixel.
    pub fn scores(&self, template: &Soft) -> Soft {
        let n = template.values.len() as f64;
        let mean = template.values.iter().map(|&v| f64::from(v)).sum::<f64>() / n;
        let spread: f64 = template.values.iter().map(|&v| (f64::from(v) - mean).powi(2)).sum();
        let product = self.correlated(template, mean as f32);
        let places = |all: usize, own: u32| (all + 1).saturating_sub(own as usize) as u32;
        let (w, h) =
            (places(self.picture_width, template.width), places(self.picture_height, template.height));
        Soft::from_fn(w, h, |x, y| {
            let window = [x, y, template.width, template.height].map(|v| v as usize);
            let (sum, square) = (self.sum(&self.sums, window), self.sum(&self.squares, window));
            let variance = square - sum * sum / n;
            let blank = variance.min(spread) < LEAST_VARIANCE * n;
            let numerator = f64::from(product[y as usize * self.width + x as usize].re);
            if blank { 0.0 } else { (numerator / (variance * spread).sqrt()) as f32 }
        })
    }

    fn correlated(&self, template: &Soft, mean: f32) -> Vec<Complex<f32>> {
        let mut product = self.transformed(template, mean);
        let scale = 1.0 / (self.width * self.height) as f32;
        product.iter_mut().zip(&self.spectrum).for_each(|(t, s)| *t = s * t.conj() * scale);
        // The picture's spectrum lies transposed, so the way back begins with the columns.
        self.columns[1].process(&mut product);
        let mut product = transposed(&product, self.height, self.width);
        self.rows[1].process(&mut product);
        product
    }

    fn transformed(&self, picture: &Soft, mean: f32) -> Vec<Complex<f32>> {
        let mut values = vec![Complex::default(); self.width * self.height];
        let rows = picture.values.chunks_exact(picture.width.max(1) as usize);
        for (to, from) in values.chunks_exact_mut(self.width).zip(rows) {
            to.iter_mut().zip(from).for_each(|(t, &f)| t.re = f - mean);
        }
        self.rows[0].process(&mut values);
        let mut values = transposed(&values, self.width, self.height);
        self.columns[0].process(&mut values);
        values
    }

    fn sum(&self, table: &[f64], [x, y, w, h]: [usize; 4]) -> f64 {
        let at = |x: usize, y: usize| table[y * (self.picture_width + 1) + x];
        at(x + w, y + h) - at(x, y + h) - at(x + w, y) + at(x, y)
    }
}

/// Sums over all rectangles that begin at the upper left corner.
fn table(picture: &Soft, f: fn(f64) -> f64) -> Vec<f64> {
    let (w, h) = (picture.width as usize, picture.height as usize);
    let mut sums = vec![0.0; (w + 1) * (h + 1)];
    for y in 0..h {
        let mut row = 0.0;
        for x in 0..w {
            row += f(f64::from(picture.values[y * w + x]));
            sums[(y + 1) * (w + 1) + x + 1] = sums[y * (w + 1) + x + 1] + row;
        }
    }
    sums
}

fn transposed(values: &[Complex<f32>], width: usize, height: usize) -> Vec<Complex<f32>> {
    const TILE: usize = 32;
    let mut out = vec![Complex::default(); values.len()];
    for top in (0..height).step_by(TILE) {
        for left in (0..width).step_by(TILE) {
            for y in top..(top + TILE).min(height) {
                for x in left..(left + TILE).min(width) {
                    out[x * height + y] = values[y * width + x];
                }
            }
        }
    }
    out
}

/// The next length with no prime factor above 5, for which the transform is quick.
fn fast_length(least: usize) -> usize {
    let smooth = |mut n: usize| {
        for p in [2, 3, 5] {
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        n == 1
    };
    (least.max(1)..).find(|&n| smooth(n)).unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(width: u32, height: u32) -> Soft {
        Soft::from_fn(width, height, |x, y| ((x * 7919 + y * 104_729 + x * y * 31) % 97) as f32 / 97.0)
    }

    fn window(s: &Soft, x: u32, y: u32, w: u32, h: u32) -> Vec<f32> {
        Soft::from_fn(w, h, |i, j| s.get(i64::from(x + i), i64::from(y + j))).values
    }

    #[test]
    fn the_quick_way_equals_the_direct_one() {
        let (picture, template) = (noise(61, 47), noise(9, 12));
        let scores = Searched::new(&picture, 12).scores(&template);
        assert_eq!((scores.width, scores.height), (53, 36));
        for (x, y) in [(0, 0), (52, 35), (17, 3), (30, 30)] {
            let direct = score(&window(&picture, x, y, 9, 12), &template.values);
            let quick = f64::from(scores.get(i64::from(x), i64::from(y)));
            assert!((direct - quick).abs() < 1e-4, "{x} {y}: {direct} {quick}");
        }
    }

    #[test]
    fn a_part_of_the_picture_scores_one_whatever_its_contrast() {
        let picture = noise(40, 40);
        let mut values = window(&picture, 11, 23, 8, 8);
        values.iter_mut().for_each(|v| *v = 0.25 * *v + 0.5);
        let scores = Searched::new(&picture, 8).scores(&Soft { width: 8, height: 8, values });
        assert!((scores.get(11, 23) - 1.0).abs() < 1e-3);
        assert!(scores.values.iter().filter(|&&s| s > 0.9).count() == 1);
    }

    #[test]
    fn blank_paper_scores_nothing() {
        let blank = Soft::from_fn(30, 30, |_, _| 0.9);
        assert!(Searched::new(&blank, 8).scores(&noise(8, 8)).values.iter().all(|&s| s == 0.0));
        assert_eq!(score(&[0.9; 64], &noise(8, 8).values), 0.0);
    }

    #[test]
    fn a_template_larger_than_the_picture_fits_nowhere() {
        assert!(Searched::new(&noise(5, 5), 8).scores(&noise(8, 8)).values.is_empty());
    }
}
