//! The pixels that draw a doorway: arcs, leaves, and lines through the opening; never the wall beside it.

use super::pairs::Doorway;
use super::swing::Swing;
use super::wall::Faces;
use crate::mask::Mask;
use crate::symbols::plane::{Plane, distance, dot};
use std::ops::Range;

/// A leaf drawn as a box is no thicker than this share of its length.
const PANEL: f64 = 0.1;

/// What is thicker than this share of a leaf's length is a wall, wherever an arc seems to run.
const THICK: f64 = 0.085;

/// Thinner ink is none, pixels of the sheet: lines are blurred.
const THINNEST: f64 = 5.0;

/// An opening that so much of is wall is none.
const MOST_WALL: f64 = 0.4;

/// Adds what draws the doorway; nothing, and says so, if a wall stands in its opening.
pub fn doorway(plane: &Plane, ink: &Mask, doorway: &Doorway, wall: &Faces, erase: &mut Mask) -> bool {
    let drawn = Drawn { doorway, wall, slack: 1.0 };
    let scale = f64::from(plane.factor);
    let longest = doorway.leaves.iter().map(|l| l.radius).fold(0.0, f64::max);
    let window = window(ink, doorway.at(doorway.width / 2.0, 0.0), 2.0 * longest.max(doorway.width), scale);
    let thick = Thick::of(ink, window.clone(), (THICK * longest * scale).max(THINNEST).ceil() as u32);
    let [columns, rows] = window;
    let (mut opening, mut walled, mut found) = (0_u32, 0_u32, vec![]);
    for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
        let i = y as usize * ink.width as usize + x as usize;
        let place = [f64::from(x) + 0.5, f64::from(y) + 0.5].map(|v| v / scale);
        let (is_opening, is_wall) = (drawn.is_opening(place), thick.is_at(x, y));
        opening += u32::from(is_opening);
        walled += u32::from(is_opening && is_wall);
        if ink.set[i] && (is_opening || drawn.is_leaf(place) && !is_wall) {
            found.push(i);
        }
    }
    let is_free = f64::from(walled) <= MOST_WALL * f64::from(opening);
    found.iter().filter(|_| is_free).for_each(|&i| erase.set[i] = true);
    is_free
}

/// The columns and rows of the sheet that lie at most `reach` from a place of the plane, whose pixels are `scale` wide.
fn window(ink: &Mask, [x, y]: [f64; 2], reach: f64, scale: f64) -> [Range<u32>; 2] {
    let range = |at: f64, end: u32| {
        let clamp = |v: f64| (v * scale).clamp(0.0, f64::from(end)) as u32;
        clamp(at - reach)..clamp(at + reach)
    };
    [range(x, ink.width), range(y, ink.height)]
}

struct Drawn<'a> {
    doorway: &'a Doorway,
    wall: &'a Faces,
    slack: f64,
}

impl Drawn<'_> {
    /// How far along and across the wall a point is.
    fn place(&self, p: [f64; 2]) -> [f64; 2] {
        let from = [p[0] - self.doorway.from[0], p[1] - self.doorway.from[1]];
        [dot(from, self.doorway.along), dot(from, self.doorway.across)]
    }

    /// Whether a point lies in the opening, between the jambs and the wall's faces.
    fn is_opening(&self, p: [f64; 2]) -> bool {
        let [along, across] = self.place(p);
        let within = along > self.slack && along < self.doorway.width - self.slack;
        within && (self.wall.low - self.slack..=self.wall.high + self.slack).contains(&across)
    }

    /// Whether a point lies on a leaf or its arc, before the wall.
    fn is_leaf(&self, p: [f64; 2]) -> bool {
        let before = self.place(p)[1] > self.wall.high + self.slack;
        before && self.doorway.leaves.iter().any(|leaf| self.is_on(leaf, p))
    }

    fn is_on(&self, leaf: &Swing, p: [f64; 2]) -> bool {
        let from = [p[0] - leaf.hinge[0], p[1] - leaf.hinge[1]];
        let r = leaf.radius;
        let width = 2.0 + 0.03 * r;
        let between = dot(from, leaf.along) > -width && dot(from, leaf.across()) > 0.0;
        let arc = (distance(p, leaf.hinge) - r).abs() <= width && between && self.is_within(leaf, from);
        let (out, side) = (dot(from, leaf.into), [leaf.into[1], -leaf.into[0]]);
        // The box of a leaf lies towards the opening.
        let side = if dot(side, leaf.along) >= 0.0 { side } else { [-side[0], -side[1]] };
        let beside = dot(from, side);
        arc || (out > 0.0 && out < r + width && beside > -2.0 && beside < (PANEL * r).max(2.0))
    }

    /// Whether a direction lies between the closed and the open leaf, or hardly beyond.
    fn is_within(&self, leaf: &Swing, from: [f64; 2]) -> bool {
        let angle = |v: [f64; 2]| dot(v, leaf.across()).atan2(dot(v, leaf.along));
        angle(from) <= angle(leaf.into) + 0.1
    }
}

