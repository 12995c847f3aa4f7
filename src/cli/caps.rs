//! How much there may be in a document.

use super::params::exceed;
use crate::reconstruct::Params;
use clap::{Args, value_parser};
use image::ImageReader;
use planform_sdk::{ErrorKind, InputAdapter, MAX_CELLS, PluginError, Scene, Source};
use serde::{Deserialize, Serialize};
use std::io::{BufRead, Cursor, Seek};

/// The flags that say how much there may be in a document. What adapters refuse on their own stays refused.
#[derive(Args)]
#[command(next_help_heading = "Limits")]
pub struct CapArgs {
    /// The most bytes of a document, and of every file that belongs to it
    #[arg(long, value_name = "N", default_value_t = Caps::default().bytes, value_parser = value_parser!(u64).range(1..=1 << 40))]
    max_bytes: u64,
    /// The most pixels of a picture, and cells of what is read of a document
    #[arg(long, value_name = "N", default_value_t = Caps::default().pixels, value_parser = value_parser!(u64).range(1..=MAX_CELLS))]
    max_pixels: u64,
    /// The most texts that are read of a document
    #[arg(long, value_name = "N", default_value_t = Caps::default().texts, value_parser = value_parser!(u64).range(0..=1_000_000))]
    max_texts: u64,
    /// The most lines along which the method `paper` aligns walls, further ones being left out: short for `--param
    /// lines.max_count=N`
    #[arg(long, value_name = "N")]
    max_lines: Option<usize>,
    /// The most faces into which these lines may part a building: short for `--param faces.max_count=N`
    #[arg(long, value_name = "N")]
    max_faces: Option<usize>,
}

/// How much there may be in a document.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Caps {
    /// Bytes of a file.
    pub bytes: u64,
    /// Pixels of a picture.
    pub pixels: u64,
    /// Texts.
    pub texts: u64,
}

impl Default for Caps {
    fn default() -> Self {
        Self { bytes: Source::BYTE_LIMIT, pixels: MAX_CELLS, texts: 100_000 }
    }
}

impl CapArgs {
    /// How much there may be in a document.
    pub fn caps(&self) -> Caps {
        Caps { bytes: self.max_bytes, pixels: self.max_pixels, texts: self.max_texts }
    }

    /// The parameters with the limits of a reconstruction.
    pub fn limit(&self, params: &mut Params) -> Result<(), super::Failure> {
        params.lines.max_count = self.max_lines.unwrap_or(params.lines.max_count);
        params.faces.max_count = self.max_faces.unwrap_or(params.faces.max_count);
        params.check().map_err(|e| exceed(&e))
    }
}

impl Caps {
    /// Fails if the document is a picture, or refers to one, that says to have too many pixels. Nothing is decoded.
    pub fn check_source(&self, source: &Source, adapter: &dyn InputAdapter) -> Result<(), PluginError> {
        self.check_picture(Cursor::new(source.bytes.as_slice()))?;
        for sibling in adapter.siblings(source) {
            let path = source.resolve(&sibling);
            // What is no file may have no end, and is refused when it is read.
            if let Some(reader) = path.is_file().then(|| std::fs::File::open(&path).ok()).flatten() {
                let checked = self.check_picture(std::io::BufReader::new(reader));
                checked.map_err(|e| PluginError { message: format!("{sibling}: {}", e.message), ..e })?;
            }
        }
        Ok(())
    }

    fn check_picture(&self, bytes: impl BufRead + Seek) -> Result<(), PluginError> {
        let sides = ImageReader::new(bytes).with_guessed_format().ok().and_then(|r| r.into_dimensions().ok());
        let Some((width, height)) = sides else { return Ok(()) };
        let pixels = u64::from(width) * u64::from(height);
        let what = format!("the picture has {width} x {height} pixels");
        if pixels > self.pixels { Err(too_much(&what, self.pixels, "--max-pixels")) } else { Ok(()) }
    }

    /// Fails if more was read than there may be.
    pub fn check_scene(&self, scene: &Scene) -> Result<(), PluginError> {
        let cells = scene.grid.cells().len() as u64;
        if cells > self.pixels {
            return Err(too_much(&format!("it has {cells} cells"), self.pixels, "--max-pixels"));
        }
        let texts = scene.texts.len() as u64;
        if texts > self.texts {
            return Err(too_much(&format!("it has {texts} texts"), self.texts, "--max-texts"));
        }
        Ok(())
    }
}

fn too_much(what: &str, most: u64, flag: &str) -> PluginError {
    PluginError::new(ErrorKind::Limit, format!("{what}; the most are {most}"))
        .advise(format!("`{flag}` allows more"))
}
