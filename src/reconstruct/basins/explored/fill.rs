//! The unseen cells of a room behind a frontier.

use super::extend::Extent;
use super::field::{Field, Shown};
use super::flood::Flood;
use super::frontier::Run;

/// The unknown cells in the box that hang together with the frontier, at least a wall away from other rooms.
pub fn behind(field: &Field<'_>, run: &Run, extent: &Extent, wall: f64, flood: &mut Flood) -> Vec<usize> {
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
    let at = |i: usize| ((i % width) as i64, (i / width) as i64);
    let unknown = |i: usize| field.cell(at(i).0, at(i).1) == Shown::Unknown;
    let may = |i| unknown(i) && inside(i) && parted(at(i));
    let mut found = flood.run(&run.cells, may, |_| true).unwrap_or_default();
    found.retain(|c| run.cells.binary_search(c).is_err());
    found
}
