//! Words: found among the ink by their shape, read where there is something to read them with, and taken off without a
//! pixel of the walls that they touch.
//!
//! Connected parts (`components`) that may be letters (`glyph`) are put into lines (`lines`, `extras`). Letters that touch
//! walls are cut off them first (`cut`). Each line is cut out, turned and enlarged (`crop`), and read (`read`) by an
//! [`OcrEngine`](engine::OcrEngine), the way round that words beside it read (`context`); what does not read like words
//! (`plausible`) stays ink. Where nothing can be read, the shape of a line decides (`shape`). Coloured bands with light
//! letters are read each as a sheet of its own (`banners`).

mod banners;
mod components;
mod context;
mod crop;
mod cut;
#[cfg(test)]
mod drawn;
pub mod engine;
mod extras;
mod glyph;
mod known;
mod lines;
pub mod measures;
mod options;
mod picture;
mod plausible;
mod read;
mod search;
mod shape;
pub mod tesseract;
#[cfg(test)]
mod tests;
mod verdict;

pub use options::{OcrMode, WordOptions};

use crate::found::SheetText;
use crate::mask::Mask;
use crate::sheet::Sheet;
use crate::stages::Stages;
use engine::OcrEngines;
use planform_sdk::PluginError;
use search::Search;

/// What is written on a sheet.
#[derive(Debug, Clone)]
pub struct Words {
    /// The texts, line by line: the known ones first, then those that were read from the top down, then those on coloured
    /// bands.
    pub texts: Vec<SheetText>,
    /// The ink of all words, of those as well that could not be read.
    pub erase: Mask,
    /// What the user should know, one sentence each.
    pub warnings: Vec<String>,
}

/// If the document holds so many texts as texts, there are no others to be read.
const KNOWN_ENOUGH: usize = 5;

/// Finds the words on a sheet. `known` are the texts that the document holds as texts: they are not read, only erased.
///
/// With `ocr=auto`, what is missing for reading gives a warning; with `ocr=on` it is an error. A folder of `tessdata` that
/// does not serve is always one.
pub fn find(
    sheet: &Sheet,
    known: &[SheetText],
    request: &WordOptions,
    stages: &mut dyn Stages,
) -> Result<Words, PluginError> {
    let enough = request.ocr == OcrMode::Auto && known.len() >= KNOWN_ENOUGH;
    let (engines, warnings) = if enough { (None, Vec::new()) } else { options::engines(request)? };
    let engines = engines.as_ref().map(|e| e as &dyn OcrEngines);
    let words = find_with(sheet, known, engines).map_err(|e| options::refusal(request, e))?;
    stages.stage("words", &mut || picture::words(sheet, &words));
    Ok(Words { warnings, ..words })
}

/// Finds the words on a sheet and reads them with these engines; without any, lines of text are erased by their shape.
pub fn find_with(
    sheet: &Sheet,
    known: &[SheetText],
    engines: Option<&dyn OcrEngines>,
) -> Result<Words, engine::OcrError> {
    let search = Search::of(sheet);
    let mut erase = Mask::empty(sheet.ink.width, sheet.ink.height);
    let lines = known::take(known, &search, sheet, &mut erase);
    let mut texts = known.to_vec();
    let found = match engines {
        Some(engines) => search.read(lines, sheet, engines)?,
        None => search.by_shape(lines),
    };
    for line in found {
        search.erase(&line.parts, &sheet.ink, &mut erase);
        texts.extend(line.text);
    }
    if let Some(engines) = engines {
        texts.extend(on_banners(sheet, known, engines)?);
    }
    Ok(Words { texts, erase, warnings: Vec::new() })
}

/// The words on coloured bands that hold no known text, where they lie on the sheet.
fn on_banners(
    sheet: &Sheet,
    known: &[SheetText],
    engines: &dyn OcrEngines,
) -> Result<Vec<SheetText>, engine::OcrError> {
    let mut texts = Vec::new();
    let is_new = |b: &banners::Banner| known.iter().all(|t| !b.holds(t.centre));
    for banner in banners::find(sheet).into_iter().filter(is_new) {
        let mut search = Search::of(&banner.sheet);
        let lines = std::mem::take(&mut search.lines);
        let found = search.read(lines, &banner.sheet, engines)?.into_iter().filter_map(|f| f.text);
        texts.extend(found.map(|t| SheetText {
            centre: [t.centre[0] + f64::from(banner.at[0]), t.centre[1] + f64::from(banner.at[1])],
            ..t
        }));
    }
    Ok(texts)
}
