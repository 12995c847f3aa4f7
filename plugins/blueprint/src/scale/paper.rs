//! Scale from the paper: a ratio, and how many pixels there are to an inch.

use super::Estimate;
use crate::found::SheetText;
use crate::words::measures::Measure;
use planform_sdk::{ErrorKind, PluginError};

/// Metres of an inch.
const INCH: f64 = 0.0254;

/// The scales that whole floors are drawn at. Others are of details, or were misread.
const PLANS: std::ops::RangeInclusive<f64> = 20.0..=2500.0;

/// Pictures say 72 or 96 pixels per inch when nobody knows: what was scanned says more.
const SCREEN: f64 = 97.0;

/// How sure a written scale is at most where a person says the resolution of the paper, and where the file does: it
/// may have been scaled since.
const SAID: f64 = 0.95;
const CLAIMED: f64 = 0.65;

/// A scale that was read at all was read so well: among numbers, few are ratios by mistake.
const READ: f64 = 0.8;

/// Pixels per inch of paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Resolution {
    /// By a person.
    Said(f64),
    /// By the file alone.
    Claimed(f64),
}

impl Resolution {
    /// The number.
    pub fn dpi(self) -> f64 {
        match self {
            Self::Said(dpi) | Self::Claimed(dpi) => dpi,
        }
    }
}

/// Whether a document's resolution is that of its paper.
pub fn is_meant(dpi: f64) -> bool {
    dpi > SCREEN
}

/// Metres per pixel where one on paper is `ratio` in the world.
///
/// # Errors
/// When the resolution of the paper is not known.
pub fn given(ratio: f64, resolution: Option<Resolution>) -> Result<f64, PluginError> {
    let resolution = resolution.ok_or_else(|| {
        let message =
            "a scale is given, but not how many pixels there are to an inch of paper (files that claim 72 or 96 seldom \
             know)";
        PluginError::new(ErrorKind::BadOption, message).advise("add `--set dpi=300` with the scan's resolution")
    })?;
    Ok(ratio * INCH / resolution.dpi())
}

/// Metres per pixel by the ratio that is written on the sheet, if there is one only.
pub fn written(texts: &[(SheetText, Measure)], resolution: Option<Resolution>) -> Option<Estimate> {
    let resolution = resolution?;
    let most = if matches!(resolution, Resolution::Said(_)) { SAID } else { CLAIMED };
    let mut ratios = texts.iter().filter_map(|(text, m)| match m {
        Measure::Ratio(ratio) if PLANS.contains(ratio) => Some((text, *ratio)),
        _ => None,
    });
    let (text, ratio) = ratios.next()?;
    let source = format!("written scale {}", text.content.trim());
    let unique = ratios.all(|(_, other)| other == ratio);
    unique.then(|| Estimate {
        metres_per_pixel: ratio * INCH / resolution.dpi(),
        source,
        confidence: most * text.confidence.max(READ),
    })
}
