//! The steps from a page to what was read of it.

use crate::found::{SheetSymbol, SheetText};
use crate::mask::Mask;
use crate::options::Request;
use crate::page::Page;
use crate::scale::{self, Built, Drawn, Estimate, doubt};
use crate::sheet::Sheet;
use crate::stages::{Stages, Unwatched};
use crate::symbols::{self, Library, Symbols};
use crate::walls::{self, Walls};
use crate::words::{self, Words};
use crate::{doorways, overlay, prepare};
use planform_sdk::{ErrorKind, PluginError};

/// What was read of a page.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The page as a sheet.
    pub sheet: Sheet,
    /// Its words.
    pub words: Words,
    /// Its symbols, those that the document itself names included.
    pub symbols: Symbols,
    /// Its walls.
    pub walls: Walls,
    /// How large it is.
    pub scale: Estimate,
    /// What the reader should know.
    pub warnings: Vec<String>,
}

/// Reads a page.
///
/// # Errors
/// When an option cannot be followed, or the page shows no building.
pub fn read(page: &Page, request: &Request, stages: &mut dyn Stages) -> Result<Reading, PluginError> {
    let library = library(request)?;
    let said = scale::said(request, page)?;
    let sheet = prepare::sheet(page, stages);
    let words = read_words(page, &sheet, request, stages)?;
    let resolution = scale::resolution(request, page);
    let ink = sheet.ink.clone().without(&words.erase);
    let lines = ink.clone().with(&sheet.aside).without(&words.erase);
    let mut estimates: Vec<Estimate> = said.into_iter().collect();
    estimates.extend(scale::drawn(&Drawn { texts: &words.texts, lines: &lines }, resolution));
    drop(lines);
    let (mut symbols, refuted) = find_symbols(page, &sheet, &ink, &library, &mut estimates, stages);
    symbols.symbols.iter_mut().for_each(doorways::straighten);
    symbols.symbols.extend(page.symbols.iter().map(|s| symbol_on_sheet(&sheet, s)));
    let ink = ink.without(&symbols.erase).with(&symbols.hidden);
    let by_doors = || scale::by_doors(&symbols.symbols).map(|e| e.metres_per_pixel);
    let guess = good(&estimates).or_else(by_doors);
    let read = walls::Read { texts: &words.texts, symbols: &symbols.symbols };
    let walls = walls::find(&ink, &sheet, read, guess, stages);
    if !shows_walls(&walls) {
        return Err(no_walls());
    }
    symbols.symbols.retain(|s| belongs(s, &walls.inside));
    let built = Built { occupied: &walls.occupied, inside: &walls.inside, symbols: &symbols.symbols };
    estimates.extend(scale::built(&words.texts, &built));
    let (scale, doubts) = decide(&estimates, &walls);
    let size = scale::size::doubt(&walls.inside, &scale).into_iter().collect();
    let warnings = [page.warnings.clone(), words.warnings.clone(), refuted, doubts, size].concat();
    let reading = Reading { sheet, words, symbols, walls, scale, warnings };
    stages.stage("found", &mut || overlay::picture(&reading));
    Ok(reading)
}

/// The words of the page. Texts that the document holds as such are erased where they are drawn, and not read.
fn read_words(
    page: &Page,
    sheet: &Sheet,
    request: &Request,
    stages: &mut dyn Stages,
) -> Result<Words, PluginError> {
    let known: Vec<SheetText> = page.texts.iter().map(|t| on_sheet(sheet, t)).collect();
    if page.drawn {
        return words::find(sheet, &known, &request.words, stages);
    }
    Ok(Words { texts: known, erase: Mask::empty(sheet.ink.width, sheet.ink.height), warnings: Vec::new() })
}

fn library(request: &Request) -> Result<Library, PluginError> {
    request.templates.as_deref().map_or_else(Library::builtin, Library::with_folder)
}

/// The scale that the symbols may rely on.
fn good(estimates: &[Estimate]) -> Option<f64> {
    scale::good(estimates).map(|e| e.metres_per_pixel)
}

