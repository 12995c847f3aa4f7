//! What a document shows, in the free space: it is cut along each door, and the regions on the two sides of one are told,
//! and those that something is written in.

use super::super::doors::Door;
use super::space::Space;
use planform_sdk::Point;
use std::collections::{BTreeMap, BTreeSet};

/// A door's line goes on beyond its jambs to the wall, which is no farther than this, metres.
const BEYOND: f64 = 0.4;

/// Wall this far beside the line is the door's as well: symbols are a little turned. Metres.
const LEANING: f64 = 0.2;

/// Cells whose centre is no farther than this from a line are on it: none of their neighbours lie on both sides.
const HALF: f64 = 0.75;

/// Regions to a door's sides are looked for this far from its line, cells.
const ASIDE: f64 = 1.5;

/// A door as a line of cells: columns and rows of cell centres.
pub struct Line {
    from: Point,
    along: Point,
    length: f64,
}

impl Line {
    /// From wall to wall along a door; none where no wall is near its jambs: what was taken for a door parts nothing.
    fn of(door: &Door, space: &Space) -> Option<Self> {
        let [a, b] = [door.segment.a, door.segment.b].map(|p| space.cell(p));
        let inside = Self::between(a, b).filter(|line| line.cells(space).any(|i| space.free[i]))?;
        let before = inside.wall(space, 0.0, -1.0, LEANING)?;
        let after = inside.wall(space, inside.length, 1.0, LEANING)?;
        Some(inside.extended(before, after))
    }

    /// From one place to another one, in cells.
    pub fn between(a: Point, b: Point) -> Option<Self> {
        let length = a.distance(b);
        let along = Point::new((b.x - a.x) / length, (b.y - a.y) / length);
        (length.is_finite() && length > 0.0).then_some(Self { from: a, along, length })
    }

    /// The same up to the walls near its ends that stand no farther aside than this, metres; or by some cells where
    /// there is none.
    pub fn lengthened(&self, space: &Space, leaning: f64, otherwise: f64) -> Self {
        let before = self.wall(space, 0.0, -1.0, leaning).unwrap_or(otherwise);
        self.extended(before, self.wall(space, self.length, 1.0, leaning).unwrap_or(otherwise))
    }

    fn extended(&self, before: f64, after: f64) -> Self {
        Self { from: self.at(-before, 0.0), along: self.along, length: before + self.length + after }
    }

    /// How far it is from a place on the line to the wall, in one sense of the line; cells.
    fn wall(&self, space: &Space, at: f64, sense: f64, leaning: f64) -> Option<f64> {
        let [most, aside] = [BEYOND, leaning].map(|metres| metres / space.resolution);
        let is_wall = |t: f64| {
            [0.0, -aside, -aside / 2.0, aside / 2.0, aside].into_iter().any(|left| {
                let p = self.at(at + sense * t, left);
                space.index(p.x, p.y).is_none_or(|i| !space.free[i])
            })
        };
        (0..=(2.0 * most) as usize).map(|k| k as f64 / 2.0).find(|&t| is_wall(t))
    }

    fn at(&self, along: f64, left: f64) -> Point {
        let Point { x, y } = self.along;
        Point::new(self.from.x + along * x - left * y, self.from.y + along * y + left * x)
    }

    /// On which side of the line a cell lies, and the cells beside it on that side, the nearest first.
    pub fn aside(&self, space: &Space, i: usize) -> impl Iterator<Item = usize> {
        let (x, y) = ((i % space.width) as f64, (i / space.width) as f64);
        let Point { x: dx, y: dy } = self.along;
        let left = (y - self.from.y) * dx - (x - self.from.x) * dy;
        let sense = if left > 0.0 { 1.0 } else { -1.0 };
        let steps = (1..=6).map(move |k| sense * f64::from(k) / 2.0);
        steps.filter_map(move |t| space.index(x - t * dy, y + t * dx))
    }

