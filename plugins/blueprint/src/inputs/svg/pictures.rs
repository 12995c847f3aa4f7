//! Pictures inside of an SVG: those that are in the file itself are drawn, files and addresses are never opened.

use super::super::limit::MAX_PIXELS;
use image::{ImageFormat, ImageReader};
use resvg::usvg::{ImageHrefResolver, ImageKind};
use std::io::Cursor;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

/// What becomes of a document's pictures.
#[derive(Debug, Default)]
pub struct Pictures {
    /// The pixels of all that are drawn; a picture that is used twice counts twice.
    pixels: AtomicU64,
    refused: AtomicBool,
}

impl Pictures {
    /// Tells the renderer which pictures to draw.
    pub fn resolver(&self) -> ImageHrefResolver<'_> {
        ImageHrefResolver {
            resolve_data: Box::new(|_, data, _| {
                self.kept(drawable(&data).filter(|p| self.has_room(p.pixels)), data)
            }),
            resolve_string: Box::new(|_, _| self.kept(None, Arc::default())),
        }
    }

    /// Whether any is drawn.
    pub fn are_drawn(&self) -> bool {
        self.pixels.load(Relaxed) > 0
    }

    /// Whether any was left out.
    pub fn are_refused(&self) -> bool {
        self.refused.load(Relaxed)
    }

    fn kept(&self, picture: Option<Drawable>, data: Arc<Vec<u8>>) -> Option<ImageKind> {
        self.refused.fetch_or(picture.is_none(), Relaxed);
        picture.map(|p| (p.kind)(data))
    }

    /// Takes room for so many pixels, if all together are no more than those of the largest page.
    fn has_room(&self, pixels: u64) -> bool {
        let sum = |taken: u64| taken.checked_add(pixels).filter(|sum| *sum <= MAX_PIXELS);
        self.pixels.fetch_update(Relaxed, Relaxed, sum).is_ok()
    }
}

/// A picture that can be drawn.
struct Drawable {
    kind: fn(Arc<Vec<u8>>) -> ImageKind,
    /// As many as it says that it has.
    pixels: u64,
}

/// Told by the picture's own first bytes: what the document says of it may be wrong.
fn drawable(data: &[u8]) -> Option<Drawable> {
    let format = image::guess_format(data).ok()?;
    let kind = match format {
        ImageFormat::Png => ImageKind::PNG,
        ImageFormat::Jpeg => ImageKind::JPEG,
        _ => return None,
    };
    let (width, height) = ImageReader::with_format(Cursor::new(data), format).into_dimensions().ok()?;
    Some(Drawable { kind, pixels: u64::from(width) * u64::from(height) })
}
