//! Symbols: found, told what they mean, and taken off the drawing.

mod behind;
mod blobs;
mod bowls;
mod doors;
mod drawing;
mod fixtures;
pub mod library;
mod lifts;
mod near;
mod panes;
mod picture;
mod plane;
mod regions;
mod runs;
mod shapes;
mod signs;
mod sliding;
mod soft;
mod stairs;
mod strokes;
#[cfg(test)]
mod tests;
mod thin;
mod windows;
mod zncc;

use crate::doorways::{USUAL_WIDTH, Widths};
use crate::found::{SheetLeaf, SheetSymbol};
use crate::mask::Mask;
use crate::sheet::Sheet;
use crate::stages::Stages;
use doors::Swing;
pub use library::Library;
use plane::Plane;
use shapes::{Box2, erase_inside};
use strokes::Segment;
use thin::Chain;

/// What was found.
#[derive(Debug, Clone)]
pub struct Symbols {
    /// The symbols.
    pub symbols: Vec<SheetSymbol>,
    /// The pixels that draw them, and nothing else.
    pub erase: Mask,
    /// The pixels of walls that signs hide.
    pub hidden: Mask,
}

impl Symbols {
    /// No symbols in this ink.
    pub fn none(ink: &Mask) -> Self {
        let nothing = || Mask::empty(ink.width, ink.height);
        Self { symbols: Vec::new(), erase: nothing(), hidden: nothing() }
    }
}

/// Leaves of doors, metres.
const LEAF: [f64; 2] = [0.55, 1.35];
/// Leaves of doors, pixels of a plane, where the scale is not known.
const LEAF_PIXELS: [f64; 2] = [8.0, 44.0];
/// No leaf is shorter than this share of the sheet's longer side, nor longer than this one.
const LEAF_SHARES: [f64; 2] = [0.004, 0.1];
/// No sign is drawn larger than this, metres of the building,
const LARGEST_SIGN: f64 = 2.2;
/// unless it has this score.
const SURE_SIGN: f64 = 0.8;
/// A usual leaf is at least so long on a plane, pixels.
const SHARP: f64 = 18.0;
/// Strokes of doors and stairs are thinner than this, pixels of a plane.
const WIDEST_STROKE: u32 = 4;

/// All symbols of the sheet. `ink` is the sheet's ink without its words; `metres_per_pixel`, if it is known already, makes
/// the search surer and quicker. Where it is not known, and there are no doors to tell it, things without a colour are
/// not searched for.
pub fn find(
    sheet: &Sheet,
    ink: &Mask,
    library: &Library,
    metres_per_pixel: Option<f64>,
    stages: &mut dyn Stages,
) -> Symbols {
    let metres_per_pixel = metres_per_pixel.filter(|m| *m > 0.0 && m.is_finite());
    let mut found = Symbols::none(ink);
    signs(sheet, ink, library, metres_per_pixel, &mut found);
    let rest = ink.clone().without(&found.erase);
    found.symbols.iter().for_each(|sign| behind::walls(&rest, sign, &mut found.hidden));
    let rest = rest.with(&found.hidden);
    let view = best_view(&rest, metres_per_pixel);
    if let Some(view) = &view {
        found.symbols.extend(doors::doors(&view.plane, &rest, &view.swings, &mut found.erase));
    }
    let told = Widths::of_single(&found.symbols).filter(|w| w.count >= 2).map(|w| w.metres_per_pixel());
    if let (Some(view), Some(pixel)) = (&view, metres_per_pixel.or(told)) {
        drawn_to_scale(sheet, &rest, library, view, pixel, &mut found);
    }
    stages.stage("symbols", &mut || picture::of(sheet, &found));
    found
}

fn signs(sheet: &Sheet, ink: &Mask, library: &Library, pixel: Option<f64>, found: &mut Symbols) {
    for symbol in signs::alike(signs::find(sheet, library)) {
        if is_aside(sheet, &symbol) || pixel.is_some_and(|p| is_a_room(&symbol, p)) {
            continue;
        }
        let keep = |t: &library::Template| t.kind == symbol.kind && t.action == library::Action::Keep;
        if !library.templates.iter().any(keep) {
            erase_inside(ink, &Box2::of(&symbol).grown([1.0; 2]), &mut found.erase);
        }
        found.symbols.push(symbol);
    }
}

/// Whether a sign is so large in the building that it is a coloured room rather, unless it surely is one.
fn is_a_room(symbol: &SheetSymbol, pixel: f64) -> bool {
    symbol.width.min(symbol.height) * pixel > LARGEST_SIGN && symbol.score < SURE_SIGN
}

/// Whether a sign stands in a legend or a title block, where it only explains itself.
fn is_aside(sheet: &Sheet, symbol: &SheetSymbol) -> bool {
    let around = Box2::of(symbol).grown([symbol.width / 2.0, symbol.height / 2.0]);
    shapes::count_inside(&sheet.aside, &around) > shapes::count_inside(&sheet.ink, &around)
}

