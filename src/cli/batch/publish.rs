//! Puts the files of a document into their places: all of them are noted in the journal first, then renamed.

use super::digest::Digest;
use super::journal::{Journal, Own};
use super::names::text_of;
use super::task::{Cause, Fault, Staged};
use super::worker::unwritable;
use crate::cli::Failure;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use tempfile::TempPath;

/// The output folder, and whether files in it that are not the batch's own may be overwritten.
pub struct Places<'a> {
    /// The folder.
    pub output: &'a Path,
    /// Whether they may.
    pub force: bool,
}

/// Why files were not published.
pub enum Unpublished {
    /// The document failed.
    Fault(Fault),
    /// The journal cannot be written.
    Journal(Failure),
}

impl From<Fault> for Unpublished {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

impl From<Failure> for Unpublished {
    fn from(failure: Failure) -> Self {
        Self::Journal(failure)
    }
}

impl Places<'_> {
    /// The path below the output folder, as the journal has it.
    pub fn below(&self, path: &Path) -> String {
        text_of(path.strip_prefix(self.output).unwrap_or(path))
    }

    /// Fails if something is in this place that must not be overwritten. What is there, if it is the batch's own.
    pub fn check(&self, path: &Path, journal: Option<&Journal>) -> Result<Option<Digest>, Unpublished> {
        match fs::symlink_metadata(path) {
            Err(e) if [io::ErrorKind::NotFound, io::ErrorKind::NotADirectory].contains(&e.kind()) => {
                return Ok(None);
            }
            Err(e) => return Err(unwritable(path, e).into()),
            Ok(there) if there.is_dir() => return Err(present(path, "is a folder; move it away").into()),
            Ok(_) => {}
        }
        let own = journal.map(|j| j.file(&self.below(path))).transpose()?.flatten();
        let content = Digest::of_file(path).map_err(|e| unwritable(path, e))?;
        match own {
            Some(own) if own.digest.as_ref() == Some(&content) || own.intended.as_ref() == Some(&content) => {
                Ok(Some(content))
            }
            _ if self.force => Ok(None),
            Some(_) => {
                Err(present(path, "was changed since planform wrote it; `--force` overwrites it").into())
            }
            None => Err(present(path, "is there already; `--force` overwrites it").into()),
        }
    }

    /// Renames the files of this document to their places, companions before what refers to them.
    pub fn publish(&self, name: &str, files: &[Staged], journal: &mut Journal) -> Result<(), Unpublished> {
        let mut intended = vec![];
        for file in files {
            let path = Path::new(&file.path);
            // What was staged lies in the output folder: if it is gone, so is that, and must not be made anew.
            fs::metadata(&file.at).map_err(|e| unwritable(path, e))?;
            let before = self.check(path, Some(journal))?;
            intended.push(Own {
                path: self.below(path),
                digest: before,
                intended: Some(file.digest.clone()),
            });
        }
        for folder in folders(files) {
            fs::create_dir_all(&folder).map_err(|e| unfoldered(&folder, e))?;
        }
        journal.intend(name, &intended)?;
        let overwrites = |own: &Own| self.force || own.digest.is_some();
        files.iter().zip(&intended).rev().try_for_each(|(file, own)| rename(file, overwrites(own)))
    }
}

/// Renames a file to its place, over what is there only if that may be.
fn rename(file: &Staged, overwrites: bool) -> Result<(), Unpublished> {
    let path = Path::new(&file.path);
    if overwrites {
        return fs::rename(&file.at, path).map_err(|e| unwritable(path, e).into());
    }
    // Somebody else may have made the file since it was checked.
    let staged = TempPath::try_from_path(PathBuf::from(&file.at)).map_err(|e| unwritable(path, e))?;
    staged.persist_noclobber(path).map_err(|e| match e.error.kind() {
        io::ErrorKind::AlreadyExists => present(path, "is there already; `--force` overwrites it").into(),
        _ => unwritable(path, e.error).into(),
    })
}

fn folders(files: &[Staged]) -> Vec<PathBuf> {
    let mut folders: Vec<_> =
        files.iter().filter_map(|f| Path::new(&f.path).parent()).map(PathBuf::from).collect();
    folders.dedup();
    folders
}

fn unfoldered(folder: &Path, error: io::Error) -> Fault {
    match error.kind() {
        io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists => {
            present(folder, "is in the way of a folder for outputs; move it away")
        }
        _ => unwritable(folder, error),
    }
}

fn present(path: &Path, reason: &str) -> Fault {
    Fault::new(Cause::Present, format!("{}: {reason}", path.display()))
}
