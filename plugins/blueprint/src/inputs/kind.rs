//! Tells documents apart, by their first bytes, and by their names where these say nothing.

use flate2::read::GzDecoder;
use image::ImageFormat;
use std::io::Read;
use std::path::Path;

/// What a document is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A picture in this format.
    Picture(ImageFormat),
    /// A PDF document.
    Pdf,
    /// An SVG drawing, maybe compressed with gzip.
    Svg,
    /// A DXF drawing, as text or binary.
    Dxf,
}

/// Pictures that are read, and the extensions of their names.
const PICTURES: [(ImageFormat, &[&str]); 5] = [
    (ImageFormat::Png, &["png"]),
    (ImageFormat::Jpeg, &["jpg", "jpeg"]),
    (ImageFormat::Tiff, &["tif", "tiff"]),
    (ImageFormat::Bmp, &["bmp"]),
    (ImageFormat::Pnm, &["pnm", "pgm", "pbm", "ppm", "pam"]),
];

/// How far into a document its kind is looked for.
const HEAD: usize = 4096;

/// What begins a binary DXF.
pub const BINARY_DXF: &[u8] = b"AutoCAD Binary DXF";

/// What begins a file compressed with gzip.
pub const GZIP: [u8; 2] = [0x1f, 0x8b];

/// What the document of this name and these first bytes is; `None` if it is nothing that is read here. Any bytes are
/// accepted; more than the first 4096 change nothing.
pub fn kind(path: &Path, head: &[u8]) -> Option<Kind> {
    let head = &head[..head.len().min(HEAD)];
    of_content(head).or_else(|| if is_foreign(head) { None } else { of_name(path) })
}

/// Whether pictures of this format are read.
pub fn is_read(format: ImageFormat) -> bool {
    PICTURES.iter().any(|(f, _)| *f == format)
}

fn of_content(head: &[u8]) -> Option<Kind> {
    if let Some(format) = picture(head) {
        return Some(Kind::Picture(format));
    }
    if is_pdf(head) {
        return Some(Kind::Pdf);
    }
    if is_svg(head) || is_svg(&unpacked(head)) {
        return Some(Kind::Svg);
    }
    is_dxf(head).then_some(Kind::Dxf)
}

fn of_name(path: &Path) -> Option<Kind> {
    let extension = path.extension()?.to_string_lossy().to_lowercase();
    match extension.as_str() {
        "pdf" => Some(Kind::Pdf),
        "svg" | "svgz" => Some(Kind::Svg),
        "dxf" => Some(Kind::Dxf),
        other => PICTURES.iter().find(|(_, names)| names.contains(&other)).map(|(f, _)| Kind::Picture(*f)),
    }
}

/// Whether the content is surely something that is not read, whatever its name says.
fn is_foreign(head: &[u8]) -> bool {
    head.is_empty() || head.starts_with(b"AC10") || image::guess_format(head).is_ok_and(|f| !is_read(f))
}

fn picture(head: &[u8]) -> Option<ImageFormat> {
    let format = image::guess_format(head).ok()?;
    let plausible = match format {
        // Two letters and a digit, or two letters, also begin many a text.
        ImageFormat::Pnm => head.get(2).is_some_and(|&b| b.is_ascii_whitespace() || b == b'#'),
        ImageFormat::Bmp => head.get(15..18) == Some(&[0; 3]),
        _ => true,
    };
    (plausible && is_read(format)).then_some(format)
}

/// PDF readers accept other bytes before the first line, within the first 1024.
fn is_pdf(head: &[u8]) -> bool {
    head[..head.len().min(1024)].windows(5).any(|w| w == b"%PDF-")
}

/// Whether the first element is `svg`, with or without a prefix: prolog, comments and document type are skipped.
fn is_svg(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head));
    let mut rest = text.trim_start();
    while let Some(end) = ["<?", "<!--", "<!"]
        .iter()
        .zip(["?>", "-->", ">"])
        .find_map(|(begin, end)| rest.starts_with(begin).then(|| end_of_markup(rest, end)).flatten())
    {
        rest = rest[end..].trim_start();
    }
    let name: String = rest
        .strip_prefix('<')
        .unwrap_or_default()
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == ':')
        .collect();
    name.rsplit(':').next() == Some("svg")
}

