//! Why a plugin could not do its work.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::io;

/// Who or what is at fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum ErrorKind {
    /// The document is damaged or is not what its format promises.
    BadInput,
    /// The document is sound, but uses something that the plugin does not handle.
    Unsupported,
    /// The document is larger than a limit allows.
    Limit,
    /// An option has a value that cannot be used.
    BadOption,
    /// The operating system refused to read or write.
    Io,
    /// The plugin itself failed, whatever the document: it has a bug, or it took more time or memory than it may.
    Plugin,
}

/// Where in a document the fault lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Place {
    /// A line, from 1.
    Line(usize),
    /// A byte, from 0.
    Byte(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(n) => write!(f, "line {n}"),
            Self::Byte(n) => write!(f, "byte {n}"),
        }
    }
}

/// What went wrong, where, and what to do about it. Displayed as one sentence of plain words, the advice after a
/// semicolon; the host puts the name of the document in front.
#[derive(Debug, Serialize, Deserialize)]
pub struct PluginError {
    /// Who or what is at fault.
    pub kind: ErrorKind,
    /// What was wrong.
    pub message: String,
    /// Where in the document.
    pub place: Option<Place>,
    /// What the user can do.
    pub advice: Option<String>,
}

impl PluginError {
    /// An error of this kind.
    ///
    /// ```
    /// # use planform_sdk::{ErrorKind, Place, PluginError};
    /// let e = PluginError::new(ErrorKind::BadInput, "`resolution` is missing").at(Place::Line(3)).advise("add it");
    /// assert_eq!(e.to_string(), "line 3: `resolution` is missing; add it");
    /// ```
    pub fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self { kind, message: message.into(), place: None, advice: None }
    }

    /// The same error with its place.
    pub fn at(mut self, place: Place) -> Self {
        self.place = Some(place);
        self
    }

    /// The same error with advice.
    pub fn advise(mut self, advice: impl Into<String>) -> Self {
        self.advice = Some(advice.into());
        self
    }
}

impl fmt::Display for PluginError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = self.place {
            write!(f, "{place}: ")?;
        }
        f.write_str(&self.message)?;
        match &self.advice {
            Some(advice) => write!(f, "; {advice}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for PluginError {}

impl From<io::Error> for PluginError {
    fn from(e: io::Error) -> Self {
        Self::new(ErrorKind::Io, plain_words(&e))
    }
}

fn plain_words(e: &io::Error) -> String {
    let words = match e.kind() {
        io::ErrorKind::NotFound => "there is no such file",
        io::ErrorKind::PermissionDenied => "the system does not permit it",
        io::ErrorKind::StorageFull => "the disk is full",
        io::ErrorKind::QuotaExceeded => "the disk quota is used up",
        io::ErrorKind::FileTooLarge => "the system allows no file as large as this",
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only",
        io::ErrorKind::NotADirectory => "a part of the path is a file, not a folder",
        io::ErrorKind::IsADirectory => "is a folder, not a file",
        io::ErrorKind::AlreadyExists => "is there already",
        io::ErrorKind::InvalidFilename => {
            "the system takes no file name as long as this, or with these characters"
        }
        // The number says nothing to most people.
        _ => return e.to_string().split(" (os error").next().unwrap_or_default().into(),
    };
    words.into()
}
