//! Where libraries of plugins are looked for.

use std::collections::BTreeSet;
use std::env;
use std::env::consts::DLL_EXTENSION;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

/// The variable that names further folders.
pub const PATH_VARIABLE: &str = "PLANFORM_PLUGIN_PATH";

/// The folders of the system: what its administrator installed, then what its packages did.
const SYSTEM: [&str; 2] = ["/usr/local/lib/planform/plugins", "/usr/lib/planform/plugins"];

/// The folders in the order in which they are searched, and what was wrong with those left out.
///
/// The working directory is none of them, nor is anything relative to it, unless the user asked for it on the command
/// line: otherwise whoever wrote the folder that the user stands in could run code as the user.
pub fn folders(given: &[PathBuf]) -> (Vec<PathBuf>, Vec<String>) {
    let listed: Vec<_> = env::var_os(PATH_VARIABLE).iter().flat_map(env::split_paths).collect();
    let (listed, relative): (Vec<_>, Vec<_>) = listed.into_iter().partition(|p| p.is_absolute());
    let users = users_folder(env::var_os("XDG_DATA_HOME"), env::home_dir());
    let folders = given.iter().cloned().chain(listed).chain(users).chain(SYSTEM.map(PathBuf::from));
    (folders.collect(), relative.iter().filter(|p| !p.as_os_str().is_empty()).map(|p| left_out(p)).collect())
}

fn left_out(folder: &Path) -> String {
    format!("{PATH_VARIABLE} names the folder `{}`, which is left out: give its full path", folder.display())
}

/// The user's own folder, by the XDG Base Directory Specification, which has relative paths ignored.
pub fn users_folder(data_home: Option<OsString>, home: Option<PathBuf>) -> Option<PathBuf> {
    let absolute = |path: PathBuf| path.is_absolute().then_some(path);
    let data = data_home.map(PathBuf::from).and_then(absolute);
    let data = data.or_else(|| Some(home.and_then(absolute)?.join(".local/share")))?;
    Some(data.join("planform/plugins"))
}

/// The libraries in these folders, each once.
pub fn libraries_in(folders: &[PathBuf]) -> Vec<PathBuf> {
    let mut seen = BTreeSet::new();
    let libraries = folders.iter().flat_map(|folder| libraries(folder));
    libraries
        .filter(|library| seen.insert(library.canonicalize().unwrap_or_else(|_| library.clone())))
        .collect()
}

/// The libraries in a folder, by name. A folder that is not there has none.
fn libraries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut libraries: Vec<_> = entries
        .map(|e| e.path())
        .filter(|p| p.extension().is_some_and(|e| e == DLL_EXTENSION) && p.is_file())
        .collect();
    libraries.sort();
    libraries
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_users_folder_is_that_of_the_specification() {
        let folder = |data: Option<&str>, home: Option<&str>| {
            users_folder(data.map(OsString::from), home.map(PathBuf::from))
        };
        let home = Some("/home/ann");
        assert_eq!(folder(Some("/data"), home), Some("/data/planform/plugins".into()));
        let usual = Some("/home/ann/.local/share/planform/plugins".into());
        assert_eq!(folder(None, home), usual);
        assert_eq!((folder(Some("data"), home), folder(Some(""), home)), (usual.clone(), usual));
        assert_eq!((folder(None, None), folder(None, Some("ann"))), (None, None));
    }

    #[test]
    fn libraries_are_known_by_their_ending() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["b", "a", "note.txt"] {
            let name = if name.contains('.') { name.into() } else { format!("{name}.{DLL_EXTENSION}") };
            fs::write(folder.path().join(name), "").unwrap();
        }
        let names: Vec<_> =
            libraries(folder.path()).iter().map(|p| p.file_stem().unwrap().to_owned()).collect();
        assert_eq!(names, ["a", "b"]);
        assert!(libraries(&folder.path().join("none")).is_empty());
        let twice = [folder.path().to_owned(), folder.path().join("."), folder.path().to_owned()];
        assert_eq!(libraries_in(&twice).len(), 2);
    }
}
