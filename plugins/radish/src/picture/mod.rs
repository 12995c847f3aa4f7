//! Map pictures as the Robotics Data Set Repository holds them: grey ones whose conventions differ, with the robot's way
//! drawn over them in colours, or with unknown space in a colour.
//!
//! A pixel is coloured or grey. A colour that fills wide areas is unknown space; other colours are lines drawn over the
//! map, and their pixels become what lies around them (`lines`). Of the greys the frequent ones are found, and told
//! apart by where they are (`greys`).

mod backdrop;
mod claim;
mod decode;
mod greys;
mod lines;
mod options;
#[cfg(test)]
mod tests;
mod wide;

pub use claim::{look, probe};
pub use decode::is_picture;
pub use options::specs;

use decode::Picture;
use greys::Meaning;
use planform_sdk::{Cell, ErrorKind, Grid, PluginError, Pose};

/// What coloured lines become.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lines {
    /// What lies around them.
    #[default]
    Remove,
    /// What their grey means.
    Keep,
}

/// What is known of a picture before it is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureParams {
    /// Metres per pixel.
    pub resolution: f64,
    /// The grey of free space, if it is not to be found.
    pub free: Option<u8>,
    /// The grey of unknown space, if it is not to be found.
    pub unknown: Option<u8>,
    /// The grey of walls, if it is not to be found.
    pub wall: Option<u8>,
    /// What becomes of coloured lines.
    pub lines: Lines,
}

/// Reads a picture; the map frame's origin is its lower left corner. Returns the grid, and a sentence on what the greys
/// were taken for.
///
/// # Errors
/// When the picture cannot be decoded, is too large, or shows one grey alone.
pub fn read(bytes: &[u8], params: &PictureParams) -> Result<(Grid, String), PluginError> {
    let picture = Picture::decode(bytes)?;
    let (meaning, shades) = understand(&picture, params)?;
    let cells: Vec<Cell> = rows_from_below(&shades, picture.width).map(|shade| meaning.cell(shade)).collect();
    let (width, height) = (picture.width as u32, picture.height as u32);
    let grid = Grid::new(width, height, params.resolution, Pose::default(), cells)
        .map_err(|e| PluginError::new(ErrorKind::BadInput, e.to_string()))?;
    Ok((grid, meaning.in_words()))
}

/// What the picture's greys mean, and the grey of each pixel, row by row from above; none where a colour says unknown.
fn understand(picture: &Picture, params: &PictureParams) -> Result<(Meaning, Vec<Option<u8>>), PluginError> {
    let radius = wide::radius(params.resolution);
    let mut drawn = picture.coloured();
    let backdrop = backdrop::find(picture, &drawn, radius);
    drawn.iter_mut().zip(&backdrop).for_each(|(drawn, back)| *drawn &= !back);
    if params.lines == Lines::Keep {
        drawn.fill(false);
    }
    let mut shades: Vec<Option<u8>> =
        picture.greys().zip(&backdrop).map(|(grey, back)| grey.filter(|_| !back)).collect();
    let meaning = greys::find(&shades, &drawn, picture.width, radius, params)?;
    lines::remove(&mut shades, &drawn, picture.width, &meaning);
    Ok((meaning, shades))
}

fn rows_from_below(shades: &[Option<u8>], width: usize) -> impl Iterator<Item = Option<u8>> + '_ {
    shades.chunks(width.max(1)).rev().flatten().copied()
}
