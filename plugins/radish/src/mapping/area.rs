//! Where the grid lies.

use super::MappingParams;
use super::beam::beams;
use crate::log::{Pose, Scan};
use planform_sdk::{Cell, ErrorKind, Grid, PluginError, Pose as MapPose};

/// Unknown space around what the beams reached, cells.
const MARGIN: f64 = 4.0;

/// A rectangle of cells in the frame of the poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Width of a cell, metres.
    pub resolution: f64,
    /// The lower left corner, in cells from the frame's origin: whole numbers, so that maps of one frame overlay.
    corner: [f64; 2],
}

impl Area {
    /// The cells that the beams of these scans reach, with a margin.
    ///
    /// # Errors
    /// When there are more than a grid may have, or no beam at all.
    pub fn of(placed: &[(&Scan, Pose)], params: &MappingParams) -> Result<Self, PluginError> {
        let bounds = Bounds::of(placed, params.reach).ok_or_else(no_beams)?;
        let low = bounds.low.map(|v| (v / params.resolution).floor() - MARGIN);
        let sides = [0, 1].map(|i| (bounds.high[i] / params.resolution).floor() + 1.0 + MARGIN - low[i]);
        // A cast to a whole number keeps to what that can hold, which is more than a grid can have.
        let [width, height] = sides.map(|side| side as u32);
        Grid::check_size(width, height).map_err(|e| {
            let metres = [0, 1].map(|i| (bounds.high[i] - bounds.low[i]).round());
            let message = format!("the scans reach over {} x {} m, and {e}", metres[0], metres[1]);
            PluginError::new(ErrorKind::Limit, message).advise(advice(placed))
        })?;
        Ok(Self { width, height, resolution: params.resolution, corner: low })
    }

    /// From metres to cell coordinates.
    pub fn to_cells(&self, p: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| p[i] / self.resolution - self.corner[i])
    }

    /// The grid of these cells.
    ///
    /// # Errors
    /// When there is no such grid, as of cells that are too small.
    pub fn grid(&self, cells: Vec<Cell>) -> Result<Grid, PluginError> {
        let [x, y] = self.corner.map(|v| v * self.resolution);
        Grid::new(self.width, self.height, self.resolution, MapPose { x, y, yaw: 0.0 }, cells)
            .map_err(|e| PluginError::new(ErrorKind::BadOption, e.to_string()))
    }
}

/// What to do about a map that is too large: a damaged pose is the likeliest cause.
fn advice(placed: &[(&Scan, Pose)]) -> String {
    let middle = [|p: Pose| p.x, |p: Pose| p.y].map(|axis| {
        let mut values: Vec<f64> = placed.iter().map(|(_, pose)| axis(*pose)).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    });
    let away = |pose: Pose| (pose.x - middle[0]).hypot(pose.y - middle[1]);
    let far = (1..).zip(placed).max_by(|(_, (_, a)), (_, (_, b))| away(*a).total_cmp(&away(*b)));
    let (number, metres) = far.map_or((0, 0.0), |(number, (_, pose))| (number, away(*pose).round()));
    format!(
        "a larger `resolution` makes fewer cells; the pose farthest out, {metres} m from the middle one, is that of scan {number}"
    )
}

fn no_beams() -> PluginError {
    PluginError::new(ErrorKind::BadInput, "no reading of the log is an echo, so there is nothing to draw")
        .advise("the laser's maximum range in the log may be wrong")
}

/// The least and the greatest coordinates that beams reach, metres.
struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    fn of(placed: &[(&Scan, Pose)], reach: f64) -> Option<Self> {
        let mut bounds = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for (scan, pose) in placed {
            for ray in beams(scan, *pose, reach) {
                bounds.add([pose.x, pose.y]);
                bounds.add(ray.end);
            }
        }
        bounds.low[0].is_finite().then_some(bounds)
    }

    fn add(&mut self, p: [f64; 2]) {
        for (i, v) in p.into_iter().enumerate() {
            self.low[i] = self.low[i].min(v);
            self.high[i] = self.high[i].max(v);
        }
    }
}
