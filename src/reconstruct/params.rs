//! Every number that the reconstruction depends on. Lengths are in metres and angles in radians, so that a map's
//! resolution changes nothing.

use super::ReconstructError;
use super::affinity::Affinity;
use super::basins::{Explored, Furniture, Merge};
use super::clutter::Clutter;
use super::collinear::Collinear;
use super::contour::Contour;
use super::directions::Directions;
use super::edges::Edges;
use super::faces::Faces;
use super::lines::Lines;
use super::observer::Step;
use super::partial::Partial;
use super::rooms::Rooms;
use super::segments::Segments;
use super::straight::Straight;
use super::walls::Walls;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// The parameters of a reconstruction.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Which method reconstructs: `basins` merges basins of free space to rooms, `paper` is Algorithm 1 of the paper.
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
    /// What stands in the free space and is no wall, for the method `basins`.
    pub furniture: Furniture,
    /// When two regions of free space are one room, for the method `basins`.
    pub merge: Merge,
    /// When a room is partial, and how it is completed, for the method `basins`.
    pub explored: Explored,
    /// How straight rooms' polygons are, for the method `basins`.
    pub straight: Straight,
    /// How walls' faces and openings are measured.
    pub walls: Walls,
}

impl Params {
    /// Every number with its name as in the file and the range that it may have. Beyond it the work would have no
    /// meaning or no end.
    fn ranges(&self) -> Vec<(&'static str, f64, RangeInclusive<f64>)> {
        let (s, t, w, e) = (&self.segments, &self.straight, &self.walls, &self.explored);
        vec![
            ("clutter.radius", self.clutter.radius, 0.0..=1.0),
            ("clutter.extent", self.clutter.extent, 0.0..=1e4),
            ("edges.low", self.edges.low, 0.0..=1e6),
            ("edges.high", self.edges.high, 0.0..=1e6),
            ("segments.distance_step", s.distance_step, 1e-3..=10.0),
            ("segments.angle_step", s.angle_step, 2e-3..=0.5),
            ("segments.support", s.support, 0.0..=1e3),
            ("segments.min_length", s.min_length, 0.0..=1e3),
            ("segments.max_gap", s.max_gap, 0.0..=1e3),
            ("contour.obstacle", self.contour.obstacle.into(), 1.0..=100.0),
            ("contour.free", self.contour.free.into(), 0.0..=99.0),
            ("contour.min_area", self.contour.min_area, 0.0..=1e6),
            ("contour.max_hole", self.contour.max_hole, 0.0..=1e6),
            ("directions.bandwidth", self.directions.bandwidth, 1e-3..=1.5),
            ("directions.merge", self.directions.merge, 0.0..=0.5),
            ("directions.min_share", self.directions.min_share, 0.0..=1.0),
            ("collinear.distance", self.collinear.distance, 1e-3..=100.0),
            ("lines.min_support", self.lines.min_support, 0.0..=1e6),
            ("lines.max_count", self.lines.max_count as f64, 1.0..=10_000.0),
            ("faces.inner_share", self.faces.inner_share, 1e-3..=1.0),
            ("faces.margin", self.faces.margin, 1e-3..=50.0),
            ("faces.max_count", self.faces.max_count as f64, 1.0..=1e7),
            ("affinity.sigma", self.affinity.sigma, 1e-3..=100.0),
            ("rooms.epsilon", self.rooms.epsilon, 0.0..=2.0),
            ("partial.weight", self.partial.weight, 0.0..=1.0),
            ("furniture.area", self.furniture.area, 0.0..=1e3),
            ("furniture.extent", self.furniture.extent, 0.0..=100.0),
            ("furniture.gap", self.furniture.gap, 0.0..=1.0),
            ("furniture.reach", self.furniture.reach, 0.0..=20.0),
            ("merge.probability", self.merge.probability, 0.0..=1.0),
            ("merge.corridor", self.merge.corridor, 0.0..=1e6),
            ("merge.unnarrowed", self.merge.unnarrowed, 0.0..=10.0),
            ("merge.door", self.merge.door, 0.0..=100.0),
            ("merge.through", self.merge.through, 0.0..=10.0),
            ("merge.nook", self.merge.nook, 0.0..=1e4),
            ("explored.frontier", e.frontier, 0.0..=100.0),
            ("explored.depth", e.depth, 0.0..=5.0),
            ("explored.gap", e.gap, 0.0..=1.0),
            ("explored.unseen", e.unseen, 0.0..=1.0),
            ("explored.reach", e.reach, 0.0..=50.0),
            ("explored.row", e.row, 0.0..=1e4),
            ("explored.door", e.door, 0.0..=10.0),
            ("explored.smallest", e.smallest, 0.0..=1e3),
            ("explored.support", e.support, 0.0..=1e3),
            ("straight.tolerance", t.tolerance, 0.0..=5.0),
            ("straight.alignment", t.alignment, 0.0..=1.0),
            ("straight.min_share", t.min_share, 0.0..=1.0),
            ("straight.dent_depth", t.dent_depth, 0.0..=5.0),
            ("straight.dent_width", t.dent_width, 0.0..=10.0),
            ("straight.min_hole", t.min_hole, 0.0..=1e4),
            ("straight.max_wall", t.max_wall, 1e-3..=5.0),
            ("straight.unseen_thickness", t.unseen_thickness, 1e-3..=5.0),
            ("straight.frontier_reach", t.frontier_reach, 0.0..=5.0),
            ("straight.min_opening", t.min_opening, 0.0..=100.0),
            ("straight.max_door", t.max_door, 0.0..=100.0),
            ("walls.reach", w.reach, 1e-3..=5.0),
            ("walls.min_weight", w.min_weight, 0.0..=1.0),
            ("walls.unseen_thickness", w.unseen_thickness, 1e-3..=5.0),
            ("walls.min_opening", w.min_opening, 0.0..=100.0),
            ("walls.max_door", w.max_door, 0.0..=100.0),
            ("walls.min_floor", w.min_floor, 1e-3..=1e6),
        ]
    }

