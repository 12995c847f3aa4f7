//! What a document's process is told, and what it answers.

use super::digest::{Digest, Seen};
use crate::cli::caps::Caps;
use crate::host::Setting;
use crate::reconstruct::Params;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;

/// The verb by which the program works on one document; not for people.
pub const VERB: &str = "batch-process";

/// One document and what is to become of it. Paths need not be UTF-8.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Task {
    /// The document.
    pub input: OsString,
    /// The files that belong to it.
    pub siblings: Vec<OsString>,
    /// Whether it has to be a document that planform knows.
    pub named: bool,
    /// The outputs, and the exporters that write them.
    pub outputs: Vec<(OsString, String)>,
    /// The folder that the outputs are written to for the time being.
    pub staging: OsString,
    /// How it is read.
    pub how: How,
    /// The most memory that it may take, MiB.
    pub memory: u64,
}

/// How a document is read and reconstructed.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct How {
    /// The input adapter, if it is given.
    pub from: Option<String>,
    /// Options for whoever has them.
    pub settings: Vec<Setting>,
    /// Options that this document must take.
    pub own_settings: Vec<Setting>,
    /// The parameters of the reconstruction.
    pub params: Params,
    /// How much there may be in the document.
    pub caps: Caps,
    /// The plugins from outside.
    pub outside: Outside,
}

/// Where plugins from outside are looked for, and how they are run.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Outside {
    /// Folders to search before all others.
    pub folders: Vec<OsString>,
    /// Seconds and MiB that they may take in processes of their own; none has them run in the document's.
    pub isolation: Option<(u64, u64)>,
}

/// What came of a document.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Answer {
    /// What was read, if it could be.
    pub seen: Option<Seen>,
    /// Small pictures.
    pub thumbnails: Thumbnails,
    /// The most memory that its process held, bytes; 0 where the system does not tell.
    pub memory: u64,
    /// What came of it.
    pub outcome: Outcome,
}

/// Small pictures as PNG files in base64.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Thumbnails {
    /// The document.
    pub before: Option<String>,
    /// Its layout.
    pub after: Option<String>,
}

/// How the work on a document ended.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub enum Outcome {
    /// Its outputs wait in the staging folder.
    Converted(Box<Converted>),
    /// It is no document that planform knows, and nobody said that it is.
    LeftOut(String),
    /// It failed.
    Failed(Fault),
}

/// Why a document failed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// Whose fault it is.
    pub cause: Cause,
    /// What was wrong, where, and what to do.
    pub sentence: String,
}

impl Fault {
    /// A fault with its sentence.
    pub fn new(cause: Cause, sentence: impl Into<String>) -> Self {
        Self { cause, sentence: sentence.into() }
    }
}

/// Whose fault it is that a document failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Cause {
    /// The document itself, or an option for it.
    Document,
    /// A plugin from outside.
    Plugin,
    /// A bug of planform's.
    Bug,
    /// The document is not there, or may not be read.
    Missing,
    /// What is there must not be overwritten.
    Present,
    /// The document changed while it was read.
    Changed,
    /// The system refused to read, to write or to start a process.
    System,
    /// The document's process crashed.
    Crash,
    /// It took too long.
    Time,
    /// It took too much memory.
    Memory,
    /// The disk is full.
    Disk,
    /// The output folder is not there any more.
    Gone,
}

/// A converted document.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Converted {
    /// What was found in it.
    pub found: Found,
    /// The files that are to be published, each output before its companions.
    pub files: Vec<Staged>,
}

/// What was found in a document.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// In words: `12 rooms, 58 walls, 14 doors`.
    pub summary: String,
    /// The adapter that read it.
    pub adapter: String,
    /// Rooms.
    pub rooms: usize,
    /// Those of them that were seen in part.
    pub partial_rooms: usize,
    /// The rooms' floor area, square metres.
    pub area: f64,
    /// Walls.
    pub walls: usize,
    /// Doors.
    pub doors: usize,
    /// Passages.
    pub passages: usize,
    /// What the adapter warns of.
    pub warnings: Vec<String>,
}

/// A file that waits in the staging folder.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Staged {
    /// Where it is.
    pub at: OsString,
    /// Where it belongs.
    pub path: OsString,
    /// Its length.
    pub bytes: u64,
    /// What it holds.
    pub digest: Digest,
}
