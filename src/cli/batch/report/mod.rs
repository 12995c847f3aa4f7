//! The reports of a batch: what became of every document, for spreadsheets, for programs, and for people.

mod csv;
mod html;
mod jsonl;

use super::documents::Listed;
use super::journal::Journal;
use super::names::text_of;
use super::record::{Record, State};
use super::task::Thumbnails;
use crate::cli::Failure;
use planform_sdk::PluginError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A document of the report.
pub struct Row {
    /// What is known of it.
    pub record: Record,
    /// Small pictures.
    pub thumbnails: Thumbnails,
}

/// How many documents stand how.
#[derive(Debug, Default, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Totals {
    /// All of them.
    pub documents: usize,
    /// Those whose outputs are there.
    pub converted: usize,
    /// Those that failed.
    pub failed: usize,
    /// Those that are none.
    pub skipped: usize,
    /// Those of which nothing came yet.
    pub open: usize,
}

impl Totals {
    fn count(&mut self, state: State) {
        self.documents += 1;
        *match state {
            State::Converted => &mut self.converted,
            State::Failed => &mut self.failed,
            State::Skipped => &mut self.skipped,
            State::Open => &mut self.open,
        } += 1;
    }

    /// `940 converted, 10 skipped, 50 failed`
    pub fn words(&self) -> String {
        let parts = [
            (self.converted, "converted"),
            (self.skipped, "skipped"),
            (self.failed, "failed"),
            (self.open, "not done yet"),
        ];
        let parts: Vec<_> =
            parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
        let documents =
            if self.documents == 1 { "1 file".into() } else { format!("{} files", self.documents) };
        format!("{documents}: {}", if parts.is_empty() { "nothing to do".into() } else { parts.join(", ") })
    }
}

/// What the journal knows of these documents.
pub struct Report<'a> {
    /// The documents.
    pub documents: &'a [Listed],
    /// What came of them.
    pub journal: &'a Journal,
}

impl Report<'_> {
    fn rows(&self) -> impl Iterator<Item = Result<Row, Failure>> {
        self.documents.iter().map(|document| self.row(document))
    }

    fn row(&self, document: &Listed) -> Result<Row, Failure> {
        let name = document.name();
        Ok(match self.journal.entry(&name)? {
            Some(entry) => Row { record: entry.record, thumbnails: entry.thumbnails },
            None => Row {
                record: Record::open(&name, &text_of(&document.input)),
                thumbnails: Thumbnails::default(),
            },
        })
    }

    /// How many documents stand how.
    pub fn totals(&self) -> Result<Totals, Failure> {
        let mut totals = Totals::default();
        for row in self.rows() {
            totals.count(row?.record.state);
        }
        Ok(totals)
    }

    /// Writes all three reports into this folder, over those of former runs; the path of the one for people.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, Failure> {
        write(&folder.join("report.csv"), |out| csv::write(out, self.rows()))?;
        write(&folder.join("report.jsonl"), |out| jsonl::write(out, self.rows()))?;
        let page = folder.join("report.html");
        write(&page, |out| html::write(out, self.rows()))?;
        Ok(page)
    }
}

/// Why a report is not written.
enum Unwritten {
    /// The journal cannot be read.
    Journal(Failure),
    /// The report cannot be written.
    Io(io::Error),
}

impl From<Failure> for Unwritten {
    fn from(failure: Failure) -> Self {
        Self::Journal(failure)
    }
}

impl From<io::Error> for Unwritten {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// Writes a file beside its place, and renames it when it is whole. One that a run left behind that was killed is
/// overwritten: nobody else writes here.
fn write(path: &Path, content: impl FnOnce(&mut dyn Write) -> Result<(), Unwritten>) -> Result<(), Failure> {
    let part = path.with_added_extension("part");
    let written = || -> Result<(), Unwritten> {
        let mut out = BufWriter::new(File::create(&part)?);
        content(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        Ok(fs::rename(&part, path)?)
    };
    written().map_err(|e| match e {
        Unwritten::Journal(failure) => failure,
        Unwritten::Io(e) => {
            let advice = "what is converted is in its place; run again with `--resume` for the report";
            Failure::over(path, format!("{}; {advice}", PluginError::from(e)))
        }
    })
}
