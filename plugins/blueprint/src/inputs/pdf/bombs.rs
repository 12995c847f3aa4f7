//! Streams that would unpack to more memory than any plan takes.

use flate2::read::ZlibDecoder;
use planform_sdk::{ErrorKind, PluginError};
use std::io::{Read, copy, sink};

/// The most bytes of one stream, unpacked: the largest picture in colours, and some more.
const MAX_STREAM: u64 = 4 * crate::inputs::limit::MAX_PIXELS;
/// Deflate makes data at most so many times smaller, so shorter streams need no look.
const MAX_RATIO: u64 = 1032;
/// How far before a stream its dictionary is looked at.
const DICTIONARY: usize = 512;
const PACKED: &[u8] = b"FlateDecode";

/// Refuses documents with a stream that unpacks to too much, or that is packed twice, which nothing but a bomb is.
/// Dictionaries of streams always stand in the file as they are, so a search finds them all.
pub fn check(bytes: &[u8]) -> Result<(), PluginError> {
    let mut from = 0;
    while let Some(at) = find(&bytes[from..], b"stream").map(|i| from + i) {
        from = at + b"stream".len();
        let dictionary = &bytes[at.saturating_sub(DICTIONARY)..at];
        // The end of a stream has the same letters.
        if dictionary.ends_with(b"end") {
            continue;
        }
        let data = &bytes[from..];
        if packings(dictionary) > 1 || unpacked(data) > MAX_STREAM {
            return Err(refuse());
        }
    }
    Ok(())
}

/// How many times the stream after this is packed.
fn packings(before: &[u8]) -> usize {
    let start = before.windows(3).rposition(|w| w == b"obj").unwrap_or(0);
    before[start..].windows(PACKED.len()).filter(|w| *w == PACKED).count()
}

/// How many bytes come of this if it is packed, counted up to just beyond the limit.
fn unpacked(data: &[u8]) -> u64 {
    let data = data.strip_prefix(b"\r\n").or_else(|| data.strip_prefix(b"\n")).unwrap_or(data);
    let shortest = (MAX_STREAM / MAX_RATIO) as usize;
    // The compressed data begin with 8 in the low half of the first byte.
    if data.len() < shortest || data[0] & 0x0f != 8 {
        return 0;
    }
    let mut decoder = ZlibDecoder::new(data);
    // What cannot be unpacked to the end counts until there.
    let _ = copy(&mut (&mut decoder).take(MAX_STREAM + 1), &mut sink());
    decoder.total_out()
}

fn find(bytes: &[u8], what: &[u8]) -> Option<usize> {
    bytes.windows(what.len()).position(|w| w == what)
}

fn refuse() -> PluginError {
    let message = format!("the PDF has a stream that unpacks to more than {} MB", MAX_STREAM / 1_000_000);
    PluginError::new(ErrorKind::Limit, message).advise("save it with smaller pictures")
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::ZlibEncoder};
    use std::io::Write;

    fn document(filter: &str, megabytes: u64) -> Vec<u8> {
        let mut packed = ZlibEncoder::new(vec![], Compression::best());
        for _ in 0..megabytes {
            packed.write_all(&[b' '; 1_000_000]).unwrap();
        }
        let mut bytes = format!("%PDF-1.4\n1 0 obj\n<< /Filter {filter} >>\nstream\r\n").into_bytes();
        bytes.extend(packed.finish().unwrap());
        bytes.extend(b"\nendstream\nendobj\n");
        bytes
    }

    #[test]
    fn streams_are_measured_before_they_are_unpacked() {
        assert!(check(&document("/FlateDecode", 390)).is_ok());
        let message = check(&document("/FlateDecode", 401)).unwrap_err().to_string();
        assert!(message.starts_with("the PDF has a stream that unpacks to more than 400 MB"), "{message}");
        assert!(check(&document("[/FlateDecode /FlateDecode]", 1)).is_err());
        assert!(check(b"stream").is_ok() && check(b"endstream").is_ok() && check(b"").is_ok());
    }
}
