//! From a grid to a layout, by one of two methods: `basins` (the folder of that name, then `straight`), and `paper`,
//! Algorithm 1 of Luperto et al., "Extracting Structure of Buildings using Layout Reconstruction", one file for each step.
//!
//! The core reads no file, prints nothing and does not know where a grid came from.

mod affinity;
mod arrangement;
#[doc(hidden)]
pub mod basins;
mod boundary;
mod clutter;
mod collinear;
mod contour;
mod directions;
mod doors;
mod drawings;
mod edges;
mod faces;
mod finish;
mod inner;
mod lines;
mod measures;
mod names;
mod observer;
mod openings;
mod outline;
mod paper;
mod params;
mod partial;
mod random;
mod raster;
mod rooms;
mod runs;
mod segments;
mod shown;
mod straight;
mod walls;

pub use affinity::Affinity;
pub use basins::{Explored, Furniture, Merge};
pub use clutter::Clutter;
pub use collinear::{Collinear, Linkage};
pub use contour::Contour;
pub use directions::Directions;
pub use edges::Edges;
pub use faces::Faces;
pub use lines::Lines;
pub use observer::{Drawing, Observer, Shape, Step};
pub use params::{Method, Params};
pub use partial::Partial;
pub use rooms::{Metric, Rooms};
pub use segments::Segments;
pub use straight::Straight;
pub use walls::Walls;

use planform_sdk::{Layout, Scene};
use thiserror::Error;

/// Why a scene has no layout.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReconstructError {
    /// Nothing to lay rooms out in.
    #[error(
        "the map shows no free space, so there is no room to find; `planform inspect` tells which cells are taken for what"
    )]
    NoFreeSpace,
    /// Nothing that bounds a room.
    #[error(
        "the map shows no walls, so there is no room to find; `planform inspect` tells which cells are taken for what"
    )]
    NoWalls,
    /// Too much for the parameter `faces.max_count`.
    #[error("the map's lines part it into more than {0} faces; `--max-faces` allows more")]
    TooManyFaces(usize),
    /// A parameter has no usable value.
    #[error("parameter `{name}` cannot be {value}; {advice}")]
    Parameter {
        /// Its name as in the file: `collinear.distance`.
        name: String,
        /// The value given.
        value: f64,
        /// What would do.
        advice: String,
    },
}

/// Reconstructs the layout of the building that the scene shows.
///
/// The same scene and parameters give the same layout, always. `observer` is told of every step; `&mut ()` ignores
/// them.
pub fn reconstruct(
    scene: &Scene,
    params: &Params,
    observer: &mut dyn Observer,
) -> Result<Layout, ReconstructError> {
    params.check()?;
    match params.method {
        Method::Basins => basins::reconstruct(scene, params, observer),
        Method::Paper => paper::reconstruct(scene, params, observer),
    }
}
