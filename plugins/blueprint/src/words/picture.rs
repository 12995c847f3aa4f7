//! The picture of what was found.

use super::Words;
use crate::sheet::Sheet;
use image::{Rgb, RgbImage};

const ERASED: Rgb<u8> = Rgb([230, 60, 40]);
const READ: Rgb<u8> = Rgb([40, 90, 220]);
const INK: Rgb<u8> = Rgb([90, 90, 90]);
const PAPER: Rgb<u8> = Rgb([255; 3]);

/// The ink, what is erased of it in red, and a blue box around each text.
pub fn words(sheet: &Sheet, words: &Words) -> RgbImage {
    let mut picture = RgbImage::from_fn(sheet.ink.width, sheet.ink.height, |x, y| {
        let (x, y) = (i64::from(x), i64::from(y));
        if words.erase.get(x, y) {
            ERASED
        } else if sheet.ink.get(x, y) || sheet.aside.get(x, y) {
            INK
        } else {
            PAPER
        }
    });
    for text in &words.texts {
        let (sin, cos) = text.angle.sin_cos();
        let (w, h) = (text.width / 2.0 + 2.0, text.height / 2.0 + 2.0);
        let corner =
            |a: f64, b: f64| [text.centre[0] + cos * a - sin * b, text.centre[1] + sin * a + cos * b];
        let ring = [corner(-w, -h), corner(w, -h), corner(w, h), corner(-w, h), corner(-w, -h)];
        ring.windows(2).for_each(|side| stroke(&mut picture, side[0], side[1]));
    }
    picture
}

/// A thin line.
fn stroke(picture: &mut RgbImage, from: [f64; 2], to: [f64; 2]) {
    let steps = (to[0] - from[0]).abs().max((to[1] - from[1]).abs()).ceil().max(1.0);
    for i in 0..=steps as u32 {
        let t = f64::from(i) / steps;
        let [x, y] = [0, 1].map(|k| from[k] + t * (to[k] - from[k]));
        if x >= 0.0 && y >= 0.0 && x < f64::from(picture.width()) && y < f64::from(picture.height()) {
            picture.put_pixel(x as u32, y as u32, READ);
        }
    }
}