/// What is found by its size in the building; `pixel` is metres per pixel of the sheet.
fn drawn_to_scale(
    sheet: &Sheet,
    ink: &Mask,
    library: &Library,
    view: &View,
    pixel: f64,
    found: &mut Symbols,
) {
    let own = pixel * f64::from(view.plane.factor);
    let (plane, segments) = (&view.plane, &view.segments);
    let stairs = stairs::find(plane, ink, segments, own, &mut found.erase);
    let mut lifts = lifts::find(plane, ink, segments, own, &mut found.erase);
    let windows = windows::find(sheet, plane, &view.parts, own);
    let close = Close::new(ink, pixel);
    lifts.extend(lifts::find(&close.plane, ink, &close.segments, close.pixel, &mut found.erase));
    let sliding = sliding::find(&close.plane, ink, &close.segments, close.pixel, &mut found.erase);
    let mut panes = panes::find(sheet, &close.plane, close.pixel);
    // The box of an open leaf, a lift's double outline and the space between two steps are no windows.
    let around = |s: &SheetSymbol| Box2::of(s).grown([0.2 / pixel; 2]);
    panes.retain(|w| {
        !stairs.iter().chain(&lifts).any(|s| around(s).contains(w.centre))
            && !found.symbols.iter().flat_map(|d| &d.leaves).any(|l| is_on_leaf(w, l))
    });
    let bowls = bowls::find(&sheet.ink, pixel, &mut found.erase);
    let rest = ink.clone().without(&found.erase);
    let fixtures = fixtures::find(&rest, library, pixel, &mut found.erase);
    // What looks like a door inside a lift or a flight of steps is a part of it.
    let within = |d: &SheetSymbol| stairs.iter().chain(&lifts).any(|s| Box2::of(s).contains(d.centre));
    found.symbols.retain(|s| s.leaves.is_empty() || !within(s));
    for symbol in [stairs, lifts, bowls, fixtures, sliding, windows, panes].into_iter().flatten() {
        let inside =
            |s: &SheetSymbol| Box2::of(s).contains(symbol.centre) || Box2::of(&symbol).contains(s.centre);
        if !found.symbols.iter().any(inside) {
            found.symbols.push(symbol);
        }
    }
}

/// Whether a symbol's middle lies on the open leaf of a door.
fn is_on_leaf(symbol: &SheetSymbol, leaf: &SheetLeaf) -> bool {
    let (along, length) = plane::direction(leaf.hinge, leaf.open);
    let d = [symbol.centre[0] - leaf.hinge[0], symbol.centre[1] - leaf.hinge[1]];
    let (ahead, aside) = (plane::dot(d, along), plane::dot(d, [-along[1], along[0]]).abs());
    aside < 0.15 * length && (0.2..0.9).contains(&(ahead / length))
}

/// The straight strokes of the sheet, seen more closely: lines that run side by side stay apart.
struct Close {
    plane: Plane,
    segments: Vec<Segment>,
    /// Metres per pixel of the plane.
    pixel: f64,
}

impl Close {
    fn new(ink: &Mask, pixel: f64) -> Self {
        let (plane, pixel) = Plane::close(ink, pixel);
        let parts = strokes::parts(&thin::chains(&plane.mask, WIDEST_STROKE));
        let segments = strokes::segments(&parts, 5.0);
        Self { plane, segments, pixel }
    }
}

/// The sheet at the resolution at which its doors are seen best.
struct View {
    plane: Plane,
    parts: Vec<Segment>,
    segments: Vec<Segment>,
    swings: Vec<Swing>,
}

impl View {
    fn new(ink: &Mask, factor: u32, radii: [f64; 2]) -> Self {
        let plane = Plane::new(ink, factor);
        let chains: Vec<Chain> = thin::chains(&plane.mask, WIDEST_STROKE);
        let parts = strokes::parts(&chains);
        let segments = strokes::segments(&parts, 5.0);
        let swings = doors::alike(doors::find(&plane, &chains, &segments, radii));
        Self { plane, parts, segments, swings }
    }

    fn weight(&self) -> f64 {
        self.swings.iter().map(|s| s.score * s.score * s.radius * f64::from(self.plane.factor)).sum()
    }
}

fn best_view(ink: &Mask, metres_per_pixel: Option<f64>) -> Option<View> {
    let views =
        resolutions(ink, metres_per_pixel).into_iter().map(|(factor, radii)| View::new(ink, factor, radii));
    views.reduce(|a, b| if b.weight() > a.weight() { b } else { a })
}

/// The factors of the planes to look at, with the range of leaves there, pixels of the plane.
fn resolutions(ink: &Mask, metres_per_pixel: Option<f64>) -> Vec<(u32, [f64; 2])> {
    let doubled = || (0..8).map(|k| 1u32 << k);
    if let Some(m) = metres_per_pixel {
        let sharp = |f: &u32| USUAL_WIDTH / m / f64::from(*f) >= SHARP;
        let factor = doubled().filter(sharp).max().unwrap_or(1);
        return vec![(factor, LEAF.map(|l| l / m / f64::from(factor)))];
    }
    let [shortest, longest] = LEAF_SHARES.map(|s| s * f64::from(ink.width.max(ink.height)));
    let useful = |f: &u32| {
        let [least, most] = LEAF_PIXELS.map(|l| l * f64::from(*f));
        most > 2.0 * shortest && least < longest
    };
    doubled().filter(useful).step_by(2).map(|f| (f, LEAF_PIXELS)).collect()
}
