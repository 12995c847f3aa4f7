//! What reads a line of text, whoever does it.

use image::GrayImage;
use thiserror::Error;

/// Reads pictures of text. One engine works for one thread; `&mut` as most keep their last picture.
pub trait OcrEngine {
    /// The words on a picture of one upright line, dark on white with a white margin, from left to right.
    fn read(&mut self, line: &GrayImage) -> Result<Vec<OcrWord>, OcrError>;
}

/// Makes engines, one for every thread that reads.
pub trait OcrEngines: Sync {
    /// A new engine.
    fn open(&self) -> Result<Box<dyn OcrEngine>, OcrError>;
}

/// A word as an engine read it.
#[derive(Debug, Clone, PartialEq)]
pub struct OcrWord {
    /// What it says.
    pub text: String,
    /// Left, top, right and bottom in pixels of the picture, right and bottom exclusive.
    pub bounds: [i32; 4],
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// Why nothing can be read. Each is a sentence with what to do about it.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum OcrError {
    /// There is no engine on this machine.
    #[error("words cannot be read because Tesseract is not installed; {0}")]
    NotInstalled(String),
    /// The engine lacks what it has to know of a language.
    #[error("Tesseract has no data for the language `{language}`{place}; {advice}")]
    Language {
        /// As the user or the default names it.
        language: String,
        /// Where it was looked for, if that is known: " in FOLDER".
        place: String,
        /// What to do.
        advice: String,
    },
    /// The engine gave up.
    #[error("Tesseract failed while it {0}; give `ocr=off` to do without it")]
    Failed(&'static str),
}
