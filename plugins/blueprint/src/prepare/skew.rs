//! By how much a page lies askew.
//!
//! Edges of strokes that run nearly along the page's sides are projected in the direction of a tried angle;
//! at the right one the edges of every straight stroke fall into one place. The sum of squares of what falls
//! into each place is largest there (Postl, "Detection of linear oblique structures and skew scan in
//! digitized documents", 1986). Both families of strokes, along and across, are projected at once.

use crate::rows;
use image::GrayImage;

/// The page is looked at with about this many pixels along its longer side.
const LOOKED_AT: u32 = 1600;
/// The largest skew that is looked for, degrees. Beyond, it may as well be the building that is turned.
const MOST: f64 = 10.0;
/// Smaller skews are left alone, degrees.
const LEAST: f64 = 0.05;
/// A stroke's edge is at least this steep, grey levels per two pixels.
const STEEP: f32 = 40.0;
/// An edge runs along the page's sides if it departs from them by less than this slope.
const SLOPE: f32 = 0.35;
/// More edges than this tell nothing more.
const ENOUGH: usize = 120_000;
/// With fewer nothing is certain.
const TOO_FEW: usize = 200;
/// A page is turned only if its strokes fall together better then, by this factor.
const BETTER: f64 = 1.03;
/// The best angle's score is at least this many times the usual one, or the page has no direction.
const CLEAR: f64 = 1.25;
/// A page on which strokes along its sides stand out by this share of the most is not askew: the building has
/// several directions.
const UPRIGHT: f64 = 0.4;
/// Directions closer than this, degrees, are one.
const SAME: f64 = 0.75;

/// The angle of the page's strokes against its sides, radians clockwise as seen; 0 if they are upright or not
/// sure.
pub fn skew(grey: &GrayImage) -> f64 {
    let edges = Edges::find(grey);
    if edges.len() < TOO_FEW {
        return 0.0;
    }
    let coarse: Vec<f64> = (-80..=80).map(|i| f64::from(i) * MOST / 80.0).collect();
    let scores = edges.scores(&coarse, 2.0);
    let Some(best) = (0..scores.len()).max_by(|&a, &b| scores[a].total_cmp(&scores[b])) else { return 0.0 };
    if !is_clear(&coarse, &scores, best) {
        return 0.0;
    }
    let fine = edges.refined(edges.refined(coarse[best], 0.03, 1.0), 0.01, 1.0);
    let [upright, askew] = [0.0, fine].map(|angle| edges.scores(&[angle], 1.0).into_iter().sum::<f64>());
    if fine.abs() < LEAST || askew < BETTER * upright { 0.0 } else { fine.to_radians() }
}

/// Whether the best angle stands out, and is not just one of the building's directions beside that of the
/// page.
fn is_clear(angles: &[f64], scores: &[f64], best: usize) -> bool {
    let mut sorted = scores.to_vec();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted[sorted.len() / 2];
    let upright =
        (0..angles.len()).filter(|&i| angles[i].abs() <= SAME / 2.0).map(|i| scores[i]).fold(0.0, f64::max);
    let shoulder = (0..angles.len())
        .filter(|&i| (SAME..SAME * 2.0).contains(&angles[i].abs()) && (angles[i] - angles[best]).abs() > SAME)
        .map(|i| scores[i])
        .fold(usual, f64::max);
    let apart = angles[best].abs() > 2.0 * SAME;
    let several = apart && upright - shoulder > UPRIGHT * (scores[best] - usual);
    scores[best] > CLEAR * usual && best > 0 && best + 1 < scores.len() && !several
}

/// Points on the edges of strokes, each with its steepness.
struct Edges {
    /// x, y, steepness, of edges along the page's width.
    along: Vec<[f32; 3]>,
    /// The same of edges along its height, x and y exchanged and turned so that both project alike.
    across: Vec<[f32; 3]>,
}

