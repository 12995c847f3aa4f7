//! What is asked for, and what there is to do it with.

use super::engine::OcrError;
use super::tesseract::TesseractEngines;
use planform_sdk::{ErrorKind, PluginError};
use std::path::PathBuf;

/// Whether words are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OcrMode {
    /// If there is something to read them with.
    #[default]
    Auto,
    /// Always; it is an error if they cannot be.
    On,
    /// Never.
    Off,
}

/// How words are read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WordOptions {
    /// Whether.
    pub ocr: OcrMode,
    /// In which languages, as Tesseract names them, joined by `+`.
    pub lang: String,
    /// The folder of Tesseract's data, if it is not where Tesseract looks.
    pub tessdata: Option<PathBuf>,
}

impl Default for WordOptions {
    fn default() -> Self {
        Self { ocr: OcrMode::Auto, lang: "eng+deu".into(), tessdata: None }
    }
}

/// The engines to read with, if there are any, and what is missing of what was asked for.
pub fn engines(request: &WordOptions) -> Result<(Option<TesseractEngines>, Vec<String>), PluginError> {
    if request.ocr == OcrMode::Off {
        return Ok((None, Vec::new()));
    }
    let wanted: Vec<_> = request.lang.split('+').map(str::trim).filter(|l| !l.is_empty()).collect();
    let engines = TesseractEngines { languages: wanted.join("+"), data: request.tessdata.clone() };
    let missing = engines.missing();
    let Some((_, first)) = missing.first() else { return Ok((Some(engines), Vec::new())) };
    if must_work(request, first) {
        return Err(refusal(request, first.clone()));
    }
    let there: Vec<_> = wanted.iter().filter(|w| missing.iter().all(|(m, _)| m != *w)).copied().collect();
    let engines = TesseractEngines { languages: there.join("+"), ..engines };
    let warnings = match first {
        OcrError::NotInstalled(_) => vec![first.to_string()],
        _ => missing.iter().map(|(_, e)| e.to_string()).collect(),
    };
    Ok(((!there.is_empty()).then_some(engines), warnings))
}

/// Whether the user asked for what is missing.
fn must_work(request: &WordOptions, missing: &OcrError) -> bool {
    let named_folder = request.tessdata.is_some() && matches!(missing, OcrError::Language { .. });
    request.ocr == OcrMode::On || named_folder
}

/// The error as an adapter's.
pub fn refusal(request: &WordOptions, error: OcrError) -> PluginError {
    let kind = match error {
        OcrError::Language { .. } if request.tessdata.is_some() => ErrorKind::BadOption,
        OcrError::Failed(_) => ErrorKind::Plugin,
        _ => ErrorKind::Unsupported,
    };
    PluginError::new(kind, error.to_string())
}
