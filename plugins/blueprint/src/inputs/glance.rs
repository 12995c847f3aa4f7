//! A picture as it is stored, to be told from a robot's map: neither turned nor laid on paper.

use super::limit::check_size;
use super::picture::damaged;
use super::{Kind, kind};
use image::{DynamicImage, ImageDecoder, ImageReader};
use planform_sdk::{PluginError, Source};
use std::io::Cursor;

/// The picture of a document that is one.
///
/// # Errors
/// When it is none, is damaged or too large.
pub fn glance(source: &Source) -> Result<DynamicImage, PluginError> {
    let Some(Kind::Picture(format)) = kind(&source.path, &source.bytes) else {
        return Err(damaged("it is no picture"));
    };
    let decoder = ImageReader::with_format(Cursor::new(&source.bytes), format).into_decoder();
    let decoder = decoder.map_err(|e| damaged(&e.to_string()))?;
    let (width, height) = decoder.dimensions();
    check_size(width, height)?;
    DynamicImage::from_decoder(decoder).map_err(|e| damaged(&e.to_string()))
}
