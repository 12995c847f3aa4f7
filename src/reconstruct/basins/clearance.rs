//! The clearance of every free cell: how far the nearest cell is that is not free, and which one that is.
//!
//! An exact Euclidean distance transform in two passes (Meijster, Roerdink and Hesselink, "A General Algorithm for
//! Computing Distance Transforms in Linear Time", 2000).

use super::super::runs::{Run, runs};
use super::super::straight::floor;
use super::space::Space;

/// The clearance of the free space.
pub struct Clearance {
    /// Metres from each cell's middle to that of the nearest cell that is not free; 0 for such cells.
    pub metres: Vec<f32>,
    /// Index of the nearest cell that is not free.
    pub nearest: Vec<u32>,
}

/// Measures the clearance of a space.
pub fn measure(space: &Space) -> Clearance {
    let mut below = nearest_below(space);
    let mut metres = vec![0.0; space.free.len()];
    let (width, height) = (space.width, space.height);
    let mut runs: Vec<Run> = runs(&space.free, width, true).collect();
    let mut envelope = Envelope::default();
    // From the top down, so that the row above always has its final values.
    let mut above: Vec<u32> = vec![height as u32 - 1; width];
    let mut away: Vec<f64> = vec![0.0; width];
    for row in (0..height).rev() {
        let cells = row * width..(row + 1) * width;
        nearest_in_column(row, &space.free[cells.clone()], &mut below[cells.clone()], &mut above);
        while let Some(run) = runs.pop_if(|run| run.row == row) {
            // At either end is a cell that is not free: what lies beyond is not nearer.
            let around = run.from - 1..run.to + 1;
            for (a, &r) in away[around.clone()].iter_mut().zip(&above[around.clone()]) {
                *a = (f64::from(r) - row as f64).powi(2);
            }
            envelope.build(&away[around.clone()]);
            for column in run.from..run.to {
                let (from, square) = envelope.lowest(column - around.start, &away[around.clone()]);
                let i = cells.start + column;
                metres[i] = (square.sqrt() * space.resolution) as f32;
                below[i] = above[around.start + from] * width as u32 + (around.start + from) as u32;
            }
        }
    }
    Clearance { metres, nearest: below }
}

/// For each cell the row of the nearest cell below in its column that is not free. The border of a space is not free,
/// so there always is one.
fn nearest_below(space: &Space) -> Vec<u32> {
    let width = space.width;
    let mut rows = vec![0u32; width * space.height];
    for row in 1..space.height {
        let (done, rest) = rows.split_at_mut(row * width);
        let free = &space.free[row * width..(row + 1) * width];
        for ((r, below), free) in rest.iter_mut().zip(&done[(row - 1) * width..]).zip(free) {
            *r = if *free { *below } else { row as u32 };
        }
    }
    rows
}

/// Of a row for each cell the row of the nearest cell of its column that is not free: on entry, `above` holds those of
/// the row above, and `below` the nearest ones below; they become the cells' own indices.
fn nearest_in_column(row: usize, free: &[bool], below: &mut [u32], above: &mut [u32]) {
    let first = (row * free.len()) as u32;
    let at = row as u32;
    for (column, ((a, b), free)) in above.iter_mut().zip(below).zip(free).enumerate() {
        // The row above still may name a cell beneath.
        let is_nearer = *free && *a > at && *a - at < at - *b;
        *a = if is_nearer { *a } else { *b };
        *b = first + column as u32;
    }
}

/// The lower envelope of the parabolas `away[i] + (x - i)^2`. All are whole numbers, in floating point as that divides
/// faster; they are exact up to 94 million cells.
#[derive(Default)]
struct Envelope {
    /// The parabolas of the envelope: apex, and the first column where it is the lowest.
    parts: Vec<(f64, f64)>,
    at: usize,
}

impl Envelope {
    fn build(&mut self, away: &[f64]) {
        self.parts.clear();
        self.at = 0;
        for (u, &high) in away.iter().enumerate() {
            let b = u as f64;
            while let Some(&(a, from)) = self.parts.last()
                && away[a as usize] + (from - a) * (from - a) > high + (from - b) * (from - b)
            {
                self.parts.pop();
            }
            let from = match self.parts.last() {
                None => 0.0,
                Some(&(a, _)) => {
                    let crossing = ((b - a) * (b + a) + high - away[a as usize]) / (2.0 * (b - a));
                    (floor(crossing) + 1) as f64
                }
            };
            if from < away.len() as f64 {
                self.parts.push((b, from));
            }
        }
    }

    /// The parabola that is lowest at a column, and its value there. Columns are asked for in rising order.
    fn lowest(&mut self, column: usize, away: &[f64]) -> (usize, f64) {
        let x = column as f64;
        while self.parts.get(self.at + 1).is_some_and(|p| p.1 <= x) {
            self.at += 1;
        }
        let apex = self.parts[self.at].0;
        (apex as usize, away[apex as usize] + (x - apex) * (x - apex))
    }
}

#[cfg(test)]
mod tests {
    use super::super::space::tests::space;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_is_the_distance_to_the_nearest_cell_that_is_not_free(
            bits in prop::collection::vec(prop::bool::weighted(0.8), 15 * 11)
        ) {
            let rows: Vec<String> =
                bits.chunks(15).map(|r| r.iter().map(|&b| if b { '.' } else { '#' }).collect()).collect();
            let space = space(&rows.iter().map(String::as_str).collect::<Vec<_>>(), 1.0);
            let clearance = measure(&space);
            let at = |i: usize| ((i % space.width) as f64, (i / space.width) as f64);
            let distance = |i: usize, j: usize| (at(i).0 - at(j).0).hypot(at(i).1 - at(j).1);
            for i in 0..space.free.len() {
                let walls = (0..space.free.len()).filter(|&j| !space.free[j]);
                let truth = walls.map(|j| distance(i, j)).fold(f64::MAX, f64::min);
                let nearest = clearance.nearest[i] as usize;
                prop_assert!((f64::from(clearance.metres[i]) - truth).abs() < 1e-4);
                prop_assert!(!space.free[nearest] && (distance(i, nearest) - truth).abs() < 1e-9);
            }
        }
    }
}
