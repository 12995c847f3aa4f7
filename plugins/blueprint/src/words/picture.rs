//! The picture of what was found.

use super::Words;
use crate::paint::outline;
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
        outline(&mut picture, text.centre, text.angle, [text.width + 4.0, text.height + 4.0], READ);
    }
    picture
}
