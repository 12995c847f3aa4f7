//! What is to be done with each document, and whether it was done before.

use super::digest::{Digest, Seen, Stamp};
use super::documents::Listed;
use super::formats::{self, Format};
use super::journal::{Entry, Journal};
use super::publish::Places;
use super::record::State;
use super::retry::is_lasting;
use super::task::How;
use crate::cli::Failure;
use crate::cli::output::Target;
use crate::host::Registry;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// The version of this program, which the outputs depend on.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A document and what is to become of it.
#[derive(Debug, Clone)]
pub struct Job {
    /// The document's place below the output folder.
    pub name: String,
    /// The document and its siblings.
    pub files: Vec<PathBuf>,
    /// Whether the user named it.
    pub named: bool,
    /// How it is read.
    pub how: How,
    /// Its outputs and their formats.
    pub outputs: Vec<(PathBuf, String)>,
    /// Where its outputs and their companions lie.
    pub places: Vec<PathBuf>,
    /// Digest of all that its outputs depend on but for the document itself.
    pub options: Digest,
}

impl Job {
    /// The document.
    pub fn input(&self) -> &Path {
        &self.files[0]
    }
}

/// What all documents have in common.
pub struct Common<'a> {
    /// The output folder.
    pub output: &'a Path,
    /// The formats of documents without outputs of their own.
    pub formats: &'a [Format],
    /// How documents are read.
    pub how: &'a How,
    /// The plugins.
    pub registry: &'a Registry,
}

/// The jobs of these documents. Fails if two would write one file.
pub fn of(documents: &[Listed], common: &Common<'_>) -> Result<Vec<Job>, Failure> {
    let jobs: Vec<_> = documents.iter().map(|d| job(d, common)).collect::<Result<_, _>>()?;
    let mut writers: HashMap<&Path, &str> = HashMap::new();
    for job in &jobs {
        for place in &job.places {
            if let Some(other) = writers.insert(place, &job.name) {
                let both = if other == job.name {
                    "twice".into()
                } else {
                    format!("for {other} and for {}", job.name)
                };
                return Err(Failure::Usage(format!("{}: would be written {both}", place.display())));
            }
        }
    }
    Ok(jobs)
}

fn job(document: &Listed, common: &Common<'_>) -> Result<Job, Failure> {
    let outputs = outputs(document, common)?;
    let places = outputs.iter().flat_map(|(path, format)| places(path, format, common.registry)).collect();
    let row = &document.row;
    let how = How {
        from: row.from.clone().or_else(|| common.how.from.clone()),
        own_settings: row.settings.clone(),
        ..common.how.clone()
    };
    let options = options(&how, &outputs, common.output);
    let files = std::iter::once(&document.input).chain(&document.siblings).cloned().collect();
    Ok(Job { name: document.name(), files, named: document.named, how, outputs, places, options })
}

fn outputs(document: &Listed, common: &Common<'_>) -> Result<Vec<(PathBuf, String)>, Failure> {
    if document.row.outputs.is_empty() {
        let output = |f: &Format| {
            (common.output.join(document.place.with_added_extension(&f.extension)), f.exporter.clone())
        };
        return Ok(common.formats.iter().map(output).collect());
    }
    let named = |path: &PathBuf| {
        let format = formats::of_path(path, common.registry)?;
        Ok((common.output.join(path), format))
    };
    document.row.outputs.iter().map(named).collect()
}

fn places(path: &Path, format: &str, registry: &Registry) -> Vec<PathBuf> {
    registry
        .exporter(format)
        .map_or_else(|| vec![path.into()], |exporter| Target::new(path, exporter).paths())
}

/// Digest of what the outputs depend on, wherever the output folder is.
fn options(how: &How, outputs: &[(PathBuf, String)], output: &Path) -> Digest {
    let below = |path: &PathBuf| super::names::text_of(path.strip_prefix(output).unwrap_or(path));
    let outputs: Vec<_> = outputs.iter().map(|(path, format)| (below(path), format)).collect();
    // How long a plugin may take changes no output.
    let mut how = how.clone();
    how.outside.isolation = None;
    Digest::of(serde_json::json!([how, outputs]).to_string().as_bytes())
}

/// Whether a document is to be worked on.
pub enum Verdict {
    /// It was never finished.
    New,
    /// It was, but must be done again for this reason.
    Again(String),
    /// It was, and nothing has changed since.
    Settled(Box<Entry>),
}

/// Whether the journal holds all that this job would bring. `retry_failed` has all failed ones tried again.
pub fn verdict(
    job: &Job,
    journal: &Journal,
    places: &Places<'_>,
    retry_failed: bool,
) -> Result<Verdict, Failure> {
    let unfinished = || Verdict::Again("it was in work when the last run ended".into());
    let files = journal.files(&job.name)?;
    let is_unfinished = files.iter().any(|f| f.intended.is_some());
    let Some(entry) = journal.entry(&job.name)? else {
        return Ok(if is_unfinished { unfinished() } else { Verdict::New });
    };
    let changed = change(job, &entry).or_else(|| match entry.record.state {
        State::Failed if retry_failed || !entry.record.cause.is_some_and(is_lasting) => {
            Some("it failed before".into())
        }
        State::Converted => lost_output(job, journal, places),
        _ => None,
    });
    Ok(match changed {
        Some(reason) => Verdict::Again(reason),
        None if is_unfinished => unfinished(),
        None => Verdict::Settled(Box::new(entry)),
    })
}

fn change(job: &Job, entry: &Entry) -> Option<String> {
    if entry.version != VERSION {
        return Some(format!("it was converted by planform {}, and this is {VERSION}", entry.version));
    }
    if entry.options != job.options {
        return Some("its options or outputs changed".into());
    }
    match &entry.seen {
        Some(seen) => (!is_same(&job.files, seen)).then(|| "the document changed".into()),
        None => Some("it could not be read before".into()),
    }
}

/// Whether the files are those that were seen. Their content is read only if they were written since.
fn is_same(files: &[PathBuf], seen: &Seen) -> bool {
    let stamps = Stamp::of_files(files);
    stamps.is_ok_and(|now| now == seen.stamps) || Digest::of_files(files).is_ok_and(|now| now == seen.digest)
}

fn lost_output(job: &Job, journal: &Journal, places: &Places<'_>) -> Option<String> {
    let lost = |path: &&PathBuf| {
        let own = journal.file(&places.below(path)).ok().flatten().and_then(|own| own.digest);
        own.is_none() || Digest::of_file(path).ok() != own
    };
    let path = job.places.iter().find(lost)?;
    let what = if path.exists() { "was changed" } else { "is missing" };
    Some(format!("its output {} {what}", path.display()))
}
