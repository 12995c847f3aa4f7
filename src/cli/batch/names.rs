//! Paths as texts that can be kept, compared and read again by people.

use std::ffi::OsStr;
use std::path::{Component, Path};

/// The path as a text, its parts with `/` between them. What is no UTF-8 becomes `\xE9` and the like, so that two paths
/// hardly ever have one text.
pub fn text_of(path: &Path) -> String {
    let parts: Vec<_> = path.components().map(|c| part(c.as_os_str())).collect();
    parts.join("/").replacen("//", "/", 1)
}

fn part(name: &OsStr) -> String {
    let mut text = String::new();
    for chunk in name.as_encoded_bytes().utf8_chunks() {
        text += chunk.valid();
        chunk.invalid().iter().for_each(|byte| text += &format!("\\x{byte:02X}"));
    }
    text
}

/// Whether a path leads to something below the folder that it is appended to, whatever it is.
pub fn stays_below(path: &Path) -> bool {
    let plain = |c: Component<'_>| matches!(c, Component::Normal(_) | Component::CurDir);
    path.file_name().is_some() && path.components().all(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_texts() {
        assert_eq!(text_of(Path::new("a/b c.png")), "a/b c.png");
        assert_eq!(text_of(Path::new("/a/b")), "/a/b");
        #[cfg(unix)]
        {
            use std::os::unix::ffi::OsStrExt;
            assert_eq!(text_of(Path::new(OsStr::from_bytes(b"caf\xe9/\xff.png"))), "caf\\xE9/\\xFF.png");
        }
    }

    #[test]
    fn what_leads_out_is_known() {
        assert!(stays_below(Path::new("a/b.svg")) && stays_below(Path::new("./a")));
        for out in ["../a", "a/../../b", "/a", "..", "", "."] {
            assert!(!stays_below(Path::new(out)), "{out}");
        }
    }
}
