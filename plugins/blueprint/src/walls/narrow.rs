//! Walls drawn as two lines or as hatched bands: narrow paper between ink, as long as walls are.

use super::components::{self, Neighbours};
use super::distance;
use super::drawing::Drawing;

/// Paper is narrow where no disc of this radius fits, metres.
const NARROW: f64 = 0.27;

/// Ink and narrow paper together are no wall but stairs or furniture where a disc of this radius fits, metres.
const BLOCK: f64 = 0.36;

/// A band covers at least this many squares of its own width.
const LONG: f64 = 2.5;

/// The paper within bands. `paper`: how far it is from ink, squared.
pub fn bands(drawing: &Drawing, paper: &[u32]) -> Vec<bool> {
    let tight = closing(paper, drawing.width, NARROW * drawing.metre);
    let block = opening(&tight, drawing.width, BLOCK * drawing.metre);
    let band: Vec<bool> = (0..tight.len()).map(|i| !drawing.ink[i] && tight[i] && !block[i]).collect();
    long(&band, paper, drawing.width)
}

/// Ink, and the paper that no disc reaches.
fn closing(paper: &[u32], width: usize, radius: f64) -> Vec<bool> {
    let cramped: Vec<bool> = paper.iter().map(|&d| f64::from(d) <= radius * radius).collect();
    distance::squared(&cramped, width).iter().map(|&d| f64::from(d) > (radius + 1.0).powi(2)).collect()
}

/// What discs within the set reach.
fn opening(set: &[bool], width: usize, radius: f64) -> Vec<bool> {
    let shallow: Vec<bool> =
        distance::squared(set, width).iter().map(|&d| f64::from(d) <= radius * radius).collect();
    distance::squared(&shallow, width).iter().map(|&d| f64::from(d) <= (radius * 1.05).powi(2)).collect()
}

/// What hangs together in long pieces.
fn long(band: &[bool], paper: &[u32], width: usize) -> Vec<bool> {
    let pieces = components::find(band, width, Neighbours::Four);
    let mut depth = vec![0; pieces.all.len()];
    for (&piece, &d) in pieces.label.iter().zip(paper) {
        depth[piece as usize] = d.max(depth[piece as usize]);
    }
    let is_long = |p: usize| p != 0 && pieces.all[p].area as f64 >= LONG * 4.0 * f64::from(depth[p]);
    pieces.label.iter().map(|&p| is_long(p as usize)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// Upright lines at these columns, 3 m long; a pixel is 0.05 m.
    fn lines(columns: &[usize]) -> Vec<bool> {
        let mut ink = Mask::empty(80, 80);
        for &x in columns {
            (10..70).for_each(|y| ink.set[y * 80 + x] = true);
        }
        let drawing = Drawing::of_sheet(&ink, 0.05);
        bands(&drawing, &drawing.paper())
    }

    #[test]
    fn two_lines_are_a_wall_and_stairs_are_none() {
        assert!(lines(&[30, 35])[40 * 80 + 32]);
        assert!(!lines(&[30, 35])[40 * 80 + 40]);
        assert!(!lines(&[30, 50])[40 * 80 + 32]);
        let treads: Vec<usize> = (10..70).step_by(5).collect();
        assert!(!lines(&treads)[40 * 80 + 42]);
    }
}
