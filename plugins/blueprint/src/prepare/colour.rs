//! From colours to greys in which only what is drawn is dark: floors, routes and signs become paper; lines
//! and letters on them stay, as dark as they are against them.

use super::palette::{Meaning, Palette};
use super::tone;
use crate::rows;
use image::{GrayImage, RgbImage};

/// A floor's colour fills at least a square of this many pixels somewhere near; thinner, it is the soft edge
/// of a stroke.
const CORE: usize = 3;
/// So far from a floor the pixels of an edge still have some of its colour.
const REACH: usize = 3;
/// No floor is near.
const NONE: u8 = 255;

/// How dark the drawing is at every pixel of a page that is drawn in dark on light.
pub fn without_colours(page: &RgbImage) -> GrayImage {
    let palette = Palette::read(page);
    let (width, height) = (page.width() as usize, page.height() as usize);
    let meanings = meanings(page, &palette);
    let mut grey = GrayImage::new(page.width(), page.height());
    rows::for_each_band(&mut grey, width, |first, band| {
        let mut floors = Floors::new(&meanings, width, height);
        for (i, row) in band.chunks_exact_mut(width).enumerate() {
            let (near, own) = floors.around(first + i);
            let pixels = page.as_raw()[(first + i) * width * 3..].chunks_exact(3);
            for ((to, p), (&near, &own)) in row.iter_mut().zip(pixels).zip(near.iter().zip(own)) {
                *to = if own == NONE { drawn(&palette, [p[0], p[1], p[2]], near) } else { 255 };
            }
        }
    });
    grey
}

/// How dark a pixel is, if it is none of a floor. Of what has a colour, only that is drawn which is a shade
/// of the floor that it lies on: a black line under a transparent fill.
fn drawn(palette: &Palette, colour: [u8; 3], near: u8) -> u8 {
    let ground = palette.grounds().get(usize::from(near)).copied().unwrap_or([255; 3]);
    if !palette.is_foreign(colour) {
        return against(tone::luma(colour), tone::luma(ground));
    }
    let bare = std::array::from_fn(|c| against(colour[c], ground[c]));
    if palette.is_foreign(bare) { 255 } else { tone::luma(bare) }
}

/// How light something is when its ground is taken for white.
fn against(light: u8, ground: u8) -> u8 {
    (u32::from(light) * 255 / u32::from(ground.max(1))).min(255) as u8
}

/// For each pixel the number of the floor that has its colour, or `NONE`.
fn meanings(page: &RgbImage, palette: &Palette) -> Vec<u8> {
    let width = page.width() as usize;
    let mut meanings = vec![NONE; width * page.height() as usize];
    rows::for_each(&mut meanings, width, |y, row| {
        let pixels = page.as_raw()[y * width * 3..].chunks_exact(3);
        row.iter_mut().zip(pixels).for_each(|(to, p)| *to = code(palette.meaning([p[0], p[1], p[2]])));
    });
    meanings
}

fn code(meaning: Meaning) -> u8 {
    match meaning {
        Meaning::Plain | Meaning::Coloured => NONE,
        Meaning::Ground(number) => number,
    }
}

/// Walks down the rows and tells of every pixel the darkest floor nearby.
struct Floors<'a> {
    meanings: &'a [u8],
    width: usize,
    height: usize,
    /// The last rows of floors' cores, each with the least within `REACH` and within the core itself to both
    /// sides.
    rows: Vec<(usize, Vec<u8>, Vec<u8>)>,
    near: Vec<u8>,
    own: Vec<u8>,
}

impl<'a> Floors<'a> {
    fn new(meanings: &'a [u8], width: usize, height: usize) -> Self {
        Self { meanings, width, height, rows: vec![], near: vec![NONE; width], own: vec![NONE; width] }
    }