    /// The cells on the line that lie in the space; some come twice.
    pub fn cells(&self, space: &Space) -> impl Iterator<Item = usize> {
        let across = [-HALF, -HALF / 2.0, 0.0, HALF / 2.0, HALF];
        let steps = (0..=(2.0 * self.length).ceil() as usize).map(|k| (k as f64 / 2.0).min(self.length));
        let places = steps.flat_map(move |along| across.map(|left| self.at(along, left)));
        places.filter_map(|p| space.index(p.x, p.y))
    }
}

/// Which free cells lie on doors; nothing if there are none.
pub fn cells(space: &Space, doors: &[Door]) -> Vec<bool> {
    let lines: Vec<Line> = doors.iter().filter_map(|d| Line::of(d, space)).collect();
    if lines.is_empty() {
        return Vec::new();
    }
    let mut on_door = vec![false; space.free.len()];
    for i in lines.iter().flat_map(|line| line.cells(space)) {
        on_door[i] = space.free[i];
    }
    on_door
}

/// Metres of door between each two labels, the smaller first.
pub fn between(space: &Space, label: &[u32], doors: &[Door]) -> BTreeMap<(u32, u32), f64> {
    let lines: Vec<Line> = doors.iter().filter_map(|d| Line::of(d, space)).collect();
    beside(space, label, &lines)
}

/// Metres of line between each two labels, the smaller first.
pub fn beside(space: &Space, label: &[u32], lines: &[Line]) -> BTreeMap<(u32, u32), f64> {
    let mut found = BTreeMap::new();
    for line in lines {
        let side = |along: f64, left: f64| {
            let p = line.at(along, left);
            space.index(p.x, p.y).map_or(0, |i| label[i])
        };
        for along in (0..line.length as usize).map(|k| k as f64 + 0.5) {
            let [left, right] = [side(along, ASIDE), side(along, -ASIDE)];
            if left != 0 && right != 0 && left != right {
                *found.entry((left.min(right), left.max(right))).or_default() += space.resolution;
            }
        }
    }
    found
}

