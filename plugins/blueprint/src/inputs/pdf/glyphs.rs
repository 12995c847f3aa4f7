//! The letters of a page's text layer.

use hayro::hayro_interpret::font::{Glyph, GlyphRun, PositionedGlyph};
use hayro::hayro_interpret::hayro_cmap::BfString;
use hayro::kurbo::{Affine, Point, Shape, Vec2};

/// Units of a glyph's own coordinates per em.
const EM: f64 = 1000.0;
/// Without an outline a letter reaches from the baseline to the height of a capital, in em.
const CAPITAL: [f64; 2] = [0.0, 0.72];
/// Without an advance a letter is half as wide as high.
const ADVANCE: f32 = 500.0;

/// A letter, or a ligature, where it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Letter {
    /// What it says; `None` if the document does not tell.
    pub content: Option<String>,
    /// Where its baseline begins and ends.
    pub from: Point,
    pub to: Point,
    /// One em, from the baseline upwards as the letter stands.
    pub up: Vec2,
    /// From where to where it reaches along `up`, in em.
    pub reach: [f64; 2],
    /// Whether it is drawn; what was recognised in a scan is not.
    pub visible: bool,
}

/// The letters of a run, in the coordinates that `transform` leads to; without those that have no size.
pub fn letters(run: &GlyphRun<'_, '_>, transform: Affine, visible: bool) -> Vec<Letter> {
    let letter = |glyph| letter(glyph, transform, visible);
    run.glyphs()
        .iter()
        .map(letter)
        .filter(|l| l.up.is_finite() && l.up.hypot() > 0.0 && l.to.is_finite())
        .collect()
}

fn letter(glyph: &PositionedGlyph<'_>, transform: Affine, visible: bool) -> Letter {
    let transform = transform * glyph.transform();
    let from = transform * Point::ZERO;
    Letter {
        content: content(glyph),
        from,
        to: transform * Point::new(advance(glyph), 0.0),
        up: transform * Point::new(0.0, EM) - from,
        reach: reach(glyph),
        visible,
    }
}

/// The glyph's text. Codes for private use and controls mean nothing outside of their font.
fn content(glyph: &Glyph<'_>) -> Option<String> {
    let text = match glyph.as_unicode()? {
        BfString::Char(c) => c.to_string(),
        BfString::String(s) => s,
    };
    let plain = |c: char| !c.is_control() && !('\u{e000}'..='\u{f8ff}').contains(&c) && c != '\u{fffd}';
    (!text.is_empty() && text.chars().all(plain)).then_some(text)
}

fn advance(glyph: &Glyph<'_>) -> f64 {
    let advance = match glyph {
        Glyph::Outline(outline) => outline.advance_width(),
        Glyph::Type3(drawn) => drawn.advance_width(),
    };
    f64::from(advance.unwrap_or(ADVANCE))
}

fn reach(glyph: &Glyph<'_>) -> [f64; 2] {
    let Glyph::Outline(outline) = glyph else { return CAPITAL };
    let path = outline.outline();
    if path.elements().is_empty() {
        return CAPITAL;
    }
    let bounds = path.bounding_box();
    [bounds.y0 / EM, bounds.y1 / EM]
}
