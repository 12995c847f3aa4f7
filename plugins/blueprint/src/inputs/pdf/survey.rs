//! What is drawn on a page: asked before it is rendered.

use super::glyphs::{Letter, letters};
use super::lines::lines;
use crate::found::SheetText;
use crate::inputs::limit::MAX_PIXELS;
use hayro::hayro_interpret::font::GlyphRun;
use hayro::hayro_interpret::util::TransformExt;
use hayro::hayro_interpret::{
    BlendMode, ClipPath, Context, Device, DrawMode, DrawProps, Image, ImageDrawProps, InterpreterCache,
    InterpreterSettings, SoftMask, interpret_page,
};
use hayro::hayro_syntax::page::Page;
use hayro::kurbo::{BezPath, Rect};
use planform_sdk::{ErrorKind, PluginError};

/// The most letters that are kept of a page; no plan has as many.
const MAX_LETTERS: usize = 500_000;
/// A page is a scan if its pictures cover this much of it and nothing but a frame or a background is drawn besides.
const SCAN_COVER: f64 = 0.8;
const SCAN_PATHS: usize = 4;

/// What a page holds; lengths in units of the page, from its upper left corner, y down.
#[derive(Default)]
pub struct Survey {
    letters: Vec<Letter>,
    visible_letters: usize,
    paths: usize,
    images: Vec<Placed>,
}

/// A picture on the page.
struct Placed {
    /// Pixels.
    size: [u32; 2],
    /// Its two sides.
    sides: [f64; 2],
}

impl Survey {
    /// Goes through the page without drawing it.
    pub fn of(page: &Page<'_>) -> Self {
        let (width, height) = page.render_dimensions();
        let area = Rect::new(0.0, 0.0, width.into(), height.into());
        let settings = InterpreterSettings::default();
        let cache = InterpreterCache::new();
        let transform = page.initial_transform(true).to_kurbo();
        let mut context = Context::new(transform, area, &cache, page.xref(), settings);
        let mut survey = Self::default();
        interpret_page(page, &mut context, &mut survey);
        survey
    }

    /// Refuses pages with nothing on them, and those with pictures that are too large to decode.
    pub fn check(&self, number: u32) -> Result<(), PluginError> {
        if self.paths == 0 && self.letters.is_empty() && self.images.is_empty() {
            let message = format!("page {number} of the PDF is empty, or too damaged to be drawn");
            return Err(PluginError::new(ErrorKind::BadInput, message)
                .advise("give another page, or save the PDF again"));
        }
        match self.images.iter().find(|i| i.pixels() > MAX_PIXELS) {
            Some(image) => Err(too_large(image)),
            None => Ok(()),
        }
    }

    /// Pixels per unit of the page, if it is a scan.
    pub fn scan_density(&self, page_area: f64) -> Option<f64> {
        let cover: f64 = self.images.iter().map(|i| i.sides[0] * i.sides[1]).sum();
        let plain = self.paths <= SCAN_PATHS && self.visible_letters == 0;
        let density = self.images.iter().filter_map(Placed::density).reduce(f64::max);
        density.filter(|_| plain && cover >= SCAN_COVER * page_area)
    }

    /// The lines of its text layer, on a picture with so many pixels per unit, of this size.
    pub fn texts(&self, per_unit: f64, size: [f64; 2]) -> Vec<SheetText> {
        let within = |t: &SheetText| (0..2).all(|i| (0.0..=size[i]).contains(&t.centre[i]));
        lines(&self.letters, per_unit).into_iter().filter(within).collect()
    }
}

impl Placed {
    fn pixels(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1])
    }

    fn density(&self) -> Option<f64> {
        let along = [0, 1].map(|i| f64::from(self.size[i]) / self.sides[i]);
        let density = along[0].max(along[1]);
        (density.is_finite() && density > 0.0).then_some(density)
    }
}

fn too_large(image: &Placed) -> PluginError {
    let [width, height] = image.size;
    let message = format!(
        "a picture on the PDF page has {width} x {height} pixels; at most {} million are read",
        MAX_PIXELS / 1_000_000
    );
    PluginError::new(ErrorKind::Limit, message).advise("save the PDF with smaller pictures")
}

impl Device<'_> for Survey {
    fn draw_path(&mut self, _: &BezPath, _: DrawProps<'_>, _: &DrawMode) {
        self.paths += 1;
    }

    fn push_clip_path(&mut self, _: &ClipPath) {}

    fn push_transparency_group(&mut self, _: f32, _: Option<SoftMask<'_>>, _: BlendMode) {}

    fn draw_glyph_run(&mut self, run: &GlyphRun<'_, '_>, props: DrawProps<'_>, mode: &DrawMode) {
        let visible = !matches!(mode, DrawMode::Invisible);
        if visible {
            self.visible_letters += run.glyphs().len();
        }
        let letters = letters(run, props.transform, visible);
        // Letters that are filled and stroked come twice.
        if self.letters.len() < MAX_LETTERS && !self.letters.ends_with(&letters) {
            self.letters.extend(letters);
        }
    }

    /// The transform given is that from the picture's pixels.
    fn draw_image(&mut self, image: Image<'_, '_>, props: ImageDrawProps<'_>) {
        let size = [image.width(), image.height()];
        let [a, b, c, d, _, _] = props.transform.as_coeffs();
        let sides = [a.hypot(b) * f64::from(size[0]), c.hypot(d) * f64::from(size[1])];
        self.images.push(Placed { size, sides });
    }

    fn pop_clip(&mut self) {}

    fn pop_transparency_group(&mut self) {}
}
