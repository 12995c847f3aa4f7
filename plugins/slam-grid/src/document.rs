//! Tells the adapter's documents apart.

use image::ImageFormat;
use planform_sdk::{ErrorKind, PluginError, Source};

/// The picture formats that are read, with their names for people and their usual extensions.
const FORMATS: [(ImageFormat, &str, &[&str]); 5] = [
    (ImageFormat::Png, "PNG", &["png"]),
    (ImageFormat::Pnm, "PNM (PGM, PBM, PPM or PAM)", &["pgm", "pnm", "pbm", "ppm", "pam"]),
    (ImageFormat::Bmp, "BMP", &["bmp"]),
    (ImageFormat::Tiff, "TIFF", &["tif", "tiff"]),
    (ImageFormat::Jpeg, "JPEG", &["jpg", "jpeg"]),
];

/// What a document is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The YAML file of a map server.
    Yaml,
    /// A picture.
    Picture(ImageFormat),
}

/// Judges a whole document by its first bytes, and by its name where they say nothing.
pub fn kind(source: &Source) -> Result<Kind, PluginError> {
    let bad = |message: &str| PluginError::new(ErrorKind::BadInput, message);
    let extension = source.path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    if source.bytes.is_empty() {
        return Err(bad("the file is empty").advise("give a map's YAML file or picture"));
    }
    if let Some(format) = picture_format(&source.bytes) {
        return Ok(Kind::Picture(format));
    }
    if is_text(&source.bytes) && format_of_extension(&extension).is_none() {
        return Ok(Kind::Yaml);
    }
    refuse_other_picture(&source.bytes)?;
    Err(bad("the first bytes are not those of a PNG, PGM, BMP, TIFF or JPEG picture, nor is it a YAML file")
        .advise("the file may be damaged or wrongly named"))
}

/// Says of a picture in a format that is not read what it is.
pub fn refuse_other_picture(bytes: &[u8]) -> Result<(), PluginError> {
    match image::guess_format(bytes) {
        Ok(format) if format_name(format).is_none() => Err(PluginError::new(
            ErrorKind::Unsupported,
            format!("it is a picture in the format {format:?}, which is not read"),
        )
        .advise("save it as PNG")),
        _ => Ok(()),
    }
}

/// The picture format that begins with these bytes, if it is one that is read.
pub fn picture_format(head: &[u8]) -> Option<ImageFormat> {
    let format = image::guess_format(head).ok()?;
    let plausible = match format {
        // Two letters and a digit, or two letters, also begin many a text.
        ImageFormat::Pnm => head.get(2).is_some_and(|&b| b.is_ascii_whitespace() || b == b'#'),
        ImageFormat::Bmp => head.get(15..18) == Some(&[0; 3]),
        _ => true,
    };
    (plausible && format_name(format).is_some()).then_some(format)
}

/// The name for people of a format that is read.
pub fn format_name(format: ImageFormat) -> Option<&'static str> {
    FORMATS.iter().find(|(f, ..)| *f == format).map(|(_, name, _)| *name)
}

fn format_of_extension(extension: &str) -> Option<ImageFormat> {
    FORMATS.iter().find(|(.., extensions)| extensions.contains(&extension)).map(|(f, ..)| *f)
}

/// Whether bytes may be text: no control characters but white space. Letters beyond ASCII may be in any encoding,
/// for old files have comments in Latin-1.
pub fn is_text(bytes: &[u8]) -> bool {
    bytes.iter().all(|&b| b >= 0x20 && b != 0x7f || matches!(b, b'\t' | b'\n' | b'\r' | 0x0c))
}
