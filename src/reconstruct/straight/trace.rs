//! The borders of a room's cells.

use super::super::raster::{Components, Mask};
use super::{Labelled, Straight};
use planform_sdk::Point;

/// The cells of a room, in a mask of its own around them.
#[derive(Debug, Clone)]
pub struct Cells {
    /// Column and row of the mask's lower left cell.
    pub corner: (i64, i64),
    /// The cells, with an unset border of one cell.
    pub mask: Mask,
}

/// A closed walk along the border of cells, one point for each cell's side; the room is to the left.
pub type Ring = Vec<(i64, i64)>;

/// The lowest and highest column and row of each label.
pub fn boxes(input: &Labelled<'_>, label: &[u32]) -> Vec<Option<[i64; 4]>> {
    let mut boxes: Vec<Option<[i64; 4]>> = vec![None; input.rooms];
    for (i, &l) in label.iter().enumerate() {
        let Some(found) = (l as usize).checked_sub(1).and_then(|r| boxes.get_mut(r)) else { continue };
        let (c, r) = ((i % input.width()) as i64, (i / input.width()) as i64);
        let b = found.get_or_insert([c, r, c, r]);
        *b = [b[0].min(c), b[1].min(r), b[2].max(c), b[3].max(r)];
    }
    boxes
}

impl Cells {
    /// The largest connected part of a room's cells, without small holes, such that no two cells touch only at a
    /// corner. `label` may have fewer cells in rooms than the input: what another room of the input has is not filled.
    pub fn of(
        input: &Labelled<'_>,
        label: &[u32],
        room: usize,
        [left, low, right, high]: [i64; 4],
        params: &Straight,
    ) -> Self {
        let corner = (left - 1, low - 1);
        let (width, height) = ((right - left + 3) as usize, (high - low + 3) as usize);
        let at = |i: usize| (corner.0 + (i % width) as i64, corner.1 + (i / width) as i64);
        let is = |i: usize| input.room(label, at(i).0, at(i).1) as usize == room + 1;
        let mask = largest(&Mask::new(width, height, (0..width * height).map(is).collect()));
        let taken = |i: usize| {
            let l = input.room(input.label, at(i).0, at(i).1) as usize;
            l != 0 && l != room + 1
        };
        let most = (params.min_hole / (input.resolution * input.resolution)) as usize;
        let mask = largest(&cut_saddles(&fill(&mask, most, taken)));
        Self { corner, mask }
    }

    /// The rings around the cells: one counter-clockwise, then clockwise ones around holes.
    pub fn rings(&self) -> Vec<Ring> {
        let mut seen = vec![false; self.mask.bits().len()];
        let mut rings = Vec::new();
        for (c, r) in self.mask.cells() {
            let start = (c as i64, r as i64);
            if !self.mask.get(start.0, start.1 - 1) && !seen[r * self.mask.width() + c] {
                rings.push(self.follow(start, &mut seen));
            }
        }
        rings
    }

    /// Follows the border from the lower left corner of a cell with none below.
    fn follow(&self, start: (i64, i64), seen: &mut [bool]) -> Ring {
        let mut ring = Vec::new();
        let mut at = start;
        loop {
            ring.push((at.0 + self.corner.0, at.1 + self.corner.1));
            let (dx, dy) = self.step(at);
            if let Some(i) = self.mask.index(at.0, at.1).filter(|_| dx == 1) {
                seen[i] = true;
            }
            at = (at.0 + dx, at.1 + dy);
            if at == start {
                return ring;
            }
        }
    }

    /// The step from a corner along the border with the cells to the left. No two cells touch only at a corner, so
    /// there is one.
    fn step(&self, (x, y): (i64, i64)) -> (i64, i64) {
        let set = |dx: i64, dy: i64| self.mask.get(x + dx, y + dy);
        let (sw, se, nw, ne) = (set(-1, -1), set(0, -1), set(-1, 0), set(0, 0));
        if ne && !se {
            (1, 0)
        } else if nw && !ne {
            (0, 1)
        } else if sw && !nw {
            (-1, 0)
        } else {
            (0, -1)
        }
    }
}

/// The largest component of cells that touch by their sides; of equal ones the first.
fn largest(mask: &Mask) -> Mask {
    let parts = mask.components(false);
    let best = (0..parts.sizes.len()).rev().max_by_key(|&i| parts.sizes[i]);
    let keep = parts.label.iter().map(|&l| l != Components::NONE && Some(l as usize) == best);
    mask.with_bits(keep.collect())
}

/// Fills holes of at most this many cells in which no cell is taken.
fn fill(mask: &Mask, most: usize, taken: impl Fn(usize) -> bool) -> Mask {
    let outside = mask.with_bits(mask.bits().iter().map(|b| !b).collect());
    let holes = outside.components(true);
    // The mask's border is unset: the first component is the outside.
    let mut keep: Vec<bool> = holes.sizes.iter().map(|&size| size > most).collect();
    if let Some(first) = keep.first_mut() {
        *first = true;
    }
    for (i, &hole) in holes.label.iter().enumerate() {
        if hole != Components::NONE && !keep[hole as usize] && taken(i) {
            keep[hole as usize] = true;
        }
    }
    let set = |(i, &b): (usize, &bool)| b || !keep[holes.label[i] as usize];
    mask.with_bits(mask.bits().iter().enumerate().map(set).collect())
}

/// Unsets one of every two cells that touch only at a corner.
fn cut_saddles(mask: &Mask) -> Mask {
    let mut bits = mask.bits().to_vec();
    let mut open: Vec<usize> = (0..bits.len()).rev().collect();
    while let Some(i) = open.pop() {
        let (c, r) = ((i % mask.width()) as i64, (i / mask.width()) as i64);
        let square = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| mask.index(c + dx, r + dy));
        let [Some(a), Some(b), Some(d), Some(e)] = square else { continue };
        let cut = match [bits[a], bits[b], bits[d], bits[e]] {
            [true, false, false, true] => e,
            [false, true, true, false] => d,
            _ => continue,
        };
        bits[cut] = false;
        let (c, r) = ((cut % mask.width()) as i64, (cut / mask.width()) as i64);
        open.extend(
            [(-1, -1), (0, -1), (-1, 0), (0, 0)].iter().filter_map(|(x, y)| mask.index(c + x, r + y)),
        );
    }
    mask.with_bits(bits)
}

/// A corner of cells as a point, metres.
pub fn corner_point((x, y): (i64, i64), resolution: f64) -> Point {
    Point::new(x as f64 * resolution, y as f64 * resolution)
}

/// The cell to the right of a step along a border: what lies beyond.
pub fn beyond(from: (i64, i64), to: (i64, i64)) -> (i64, i64) {
    match (to.0 - from.0, to.1 - from.1) {
        (1, _) => (from.0, from.1 - 1),
        (_, 1) => (from.0, from.1),
        (-1, _) => (from.0 - 1, from.1),
        _ => (from.0 - 1, from.1 - 1),
    }
}
