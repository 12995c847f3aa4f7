//! Draws laser scans to an occupancy grid.
//!
//! Every beam is cast through the grid: each cell that it passes is a vote for free space, and the one that it ends in a
//! vote for an obstacle. Votes are whole numbers, so their sums do not depend on the order, nor on the number of threads;
//! a cell's log-odds is what they sum up to (Moravec and Elfes 1985; Thrun, Burgard and Fox, Probabilistic Robotics,
//! chapter 9).

mod area;
mod beam;
mod odds;
mod votes;

pub use area::Area;
pub use odds::Odds;

use crate::log::{Pose, Scan};
use planform_sdk::{Grid, PluginError};

/// How scans are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MappingParams {
    /// Width of a cell, metres.
    pub resolution: f64,
    /// How far beams reach, metres: one that ends farther away frees the way up to there, and no obstacle is drawn.
    pub reach: f64,
    /// What votes are worth.
    pub odds: Odds,
}

/// The grid that these scans make, each from its pose. Its frame is that of the poses.
///
/// # Errors
/// When the scans cover more cells than a grid may have, or none.
pub fn map(scans: &[Scan], poses: &[Pose], params: &MappingParams) -> Result<Grid, PluginError> {
    let placed: Vec<_> = scans.iter().zip(poses.iter().copied()).collect();
    let area = Area::of(&placed, params)?;
    let votes = votes::count(&placed, &area, params.reach);
    area.grid(votes.iter().map(|v| params.odds.cell(v.ends, v.passes)).collect())
}
