//! Decodes pictures within limits and hands out their pixels.

use image::{DynamicImage, ImageBuffer, ImageDecoder, ImageFormat, ImageReader, Limits, Pixel, Primitive};
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

    /// Turns every pixel into a `T`, row by row from the **bottom**, as grids are stored.
    pub fn map<T>(&self, f: impl FnMut(Tone) -> T) -> Vec<T> {
        match &self.0 {
            DynamicImage::ImageLuma8(b) => map_buffer(b, f),
            DynamicImage::ImageLumaA8(b) => map_buffer(b, f),
            DynamicImage::ImageRgb8(b) => map_buffer(b, f),
            DynamicImage::ImageRgba8(b) => map_buffer(b, f),
            DynamicImage::ImageLuma16(b) => map_buffer(b, f),
            DynamicImage::ImageLumaA16(b) => map_buffer(b, f),
            DynamicImage::ImageRgb16(b) => map_buffer(b, f),
            DynamicImage::ImageRgba16(b) => map_buffer(b, f),
            other => map_buffer(&other.to_rgba32f(), f),
        }
    }
}

fn map_buffer<P, T>(buffer: &ImageBuffer<P, Vec<P::Subpixel>>, mut f: impl FnMut(Tone) -> T) -> Vec<T>
where
    P: Pixel,
    P::Subpixel: Into<f64>,
{
    let mut out = Vec::with_capacity(buffer.width() as usize * buffer.height() as usize);
    for row in buffer.rows().rev() {
        out.extend(row.map(|pixel| f(tone(pixel))));
    }
    out
}

fn tone<P>(pixel: &P) -> Tone
where
    P: Pixel,
    P::Subpixel: Into<f64>,
{
    let full: f64 = P::Subpixel::DEFAULT_MAX_VALUE.into();
    let channels = pixel.channels();
    let (colours, alpha) = match channels.split_last() {
        Some((&alpha, colours)) if P::HAS_ALPHA => (colours, alpha.into() / full),
        _ => (channels, 1.0),
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
