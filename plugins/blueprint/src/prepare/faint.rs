//! Faint lines from wall to wall: gates and glass are often drawn so lightly that they pass for paper. Ink as faint as
//! that is found only where it is a long, upright and straight line between two places of strong ink.

use super::ink::noise;
use crate::mask::Mask;
use crate::rows;
use image::GrayImage;

/// A faint line is darker by this than the paper at both its sides, `ASIDE` pixels away,
const CONTRAST: u8 = 8;
const ASIDE: usize = 3;

/// and by so many times the paper's noise.
const ABOVE_NOISE: f32 = 5.0;

/// Strong ink leaves a seam as far away as this, pixels: a picture's compression works on blocks of eight.
const SEAM: usize = 9;

/// It is at least so many pixels long,
const LEAST: usize = 24;

/// has no gap longer than this, and ends no farther from strong ink.
const GAP: usize = 2;
const END: usize = SEAM + 3;

/// The faint lines of a page, of which this is the strong ink.
pub fn lines(grey: &GrayImage, ink: &Mask) -> Mask {
    let contrast = (ABOVE_NOISE * noise(grey)).max(f32::from(CONTRAST)).min(255.0) as u8;
    let (width, height) = (ink.width as usize, ink.height as usize);
    let level = Page { grey: grey.as_raw(), ink: &ink.set, width, height, contrast }.lines();
    let found = Mask { set: level, width: ink.width, height: ink.height };
    let (grey, ink) = (turned(grey.as_raw(), width, height), turned(&ink.set, width, height));
    let upright = Page { grey: &grey, ink: &ink, width: height, height: width, contrast }.lines();
    if !upright.contains(&true) {
        return found;
    }
    found.with(&Mask { set: turned(&upright, height, width), width: width as u32, height: height as u32 })
}

/// The columns of a picture as rows.
fn turned<T: Copy + Default + Send + Sync>(pixels: &[T], width: usize, height: usize) -> Vec<T> {
    let mut out = vec![T::default(); pixels.len()];
    rows::for_each(&mut out, height, |x, row| {
        row.iter_mut().enumerate().for_each(|(y, to)| *to = pixels[y * width + x]);
    });
    out
}

struct Page<'a> {
    grey: &'a [u8],
    ink: &'a [bool],
    width: usize,
    height: usize,
    contrast: u8,
}

impl Page<'_> {
    /// The faint lines along its rows.
    fn lines(&self) -> Vec<bool> {
        let mut found = vec![false; self.ink.len()];
        rows::for_each(&mut found, self.width, |y, row| self.find(y, row));
        found
    }

    /// Marks the faint lines in a row.
    fn find(&self, y: usize, row: &mut [bool]) {
        if y < SEAM || y + SEAM >= self.height {
            return;
        }
        let mut x = 0;
        while x < self.width {
            let end = self.run(x, y);
            if end - x >= LEAST && self.is_held(x, end, y) {
                row[x..end].fill(true);
            }
            x = end + 1;
        }
    }

    /// Where the faint run ends that begins here; here if there is none.
    fn run(&self, from: usize, y: usize) -> usize {
        let (mut last, mut at) = (from, from);
        while at < self.width && at - last <= GAP {
            if self.is_faint(at, y) {
                last = at + 1;
            } else if last == from {
                break;
            }
            at += 1;
        }
        last
    }

    /// Whether a pixel is darker than both sides, and far from strong ink.
    fn is_faint(&self, x: usize, y: usize) -> bool {
        let tone = |y: usize| self.grey[y * self.width + x];
        let limit = tone(y).saturating_add(self.contrast);
        let is_ridge = limit < 255 && tone(y - ASIDE) >= limit && tone(y + ASIDE) >= limit;
        is_ridge && (y - SEAM..=y + SEAM).all(|y| !self.ink[y * self.width + x])
    }

    /// Whether strong ink is at both ends.
    fn is_held(&self, from: usize, end: usize, y: usize) -> bool {
        let has_ink = |range: std::ops::Range<usize>| range.clone().any(|x| self.ink[y * self.width + x]);
        has_ink(from.saturating_sub(END)..from) && has_ink(end..(end + END).min(self.width))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Luma;

    /// Two walls, and between them what `tone` says.
    fn found(tone: impl Fn(u32, u32) -> u8) -> usize {
        let is_wall = |x: u32| !(10..90).contains(&x);
        let grey = GrayImage::from_fn(100, 60, |x, y| Luma([if is_wall(x) { 0 } else { tone(x, y) }]));
        let mut ink = Mask::empty(100, 60);
        (0..6000).for_each(|i| ink.set[i as usize] = is_wall(i % 100));
        lines(&grey, &ink).count()
    }

    #[test]
    fn a_faint_line_between_walls_is_one_and_a_stub_or_an_edge_is_none() {
        assert_eq!(found(|_, y| if y == 30 { 240 } else { 255 }), 80);
        assert_eq!(found(|x, y| if y == 30 && x < 60 { 240 } else { 255 }), 0);
        assert_eq!(found(|_, y| if y < 30 { 240 } else { 255 }), 0);
        assert_eq!(found(|_, y| if y == 30 { 250 } else { 255 }), 0);
    }

    #[test]
    fn it_is_found_upright_too() {
        let grey = GrayImage::from_fn(60, 100, |x, y| match (x, y) {
            (_, 0..10 | 90..) => Luma([0]),
            (30, _) => Luma([235]),
            _ => Luma([255]),
        });
        let mut ink = Mask::empty(60, 100);
        (0..6000).for_each(|i| ink.set[i] = !(600..5400).contains(&i));
        assert_eq!(lines(&grey, &ink).count(), 80);
    }
}