impl Edges {
    fn find(grey: &GrayImage) -> Self {
        let small = reduced(grey);
        let (middle_x, middle_y) = (small.width as f32 / 2.0, small.height() as f32 / 2.0);
        let (mut along, mut across) = (vec![], vec![]);
        for y in 1..small.height().saturating_sub(1) {
            for x in 1..small.width.saturating_sub(1) {
                let [gx, gy] = small.gradient(x, y);
                let (px, py) = (x as f32 - middle_x, y as f32 - middle_y);
                if gy.abs() > STEEP && gx.abs() < SLOPE * gy.abs() {
                    along.push([px, py, gy.abs()]);
                } else if gx.abs() > STEEP && gy.abs() < SLOPE * gx.abs() {
                    across.push([-py, px, gx.abs()]);
                }
            }
        }
        let step = (along.len() + across.len()) / ENOUGH + 1;
        let some = |all: Vec<_>| all.into_iter().step_by(step).collect();
        Self { along: some(along), across: some(across) }
    }

    fn len(&self) -> usize {
        self.along.len() + self.across.len()
    }

    /// How well the edges fall together at each of these angles, degrees, in places so many pixels wide.
    fn scores(&self, angles: &[f64], place: f32) -> Vec<f64> {
        rows::map(angles.len(), |i| {
            project(&self.along, angles[i], place) + project(&self.across, angles[i], place)
        })
    }

    /// A better angle close to this one: the best of some steps to both sides, and between them the top of a
    /// parabola.
    fn refined(&self, angle: f64, step: f64, place: f32) -> f64 {
        let angles: Vec<f64> = (-7..=7).map(|i| angle + f64::from(i) * step).collect();
        let scores = self.scores(&angles, place);
        let best = (1..scores.len() - 1).max_by(|&a, &b| scores[a].total_cmp(&scores[b])).unwrap_or(1);
        let (before, top, after) = (scores[best - 1], scores[best], scores[best + 1]);
        let bend = before - 2.0 * top + after;
        let shift = if bend < 0.0 { (before - after) / bend / 2.0 } else { 0.0 };
        angles[best] + shift.clamp(-1.0, 1.0) * step
    }
}

/// The sum of squares of the steepness that falls into each place. A point is spread over three places by a
/// quadratic spline: with less, points that lie in pixel rows would favour the page's own sides.
fn project(edges: &[[f32; 3]], angle: f64, place: f32) -> f64 {
    let (sin, cos) = angle.to_radians().sin_cos();
    let (sin, cos) = (sin as f32 / place, cos as f32 / place);
    let reach = edges.iter().map(|[x, y, _]| x.abs() + y.abs()).fold(0.0, f32::max) / place + 2.0;
    let mut places = vec![0f32; 2 * reach as usize + 4];
    for &[x, y, weight] in edges {
        let at = y * cos - x * sin + reach;
        let (first, off) = (at as usize, at.fract() - 0.5);
        let shares = [(0.5 - off) * (0.5 - off) / 2.0, 0.75 - off * off, (0.5 + off) * (0.5 + off) / 2.0];
        places[first..first + 3].iter_mut().zip(shares).for_each(|(p, share)| *p += weight * share);
    }
    places.iter().map(|&p| f64::from(p) * f64::from(p)).sum()
}

/// A picture made smaller by whole blocks of pixels.
struct Reduced {
    width: usize,
    tones: Vec<f32>,
}

impl Reduced {
    fn height(&self) -> usize {
        self.tones.len() / self.width.max(1)
    }

    /// Half of Sobel's, so that a step from black to white between two pixels is 510.
    fn gradient(&self, x: usize, y: usize) -> [f32; 2] {
        let at = |dx: usize, dy: usize| self.tones[(y + dy - 1) * self.width + x + dx - 1];
        let across = |a: usize| [at(a, 0) + 2.0 * at(a, 1) + at(a, 2), at(0, a) + 2.0 * at(1, a) + at(2, a)];
        let (before, after) = (across(0), across(2));
        [(after[0] - before[0]) / 2.0, (after[1] - before[1]) / 2.0]
    }
}

