//! Whose library may be loaded: one that nobody but its owner can have written.

use std::path::{Path, PathBuf};

/// The library's real path, if neither the file nor the folders above it can be written by everybody.
pub fn check(library: &Path) -> Result<PathBuf, String> {
    let path = library.canonicalize().map_err(|e| planform_sdk::PluginError::from(e).to_string())?;
    match path.ancestors().find_map(|part| fault(part, &path)) {
        Some(fault) => Err(fault),
        None => Ok(path),
    }
}

/// What is wrong with the library itself, its folder or one further up, if anything is.
#[cfg(unix)]
fn fault(part: &Path, library: &Path) -> Option<String> {
    use std::os::unix::fs::PermissionsExt;
    const EVERYBODY: u32 = 0o002;
    // In such a folder nobody can replace what is another's.
    const STICKY: u32 = 0o1000;
    let metadata = part.metadata().ok()?;
    let mode = metadata.permissions().mode();
    let direct = part == library || Some(part) == library.parent();
    if mode & EVERYBODY == 0 || (!direct && mode & STICKY != 0) {
        return None;
    }
    let what = if metadata.is_dir() { "the folder" } else { "the file" };
    Some(format!(
        "{what} `{shown}` can be written by everybody, so anybody may have put it there; `chmod o-w` mends that, or another place does",
        shown = part.display()
    ))
}

#[cfg(not(unix))]
fn fault(_: &Path, _: &Path) -> Option<String> {
    None
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    fn chmod(path: &Path, mode: u32) {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("it is the test's own");
    }

    #[test]
    fn what_everybody_can_write_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let (inner, library) = (folder.path().join("plugins"), folder.path().join("plugins/a.so"));
        fs::create_dir(&inner).unwrap();
        fs::write(&library, "").unwrap();
        chmod(&inner, 0o755);
        chmod(&library, 0o644);
        assert_eq!(check(&library).unwrap(), library.canonicalize().unwrap());
        for (path, mode, words) in [
            (library.as_path(), 0o666, "the file `"),
            (inner.as_path(), 0o777, "the folder `"),
            (inner.as_path(), 0o1777, "the folder `"),
            (folder.path(), 0o777, "the folder `"),
        ] {
            let before = fs::metadata(path).unwrap().permissions();
            chmod(path, mode);
            assert!(check(&library).unwrap_err().starts_with(words), "{mode:o}");
            fs::set_permissions(path, before).unwrap();
        }
        chmod(folder.path(), 0o1777);
        assert!(check(&library).is_ok());
        assert_eq!(check(&inner.join("b.so")).unwrap_err(), "there is no such file");
    }
}
