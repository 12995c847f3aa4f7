//! Which documents a batch has: those of folders, of patterns, of a manifest, and those named one by one. They come in
//! the order of their names, and every one has a place below the output folder.

mod folder;
mod manifest;
mod pattern;
mod siblings;

use super::names::text_of;
use crate::cli::Failure;
use crate::host::{Registry, Setting};
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

/// A document that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Listed {
    /// Where its outputs lie below the output folder, but for what their formats add.
    pub place: PathBuf,
    /// Its path, as the user would type it.
    pub input: PathBuf,
    /// Whether the user named it, and did not just name a folder or a pattern: then it has to be a document.
    pub named: bool,
    /// The files that belong to it.
    pub siblings: Vec<PathBuf>,
    /// What the manifest says of it.
    pub row: Row,
    /// Why it cannot even be tried.
    pub trouble: Option<Trouble>,
}

/// What a manifest says of one document.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Row {
    /// Its outputs, below the output folder; none are those of `--to`.
    pub outputs: Vec<PathBuf>,
    /// Options for it alone.
    pub settings: Vec<Setting>,
    /// The input adapter that reads it.
    pub from: Option<String>,
}

/// Why a document is not tried.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Trouble {
    /// It is left out, for this reason.
    LeftOut(String),
    /// It failed, for this reason.
    Broken(String),
}

impl Listed {
    fn new(place: PathBuf, input: PathBuf, named: bool) -> Self {
        Self { place, input, named, siblings: vec![], row: Row::default(), trouble: None }
    }

    /// The name that it goes by: its place as a text.
    pub fn name(&self) -> String {
        text_of(&self.place)
    }
}

/// What the command line says of where documents are.
pub struct Sources<'a> {
    /// Folders, patterns and files.
    pub inputs: &'a [PathBuf],
    /// A manifest.
    pub manifest: Option<&'a Path>,
    /// The folder that is written to: what is in there is no document.
    pub output: &'a Path,
    /// Whether documents may still come: then a pattern need not match any yet.
    pub patient: bool,
}

/// The documents, by their names.
pub fn find(sources: &Sources<'_>, registry: &Registry) -> Result<Vec<Listed>, Failure> {
    let several = sources.inputs.len() + usize::from(sources.manifest.is_some()) > 1;
    let mut all = vec![];
    for input in sources.inputs {
        all.extend(of_input(input, several, sources)?);
    }
    if let Some(manifest) = sources.manifest {
        all.extend(manifest::read(manifest)?);
    }
    let mut documents = distinct(all)?;
    documents.iter_mut().for_each(|d| d.siblings = siblings::of(d, registry));
    leave_out_siblings(&mut documents);
    Ok(documents)
}

fn of_input(input: &Path, several: bool, sources: &Sources<'_>) -> Result<Vec<Listed>, Failure> {
    let Sources { output, patient, .. } = *sources;
    if input.is_dir() {
        return folder::read(input, several, output);
    }
    if !input.exists() && pattern::is_pattern(input) {
        let found = pattern::read(input, several, output)?;
        if found.is_empty() && !patient {
            return Err(Failure::over(input, "there is no such file, and none that this pattern matches"));
        }
        return Ok(found);
    }
    let name = input.file_name().ok_or_else(|| Failure::over(input, "is no file and no folder"))?;
    Ok(vec![Listed::new(name.into(), input.into(), true)])
}

/// The documents by their names; fails if two have one. The same file twice is one document.
fn distinct(all: Vec<Listed>) -> Result<Vec<Listed>, Failure> {
    let mut by_name: BTreeMap<String, Listed> = BTreeMap::new();
    for document in all {
        match by_name.get(&document.name()) {
            Some(before) if before.input != document.input => {
                let (one, other) = (before.input.display(), document.input.display());
                let advice = "give the folder that both are in, or a manifest that names their outputs";
                return Err(Failure::Usage(format!("{other}: would be written where {one} is; {advice}")));
            }
            Some(before) if before.row != document.row => {
                let message = "is named twice, with different outputs or options; put them into one line";
                return Err(Failure::Usage(format!("{}: {message}", document.input.display())));
            }
            _ => drop(by_name.insert(document.name(), document)),
        }
    }
    Ok(by_name.into_values().collect())
}

/// A file that belongs to a document is none itself, unless the user named it.
fn leave_out_siblings(documents: &mut [Listed]) {
    let owners = documents.iter().flat_map(|d| d.siblings.iter().map(|s| (real(s), d.name())));
    let owners: BTreeMap<_, _> = owners.collect();
    let named: HashSet<_> = documents.iter().filter(|d| d.named).map(|d| real(&d.input)).collect();
    for document in documents.iter_mut().filter(|d| d.trouble.is_none()) {
        let own = real(&document.input);
        if let Some(owner) = owners.get(&own).filter(|owner| **owner != document.name())
            && !named.contains(&own)
        {
            document.trouble = Some(Trouble::LeftOut(format!("belongs to {owner}")));
        }
    }
}

/// The path without symbolic links.
fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.into())
}
