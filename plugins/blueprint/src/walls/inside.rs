//! What of a drawing is inside of the building: what walls enclose once the gaps in them are closed.

use super::components::{self, Neighbours};
use super::distance;
use super::drawing::Drawing;

/// Cells in which it is found are about this large, metres.
const CELL: f64 = 0.1;

/// Gaps twice as wide as these are closed, one after the other, metres: doors first, then windows and what was cut off.
const CLOSED: [f64; 5] = [0.5, 0.8, 1.2, 1.7, 2.3];

/// What a wider closing adds is a room only if at most this share of its boundary is open,
const OPEN: f64 = 0.15;

/// and if it covers at least this, square metres.
const LEAST: f64 = 1.0;

/// For every pixel of the drawing whether it is inside, walls included.
pub fn find(drawing: &Drawing, occupied: &[bool]) -> Vec<bool> {
    let coarse = Coarse::of(drawing, occupied);
    let clear = distance::squared(&coarse.paper, coarse.width);
    let mut inside = vec![false; coarse.paper.len()];
    for radius in CLOSED {
        let closed = coarse.closed(&clear, radius * coarse.metre);
        coarse.add_enclosed(&closed, &mut inside);
    }
    let at = |i: usize| coarse.at(i % drawing.width, i / drawing.width);
    (0..occupied.len()).map(|i| occupied[i] || inside[at(i)]).collect()
}

/// The drawing in cells, with a margin of paper around it.
struct Coarse {
    paper: Vec<bool>,
    width: usize,
    height: usize,
    /// Cells per metre.
    metre: f64,
    /// Pixels of the drawing per cell.
    step: usize,
    margin: usize,
}

impl Coarse {
    fn of(drawing: &Drawing, occupied: &[bool]) -> Self {
        let step = (drawing.metre * CELL).max(1.0) as usize;
        let metre = drawing.metre / step as f64;
        let margin = (CLOSED[CLOSED.len() - 1] * metre) as usize + 2;
        let width = drawing.width.div_ceil(step) + 2 * margin;
        let height = drawing.height.div_ceil(step) + 2 * margin;
        let mut out = Self { paper: vec![true; width * height], width, height, metre, step, margin };
        for i in (0..occupied.len()).filter(|&i| occupied[i]) {
            let at = out.at(i % drawing.width, i / drawing.width);
            out.paper[at] = false;
        }
        out
    }

    /// The cell of a pixel.
    fn at(&self, x: usize, y: usize) -> usize {
        (y / self.step + self.margin) * self.width + x / self.step + self.margin
    }

    /// What a disc of this radius, in cells, cannot reach from outside. `clear`: how far cells are from what is
    /// occupied, squared.
    fn closed(&self, clear: &[u32], radius: f64) -> Vec<bool> {
        let passable: Vec<bool> = clear.iter().map(|&d| f64::from(d) > radius * radius).collect();
        let parts = components::find(&passable, self.width, Neighbours::Four);
        let outside = parts.label.first().copied().unwrap_or(0);
        let unreached: Vec<bool> = parts.label.iter().map(|&l| l != outside || l == 0).collect();
        let reach = (radius + 0.5).powi(2);
        distance::squared(&unreached, self.width).iter().map(|&d| f64::from(d) > reach).collect()
    }

    /// Adds what is closed now and has walls nearly all around.
    fn add_enclosed(&self, closed: &[bool], inside: &mut [bool]) {
        let fresh: Vec<bool> = (0..closed.len()).map(|i| closed[i] && !inside[i] && self.paper[i]).collect();
        let parts = components::find(&fresh, self.width, Neighbours::Four);
        let mut around = vec![[0usize; 2]; parts.all.len()];
        for i in (0..fresh.len()).filter(|&i| fresh[i]) {
            let beside = Neighbours::Four.of(i, self.width, self.height);
            for other in beside.filter(|&o| !(fresh[o] || inside[o] && self.paper[o])) {
                around[parts.label[i] as usize][usize::from(self.paper[other])] += 1;
            }
        }
        let least = LEAST * self.metre * self.metre;
        let is_room = |part: usize| {
            let [wall, open] = around[part];
            let enclosed = open as f64 <= OPEN * (wall + open) as f64;
            part != 0 && enclosed && parts.all[part].area as f64 >= least
        };
        let rooms: Vec<bool> = (0..parts.all.len()).map(is_room).collect();
        inside.iter_mut().zip(&parts.label).for_each(|(i, &l)| *i |= rooms[l as usize]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// A house of 8 x 6 m, its wall open to the north over this many metres; a pixel is 0.1 m.
    fn house(open: f64) -> (Drawing, Vec<bool>) {
        let mut ink = Mask::empty(120, 100);
        let gap = (40.0 - open * 5.0) as usize..(40.0 + open * 5.0) as usize;
        for x in (20..100).filter(|x| !gap.contains(&(x - 20))) {
            ink.set[20 * 120 + x] = true;
        }
        (20..100).for_each(|x| ink.set[79 * 120 + x] = true);
        (20..80).for_each(|y| {
            ink.set[y * 120 + 20] = true;
            ink.set[y * 120 + 99] = true;
        });
        let drawing = Drawing::of_sheet(&ink, 0.1);
        let inside = find(&drawing, &drawing.ink);
        (drawing, inside)
    }

    #[test]
    fn a_house_with_a_gap_has_an_inside_and_a_yard_has_none() {
        for (open, found) in [(0.0, true), (0.9, true), (2.0, true), (7.0, false)] {
            let (drawing, inside) = house(open);
            assert_eq!(inside[50 * drawing.width + 60], found, "{open}");
            assert!(!inside[5 * drawing.width + 60] && !inside[50 * drawing.width + 110]);
        }
    }
}
