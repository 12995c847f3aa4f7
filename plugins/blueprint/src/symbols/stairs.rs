//! Flights of steps: lines of the same length, at the same distance from each other.

use super::plane::Plane;
use super::runs::{Frame, Lying, beside};
use super::shapes::{Box2, erase_inside};
use super::strokes::Segment;
use crate::found::SheetSymbol;
use crate::mask::Mask;

/// A flight has so many lines at least.
const LEAST_LINES: usize = 5;
/// Depth of a step, metres.
const TREAD: [f64; 2] = [0.2, 0.42];
/// Width of a flight, metres.
const WIDTH: [f64; 2] = [0.65, 4.0];
/// The longest flight, metres.
const LONGEST: f64 = 8.0;

/// All flights of the plane, and what draws their steps.
pub fn find(
    plane: &Plane,
    ink: &Mask,
    segments: &[Segment],
    pixel: f64,
    erase: &mut Mask,
) -> Vec<SheetSymbol> {
    let mut taken = vec![false; segments.len()];
    let mut found = Vec::new();
    for i in 0..segments.len() {
        let width = segments[i].length() * pixel;
        if taken[i] || !(WIDTH[0]..=WIDTH[1]).contains(&width) {
            continue;
        }
        let slack = (0.12 * segments[i].length()).max(3.0);
        let (frame, lines) = beside(segments, i, LONGEST / pixel, slack);
        if let Some(run) = run(&lines, pixel) {
            lines.iter().for_each(|(k, _)| taken[*k] = true);
            found.push(flight(plane, ink, &frame, run, pixel, erase));
        }
    }
    found
}

/// The longest part of the lines that are evenly spaced.
fn run(lines: &[(usize, Lying)], pixel: f64) -> Option<&[(usize, Lying)]> {
    let gap = |k: usize| (lines[k + 1].1.off - lines[k].1.off) * pixel;
    let mut best: &[(usize, Lying)] = &[];
    let mut from = 0;
    for to in 0..lines.len() {
        let even = to == from || {
            let (own, first) = (gap(to - 1), gap(from));
            (TREAD[0]..=TREAD[1]).contains(&own) && (own / first - 1.0).abs() < 0.3
        };
        if !even {
            from = to;
        }
        if to + 1 - from > best.len() {
            best = &lines[from..=to];
        }
    }
    (best.len() >= LEAST_LINES).then_some(best)
}

fn flight(
    plane: &Plane,
    ink: &Mask,
    frame: &Frame,
    lines: &[(usize, Lying)],
    pixel: f64,
    erase: &mut Mask,
) -> SheetSymbol {
    let mean = |f: fn(&Lying) -> f64| lines.iter().map(|(_, l)| f(l)).sum::<f64>() / lines.len() as f64;
    let (from, to) = (mean(|l| l.from), mean(|l| l.to));
    let (low, high) = (lines[0].1.off, lines[lines.len() - 1].1.off);
    let scale = f64::from(plane.factor);
    let area = Box2 {
        centre: frame.at((from + to) / 2.0, (low + high) / 2.0).map(|v| v * scale),
        along: frame.across,
        half: [(high - low) / 2.0 * scale, (to - from) / 2.0 * scale],
    };
    let margin = (0.06 / pixel).max(2.0) * scale;
    erase_inside(ink, &area.grown([2.0 * scale, -margin]), erase);
    area.symbol("stairs", (0.6 + 0.05 * lines.len() as f64).min(1.0))
}
