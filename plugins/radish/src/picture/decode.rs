//! Decodes pictures within limits.

use super::wide;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits, RgbaImage};
use planform_sdk::{ErrorKind, Grid, GridError, PluginError};
use std::io::Cursor;

/// The most memory that a decoded picture may take: 1 GiB.
const MEMORY_LIMIT: u64 = 1 << 30;

/// The formats that are read.
const FORMATS: [ImageFormat; 6] = [
    ImageFormat::Png,
    ImageFormat::Gif,
    ImageFormat::Jpeg,
    ImageFormat::Bmp,
    ImageFormat::Tiff,
    ImageFormat::Pnm,
];

/// The least difference between a pixel's strongest and weakest channel that makes it coloured, and that of one near
/// such a pixel, where lines are smoothed.
const COLOURED: (u8, u8) = (40, 10);

/// How far lines are smoothed, pixels: JPEG keeps colours at half the resolution.
const BLEED: usize = 3;

/// How many pixels are looked at at once.
const BLOCK: usize = 16;

/// A picture's pixels, row by row from above.
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    pixels: RgbaImage,
}

/// The format of a picture that begins with these bytes, if it is one that is read.
pub fn format(head: &[u8]) -> Option<ImageFormat> {
    let format = image::guess_format(head).ok()?;
    let plausible = match format {
        // Two letters and a digit, or two letters, also begin many a text.
        ImageFormat::Pnm => head.get(2).is_some_and(|b| b.is_ascii_whitespace() || *b == b'#'),
        ImageFormat::Bmp => head.get(15..18) == Some(&[0; 3]),
        _ => true,
    };
    (plausible && FORMATS.contains(&format)).then_some(format)
}

/// Whether a document that begins with these bytes is a picture that is read here.
pub fn is_picture(head: &[u8]) -> bool {
    format(head).is_some()
}

/// Whether a picture says at its head that it holds no colours.
pub fn is_grey(bytes: &[u8]) -> bool {
    let decoder =
        format(bytes).and_then(|f| ImageReader::with_format(Cursor::new(bytes), f).into_decoder().ok());
    decoder.is_some_and(|d| !d.color_type().has_color())
}

/// Decodes a picture as it is stored; of a moving one, the first. Its size is checked before memory is taken.
pub fn decode(bytes: &[u8]) -> Result<DynamicImage, PluginError> {
    let format = format(bytes).ok_or_else(|| {
        PluginError::new(ErrorKind::BadInput, "the first bytes are not those of a picture that is read")
            .advise("give a PNG, GIF, JPEG, BMP, TIFF or PNM picture")
    })?;
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    limits.max_alloc = Some(MEMORY_LIMIT);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(|e| cannot_decode(&e))?;
    let (width, height) = decoder.dimensions();
    Grid::check_size(width, height).map_err(refuse_size)?;
    if decoder.total_bytes() > MEMORY_LIMIT {
        return Err(PluginError::new(ErrorKind::Limit, "the picture takes more than 1 GiB of memory")
            .advise("save it with 8 bits for each colour, or shrink it"));
    }
    DynamicImage::from_decoder(decoder).map_err(|e| cannot_decode(&e))
}

/// The picture, if any of its pixels is of a colour.
pub fn coloured(picture: &DynamicImage) -> Option<Picture> {
    let colour = match picture {
        DynamicImage::ImageRgb8(p) => shows_colour(p, |&[r, g, b]| [r, g, b, u8::MAX]),
        DynamicImage::ImageRgba8(p) => shows_colour(p, |&pixel| pixel),
        other => shows_colour(&other.to_rgba8(), |&pixel| pixel),
    };
    colour.then(|| Picture::of(picture.to_rgba8()))
}