/// The symbols by the scale that is written; and without it, with a sentence that says so, if it proves wrong. Where only
/// walls are drawn, no doors can say so; and those that the document names need not be found.
fn find_symbols(
    page: &Page,
    sheet: &Sheet,
    ink: &Mask,
    library: &Library,
    estimates: &mut [Estimate],
    stages: &mut dyn Stages,
) -> (Symbols, Vec<String>) {
    if page.walls_only && !page.symbols.is_empty() {
        return (Symbols::none(ink), Vec::new());
    }
    let found = symbols::find(sheet, ink, library, good(estimates), stages);
    let chosen = estimates.iter_mut().find(|e| e.confidence >= scale::GOOD);
    let is_doubtful = |c: &&mut Estimate| {
        !page.walls_only && doubt::is_doubtful(c, &[&found.symbols[..], &page.symbols].concat())
    };
    let Some(chosen) = chosen.filter(is_doubtful) else { return (found, Vec::new()) };
    let without = symbols::find(sheet, ink, library, None, &mut Unwatched);
    match doubt::refute(chosen, &found.symbols, &without.symbols) {
        Some(sentence) if chosen.confidence < scale::GOOD => (without, vec![sentence]),
        said => (found, said.into_iter().collect()),
    }
}

/// Floor covers at least this share of the sheet.
const FLOOR: f64 = 0.002;

/// Of the walls' outline at least this share is straight.
const STRAIGHT: f64 = 0.28;

/// Whether what was taken for walls may be some.
fn shows_walls(walls: &Walls) -> bool {
    let floor = walls.inside.set.iter().zip(&walls.occupied.set).filter(|(i, o)| **i && !**o).count();
    floor as f64 > FLOOR * walls.inside.set.len() as f64 && walls.straightness >= STRAIGHT
}

/// The scale, and what speaks against it.
fn decide(estimates: &[Estimate], walls: &Walls) -> (Estimate, Vec<String>) {
    match scale::choose(estimates) {
        Some(chosen) if chosen.confidence >= scale::GOOD => {
            (chosen.clone(), scale::contradictions(chosen, estimates))
        }
        Some(chosen) => (chosen.clone(), vec![unsure(chosen)]),
        None => {
            let guessed = scale::by_rooms(walls.metres_per_pixel);
            let doubt = unsure(&guessed);
            (guessed, vec![doubt])
        }
    }
}

fn unsure(scale: &Estimate) -> String {
    format!(
        "the scale is a guess, {:.4} metres per pixel by {}; give `--set metres-per-pixel=...`, `--set scale=1:100` \
         with `--set dpi=...`, or `--set known-distance=X1,Y1,X2,Y2,METRES`",
        scale.metres_per_pixel, scale.source
    )
}

/// Whether a symbol is one of the building: legends explain signs beside it. Places to assemble at lie outside.
fn belongs(symbol: &SheetSymbol, inside: &Mask) -> bool {
    let reach = (0.5 * symbol.width.max(symbol.height)).clamp(1.0, 1e4) as i64;
    let [x, y] = symbol.centre.map(|c| c as i64);
    let around = [(0, 0), (reach, 0), (-reach, 0), (0, reach), (0, -reach)];
    symbol.kind == "assembly-point" || around.iter().any(|(dx, dy)| inside.get(x + dx, y + dy))
}

fn no_walls() -> PluginError {
    PluginError::new(ErrorKind::BadInput, "shows no walls: no straight lines in it enclose a room")
        .advise("is it the plan of a building? A robot's map is read with `--from slam-grid`")
}

/// A text of the page where it lies on the sheet.
fn on_sheet(sheet: &Sheet, text: &SheetText) -> SheetText {
    SheetText { centre: sheet.from_page(text.centre), angle: text.angle + sheet.turned, ..text.clone() }
}

/// A symbol of the page where it lies on the sheet.
fn symbol_on_sheet(sheet: &Sheet, symbol: &SheetSymbol) -> SheetSymbol {
    let mut turned = symbol.clone();
    turned.centre = sheet.from_page(symbol.centre);
    turned.angle += sheet.turned;
    for leaf in &mut turned.leaves {
        [&mut leaf.hinge, &mut leaf.closed, &mut leaf.open]
            .into_iter()
            .for_each(|p| *p = sheet.from_page(*p));
    }
    turned
}
