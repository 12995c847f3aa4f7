//! Every number that the reconstruction depends on. Lengths are in metres and angles in radians, so that a map's
//! resolution changes nothing.

use super::affinity::Affinity;
use super::clutter::Clutter;
use super::collinear::Collinear;
use super::contour::Contour;
use super::directions::Directions;
use super::edges::Edges;
use super::faces::Faces;
use super::lines::Lines;
use super::partial::Partial;
use super::rooms::Rooms;
use super::segments::Segments;
use super::walls::Walls;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The parameters of a reconstruction.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Which method reconstructs: `paper` is Algorithm 1 of the paper to the letter.
    pub method: Method,
    /// How isolated obstacle cells are found and removed.
    pub clutter: Clutter,
    /// Thresholds of the edge detector.
    pub edges: Edges,
    /// What makes a line segment.
    pub segments: Segments,
    /// What belongs to the inner area.
    pub contour: Contour,
    /// How alike the angles of one direction are.
    pub directions: Directions,
    /// When two segments lie along one line.
    pub collinear: Collinear,
    /// Which clusters have a representative line.
    pub lines: Lines,
    /// Which faces lie outside.
    pub faces: Faces,
    /// How fast affinity falls with the wall between two faces.
    pub affinity: Affinity,
    /// When two faces belong to one room.
    pub rooms: Rooms,
    /// What makes a face partial.
    pub partial: Partial,
    /// How walls' faces and openings are measured.
    pub walls: Walls,
}

/// A method of reconstruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// The paper's Algorithm 1.
    #[default]
    Paper,
}

impl Method {
    /// All methods.
    pub const ALL: &[Self] = &[Self::Paper];

    /// The name as the user types it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
        }
    }
}
