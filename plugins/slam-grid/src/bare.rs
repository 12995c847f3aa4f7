//! Reads a bare picture into a scene.

use crate::grey::Grey;
use crate::options::{self, BARE_RESOLUTION, NAME, Unknown};
use crate::picture::{Picture, Tone};
use crate::unknown_grey::{Band, find};
use image::ImageFormat;
use planform_sdk::runs::runs;
use planform_sdk::{Cell, ErrorKind, Grid, Kept, Options, PluginError, Pose, Provenance, Scene, Source};

/// How far a pixel may be from a grey that the user gave.
const TOLERANCE: u8 = 2;

/// Reads the whole document: occupancy is darkness in percent, unknown where the grey says so.
pub fn read(
    source: &Source,
    format: ImageFormat,
    kept: Kept,
    options: &Options,
) -> Result<Scene, PluginError> {
    let unknown = options::unknown(options)?;
    let negate = options.flag("negate");
    let given = options.number("resolution");
    let resolution = given.unwrap_or(BARE_RESOLUTION);
    let picture = match kept.take() {
        Some(decoded) => Picture::of(decoded)?,
        None => Picture::decode(&source.bytes, format)?,
    };
    let (width, height) = (picture.width(), picture.height());
    let greys = picture.map(|tone| grey(tone, negate));
    drop(picture);
    let bands = match unknown {
        Unknown::Auto => find(&greys, width as usize, resolution),
        Unknown::None => vec![],
        Unknown::Grey(g) => vec![Band::around(if negate { 255 - g } else { g }, TOLERANCE)],
    };
    let table: [Cell; Grey::COUNT] = std::array::from_fn(|index| cell(Grey::at(index), &bands));
    let mut cells = Vec::with_capacity(greys.len());
    for run in runs(&greys) {
        cells.resize(cells.len() + run.len(), table[run[0].index()]);
    }
    drop(greys);
    let grid = Grid::new(width, height, resolution, Pose::default(), cells)
        .map_err(|e| PluginError::new(ErrorKind::BadInput, e.to_string()))?;
    let mut scene = Scene::of_grid(grid, Provenance { source: source.name(), adapter: NAME.into() });
    scene.warnings.extend(given.is_none().then(assumed));
    Ok(scene)
}

/// Lengths are only as right as the resolution, which a picture does not tell.
fn assumed() -> String {
    format!("a pixel is taken to be {BARE_RESOLUTION} m wide; `--resolution` says otherwise")
}

/// The grey from 0 (occupied) to 255 (free), or that it is rather transparent than not.
fn grey(tone: Tone, negate: bool) -> Grey {
    let shade = if negate { 1.0 - tone.shade } else { tone.shade };
    if tone.alpha >= 0.5 { Grey::of((shade * 255.0).round() as u8) } else { Grey::CLEAR }
}

fn cell(grey: Grey, unknown: &[Band]) -> Cell {
    match grey.shade() {
        Some(g) if !unknown.iter().any(|band| band.contains(g)) => {
            Cell::percent((f64::from(255 - g) / 2.55).round() as u8)
        }
        _ => Cell::UNKNOWN,
    }
}
