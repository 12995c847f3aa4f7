//! From a grid to a layout, after Luperto et al., "Extracting Structure of Buildings using Layout Reconstruction",
//! Algorithm 1. One file for each step, in the paper's order.
//!
//! The core reads no file, prints nothing and does not know where a grid came from.

mod observer;
mod params;

pub use observer::{Drawing, Observer, Shape, Step};
pub use params::{Method, Params};

use planform_sdk::{Layout, Scene};
use thiserror::Error;

/// Why a scene has no layout.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ReconstructError {
    /// Nothing to lay rooms out in.
    #[error("the map shows no free space, so there is no room to find; check the thresholds and `negate`")]
    NoFreeSpace,
    /// Nothing that bounds a room.
    #[error("the map shows no walls, so there is no room to find; check the thresholds and `negate`")]
    NoWalls,
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
    /// The work would grow beyond a limit.
    #[error("{what}: {found}, and the most are {limit}; {advice}")]
    Limit {
        /// What there is too much of.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there may be.
        limit: usize,
        /// What the user can do.
        advice: &'static str,
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
    observer.step(Step::Edges);
    Ok(Layout {
        provenance: scene.provenance.clone(),
        method: params.method.name().into(),
        ..Layout::default()
    })
}
