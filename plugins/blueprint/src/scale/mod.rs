//! How many metres a pixel is: by what the user says, the document says, or what is drawn.

mod areas;
mod bar;
mod consensus;
mod dimensions;
mod doors;
pub mod doubt;
mod paper;
pub mod size;
mod trace;

use crate::found::{SheetSymbol, SheetText};
use crate::mask::Mask;
use crate::options::{KnownScale, Request};
use crate::page::Page;
use crate::words::measures::{Measure, parse};
use consensus::{Agreement, agreement};
pub use paper::Resolution;
use planform_sdk::PluginError;

/// A scale, where it is from, and how sure it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Metres per pixel of the sheet.
    pub metres_per_pixel: f64,
    /// Where it is from, for people: "written scale 1:100".
    pub source: String,
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// What is drawn on a sheet, for its scale.
#[derive(Debug, Clone, Copy)]
pub struct Drawn<'a> {
    /// The texts found.
    pub texts: &'a [SheetText],
    /// All ink but that of the texts, the drawing's and what was set aside.
    pub lines: &'a Mask,
}

/// What is built, for the scale.
#[derive(Debug, Clone, Copy)]
pub struct Built<'a> {
    /// The walls.
    pub occupied: &'a Mask,
    /// What is not outside of the building.
    pub inside: &'a Mask,
    /// The symbols found.
    pub symbols: &'a [SheetSymbol],
}

/// Below this confidence the next way to the scale is tried.
pub const GOOD: f64 = 0.5;

/// Two scales that differ by more than this factor contradict each other.
const CONTRADICTION: f64 = 1.1;

/// What the user or the document says.
///
/// # Errors
/// When the user gives a ratio, and nobody says how many pixels there are to an inch of paper.
pub fn said(request: &Request, page: &Page) -> Result<Option<Estimate>, PluginError> {
    let certain = |metres_per_pixel: f64, source: &str| Estimate {
        metres_per_pixel,
        source: source.into(),
        confidence: 1.0,
    };
    Ok(match request.scale {
        KnownScale::MetresPerPixel(metres) => Some(certain(metres, "given")),
        KnownScale::Ratio(ratio) => {
            Some(certain(paper::given(ratio, resolution(request, page))?, "given as a ratio"))
        }
        KnownScale::Distance(a, b, metres) => {
            Some(certain(metres / (b[0] - a[0]).hypot(b[1] - a[1]), "given as a distance"))
        }
        KnownScale::Unknown => page.metres_per_pixel.map(|m| certain(m, "the drawing's units")),
    })
}

/// Pixels per inch of paper by what the user says, or else the document, if it means it.
pub fn resolution(request: &Request, page: &Page) -> Option<Resolution> {
    let claimed = || page.dpi.filter(|&dpi| paper::is_meant(dpi)).map(Resolution::Claimed);
    request.dpi.map(Resolution::Said).or_else(claimed)
}

/// What is written: the scale, a scale bar, dimension lines, the surest in this order.
pub fn drawn(drawn: &Drawn<'_>, resolution: Option<Resolution>) -> Vec<Estimate> {
    let measures = measures(drawn.texts);
    let bar = agreement(&bar::measurements(drawn.texts, drawn.lines));
    let dimensions = agreement(&dimensions::measurements(&measures, drawn.lines));
    let ways = [
        paper::written(&measures, resolution),
        bar.map(|a| estimate(&a, "scale bar", 0.9)),
        dimensions
            .map(|a| estimate(&a, &counted(a.count, "dimension line", "dimension lines"), by_count(&a))),
    ];
    ways.into_iter().flatten().collect()
}

/// What follows from the rooms and the doors.
pub fn built(texts: &[SheetText], built: &Built<'_>) -> Vec<Estimate> {
    let measured = areas::measurements(&measures(texts), built.occupied, built.inside, built.symbols);
    let rooms = agreement(&measured);
    let rooms = rooms.map(|a| {
        estimate(
            &a,
            &counted(a.count, "area or size written in a room", "areas or sizes written in rooms"),
            by_count(&a),
        )
    });
    rooms.into_iter().chain(doors::estimate(built.symbols)).collect()
}

/// The scale by door widths alone, for what has to be judged before rooms are known.
pub fn by_doors(symbols: &[SheetSymbol]) -> Option<Estimate> {
    doors::estimate(symbols)
}

/// The scale when nothing else tells it, as the walls were told apart with.
pub fn by_rooms(metres_per_pixel: f64) -> Estimate {
    Estimate { metres_per_pixel, source: "the usual size of rooms".into(), confidence: 0.1 }
}

/// The first estimate that is good, or else the surest.
pub fn choose(estimates: &[Estimate]) -> Option<&Estimate> {
    let surest = || estimates.iter().max_by(|a, b| a.confidence.total_cmp(&b.confidence));
    good(estimates).or_else(surest)
}

/// The first estimate that is good.
pub fn good(estimates: &[Estimate]) -> Option<&Estimate> {
    estimates.iter().find(|e| e.confidence >= GOOD)
}

/// Only an estimate as sure as this contradicts another one.
const SURE: f64 = 0.7;

/// One sentence for each other sure estimate that contradicts the one chosen.
pub fn contradictions(chosen: &Estimate, others: &[Estimate]) -> Vec<String> {
    let contradicts = |e: &&Estimate| {
        let factor = e.metres_per_pixel / chosen.metres_per_pixel;
        e.confidence >= SURE && !(1.0 / CONTRADICTION..=CONTRADICTION).contains(&factor)
    };
    let sentence = |e: &Estimate| {
        format!(
            "the scale is {:.5} metres per pixel ({}), but {:.5} by another way ({}); give the right one with `--set \
             metres-per-pixel`",
            chosen.metres_per_pixel, chosen.source, e.metres_per_pixel, e.source
        )
    };
    others.iter().filter(contradicts).map(sentence).collect()
}

fn measures(texts: &[SheetText]) -> Vec<(SheetText, Measure)> {
    texts.iter().filter_map(|t| Some((t.clone(), parse(&t.content)?))).collect()
}

fn estimate(agreed: &Agreement, source: &str, confidence: f64) -> Estimate {
    Estimate { metres_per_pixel: agreed.value, source: source.into(), confidence }
}

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// One measurement may be anything; three that agree are no chance.
fn by_count(agreed: &Agreement) -> f64 {
    let by_count = match agreed.count {
        0 | 1 => 0.4,
        2 => 0.7,
        _ => 0.9,
    };
    by_count * (0.5 + 0.5 * agreed.share)
}
