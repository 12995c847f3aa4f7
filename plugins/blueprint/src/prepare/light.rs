//! Uneven light, vignettes and yellowed paper: every pixel is divided by what the paper would be in its
//! place.
//!
//! The paper's tone is read in blocks, and followed from block to block as long as it changes slowly, as
//! light does; the edge of a painted floor is a step, so floors are not taken for badly lit paper. Where no
//! paper is seen it is interpolated.

use crate::rows;

/// Blocks along the longer side of a picture.
const BLOCKS: usize = 96;
/// Light changes by less than this from a block to the next one.
const STEP: f32 = 0.06;
/// The paper is a connected part of the picture that covers at least this much of it,
const PAPER_SHARE: f32 = 0.1;
/// and is at least so bright, of the brightest such part. One that reaches the picture's edge is preferred: the rooms of
/// a plan may lie in better light than the paper around it.
const PAPER_TONE: f32 = 0.7;
/// In the blocks' sorted tones the paper is here: above strokes and their soft edges, below the brightest
/// noise.
const PAPER_QUANTILE: f32 = 0.75;
/// A paper as light as this is white already.
const WHITE: f32 = 250.0;
/// So much of a paper may be darker without being called uneven.
const UNEVEN_SHARE: f32 = 0.02;

/// Makes the paper evenly white in an interleaved picture of `CHANNELS` channels. Returns whether it had to.
pub fn flatten<const CHANNELS: usize>(data: &mut [u8], width: usize) -> bool {
    let Some(blocks) = Blocks::<CHANNELS>::read(data, width) else { return false };
    let reached = blocks.paper();
    if blocks.is_white(&reached) {
        return false;
    }
    let paper = blocks.interpolated(reached);
    rows::for_each(data, width * CHANNELS, |y, row| paper.divide(y, row));
    true
}

/// The tone of the lighter pixels in each block of a picture.
struct Blocks<const CHANNELS: usize> {
    side: usize,
    columns: usize,
    tones: Vec<[f32; CHANNELS]>,
}

impl<const CHANNELS: usize> Blocks<CHANNELS> {
    fn read(data: &[u8], width: usize) -> Option<Self> {
        let height = data.len() / (width * CHANNELS).max(1);
        if width == 0 || height == 0 {
            return None;
        }
        let side = width.max(height).div_ceil(BLOCKS).max(8);
        let columns = width.div_ceil(side);
        let line = |row: usize| -> Vec<[f32; CHANNELS]> {
            let (top, bottom) = (row * side, (row * side + side).min(height));
            let across = |c: usize| [c * side, (c * side + side).min(width)];
            (0..columns).map(|c| Self::tone(data, width, across(c), [top, bottom])).collect()
        };
        let tones = rows::map(height.div_ceil(side), line).concat();
        Some(Self { side, columns, tones })
    }

    fn tone(
        data: &[u8],
        width: usize,
        [left, right]: [usize; 2],
        [top, bottom]: [usize; 2],
    ) -> [f32; CHANNELS] {
        // A few hundred pixels tell the quantile well enough; odd steps do not fall into step with hatching.
        let step = ((bottom - top) / 24).max(1) | 1;
        let mut counts = [[0u32; 256]; CHANNELS];
        for y in (top..bottom).step_by(step) {
            for x in (left..right).step_by(step) {
                let at = (y * width + x) * CHANNELS;
                data[at..at + CHANNELS].iter().zip(&mut counts).for_each(|(&v, c)| c[v as usize] += 1);
            }
        }
        counts.map(|c| quantile(&c, PAPER_QUANTILE))
    }

    fn rows(&self) -> usize {
        self.tones.len() / self.columns
    }

    fn brightness(&self, block: usize) -> f32 {
        self.tones[block].iter().sum::<f32>() / CHANNELS as f32
    }

