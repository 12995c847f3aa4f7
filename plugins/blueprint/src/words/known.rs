//! Texts that the document holds as texts: where they are is known, so that their ink is erased without reading.

use super::components::Bounds;
use super::extras::FullLine;
use super::glyph::Layer;
use super::search::Search;
use crate::found::SheetText;
use crate::mask::Mask;
use crate::sheet::Sheet;

/// How much larger than the text's box the box is in which its parts' middles lie, in heights of the text.
const MARGIN: f64 = 0.15;
/// How much larger than the text's height its parts are at most.
const TALLEST: f64 = 1.5;

/// Erases the parts of the known texts. Returns the search's lines that are none of them.
pub fn take(known: &[SheetText], search: &Search, sheet: &Sheet, erase: &mut Mask) -> Vec<FullLine> {
    if known.is_empty() {
        return search.lines.clone();
    }
    let inside = |b: Bounds| known.iter().any(|t| holds(t, b));
    let mut parts = Vec::new();
    for layer in [Layer::Whole, Layer::Cut] {
        let list = search.parts(layer).list.iter().enumerate();
        parts.extend(list.filter(|(_, p)| inside(p.bounds)).map(|(i, _)| (layer, i)));
    }
    search.erase(&parts, &sheet.ink, erase);
    search
        .lines
        .iter()
        .filter(|l| {
            !inside(l.bounds) && !l.parts.iter().any(|p| parts.binary_search_by_key(&key(p), key).is_ok())
        })
        .cloned()
        .collect()
}

fn key(&(layer, part): &(Layer, usize)) -> (usize, usize) {
    (layer as usize, part)
}

/// Whether a part of this box is of the text: its middle within the text's box, and itself no larger than a letter, or a
/// word whose letters touch.
fn holds(text: &SheetText, part: Bounds) -> bool {
    let [x, y] = part.middle();
    let (dx, dy) = (x - text.centre[0], y - text.centre[1]);
    let (sin, cos) = text.angle.sin_cos();
    let (along, across) = (cos * dx + sin * dy, cos * dy - sin * dx);
    let margin = MARGIN * text.height;
    let (w, h) = (f64::from(part.width()), f64::from(part.height()));
    let (wide, high) = (w * cos.abs() + h * sin.abs(), w * sin.abs() + h * cos.abs());
    let slanted = (sin * cos).abs() * 2.0 * w.min(h);
    along.abs() <= text.width / 2.0 + margin
        && across.abs() <= text.height / 2.0 + margin
        && high - slanted <= TALLEST * text.height
        && wide - slanted <= text.width + 2.0 * margin
}
