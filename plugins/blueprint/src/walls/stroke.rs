//! How thick lines are drawn, and what is thicker.

use super::distance;
use super::drawing::Drawing;

/// A line is solid, and so a wall, if it is this much thicker than usual ones,
const THICKER: f64 = 1.7;

/// and at least this thick, metres.
const LEAST: f64 = 0.04;

/// What is this thick is a wall whatever the others are, metres.
const SURELY: f64 = 0.12;

/// Thicknesses that are told apart, pixels.
const LEVELS: usize = 256;

/// The usual thickness of lines, pixels: that of the greatest length of them.
pub fn usual(drawing: &Drawing) -> f64 {
    let mut area = [0usize; LEVELS];
    let across = run_lengths(drawing.ink.iter(), drawing.width);
    for x in 0..drawing.width {
        let mut from = 0;
        for y in 0..=drawing.height {
            if y < drawing.height && drawing.ink[y * drawing.width + x] {
                continue;
            }
            let rows = from..y;
            rows.for_each(|row| area[across[row * drawing.width + x].min(y - from).min(LEVELS - 1)] += 1);
            from = y + 1;
        }
    }
    (1..LEVELS).max_by_key(|&t| (area[t] * LEVELS / t, LEVELS - t)).unwrap_or(1) as f64
}

/// For every pixel of ink how many pixels of ink lie in a row with it.
fn run_lengths<'a>(ink: impl Iterator<Item = &'a bool>, width: usize) -> Vec<usize> {
    let ink: Vec<bool> = ink.copied().collect();
    let mut out = vec![0; ink.len()];
    for (row, lengths) in ink.chunks(width.max(1)).zip(out.chunks_mut(width.max(1))) {
        let mut from = 0;
        for x in 0..=row.len() {
            if x < row.len() && row[x] {
                continue;
            }
            lengths[from..x].fill(x - from);
            from = x + 1;
        }
    }
    out
}

/// The ink that is thick: walls drawn solid, columns. Morphological opening by a disc.
pub fn solid(drawing: &Drawing, usual: f64) -> Vec<bool> {
    let thick = (THICKER * usual).max(LEAST * drawing.metre).min(SURELY * drawing.metre).max(1.5);
    let radius = (thick + 1.0) / 2.0;
    let depth = distance::squared(&drawing.ink, drawing.width);
    let shallow: Vec<bool> = depth.iter().map(|&d| f64::from(d) < radius * radius).collect();
    let reach = (radius + 0.5).powi(2);
    let near = distance::squared(&shallow, drawing.width);
    near.iter().zip(&drawing.ink).map(|(&d, &ink)| ink && f64::from(d) <= reach).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// Four thin lines and one thick one of this many pixels; a pixel is 0.05 m.
    fn lines(thick: u32) -> Drawing {
        let mut ink = Mask::empty(60, 60);
        for x in 5..55 {
            (0..4).for_each(|line| ink.set[(5 + 6 * line) * 60 + x] = true);
            (35..35 + thick as usize).for_each(|y| ink.set[y * 60 + x] = true);
        }
        Drawing::of_sheet(&ink, 0.05)
    }

    #[test]
    fn what_is_thicker_than_usual_is_solid() {
        let drawing = lines(5);
        assert_eq!(usual(&drawing), 1.0);
        let solid = solid(&drawing, 1.0);
        assert!(solid[37 * 60 + 30] && !solid[5 * 60 + 30]);
    }

    #[test]
    fn thin_lines_alone_are_not() {
        assert!(!solid(&lines(1), 1.0).contains(&true));
    }
}
