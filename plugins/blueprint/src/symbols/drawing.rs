//! A template's drawing, rendered large once and shrunk from there.

use super::soft::Soft;
use image::ImageReader;
use planform_sdk::{ErrorKind, PluginError};
use resvg::{tiny_skia, usvg};
use std::io::Cursor;

/// The longer side of a rendered drawing, pixels.
const SIDE: f32 = 192.0;
/// No PNG drawing is wider or higher than this, pixels.
const LARGEST_SIDE: u32 = 4096;

/// A drawing in the three ways in which a sheet may show it.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// How much ink covers every pixel, 0 to 1: lines and dark areas.
    pub ink: Soft,
    /// How much colour covers every pixel, 0 to 1: coloured areas, but not what is white or black in them.
    pub colour: Soft,
}

impl Drawing {
    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.ink.width) / f64::from(self.ink.height)
    }
}

/// The drawing that an SVG document holds.
///
/// # Errors
/// If it is not an SVG document, or has no area.
pub fn of_svg(bytes: &[u8]) -> Result<Drawing, PluginError> {
    let tree =
        usvg::Tree::from_data(bytes, &usvg::Options::default()).map_err(|_| bad("is not a sound SVG"))?;
    let scale = SIDE / tree.size().width().max(tree.size().height());
    let size = |length: f32| (length * scale).round().max(1.0) as u32;
    let (width, height) = (size(tree.size().width()), size(tree.size().height()));
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(|| bad("has no area"))?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    let rgb = pixels.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect();
    Ok(of_pixels(width, height, rgb))
}

/// The drawing that a PNG file holds; what is transparent in it is paper.
///
/// # Errors
/// If it is not a PNG file, or too large.
pub fn of_png(bytes: &[u8]) -> Result<Drawing, PluginError> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), image::ImageFormat::Png);
    let mut limits = image::Limits::default();
    limits.max_image_width = Some(LARGEST_SIDE);
    limits.max_image_height = Some(LARGEST_SIDE);
    reader.limits(limits);
    let picture =
        reader.decode().map_err(|_| bad("is not a sound PNG, or is wider or higher than 4096 pixels"))?;
    let picture = picture.into_rgba8();
    let on_paper = |c: u8, a: u8| (u16::from(c) * u16::from(a) / 255) as u8 + (255 - a);
    let rgb = picture.pixels().map(|p| [0, 1, 2].map(|i| on_paper(p.0[i], p.0[3]))).collect();
    Ok(of_pixels(picture.width(), picture.height(), rgb))
}

fn of_pixels(width: u32, height: u32, rgb: Vec<[u8; 3]>) -> Drawing {
    let full = |f: fn([u8; 3]) -> f32| Soft { width, height, values: rgb.iter().map(|&p| f(p)).collect() };
    let scale = f64::from(SIDE) / f64::from(width.max(height));
    let shrink =
        |s: Soft| if scale < 1.0 { s.resized(scaled(width, scale), scaled(height, scale)) } else { s };
    Drawing { ink: shrink(full(darkness)), colour: shrink(full(chroma)) }
}

fn scaled(length: u32, scale: f64) -> u32 {
    ((f64::from(length) * scale).round() as u32).max(1)
}

fn darkness(p: [u8; 3]) -> f32 {
    1.0 - f32::from(p[0].min(p[1]).min(p[2])) / 255.0
}

/// How strongly a pixel is coloured, from 0 to 1.
pub fn chroma(p: [u8; 3]) -> f32 {
    let most = p[0].max(p[1]).max(p[2]);
    let least = p[0].min(p[1]).min(p[2]);
    (f32::from(most - least) / 128.0).min(1.0)
}

fn bad(message: &str) -> PluginError {
    PluginError::new(ErrorKind::BadOption, message)
}