/// Where the markup at the start of `text` ends. A document type may hold declarations in brackets.
fn end_of_markup(text: &str, end: &str) -> Option<usize> {
    let first = text.find(end)?;
    let at = match text.find('[') {
        Some(bracket) if end == ">" && bracket < first => text.find("]>").map(|at| at + 1)?,
        _ => first,
    };
    Some(at + end.len())
}

/// What a gzip stream begins with; nothing if it is none.
fn unpacked(head: &[u8]) -> Vec<u8> {
    let mut bytes = vec![];
    if head.starts_with(&GZIP) {
        // The head ends in the middle of the stream, which is an error after the bytes that are wanted.
        let _ = GzDecoder::new(head).take(HEAD as u64).read_to_end(&mut bytes);
    }
    bytes
}

/// Pairs of lines, a number and a value: comments (999), then a section (0).
fn is_dxf(head: &[u8]) -> bool {
    if head.starts_with(BINARY_DXF) {
        return true;
    }
    let text = String::from_utf8_lossy(head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head));
    let mut lines = text.lines().map(str::trim);
    loop {
        match (lines.next(), lines.next()) {
            (Some("999"), Some(_)) => {}
            (Some("0"), Some("SECTION")) => return true,
            _ => return false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;

    fn of(name: &str, head: &[u8]) -> Option<Kind> {
        kind(Path::new(name), head)
    }

    #[test]
    fn content_goes_before_the_name() {
        assert_eq!(of("x.pdf", b"\x89PNG\r\n\x1a\n"), Some(Kind::Picture(ImageFormat::Png)));
        assert_eq!(of("x.png", b"%PDF-1.7\n"), Some(Kind::Pdf));
        assert_eq!(of("", b"mail headers\n%PDF-1.4"), Some(Kind::Pdf));
        assert_eq!(of("x.png", b"GIF89a\x01\0\x01\0"), None);
        assert_eq!(of("x.dxf", b"AC1032\0\0\0"), None);
    }

    #[test]
    fn drawings_are_known_by_their_first_element() {
        for text in [
            "<svg xmlns='x'>",
            "\u{feff}<?xml version='1.0'?>\n<!-- a > b -->\n<!DOCTYPE svg [<!ENTITY a 'b'>]>\n<svg:svg>",
            "<!DOCTYPE svg PUBLIC \"a\" \"b\"><svg/>",
        ] {
            assert_eq!(of("", text.as_bytes()), Some(Kind::Svg), "{text}");
        }
        for text in ["<html><svg/></html>", "<!-- <svg> ", "<", "svg", "<?xml ?>"] {
            assert_eq!(of("", text.as_bytes()), None, "{text}");
        }
        let mut packed = GzEncoder::new(vec![], Compression::default());
        packed.write_all(b"<svg>").unwrap();
        assert_eq!(of("", &packed.finish().unwrap()), Some(Kind::Svg));
    }

    #[test]
    fn dxf_is_known_by_its_first_pairs() {
        for text in ["0\nSECTION\n", "999\r\nmade by\r\n  0\r\nSECTION\r\n", "AutoCAD Binary DXF\r\n\x1a\0"] {
            assert_eq!(of("", text.as_bytes()), Some(Kind::Dxf), "{text}");
        }
        for text in ["0", "0\nHEADER", "999\n", "1\nSECTION"] {
            assert_eq!(of("", text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn names_help_where_the_content_is_damaged() {
        assert_eq!(of("a.PDF", b"junk"), Some(Kind::Pdf));
        assert_eq!(of("a.svgz", b"\x1f\x8bjunk"), Some(Kind::Svg));
        assert_eq!(of("a.dxf", b"junk"), Some(Kind::Dxf));
        assert_eq!(of("a.jpeg", b"junk"), Some(Kind::Picture(ImageFormat::Jpeg)));
        assert_eq!((of("a.txt", b"junk"), of("pdf", b"junk"), of("a.pdf", b"")), (None, None, None));
    }
}
