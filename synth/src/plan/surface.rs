//! A layer of the drawing, in the frame of the sheet.

use super::view::View;
use image::GrayImage;
use planform_sdk::Point;
use std::f64::consts::TAU;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapPaint, Stroke, Transform,
};

/// Red, green, blue.
pub(super) type Colour = [u8; 3];

pub(super) const WHITE: Colour = [255; 3];

/// What lines are drawn with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pen {
    /// Metres.
    pub(super) width: f64,
    pub(super) colour: Colour,
}

/// A layer: transparent where nothing was drawn.
pub(super) struct Surface {
    pub(super) view: View,
    pixmap: Pixmap,
}

impl Surface {
    /// An empty layer; `None` if the view has no pixels.
    pub(super) fn new(view: View) -> Option<Self> {
        Some(Self { view, pixmap: Pixmap::new(view.width, view.height)? })
    }

    /// Paints the whole layer.
    pub(super) fn flood(&mut self, [r, g, b]: Colour) {
        self.pixmap.fill(Color::from_rgba8(r, g, b, 255));
    }

    pub(super) fn fill_path(&mut self, path: &Path, colour: Colour, rule: FillRule) {
        self.pixmap.fill_path(path, &paint(colour), rule, self.view.transform(), None);
    }

    /// Fills what an odd number of the rings contain.
    pub(super) fn fill<'a>(&mut self, rings: impl IntoIterator<Item = &'a [Point]>, colour: Colour) {
        if let Some(path) = path(rings, true) {
            self.fill_path(&path, colour, FillRule::EvenOdd);
        }
    }

    /// Draws a line through the points.
    pub(super) fn line(&mut self, points: &[Point], pen: Pen) {
        self.stroke(path([points], false), pen);
    }

    /// Draws closed lines.
    pub(super) fn rings<'a>(&mut self, rings: impl IntoIterator<Item = &'a [Point]>, pen: Pen) {
        self.stroke(path(rings, true), pen);
    }

    /// Draws the outline, filled with a colour or not.
    pub(super) fn shape(&mut self, ring: &[Point], fill: Option<Colour>, pen: Pen) {
        if let Some(colour) = fill {
            self.fill([ring], colour);
        }
        self.rings([ring], pen);
    }

    fn stroke(&mut self, path: Option<Path>, pen: Pen) {
        let Some(path) = path else { return };
        let finest = 0.9 * self.view.metres_per_pixel();
        let stroke = Stroke {
            width: pen.width.max(finest) as f32,
            line_cap: LineCap::Square,
            line_join: LineJoin::Miter,
            ..Stroke::default()
        };
        self.pixmap.stroke_path(&path, &paint(pen.colour), &stroke, self.view.transform(), None);
    }

    /// Lays a layer of the same view on this one.
    pub(super) fn put(&mut self, other: &Self) {
        self.pixmap.draw_pixmap(
            0,
            0,
            other.pixmap.as_ref(),
            &PixmapPaint::default(),
            Transform::identity(),
            None,
        );
    }

    /// The layer's own pixels, to render into.
    pub(super) fn pixmap(&mut self) -> &mut Pixmap {
        &mut self.pixmap
    }

    /// 255 where something was drawn that covers at least half of the pixel, else 0.
    pub(super) fn covered(&self) -> GrayImage {
        let alpha = self.pixmap.pixels().iter().map(|p| if p.alpha() >= 128 { 255 } else { 0 });
        GrayImage::from_raw(self.view.width, self.view.height, alpha.collect()).unwrap_or_default()
    }

    /// The colours, row by row from the top, three bytes each.
    pub(super) fn colours(&self) -> Vec<u8> {
        self.pixmap.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect()
    }
}

fn paint([r, g, b]: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

fn path<'a>(lines: impl IntoIterator<Item = &'a [Point]>, closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for line in lines {
        for (i, p) in line.iter().enumerate() {
            let (x, y) = (p.x as f32, p.y as f32);
            if i == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
        }
        if closed && !line.is_empty() {
            builder.close();
        }
    }
    builder.finish()
}

/// Part of an ellipse as a line: from the angle `from` on, `sweep` radians counter-clockwise, in the directions that
/// `at` gives to its two half axes.
pub(super) fn arc(at: impl Fn(f64, f64) -> Point, from: f64, sweep: f64) -> Vec<Point> {
    let steps = (sweep.abs() / TAU * 48.0).ceil().max(4.0) as i32;
    let angle = |i: i32| from + sweep * f64::from(i) / f64::from(steps);
    (0..=steps).map(|i| at(angle(i).cos(), angle(i).sin())).collect()
}

/// A circle.
pub(super) fn circle(middle: Point, radius: f64) -> Vec<Point> {
    arc(|u, v| Point::new(middle.x + radius * u, middle.y + radius * v), 0.0, TAU)
}

/// An upright rectangle.
pub(super) fn rectangle(low: Point, high: Point) -> [Point; 4] {
    [low, Point::new(high.x, low.y), high, Point::new(low.x, high.y)]
}
