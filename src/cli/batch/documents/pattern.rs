//! The files that a pattern such as `plans/**/*.pdf` matches, for shells that do not know `**` and for quoted ones.

use super::{Listed, Trouble, folder};
use crate::cli::Failure;
use globset::{GlobBuilder, GlobMatcher};
use std::path::{Component, Path, PathBuf};

/// Whether the path has a part that stands for several names.
pub fn is_pattern(path: &Path) -> bool {
    path.as_os_str().as_encoded_bytes().iter().any(|b| b"*?[{".contains(b))
}

/// The files that it matches. Their places are their paths below the part of the pattern that is no pattern.
pub fn read(pattern: &Path, several: bool, output: &Path) -> Result<Vec<Listed>, Failure> {
    let base: PathBuf = pattern.components().take_while(|c| !is_pattern(Path::new(c))).collect();
    let rest: PathBuf = pattern.components().skip(base.components().count()).collect();
    let matcher = matcher(&rest).ok_or_else(|| {
        Failure::Usage(format!("{}: is no file, and no pattern that makes sense", pattern.display()))
    })?;
    let prefix = if several { last_name(&base) } else { PathBuf::new() };
    let folder = if base == Path::new("") { Path::new(".") } else { &base };
    if !folder.is_dir() {
        return Ok(vec![]);
    }
    let below = |path: &Path| path.strip_prefix(folder).unwrap_or(path).to_path_buf();
    let mut found = folder::walk(folder, output, &|path| prefix.join(below(path)));
    found.retain(|l| matcher.is_match(below(&l.input)) || matches!(l.trouble, Some(Trouble::Broken(_))));
    if base == Path::new("") {
        found.iter_mut().for_each(|l| l.input = below(&l.input));
    }
    Ok(found)
}

fn last_name(base: &Path) -> PathBuf {
    let mut names = base.components().filter(|c| matches!(c, Component::Normal(_)));
    names.next_back().map(|c| PathBuf::from(c.as_os_str())).unwrap_or_default()
}

fn matcher(pattern: &Path) -> Option<GlobMatcher> {
    let glob = GlobBuilder::new(pattern.to_str()?).literal_separator(true).build();
    glob.ok().map(|g| g.compile_matcher())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn patterns_match_as_in_shells() {
        let root = tempfile::tempdir().unwrap();
        for file in ["p/a.pdf", "p/b.png", "p/q/c.pdf", "d.pdf"] {
            fs::create_dir_all(root.path().join(file).parent().unwrap()).unwrap();
            fs::write(root.path().join(file), "").unwrap();
        }
        let out = root.path().join("out");
        let names = |pattern: &str, several| -> Vec<String> {
            let found = read(&root.path().join(pattern), several, &out);
            found.map(|found| found.iter().map(Listed::name).collect()).unwrap_or_default()
        };
        assert_eq!(names("p/*.pdf", false), ["a.pdf"]);
        assert_eq!(names("p/**/*.pdf", false), ["a.pdf", "q/c.pdf"]);
        assert_eq!(names("p/*.{pdf,png}", true), ["p/a.pdf", "p/b.png"]);
        assert_eq!(names("**/?.pdf", false), ["d.pdf", "p/a.pdf", "p/q/c.pdf"]);
        assert!(names("*.docx", false).is_empty() && names("p/[", false).is_empty());
    }
}
