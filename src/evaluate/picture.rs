//! Image files as one number for each pixel.

use super::error::{bad, limit};
use image::{DynamicImage, GenericImageView, ImageReader, Limits, Pixel, Rgba};
use planform_sdk::{ErrorKind, MAX_CELLS, PluginError};
use std::io::Cursor;

/// The colours of an image, row by row from the top.
///
/// A colour is `0xRRGGBB`; a pixel that is transparent shows the black behind it. Sixteen-bit greys are room numbers,
/// not shades: such a colour is the number itself.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Picture {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) colours: Vec<u32>,
    /// Whether the colours are room numbers.
    pub(super) numbers: bool,
}

impl Picture {
    /// Decodes an image file of at most [`MAX_CELLS`] pixels.
    pub(super) fn decode(bytes: &[u8]) -> Result<Self, PluginError> {
        check_size(bytes)?;
        let mut reader = guess(bytes)?;
        let mut limits = Limits::default();
        limits.max_alloc = Some(MAX_CELLS * 8);
        reader.limits(limits);
        Ok(Self::of_image(&reader.decode().map_err(unreadable)?))
    }

    fn of_image(image: &DynamicImage) -> Self {
        let colours = match image {
            DynamicImage::ImageLuma16(grey) => grey.iter().map(|&v| v.into()).collect(),
            DynamicImage::ImageLuma8(grey) => grey.iter().map(|&v| u32::from(v) * 0x01_01_01).collect(),
            DynamicImage::ImageLumaA16(i) => i.pixels().map(|p| colour(high_bytes(p.to_rgba()))).collect(),
            DynamicImage::ImageRgb16(i) => i.pixels().map(|p| colour(high_bytes(p.to_rgba()))).collect(),
            DynamicImage::ImageRgba16(i) => i.pixels().map(|p| colour(high_bytes(*p))).collect(),
            other => other.pixels().map(|(_, _, p)| colour(p)).collect(),
        };
        let numbers = matches!(image, DynamicImage::ImageLuma16(_));
        Self { width: image.width() as usize, height: image.height() as usize, colours, numbers }
    }
}

fn check_size(bytes: &[u8]) -> Result<(), PluginError> {
    let (width, height) = guess(bytes)?.into_dimensions().map_err(unreadable)?;
    if u64::from(width) * u64::from(height) > MAX_CELLS {
        return Err(limit(format!("has {width} x {height} pixels, and {MAX_CELLS} are the most")));
    }
    Ok(())
}

fn guess(bytes: &[u8]) -> Result<ImageReader<Cursor<&[u8]>>, PluginError> {
    ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(PluginError::from)
}

fn unreadable(e: image::ImageError) -> PluginError {
    match e {
        image::ImageError::Unsupported(_) => {
            PluginError::new(ErrorKind::Unsupported, "is neither a picture nor a GeoJSON layout")
                .advise("these two are read: a picture (PNG, PNM, BMP, TIFF, JPEG), and a layout named *.geojson or *.json")
        }
        e => bad(format!("cannot be read as an image: {e}")),
    }
}

fn high_bytes(p: Rgba<u16>) -> Rgba<u8> {
    Rgba(p.0.map(|v| (v >> 8) as u8))
}

fn colour(Rgba([r, g, b, alpha]): Rgba<u8>) -> u32 {
    [r, g, b].iter().fold(0, |code, &v| code << 8 | over_black(v, alpha))
}

/// `v * alpha / 255`, rounded.
fn over_black(v: u8, alpha: u8) -> u32 {
    (u32::from(v) * u32::from(alpha) + 127) / 255
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{ImageFormat, LumaA, RgbaImage};

    fn png(image: impl Into<DynamicImage>) -> Vec<u8> {
        let mut bytes = Cursor::new(vec![]);
        image.into().write_to(&mut bytes, ImageFormat::Png).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn transparent_pixels_show_black() {
        let mut image = RgbaImage::from_pixel(3, 1, Rgba([255, 255, 255, 255]));
        image.put_pixel(1, 0, Rgba([255, 255, 255, 0]));
        image.put_pixel(2, 0, Rgba([200, 100, 255, 128]));
        assert_eq!(Picture::decode(&png(image)).unwrap().colours, [0xFF_FF_FF, 0, 0x64_32_80]);
        let grey = image::ImageBuffer::from_pixel(1, 1, LumaA([254u8, 0]));
        assert_eq!(Picture::decode(&png(grey)).unwrap().colours, [0]);
    }

    #[test]
    fn sixteen_bit_greys_are_numbers() {
        let image = image::ImageBuffer::from_fn(3, 1, |x, _| image::Luma([[1u16, 300, 65535][x as usize]]));
        let picture = Picture::decode(&png(image)).unwrap();
        assert_eq!((picture.colours.as_slice(), picture.numbers), ([1, 300, 65535].as_slice(), true));
    }

    #[test]
    fn sixteen_bit_colours_keep_their_high_bytes() {
        let image = image::ImageBuffer::from_pixel(1, 1, image::Rgb([0xFFFFu16, 0x12FF, 0x00FF]));
        assert_eq!(Picture::decode(&png(image)).unwrap().colours, [0xFF_12_00]);
    }

    #[test]
    fn huge_and_broken_images_are_refused() {
        let e = Picture::decode(b"P5\n100000 100000\n255\n").unwrap_err();
        assert_eq!(e.kind, ErrorKind::Limit);
        assert_eq!(Picture::decode(b"hello").unwrap_err().kind, ErrorKind::Unsupported);
        let whole = png(RgbaImage::new(9, 9));
        assert_eq!(Picture::decode(&whole[..whole.len() / 2]).unwrap_err().kind, ErrorKind::BadInput);
    }
}