/// Where ink in a window of the sheet is thick: some square of a given side that is all ink covers it.
struct Thick {
    columns: Range<u32>,
    rows: Range<u32>,
    set: Vec<bool>,
}

impl Thick {
    fn of(ink: &Mask, [columns, rows]: [Range<u32>; 2], side: u32) -> Self {
        let (width, height) = (columns.len(), rows.len());
        let mut set = Vec::with_capacity(width * height);
        for y in rows.clone() {
            let start = y as usize * ink.width as usize;
            set.extend_from_slice(&ink.set[start + columns.start as usize..start + columns.end as usize]);
        }
        let corners = Self::corners(&set, width, height, side as usize);
        let set = Self::grown(&corners, width, height, side as usize);
        Self { columns, rows, set }
    }

    /// The first pixels of squares that are all set: a square is a run of runs.
    fn corners(set: &[bool], width: usize, height: usize, side: usize) -> Vec<bool> {
        let mut along = vec![0usize; set.len()];
        let mut down = vec![0usize; set.len()];
        for y in (0..height).rev() {
            for x in (0..width).rev() {
                let i = y * width + x;
                let right = if x + 1 < width { along[i + 1] } else { 0 };
                along[i] = if set[i] { right + 1 } else { 0 };
                let below = if y + 1 < height { down[i + width] } else { 0 };
                down[i] = if along[i] >= side { below + 1 } else { 0 };
            }
        }
        down.iter().map(|&run| run >= side).collect()
    }

    /// All that squares with these first pixels cover.
    fn grown(corners: &[bool], width: usize, height: usize, side: usize) -> Vec<bool> {
        let mut along = vec![0usize; corners.len()];
        let mut down = vec![0usize; corners.len()];
        for y in 0..height {
            for x in 0..width {
                let i = y * width + x;
                let left = if x > 0 { along[i - 1].saturating_sub(1) } else { 0 };
                along[i] = if corners[i] { side } else { left };
                let above = if y > 0 { down[i - width].saturating_sub(1) } else { 0 };
                down[i] = if along[i] > 0 { side } else { above };
            }
        }
        down.iter().map(|&left| left > 0).collect()
    }

    fn is_at(&self, x: u32, y: u32) -> bool {
        let (column, row) = ((x - self.columns.start) as usize, (y - self.rows.start) as usize);
        self.set[row * self.columns.len() + column]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_is_thick_and_a_line_is_not() {
        let mut ink = Mask::empty(30, 20);
        for y in 0..20 {
            for x in 0..30 {
                let (wall, line) = ((4..10).contains(&x), y == 12 || x == 20);
                ink.set[y * 30 + x] = wall || line;
            }
        }
        let thick = Thick::of(&ink, [2..28, 1..19], 5);
        let found: Vec<u32> = (2..28).filter(|&x| thick.is_at(x, 12)).collect();
        assert_eq!(found, [4, 5, 6, 7, 8, 9]);
        assert!(thick.is_at(4, 1) && thick.is_at(9, 18) && !thick.is_at(20, 5));
    }
}
