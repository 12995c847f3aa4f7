//! Rooms of which something was seen through a door.
//!
//! Such a glimpse is a narrow fan of cells that hangs together with the room from which it was seen. It is another
//! room's if it lies beyond the line of a wall that stands on both sides of the way there.

use super::super::super::straight::Labelled;
use super::Explored;
use super::field::{Field, Side};
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
    params: &Explored,
) -> usize {
    let mut rooms = input.rooms;
    for run in runs {
        let Some(lines) = lines::sharpest(lines, run.room) else { continue };
        let field = Field { input, label, frame: lines.frame };
        let looks = Glimpses { field: &field, run, lines, max_door: params.door };
        let Some(cells) = looks.find() else { continue };
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
    fn find(&self) -> Option<Vec<usize>> {
        let own = self.run.room as u32 + 1;
        if self.run.cells.iter().any(|&c| self.field.label[c] != own) {
            return None;
        }
        Side::ALL.into_iter().find_map(|side| self.beyond(side))
    }

    /// The cells beyond the nearest wall line on a side that has a door there.
    fn beyond(&self, side: Side) -> Option<Vec<usize>> {
        let out = |c: usize| self.field.middle(c)[side.axis] * side.sense();
        let first = self.run.cells.iter().map(|&c| out(c)).fold(f64::MAX, f64::min);
        let aside: Vec<f64> = self.run.cells.iter().map(|&c| self.field.middle(c)[1 - side.axis]).collect();
        let (low, high) = aside.iter().fold((f64::MAX, f64::MIN), |(l, h), &v| (l.min(v), h.max(v)));
        let around = [low - BESIDE - self.max_door, high + BESIDE + self.max_door];
        let line = self.lines.own(self.run.room, side, first, around)?;
        let resolution = self.field.input.resolution;
        let cells = self.cells(|c| out(c) > line + BEYOND.max(resolution));
        let way = |c: &&usize| out(**c) < line + BEYOND.max(resolution) + 1.5 * resolution;
        let places = cells.iter().filter(way).map(|&c| self.field.middle(c)[1 - side.axis]);
        let (from, to) = places.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        let walls = |range| self.lines.covered(self.run.room, side, line * side.sense(), range) >= JAMB;
        let door = to >= from && to - from <= self.max_door;
        (door && walls([from - BESIDE, from]) && walls([to, to + BESIDE])).then_some(cells)
    }

    /// The room's cells for which `is` holds that hang together with the frontier.
    fn cells(&self, is: impl Fn(usize) -> bool) -> Vec<usize> {
        let own = self.run.room as u32 + 1;
        let found = self.field.flood(&self.run.cells, |i| self.field.label[i] == own && is(i));
        found.into_iter().collect()
    }
}
