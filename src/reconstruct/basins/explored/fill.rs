//! The unseen cells of a room behind a frontier.

use super::extend::Extent;
use super::field::{Field, Shown};
use super::frontier::Run;
use std::collections::BTreeSet;

/// The unknown cells in the box that hang together with the frontier, at least a wall away from other rooms.
pub fn behind(field: &Field<'_>, run: &Run, extent: &Extent, wall: f64) -> Vec<usize> {
    let width = field.input.free.width();
    let wall = (wall / field.input.resolution).round().max(1.0) as i64;
    let own = run.room as u32 + 1;
    let inside = |cell: usize| {
        let place = field.middle(cell);
        (0..2).all(|axis| place[axis] > extent.low[axis] && place[axis] < extent.high[axis])
    };
    let parted = |(c, r): (i64, i64)| {
        let other = |c, r| matches!(field.cell(c, r), Shown::Room(l) if l != own);
        !(-wall..=wall).any(|dy| (-wall..=wall).any(|dx| other(c + dx, r + dy)))
    };
    let mut found = BTreeSet::new();
    let mut open = run.cells.clone();
    while let Some(at) = open.pop() {
        let (c, r) = ((at % width) as i64, (at / width) as i64);
        for (x, y) in [(c + 1, r), (c - 1, r), (c, r + 1), (c, r - 1)] {
            let Some(i) = field.input.free.index(x, y) else { continue };
            if field.cell(x, y) == Shown::Unknown && inside(i) && !found.contains(&i) && parted((x, y)) {
                found.insert(i);
                open.push(i);
            }
        }
    }
    found.into_iter().collect()
}
