//! PNG pictures.

use super::density::per_metre;
use super::limit::check_size;
use super::paper::on_paper;
use super::picture::{Scan, damaged};
use image::metadata::Orientation;
use planform_sdk::PluginError;
use png::{ColorType, Decoder, DecodingError, Info, Transformations, Unit};
use std::io::Cursor;

/// Decodes the picture to 8 bits a sample, whatever it has.
pub fn read(bytes: &[u8]) -> Result<Scan, PluginError> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(cannot)?;
    let (width, height) = reader.info().size();
    check_size(width, height)?;
    let dpi = density(reader.info());
    let orientation = reader.info().exif_metadata.as_ref().and_then(|e| Orientation::from_exif_chunk(e));
    let mut samples = vec![0; reader.output_buffer_size().ok_or_else(|| damaged("it lies about its size"))?];
    let frame = reader.next_frame(&mut samples).map_err(cannot)?;
    samples.truncate(frame.buffer_size());
    let picture = on_paper(width, height, channels(frame.color_type), samples)
        .ok_or_else(|| damaged("it has too few pixels"))?;
    Ok(Scan { picture, dpi, orientation: orientation.unwrap_or(Orientation::NoTransforms) })
}

fn density(info: &Info<'_>) -> Option<f64> {
    let dims = info.pixel_dims.filter(|d| d.unit == Unit::Meter)?;
    per_metre(dims.xppu.into(), dims.yppu.into())
}

fn channels(colour: ColorType) -> usize {
    match colour {
        ColorType::Grayscale | ColorType::Indexed => 1,
        ColorType::GrayscaleAlpha => 2,
        ColorType::Rgb => 3,
        ColorType::Rgba => 4,
    }
}

fn cannot(e: DecodingError) -> PluginError {
    damaged(&e.to_string())
}
