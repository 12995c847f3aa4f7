//! What is known of one document in the end: a row of the journal and of the reports.

use super::digest::Digest;
use super::task::{Cause, Fault, Found};
use serde::{Deserialize, Serialize};

/// How a document stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Its outputs are there.
    Converted,
    /// It failed.
    Failed,
    /// It is no document, or belongs to one.
    Skipped,
    /// Nothing came of it yet.
    Open,
}

impl State {
    /// The state in a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converted => "converted",
            Self::Failed => "failed",
            Self::Skipped => "skipped",
            Self::Open => "open",
        }
    }
}

/// What is known of one document.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its place below the output folder, which is its name.
    pub name: String,
    /// Its path, as the user would type it.
    pub input: String,
    /// How it stands.
    pub state: State,
    /// Why it failed or was skipped, as a sentence.
    pub reason: Option<String>,
    /// Whose fault it is that it failed.
    pub cause: Option<Cause>,
    /// What was found in it.
    #[serde(flatten)]
    pub found: Found,
    /// How long its last attempt took, seconds.
    pub seconds: f64,
    /// The most memory that its process was seen with, MiB.
    pub memory_mib: u64,
    /// How often it was tried.
    pub attempts: u32,
    /// Its outputs.
    pub outputs: Vec<Written>,
}

/// An output that is in its place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Written {
    /// Its path below the output folder.
    pub path: String,
    /// Its length.
    pub bytes: u64,
    /// What it holds.
    pub sha256: Digest,
}

impl Record {
    /// A document of which nothing came yet.
    pub fn open(name: &str, input: &str) -> Self {
        Self {
            name: name.into(),
            input: input.into(),
            state: State::Open,
            reason: None,
            cause: None,
            found: Found::default(),
            seconds: 0.0,
            memory_mib: 0,
            attempts: 0,
            outputs: vec![],
        }
    }

    /// The same, left out for this reason.
    pub fn skipped(self, reason: String) -> Self {
        Self { state: State::Skipped, reason: Some(reason), ..self }
    }

    /// The same, failed.
    pub fn failed(self, fault: Fault) -> Self {
        Self { state: State::Failed, reason: Some(fault.sentence), cause: Some(fault.cause), ..self }
    }
}
