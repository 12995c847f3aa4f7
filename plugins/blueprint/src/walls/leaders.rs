//! Leader lines: thin straight lines from a word beside or in the plan to a dot at what it tells of. They part nothing.

use super::components::{self, Extent, Neighbours};
use super::drawing::Drawing;
use crate::found::SheetText;
use std::f64::consts::TAU;

/// A dot is no larger than this, metres, or than so many pixels.
const DOT: [f64; 2] = [0.35, 4.0];

/// A leader is at least this long, metres,
const LEAST: f64 = 0.8;

/// and ends within so many heights of the word.
const BESIDE: f64 = 1.5;

/// Where so many lines of this length, metres, begin at dots, they are leaders though their words were not read.
const CUSTOM: usize = 6;
const LONG: f64 = 2.0;

/// Places around a dot at which lines are looked for.
const AROUND: usize = 72;

/// A line leaves it over less than this, radians, or it is a wall.
const THIN: f64 = 1.3;

/// It is followed this much to both sides, radians, over gaps of so many pixels.
const ASIDE: f64 = 0.2;
const GAP: usize = 2;

/// The ink of all leaders. `solid`: thick ink, dots among it; `stroke`: how thick thin lines are, pixels.
pub fn ink(drawing: &Drawing, solid: &[bool], stroke: f64, texts: &[SheetText]) -> Vec<bool> {
    let mut out = vec![false; drawing.ink.len()];
    let dots = components::find(solid, drawing.width, Neighbours::Eight);
    let largest = (DOT[0] * drawing.metre).max(DOT[1]);
    let dots = dots.all.iter().skip(1).filter(|d| diameter(d) <= largest);
    let lines = dots.filter_map(|d| Some([middle(d), leader(drawing, middle(d), diameter(d) / 2.0 + 2.0)?]));
    let (mut leaders, mut others): (Vec<_>, Vec<_>) =
        lines.partition(|[_, to]| texts.iter().any(|t| is_beside(drawing, t, *to)));
    others.retain(|[a, b]| (b[0] - a[0]).hypot(b[1] - a[1]) >= LONG * drawing.metre);
    if others.len() >= CUSTOM {
        leaders.append(&mut others);
    }
    leaders.iter().for_each(|line| mark(drawing, *line, stroke, &mut out));
    out
}

fn diameter(dot: &Extent) -> f64 {
    let [w, h] = [0, 1].map(|i| dot.high[i] - dot.low[i] + 1);
    w.max(h) as f64
}

fn middle(dot: &Extent) -> [f64; 2] {
    [0, 1].map(|i| (dot.low[i] + dot.high[i] + 1) as f64 / 2.0)
}

/// Where the only line ends that leaves a dot, if it is long enough.
fn leader(drawing: &Drawing, from: [f64; 2], radius: f64) -> Option<[f64; 2]> {
    let angle = only_line(drawing, from, radius)?;
    let turns = (-12..=12).map(|k| angle + ASIDE * f64::from(k) / 12.0);
    let ends = turns.map(|angle| (follow(drawing, from, angle, radius), angle));
    let (length, angle) = ends.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let end = [from[0] + length * angle.cos(), from[1] + length * angle.sin()];
    (length >= LEAST * drawing.metre).then_some(end)
}

/// The direction in which ink leaves a dot, if it does so in one place.
fn only_line(drawing: &Drawing, from: [f64; 2], radius: f64) -> Option<f64> {
    let angle = |k: usize| k as f64 * TAU / AROUND as f64;
    let is_ink = |k: usize| {
        let (sin, cos) = angle(k % AROUND).sin_cos();
        drawing.has_ink([from[0] + radius * cos, from[1] + radius * sin])
    };
    let mut begins = (0..AROUND).filter(|&k| is_ink(k) && !is_ink(k + AROUND - 1));
    let first = begins.next().filter(|_| begins.next().is_none())?;
    let count = (first..first + AROUND).take_while(|&k| is_ink(k)).count();
    let width = count as f64 * TAU / AROUND as f64;
    (width < THIN).then(|| angle(first) + (width - TAU / AROUND as f64) / 2.0)
}

