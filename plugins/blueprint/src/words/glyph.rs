//! Which connected parts may be letters, by their shape alone. Lengths are multiples of the part's own sides, or of the
//! sheet's, as nothing is known of the scale yet.

use super::components::{Bounds, Component, Components, Run};
use super::lines::Rows;

/// What is smaller on both sides is no letter that anyone could read, pixels.
const SMALLEST: i32 = 5;

/// Letters are at most this part of the sheet's shorter side tall, but always up to `ALWAYS` pixels.
const LARGEST: f64 = 0.07;
const ALWAYS: f64 = 48.0;

/// Letters that run into each other become one part, this many times as long as tall.
const LONGEST: f64 = 9.0;

/// Ink per box. Less is an arc or an outline, more is a column or a piece of wall.
const LIGHTEST: f64 = 0.06;
const DENSEST: f64 = 0.82;

/// A part is a bar (I, l, 1, a dash) if it is this many times as long as thick.
const BAR: f64 = 4.0;

/// A stroke is at most this part of a letter's longer side.
const THICKEST: f64 = 0.34;

/// Ink per box of a letter that something is drawn around; of a dot it is more.
const OPEN: f64 = 0.68;

/// Which mask a part is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    /// The ink as it is.
    Whole,
    /// What stays of large parts without their long and thick strokes.
    Cut,
}

/// A part that may be a letter, or several that touch.
#[derive(Debug, Clone)]
pub struct Glyph {
    /// Its box.
    pub bounds: Bounds,
    /// Its pixels.
    pub area: i64,
    /// Mean width of its strokes, pixels.
    pub stroke: f64,
    /// Whether it is one straight stroke.
    pub bar: bool,
    /// Where its pixels are.
    pub layer: Layer,
    /// The part of that layer.
    pub part: usize,
}

/// How tall a letter may be on a sheet of this size, pixels.
pub fn tallest(width: u32, height: u32) -> i32 {
    (f64::from(width.min(height)) * LARGEST).max(ALWAYS) as i32
}

/// The parts that may be letters.
pub fn glyphs(parts: &Components, layer: Layer, tallest: i32) -> Vec<Glyph> {
    let glyph =
        |(i, part): (usize, &Component)| glyph(parts, part, tallest).map(|g| Glyph { layer, part: i, ..g });
    let glyphs: Vec<_> = parts.list.iter().enumerate().filter_map(glyph).collect();
    without_frames(glyphs)
}

/// The parts without those that are drawn around others, as the box around a room's number is.
fn without_frames(glyphs: Vec<Glyph>) -> Vec<Glyph> {
    let boxes: Vec<_> = glyphs.iter().map(|g| g.bounds).collect();
    let rows = Rows::of(&boxes);
    let within = |a: Bounds, b: Bounds| a.x0 < b.x0 && a.y0 < b.y0 && a.x1 > b.x1 && a.y1 > b.y1;
    let frame =
        |g: &Glyph| rows.within(g.bounds, 0).any(|i| within(g.bounds, boxes[i]) && is_letter(&glyphs[i]));
    glyphs.iter().filter(|g| !frame(g)).cloned().collect()
}

/// Whether the part is no mere dot, as there is one in some zeros.
fn is_letter(glyph: &Glyph) -> bool {
    let (long, short) = sides(glyph.bounds);
    !glyph.bar && glyph.area as f64 <= OPEN * f64::from(long) * f64::from(short)
}

fn glyph(parts: &Components, part: &Component, tallest: i32) -> Option<Glyph> {
    let (long, short) = sides(part.bounds);
    let (l, s) = (f64::from(long), f64::from(short));
    if long < SMALLEST || short > tallest || l > f64::from(tallest) * LONGEST {
        return None;
    }
    let density = part.area as f64 / (l * s);
    let runs = parts.runs(part);
    let bar = elongation(runs) >= BAR;
    let stroke = stroke(runs, part.area);
    let letter = (LIGHTEST..=DENSEST).contains(&density) && stroke <= THICKEST * l && l <= s * LONGEST;
    let thin = bar && stroke <= THICKEST * l && long <= tallest;
    let glyph = Glyph { bounds: part.bounds, area: part.area, stroke, bar, layer: Layer::Whole, part: 0 };
    (letter || thin).then_some(glyph)
}

