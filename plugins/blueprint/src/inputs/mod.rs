//! Reads one page of a document, whatever its format: pictures, PDF, SVG and DXF.

mod density;
mod dxf;
mod glance;
mod guard;
mod kind;
mod limit;
mod paper;
mod pdf;
mod picture;
mod png;
mod svg;
mod tiff;

pub use glance::glance;
pub use kind::{Kind, kind};

use crate::page::Page;
use planform_sdk::{ErrorKind, PluginError, Source};

/// What of a document is wanted, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct PageRequest {
    /// Which page, from 1. Documents of formats without pages have one.
    pub page: u32,
    /// Pixels per inch of paper at which pages of lines are drawn, from 10 to 2400. Pages that would become larger than
    /// what is read are drawn with fewer, and warn. Of no concern for pictures and drawings to scale.
    pub dpi: f64,
    /// The layers of a CAD drawing that hold its walls; `None` to guess. Compared without regard to case.
    pub layers: Option<Vec<String>>,
}

impl Default for PageRequest {
    fn default() -> Self {
        Self { page: 1, dpi: 200.0, layers: None }
    }
}

/// Pixels per inch that a page may be drawn with.
const DPI: std::ops::RangeInclusive<f64> = 10.0..=2400.0;

/// Reads one page of the document.
///
/// A page that is not there or a `dpi` out of range is [`ErrorKind::BadOption`], a damaged document
/// [`ErrorKind::BadInput`], a page too large [`ErrorKind::Limit`], and a format or a feature of it that is not read
/// [`ErrorKind::Unsupported`].
pub fn page(source: &Source, request: &PageRequest) -> Result<Page, PluginError> {
    check(request)?;
    match kind(&source.path, &source.bytes) {
        Some(Kind::Picture(format)) => picture::page(&source.bytes, format, request.page),
        Some(Kind::Pdf) => pdf::page(&source.bytes, request),
        Some(Kind::Svg) => svg::page(&source.bytes, request),
        Some(Kind::Dxf) => dxf::page(&source.bytes, request),
        None => Err(refuse(&source.bytes)),
    }
}

fn check(request: &PageRequest) -> Result<(), PluginError> {
    let bad = |message| Err(PluginError::new(ErrorKind::BadOption, message));
    if request.page == 0 {
        return bad("pages are counted from 1, so there is no page 0".to_owned());
    }
    if !DPI.contains(&request.dpi) {
        return bad(format!("a page is drawn with 10 to 2400 pixels per inch, not {}", request.dpi));
    }
    Ok(())
}

/// The page that was asked for is not one of the document's.
fn no_such_page(page: u32, pages: usize) -> PluginError {
    let (holds, advice) = match pages {
        1 => ("one page".to_owned(), "give page=1, or leave it away".to_owned()),
        n => (format!("{n} pages"), format!("give page=1 to page={n}")),
    };
    let message = format!("there is no page {page}: the document has {holds}");
    PluginError::new(ErrorKind::BadOption, message).advise(advice)
}

/// Why a document of no known kind is not read.
fn refuse(bytes: &[u8]) -> PluginError {
    const READ: &str = "give it as PDF, SVG, DXF, PNG, JPEG, TIFF, BMP or PNM";
    if bytes.is_empty() {
        return PluginError::new(ErrorKind::BadInput, "the file is empty").advise(READ);
    }
    // Every version of DWG begins with its number, AC1032 being that of 2018.
    if bytes.starts_with(b"AC10") {
        let message = "it is a DWG drawing, which is not read";
        return PluginError::new(ErrorKind::Unsupported, message).advise("save it as DXF in a CAD program");
    }
    let message = match image::guess_format(bytes) {
        Ok(format) if !kind::is_read(format) => {
            format!("it is a picture in the format {format:?}, which is not read")
        }
        _ => "it is neither a drawing nor a picture of a kind that is read".to_owned(),
    };
    PluginError::new(ErrorKind::Unsupported, message).advise(READ)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    fn source(name: &str, bytes: &[u8]) -> Source {
        Source { path: PathBuf::from(name), bytes: bytes.to_vec(), byte_limit: 1 << 20 }
    }

    fn complaint(name: &str, bytes: &[u8], request: &PageRequest) -> String {
        page(&source(name, bytes), request).unwrap_err().to_string()
    }

    #[test]
    fn what_is_not_read_gets_its_sentence() {
        let wanted = PageRequest::default();
        for (name, bytes, words) in [
            ("x.bin", &b""[..], "the file is empty; give it as PDF"),
            ("x.dwg", b"AC1032\0\0", "it is a DWG drawing, which is not read; save it as DXF"),
            ("x.gif", b"GIF89a\x01\0\x01\0", "it is a picture in the format Gif, which is not read"),
            ("x.txt", b"hello", "it is neither a drawing nor a picture"),
        ] {
            let message = complaint(name, bytes, &wanted);
            assert!(message.starts_with(words), "{message}");
        }
    }

    #[test]
    fn requests_are_checked() {
        let zero = PageRequest { page: 0, ..PageRequest::default() };
        assert!(complaint("x", b"", &zero).contains("no page 0"));
        for dpi in [0.0, -1.0, f64::NAN, 1e6] {
            let wanted = PageRequest { dpi, ..PageRequest::default() };
            assert!(complaint("x", b"", &wanted).contains("10 to 2400 pixels per inch"));
        }
    }
}
