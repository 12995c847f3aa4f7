//! Straight polygons from a raster of room labels: floors, walls, openings.
//!
//! Where two rooms touch is an opening (`doorways`). What is left of each room is traced along its cells' borders
//! (`trace`), split into straight pieces (`pieces`), turned to the building's main directions (`bearings`), rid of what
//! is too small to be built (`simplify`) and aligned over the whole building (`align`); then the pieces meet at corners
//! (`corners`). Faces that look at each other make walls (`facing`, `walls`, `joints`), and the floors grown by half
//! their walls make the rooms along the walls' centre lines (`centre`).
//!
//! All is in metres from the grid's corner, x right, y up; the cell (column, row) covers
//! `[column, column + 1] x [row, row + 1]` times the resolution. Rooms are numbered from 0: room i has the label i + 1.

mod align;
mod bearings;
mod carrier;
mod centre;
mod corners;
mod doorways;
mod facing;
mod guard;
mod joints;
mod outer;
mod pieces;
mod plan;
mod simplify;
mod trace;
mod walls;

use super::openings::Gap;
use super::raster::Mask;
use planform_sdk::{Point, Polygon, Segment, StatedOpening};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How straight the polygons of rooms become.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Straight {
    /// How far a straight piece may lie from the cells' border; at least one and a half cells. Metres.
    pub tolerance: f64,
    /// Between faithful curves (0) and strong alignment (1): how far pieces are turned to the building's main directions
    /// and moved onto common lines.
    pub alignment: f64,
    /// A direction is a main one when it carries this share of all pieces' length. 0 to 1.
    pub min_share: f64,
    /// A dent no deeper than this is bridged if it is no wider than `dent_width`: furniture, pillars. Metres.
    pub dent_depth: f64,
    /// See `dent_depth`. Metres.
    pub dent_width: f64,
    /// A hole in a room with less area is filled, unless there is another room in it. Square metres.
    pub min_hole: f64,
    /// The thickest wall: what is farther apart is not one wall. Metres.
    pub max_wall: f64,
    /// Thickness of a wall of which only one face was seen. Metres.
    pub unseen_thickness: f64,
    /// A room's outline is open where no obstacle lies within this distance. Metres.
    pub frontier_reach: f64,
    /// An opening narrower than this is a gap in the map. Metres.
    pub min_opening: f64,
    /// An opening up to this width is a door, a wider one a passage. Metres.
    pub max_door: f64,
}

impl Default for Straight {
    fn default() -> Self {
        Self {
            tolerance: 0.15,
            alignment: 0.25,
            min_share: 0.05,
            dent_depth: 0.5,
            dent_width: 1.0,
            min_hole: 2.0,
            max_wall: 1.2,
            unseen_thickness: 0.3,
            frontier_reach: 0.3,
            min_opening: 0.5,
            max_door: 2.1,
        }
    }
}

/// A raster of rooms and what the map shows.
#[derive(Debug, Clone, Copy)]
pub struct Labelled<'a> {
    /// Metres per cell.
    pub resolution: f64,
    /// For each cell its room's label, 1 to `rooms`; other values are no room. As many as the masks have cells.
    pub label: &'a [u32],
    /// How many rooms there are.
    pub rooms: usize,
    /// Cells seen free.
    pub free: &'a Mask,
    /// Occupied cells; what is neither is unknown.
    pub obstacles: &'a Mask,
    /// Openings that the document states, metres from the grid's corner.
    pub stated: &'a [StatedOpening],
}

/// One room.
#[derive(Debug, Clone, PartialEq)]
pub struct RoomPlan {
    /// Within the walls' inner faces.
    pub floor: Polygon,
    /// Along the walls' centre lines; it contains the floor.
    pub centre: Polygon,
}

/// A straight wall.
#[derive(Debug, Clone, PartialEq)]
pub struct StraightWall {
    /// Its centre line.
    pub line: Segment,
    /// Distance of its faces, metres.
    pub thickness: f64,
    /// The share of it that the map shows as obstacle, 0 to 1.
    pub weight: f64,
    /// The rooms to its left and right.
    pub rooms: [Option<usize>; 2],
}

/// A stretch of a room's outline beyond which nothing is known.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenSide {
    /// Where it runs, with the room to its left.
    pub segment: Segment,
    /// The room.
    pub room: usize,
}

/// What the raster shows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plan {
    /// For each room its polygons; `None` if no cell has its label.
    pub rooms: Vec<Option<RoomPlan>>,
    /// The walls.
    pub walls: Vec<StraightWall>,
    /// Doors and passages.
    pub openings: Vec<Gap>,
    /// Where rooms are open.
    pub frontiers: Vec<OpenSide>,
}

impl Labelled<'_> {
    /// Columns.
    fn width(&self) -> usize {
        self.free.width()
    }

    /// The column and row of the cell that holds a point.
    fn cell(&self, p: Point) -> (i64, i64) {
        (floor(p.x / self.resolution), floor(p.y / self.resolution))
    }

    /// The label of a cell; 0 for none and outside.
    fn room(&self, label: &[u32], column: i64, row: i64) -> u32 {
        let at = self.free.index(column, row).and_then(|i| label.get(i));
        at.copied().filter(|&l| l as usize <= self.rooms).unwrap_or(0)
    }
}

/// The largest whole number that is not larger; without a call of the mathematical library.
pub fn floor(v: f64) -> i64 {
    let towards_zero = v as i64;
    towards_zero - i64::from(v < towards_zero as f64)
}

/// The building's main directions: angles in [0, pi), by rising angle.
pub fn directions(input: &Labelled<'_>, params: &Straight) -> Vec<f64> {
    plan::directions(input, params)
}

/// The plan of the rooms; `main` are the building's [`directions`].
pub fn plan(input: &Labelled<'_>, main: &[f64], params: &Straight) -> Plan {
    plan::plan(input, main, params)
}

#[cfg(test)]
mod tests;