    /// The blocks in which paper is seen.
    fn paper(&self) -> Vec<bool> {
        let parts = self.parts();
        let least = (self.tones.len() as f32 * PAPER_SHARE) as usize;
        let tone = |p: &Vec<usize>| p.iter().map(|&b| self.brightness(b)).sum::<f32>() / p.len() as f32;
        let large: Vec<_> = parts.iter().filter(|p| p.len() > least).collect();
        let brightest = large.iter().map(|p| tone(p)).fold(0.0, f32::max);
        let bright = large.into_iter().filter(|p| tone(p) >= PAPER_TONE * brightest);
        let is_outer = |p: &Vec<usize>| p.iter().any(|&b| self.neighbours(b).count() < 4);
        let paper = bright.max_by(|a, b| is_outer(a).cmp(&is_outer(b)).then(tone(a).total_cmp(&tone(b))));
        let mut reached = vec![false; self.tones.len()];
        paper.into_iter().flatten().for_each(|&b| reached[b] = true);
        reached
    }

    /// Blocks connected by slow changes of tone.
    fn parts(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.tones.len()];
        let mut parts = vec![];
        for start in 0..self.tones.len() {
            if !seen[start] {
                parts.push(self.part_from(start, &mut seen));
            }
        }
        parts
    }

    fn part_from(&self, start: usize, seen: &mut [bool]) -> Vec<usize> {
        seen[start] = true;
        let mut part = vec![start];
        let mut next = 0;
        while let Some(&block) = part.get(next) {
            next += 1;
            for other in self.neighbours(block) {
                if !seen[other] && self.alike(block, other) {
                    seen[other] = true;
                    part.push(other);
                }
            }
        }
        part
    }

    fn alike(&self, a: usize, b: usize) -> bool {
        self.tones[a].iter().zip(&self.tones[b]).all(|(&p, &q)| (p - q).abs() <= STEP * p.max(q))
    }

    fn neighbours(&self, block: usize) -> impl Iterator<Item = usize> + use<CHANNELS> {
        let (x, y, columns, rows) = (block % self.columns, block / self.columns, self.columns, self.rows());
        [
            (x > 0).then(|| block - 1),
            (x + 1 < columns).then(|| block + 1),
            (y > 0).then(|| block - columns),
            (y + 1 < rows).then(|| block + columns),
        ]
        .into_iter()
        .flatten()
    }

    fn is_white(&self, reached: &[bool]) -> bool {
        let of_paper: Vec<_> = self.tones.iter().zip(reached).filter(|&(_, &r)| r).map(|(t, _)| t).collect();
        let dark = of_paper.iter().filter(|t| t.iter().any(|&v| v < WHITE)).count();
        dark as f32 <= of_paper.len() as f32 * UNEVEN_SHARE
    }

    /// The paper's tone everywhere: outwards from where it is seen, every layer of blocks takes the mean of
    /// the one before, and the result is smoothed as light is smooth.
    fn interpolated(mut self, mut reached: Vec<bool>) -> Self {
        loop {
            let layer: Vec<_> =
                (0..reached.len()).filter(|&b| !reached[b]).filter_map(|b| self.mean(b, &reached)).collect();
            if layer.is_empty() {
                break;
            }
            for (block, tone) in layer {
                self.tones[block] = tone;
                reached[block] = true;
            }
        }
        let smooth: Vec<_> =
            (0..reached.len()).filter_map(|b| self.mean(b, &reached)).map(|(_, t)| t).collect();
        if smooth.len() == self.tones.len() {
            self.tones
                .iter_mut()
                .zip(smooth)
                .for_each(|(t, s)| *t = std::array::from_fn(|c| (t[c] + s[c]) / 2.0));
        }
        self
    }

    /// The block and the mean tone of its reached neighbours, if there are any.
    fn mean(&self, block: usize, reached: &[bool]) -> Option<(usize, [f32; CHANNELS])> {
        let near: Vec<_> = self.neighbours(block).filter(|&n| reached[n]).map(|n| self.tones[n]).collect();
        let mean = |c: usize| near.iter().map(|t| t[c]).sum::<f32>() / near.len() as f32;
        (!near.is_empty()).then(|| (block, std::array::from_fn(mean)))
    }

    /// Divides a row of the picture by the paper's tone, interpolated bilinearly between the blocks' middles.
    fn divide(&self, y: usize, row: &mut [u8]) {
        let (above, below, t) = self.between(y, self.rows());
        let blend = |c: usize| -> [f32; CHANNELS] {
            let (a, b) = (self.tones[above * self.columns + c], self.tones[below * self.columns + c]);
            std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
        };
        let line: Vec<_> = (0..self.columns).map(blend).collect();
        for (x, pixel) in row.chunks_exact_mut(CHANNELS).enumerate() {
            let (left, right, u) = self.between(x, self.columns);
            for (c, value) in pixel.iter_mut().enumerate() {
                let paper = line[left][c] + (line[right][c] - line[left][c]) * u;
                *value = (f32::from(*value) * 255.0 / paper.max(1.0) + 0.5) as u8;
            }
        }
    }

    /// The two blocks between whose middles a pixel lies, and how far it is from the first to the second.
    fn between(&self, pixel: usize, blocks: usize) -> (usize, usize, f32) {
        let place = ((pixel as f32 + 0.5) / self.side as f32 - 0.5).max(0.0);
        let first = (place as usize).min(blocks - 1);
        (first, (first + 1).min(blocks - 1), place - first as f32)
    }
}

