//! Windows: two or more thin lines side by side between the ends of a wall.

use super::plane::Plane;
use super::runs::{Frame, Lying, beside};
use super::shapes::Box2;
use super::strokes::Segment;
use crate::found::SheetSymbol;
use crate::sheet::Sheet;

/// Length of a window, metres.
const LENGTH: [f64; 2] = [0.35, 6.0];
/// Thickness of the wall it is in, metres.
const THICKNESS: [f64; 2] = [0.06, 0.65];
/// A wall's filling or hatching is darker than a window by this much of 255.
const LIGHTER: f64 = 14.0;
/// The share of the wall's thickness beside a window that is inked if the wall is solid.
const SOLID: f64 = 0.85;

/// All windows of the plane.
pub fn find(sheet: &Sheet, plane: &Plane, segments: &[Segment], pixel: f64) -> Vec<SheetSymbol> {
    let mut taken = vec![false; segments.len()];
    let mut found = Vec::new();
    for i in 0..segments.len() {
        let length = segments[i].length() * pixel;
        if taken[i] || !(LENGTH[0]..=LENGTH[1]).contains(&length) {
            continue;
        }
        let slack = (0.08 / pixel).max(3.0);
        let (frame, lines) = beside(segments, i, THICKNESS[1] / pixel, slack);
        if let Some(area) = window(sheet, plane, &frame, &lines, pixel) {
            lines.iter().for_each(|(k, _)| taken[*k] = true);
            found.push(area.symbol("window", 0.8));
        }
    }
    found
}

/// The window that these lines draw: two or three between solid ends, or three between the lines of a wall's faces.
fn window(sheet: &Sheet, plane: &Plane, frame: &Frame, lines: &[(usize, Lying)], pixel: f64) -> Option<Box2> {
    let (low, high) = (lines.first()?.1.off, lines.last()?.1.off);
    if !(2..=5).contains(&lines.len())
        || !(THICKNESS[0]..=THICKNESS[1]).contains(&((high - low + 1.0) * pixel))
    {
        return None;
    }
    let mean = |f: fn(&Lying) -> f64| lines.iter().map(|(_, l)| f(l)).sum::<f64>() / lines.len() as f64;
    let (from, to) = (mean(|l| l.from), mean(|l| l.to));
    let ends = [(from, -1.0), (to, 1.0)];
    let solid = ends.iter().all(|&(end, out)| is_solid(plane, frame, end, out, [low, high]));
    let shown = lines.len() >= 3 || is_lighter(sheet, plane, frame, [from, to], [low, high]);
    let lined = shown && ends.iter().all(|&(end, out)| is_lined(plane, frame, end, out, [low, high]));
    let alone = is_free_beside(plane, frame, [from, to], [low, high], pixel);
    ((solid || lined) && alone).then(|| on_sheet(plane, frame, [from, to], [low, high]))
}

/// Whether the wall beyond an end is inked all through.
fn is_solid(plane: &Plane, frame: &Frame, end: f64, out: f64, [low, high]: [f64; 2]) -> bool {
    [4.0, 6.0, 8.0].iter().filter(|&&d| across(plane, frame, end + out * d, low, high) >= SOLID).count() >= 2
}

/// Whether a line across ends the window, and the wall's faces go on beyond it with paper or filling between.
fn is_lined(plane: &Plane, frame: &Frame, end: f64, out: f64, [low, high]: [f64; 2]) -> bool {
    let cap = [0.0, 1.0, 2.0, 3.0].iter().any(|&d| across(plane, frame, end + out * d, low, high) >= 0.95);
    let face =
        |off: f64| plane.covered(frame.at(end + out * 3.0, off), frame.at(end + out * 10.0, off), 1.5) >= 0.9;
    cap && face(low) && face(high)
}

/// Whether the wall's filling or hatching ends where the window begins.
fn is_lighter(
    sheet: &Sheet,
    plane: &Plane,
    frame: &Frame,
    [from, to]: [f64; 2],
    [low, high]: [f64; 2],
) -> bool {
    let middle = (from + to) / 2.0;
    let inside = lightness(sheet, plane, frame, middle, [low, high]);
    [from - 8.0, to + 8.0]
        .iter()
        .all(|&at| lightness(sheet, plane, frame, at, [low, high]) + LIGHTER < inside)
}

/// The mean grey between two lines, around one place along them.
fn lightness(sheet: &Sheet, plane: &Plane, frame: &Frame, along: f64, [low, high]: [f64; 2]) -> f64 {
    let scale = f64::from(plane.factor);
    let grey = |i: i32, k: i32| {
        let off = low + (high - low) * (0.25 + 0.5 * f64::from(k) / 8.0);
        let [x, y] = frame.at(along + f64::from(i) / 3.0, off).map(|v| (v * scale).max(0.0) as u32);
        let p = sheet.colour.get_pixel_checked(x, y).map_or([255; 3], |p| p.0);
        p.iter().map(|&c| f64::from(c)).sum::<f64>() / 3.0
    };
    (-12..=12).flat_map(|i| (0..=8).map(move |k| (i, k))).map(|(i, k)| grey(i, k)).sum::<f64>() / 225.0
}

fn across(plane: &Plane, frame: &Frame, along: f64, low: f64, high: f64) -> f64 {
    plane.covered(frame.at(along, low), frame.at(along, high), 0.5)
}

/// Whether no more such lines lie close beside, as in stairs, shelves and hatching.
fn is_free_beside(
    plane: &Plane,
    frame: &Frame,
    [from, to]: [f64; 2],
    [low, high]: [f64; 2],
    pixel: f64,
) -> bool {
    let clear = (0.12 / pixel).max(3.5);
    [low - clear, high + clear]
        .iter()
        .all(|&off| plane.covered(frame.at(from, off), frame.at(to, off), 0.5) < 0.5)
}

fn on_sheet(plane: &Plane, frame: &Frame, [from, to]: [f64; 2], [low, high]: [f64; 2]) -> Box2 {
    let scale = f64::from(plane.factor);
    Box2 {
        centre: frame.at((from + to) / 2.0, (low + high) / 2.0).map(|v| v * scale),
        along: frame.along,
        half: [(to - from) / 2.0 * scale, (high - low + 1.0) / 2.0 * scale],
    }
}
