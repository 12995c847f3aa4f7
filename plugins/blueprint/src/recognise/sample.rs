//! A picture looked at in places: enough to tell what it is, and quick however large it is.

use super::areas;
use super::counts::Counts;
use image::{DynamicImage, GenericImageView};
use std::ops::Range;

/// The most columns or rows of a sample.
const SIDE: u32 = 1000;

/// The least difference between the colour channels of what is coloured.
const CHROMA: u8 = 32;

/// Grey from 0 to 255; nothing where the picture is rather transparent than not.
pub type Tone = Option<u8>;

/// A tone as it is kept: the grey, or [`CLEAR`].
pub type Code = u16;

/// The code of what is transparent.
pub const CLEAR: Code = 256;

/// Pixels at even distances.
#[derive(Debug)]
pub struct Sample {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The tone of each pixel, row by row from the top.
    pub codes: Vec<Code>,
    /// All tones.
    pub tones: Counts,
    /// The tones of what is coloured.
    pub coloured: Counts,
}

impl Sample {
    /// Looks at a picture.
    pub fn of(picture: &DynamicImage) -> Self {
        let (columns, rows) = picture.dimensions();
        let step = columns.max(rows).div_ceil(SIDE).max(1);
        let (width, height) = (columns.div_ceil(step) as usize, rows.div_ceil(step) as usize);
        let looked_at = Seen::of(picture, step as usize);
        let tones = Counts::of(&looked_at.codes);
        Self { width, height, tones, codes: looked_at.codes, coloured: Counts::of(&looked_at.coloured) }
    }

    /// The longer side.
    pub fn side(&self) -> usize {
        self.width.max(self.height)
    }

    /// So many of its pixels as a share.
    pub fn share(&self, count: usize) -> f64 {
        count as f64 / self.codes.len().max(1) as f64
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = &[Code]> {
        self.codes.chunks_exact(self.width.max(1))
    }

    /// The pixels of a column.
    pub fn column(&self, x: usize) -> impl DoubleEndedIterator<Item = &Code> + Clone {
        self.codes.get(x..).unwrap_or_default().iter().step_by(self.width.max(1))
    }

    /// The share of pixels of these tones that lie in areas: in at least `size` of them in a row and in a column.
    pub fn in_areas(&self, size: u8, tones: Range<Code>) -> f64 {
        self.share(areas::covered(&self.codes, self.width, size, tones))
    }
}

/// The pixels looked at.
#[derive(Default)]
struct Seen {
    codes: Vec<Code>,
    /// The codes of those that are coloured.
    coloured: Vec<Code>,
}

impl Seen {
    fn of(picture: &DynamicImage, step: usize) -> Self {
        let (columns, rows) = picture.dimensions();
        let mut seen = Self::default();
        match picture {
            DynamicImage::ImageLuma8(p) => seen.add(p, columns, step, |&[grey]| grey.into(), |_| false),
            DynamicImage::ImageLumaA8(p) => {
                seen.add(p, columns, step, |&[grey, alpha]| veiled(grey.into(), alpha), |_| false);
            }
            DynamicImage::ImageRgb8(p) => {
                let opaque = |&[r, g, b]: &[u8; 3]| [r, g, b, u8::MAX];
                seen.add(p, columns, step, |p| code(&opaque(p)), |p| is_coloured(&opaque(p)));
            }
            DynamicImage::ImageRgba8(p) => seen.add(p, columns, step, code, is_coloured),
            other => {
                let rows = (0..rows).step_by(step);
                let places = rows.flat_map(|y| (0..columns).step_by(step).map(move |x| (x, y)));
                let pixels: Vec<[u8; 4]> = places.map(|(x, y)| other.get_pixel(x, y).0).collect();
                seen.add(pixels.as_flattened(), pixels.len() as u32, 1, code, is_coloured);
            }
        }
        seen
    }

    /// Looks at a picture of `N` bytes a pixel.
    fn add<const N: usize>(
        &mut self,
        samples: &[u8],
        columns: u32,
        step: usize,
        code: impl Fn(&[u8; N]) -> Code,
        is_coloured: impl Fn(&[u8; N]) -> bool,
    ) {
        let (pixels, _) = samples.as_chunks::<N>();
        let columns = columns.max(1) as usize;
        for row in pixels.chunks_exact(columns).step_by(step) {
            if step == 1 {
                self.codes.extend(row.iter().map(&code));
            } else {
                self.codes.extend((0..columns.div_ceil(step)).map(|x| code(&row[x * step])));
            }
            // Pixels are mostly like the one before them.
            let (mut last, mut coloured) = (&row[0], is_coloured(&row[0]));
            for pixel in row.iter().step_by(step) {
                if pixel != last {
                    (last, coloured) = (pixel, is_coloured(pixel));
                }
                if coloured {
                    self.coloured.push(code(pixel));
                }
            }
        }
    }
}

fn code(&[red, green, blue, alpha]: &[u8; 4]) -> Code {
    veiled((u16::from(red) + u16::from(green) + u16::from(blue)) / 3, alpha)
}

fn veiled(tone: Code, alpha: u8) -> Code {
    if alpha < 128 { CLEAR } else { tone }
}

fn is_coloured(&[red, green, blue, alpha]: &[u8; 4]) -> bool {
    let (low, high) = (red.min(green).min(blue), red.max(green).max(blue));
    alpha >= 128 && high - low > CHROMA
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The codes of all pixels looked at and of the coloured ones, by asking for one pixel after the other.
    fn plain(picture: &DynamicImage, step: u32) -> [Vec<Code>; 2] {
        let (columns, rows) = picture.dimensions();
        let [mut codes, mut coloured] = [vec![], vec![]];
        for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
            if x % step != 0 || y % step != 0 {
                continue;
            }
            let [r, g, b, alpha] = picture.get_pixel(x, y).0.map(u16::from);
            let mean = (r + g + b) / 3;
            codes.push(if alpha < 128 { CLEAR } else { mean });
            let is_coloured = alpha >= 128 && r.max(g).max(b) - r.min(g).min(b) > u16::from(CHROMA);
            coloured.extend(is_coloured.then_some(mean));
        }
        [codes, coloured]
    }

    proptest! {
        #[test]
        fn formats_show_the_same_pixels(
            samples in proptest::collection::vec(any::<u8>(), 4 * 13 * 9),
            step in 1..5_u32,
        ) {
            let rgba = image::RgbaImage::from_raw(13, 9, samples).unwrap();
            let rgba = DynamicImage::from(rgba);
            for picture in [
                rgba.to_luma8().into(),
                rgba.to_luma_alpha8().into(),
                rgba.to_rgb8().into(),
                rgba.to_rgba16().into(),
                rgba,
            ] {
                let seen = Seen::of(&picture, step as usize);
                prop_assert_eq!([seen.codes, seen.coloured], plain(&picture, step));
            }
        }
    }
}
