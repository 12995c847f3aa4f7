//! Letters as outlines, of fonts that come with the program.

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider};
use tiny_skia::{Path, PathBuilder, Rect};

/// A typeface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Face {
    DejaVu,
    Condensed,
    Bold,
    Mono,
    Ubuntu,
}

impl Face {
    /// Faces that plans are written in.
    pub(super) const PLAIN: [Self; 4] = [Self::DejaVu, Self::Condensed, Self::Ubuntu, Self::Mono];

    fn bytes(self) -> &'static [u8] {
        match self {
            Self::DejaVu => dejavu::sans::regular(),
            Self::Condensed => dejavu::sans_condensed::regular(),
            Self::Bold => dejavu::sans::bold(),
            Self::Mono => epaint_default_fonts::HACK_REGULAR,
            Self::Ubuntu => epaint_default_fonts::UBUNTU_LIGHT,
        }
    }
}

/// The outline of a line of text whose capitals are `capital` high. The baseline begins at (0, 0), x to the right, y up.
/// `None` if the text has no ink.
pub(super) fn outline(text: &str, face: Face, capital: f64) -> Option<Path> {
    let font = FontRef::new(face.bytes()).ok()?;
    let (size, place) = (Size::new(1000.0), LocationRef::default());
    let (glyphs, widths) = (font.outline_glyphs(), font.glyph_metrics(size, place));
    let height = font.metrics(size, place).cap_height.filter(|h| *h > 0.0).unwrap_or(720.0);
    let mut pen = Tracer { builder: PathBuilder::new(), x: 0.0, scale: capital as f32 / height };
    for letter in text.chars() {
        let glyph = font.charmap().map(letter).unwrap_or_default();
        if let Some(shape) = glyphs.get(glyph) {
            shape.draw(DrawSettings::unhinted(size, place), &mut pen).ok()?;
        }
        pen.x += widths.advance_width(glyph).unwrap_or(500.0);
    }
    pen.builder.finish()
}

/// Width and height of the ink.
pub(super) fn measure(text: &str, face: Face, capital: f64) -> (f64, f64) {
    let ink = outline(text, face, capital).map(|p| p.bounds());
    ink.map_or((0.0, 0.0), |b: Rect| (f64::from(b.width()), f64::from(b.height())))
}

struct Tracer {
    builder: PathBuilder,
    /// Where the letter begins, in the font's units.
    x: f32,
    scale: f32,
}

impl Tracer {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        ((self.x + x) * self.scale, y * self.scale)
    }
}

impl OutlinePen for Tracer {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.builder.line_to(x, y);
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let ((cx, cy), (x, y)) = (self.at(cx, cy), self.at(x, y));
        self.builder.quad_to(cx, cy, x, y);
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let ((ax, ay), (bx, by), (x, y)) = (self.at(ax, ay), self.at(bx, by), self.at(x, y));
        self.builder.cubic_to(ax, ay, bx, by, x, y);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}
