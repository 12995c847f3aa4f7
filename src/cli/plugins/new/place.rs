//! Puts the files of a new project into its folder: all of them or none.

use super::File;
use crate::cli::Failure;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;
use tempfile::TempDir;

/// Writes the files into the folder, which must be new or empty.
pub fn write(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let is_new = check(folder)?;
    let written = fs::create_dir_all(folder).and_then(|()| fill(folder, files));
    if written.is_err() && is_new {
        // It is as it was when this fails as well.
        let _ = fs::remove_dir(folder);
    }
    written.map_err(|e| Failure::of_io(folder, e))
}

/// Whether the folder is yet to be made. Fails when there is something in its place.
fn check(folder: &Path) -> Result<bool, Failure> {
    match fs::read_dir(folder).map(|mut entries| entries.next().is_none()) {
        Ok(true) => Ok(false),
        Ok(false) => {
            Err(Failure::over(folder, "is there already and not empty; `--dir` names another folder"))
        }
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(true),
        Err(e) => Err(Failure::of_io(folder, e)),
    }
}

/// Writes the files aside first, so that a full disk leaves nothing half done.
fn fill(folder: &Path, files: &[File]) -> io::Result<()> {
    let aside = TempDir::with_prefix_in(".planform-", folder)?;
    for (path, text) in files {
        let path = aside.path().join(path);
        fs::create_dir_all(path.parent().unwrap_or(aside.path()))?;
        fs::write(path, text)?;
    }
    for entry in fs::read_dir(aside.path())? {
        let entry = entry?;
        fs::rename(entry.path(), folder.join(entry.file_name()))?;
    }
    aside.close()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(path: &str) -> File {
        (path.into(), "text".into())
    }

    #[test]
    fn files_are_written_into_a_new_or_an_empty_folder() {
        let root = TempDir::new().unwrap();
        for folder in [root.path().join("a/b"), root.path().join("a/c")] {
            if folder.ends_with("c") {
                fs::create_dir(&folder).unwrap();
            }
            write(&folder, &[file("one"), file(".two"), file("deep/three")]).unwrap();
            assert_eq!(fs::read(folder.join("deep/three")).unwrap(), b"text");
            assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
        }
    }

    #[test]
    fn what_cannot_be_written_whole_is_not_written() {
        let root = TempDir::new().unwrap();
        let folder = root.path().join("new");
        // The second would have to be a folder and a file.
        assert!(write(&folder, &[file("one"), file("one/two")]).is_err());
        assert!(!folder.exists());
    }

    #[test]
    fn nothing_is_overwritten() {
        let root = TempDir::new().unwrap();
        fs::write(root.path().join("mine"), "").unwrap();
        for taken in [root.path().to_path_buf(), root.path().join("mine")] {
            assert!(write(&taken, &[file("one")]).is_err());
        }
        assert_eq!(fs::read_dir(root.path()).unwrap().count(), 1);
    }
}
