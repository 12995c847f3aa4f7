//! What was read of a sheet, painted over it.

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

/// The outline of a turned box.
fn outline(picture: &mut RgbImage, [x, y]: [f64; 2], angle: f64, [w, h]: [f64; 2], colour: Rgb<u8>) {
    let (c, s) = (angle.cos(), angle.sin());
    let corner = |u: f64, v: f64| [x + 0.5 * (u * w * c - v * h * s), y + 0.5 * (u * w * s + v * h * c)];
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    (0..4).for_each(|i| line(picture, corners[i], corners[(i + 1) % 4], colour));
}

fn line(picture: &mut RgbImage, a: [f64; 2], b: [f64; 2], colour: Rgb<u8>) {
    let longest = f64::from(picture.width().max(picture.height()));
    let steps = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()).min(2.0 * longest).ceil().max(1.0);
    for i in 0..=steps as u32 {
        let t = f64::from(i) / steps;
        let (x, y) = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
        if x >= 0.0 && y >= 0.0 && x < f64::from(picture.width()) && y < f64::from(picture.height()) {
            picture.put_pixel(x as u32, y as u32, colour);
        }
    }
}
