//! Rooms of which something was seen through a door.
//!
//! Such a glimpse is a narrow fan of cells that hangs together with the room from which it was seen. It is another
//! room's if it lies beyond the line of a wall that stands on both sides of the way there.

use super::super::super::straight::Labelled;
use super::Explored;
use super::field::{Field, Side};
use super::flood::Flood;
use super::frontier::Run;
use super::lines::{self, Lines};

/// A wall beside a door is at least this long, metres.
const JAMB: f64 = 0.15;

/// It is sought this far from the door, metres.
const BESIDE: f64 = 1.0;

/// A glimpse begins this far beyond the wall's face, metres; at least one cell.
const BEYOND: f64 = 0.1;

/// Gives every glimpse that ends at one of the runs a label of its own; how many labels there are then.
pub fn part(
    input: &Labelled<'_>,
    label: &mut [u32],
    lines: &[Lines],
    runs: &[Run],
    flood: &mut Flood,
    params: &Explored,
) -> usize {
    let mut rooms = input.rooms;
    for run in runs {
        let Some(lines) = lines::sharpest(lines, run.room) else { continue };
        let field = Field { input, label, frame: lines.frame };
        let looks = Glimpses { field: &field, run, lines, max_door: params.door };
        let Some(cells) = looks.find(flood) else { continue };
        let enough = cells.len() as f64 * input.resolution * input.resolution >= params.smallest;
        rooms += usize::from(enough);
        for c in cells {
            label[c] = if enough { rooms as u32 } else { 0 };
        }
    }
    rooms
}

struct Glimpses<'a> {
    field: &'a Field<'a>,
    run: &'a Run,
    lines: &'a Lines,
    max_door: f64,
}

impl Glimpses<'_> {
    /// The cells of the glimpse that ends at a frontier, if it is one.
    fn find(&self, flood: &mut Flood) -> Option<Vec<usize>> {
        let own = self.run.room as u32 + 1;
        if self.run.cells.iter().any(|&c| self.field.label[c] != own) {
            return None;
        }
        Side::ALL.into_iter().find_map(|side| self.beyond(side, flood))
    }

    /// The cells beyond the nearest wall line on a side that has a door there.
    fn beyond(&self, side: Side, flood: &mut Flood) -> Option<Vec<usize>> {
        let out = |c: usize| self.field.middle(c)[side.axis] * side.sense();
        let first = self.run.cells.iter().map(|&c| out(c)).fold(f64::MAX, f64::min);
        let aside = |c: usize| self.field.middle(c)[1 - side.axis];
        let (low, high) =
            self.run.cells.iter().fold((f64::MAX, f64::MIN), |(l, h), &c| (l.min(aside(c)), h.max(aside(c))));
        let around = [low - BESIDE - self.max_door, high + BESIDE + self.max_door];
        let line = self.lines.own(self.run.room, side, first, around)?;
        let resolution = self.field.input.resolution;
        let begin = line + BEYOND.max(resolution);
        let own = self.run.room as u32 + 1;
        // Where the glimpse begins; it is none if that is wider than a door.
        let (mut from, mut to) = (f64::MAX, f64::MIN);
        let narrow = |c: usize| {
            if out(c) < begin + 1.5 * resolution {
                (from, to) = (from.min(aside(c)), to.max(aside(c)));
            }
            to - from <= self.max_door
        };
        let cells = flood.run(&self.run.cells, |i| self.field.label[i] == own && out(i) > begin, narrow)?;
        let walls = |range| self.lines.covered(self.run.room, side, line * side.sense(), range) >= JAMB;
        (to >= from && walls([from - BESIDE, from]) && walls([to, to + BESIDE])).then_some(cells)
    }
}
