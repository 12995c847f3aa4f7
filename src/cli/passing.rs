//! The files that have a passing name: none stays behind when the user or the system ends the program.

use super::failure::INTERRUPTED;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Mutex, MutexGuard, Once, PoisonError};
use tempfile::NamedTempFile;

static PASSING: Passing = Passing::new();
static HANDLER: Once = Once::new();

/// Makes a file with `make`. It is on the list of files to remove until its entry is dropped.
pub fn create(
    make: impl FnOnce() -> io::Result<NamedTempFile>,
) -> io::Result<(NamedTempFile, Entry<'static>)> {
    HANDLER.call_once(listen);
    PASSING.create(make)
}

/// Has SIGINT, SIGTERM and SIGHUP, or Ctrl-C, remove the files.
fn listen() {
    // Fails where a signal is ignored already, as `nohup` does with SIGHUP: then it is to stay so.
    let _ = ctrlc::try_set_handler(|| {
        // Locked to the end, so that no new file is made.
        let mut paths = PASSING.lock();
        remove(&mut paths);
        process::exit(INTERRUPTED.into());
    });
}

/// A list of files.
struct Passing(Mutex<Vec<PathBuf>>);

impl Passing {
    const fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    fn lock(&self) -> MutexGuard<'_, Vec<PathBuf>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a file and notes it. No interrupt comes between.
    fn create(
        &self,
        make: impl FnOnce() -> io::Result<NamedTempFile>,
    ) -> io::Result<(NamedTempFile, Entry<'_>)> {
        let mut paths = self.lock();
        let file = make()?;
        let path = file.path().to_path_buf();
        paths.push(path.clone());
        Ok((file, Entry { list: self, path }))
    }

    fn forget(&self, path: &Path) {
        self.lock().retain(|p| p != path);
    }
}

fn remove(paths: &mut Vec<PathBuf>) {
    // A file that cannot be removed is lost; nobody could do more.
    paths.drain(..).for_each(|path| drop(fs::remove_file(path)));
}

/// A file's place on the list, until dropped.
pub struct Entry<'a> {
    list: &'a Passing,
    path: PathBuf,
}

impl Drop for Entry<'_> {
    fn drop(&mut self) {
        self.list.forget(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_on_the_list_is_removed_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let list = Passing::new();
        let make = || list.create(|| NamedTempFile::new_in(folder.path())).unwrap();
        let (published, entry) = make();
        published.persist(folder.path().join("a.svg")).unwrap();
        drop(entry);
        let (_staged, _entry) = make();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
        remove(&mut list.lock());
        let left: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
        assert_eq!(left, ["a.svg"]);
    }

    #[test]
    fn a_file_that_cannot_be_made_is_not_on_the_list() {
        let list = Passing::new();
        assert!(list.create(|| Err(io::ErrorKind::PermissionDenied.into())).is_err());
        drop(list.create(NamedTempFile::new).unwrap());
        assert!(list.lock().is_empty());
    }
}