fn sides(b: Bounds) -> (i32, i32) {
    (b.width().max(b.height()), b.width().min(b.height()))
}

/// Twice the area by the outline's length, which is the width of a long stroke.
fn stroke(runs: &[Run], area: i64) -> f64 {
    2.0 * area as f64 / outline(runs) as f64
}

/// Edges between pixels of the part and others.
fn outline(runs: &[Run]) -> i64 {
    let own: i64 = runs.iter().map(|r| 2 + 2 * i64::from(r.x1 - r.x0)).sum();
    own - 2 * shared_edges(runs)
}

/// Edges between pixels of neighbouring rows. Two pointers, as the runs are sorted.
fn shared_edges(runs: &[Run]) -> i64 {
    let (mut above, mut shared) = (0, 0);
    for run in runs {
        while runs[above].y < run.y - 1 || (runs[above].y == run.y - 1 && runs[above].x1 <= run.x0) {
            above += 1;
        }
        let touching = runs[above..].iter().take_while(|a| a.y == run.y - 1 && a.x0 < run.x1);
        shared += touching.map(|a| i64::from(a.x1.min(run.x1) - a.x0.max(run.x0))).sum::<i64>();
    }
    shared
}

/// Length by thickness of the ellipse with the part's second moments.
fn elongation(runs: &[Run]) -> f64 {
    let [a, b, c] = covariance(runs);
    let spread = ((a - c) / 2.0).hypot(b);
    let middle = (a + c) / 2.0;
    ((middle + spread) / (middle - spread).max(1.0 / 12.0)).sqrt()
}

/// Variance of x, covariance, and variance of y, of pixels of side 1.
fn covariance(runs: &[Run]) -> [f64; 3] {
    let (Some(first), mut sums) = (runs.first(), [0.0; 6]) else { return [0.0; 3] };
    for r in runs {
        let (n, y) = (f64::from(r.x1 - r.x0), f64::from(r.y - first.y));
        let x = f64::from(r.x0 + r.x1) / 2.0 - f64::from(first.x0);
        let own = n * (n * n - 1.0) / 12.0;
        let terms = [n, n * x, n * y, n * x * x + own, n * x * y, n * y * y];
        sums.iter_mut().zip(terms).for_each(|(s, t)| *s += t);
    }
    let [n, x, y, xx, xy, yy] = sums;
    let (mx, my) = (x / n, y / n);
    [xx / n - mx * mx + 1.0 / 12.0, xy / n - mx * my, yy / n - my * my + 1.0 / 12.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::drawn::mask;

    fn found(rows: &[&str]) -> Vec<Glyph> {
        glyphs(&Components::of(&mask(rows)), Layer::Whole, 48)
    }

    #[test]
    fn letters_are_found_with_their_strokes() {
        let e = found(&["######", "#.....", "#.....", "#####.", "#.....", "#.....", "######"]);
        assert_eq!(e.len(), 1);
        assert!(!e[0].bar && (0.8..1.2).contains(&e[0].stroke), "{e:?}");
    }

    #[test]
    fn bars_are_told_from_letters_at_any_angle() {
        assert!(found(&["#", "#", "#", "#", "#", "#", "#"])[0].bar);
        assert!(found(&["......#", ".....#.", "....#..", "...#...", "..#....", ".#.....", "#......"])[0].bar);
        assert!(!found(&["#.....", "#.....", "#.....", "#.....", "#.....", "######"])[0].bar);
    }

    #[test]
    fn a_box_around_a_letter_is_none() {
        let boxed = [
            "#########",
            "#.......#",
            "#.#####.#",
            "#.#.....#",
            "#.####..#",
            "#.#.....#",
            "#.#####.#",
            "#.......#",
            "#########",
        ];
        let found = found(&boxed);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].bounds.width(), 5);
    }

    #[test]
    fn columns_and_specks_are_no_letters() {
        assert!(found(&["######"; 6]).is_empty());
        assert!(found(&["##.", "##.", "..."]).is_empty());
    }
}
