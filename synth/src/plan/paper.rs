//! The sheet: its size, the scale, and where on it the building, the title block and the legend lie.

use super::PlanStyle;
use super::look::Look;
use super::surface::rectangle;
use super::view::View;
use crate::rng::Rng;
use planform_sdk::Point;

/// Long and short side of A4, A3 and A2, millimetres.
const SIZES: [(f64, f64); 3] = [(297.0, 210.0), (420.0, 297.0), (594.0, 420.0)];
const DENOMINATORS: [f64; 6] = [50.0, 75.0, 100.0, 125.0, 150.0, 200.0];
const DPIS: [f64; 6] = [96.0, 100.0, 120.0, 150.0, 200.0, 250.0];
/// Fewest and most pixels of a sheet.
const PIXELS: (f64, f64) = (1.9e6, 6.2e6);
/// Finest and coarsest metres per pixel.
const DETAIL: (f64, f64) = (0.01, 0.034);
/// Pixels that a capital letter has at least.
const LETTER: f64 = 10.0;

/// A rectangle of the sheet, in its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub(super) low: Point,
    pub(super) high: Point,
}

impl Area {
    pub(super) fn ring(&self) -> [Point; 4] {
        rectangle(self.low, self.high)
    }

    pub(super) fn middle(&self) -> Point {
        self.low.midpoint(self.high)
    }
}

/// A sheet and its parts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Paper {
    pub(super) view: View,
    /// Where the building's box has its lower left corner.
    pub(super) place: Point,
    pub(super) frame: Option<Area>,
    pub(super) title: Option<Area>,
    pub(super) header: Option<Area>,
    pub(super) legend: Option<Area>,
}

/// What lies around the building, millimetres.
#[derive(Debug, Clone, Copy)]
struct Margins {
    /// From the sheet's edge to its frame.
    edge: f64,
    /// Around the building, for dimensions.
    around: f64,
    bottom: f64,
    top: f64,
    right: f64,
}

impl Margins {
    fn new(look: &Look, rng: &mut Rng) -> Self {
        let evacuation = look.style == PlanStyle::Evacuation;
        let edge = if look.framed { rng.range((5.0, 12.0)) } else { rng.range((1.0, 4.0)) };
        let below = look.scale_bar || look.north;
        Self {
            edge,
            around: if look.dimensions.is_some() { 21.0 } else { rng.range((4.0, 12.0)) },
            bottom: if look.framed {
                30.0
            } else if below {
                18.0
            } else {
                0.0
            },
            top: if evacuation && look.evacuation.header { 17.0 } else { 0.0 },
            right: if evacuation && look.evacuation.legend { 62.0 } else { 0.0 },
        }
    }

    fn wide(&self) -> f64 {
        2.0 * (self.edge + self.around) + self.right
    }

    fn high(&self) -> f64 {
        2.0 * (self.edge + self.around) + self.bottom + self.top
    }
}

impl Paper {
    /// A sheet on which a building of this size, metres, has its place; `None` if none of the usual ones is right for it.
    pub(super) fn draw(size: (f64, f64), look: &mut Look, skew: f64, rng: &mut Rng) -> Option<Self> {
        let margins = Margins::new(look, rng);
        let mut possible = Vec::new();
        for denominator in DENOMINATORS {
            let drawn = (size.0 * 1000.0 / denominator, size.1 * 1000.0 / denominator);
            for (wide, high) in sheets(drawn, &margins, look.framed) {
                possible.extend(DPIS.iter().map(|&dpi| pixels(wide, high, dpi, denominator, skew)));
            }
        }
        possible.retain(fits);
        let view = *possible.get(rng.index(possible.len()))?;
        look.capital = look.capital.max(LETTER * 25.4 / view.dpi);
        Some(Self::arranged(view, size, &margins, look))
    }

    fn arranged(view: View, size: (f64, f64), margins: &Margins, look: &Look) -> Self {
        let (w, h) = view.size();
        let [edge, bottom, top, right] =
            [margins.edge, margins.bottom, margins.top, margins.right].map(|v| view.mm(v));
        let area = |x0, y0, x1, y1| Area { low: Point::new(x0, y0), high: Point::new(x1, y1) };
        let (free_w, free_h) = (w - 2.0 * edge - right, h - 2.0 * edge - bottom - top);
        Self {
            view,
            place: Point::new(edge + (free_w - size.0) / 2.0, edge + bottom + (free_h - size.1) / 2.0),
            frame: look.framed.then(|| area(edge, edge, w - edge, h - edge)),
            title: look.framed.then(|| area(w - edge - view.mm(110.0), edge, w - edge, edge + bottom)),
            header: (top > 0.0).then(|| area(edge, h - edge - top * 0.8, w - edge, h - edge)),
            legend: (right > 0.0).then(|| area(w - edge - right * 0.95, edge, w - edge, h - edge - top)),
        }
    }
}

/// The sheets for a drawing of this size, millimetres: the usual ones that it fills at least by half, or one cut to it.
fn sheets(drawn: (f64, f64), margins: &Margins, framed: bool) -> Vec<(f64, f64)> {
    let (wide, high) = (drawn.0 + margins.wide(), drawn.1 + margins.high());
    if !framed {
        return vec![(wide, high)];
    }
    let turned = SIZES.iter().flat_map(|&(a, b)| [(a, b), (b, a)]);
    let fills = |w: f64, h: f64| drawn.0 > 0.6 * w || drawn.1 > 0.6 * h;
    let fits = |&(w, h): &(f64, f64)| wide <= w && high <= h && fills(w, h);
    turned.filter(fits).collect()
}

fn pixels(wide: f64, high: f64, dpi: f64, denominator: f64, skew: f64) -> View {
    let count = |mm: f64| (mm * dpi / 25.4).round() as u32;
    View { width: count(wide), height: count(high), dpi, denominator, skew }
}

fn fits(view: &View) -> bool {
    let pixels = f64::from(view.width) * f64::from(view.height);
    let detail = view.metres_per_pixel();
    (PIXELS.0..=PIXELS.1).contains(&pixels) && (DETAIL.0..=DETAIL.1).contains(&detail)
}
