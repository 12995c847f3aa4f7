//! How much memory a document seems to need. A wrong guess costs a second attempt, and nothing else.

use crate::cli::memory::MIB;
use image::ImageReader;
use std::fs;
use std::path::{Path, PathBuf};

/// What every process takes, with the engines that read words, MiB.
const PROCESS: u64 = 256;
/// For each pixel of a picture, bytes.
const PER_PIXEL: u64 = 60;
/// For each byte of any other file.
const PER_BYTE: u64 = 20;

/// The memory that a document with these files seems to need, MiB.
pub fn need(files: &[PathBuf]) -> u64 {
    let bytes: u64 = files.iter().map(|f| of_file(f)).fold(0, u64::saturating_add);
    PROCESS + bytes / MIB
}

fn of_file(path: &Path) -> u64 {
    let length = || fs::metadata(path).map(|m| m.len()).unwrap_or(0);
    pixels(path).map_or_else(|| length().saturating_mul(PER_BYTE), |pixels| pixels.saturating_mul(PER_PIXEL))
}

/// The pixels that a picture says it has. Only its head is read.
fn pixels(path: &Path) -> Option<u64> {
    // Opening what is no file may wait for ever.
    fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    let reader = ImageReader::open(path).ok()?.with_guessed_format().ok()?;
    let (width, height) = reader.into_dimensions().ok()?;
    Some(u64::from(width) * u64::from(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_need_memory_for_their_pixels() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, bytes: &[u8]| {
            fs::write(folder.path().join(name), bytes).unwrap();
            folder.path().join(name)
        };
        let head = file("a.pgm", b"P5\n10000 10000\n255\n");
        let text = file("a.yaml", &[b'x'; 100]);
        assert_eq!(need(&[text.clone(), head]), PROCESS + 10_000 * 10_000 * PER_PIXEL / MIB);
        assert_eq!(need(&[text]), PROCESS);
        assert_eq!(need(&[folder.path().join("gone")]), PROCESS);
    }
}
