//! What the tests share.

use image::{DynamicImage, GrayImage, ImageFormat, Luma};
use planform_sdk::{Options, PluginError, Scene, Source};
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// A YAML file as `map_saver` writes it.
pub const YAML: &str = "image: map.pgm\nresolution: 0.05\norigin: [-1.5, 2.0, 0.5]\nnegate: 0\n\
    occupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// The cells of a scene row by row from the bottom, -1 for unknown.
pub fn cells(scene: &Scene) -> Vec<i16> {
    scene.grid.cells().iter().map(|c| c.occupancy().map_or(-1, i16::from)).collect()
}

/// A grey picture; `greys` row by row from the top.
pub fn picture(width: u32, greys: &[u8]) -> DynamicImage {
    GrayImage::from_fn(width, greys.len() as u32 / width, |x, y| Luma([greys[(y * width + x) as usize]]))
        .into()
}

pub fn encode(picture: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut out = Cursor::new(vec![]);
    picture.write_to(&mut out, format).unwrap();
    out.into_inner()
}

pub fn read_bytes(name: &str, bytes: &[u8], set: &[(&str, &str)]) -> Result<Scene, PluginError> {
    let source = Source { path: PathBuf::from(name), bytes: bytes.to_vec(), byte_limit: Source::BYTE_LIMIT };
    read(&source, set)
}

pub fn read(source: &Source, set: &[(&str, &str)]) -> Result<Scene, PluginError> {
    let adapter = planform_slam_grid::adapter();
    let options = Options::parse(&adapter.info().options, set.iter().copied())?;
    adapter.read(source, &options)
}

/// A folder with files of these names.
pub fn folder(files: &[(&str, &[u8])]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

pub fn read_in(folder: &Path, name: &str, set: &[(&str, &str)]) -> Result<Scene, PluginError> {
    read(&Source::open(folder.join(name), Source::BYTE_LIMIT)?, set)
}

/// Reads this YAML file next to a `map.pgm` of the greys 254, 205 above 0, 100.
pub fn read_yaml(yaml: &str) -> Result<Scene, PluginError> {
    let pgm = encode(&picture(2, &[254, 205, 0, 100]), ImageFormat::Pnm);
    let folder = folder(&[("map.yaml", yaml.as_bytes()), ("map.pgm", &pgm)]);
    read_in(folder.path(), "map.yaml", &[])
}
