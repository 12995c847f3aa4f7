//! Light letters on coloured bands, as evacuation plans have their titles. What is coloured is paper on a sheet, so its
//! words are nowhere among the ink; here each band is a sheet of its own, dark on light.

use super::components::{Bounds, Components};
use crate::mask::Mask;
use crate::sheet::Sheet;
use image::{GrayImage, RgbImage, imageops};

/// A band's colour: its strongest channel is at least so much stronger than its weakest, and it is darker than this.
const CHROMA: u8 = 40;
const LIGHTEST: u32 = 480;
/// A band is at least so many times as wide as high,
const WIDE: i32 = 3;
/// at least so many pixels high: its letters fill about half of it,
const LOWEST: i32 = 16;
/// covers at least the first, and at most the second share of the sheet,
const SHARES: [f64; 2] = [0.004, 0.3];
/// and fills so much of its box; the rest is letters.
const FILLED: f64 = 0.5;

/// A band as a sheet, and where its upper left corner lies on the whole one.
pub struct Banner {
    /// Its letters are ink, all else is paper.
    pub sheet: Sheet,
    /// Pixels of the whole sheet.
    pub at: [i32; 2],
}

impl Banner {
    /// Whether a point of the whole sheet lies on the band.
    pub fn holds(&self, point: [f64; 2]) -> bool {
        let [x, y] = [point[0] - f64::from(self.at[0]), point[1] - f64::from(self.at[1])];
        x >= 0.0 && y >= 0.0 && x < f64::from(self.sheet.ink.width) && y < f64::from(self.sheet.ink.height)
    }
}

/// The bands of a sheet that something is written on.
pub fn find(sheet: &Sheet) -> Vec<Banner> {
    let (width, height) = sheet.colour.dimensions();
    let all = f64::from(width) * f64::from(height);
    let set: Vec<bool> = sheet.colour.as_raw().chunks_exact(3).map(is_band).collect();
    if (set.iter().filter(|&&s| s).count() as f64) < SHARES[0] * all {
        return Vec::new();
    }
    let parts = Components::of(&Mask { width, height, set }).list;
    let is_banner = |bounds: &Bounds, area: i64| {
        let whole = f64::from(bounds.width()) * f64::from(bounds.height());
        bounds.width() >= WIDE * bounds.height()
            && bounds.height() >= LOWEST
            && (SHARES[0] * all..=SHARES[1] * all).contains(&whole)
            && area as f64 >= FILLED * whole
    };
    parts.iter().filter(|p| is_banner(&p.bounds, p.area)).map(|p| banner(&sheet.colour, p.bounds)).collect()
}

fn is_band(pixel: &[u8]) -> bool {
    let sum: u32 = pixel.iter().map(|&v| u32::from(v)).sum();
    let (low, high) = pixel.iter().fold((255, 0), |(l, h), &v| (v.min(l), v.max(h)));
    high - low >= CHROMA && sum <= LIGHTEST
}

/// The band in negative. Its rim is left out: there it is as light as its letters.
fn banner(colour: &RgbImage, bounds: Bounds) -> Banner {
    let rim = 2;
    let [x, y] = [bounds.x0 + rim, bounds.y0 + rim];
    let size = [bounds.width() - 2 * rim, bounds.height() - 2 * rim].map(|s| s as u32);
    let crop = imageops::crop_imm(colour, x as u32, y as u32, size[0], size[1]).to_image();
    let mut grey = imageops::grayscale(&crop);
    let ground = median(&grey);
    let scale = 255.0 / f32::from((255 - ground).max(1));
    grey.iter_mut().for_each(|v| *v = (f32::from(255 - *v) * scale).min(255.0) as u8);
    let ink = letters(&grey);
    let aside = Mask::empty(ink.width, ink.height);
    Banner { sheet: Sheet { colour: crop, grey, ink, aside, turned: 0.0, page_size: size }, at: [x, y] }
}

fn median(grey: &GrayImage) -> u8 {
    let mut tones = grey.as_raw().clone();
    let half = tones.len() / 2;
    if tones.is_empty() { 255 } else { *tones.select_nth_unstable(half).1 }
}

/// What is dark, without what reaches the sides: the paper around a band that is not quite level.
fn letters(grey: &GrayImage) -> Mask {
    let (width, height) = grey.dimensions();
    let mut ink = Mask { width, height, set: grey.iter().map(|&v| v < 128).collect() };
    let parts = Components::of(&ink);
    let at_side = |b: &Bounds| b.x0 == 0 || b.y0 == 0 || b.x1 >= width as i32 || b.y1 >= height as i32;
    for part in parts.list.iter().filter(|p| at_side(&p.bounds)) {
        for run in parts.runs(part) {
            let row = run.y as usize * width as usize;
            ink.set[row + run.x0 as usize..row + run.x1 as usize].fill(false);
        }
    }
    ink
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    /// A sheet with a band of this size in which two letters stand.
    fn sheet([width, height]: [u32; 2], colour: [u8; 3]) -> Sheet {
        let colour = RgbImage::from_fn(400, 300, |x, y| {
            let band = (20..20 + width).contains(&x) && (30..30 + height).contains(&y);
            let letter = (40..70).contains(&y) && ((60..66).contains(&x) || (80..86).contains(&x));
            Rgb(if band && !letter { colour } else { [255; 3] })
        });
        let empty = Mask::empty(400, 300);
        let grey = GrayImage::new(400, 300);
        Sheet { colour, grey, ink: empty.clone(), aside: empty, turned: 0.0, page_size: [400, 300] }
    }

    #[test]
    fn a_bands_letters_become_ink() {
        let found = find(&sheet([300, 60], [0, 80, 160]));
        let [banner] = &found[..] else { panic!("{} banners", found.len()) };
        assert_eq!(banner.at, [22, 32]);
        assert_eq!(banner.sheet.ink.count(), 2 * 6 * 30);
        assert!(banner.sheet.ink.get(60 - 22, 40 - 32) && banner.sheet.grey.get_pixel(5, 5).0[0] > 250);
    }

    #[test]
    fn floors_signs_and_greys_are_no_bands() {
        for (size, colour) in [
            ([300, 200], [0, 80, 160]),
            ([60, 60], [0, 130, 60]),
            ([300, 60], [90; 3]),
            ([300, 60], [200, 230, 200]),
        ] {
            assert!(find(&sheet(size, colour)).is_empty(), "{size:?} {colour:?}");
        }
    }
}
