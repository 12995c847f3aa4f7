//! The trait of input adapters, and what the host hands them.

use crate::{ErrorKind, Kept, Options, PluginError, PluginInfo, ReadWatcher, Scene};
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Reads one family of document formats.
///
/// An adapter normalises: after it, nothing depends on the format. It neither panics nor takes memory before it has
/// checked a document's claimed size.
pub trait InputAdapter: Send + Sync {
    /// Name, extensions, options.
    fn info(&self) -> &PluginInfo;

    /// How sure the adapter is that the document is its own, from the first bytes and the name. Must be quick and
    /// must accept any bytes.
    fn probe(&self, probe: &Probe<'_>) -> Confidence;

    /// How sure the adapter is after a closer look at the whole document, which may take as long as a small part of
    /// reading it. Built-in adapters are asked when several of them claim a document with about the same confidence,
    /// and the answer stands in place of the probe's. None is no other answer than that.
    ///
    /// Others may have kept the decoded picture of the document, and what is kept here saves others work. A picture that
    /// is kept is one as stored, an `image::DynamicImage` decoded within the default limits of that crate.
    fn look(&self, source: &Source, kept: &mut Kept) -> Option<Confidence> {
        let _ = (source, kept);
        None
    }

    /// The files beside the document that belong to it, as [`Source::read_sibling`] takes them: the picture of a map, for
    /// example. They are not documents of their own where whole folders are read. None for what is not the adapter's.
    fn siblings(&self, source: &Source) -> Vec<String> {
        let _ = source;
        vec![]
    }

    /// Reads the document.
    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError>;

    /// Reads the document and tells the watcher of every stage. What is read is the same. An adapter whose work has no
    /// stages leaves this as it is.
    fn read_watched(
        &self,
        source: &Source,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        let _ = watcher;
        self.read(source, options)
    }

    /// Reads the document with the help of what looks at it left, and tells the watcher of every stage. What is read is
    /// the same. An adapter that has no use for it leaves this as it is: what was kept is dropped before it reads.
    fn read_looked_at(
        &self,
        source: &Source,
        kept: Kept,
        options: &Options,
        watcher: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        drop(kept);
        self.read_watched(source, options, watcher)
    }
}

/// What an adapter may look at to recognise a document.
#[derive(Debug, Clone, Copy)]
pub struct Probe<'a> {
    /// The document's path; empty for standard input.
    pub path: &'a Path,
    /// The first bytes: 4096 of them or the whole document, whichever is less.
    pub head: &'a [u8],
}

impl<'a> Probe<'a> {
    /// How many of a document's first bytes an adapter is shown.
    const HEAD: usize = 4096;

    /// What an adapter may look at of this document.
    pub fn of(source: &'a Source) -> Self {
        Self { path: &source.path, head: &source.bytes[..source.bytes.len().min(Self::HEAD)] }
    }

    /// The path's extension in lower case, or an empty text.
    pub fn extension(&self) -> String {
        self.path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
    }
}

/// How sure an adapter is that a document is its own: 0 is surely not, 100 surely; and why.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Confidence {
    /// 0 to 100.
    pub percent: u8,
    /// What it was judged by, for `planform inspect`: "a PNG by its first bytes".
    pub reason: String,
}

impl Confidence {
    /// Surely not this adapter's document.
    pub fn no() -> Self {
        Self { percent: 0, reason: String::new() }
    }

    /// This sure, for this reason.
    pub fn because(percent: u8, reason: impl Into<String>) -> Self {
        Self { percent, reason: reason.into() }
    }
}

/// A document: its bytes, and its folder for the files that it refers to.
#[derive(Debug, Clone)]
pub struct Source {
    /// The document's path; empty for standard input.
    pub path: PathBuf,
    /// The whole document.
    pub bytes: Vec<u8>,
    /// The most bytes that a file referred to may have.
    pub byte_limit: u64,
}

impl Source {
    /// The file name without its folder, for messages.
    pub fn name(&self) -> String {
        self.path.file_name().map_or_else(|| "standard input".into(), |n| n.to_string_lossy().into_owned())
    }

    /// Reads a file that the document refers to, relative to the document's folder; a leading `~/` is the user's home.
    pub fn read_sibling(&self, reference: &str) -> Result<Vec<u8>, PluginError> {
        let path = self.resolve(reference);
        read_file(&path, self.byte_limit)
            .map_err(|e| PluginError { message: format!("{}: {}", path.display(), e.message), ..e })
    }

    /// The path of a file that the document refers to.
    pub fn resolve(&self, reference: &str) -> PathBuf {
        match (reference.strip_prefix("~/"), std::env::home_dir()) {
            (Some(rest), Some(home)) => home.join(rest),
            _ => self.path.parent().unwrap_or(Path::new("")).join(reference),
        }
    }
}

/// Reads a file of at most `limit` bytes. Refuses directories and everything else that has no end.
fn read_file(path: &Path, limit: u64) -> Result<Vec<u8>, PluginError> {
    // Before it is opened: opening a named pipe waits for a writer.
    let metadata = std::fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(std::io::Error::from(std::io::ErrorKind::IsADirectory).into());
    }
    if !metadata.is_file() {
        return Err(PluginError::new(ErrorKind::Io, "is not a file"));
    }
    let too_large =
        || PluginError::new(ErrorKind::Limit, format!("is larger than the limit of {limit} bytes"));
    if metadata.len() > limit {
        return Err(too_large());
    }
    let mut bytes = Vec::with_capacity(metadata.len() as usize);
    // The file may grow while it is read.
    File::open(path)?.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit { Err(too_large()) } else { Ok(bytes) }
}

impl Source {
    /// The most bytes of one document unless the user says otherwise: 1 GiB.
    pub const BYTE_LIMIT: u64 = 1 << 30;

    /// Opens a document of at most `byte_limit` bytes.
    pub fn open(path: impl Into<PathBuf>, byte_limit: u64) -> Result<Self, PluginError> {
        let path = path.into();
        Ok(Self { bytes: read_file(&path, byte_limit)?, path, byte_limit })
    }
}