/// The labels in which these points lie.
pub fn under(space: &Space, label: &[u32], points: &[Point]) -> BTreeSet<u32> {
    let at = |p: &Point| {
        let p = space.cell(*p);
        space.index(p.x, p.y).map(|i| label[i]).filter(|&l| l != 0)
    };
    points.iter().filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::shown::Shown;
    use super::super::merge::{self, Merge};
    use super::super::model::Model;
    use super::super::space::tests::space;
    use super::super::{Cut, regions::Regions};
    use super::*;
    use planform_sdk::Segment;

    /// A hall of 8 x 4 m at 0.1 m with `wall` at 4 m, open from 1 m to `top` m.
    fn hall(top: usize) -> Space {
        let row = |r: usize| {
            let wall = !(10..top * 10).contains(&r);
            (0..80).map(|c| if wall && c == 40 { '#' } else { '.' }).collect::<String>()
        };
        let rows: Vec<String> = (0..40).rev().map(row).collect();
        space(&rows.iter().map(String::as_str).collect::<Vec<_>>(), 0.1)
    }

    /// A door from (x, 1) to (x, top); the test's spaces begin at the map's corner.
    fn door(x: f64, top: f64) -> Door {
        Door { segment: Segment::new(Point::new(x, 1.0), Point::new(x, top)), thickness: 0.1 }
    }

    fn shown(doors: &[Door]) -> Shown {
        Shown { doors: doors.to_vec(), ..Shown::default() }
    }

    fn rooms(space: Space, doors: &[Door]) -> usize {
        let cut = Cut::of_shown(space, &shown(doors));
        let view = cut.view();
        let mut regions = cut.regions(&view);
        merge::rooms(&mut regions, &Model::default(), &Merge::default());
        regions.all().count()
    }

    #[test]
    fn a_door_parts_what_would_be_one_room() {
        assert_eq!(rooms(hall(4), &[]), 1);
        assert_eq!(rooms(hall(4), &[door(4.05, 4.0)]), 2);
        // Turned by some degrees, and short of the jambs.
        let leaning = Segment::new(Point::new(3.9, 1.2), Point::new(4.2, 3.8));
        assert_eq!(rooms(hall(4), &[Door { segment: leaning, thickness: 0.1 }]), 2);
    }

    /// Six rooms of 2.5 x 3 m in a row at 0.1 m, doors of 1 m in all walls between them but the last.
    fn row() -> (Space, Vec<Door>) {
        let wall = |r: usize, c: usize| c % 26 == 25 && !(10..20).contains(&r);
        let line = |r: usize| (0..155).map(|c| if wall(r, c) { '#' } else { '.' }).collect::<String>();
        let rows: Vec<String> = (0..30).rev().map(line).collect();
        let space = space(&rows.iter().map(String::as_str).collect::<Vec<_>>(), 0.1);
        (space, (1..5).map(|k| door(2.6 * f64::from(k) - 0.05, 2.0)).collect())
    }

    #[test]
    fn what_is_beyond_a_gap_without_a_door_is_likely_a_piece_unless_both_are_named() {
        let doors = row().1;
        let at = |x: f64| Point::new(x, 1.5);
        let likely = |labels: Vec<Point>, doors: &[Door], a: f64, b: f64| {
            let cut = Cut::of_shown(row().0, &Shown { doors: doors.to_vec(), labels, openings: None });
            let view = cut.view();
            let [a, b] = [a, b].map(|x| under(&cut.space, &cut.basins.label, &[at(x)]));
            cut.regions(&view).likely_one(*a.first().unwrap(), *b.first().unwrap())
        };
        assert!(likely(vec![], &doors, 11.7, 14.3));
        assert!(likely(vec![at(11.7)], &doors, 11.7, 14.3));
        assert!(!likely(vec![at(11.7), at(14.3)], &doors, 11.7, 14.3));
        assert!(!likely(vec![], &doors, 1.2, 3.8), "there is a door between them");
        assert!(!likely(vec![], &doors[..2], 11.7, 14.3), "too few doors are shown");
    }

    #[test]
    fn a_place_that_is_written_in_is_told() {
        let cut = Cut::of_shown(hall(2), &shown(&[door(4.05, 2.0)]));
        let points = [Point::new(2.0, 2.0), Point::new(2.5, 2.5), Point::new(-3.0, 1.0)];
        let found = under(&cut.space, &cut.basins.label, &points);
        assert_eq!(found.len(), 1);
        assert_eq!(
            under(&cut.space, &cut.basins.label, &[Point::new(6.0, 2.0)]).intersection(&found).count(),
            0
        );
    }

    #[test]
    fn a_door_that_does_not_reach_from_wall_to_wall_divides_nothing() {
        let free = Door { segment: Segment::new(Point::new(2.0, 1.6), Point::new(2.0, 2.4)), thickness: 0.1 };
        assert_eq!(rooms(hall(4), &[free]), 1);
    }

    #[test]
    fn doors_outside_of_the_free_space_change_nothing() {
        let cut = |doors: &[Door]| Cut::of_shown(hall(2), &shown(doors)).basins.label;
        for x in [-50.0, 1e8, f64::NAN] {
            assert_eq!(cut(&[door(x, 2.0)]), cut(&[]));
        }
    }

    #[test]
    fn every_free_cell_keeps_a_basin() {
        let cut = Cut::of_shown(hall(2), &shown(&[door(4.05, 2.0)]));
        assert!(cut.basins.label.iter().zip(&cut.space.free).all(|(l, free)| (*l != 0) == *free));
        let view = cut.view();
        let regions = Regions::of_basins(&view, &cut.basins);
        assert!(regions.pairs().iter().all(|&(a, b)| !regions.door(a, b)));
    }
}
