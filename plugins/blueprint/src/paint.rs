//! Lines and boxes on the pictures of the steps.

use image::{Rgb, RgbImage};

/// A line one pixel wide; what lies beyond the picture is left out.
pub fn line(picture: &mut RgbImage, a: [f64; 2], b: [f64; 2], colour: Rgb<u8>) {
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

/// The outline of a box of this middle and size, turned clockwise by `angle`, radians.
pub fn outline(picture: &mut RgbImage, [x, y]: [f64; 2], angle: f64, [w, h]: [f64; 2], colour: Rgb<u8>) {
    let (s, c) = angle.sin_cos();
    let corner = |u: f64, v: f64| [x + 0.5 * (u * w * c - v * h * s), y + 0.5 * (u * w * s + v * h * c)];
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    (0..4).for_each(|i| line(picture, corners[i], corners[(i + 1) % 4], colour));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_end_far_away_are_soon_drawn() {
        let mut picture = RgbImage::new(8, 8);
        line(&mut picture, [2.0, 2.0], [1e12, 2.0], Rgb([9; 3]));
        line(&mut picture, [f64::NAN, 0.0], [5.0, f64::INFINITY], Rgb([9; 3]));
        assert_eq!(picture.get_pixel(2, 2), &Rgb([9; 3]));
    }
}
