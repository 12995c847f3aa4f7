//! Cuts a line out of the sheet as an engine wants it: alone, upright, large enough, dark on white with a margin.

use super::components::{Bounds, Run};
use super::lines::Axis;
use crate::mask::Mask;
use image::imageops::{self, FilterType};
use image::{GrayImage, Luma};

/// How high a line's tall letters become, pixels. Tesseract reads best at 30 to 40.
const HEIGHT: f64 = 34.0;
/// The most by which a line is enlarged; smaller letters are beyond reading anyway.
const ENLARGED: f64 = 6.0;
/// The margin around the line, pixels of the enlarged picture.
const MARGIN: i64 = 12;
/// The longest line that is read, pixels of the enlarged picture.
const LONGEST: f64 = 6000.0;
/// How far around a letter its grey rim is looked for, pixels of the sheet.
const RIM: i32 = 2;

/// The sheet's grey picture and all its ink.
pub struct Source<'a> {
    /// Dark on white.
    pub grey: &'a GrayImage,
    /// The ink, whatever it belongs to.
    pub ink: &'a Mask,
}

/// The quarter turns, clockwise, that make a line upright which reads...
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// ... to the right.
    Right,
    /// ... downwards.
    Down,
    /// ... to the left, upside down.
    Left,
    /// ... upwards.
    Up,
}

impl Reading {
    /// The two ways in which a line along this axis may read, the usual one first.
    pub fn both(axis: Axis) -> [Self; 2] {
        match axis {
            Axis::Across => [Self::Right, Self::Left],
            Axis::Along => [Self::Up, Self::Down],
        }
    }

    /// The direction in which it reads, radians clockwise from the right.
    pub fn angle(self) -> f64 {
        use std::f64::consts::{FRAC_PI_2, PI};
        match self {
            Self::Right => 0.0,
            Self::Down => FRAC_PI_2,
            Self::Left => PI,
            Self::Up => -FRAC_PI_2,
        }
    }

    /// A box of the sheet as it is, but for its place, when the line reads to the right.
    pub fn turned(self, b: Bounds) -> Bounds {
        let of = |x0, y0, x1, y1| Bounds { x0, y0, x1, y1 };
        match self {
            Self::Right => b,
            Self::Down => of(b.y0, -b.x1, b.y1, -b.x0),
            Self::Left => of(-b.x1, -b.y1, -b.x0, -b.y0),
            Self::Up => of(-b.y1, b.x0, -b.y0, b.x1),
        }
    }

    fn upright(self, picture: &GrayImage) -> GrayImage {
        match self {
            Self::Right => picture.clone(),
            Self::Down => imageops::rotate270(picture),
            Self::Left => imageops::rotate180(picture),
            Self::Up => imageops::rotate90(picture),
        }
    }
}

/// A line as it lies on the sheet, nothing but its own ink.
pub fn alone(source: &Source<'_>, bounds: Bounds, runs: &[&[Run]]) -> GrayImage {
    let area = bounds.grown(RIM);
    let own = Local::of(area, runs);
    let (width, height) = (area.width() as u32, area.height() as u32);
    GrayImage::from_fn(width, height, |x, y| {
        let (x, y) = (area.x0 + x as i32, area.y0 + y as i32);
        let outside = x < 0 || y < 0 || x as u32 >= source.grey.width() || y as u32 >= source.grey.height();
        let shown = !outside && own.near(x, y) && (own.get(x, y) || !source.ink.get(x.into(), y.into()));
        if shown { *source.grey.get_pixel(x as u32, y as u32) } else { Luma([255]) }
    })
}

/// The picture turned upright and enlarged so that letters of `letter` pixels have the height that engines like, with its
/// margin.
pub fn prepared(picture: &GrayImage, reading: Reading, letter: f64) -> GrayImage {
    let upright = reading.upright(picture);
    let widest = LONGEST / f64::from(upright.width());
    let scale = (HEIGHT / letter.max(1.0)).min(ENLARGED).min(widest);
    let side = |s: u32| ((f64::from(s) * scale).round() as u32).max(1);
    let (width, height) = (side(upright.width()), side(upright.height()));
    let large = imageops::resize(&upright, width, height, FilterType::CatmullRom);
    let margin = MARGIN as u32;
    let mut framed = GrayImage::from_pixel(width + 2 * margin, height + 2 * margin, Luma([255]));
    imageops::replace(&mut framed, &large, MARGIN, MARGIN);
    framed
}

/// Where in the prepared picture of this width something is that lies `along` a line of this length, pixels of the sheet.
pub fn along(along: f64, length: f64, width: u32) -> f64 {
    let (margin, rim) = (MARGIN as f64, f64::from(RIM));
    let scale = (f64::from(width) - 2.0 * margin) / (length + 2.0 * rim);
    margin + (along + rim) * scale
}

/// A small mask somewhere on the sheet.
struct Local {
    area: Bounds,
    set: Vec<bool>,
}

impl Local {
    fn of(area: Bounds, runs: &[&[Run]]) -> Self {
        let mut set = vec![false; (area.width() * area.height()) as usize];
        for r in runs.iter().copied().flatten() {
            let row = ((r.y - area.y0) * area.width()) as usize;
            set[row + (r.x0 - area.x0) as usize..row + (r.x1 - area.x0) as usize].fill(true);
        }
        Self { area, set }
    }

    fn get(&self, x: i32, y: i32) -> bool {
        let (x, y) = (x - self.area.x0, y - self.area.y0);
        let inside = x >= 0 && y >= 0 && x < self.area.width() && y < self.area.height();
        inside && self.set[(y * self.area.width() + x) as usize]
    }

    /// Whether a set pixel is in the pixel's neighbourhood.
    fn near(&self, x: i32, y: i32) -> bool {
        (-RIM..=RIM).any(|dy| (-RIM..=RIM).any(|dx| self.get(x + dx, y + dy)))
    }
}