    /// The darkest floor within `REACH`, and within half a core, of every pixel of row `y`. Rows are asked
    /// for in order.
    fn around(&mut self, y: usize) -> (&[u8], &[u8]) {
        self.rows.retain(|r| r.0 + REACH >= y);
        let first = self.rows.last().map_or(y.saturating_sub(REACH), |r| r.0 + 1);
        for next in first..(y + REACH + 1).min(self.height) {
            let cores = self.cores(next);
            self.rows.push((next, rows::least_within(&cores, REACH), rows::least_within(&cores, CORE / 2)));
        }
        self.near.fill(NONE);
        self.own.fill(NONE);
        for (row, near, own) in &self.rows {
            rows::lower(&mut self.near, near);
            if row.abs_diff(y) <= CORE / 2 {
                rows::lower(&mut self.own, own);
            }
        }
        (&self.near, &self.own)
    }

    /// The number of the floor of which a pixel of this row is the middle of a core, `NONE` elsewhere.
    fn cores(&self, y: usize) -> Vec<u8> {
        let mut cores = vec![NONE; self.width];
        if y == 0 || y + 1 >= self.height || self.width < CORE {
            return cores;
        }
        let line = |row: usize| &self.meanings[row * self.width..(row + 1) * self.width];
        let (above, here, below) = (line(y - 1), line(y), line(y + 1));
        for x in 1..self.width - 1 {
            let (floor, near) = (here[x], x - 1..x + 2);
            let same = |row: &[u8]| row[near.clone()].iter().all(|&m| m == floor);
            if floor != NONE && same(here) && same(above) && same(below) {
                cores[x] = floor;
            }
        }
        cores
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    /// A page with a painted floor in the middle, a line across everything, and a sign.
    fn page(floor: [u8; 3], line: [u8; 3]) -> RgbImage {
        RgbImage::from_fn(200, 160, |x, y| {
            let inside = (40..160).contains(&x) && (30..130).contains(&y);
            Rgb(match (x, y) {
                (_, 80) | (100, _) | (10 | 190, _) | (_, 10 | 150) => line,
                (60..70, 40..50) => [200, 20, 30],
                _ if inside => floor,
                _ => [255; 3],
            })
        })
    }

    #[test]
    fn floors_and_signs_become_paper_and_lines_on_them_stay() {
        for floor in [[192, 192, 192], [85, 200, 130], [128, 128, 255], [255, 255, 100], [150, 150, 150]] {
            let grey = without_colours(&page(floor, [0; 3]));
            for (x, y) in [(50, 60), (65, 45), (20, 20), (120, 110), (39, 60), (40, 60), (61, 41)] {
                assert_eq!(grey.get_pixel(x, y).0[0], 255, "{floor:?} at {x} {y}");
            }
            for (x, y) in [(50, 80), (100, 60), (10, 40), (100, 20)] {
                assert!(grey.get_pixel(x, y).0[0] < 10, "{floor:?} at {x} {y}");
            }
        }
    }

    #[test]
    fn lines_under_a_transparent_fill_stay_and_darker_signs_on_it_go() {
        let mut plan = page([255, 255, 130], [0; 3]);
        (0..100).for_each(|i| plan.put_pixel(50 + i, 100, Rgb([120, 120, 62])));
        (0..64).for_each(|i| plan.put_pixel(110 + i % 8, 50 + i / 8, Rgb([0, 130, 60])));
        let grey = without_colours(&plan);
        assert!(grey.get_pixel(80, 100).0[0] < 130);
        assert_eq!(grey.get_pixel(113, 53).0[0], 255);
    }

    #[test]
    fn thin_grey_lines_stay_grey() {
        let grey = without_colours(&page([230, 230, 230], [170; 3]));
        assert!((160..200).contains(&grey.get_pixel(50, 80).0[0]), "on the floor");
        assert_eq!(grey.get_pixel(10, 60).0[0], 170);
    }

    #[test]
    fn pages_smaller_than_a_core_are_survived() {
        for (width, height) in [(0, 0), (1, 1), (2, 2), (2, 40), (40, 2), (3, 3)] {
            let page = RgbImage::from_pixel(width, height, Rgb([200; 3]));
            assert_eq!(without_colours(&page).dimensions(), (width, height));
        }
    }
}
