//! Tesseract as a library that the program was linked with, through the crate tesseract-rs.

use super::{Segmentation, no_data};
use crate::words::engine::{OcrEngine, OcrError, OcrWord};
use image::GrayImage;
use std::path::Path;
use tesseract_rs::{ResultIterator, TessPageIteratorLevel, TessPageSegMode, TesseractAPI, TesseractError};

/// The neural network alone, without the engine of Tesseract 3 that few installations have the data for.
const OEM_LSTM_ONLY: i32 = 1;
/// What the pictures are said to have, dots per inch.
const DPI: i32 = 300;

/// One engine of Tesseract.
pub struct Tesseract(TesseractAPI);

impl Tesseract {
    /// An engine for these languages (`eng+deu`), with data from this folder or from where Tesseract itself looks.
    pub fn open(languages: &str, data: Option<&Path>) -> Result<Self, OcrError> {
        let missing = || no_data(languages, data);
        // No folder is where Tesseract itself looks.
        let folder = data.map(Path::to_string_lossy).unwrap_or_default();
        if languages.contains('\0') || folder.contains('\0') {
            return Err(missing());
        }
        let api = TesseractAPI::new();
        let nowhere = if cfg!(windows) { "NUL" } else { "/dev/null" };
        let failed = |_| OcrError::Failed("started");
        api.set_variable("debug_file", nowhere).map_err(failed)?;
        api.init_2(&folder, languages, OEM_LSTM_ONLY).map_err(|_| missing())?;
        Ok(Self(api))
    }

    fn recognize(&self, line: &GrayImage) -> Result<(), TesseractError> {
        let side = |s: u32| i32::try_from(s).map_err(|_| TesseractError::InvalidDimensions);
        let (width, height) = (side(line.width())?, side(line.height())?);
        self.0.set_page_seg_mode(match Segmentation::of(line) {
            Segmentation::Line => TessPageSegMode::PSM_SINGLE_LINE,
            Segmentation::Letter => TessPageSegMode::PSM_SINGLE_CHAR,
        })?;
        self.0.set_image(line.as_raw(), width, height, 1, width)?;
        self.0.set_source_resolution(DPI)?;
        self.0.recognize()
    }
}

impl OcrEngine for Tesseract {
    fn read(&mut self, line: &GrayImage) -> Result<Vec<OcrWord>, OcrError> {
        self.recognize(line).map_err(|_| OcrError::Failed("read a line"))?;
        // Nothing to go through means that nothing was found.
        let Ok(iterator) = self.0.get_iterator() else { return Ok(Vec::new()) };
        let mut words = Vec::new();
        loop {
            words.extend(word(&iterator).filter(|w| !w.text.is_empty()));
            if !iterator.next(TessPageIteratorLevel::RIL_WORD).unwrap_or(false) {
                return Ok(words);
            }
        }
    }
}

/// The word that the iterator stands at.
fn word(iterator: &ResultIterator) -> Option<OcrWord> {
    let (text, left, top, right, bottom, percent) = iterator.get_current_word().ok()?;
    let confidence = (f64::from(percent) / 100.0).clamp(0.0, 1.0);
    Some(OcrWord { text: text.trim().to_owned(), bounds: [left, top, right, bottom], confidence })
}
