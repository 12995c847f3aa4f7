//! Decodes pictures within limits and hands out their pixels.

use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits, Primitive};
use planform_sdk::runs::runs;
use planform_sdk::{ErrorKind, Grid, GridError, PluginError};
use std::io::Cursor;

/// The most memory that a decoded picture may take: 1 GiB.
const MEMORY_LIMIT: u64 = 1 << 30;

/// A decoded picture that is no larger than a grid may be.
#[derive(Debug)]
pub struct Picture(DynamicImage);

/// One pixel, whatever its picture's format.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tone {
    /// Mean of the colour channels: 0 black, 1 white.
    pub shade: f64,
    /// 0 transparent, 1 opaque.
    pub alpha: f64,
}

impl Picture {
    /// Decodes a picture. Its size is checked before memory is taken.
    pub fn decode(bytes: &[u8], format: ImageFormat) -> Result<Self, PluginError> {
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        let mut limits = Limits::default();
        limits.max_alloc = Some(MEMORY_LIMIT);
        reader.limits(limits);
        let decoder = reader.into_decoder().map_err(|e| cannot_decode(&e))?;
        let (width, height) = decoder.dimensions();
        Grid::check_size(width, height).map_err(refuse_size)?;
        check_memory(width, height, decoder.total_bytes())?;
        DynamicImage::from_decoder(decoder).map(Self).map_err(|e| cannot_decode(&e))
    }

    /// The picture that was decoded before, if it is no larger than one decoded here may be.
    pub fn of(picture: DynamicImage) -> Result<Self, PluginError> {
        let (width, height) = (picture.width(), picture.height());
        Grid::check_size(width, height).map_err(refuse_size)?;
        check_memory(width, height, picture.as_bytes().len() as u64)?;
        Ok(Self(picture))
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.0.width()
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.0.height()
    }

    /// Whether the picture has an alpha channel, be it opaque throughout.
    pub fn has_alpha(&self) -> bool {
        self.0.color().has_alpha()
    }

    /// Turns every pixel into a `T`, row by row from the **bottom**, as grids are stored. `f` is asked once for each run
    /// of equal pixels.
    pub fn map<T: Copy>(&self, f: impl Fn(Tone) -> T) -> Vec<T> {
        let columns = self.width() as usize;
        match &self.0 {
            DynamicImage::ImageLuma8(b) => map_rows::<_, 1, _>(b, columns, f),
            DynamicImage::ImageLumaA8(b) => map_rows::<_, 2, _>(b, columns, f),
            DynamicImage::ImageRgb8(b) => map_rows::<_, 3, _>(b, columns, f),
            DynamicImage::ImageRgba8(b) => map_rows::<_, 4, _>(b, columns, f),
            DynamicImage::ImageLuma16(b) => map_rows::<_, 1, _>(b, columns, f),
            DynamicImage::ImageLumaA16(b) => map_rows::<_, 2, _>(b, columns, f),
            DynamicImage::ImageRgb16(b) => map_rows::<_, 3, _>(b, columns, f),
            DynamicImage::ImageRgba16(b) => map_rows::<_, 4, _>(b, columns, f),
            other => map_rows::<_, 4, _>(&other.to_rgba32f(), columns, f),
        }
    }
}

/// Turns every pixel of `N` samples, the rows from the last to the first.
fn map_rows<S, const N: usize, T: Copy>(samples: &[S], columns: usize, f: impl Fn(Tone) -> T) -> Vec<T>
where
    S: Primitive + Into<f64>,
{
    let (pixels, _) = samples.as_chunks::<N>();
    let mut out = Vec::with_capacity(pixels.len());
    for row in pixels.chunks_exact(columns).rev() {
        for run in runs(row) {
            out.resize(out.len() + run.len(), f(tone(&run[0])));
        }
    }
    out
}

