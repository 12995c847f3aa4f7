//! Pictures of plans: scans, photos, exports of drawing programs.

use super::limit::check_size;
use super::paper::dynamic_on_paper;
use super::{density, no_such_page, png, tiff};
use crate::page::Page;
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits, RgbImage};
use planform_sdk::{ErrorKind, PluginError};
use std::io::Cursor;

/// A picture as it is stored.
pub struct Scan {
    /// On white paper.
    pub picture: RgbImage,
    /// Pixels per inch, if the file says so.
    pub dpi: Option<f64>,
    /// How it is to be turned to stand upright.
    pub orientation: Orientation,
}

/// Reads the picture of this number, from 1; formats other than TIFF hold one.
pub fn page(bytes: &[u8], format: ImageFormat, number: u32) -> Result<Page, PluginError> {
    let scan = match format {
        ImageFormat::Tiff => tiff::read(bytes, number)?,
        _ if number > 1 => return Err(no_such_page(number, 1)),
        ImageFormat::Png => png::read(bytes)?,
        _ => read(bytes, format)?,
    };
    Ok(Page {
        picture: upright(scan.picture, scan.orientation),
        dpi: scan.dpi,
        metres_per_pixel: None,
        origin: [0.0; 2],
        texts: vec![],
        drawn: true,
        symbols: vec![],
        walls_only: false,
        warnings: vec![],
    })
}

fn read(bytes: &[u8], format: ImageFormat) -> Result<Scan, PluginError> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    // The size is checked here, with a better sentence.
    reader.limits(Limits::no_limits());
    let mut decoder = reader.into_decoder().map_err(cannot)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height)?;
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let exif = decoder.exif_metadata().ok().flatten();
    let dpi = if format == ImageFormat::Jpeg { density::of_jpeg(bytes, exif) } else { None };
    let picture = DynamicImage::from_decoder(decoder).map_err(cannot)?;
    let picture = dynamic_on_paper(picture).ok_or_else(|| damaged("it has too few pixels"))?;
    Ok(Scan { picture, dpi, orientation })
}

fn upright(picture: RgbImage, orientation: Orientation) -> RgbImage {
    let mut picture = DynamicImage::ImageRgb8(picture);
    picture.apply_orientation(orientation);
    picture.into_rgb8()
}

/// The picture is not what its format promises.
pub fn damaged(why: &str) -> PluginError {
    PluginError::new(ErrorKind::BadInput, format!("the picture cannot be decoded: {why}"))
        .advise("the file may be damaged or cut short: save or copy it again")
}

/// The picture is sound, but not of a kind that is read.
pub fn unsupported(why: &str) -> PluginError {
    PluginError::new(ErrorKind::Unsupported, format!("the picture is of a kind that is not read: {why}"))
        .advise("save it as PNG")
}

fn cannot(e: ImageError) -> PluginError {
    match e {
        ImageError::Unsupported(e) => unsupported(&e.to_string()),
        other => damaged(&other.to_string()),
    }
}

#[cfg(test)]
mod tests;