fn reduced(grey: &GrayImage) -> Reduced {
    let block = grey.width().max(grey.height()).div_ceil(LOOKED_AT).max(1) as usize;
    let (full, width, height) =
        (grey.width() as usize, grey.width() as usize / block, grey.height() as usize / block);
    let line = |y: usize| -> Vec<f32> {
        let mut sums = vec![0u32; width];
        for row in grey.as_raw()[y * block * full..].chunks_exact(full.max(1)).take(block) {
            let blocks = row.chunks_exact(block).zip(&mut sums);
            blocks.for_each(|(b, sum)| *sum += b.iter().map(|&v| u32::from(v)).sum::<u32>());
        }
        sums.into_iter().map(|s| s as f32 / (block * block) as f32).collect()
    };
    Reduced { width, tones: rows::map(height, line).concat() }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use image::Luma;

    /// Strokes of a building of rooms, turned clockwise by `degrees` about the middle, edges soft.
    pub fn building(width: u32, height: u32, degrees: f64) -> GrayImage {
        let (sin, cos) = degrees.to_radians().sin_cos();
        GrayImage::from_fn(width, height, |px, py| {
            let (dx, dy) =
                (f64::from(px) + 0.5 - f64::from(width) / 2.0, f64::from(py) + 0.5 - f64::from(height) / 2.0);
            let (x, y) = (cos * dx + sin * dy, cos * dy - sin * dx);
            let (w, h) = (f64::from(width) * 0.35, f64::from(height) * 0.35);
            let lines = [
                (x - w).abs().max(y.abs() - h),
                (x + w).abs().max(y.abs() - h),
                (y - h).abs().max(x.abs() - w),
                (y + h).abs().max(x.abs() - w),
                (y - h / 3.0).abs().max(x.abs() - w),
                (x - w / 4.0).abs().max(y.abs() - h),
            ];
            let nearest = lines.into_iter().fold(f64::MAX, f64::min);
            Luma([((nearest - 1.0).clamp(0.0, 1.0) * 255.0) as u8])
        })
    }

    #[test]
    fn skews_are_found_within_a_twentieth_of_a_degree() {
        for size in [480, 700, 2000] {
            for degrees in [-9.0, -3.3, -1.0, 0.2, 0.7, 5.05, 8.8] {
                let found = skew(&building(size, size * 3 / 4, degrees)).to_degrees();
                assert!((found - degrees).abs() < 0.05, "{size}: {degrees} but found {found}");
            }
        }
    }

    #[test]
    fn upright_pages_are_left_alone() {
        assert_eq!(skew(&building(600, 400, 0.0)), 0.0);
        assert_eq!(skew(&building(600, 400, 0.03)), 0.0);
    }

    #[test]
    fn a_second_direction_of_the_building_is_no_skew() {
        let (upright, wing) = (building(800, 600, 0.0), building(800, 600, 7.0));
        let both = GrayImage::from_fn(800, 600, |x, y| {
            Luma([upright.get_pixel(x, y).0[0].min(wing.get_pixel(x, y).0[0])])
        });
        assert_eq!(skew(&both), 0.0);
    }

    #[test]
    fn a_wing_at_45_degrees_does_not_hide_a_skew() {
        let (main, wing) = (building(800, 600, 2.0), building(800, 600, 47.0));
        let both = GrayImage::from_fn(800, 600, |x, y| {
            Luma([main.get_pixel(x, y).0[0].min(wing.get_pixel(x, y).0[0])])
        });
        assert!((skew(&both).to_degrees() - 2.0).abs() < 0.05);
    }

    #[test]
    fn what_has_no_direction_is_not_turned() {
        let ring = GrayImage::from_fn(500, 500, |x, y| {
            let r = (f64::from(x) - 250.0).hypot(f64::from(y) - 250.0) % 60.0;
            Luma([if r < 4.0 { 0 } else { 255 }])
        });
        assert_eq!(skew(&ring), 0.0);
        assert_eq!(skew(&GrayImage::new(0, 0)), 0.0);
        assert_eq!(skew(&GrayImage::new(3, 1)), 0.0);
    }
}
