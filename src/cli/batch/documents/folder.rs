//! The files of a folder and all folders in it.

use super::{Listed, Trouble, real};
use crate::cli::Failure;
use planform_sdk::PluginError;
use std::path::{Path, PathBuf};
use walkdir::{DirEntry, WalkDir};

/// All files of the folder, the hidden ones left out. Where there are several inputs, their places begin with the
/// folder's name.
pub fn read(folder: &Path, several: bool, output: &Path) -> Result<Vec<Listed>, Failure> {
    if real(folder).starts_with(real(output)) {
        let message = "the outputs would lie among the documents; give another folder with `--output`";
        return Err(Failure::Usage(format!("{}: {message}", folder.display())));
    }
    let prefix = if several { own_name(folder) } else { PathBuf::new() };
    Ok(walk(folder, output, &|path| prefix.join(path.strip_prefix(folder).unwrap_or(path))))
}

/// The folder's own name, also of `.` and `..`.
fn own_name(folder: &Path) -> PathBuf {
    real(folder).file_name().map(PathBuf::from).unwrap_or_default()
}

/// All files below the folder, and what cannot be looked into. Links are followed, but never round in a circle.
pub fn walk(folder: &Path, output: &Path, place: &dyn Fn(&Path) -> PathBuf) -> Vec<Listed> {
    let output = real(output);
    let enters = |entry: &DirEntry| {
        let is_output = || entry.file_type().is_dir() && real(entry.path()) == output;
        entry.depth() == 0 || !(is_hidden(entry) || is_output())
    };
    let entries = WalkDir::new(folder).follow_links(true).sort_by_file_name().into_iter();
    let listed = |entry: Result<DirEntry, walkdir::Error>| match entry {
        Ok(entry) if entry.file_type().is_dir() => None,
        Ok(entry) => Some(Listed::new(place(entry.path()), entry.path().into(), false)),
        Err(e) => Some(unreadable(&e, folder, place)),
    };
    entries.filter_entry(enters).filter_map(listed).collect()
}

fn is_hidden(entry: &DirEntry) -> bool {
    entry.file_name().as_encoded_bytes().starts_with(b".")
}

fn unreadable(e: &walkdir::Error, folder: &Path, place: &dyn Fn(&Path) -> PathBuf) -> Listed {
    let path = e.path().unwrap_or(folder);
    let trouble = match (e.loop_ancestor(), e.io_error()) {
        (Some(above), _) => {
            Trouble::LeftOut(format!("is a link back to {}, which it is in", above.display()))
        }
        (None, Some(io)) => {
            let reason = PluginError::from(std::io::Error::from(io.kind()));
            Trouble::Broken(format!("cannot be looked into: {reason}"))
        }
        (None, None) => Trouble::Broken("cannot be looked into".into()),
    };
    Listed { trouble: Some(trouble), ..Listed::new(place(path), path.into(), false) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn names(folder: &Path, several: bool, output: &Path) -> Vec<String> {
        read(folder, several, output).unwrap().iter().map(Listed::name).collect()
    }

    #[test]
    fn folders_are_mirrored_in_order_without_hidden_files_and_outputs() {
        let root = tempfile::tempdir().unwrap();
        let plans = root.path().join("plans");
        for file in ["b/2.png", "b/1.png", "a.pdf", ".hidden", ".git/c.png", "out/a.pdf.svg"] {
            fs::create_dir_all(plans.join(file).parent().unwrap()).unwrap();
            fs::write(plans.join(file), "").unwrap();
        }
        let out = plans.join("out");
        assert_eq!(names(&plans, false, &out), ["a.pdf", "b/1.png", "b/2.png"]);
        assert_eq!(names(&plans, true, &out), ["plans/a.pdf", "plans/b/1.png", "plans/b/2.png"]);
        assert!(read(&plans, false, &plans).is_err(), "outputs among the documents");
        assert!(read(&plans, false, root.path()).is_err(), "outputs above the documents");
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_but_not_in_circles() {
        let root = tempfile::tempdir().unwrap();
        let plans = root.path().join("plans");
        fs::create_dir_all(plans.join("sub")).unwrap();
        fs::write(root.path().join("elsewhere.png"), "").unwrap();
        std::os::unix::fs::symlink("../elsewhere.png", plans.join("link.png")).unwrap();
        std::os::unix::fs::symlink("..", plans.join("sub/up")).unwrap();
        std::os::unix::fs::symlink("gone", plans.join("dangling.png")).unwrap();
        let listed = read(&plans, false, &root.path().join("out")).unwrap();
        let told: Vec<_> = listed.iter().map(|l| (l.name(), l.trouble.clone())).collect();
        assert_eq!(told.len(), 3, "{told:?}");
        assert!(matches!(&told[0].1, Some(Trouble::Broken(s)) if s.contains("no such file")), "{told:?}");
        assert_eq!(told[1], ("link.png".into(), None));
        assert!(matches!(&told[2].1, Some(Trouble::LeftOut(s)) if s.starts_with("is a link back to ")));
    }
}