/// How far ink goes on in a direction.
fn follow(drawing: &Drawing, from: [f64; 2], angle: f64, radius: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let (mut last, mut at) = (radius, radius);
    while at - last <= GAP as f64 {
        let [x, y] = [from[0] + at * cos, from[1] + at * sin];
        let near = [[x, y], [x - sin, y + cos], [x + sin, y - cos]];
        if near.into_iter().any(|p| drawing.has_ink(p)) {
            last = at;
        }
        at += 1.0;
    }
    last
}

/// Whether a point of the drawing lies at a text's box.
fn is_beside(drawing: &Drawing, text: &SheetText, point: [f64; 2]) -> bool {
    let [x, y] = [0, 1].map(|i| point[i] * drawing.factor as f64 - text.centre[i]);
    let (sin, cos) = text.angle.sin_cos();
    let (along, across) = ((x * cos + y * sin).abs(), (y * cos - x * sin).abs());
    let reach = BESIDE * text.height;
    along <= text.width / 2.0 + reach && across <= text.height / 2.0 + reach
}

/// Marks the ink of a line.
fn mark(drawing: &Drawing, [from, to]: [[f64; 2]; 2], stroke: f64, out: &mut [bool]) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy).max(1.0);
    let half = (stroke / 2.0 + 1.0).ceil() as i32;
    for step in 0..=(2.0 * length) as usize {
        let t = step as f64 / (2.0 * length);
        for aside in (-2 * half..=2 * half).map(|k| f64::from(k) / 2.0) {
            let p = [from[0] + t * dx - aside * dy / length, from[1] + t * dy + aside * dx / length];
            if let Some(i) = drawing.at(p) {
                out[i] |= drawing.ink[i];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// A dot at (60, 30) with a line to the right, to x = 150; another line crosses it. A pixel is 0.03 m.
    fn found(text: f64, second: bool) -> Vec<bool> {
        let mut ink = Mask::empty(240, 60);
        (58..63).for_each(|x| (28..33).for_each(|y| ink.set[y * 240 + x] = true));
        (60..150).for_each(|x| ink.set[30 * 240 + x] = true);
        (5..55).for_each(|y| ink.set[y * 240 + 100] = true);
        if second {
            (20..60).for_each(|x| ink.set[30 * 240 + x] = true);
        }
        let drawing = Drawing::of_sheet(&ink, 0.03);
        let solid: Vec<bool> = (0..ink.set.len())
            .map(|i| (58..63).contains(&(i % 240)) && (28..33).contains(&(i / 240)))
            .collect();
        let text = SheetText {
            content: "Hall".into(),
            centre: [text, 30.0],
            angle: 0.0,
            width: 40.0,
            height: 10.0,
            confidence: 0.9,
        };
        super::ink(&drawing, &solid, 1.0, &[text])
    }

    #[test]
    fn a_line_from_a_word_to_a_dot_is_a_leader() {
        let leader = found(175.0, false);
        assert!(leader[30 * 240 + 70] && leader[30 * 240 + 145]);
        assert!(!leader[10 * 240 + 100]);
    }

    #[test]
    fn many_long_lines_with_dots_are_leaders_though_nothing_is_read() {
        let marked = |rows: usize| {
            let mut ink = Mask::empty(240, 20 * rows as u32);
            let mut solid = vec![false; ink.set.len()];
            for row in (0..rows).map(|r| 20 * r + 10) {
                (58..63).for_each(|x| (row - 2..row + 3).for_each(|y| solid[y * 240 + x] = true));
                (60..160).for_each(|x| ink.set[row * 240 + x] = true);
            }
            ink.set.iter_mut().zip(&solid).for_each(|(i, s)| *i |= s);
            super::ink(&Drawing::of_sheet(&ink, 0.03), &solid, 1.0, &[]).contains(&true)
        };
        assert!(marked(CUSTOM) && !marked(CUSTOM - 1));
    }

    #[test]
    fn lines_without_a_word_and_those_through_a_post_stay() {
        assert!(!found(220.0, false).contains(&true));
        assert!(!found(175.0, true).contains(&true));
    }
}
