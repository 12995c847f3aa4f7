//! Pictures of maps, as a robot saves them.

use std::fs;
use std::path::Path;

/// Greys of a cell.
pub const WALL: u8 = 0;
pub const UNKNOWN: u8 = 205;
pub const FREE: u8 = 254;

/// A map's picture, row by row from the top.
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub greys: Vec<u8>,
}

impl Picture {
    /// Of which nothing is known.
    pub fn unknown(width: usize, height: usize) -> Self {
        Self { width, height, greys: vec![UNKNOWN; width * height] }
    }

    /// Paints the columns `x.0..x.1` of the rows `y.0..y.1`.
    pub fn fill(&mut self, x: (usize, usize), y: (usize, usize), grey: u8) {
        let rows = self.greys.chunks_exact_mut(self.width).take(y.1).skip(y.0);
        rows.for_each(|row| row[x.0..x.1].fill(grey));
    }

    /// Writes `map.pgm` and `map.yaml` into the folder.
    pub fn save(&self, folder: &Path, resolution: f64) {
        let header = format!("P5\n{} {}\n255\n", self.width, self.height);
        fs::write(folder.join("map.pgm"), [header.as_bytes(), &self.greys].concat()).unwrap();
        let yaml = format!(
            "image: map.pgm\nresolution: {resolution}\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n\
             free_thresh: 0.196\n"
        );
        fs::write(folder.join("map.yaml"), yaml).unwrap();
    }
}
