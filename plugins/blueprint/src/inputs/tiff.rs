//! TIFF pictures, of which one file can hold several.

use super::density::{of_both, per_centimetre};
use super::limit::check_size;
use super::no_such_page;
use super::paper::on_paper;
use super::picture::{Scan, damaged, unsupported};
use image::RgbImage;
use image::metadata::Orientation;
use planform_sdk::{ErrorKind, PluginError};
use std::io::Cursor;
use tiff::decoder::{BufferLayoutPreference, Decoder, DecodingResult, Limits, ifd::Value};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

type Tiff<'a> = Decoder<Cursor<&'a [u8]>>;

/// The most pages that are counted.
const MAX_PAGES: usize = 10_000;
/// The most memory of a decoded picture, bytes: the largest picture with four channels of 16 bits.
const MEMORY: usize = 8 * super::limit::MAX_PIXELS as usize;

/// Decodes the picture of this number, from 1.
pub fn read(bytes: &[u8], number: u32) -> Result<Scan, PluginError> {
    let mut tiff = open(bytes, number)?;
    let (width, height) = tiff.dimensions().map_err(cannot)?;
    check_size(width, height)?;
    let picture = picture(&mut tiff, width, height)?;
    let orientation =
        whole(&mut tiff, Tag::Orientation).and_then(|v| Orientation::from_exif(v.min(255) as u8));
    let dpi = density(&mut tiff);
    Ok(Scan { picture, dpi, orientation: orientation.unwrap_or(Orientation::NoTransforms) })
}

fn open(bytes: &[u8], number: u32) -> Result<Tiff<'_>, PluginError> {
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MEMORY;
    limits.intermediate_buffer_size = MEMORY;
    let mut tiff = Decoder::new(Cursor::new(bytes)).map_err(cannot)?.with_limits(limits);
    for passed in 1..number as usize {
        if passed >= MAX_PAGES || !tiff.more_images() {
            return Err(no_such_page(number, passed));
        }
        tiff.next_image().map_err(cannot)?;
    }
    Ok(tiff)
}

fn picture(tiff: &mut Tiff<'_>, width: u32, height: u32) -> Result<RgbImage, PluginError> {
    let colour = tiff.colortype().map_err(cannot)?;
    let (channels, depth) = (colour.num_samples(), colour.bit_depth());
    let mut samples = DecodingResult::U8(vec![]);
    let layout = tiff.read_image_to_buffer(&mut samples).map_err(cannot)?;
    let bytes = match samples {
        DecodingResult::U8(bytes) if depth == 8 => bytes,
        DecodingResult::U8(bits) if depth < 8 => spread(&bits, width as usize, channels.into(), depth),
        DecodingResult::U16(words) if depth == 16 => words.into_iter().map(|w| (w >> 8) as u8).collect(),
        _ => return Err(unsupported(&format!("its samples have {depth} bits"))),
    };
    let bytes = if layout.planes > 1 { interleave(&bytes, &layout) } else { bytes };
    let (kept, samples) = paint(colour, bytes)?;
    on_paper(width, height, kept, samples).ok_or_else(|| damaged("it has too few pixels"))
}

/// Samples of less than 8 bits, whose rows begin at whole bytes, as bytes of the full range.
fn spread(bits: &[u8], width: usize, channels: usize, depth: u8) -> Vec<u8> {
    let in_row = width * channels;
    let highest = (1_u8 << depth) - 1;
    let value = |row: &[u8], i: usize| {
        let first = i * usize::from(depth);
        let shift = 8 - depth - (first % 8) as u8;
        (row[first / 8] >> shift & highest) * (255 / highest)
    };
    let row_bytes = (in_row * usize::from(depth)).div_ceil(8);
    bits.chunks_exact(row_bytes).flat_map(|row| (0..in_row).map(move |i| value(row, i))).collect()
}

/// Planes of one channel each as pixels.
fn interleave(bytes: &[u8], layout: &BufferLayoutPreference) -> Vec<u8> {
    let plane = bytes.len() / layout.planes;
    (0..plane).flat_map(|i| (0..layout.planes).map(move |p| bytes[p * plane + i])).collect()
}

/// Grey or RGB, maybe with alpha, of whatever the colours are: the number of channels, and their samples.
fn paint(colour: ColorType, bytes: Vec<u8>) -> Result<(usize, Vec<u8>), PluginError> {
    match colour {
        ColorType::Gray(_) => Ok((1, bytes)),
        ColorType::GrayA(_) | ColorType::Multiband { num_samples: 2, .. } => Ok((2, bytes)),
        ColorType::RGB(_) | ColorType::YCbCr(_) => Ok((3, bytes)),
        ColorType::RGBA(_) => Ok((4, bytes)),
        ColorType::CMYK(_) => Ok((3, bytes.chunks_exact(4).flat_map(rgb_of_cmyk).collect())),
        other => Err(unsupported(&format!("its colours are of the kind {other:?}"))),
    }
}

fn rgb_of_cmyk(ink: &[u8]) -> [u8; 3] {
    let white = |i: usize| 255 - u32::from(ink[i]);
    [0, 1, 2].map(|i| (white(i) * white(3) / 255) as u8)
}

fn density(tiff: &mut Tiff<'_>) -> Option<f64> {
    let (x, y) = (ratio(tiff, Tag::XResolution)?, ratio(tiff, Tag::YResolution)?);
    match whole(tiff, Tag::ResolutionUnit).unwrap_or(2) {
        2 => of_both(x, y),
        3 => per_centimetre(x, y),
        _ => None,
    }
}

fn ratio(tiff: &mut Tiff<'_>, tag: Tag) -> Option<f64> {
    match tiff.find_tag(tag).ok()?? {
        Value::Rational(above, below) if below > 0 => Some(f64::from(above) / f64::from(below)),
        _ => None,
    }
}

fn whole(tiff: &mut Tiff<'_>, tag: Tag) -> Option<u16> {
    tiff.find_tag(tag).ok()??.into_u16().ok()
}

fn cannot(e: TiffError) -> PluginError {
    match e {
        TiffError::UnsupportedError(what) => unsupported(&what.to_string()),
        TiffError::LimitsExceeded => {
            PluginError::new(ErrorKind::Limit, "the picture takes too much memory to decode")
                .advise("save it as 8 bit grey, or shrink it")
        }
        other => damaged(&other.to_string()),
    }
}