/// The last of two or four samples is alpha.
fn tone<S: Primitive + Into<f64>, const N: usize>(pixel: &[S; N]) -> Tone {
    let full: f64 = S::DEFAULT_MAX_VALUE.into();
    let (colours, alpha) = match pixel.split_last() {
        Some((&alpha, colours)) if N.is_multiple_of(2) => (colours, alpha.into() / full),
        _ => (pixel.as_slice(), 1.0),
    };
    let sum: f64 = colours.iter().map(|&c| c.into()).sum();
    // A picture of floats may hold anything; what is not a number is not known.
    match sum / colours.len() as f64 / full {
        shade if shade.is_nan() => Tone { shade: 0.0, alpha: 0.0 },
        shade => Tone { shade: shade.clamp(0.0, 1.0), alpha },
    }
}

fn refuse_size(e: GridError) -> PluginError {
    match e {
        GridError::TooLarge { .. } => {
            PluginError::new(ErrorKind::Limit, e.to_string()).advise("shrink the picture")
        }
        _ => PluginError::new(ErrorKind::BadInput, e.to_string()),
    }
}

fn check_memory(width: u32, height: u32, bytes: u64) -> Result<(), PluginError> {
    if bytes <= MEMORY_LIMIT {
        return Ok(());
    }
    let message = format!(
        "the picture is too large: {width} x {height} pixels take {bytes} bytes; the most are {MEMORY_LIMIT}"
    );
    Err(PluginError::new(ErrorKind::Limit, message).advise("save it as 8 bit grey, or shrink it"))
}

fn cannot_decode(e: &image::ImageError) -> PluginError {
    let (kind, advice) = match e {
        image::ImageError::Limits(_) => (ErrorKind::Limit, "shrink it"),
        image::ImageError::Unsupported(_) => (ErrorKind::Unsupported, "save it as a plain 8 bit grey PNG"),
        _ => (ErrorKind::BadInput, "the file may be damaged or cut short: save or copy it again"),
    };
    PluginError::new(kind, format!("the picture cannot be decoded: {e}")).advise(advice)
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{ImageBuffer, Luma, LumaA, Pixel, Rgb, Rgba};
    use proptest::prelude::*;

    /// Samples of which neighbours are often equal.
    fn samples() -> impl Strategy<Value = Vec<u8>> {
        proptest::collection::vec(prop_oneof![Just(0_u8), Just(205), Just(255), any::<u8>()], 4..400)
    }

    /// Five columns of pixels made of these samples.
    fn buffer<P: Pixel<Subpixel = u8>>(samples: &[u8]) -> ImageBuffer<P, Vec<u8>> {
        let row = 5 * usize::from(P::CHANNEL_COUNT);
        let rows = samples.len().div_ceil(row);
        let all = samples.iter().copied().cycle().take(rows * row).collect();
        ImageBuffer::from_raw(5, rows as u32, all).unwrap()
    }

    /// Mean and alpha of each pixel, by asking for one pixel after the other.
    fn plain<P: Pixel<Subpixel = u8>>(buffer: &ImageBuffer<P, Vec<u8>>) -> Vec<[u64; 2]> {
        let of = |pixel: &P| {
            let alpha = if P::HAS_ALPHA { pixel.channels()[pixel.channels().len() - 1] } else { 255 };
            let colours = &pixel.channels()[..pixel.channels().len() - usize::from(P::HAS_ALPHA)];
            let sum: f64 = colours.iter().map(|&c| f64::from(c)).sum();
            bits(Tone { shade: sum / colours.len() as f64 / 255.0, alpha: f64::from(alpha) / 255.0 })
        };
        buffer.rows().rev().flat_map(|row| row.map(of)).collect()
    }

    fn bits(tone: Tone) -> [u64; 2] {
        [tone.shade.to_bits(), tone.alpha.to_bits()]
    }

    proptest! {
        #[test]
        fn every_pixel_is_turned(samples in samples()) {
            let grey = buffer::<Luma<u8>>(&samples);
            prop_assert_eq!(Picture(grey.clone().into()).map(bits), plain(&grey));
            let veiled = buffer::<LumaA<u8>>(&samples);
            prop_assert_eq!(Picture(veiled.clone().into()).map(bits), plain(&veiled));
            let rgb = buffer::<Rgb<u8>>(&samples);
            prop_assert_eq!(Picture(rgb.clone().into()).map(bits), plain(&rgb));
            let rgba = buffer::<Rgba<u8>>(&samples);
            prop_assert_eq!(Picture(rgba.clone().into()).map(bits), plain(&rgba));
        }
    }
}
