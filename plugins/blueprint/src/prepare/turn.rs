//! Turning pictures by small angles.

use crate::rows;
use image::{ImageBuffer, Pixel};

/// Turns a picture about its middle by an angle, radians clockwise as seen, into one that is large enough to
/// hold it, with paper in the corners. Bilinear between pixels.
pub fn turned<P: Pixel<Subpixel = u8> + Sync>(
    picture: &ImageBuffer<P, Vec<u8>>,
    angle: f64,
) -> ImageBuffer<P, Vec<u8>> {
    let (width, height) = size(picture.width(), picture.height(), angle);
    let mut out = ImageBuffer::new(width, height);
    let channels = usize::from(P::CHANNEL_COUNT);
    let way = Way::new([picture.width(), picture.height()], [width, height], angle);
    rows::for_each(&mut out, width as usize * channels, |y, row| {
        let [mut x, mut y] = way.start(y);
        for pixel in row.chunks_exact_mut(channels) {
            read(picture, [x, y], pixel);
            x += way.step[0];
            y += way.step[1];
        }
    });
    out
}

/// Binary places of the numbers by which the way through a picture is told: fine enough that the steps along
/// the longest row do not add up to an error.
const PLACES: u32 = 32;

/// The way that the rows of a turned picture take through the original.
struct Way {
    /// From one pixel to the next.
    step: [i64; 2],
    /// Where the first row begins, pixels.
    origin: [f64; 2],
}

impl Way {
    fn new(from: [u32; 2], to: [u32; 2], angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        let [dx, dy] = to.map(|size| 0.5 - f64::from(size) / 2.0);
        let [mx, my] = from.map(|size| f64::from(size) / 2.0 - 0.5);
        Self { step: [cos, -sin].map(fixed), origin: [cos * dx + sin * dy + mx, cos * dy - sin * dx + my] }
    }

    /// Where a row begins: the columns' step turned by a quarter leads from row to row.
    fn start(&self, row: usize) -> [i64; 2] {
        let down = [-self.step[1], self.step[0]];
        [0, 1].map(|i| fixed(self.origin[i]) + down[i] * row as i64)
    }
}

fn fixed(length: f64) -> i64 {
    (length * (1u64 << PLACES) as f64).round() as i64
}

/// The size of the picture that holds all of a turned one.
fn size(width: u32, height: u32, angle: f64) -> (u32, u32) {
    let (sin, cos) = (angle.sin().abs(), angle.cos().abs());
    let (w, h) = (f64::from(width), f64::from(height));
    ((w * cos + h * sin).ceil() as u32, (w * sin + h * cos).ceil() as u32)
}

/// The picture's tone at a point, told from the middle of its first pixel; white outside.
fn read<P: Pixel<Subpixel = u8>>(picture: &ImageBuffer<P, Vec<u8>>, [x, y]: [i64; 2], pixel: &mut [u8]) {
    let (left, top) = (x >> PLACES, y >> PLACES);
    let shares = [x, y].map(|v| (v >> (PLACES - 8) & 255) as u32);
    let (width, height, channels) = (i64::from(picture.width()), i64::from(picture.height()), pixel.len());
    let raw = picture.as_raw();
    if left >= 0 && top >= 0 && left + 1 < width && top + 1 < height {
        let upper = (top * width + left) as usize * channels;
        let lower = upper + width as usize * channels;
        let (upper, lower) = (&raw[upper..upper + 2 * channels], &raw[lower..lower + 2 * channels]);
        for (c, value) in pixel.iter_mut().enumerate() {
            *value = blend([upper[c], upper[c + channels], lower[c], lower[c + channels]], shares);
        }
    } else {
        let corners =
            [(left, top), (left + 1, top), (left, top + 1), (left + 1, top + 1)].map(|c| at(picture, c));
        for (c, value) in pixel.iter_mut().enumerate() {
            *value = blend(corners.map(|p| p.map_or(255, |p| p[c])), shares);
        }
    }
}

/// Between four tones: the upper two and the lower two, each from left to right.
fn blend(tones: [u8; 4], [right, down]: [u32; 2]) -> u8 {
    let [a, b, c, d] = tones.map(u32::from);
    let (upper, lower) = (a * (256 - right) + b * right, c * (256 - right) + d * right);
    ((upper * (256 - down) + lower * down + (1 << 15)) >> 16) as u8
}

fn at<P: Pixel<Subpixel = u8>>(picture: &ImageBuffer<P, Vec<u8>>, (x, y): (i64, i64)) -> Option<&[u8]> {
    let (x, y) = (u32::try_from(x).ok()?, u32::try_from(y).ok()?);
    picture.get_pixel_checked(x, y).map(Pixel::channels)
}

#[cfg(test)]
mod tests {
    use super::super::skew;
    use super::*;
    use image::{GrayImage, Luma, Rgb, RgbImage};

    #[test]
    fn turning_back_makes_a_skewed_building_upright() {
        for degrees in [-7.0f64, 0.4, 3.0] {
            let askew = skew::tests::building(700, 500, degrees);
            let upright = turned(&askew, -skew::skew(&askew));
            assert_eq!(skew::skew(&upright), 0.0, "{degrees}");
        }
    }

    #[test]
    fn nothing_falls_off_and_the_corners_are_paper() {
        let page = RgbImage::from_pixel(300, 200, Rgb([10, 20, 30]));
        let out = turned(&page, 0.1);
        assert!(out.width() > 300 && out.height() > 200);
        let dark = out.pixels().filter(|p| p.0[0] < 128).count();
        assert!((59_800..60_200).contains(&dark), "{dark}");
        assert_eq!(out.get_pixel(0, 0).0, [255; 3]);
    }

    #[test]
    fn a_turn_by_nothing_changes_nothing() {
        let page = GrayImage::from_fn(30, 20, |x, y| Luma([(x * 7 + y * 5) as u8]));
        assert_eq!(turned(&page, 0.0), page);
        assert_eq!(turned(&GrayImage::new(0, 0), 0.1).dimensions(), (0, 0));
    }
}
