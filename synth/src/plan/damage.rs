//! What scanners, cameras and compression do to a drawing.

use super::PlanStyle;
use crate::rng::Rng;
use image::codecs::jpeg::{JpegDecoder, JpegEncoder, PixelDensity};
use image::{DynamicImage, RgbImage};
use std::io::Cursor;

/// How a picture is damaged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Damage {
    /// By this angle the sheet lies turned, radians.
    pub(super) skew: f64,
    light: Light,
    /// Grey of the paper.
    paper: f32,
    /// Share of a pixel's value that comes from its neighbours to both sides.
    blur: f32,
    /// Standard deviation of the noise, grey levels.
    noise: f32,
    /// Quality of the JPEG file.
    jpeg: Option<u8>,
    inverted: bool,
}

/// The light on the sheet: full in the brightest place.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Light {
    /// Loss from one edge of the sheet to the other, across and down.
    slope: (f32, f32),
    /// Loss in the corners.
    vignette: f32,
}

impl Damage {
    pub(super) fn draw(style: PlanStyle, rng: &mut Rng) -> Self {
        let photo = rng.chance(0.3);
        let scan = photo || rng.chance(0.5);
        let askew = scan && rng.chance(0.85);
        let light = Light {
            slope: (rng.range((-0.2, 0.2)) as f32, rng.range((-0.2, 0.2)) as f32),
            vignette: rng.range((0.05, 0.25)) as f32,
        };
        let dark = Light { slope: (0.0, 0.0), vignette: 0.0 };
        Self {
            skew: if askew { rng.range((-2.0, 2.0)).to_radians() } else { 0.0 },
            light: if photo { light } else { dark },
            paper: if scan { rng.range((235.0, 254.0)) as f32 } else { 255.0 },
            blur: if scan { rng.range((0.03, 0.2)) as f32 } else { 0.0 },
            noise: if scan { rng.range((1.0, 7.0)) as f32 } else { 0.0 },
            jpeg: rng.chance(0.75).then(|| 45 + rng.index(50) as u8),
            inverted: style == PlanStyle::Blueprint && !photo && rng.chance(0.08),
        }
    }

    /// The damaged picture, and the bytes of its file if that is a JPEG.
    pub(super) fn apply(
        &self,
        mut picture: RgbImage,
        dpi: Option<f64>,
        seed: u64,
    ) -> (RgbImage, Option<Vec<u8>>) {
        if self.inverted {
            picture.iter_mut().for_each(|v| *v = 255 - *v);
        }
        if self.blur > 0.0 {
            blur(&mut picture, self.blur);
        }
        self.shade(&mut picture, seed);
        let file = self.jpeg.and_then(|quality| compressed(&picture, quality, dpi));
        let read = file.as_ref().and_then(|bytes| read(bytes));
        match read {
            Some(read) => (read, file),
            None => (picture, None),
        }
    }

    /// Light and noise.
    fn shade(&self, picture: &mut RgbImage, seed: u64) {
        let (width, height) = (picture.width() as f32, picture.height() as f32);
        let mut noise = Noise::new(seed, self.noise);
        let row = 3 * picture.width() as usize;
        if row == 0 {
            return;
        }
        for (y, line) in picture.chunks_exact_mut(row).enumerate() {
            let v = y as f32 / height - 0.5;
            for (x, pixel) in line.chunks_exact_mut(3).enumerate() {
                let gain = self.light.at(x as f32 / width - 0.5, v) * self.paper / 255.0;
                let grain = noise.next();
                for channel in pixel {
                    *channel = (f32::from(*channel) * gain + grain).clamp(0.0, 255.0) as u8;
                }
            }
        }
    }
}

impl Light {
    /// `u` and `v` from -0.5 to 0.5.
    fn at(&self, u: f32, v: f32) -> f32 {
        let (a, b) = self.slope;
        1.0 - (a.abs() + b.abs()) / 2.0 + a * u + b * v - self.vignette * 2.0 * (u * u + v * v)
    }
}

/// Normal noise out of a table, which costs little for millions of pixels.
struct Noise {
    table: Vec<f32>,
    state: u64,
}

impl Noise {
    fn new(seed: u64, deviation: f32) -> Self {
        let mut rng = Rng::new(seed, 303);
        Self { table: (0..1024).map(|_| rng.gauss() as f32 * deviation).collect(), state: seed | 1 << 40 }
    }

    fn next(&mut self) -> f32 {
        // Marsaglia's xorshift, 2003.
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        self.table[(self.state >> 32) as usize % self.table.len()]
    }
}

/// Mixes every pixel with its neighbours, first along the rows, then along the columns.
fn blur(picture: &mut RgbImage, share: f32) {
    let row = 3 * picture.width() as usize;
    for step in [3, row] {
        let source = picture.as_raw().clone();
        let last = source.len().saturating_sub(step);
        for (i, value) in picture.iter_mut().enumerate().take(last).skip(step) {
            let sides = f32::from(source[i - step]) + f32::from(source[i + step]);
            *value = (f32::from(source[i]) * (1.0 - 2.0 * share) + sides * share) as u8;
        }
    }
}

fn compressed(picture: &RgbImage, quality: u8, dpi: Option<f64>) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = JpegEncoder::new_with_quality(&mut bytes, quality);
    if let Some(dpi) = dpi {
        encoder.set_pixel_density(PixelDensity::dpi(dpi as u16));
    }
    encoder.encode_image(picture).ok()?;
    Some(bytes)
}

fn read(bytes: &[u8]) -> Option<RgbImage> {
    let decoder = JpegDecoder::new(Cursor::new(bytes)).ok()?;
    Some(DynamicImage::from_decoder(decoder).ok()?.into_rgb8())
}