    /// Refuses the first number that is out of its range.
    pub fn check(&self) -> Result<(), ReconstructError> {
        let bad = self.ranges().into_iter().find(|(_, value, range)| !range.contains(value));
        let refuse = |(name, value, range): (&str, f64, RangeInclusive<f64>)| ReconstructError::Parameter {
            name: name.into(),
            value,
            advice: format!("give a number from {} to {}", range.start(), range.end()),
        };
        bad.map_or(Ok(()), |b| Err(refuse(b)))
    }
}

/// A method of reconstruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Free space cut into basins, which merge to rooms.
    #[default]
    Basins,
    /// The paper's Algorithm 1.
    Paper,
}

impl Method {
    /// All methods.
    pub const ALL: &[Self] = &[Self::Basins, Self::Paper];

    /// The name as the user types it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Basins => "basins",
            Self::Paper => "paper",
        }
    }

    /// The steps that an observer is told of, in their order.
    pub fn steps(self) -> &'static [Step] {
        match self {
            Self::Basins => &Step::BASINS,
            Self::Paper => &Step::PAPER,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_defaults_are_in_their_ranges() {
        assert_eq!(Params::default().check(), Ok(()));
    }

    #[test]
    fn every_number_has_a_range() {
        let params = serde_json::to_value(Params::default()).unwrap();
        let steps = params.as_object().unwrap().iter().filter_map(|(step, v)| Some((step, v.as_object()?)));
        let numbers: Vec<String> = steps
            .flat_map(|(step, fields)| {
                fields.iter().filter(|(_, v)| v.is_number()).map(move |(field, _)| format!("{step}.{field}"))
            })
            // Any seed will do, and no count of neighbours is too large.
            .filter(|name| {
                !["segments.seed", "clutter.min_points", "rooms.min_points"].contains(&name.as_str())
            })
            .collect();
        let default = Params::default();
        let mut ranged: Vec<&str> = default.ranges().iter().map(|r| r.0).collect();
        ranged.sort_unstable();
        let mut numbers: Vec<&str> = numbers.iter().map(String::as_str).collect();
        numbers.sort_unstable();
        assert_eq!(numbers, ranged);
    }

    #[test]
    fn what_is_out_of_range_is_named() {
        let params = Params {
            collinear: Collinear { distance: f64::NAN, ..Collinear::default() },
            ..Params::default()
        };
        let message = params.check().unwrap_err().to_string();
        assert_eq!(message, "parameter `collinear.distance` cannot be NaN; give a number from 0.001 to 100");
    }
}
