//! What was read of a sheet, painted over it.

use crate::paint::outline;
use crate::pipeline::Reading;
use image::{Rgb, RgbImage};

const WALL: Rgb<u8> = Rgb([200, 60, 40]);
const OUTSIDE: Rgb<u8> = Rgb([225, 225, 235]);
const TEXT: Rgb<u8> = Rgb([30, 90, 220]);
const SYMBOL: Rgb<u8> = Rgb([20, 150, 60]);

/// The sheet with its walls in red, what is outside in grey, words boxed in blue and symbols in green.
pub fn picture(reading: &Reading) -> RgbImage {
    let mut picture = image::DynamicImage::ImageLuma8(reading.sheet.grey.clone()).into_rgb8();
    let masks = reading.walls.occupied.set.iter().zip(&reading.walls.inside.set);
    for (pixel, (&wall, &inside)) in picture.pixels_mut().zip(masks) {
        match (wall, inside) {
            (true, _) => *pixel = WALL,
            (_, false) if pixel.0[0] > 200 => *pixel = OUTSIDE,
            _ => (),
        }
    }
    for t in &reading.words.texts {
        outline(&mut picture, t.centre, t.angle, [t.width, t.height], TEXT);
    }
    for s in &reading.symbols.symbols {
        outline(&mut picture, s.centre, s.angle, [s.width, s.height], SYMBOL);
    }
    picture
}
