//! Reads with Tesseract (<https://github.com/tesseract-ocr/tesseract>, 4 or 5).

#[cfg(not(feature = "linked-tesseract"))]
mod library;
#[cfg(feature = "linked-tesseract")]
mod linked;

#[cfg(not(feature = "linked-tesseract"))]
pub use library::Tesseract;
#[cfg(feature = "linked-tesseract")]
pub use linked::Tesseract;

use super::engine::{OcrEngine, OcrEngines, OcrError};
use image::GrayImage;
use std::path::{Path, PathBuf};

/// Engines of Tesseract for these languages.
pub struct TesseractEngines {
    /// Languages as Tesseract names them, joined by `+`: `eng+deu`.
    pub languages: String,
    /// The folder of their `.traineddata`; if none, where Tesseract itself looks: `TESSDATA_PREFIX`, or the folder that
    /// was compiled into it.
    pub data: Option<PathBuf>,
}

impl OcrEngines for TesseractEngines {
    fn open(&self) -> Result<Box<dyn OcrEngine>, OcrError> {
        let engine = Tesseract::open(&self.languages, self.data.as_deref());
        engine.map(|e| Box::new(e) as Box<dyn OcrEngine>)
    }
}

impl TesseractEngines {
    /// Those of the languages that cannot be read, in their order, each with its error.
    pub fn missing(&self) -> Vec<(String, OcrError)> {
        let opened = |l: &str| Tesseract::open(l, self.data.as_deref()).err().map(|e| (l.to_owned(), e));
        self.languages.split('+').filter(|l| !l.is_empty()).filter_map(opened).collect()
    }
}

/// How Tesseract is to take a picture, as its page segmentation modes are numbered: it finds no line in one letter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Segmentation {
    /// One line.
    Line = 7,
    /// One letter.
    Letter = 10,
}

impl Segmentation {
    /// By the shape of the picture, its margin included.
    fn of(line: &GrayImage) -> Self {
        match f64::from(line.width()) / f64::from(line.height().max(1)) {
            ..1.05 => Self::Letter,
            _ => Self::Line,
        }
    }
}

/// The command that installs Tesseract, as advice.
#[cfg(not(feature = "linked-tesseract"))]
fn install_advice() -> String {
    format!("install it with `{}`, or give `ocr=off`", install_command(""))
}

/// No data for these languages.
fn no_data(languages: &str, data: Option<&Path>) -> OcrError {
    let suffix: String = languages.split('+').filter(|l| !l.is_empty()).map(|l| format!("-{l}")).collect();
    let advice = match data {
        Some(_) => format!("give the folder that holds `{languages}.traineddata`"),
        None => format!("install it with `{}`", install_command(&suffix)),
    };
    let place = data.map(|d| format!(" in {}", d.display())).unwrap_or_default();
    OcrError::Language { language: languages.into(), place, advice }
}

/// What installs Tesseract, or its data for a language.
fn install_command(language: &str) -> String {
    if cfg!(target_os = "macos") {
        let data = if language.is_empty() { "" } else { " tesseract-lang" };
        format!("brew install tesseract{data}")
    } else if cfg!(windows) {
        "winget install UB-Mannheim.TesseractOCR".into()
    } else if language.is_empty() {
        "sudo apt-get install tesseract-ocr tesseract-ocr-deu".into()
    } else {
        format!("sudo apt-get install tesseract-ocr{language}")
    }
}
