//! What tells one content from another: SHA-256 of bytes, of files, and of a document with its siblings.

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use std::fmt;
use std::fs::{File, Metadata};
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// A SHA-256, as 64 hexadecimal digits.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Digest(String);

impl Digest {
    /// That of these bytes.
    pub fn of(bytes: &[u8]) -> Self {
        Self::end(Sha256::new_with_prefix(bytes))
    }

    /// That of a file.
    pub fn of_file(path: &Path) -> io::Result<Self> {
        let mut file = BufReader::with_capacity(1 << 16, File::open(path)?);
        let mut sha = Sha256::new();
        while let bytes @ [_, ..] = file.fill_buf()? {
            sha.update(bytes);
            let length = bytes.len();
            file.consume(length);
        }
        Ok(Self::end(sha))
    }

    /// That of a document and its siblings, in this order. A sibling that is not there is the document's fault, and
    /// no reason to stop here.
    pub fn of_files(paths: &[PathBuf]) -> io::Result<Self> {
        let (first, others) = paths.split_first().ok_or(io::ErrorKind::NotFound)?;
        let of_sibling = |path: &PathBuf| match path.is_file() {
            true => Self::of_file(path).map(|digest| digest.0),
            false => Ok(String::new()),
        };
        let others: io::Result<Vec<_>> = others.iter().map(of_sibling).collect();
        Ok(Self::of([vec![Self::of_file(first)?.0], others?].concat().join(" ").as_bytes()))
    }

    /// One that was written down.
    pub fn known(text: String) -> Self {
        Self(text)
    }

    fn end(sha: Sha256) -> Self {
        Self(sha.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
    }

    /// A number from its first digits.
    pub fn number(&self) -> u64 {
        self.0.get(..16).and_then(|digits| u64::from_str_radix(digits, 16).ok()).unwrap_or(0)
    }

    /// The digits.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// What changes when a file is written: its length, and when that was, nanoseconds since 1970. As long as it is the same,
/// the file need not be read to know that it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Stamp(u64, u128);

impl Stamp {
    /// That of a file.
    pub fn of(path: &Path) -> io::Result<Self> {
        Self::in_metadata(&std::fs::metadata(path)?)
    }

    fn in_metadata(metadata: &Metadata) -> io::Result<Self> {
        let written = metadata.modified()?.duration_since(UNIX_EPOCH).unwrap_or_default();
        Ok(Self(metadata.len(), written.as_nanos()))
    }

    /// Those of a document and its siblings. A sibling that is not there has none.
    pub fn of_files(paths: &[PathBuf]) -> io::Result<Vec<Option<Self>>> {
        let (first, others) = paths.split_first().ok_or(io::ErrorKind::NotFound)?;
        let first = Self::of(first)?;
        Ok(std::iter::once(Some(first)).chain(others.iter().map(|p| Self::of(p).ok())).collect())
    }
}

/// A document with its siblings at a moment.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Seen {
    /// When they were written.
    pub stamps: Vec<Option<Stamp>>,
    /// What they held.
    pub digest: Digest,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_are_those_of_everybody() {
        let abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(Digest::of(b"abc").as_str(), abc);
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a");
        std::fs::write(&file, "abc").unwrap();
        assert_eq!(Digest::of_file(&file).unwrap().as_str(), abc);
        assert_eq!(Stamp::of(&file).unwrap(), Stamp::of(&file).unwrap());
    }

    #[test]
    fn files_keep_their_borders() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            std::fs::write(folder.path().join(name), text).unwrap();
            folder.path().join(name)
        };
        let one = Digest::of_files(&[file("a", "ab"), file("b", "c")]).unwrap();
        let other = Digest::of_files(&[file("c", "a"), file("d", "bc")]).unwrap();
        assert_ne!(one, other);
    }
}
