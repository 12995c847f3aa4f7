//! Walls drawn as two lines or as hatched bands: narrow paper between ink, as long as walls are.

use super::components::{self, Neighbours};
use super::distance;
use super::drawing::Drawing;
use super::straight::Straight;
use super::tracks::TURNS;
use crate::found::SheetText;

/// Paper is narrow where no disc of this radius fits, metres.
const NARROW: f64 = 0.27;

/// Ink and narrow paper together are no wall but stairs or furniture where a disc of this radius fits, metres.
const BLOCK: f64 = 0.36;

/// Strokes of hatching are no longer than this, metres; a band's outlines are.
const HATCH: f64 = 0.7;

/// Hatching is drawn at least so far aslant to the sheet, in parts of half a turn of which there are [`TURNS`].
const ASLANT: usize = 3;

/// At most so much of a band lies in such a block: furniture stands at walls.
const BLOCKED: f64 = 0.4;

/// Of a band's outline at least half is lines that are no shorter than this, metres; specks and letters have none.
const OUTLINE: f64 = 0.4;

/// Words that cover this share of a piece stand in it, and nobody writes into walls: it is a dimension's strip, a table.
const WRITTEN: f64 = 0.01;

/// A band covers at least this many squares of its own width.
const LONG: f64 = 2.5;

/// The paper within bands, with their hatching. `lines`: the straight runs of the ink; `openings`: doors and windows,
/// which are in walls and join the pieces beside them; `texts`: the words that stood on the sheet.
pub fn bands(drawing: &Drawing, lines: &Straight, openings: &[bool], texts: &[SheetText]) -> Vec<bool> {
    let tight = closing(&drawing.paper(), drawing.width, NARROW * drawing.metre);
    let block = opening(&tight, drawing.width, BLOCK * drawing.metre);
    let hatch = HATCH * drawing.metre;
    let is_hatch = |i: usize| f64::from(lines.length[i]) <= hatch && is_aslant(lines.turn[i]);
    let may = |i: usize| !drawing.ink[i] || is_hatch(i);
    let narrow: Vec<bool> = (0..tight.len()).map(|i| openings[i] || tight[i] && may(i)).collect();
    let apart: Vec<bool> = (0..tight.len()).map(|i| openings[i] || narrow[i] && !block[i]).collect();
    let judge = Judge { drawing, lines, block: &block, texts };
    let (whole, rest) = (judge.long(&narrow), judge.long(&apart));
    whole.into_iter().zip(rest).map(|(w, r)| w || r).collect()
}

/// Whether a direction is neither level nor upright.
fn is_aslant(turn: u8) -> bool {
    let turn = usize::from(turn) % (TURNS / 2);
    turn.min(TURNS / 2 - turn) >= ASLANT
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

/// What hangs together within a set.
#[derive(Debug, Clone, Copy, Default)]
struct Piece {
    /// Pixels.
    area: f64,
    /// The greatest distance to what is not in the set, squared.
    depth: u32,
    /// Pixels of it in blocks.
    blocked: f64,
    /// Pixels at its rim that are ink: of short strokes, of lines.
    rim: [u32; 2],
    /// Pixels that words cover whose middles lie in it.
    written: f64,
}

impl Piece {
    fn is_band(&self) -> bool {
        self.area >= LONG * 4.0 * f64::from(self.depth)
            && self.blocked <= BLOCKED * self.area
            && self.rim[0] <= self.rim[1]
            && self.written < WRITTEN * self.area
    }
}

/// What pieces are judged by.
struct Judge<'a> {
    drawing: &'a Drawing,
    lines: &'a Straight,
    block: &'a [bool],
    texts: &'a [SheetText],
}

impl Judge<'_> {
    /// What hangs together in long pieces between lines that are no blocks, and that nothing is written in.
    fn long(&self, set: &[bool]) -> Vec<bool> {
        let found = components::find(set, self.drawing.width, Neighbours::Four);
        let mut pieces = vec![Piece::default(); found.all.len()];
        self.measure(set, &found.label, &mut pieces);
        self.texts.iter().filter_map(|t| Some((self.drawing.at_sheet(t.centre)?, t))).for_each(
            |(at, text)| {
                let covered = text.width * text.height / (self.drawing.factor as f64).powi(2);
                pieces[found.label[at] as usize].written += covered;
            },
        );
        found.label.iter().map(|&label| label != 0 && pieces[label as usize].is_band()).collect()
    }

    fn measure(&self, set: &[bool], label: &[u32], pieces: &mut [Piece]) {
        let depth = distance::squared(set, self.drawing.width);
        let outline = OUTLINE * self.drawing.metre;
        for (i, &label) in label.iter().enumerate().filter(|(_, l)| **l != 0) {
            let piece = &mut pieces[label as usize];
            piece.area += 1.0;
            piece.depth = piece.depth.max(depth[i]);
            piece.blocked += f64::from(u8::from(self.block[i]));
            let beside = Neighbours::Four.of(i, self.drawing.width, self.drawing.height);
            for b in beside.filter(|&b| self.drawing.ink[b] && !set[b]) {
                piece.rim[usize::from(f64::from(self.lines.length[b]) >= outline)] += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::straight;
    use super::*;
    use crate::mask::Mask;

    /// The bands of upright lines at these columns, 3 m long; a pixel is 0.05 m.
    fn lines(columns: &[usize]) -> Vec<bool> {
        with_texts(columns, &[])
    }

    fn with_texts(columns: &[usize], texts: &[SheetText]) -> Vec<bool> {
        let mut ink = Mask::empty(80, 80);
        for &x in columns {
            (10..70).for_each(|y| ink.set[y * 80 + x] = true);
        }
        let drawing = Drawing::of_sheet(&ink, 0.05);
        bands(&drawing, &straight::runs(&drawing.ink, drawing.width), &[false; 6400], texts)
    }

    #[test]
    fn two_lines_are_a_wall_and_stairs_are_none() {
        assert!(lines(&[30, 35])[40 * 80 + 32]);
        assert!(!lines(&[30, 35])[40 * 80 + 40]);
        assert!(!lines(&[30, 50])[40 * 80 + 32]);
        let treads: Vec<usize> = (10..70).step_by(5).collect();
        assert!(!lines(&treads)[40 * 80 + 42]);
    }

    #[test]
    fn hatching_does_not_cut_a_band_to_pieces() {
        let mut ink = Mask::empty(80, 80);
        (10..70).for_each(|y| [30, 36].iter().for_each(|x| ink.set[y * 80 + x] = true));
        (10..64).step_by(7).for_each(|y| (0..6).for_each(|i| ink.set[(y + i) * 80 + 30 + i] = true));
        let drawing = Drawing::of_sheet(&ink, 0.05);
        let found = bands(&drawing, &straight::runs(&drawing.ink, drawing.width), &[false; 6400], &[]);
        assert!((12..62).all(|y| found[y * 80 + 33]));
    }

    #[test]
    fn nobody_writes_into_a_wall() {
        let text = SheetText {
            content: "36'2".into(),
            centre: [33.0, 40.0],
            angle: 0.0,
            width: 8.0,
            height: 3.0,
            confidence: 0.9,
        };
        assert!(!with_texts(&[30, 36], &[text])[20 * 80 + 33]);
    }
}
