//! Rooms that were seen in part: which they are, what they look like whole, and where their frontiers lead.
//!
//! Where free cells border on unknown ones is a frontier (`frontier`). What was seen through a door is another room
//! (`glimpse`). A room's floor goes on at a frontier, along the building's directions, to the line that closes other
//! rooms in that row or to what was seen of others (`lines`, `extend`); the unseen cells up to there are its own
//! (`fill`). A room is partial if enough of it was not seen, so that the shadow of a cupboard makes no difference.

mod extend;
mod field;
mod fill;
mod flood;
mod frontier;
mod glimpse;
mod lines;

use super::super::straight::{Labelled, Straight};
use extend::Extent;
use field::{Field, Frame};
use flood::Flood;
use frontier::Run;
use lines::Lines;
use planform_sdk::{FrontierKind, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// When a room is partial, and how it is completed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Explored {
    /// A frontier shorter than this is a gap in the map. Metres.
    pub frontier: f64,
    /// Unknown cells are a frontier if they go on for at least this. Metres.
    pub depth: f64,
    /// Pieces of a frontier that are no farther apart than this are one. Metres.
    pub gap: f64,
    /// A room is partial if at least this share of its completed floor was not seen. 0 to 1.
    pub unseen: f64,
    /// Floors are extended by at most this. Metres.
    pub reach: f64,
    /// Walls of other rooms that are no farther aside than this say where a floor ends. Metres.
    pub row: f64,
    /// A door through which another room was seen is at most this wide. Metres.
    pub door: f64,
    /// What was seen of a room through a door is a room of its own if it covers at least this. Square metres.
    pub smallest: f64,
    /// A line closes floors if at least this length of walls lies on it. Metres.
    pub support: f64,
}

impl Default for Explored {
    fn default() -> Self {
        Self {
            frontier: 0.8,
            depth: 0.3,
            gap: 0.2,
            unseen: 0.02,
            reach: 5.0,
            row: 8.0,
            door: 1.6,
            smallest: 0.5,
            support: 1.0,
        }
    }
}

/// A frontier of a partial room.
#[derive(Debug, Clone, PartialEq)]
pub struct Border {
    /// Index of the room.
    pub room: usize,
    /// From one end of the frontier to the other, metres from the grid's corner.
    pub segment: Segment,
    /// Where it leads.
    pub leads: FrontierKind,
    /// Estimate of the area behind it, square metres; 0 is none.
    pub area: f64,
}

/// What is known of the rooms.
#[derive(Debug, Clone, PartialEq)]
pub struct Knowledge {
    /// The room of each cell, from 1, partial rooms completed; 0 is none.
    pub label: Vec<u32>,
    /// For each room whether it is partial.
    pub partial: Vec<bool>,
    /// The frontiers of partial rooms.
    pub frontiers: Vec<Border>,
}

/// A run with what lies behind it.
struct Behind {
    run: Run,
    cells: Vec<usize>,
    extent: Extent,
}

/// Tells partial rooms from complete ones and completes them. `main` are the building's directions.
pub fn explore(input: &Labelled<'_>, main: &[f64], straight: &Straight, params: &Explored) -> Knowledge {
    let lines_of = |seen: &Labelled<'_>| -> Vec<Lines> {
        let at_walls = lines::at_walls(seen);
        frames(main).into_iter().map(|f| Lines::of(seen, &at_walls, f)).collect()
    };
    let mut lines = lines_of(input);
    let mut runs = frontier::runs(input, &lines, params);
    let mut label = input.label.to_vec();
    let mut flood = Flood::new(input);
    let rooms = glimpse::part(input, &mut label, &lines, &runs, &mut flood, params);
    let seen = Labelled { label: &label, rooms, ..*input };
    if label != input.label {
        lines = lines_of(&seen);
        runs = frontier::runs(&seen, &lines, params);
    }
    let mut known = Knowledge { label: label.clone(), partial: vec![false; rooms], frontiers: Vec::new() };
    runs.retain(|r| r.length >= params.frontier);
    let sizes = sizes(&seen);
    for runs in runs.chunk_by(|a, b| a.room == b.room) {
        let room = runs[0].room;
        let Some(lines) = lines::sharpest(&lines, room) else { continue };
        let wall = straight.unseen_thickness;
        let behind = complete(&seen, &mut known.label, runs, lines, wall, &mut flood, params);
        let added = behind.iter().map(|b| b.cells.len()).sum::<usize>() as f64;
        let open = behind.iter().any(|b| b.extent.leads == FrontierKind::Space);
        if open || added >= params.unseen * (added + sizes[room] as f64) {
            known.partial[room] = true;
            known.frontiers.extend(behind.iter().map(|b| b.border(input)));
        } else {
            behind.iter().flat_map(|b| &b.cells).for_each(|&c| known.label[c] = 0);
        }
    }
    known
}

impl Behind {
    fn border(&self, input: &Labelled<'_>) -> Border {
        let added = self.cells.len() as f64 * input.resolution * input.resolution;
        Border {
            room: self.run.room,
            segment: self.run.chord(input),
            leads: self.extent.leads,
            area: if self.extent.leads == FrontierKind::Room { added } else { self.extent.area },
        }
    }
}

/// Gives the cells behind each frontier of a room to the room, the longest one first.
fn complete(
    input: &Labelled<'_>,
    label: &mut [u32],
    runs: &[Run],
    lines: &Lines,
    wall: f64,
    flood: &mut Flood,
    params: &Explored,
) -> Vec<Behind> {
    let mut runs = runs.to_vec();
    runs.sort_by(|a, b| b.length.total_cmp(&a.length));
    let mut all = Vec::new();
    for run in runs {
        let field = Field { input, label, frame: lines.frame };
        let extent = extend::extent(&field, &run, lines, wall, params);
        let cells = fill::behind(&field, &run, &extent, wall, flood);
        for &c in &cells {
            label[c] = run.room as u32 + 1;
        }
        all.push(Behind { run, cells, extent });
    }
    all
}

/// How many cells each room has.
fn sizes(input: &Labelled<'_>) -> Vec<usize> {
    let mut sizes = vec![0; input.rooms];
    for &l in input.label {
        if let Some(size) = (l as usize).checked_sub(1).and_then(|r| sizes.get_mut(r)) {
            *size += 1;
        }
    }
    sizes
}

/// A frame for each direction, those at right angles being one.
fn frames(main: &[f64]) -> Vec<Frame> {
    let mut angles: Vec<f64> = Vec::new();
    for &angle in main {
        let apart = |a: &f64| (4.0 * (a - angle)).cos() < (4.0 * SAME).cos();
        if angles.iter().all(apart) {
            angles.push(angle.rem_euclid(FRAC_PI_2));
        }
    }
    if angles.is_empty() {
        angles.push(0.0);
    }
    angles.into_iter().map(Frame::new).collect()
}

/// Directions that differ from parallel or square by less than this, radians, are the same.
const SAME: f64 = 0.05;

#[cfg(test)]
mod tests;
