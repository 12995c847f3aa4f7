//! Openings that a document states: where one room ends and the next begins, and nowhere else.
//!
//! The free space is cut along each of them, from wall to wall. What is connected then is a chamber: no room reaches
//! from one into another, and the basins of one are a room unless an opening within it, which ends short of a wall,
//! parts them. So the rooms are those of the cells as they are: an opening that was built over parts nothing, and a wall
//! that was drawn anew does.

use super::doors::{self, Line};
use super::space::Space;
use super::watershed::Basins;
use planform_sdk::{Segment, StatedOpening};
use std::collections::BTreeMap;

/// An opening that ends in no wall is cut this much farther, cells: it may end at another one.
const FARTHER: f64 = 2.0;

/// What stated openings make of a space.
pub struct Chambers {
    /// The openings as lines of cells.
    lines: Vec<Line>,
    /// Whether each cell lies on one.
    pub on_line: Vec<bool>,
    /// The chamber of each free cell on no opening.
    chamber: Vec<u32>,
}

/// What stated openings make of basins.
pub struct Stated {
    /// The chamber of each basin, by its number.
    pub chambers: Vec<u32>,
    /// Metres of opening between two basins, the smaller first.
    pub between: BTreeMap<(u32, u32), f64>,
}

impl Chambers {
    /// Cuts a space along openings, in metres from the grid's corner.
    pub fn of(space: &Space, openings: &[StatedOpening]) -> Self {
        let lines: Vec<Line> = openings.iter().filter_map(|o| line(space, &o.segment)).collect();
        let mut on_line = vec![false; space.free.len()];
        for i in lines.iter().flat_map(|line| line.cells(space)) {
            on_line[i] = space.free[i];
        }
        let bits = space.free.iter().zip(&on_line).map(|(free, on)| *free && !on).collect();
        let chamber = space.mask(bits).components(true).label;
        Self { lines, on_line, chamber }
    }

    /// Gives every cell on an opening to the basin on its side of the line: so rooms end where it is stated, not a cell
    /// beside.
    pub fn share_out(&self, space: &Space, label: &mut [u32]) {
        for line in &self.lines {
            for i in line.cells(space).filter(|&i| self.on_line[i]) {
                let basin =
                    line.aside(space, i).find(|&j| !self.on_line[j] && label[j] != 0).map(|j| label[j]);
                label[i] = basin.unwrap_or(label[i]);
            }
        }
    }

    /// What the openings make of the basins that no opening lies in.
    pub fn of_basins(&self, space: &Space, basins: &Basins) -> Stated {
        let mut chambers = vec![0; basins.count as usize + 1];
        for (i, &basin) in basins.label.iter().enumerate().filter(|(i, _)| !self.on_line[*i]) {
            chambers[basin as usize] = self.chamber[i];
        }
        Stated { chambers, between: doors::beside(space, &basins.label, &self.lines) }
    }
}

/// The line of an opening, if any of it lies in the space and is free.
fn line(space: &Space, opening: &Segment) -> Option<Line> {
    let [a, b] = [opening.a, opening.b].map(|p| space.cell(p));
    let most = (space.width + space.height) as f64;
    let is_near = [a, b].iter().all(|p| p.x.abs() <= 2.0 * most && p.y.abs() <= 2.0 * most);
    let line = Line::between(a, b).filter(|_| is_near)?;
    let inside = line.cells(space).any(|i| space.free[i]);
    inside.then(|| line.lengthened(space, 0.0, FARTHER))
}

#[cfg(test)]
mod tests {
    use super::super::super::shown::Shown;
    use super::super::merge::{self, Merge};
    use super::super::model::Model;
    use super::super::space::tests::space;
    use super::super::{Cut, regions::Region};
    use super::*;
    use planform_sdk::OpeningKind;

    /// The areas of the rooms of a hall of 8 x 4 m at 0.1 m, with a wall at 4 m but for a door of 1 m if it has one.
    fn rooms(walled: bool, openings: Option<Vec<StatedOpening>>) -> Vec<f64> {
        let wall = |r: usize, c: usize| walled && c == 40 && !(10..20).contains(&r);
        let row = |r: usize| (0..80).map(|c| if wall(r, c) { '#' } else { '.' }).collect::<String>();
        let rows: Vec<String> = (0..40).rev().map(row).collect();
        let space = space(&rows.iter().map(String::as_str).collect::<Vec<_>>(), 0.1);
        let cut = Cut::of_shown(space, &Shown { openings, ..Shown::default() });
        let view = cut.view();
        let mut regions = cut.regions(&view);
        merge::rooms(&mut regions, &Model::default(), &Merge::default());
        let area = |(_, r): (u32, &Region)| (r.area * 10.0).round() / 10.0;
        let mut areas: Vec<f64> = regions.all().map(area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    fn opening(from: [f64; 2], to: [f64; 2]) -> StatedOpening {
        let segment = Segment::new(from.into(), to.into());
        StatedOpening { kind: OpeningKind::Passage, segment, depth: Some(0.0) }
    }

    #[test]
    fn rooms_end_at_an_opening_as_wide_as_they_are() {
        assert_eq!(rooms(false, None), [32.0]);
        assert_eq!(rooms(false, Some(vec![opening([2.0, 0.0], [2.0, 4.0])])), [8.0, 24.0]);
        // At a slant, and up to another opening in the midst of the floor.
        let both = vec![opening([2.0, 0.0], [4.0, 4.0]), opening([3.0, 2.0], [8.0, 2.0])];
        let parts = rooms(false, Some(both));
        assert!(parts.len() == 3 && (parts.iter().sum::<f64>() - 32.0).abs() < 0.2, "{parts:?}");
    }

    #[test]
    fn where_none_is_stated_no_room_ends() {
        assert_eq!(rooms(true, None).len(), 2);
        assert_eq!(rooms(true, Some(vec![])).len(), 1);
    }

    #[test]
    fn openings_that_lie_in_no_floor_part_nothing() {
        let door = opening([4.05, 1.0], [4.05, 2.0]);
        let parted = rooms(true, Some(vec![door]));
        assert_eq!(parted.len(), 2);
        let none = [
            opening([4.05, 2.5], [4.05, 3.5]),
            opening([50.0, 1.0], [50.0, 2.0]),
            opening([1.0, 1.0], [1.0, 1.0]),
            opening([f64::NAN, 1.0], [2.0, 1.0]),
            opening([1.0, 1.0], [1e300, 1.0]),
            opening([-1e9, 1.0], [1e9, 1.0]),
        ];
        assert_eq!(rooms(true, Some([&[door][..], &none].concat())), parted);
    }

    #[test]
    fn both_sides_of_an_opening_that_ends_in_the_midst_are_two_rooms() {
        assert_eq!(rooms(true, Some(vec![opening([4.05, 1.3], [4.05, 1.7])])).len(), 2);
    }
}
