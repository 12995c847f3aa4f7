//! From the bytes of an SVG file to its text.

use crate::inputs::kind::GZIP;
use flate2::read::MultiGzDecoder;
use planform_sdk::{ErrorKind, PluginError};
use std::io::Read;

/// The most bytes of an SVG document, unpacked.
const MAX_BYTES: u64 = 256 << 20;

/// The text, unpacked if it is compressed with gzip.
pub fn text(bytes: &[u8]) -> Result<String, PluginError> {
    let bytes = if bytes.starts_with(&GZIP) { gunzip(bytes)? } else { bytes.to_vec() };
    if bytes.len() as u64 > MAX_BYTES {
        let message = format!("the SVG is larger than {} MiB", MAX_BYTES >> 20);
        return Err(
            PluginError::new(ErrorKind::Limit, message).advise("simplify it, or save it as a picture")
        );
    }
    let text = match bytes.as_slice() {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        _ => String::from_utf8(bytes).ok(),
    };
    text.ok_or_else(|| {
        PluginError::new(ErrorKind::BadInput, "the SVG is not text in UTF-8")
            .advise("save it in that encoding")
    })
}

fn gunzip(bytes: &[u8]) -> Result<Vec<u8>, PluginError> {
    let mut unpacked = vec![];
    MultiGzDecoder::new(bytes).take(MAX_BYTES + 1).read_to_end(&mut unpacked).map_err(|e| {
        PluginError::new(ErrorKind::BadInput, format!("the compressed SVG cannot be unpacked: {e}"))
            .advise("the file may be cut short: save or copy it again")
    })?;
    Ok(unpacked)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let units: Vec<_> = bytes.as_chunks().0.iter().map(|&pair| unit(pair)).collect();
    String::from_utf16(&units).ok()
}
