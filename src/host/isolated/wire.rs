//! What the program and the process that runs a plugin say to each other.
//!
//! A message is a JSON header and one block of bytes: `u64` length of the header, `u64` length of the block, both
//! little-endian, the header, the block. The block holds what is large: a document, a grid's cells, an output.

use planform_sdk::abi::host::Log;
use planform_sdk::{
    Annotations, Cell, Confidence, Grid, Layout, OptionValue, PluginError, PluginInfo, Pose, Scene,
};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::{self, Read, Write};

/// What the plugin's process is asked. The plugins of a library are numbered from 0, adapters and exporters each.
#[derive(Serialize, Deserialize)]
pub enum Request {
    /// Which plugins are in the library?
    Describe,
    /// Whose document is it? The block is its first bytes.
    Probe { adapter: usize, path: PathName },
    /// Read the document in the block. The stages come with their pictures only if they are wanted.
    Read { adapter: usize, path: PathName, byte_limit: u64, options: Values, pictures: bool },
    /// Write the layout and its companions. The block is the grid's cells.
    Write {
        exporter: usize,
        stem: String,
        extension: String,
        layout: Box<Layout>,
        scene: Option<Box<SceneHeader>>,
        options: Values,
    },
    /// Do this check of the conformance suite. The block is the sample document, if there is a path.
    Check { number: usize, path: Option<PathName> },
}

/// What it answers.
#[derive(Serialize, Deserialize)]
pub enum Answer {
    /// Said once and unasked, before the library is loaded: how much address space the process takes so far, bytes.
    Ready(u64),
    /// The library's adapters and exporters, with the exporters' companions.
    Described { adapters: Vec<PluginInfo>, exporters: Vec<PluginInfo>, companions: Vec<Vec<String>> },
    /// The library cannot be used, for this reason.
    Unusable(String),
    /// How sure the adapter is.
    Claim(Confidence),
    /// Said while a document is read: a stage is done. The block is its picture, if there are sides.
    Stage { name: String, sides: Option<(u32, u32)> },
    /// What was read. The block is the grid's cells.
    Scene(SceneHeader),
    /// The outputs follow each other in the block: the document, then its companions, of these lengths.
    Written { lengths: Vec<usize> },
    /// The check is done, and found this fault.
    Checked(Option<String>),
    /// It did not work.
    Failed(PluginError),
}

/// An answer and what the plugin logged before it.
#[derive(Serialize, Deserialize)]
pub struct Reply {
    pub answer: Answer,
    pub logged: Vec<Log>,
}

/// A path, which need not be UTF-8.
pub type PathName = OsString;

/// The values of a run's options.
pub type Values = BTreeMap<String, OptionValue>;

/// A scene without its grid's cells.
#[derive(Serialize, Deserialize)]
pub struct SceneHeader {
    width: u32,
    height: u32,
    resolution: f64,
    origin: Pose,
    annotations: Annotations,
}

impl SceneHeader {
    pub fn of(scene: &Scene) -> Self {
        let grid = &scene.grid;
        Self {
            width: grid.width(),
            height: grid.height(),
            resolution: grid.resolution(),
            origin: grid.origin(),
            annotations: scene.annotations(),
        }
    }

    /// The scene with these cells.
    pub fn with(self, cells: &[u8]) -> io::Result<Scene> {
        let cells = cells.iter().map(|b| Cell::of_ros(b.cast_signed())).collect::<Option<_>>();
        let cells = cells.ok_or_else(|| garbled("a cell that means nothing"))?;
        let grid =
            Grid::new(self.width, self.height, self.resolution, self.origin, cells).map_err(garbled)?;
        Ok(Scene::new(grid, self.annotations))
    }
}

/// The cells as a block.
pub fn cells_of(grid: &Grid) -> Vec<u8> {
    grid.cells().iter().map(|c| c.to_ros().cast_unsigned()).collect()
}

/// Writes a message.
pub fn send(out: &mut impl Write, header: &impl Serialize, block: &[u8]) -> io::Result<()> {
    let header = serde_json::to_vec(header)?;
    out.write_all(&(header.len() as u64).to_le_bytes())?;
    out.write_all(&(block.len() as u64).to_le_bytes())?;
    out.write_all(&header)?;
    out.write_all(block)?;
    out.flush()
}

/// Reads a message whose header and block have at most `limit` bytes each. No more memory is taken than bytes arrive.
pub fn receive<T: DeserializeOwned>(from: &mut impl Read, limit: u64) -> io::Result<(T, Vec<u8>)> {
    let lengths = [length(from)?, length(from)?];
    if lengths.iter().any(|l| *l > limit) {
        return Err(garbled("a message larger than the limit"));
    }
    let [header, block] = lengths.map(|length| bytes(from, length));
    Ok((serde_json::from_slice(&header?)?, block?))
}

fn length(from: &mut impl Read) -> io::Result<u64> {
    let mut bytes = [0; 8];
    from.read_exact(&mut bytes)?;
    Ok(u64::from_le_bytes(bytes))
}

fn bytes(from: &mut impl Read, length: u64) -> io::Result<Vec<u8>> {
    let mut bytes = vec![];
    let read = from.take(length).read_to_end(&mut bytes)?;
    if read as u64 == length { Ok(bytes) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
}

fn garbled(what: impl ToString) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Provenance;

    #[test]
    fn messages_arrive() {
        let mut pipe = vec![];
        let path = crate::host::conformance::odd_path();
        send(&mut pipe, &Request::Probe { adapter: 3, path: path.clone() }, b"head").unwrap();
        let (request, block) = receive::<Request>(&mut pipe.as_slice(), 1000).unwrap();
        assert!(matches!(request, Request::Probe { adapter: 3, path: p } if p == path));
        assert_eq!(block, b"head");
    }

    #[test]
    fn a_scene_arrives_whole() {
        let cells = vec![Cell::UNKNOWN, Cell::FREE, Cell::OCCUPIED];
        let grid = Grid::new(3, 1, 0.1 + 0.2, Pose { x: 1e-300, y: -0.0, yaw: 3.0 }, cells).unwrap();
        let scene = Scene::of_grid(grid, Provenance { source: "\0".into(), adapter: "a".into() });
        let mut pipe = vec![];
        send(&mut pipe, &SceneHeader::of(&scene), &cells_of(&scene.grid)).unwrap();
        let (header, block) = receive::<SceneHeader>(&mut pipe.as_slice(), 1000).unwrap();
        assert_eq!(header.with(&block).unwrap(), scene);
    }

    #[test]
    fn garbled_messages_are_refused() {
        let mut long = u64::MAX.to_le_bytes().to_vec();
        long.extend([0; 8]);
        let mut cut = vec![];
        send(&mut cut, &Request::Describe, b"block").unwrap();
        cut.pop();
        for bytes in [b"".as_slice(), b"12345", &long, &cut, &[0; 16]] {
            assert!(receive::<Request>(&mut &*bytes, 1000).is_err());
        }
        let header = SceneHeader {
            width: 60_000,
            height: 60_000,
            resolution: 1.0,
            origin: Pose::default(),
            annotations: Annotations::default(),
        };
        assert!(header.with(&[0]).is_err());
    }
}