/// Whether any pixel of `N` bytes is of a colour.
fn shows_colour<const N: usize>(samples: &[u8], rgba: impl Fn(&[u8; N]) -> [u8; 4]) -> bool {
    let is_colour = |pixel: &[u8; N]| spread(rgba(pixel)) >= COLOURED.0;
    let (pixels, _) = samples.as_chunks::<N>();
    let mut seen = [0; N];
    pixels.chunks(BLOCK).any(|block| {
        // Most are like one pixel that was looked at before, which is quickly told.
        let is_new = block.iter().fold(false, |new, pixel| new | (*pixel != seen));
        seen = block[block.len() - 1];
        is_new && block.iter().any(is_colour)
    })
}

impl Picture {
    /// Decodes a picture; of a moving one, the first. Its size is checked before memory is taken.
    pub fn decode(bytes: &[u8]) -> Result<Self, PluginError> {
        decode(bytes).map(|picture| Self::of(picture.into_rgba8()))
    }

    fn of(pixels: RgbaImage) -> Self {
        Self { width: pixels.width() as usize, height: pixels.height() as usize, pixels }
    }

    /// The mean of each pixel's colours; none where it is rather transparent than not.
    pub fn greys(&self) -> impl Iterator<Item = Option<u8>> + '_ {
        self.pixels.pixels().map(|p| {
            let [r, g, b, alpha] = p.0.map(u16::from);
            (alpha >= 128).then_some(((r + g + b + 1) / 3) as u8)
        })
    }

    /// The colour of each pixel.
    pub fn colours(&self) -> impl Iterator<Item = [u8; 3]> + '_ {
        self.pixels.pixels().map(|p| [p.0[0], p.0[1], p.0[2]])
    }

    /// Which pixels are of a colour, or of a tint near one.
    pub fn coloured(&self) -> Vec<bool> {
        let spread: Vec<u8> = self.pixels.pixels().map(|p| spread(p.0)).collect();
        let strong: Vec<bool> = spread.iter().map(|s| *s >= COLOURED.0).collect();
        let near = wide::near(&strong, self.width, BLEED);
        spread.iter().zip(near).map(|(s, near)| near && *s >= COLOURED.1).collect()
    }
}

fn spread([r, g, b, alpha]: [u8; 4]) -> u8 {
    if alpha < 128 { 0 } else { r.max(g).max(b) - r.min(g).min(b) }
}

fn refuse_size(e: GridError) -> PluginError {
    match e {
        GridError::TooLarge { .. } => {
            PluginError::new(ErrorKind::Limit, e.to_string()).advise("shrink the picture")
        }
        _ => PluginError::new(ErrorKind::BadInput, e.to_string()),
    }
}

fn cannot_decode(e: &image::ImageError) -> PluginError {
    let (kind, advice) = match e {
        image::ImageError::Limits(_) => (ErrorKind::Limit, "shrink it"),
        image::ImageError::Unsupported(_) => (ErrorKind::Unsupported, "save it as a plain 8 bit PNG"),
        _ => (ErrorKind::BadInput, "the file may be damaged or cut short: save or copy it again"),
    };
    PluginError::new(kind, format!("the picture cannot be decoded: {e}")).advise(advice)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Few colours, so that neighbours are often alike.
    fn pixels() -> impl Strategy<Value = Vec<[u8; 4]>> {
        let pixel = prop_oneof![
            40 => Just([255, 255, 255, 255]),
            40 => Just([205, 205, 205, 255]),
            5 => Just([0, 0, 0, 0]),
            5 => Just([205, 190, 205, 255]),
            1 => any::<[u8; 4]>(),
        ];
        proptest::collection::vec(pixel, 1..90)
    }

    proptest! {
        #[test]
        fn a_picture_with_a_coloured_pixel_is_coloured(pixels in pixels()) {
            let rgba = RgbaImage::from_raw(pixels.len() as u32, 1, pixels.concat()).unwrap();
            for picture in [DynamicImage::from(rgba.clone()).to_rgb8().into(), DynamicImage::from(rgba)] {
                let plain = Picture::of(picture.to_rgba8()).coloured().contains(&true);
                prop_assert_eq!(coloured(&picture).is_some(), plain);
            }
        }
    }
}
