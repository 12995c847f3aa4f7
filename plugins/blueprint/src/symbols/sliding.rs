//! Doors that slide: two leaves beside each other in the opening, each over one half of it, one behind the other.

use super::near::Near;
use super::plane::Plane;
use super::runs::{Frame, Lying};
use super::shapes::{Box2, erase_inside};
use super::strokes::Segment;
use crate::found::SheetSymbol;
use crate::mask::Mask;

/// Length of one leaf, metres.
const LEAF: [f64; 2] = [0.33, 1.5];
/// How far the outer lines of two leaves lie from each other across, metres.
const APART: [f64; 2] = [0.02, 0.2];
/// By how much of a leaf the two overlap.
const OVERLAP: [f64; 2] = [-0.04, 0.35];
/// The wall on both sides goes on as far as this, metres, beyond the jambs.
const WALL: f64 = 0.12;

/// All sliding doors of the plane, and what draws them.
pub fn find(
    plane: &Plane,
    ink: &Mask,
    segments: &[Segment],
    pixel: f64,
    erase: &mut Mask,
) -> Vec<SheetSymbol> {
    let leaf = |s: &&Segment| (LEAF[0]..=LEAF[1]).contains(&(s.length() * pixel));
    let leaves: Vec<&Segment> = segments.iter().filter(leaf).collect();
    let mut found: Vec<SheetSymbol> = Vec::new();
    let near = Near::of(leaves.iter().map(|l| l.middle()), LEAF[1] / pixel);
    for (i, a) in leaves.iter().enumerate() {
        for b in near.around(a.middle()).into_iter().filter(|&k| k > i).map(|k| leaves[k]) {
            let area =
                opening(plane, a, b, pixel).filter(|o| !found.iter().any(|f| Box2::of(f).contains(o.centre)));
            if let Some(area) = area {
                erase_inside(ink, &area.grown([-1.0, 1.5 * f64::from(plane.factor)]), erase);
                found.push(area.symbol("sliding-door", 0.8));
            }
        }
    }
    found
}

/// The opening that two leaves close, on the sheet.
fn opening(plane: &Plane, a: &Segment, b: &Segment, pixel: f64) -> Option<Box2> {
    let reach = LEAF[1] / pixel;
    let near = |i: usize| (a.middle()[i] - b.middle()[i]).abs() < reach;
    if !(near(0) && near(1)) {
        return None;
    }
    let frame = Frame::of(a);
    let other = frame.lying(b)?;
    let half = a.length() / 2.0;
    let own = Lying { from: -half, to: half, off: 0.0 };
    let (first, second) = if other.from < own.from { (other, own) } else { (own, other) };
    let (long, short) = (a.length().max(b.length()), a.length().min(b.length()));
    let apart = (first.off - second.off).abs() * pixel;
    let overlap = (first.to - second.from) / long;
    let fits = (APART[0]..=APART[1]).contains(&apart) && (OVERLAP[0]..=OVERLAP[1]).contains(&overlap);
    if !fits || short < 0.78 * long {
        return None;
    }
    let ends = (first.from, second.to);
    let faces = (first.off.min(second.off), first.off.max(second.off));
    let held = is_held(plane, &frame, ends.0, -1.0, faces, pixel)
        && is_held(plane, &frame, ends.1, 1.0, faces, pixel);
    let alone = is_alone(plane, &frame, &first, &second, pixel);
    (held && alone).then(|| on_sheet(plane, &frame, ends, faces))
}

/// Whether a wall goes on beyond an end: inked all through, or by a line across and its faces on either side.
fn is_held(plane: &Plane, frame: &Frame, end: f64, out: f64, (low, high): (f64, f64), pixel: f64) -> bool {
    let middle = (low + high) / 2.0;
    let from = end + out * 2.0;
    let solid =
        plane.covered(frame.at(from, middle), frame.at(from + out * WALL / pixel, middle), 0.5) >= 0.9;
    let half = ((high - low) / 2.0).max(0.05 / pixel);
    let cap = (-2..=4).any(|d| {
        let at = end + out * f64::from(d);
        plane.covered(frame.at(at, middle - half), frame.at(at, middle + half), 0.5) >= 0.9
    });
    let start = end + out * (0.03 / pixel).max(2.0);
    let stop = start + out * WALL / pixel;
    let face = |off: f64| plane.covered(frame.at(start, off), frame.at(stop, off), 0.5) >= 0.9;
    let reach = (0.25 / pixel) as i32;
    let one_side = |sign: f64| (1..=reach).any(|k| face(middle + sign * f64::from(k)));
    cap && (solid || one_side(-1.0) && one_side(1.0))
}

/// Whether the rest of the opening is free: beside each leaf what the other one leaves open, and both sides of the wall.
fn is_alone(plane: &Plane, frame: &Frame, first: &Lying, second: &Lying, pixel: f64) -> bool {
    let inset = 0.12 * (second.to - first.from);
    let covered = |from: f64, to: f64, off: f64| plane.covered(frame.at(from, off), frame.at(to, off), 0.5);
    let out = if second.off > first.off { 1.0 } else { -1.0 };
    let free = covered(first.from + inset, second.from - inset, second.off) < 0.35
        && covered(first.to + inset, second.to - inset, first.off) < 0.35;
    let clear = (0.09 / pixel).max(3.0);
    let whole = |off: f64| covered(first.from + inset, second.to - inset, off) < 0.3;
    free && whole(second.off + out * clear) && whole(first.off - out * clear)
}

fn on_sheet(plane: &Plane, frame: &Frame, (from, to): (f64, f64), (low, high): (f64, f64)) -> Box2 {
    let scale = f64::from(plane.factor);
    Box2 {
        centre: frame.at((from + to) / 2.0, (low + high) / 2.0).map(|v| v * scale),
        along: frame.along,
        half: [(to - from) / 2.0 * scale, (high - low + 1.0) / 2.0 * scale],
    }
}
