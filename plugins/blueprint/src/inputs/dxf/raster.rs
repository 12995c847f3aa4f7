//! Lines of a drawing as a picture.

use super::plane::Point;
use super::shapes::Shape;
use crate::inputs::limit::largest_scale;
use image::RgbImage;
use planform_sdk::{ErrorKind, PluginError};
use resvg::tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// Pixels along the longer side, if the resolution allows it.
const LONG_SIDE: f64 = 3000.0;
/// Metres per pixel that are fine enough for walls, and not finer than needed.
const RESOLUTIONS: [f64; 2] = [0.01, 0.05];
/// White around the drawing, pixels.
const MARGIN: f64 = 20.0;
/// Width of lines, pixels.
const LINE: f32 = 2.0;
/// Coordinates that the rasteriser can take, pixels.
const FARTHEST: f64 = 1e6;

/// Where the drawing lies in the picture.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    /// The picture's lower left corner, in the drawing's units.
    pub low: Point,
    /// Pixels per unit.
    pub scale: f64,
    /// Pixels.
    pub width: u32,
    pub height: u32,
}

impl Frame {
    /// A picture of what lies between these corners; `unit` is the drawing's, in metres.
    pub fn of([low, high]: [Point; 2], unit: f64) -> Self {
        let size = [0, 1].map(|i| high[i] - low[i]);
        let longer = size[0].max(size[1]) * unit;
        let resolution = (longer / LONG_SIDE).clamp(RESOLUTIONS[0], RESOLUTIONS[1]);
        let wanted = unit / resolution;
        let pixels = size.map(|side| side * wanted + 2.0 * MARGIN);
        let scale = wanted * largest_scale(pixels[0], pixels[1]).min(1.0);
        let [width, height] = size.map(|side| (side * scale + 2.0 * MARGIN).ceil() as u32);
        Self { low: low.map(|v| v - MARGIN / scale), scale, width, height }
    }

    /// A point in pixels, y down.
    pub fn pixel(&self, [x, y]: Point) -> Point {
        [(x - self.low[0]) * self.scale, f64::from(self.height) - (y - self.low[1]) * self.scale]
    }
}

/// The lines, black on white.
pub fn draw<'s>(shapes: impl Iterator<Item = &'s Shape>, frame: &Frame) -> Result<RgbImage, PluginError> {
    let failed = || {
        PluginError::new(ErrorKind::Limit, "the DXF is too large to be drawn").advise("save one storey alone")
    };
    let mut pixmap = Pixmap::new(frame.width, frame.height).ok_or_else(failed)?;
    pixmap.fill(Color::WHITE);
    shapes.for_each(|shape| paint(&mut pixmap, shape, frame));
    let mut samples = Vec::with_capacity(frame.width as usize * frame.height as usize * 3);
    samples.extend(pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    RgbImage::from_raw(frame.width, frame.height, samples).ok_or_else(failed)
}

fn paint(pixmap: &mut Pixmap, shape: &Shape, frame: &Frame) {
    let mut path = PathBuilder::new();
    for (i, &point) in shape.points.iter().enumerate() {
        let [x, y] = frame.pixel(point);
        if x.abs().max(y.abs()) > FARTHEST {
            return;
        }
        if i == 0 { path.move_to(x as f32, y as f32) } else { path.line_to(x as f32, y as f32) }
    }
    let Some(path) = path.finish() else { return };
    let paint = Paint::default();
    if shape.filled {
        pixmap.fill_path(&path, &paint, FillRule::EvenOdd, Transform::identity(), None);
    }
    let stroke = Stroke { width: LINE.max((shape.width * frame.scale) as f32), ..Stroke::default() };
    pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
}
