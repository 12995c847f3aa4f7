//! The clearance of every free cell: how far the nearest cell is that is not free, and which one that is.
//!
//! An exact Euclidean distance transform in two passes (Meijster, Roerdink and Hesselink, "A General Algorithm for
//! Computing Distance Transforms in Linear Time", 2000).

use super::super::runs::runs;
use super::space::Space;
use planform_sdk::parallel;

/// The clearance of the free space.
pub struct Clearance {
    /// Metres from each cell's middle to that of the nearest cell that is not free; 0 for such cells.
    pub metres: Vec<f32>,
    /// Index of the nearest cell that is not free.
    pub nearest: Vec<u32>,
}

/// Measures the clearance of a space.
pub fn measure(space: &Space) -> Clearance {
    let width = space.width;
    let mut nearest = nearest_in_columns(space);
    let mut metres = vec![0.0; space.free.len()];
    parallel::for_each_band_of_two(&mut nearest, &mut metres, width, |first, nearest, metres| {
        let mut away = Away::default();
        let rows = nearest.chunks_exact_mut(width).zip(metres.chunks_exact_mut(width));
        for (row, (nearest, metres)) in (first..).zip(rows) {
            away.across(space, row, nearest, metres);
        }
    });
    Clearance { metres, nearest }
}

/// What a row is measured with.
#[derive(Default)]
struct Away {
    /// For each cell the row of the nearest cell in its column, and the square of how far that is.
    rows: Vec<u32>,
    squares: Vec<f64>,
    envelope: Envelope,
}

impl Away {
    /// From the rows of the nearest cells in the columns to the nearest cells of a row.
    fn across(&mut self, space: &Space, row: usize, nearest: &mut [u32], metres: &mut [f32]) {
        let first = row * space.width;
        self.rows.clear();
        self.rows.extend_from_slice(nearest);
        self.squares.clear();
        self.squares.extend(nearest.iter().map(|&r| (f64::from(r) - row as f64).powi(2)));
        nearest.iter_mut().zip(first as u32..).for_each(|(n, own)| *n = own);
        for run in runs(&space.free[first..first + space.width], space.width, true) {
            // At either end is a cell that is not free: what lies beyond is not nearer.
            let begin = run.from - 1;
            self.envelope.build(&self.squares[begin..run.to + 1]);
            let inside = nearest[run.from..run.to].iter_mut().zip(&mut metres[run.from..run.to]);
            let mut parts = self.envelope.parts.iter().peekable();
            let mut part = &Parabola::default();
            let mut x = 0.0;
            for (nearest, metres) in inside {
                x += 1.0;
                while let Some(next) = parts.next_if(|next| next.from < x) {
                    part = next;
                }
                let aside = x - part.x;
                *nearest = self.rows[begin + part.column] * space.width as u32 + (begin + part.column) as u32;
                *metres = ((part.away + aside * aside).sqrt() * space.resolution) as f32;
            }
        }
    }
}

/// For each cell the row of the nearest cell of its column that is not free. The border of a space is not free, so
/// there always is one.
fn nearest_in_columns(space: &Space) -> Vec<u32> {
    let width = space.width;
    let mut rows = nearest_below(space);
    for row in (0..space.height - 1).rev() {
        let (lower, upper) = rows.split_at_mut((row + 1) * width);
        let free = &space.free[row * width..(row + 1) * width];
        let at = row as u32;
        for ((below, above), free) in lower[row * width..].iter_mut().zip(upper).zip(free) {
            // The row above still may name a cell beneath.
            let is_nearer = *free && *above > at && *above - at < at - *below;
            *below = if is_nearer { *above } else { *below };
        }
    }
    rows
}

/// For each cell the row of the nearest cell below in its column that is not free.
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

/// A parabola `away + (column - x)^2`. All are whole numbers, in floating point as that divides faster; they are exact
/// up to 94 million columns.
#[derive(Default)]
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
                let (aside, twice) = (x - last.x, x * x + away - last.x * last.x - last.away);
                // Mostly they are side by side, and dividing takes long.
                from = if aside == 1.0 { 0.5 * twice } else { twice / (2.0 * aside) };
                if from > last.from {
                    break;
                }
                self.parts.pop();
            }
            self.parts.push(Parabola { x, away, from, column });
        }
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
