//! Why two layouts could not be compared.

use planform_sdk::{ErrorKind, PluginError};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// What was wrong, and with which file.
#[derive(Debug, Error)]
#[error("{}: {error}", file.display())]
pub struct EvaluateError {
    /// The file that the reason is about.
    pub file: PathBuf,
    /// The reason.
    pub error: PluginError,
}

/// Names the file of a reason.
pub(super) trait Over<T> {
    fn over(self, file: &Path) -> Result<T, EvaluateError>;
}

impl<T> Over<T> for Result<T, PluginError> {
    fn over(self, file: &Path) -> Result<T, EvaluateError> {
        self.map_err(|error| EvaluateError { file: file.into(), error })
    }
}

pub(super) fn bad(message: impl Into<String>) -> PluginError {
    PluginError::new(ErrorKind::BadInput, message)
}

pub(super) fn limit(message: impl Into<String>) -> PluginError {
    PluginError::new(ErrorKind::Limit, message)
}

/// A reason in `serde_json`'s words, of which the end tells line and column.
pub(super) fn bad_json(reason: impl std::fmt::Display) -> PluginError {
    bad(format!("is not the JSON expected here: {reason}"))
}