/// The value below which this share of the counted ones lies.
fn quantile(counts: &[u32; 256], share: f32) -> f32 {
    let wanted = counts.iter().sum::<u32>() as f32 * share;
    let mut sum = 0.0;
    let place = counts.iter().position(|&c| {
        sum += c as f32;
        sum >= wanted
    });
    place.unwrap_or(255) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grey picture of this size.
    fn picture(size: usize, tone: impl Fn(usize, usize) -> f32) -> Vec<u8> {
        (0..size * size).map(|i| tone(i % size, i / size) as u8).collect()
    }

    #[test]
    fn a_slope_of_light_becomes_even_and_lines_stay_dark() {
        let light = |x: usize, y: usize| 120.0 + 0.3 * x as f32 + 0.1 * y as f32;
        let mut data = picture(300, |x, y| light(x, y) * if x % 50 < 3 { 0.2 } else { 1.0 });
        assert!(flatten::<1>(&mut data, 300));
        for (i, &v) in data.iter().enumerate() {
            let line = i % 300 % 50 < 3;
            assert!(if line { v < 70 } else { v > 240 }, "{} {}: {v}", i % 300, i / 300);
        }
    }

    #[test]
    fn a_painted_floor_is_not_taken_for_shade() {
        let inside = |x: usize, y: usize| (60..240).contains(&x) && (60..240).contains(&y);
        let mut data = picture(300, |x, y| if inside(x, y) { 190.0 } else { 240.0 - 0.1 * y as f32 });
        assert!(flatten::<1>(&mut data, 300));
        assert!(data[150 * 300 + 150] < 230);
        assert!(data[30 * 300 + 20] > 250 && data[290 * 300 + 20] > 250);
    }

    #[test]
    fn the_paper_around_a_plan_is_followed_into_the_shade() {
        let light = |x: usize| 220.0 - 0.4 * x as f32;
        let is_wall = |x: usize, y: usize| x.max(y) < 200 && (x.min(y) < 20 || x.max(y) >= 180);
        let mut data = picture(300, |x, y| if is_wall(x, y) { 40.0 } else { light(x) });
        assert!(flatten::<1>(&mut data, 300));
        assert!(data[250 * 300 + 290] > 240 && data[20 * 300 + 280] > 240);
    }

    #[test]
    fn white_paper_is_left_alone() {
        let mut data = picture(100, |x, _| if x == 50 { 0.0 } else { 255.0 });
        let before = data.clone();
        assert!(!flatten::<1>(&mut data, 100));
        assert_eq!(data, before);
    }

    #[test]
    fn yellowed_paper_becomes_white() {
        let mut data: Vec<u8> = [240, 225, 170].repeat(64 * 64);
        assert!(flatten::<3>(&mut data, 64));
        assert!(data.iter().all(|&v| v >= 254));
    }

    #[test]
    fn odd_sizes_are_survived() {
        for (width, height) in [(0, 0), (1, 1), (1, 700), (700, 1), (9, 8)] {
            flatten::<3>(&mut vec![90; width * height * 3], width);
        }
    }
}
