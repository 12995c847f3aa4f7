//! The borders of a room's cells.

use super::super::raster::Mask;
use super::super::runs::{Parts, label_runs, runs};
use super::{Labelled, Straight};
use planform_sdk::Point;

/// The cells of a room, in a mask of its own around them.
#[derive(Debug, Clone)]
pub struct Cells {
    /// Column and row of the mask's lower left cell.
    pub corner: (i64, i64),
    /// The cells, with an unset border of one cell; no two touch only at a corner.
    pub mask: Mask,
}

/// A closed walk along the border of cells, one point for each cell's side; the room is to the left.
pub type Ring = Vec<(i64, i64)>;

/// The lowest and highest column and row of each label.
pub fn boxes(input: &Labelled<'_>, label: &[u32]) -> Vec<Option<[i64; 4]>> {
    let mut boxes: Vec<Option<[i64; 4]>> = vec![None; input.rooms];
    for (row, cells) in label.chunks_exact(input.width().max(1)).enumerate() {
        for (run, label) in label_runs(cells) {
            let (from, to) = (run.start as i64, run.end as i64 - 1);
            let Some(found) = (label as usize).checked_sub(1).and_then(|r| boxes.get_mut(r)) else {
                continue;
            };
            let row = row as i64;
            let b = found.get_or_insert([from, row, to, row]);
            *b = [b[0].min(from), b[1].min(row), b[2].max(to), b[3].max(row)];
        }
    }
    boxes
}

impl Cells {
    /// All cells of a room but those that touch others only at a corner. The box is that of the room in `label`.
    pub fn all(input: &Labelled<'_>, label: &[u32], room: usize, around: [i64; 4]) -> Self {
        let [left, low, right, high] = around.map(|v| v as usize);
        let (width, height) = (right - left + 3, high - low + 3);
        let mut bits = vec![false; width * height];
        for row in low..=high {
            let cells = &label[row * input.width() + left..=row * input.width() + right];
            let begin = (row - low + 1) * width + 1;
            for (bit, &l) in bits[begin..].iter_mut().zip(cells) {
                *bit = l as usize == room + 1;
            }
        }
        cut_saddles(&mut bits, width);
        Self { corner: (around[0] - 1, around[1] - 1), mask: Mask::new(width, height, bits) }
    }

    /// The largest connected part of a room's cells, without small holes. `label` may have fewer cells in rooms than
    /// the input: a hole with cells of another room of the input is not filled.
    /// With the rings around them.
    pub fn of(
        input: &Labelled<'_>,
        label: &[u32],
        room: usize,
        around: [i64; 4],
        params: &Straight,
    ) -> (Self, Vec<Ring>) {
        let all = Self::all(input, label, room, around);
        let cells = Self { mask: largest(&all.mask), ..all };
        let rings = cells.rings();
        if rings.len() < 2 {
            return (cells, rings);
        }
        let taken = |i: usize| {
            let (c, r) = ((i % cells.mask.width()) as i64, (i / cells.mask.width()) as i64);
            let l = input.room(input.label, c + cells.corner.0, r + cells.corner.1) as usize;
            l != 0 && l != room + 1
        };
        let most = (params.min_hole / (input.resolution * input.resolution)) as usize;
        let filled = Self { mask: fill(&cells.mask, most, taken), ..cells };
        let rings = filled.rings();
        (filled, rings)
    }

    /// The rings around the cells: one counter-clockwise, then clockwise ones around holes.
    pub fn rings(&self) -> Vec<Ring> {
        let (width, bits) = (self.mask.width(), self.mask.bits());
        let mut seen = vec![false; bits.len()];
        let mut rings = Vec::new();
        for run in self.mask.runs() {
            // The mask's border is unset: there is a row below.
            let below = (run.row - 1) * width;
            let bare = runs(&bits[below + run.from..below + run.to], run.length(), false);
            for i in bare.flat_map(|gap| gap.from..gap.to).map(|k| run.row * width + run.from + k) {
                if !seen[i] {
                    rings.push(self.follow(((i - run.row * width) as i64, run.row as i64), &mut seen));
                }
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
    let parts = Parts::of(mask.bits(), mask.width(), true, false);
    let Some(best) = (0..parts.sizes.len()).rev().max_by_key(|&i| parts.sizes[i]) else {
        return mask.clone();
    };
    let mut bits = vec![false; mask.bits().len()];
    for (run, _) in parts.runs.iter().filter(|(_, part)| *part as usize == best) {
        bits[run.cells(mask.width())].fill(true);
    }
    mask.with_bits(bits)
}

/// Fills holes of at most this many cells in which no cell is taken.
fn fill(mask: &Mask, most: usize, taken: impl Fn(usize) -> bool) -> Mask {
    let holes = Parts::of(mask.bits(), mask.width(), false, true);
    // The mask's border is unset: the first component is the outside.
    let mut keep: Vec<bool> = holes.sizes.iter().map(|&size| size > most).collect();
    if let Some(first) = keep.first_mut() {
        *first = true;
    }
    for (run, hole) in &holes.runs {
        let keep = &mut keep[*hole as usize];
        *keep = *keep || run.cells(mask.width()).any(&taken);
    }
    let mut bits = mask.bits().to_vec();
    for (run, _) in holes.runs.iter().filter(|(_, hole)| !keep[*hole as usize]) {
        bits[run.cells(mask.width())].fill(true);
    }
    mask.with_bits(bits)
}

/// Unsets one of every two cells that touch only at a corner, and of those that do then. The border is unset.
fn cut_saddles(bits: &mut [bool], width: usize) {
    let saddle = |bits: &[bool], i: usize| {
        let (a, b, c, d) = (bits[i], bits[i + 1], bits[i + width], bits[i + width + 1]);
        (a == d && b == c && a != b).then_some(if a { i + width + 1 } else { i + width })
    };
    let mut open = vec![];
    for first in (0..bits.len() - width).step_by(width) {
        // What is cut lies in the row above, so this one stays as it is.
        let row = runs(&bits[first..first + width], width, true);
        let ends: Vec<usize> = row.flat_map(|run| [first + run.from - 1, first + run.to - 1]).collect();
        for start in ends {
            open.extend(saddle(bits, start));
            while let Some(cut) = open.pop() {
                bits[cut] = false;
                let around = [cut - width - 1, cut - width, cut - 1, cut];
                open.extend(around.into_iter().filter(|&i| i <= start).filter_map(|i| saddle(bits, i)));
            }
        }
    }
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
