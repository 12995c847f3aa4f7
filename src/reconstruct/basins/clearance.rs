//! The clearance of every free cell: how far the nearest cell is that is not free, and which one that is.
//!
//! An exact Euclidean distance transform in two passes (Meijster, Roerdink and Hesselink, "A General Algorithm for
//! Computing Distance Transforms in Linear Time", 2000).

use super::super::runs::{Run, runs};
use super::space::Space;
use std::ops::Range;

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
            for (columns, part) in envelope.within(run.length() + 2) {
                let nearest = above[around.start + part.column] * width as u32;
                let first = cells.start + around.start;
                below[first + columns.start..first + columns.end]
                    .fill(nearest + (around.start + part.column) as u32);
                let out = metres[first + columns.start..first + columns.end].iter_mut();
                for (m, x) in out.zip(columns) {
                    let aside = x as f64 - part.x;
                    *m = ((part.away + aside * aside).sqrt() * space.resolution) as f32;
                }
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

/// A parabola `away + (column - x)^2`. All are whole numbers, in floating point as that divides faster; they are exact
/// up to 94 million columns.
struct Parabola {
    x: f64,
    away: f64,
    /// It is the lowest beyond here.
    from: f64,
    column: usize,
}

/// The lower envelope of the parabolas of all columns.
#[derive(Default)]
struct Envelope {
    parts: Vec<Parabola>,
}

impl Envelope {
    fn build(&mut self, away: &[f64]) {
        self.parts.clear();
        for (column, &away) in away.iter().enumerate() {
            let x = column as f64;
            let mut from = -1.0;
            while let Some(last) = self.parts.last() {
                from = (x * x + away - last.x * last.x - last.away) / (2.0 * (x - last.x));
                if from > last.from {
                    break;
                }
                self.parts.pop();
            }
            self.parts.push(Parabola { x, away, from, column });
        }
    }

    /// The columns where each parabola is the lowest, without the first and the last of `count` columns.
    fn within(&self, count: usize) -> impl Iterator<Item = (Range<usize>, &Parabola)> {
        let first = move |part: &Parabola| ((part.from + 1.0) as usize).clamp(1, count - 1);
        self.parts.iter().enumerate().filter_map(move |(i, part)| {
            let columns = first(part)..self.parts.get(i + 1).map_or(count - 1, first);
            (!columns.is_empty()).then_some((columns, part))
        })
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
