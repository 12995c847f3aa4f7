//! Lifts: a rectangle with both diagonals.

use super::near::Near;
use super::plane::{Plane, Vec2, direction, distance, dot};
use super::shapes::{Box2, erase_inside};
use super::strokes::Segment;
use crate::found::SheetSymbol;
use crate::mask::Mask;

/// Sides of a cabin, metres.
const SIDES: [f64; 2] = [0.8, 3.5];
/// The share of each side that must be drawn.
const LEAST_SIDE: f64 = 0.75;

/// All lifts of the plane, and what draws them; the rectangle itself may be a wall and stays.
pub fn find(
    plane: &Plane,
    ink: &Mask,
    segments: &[Segment],
    pixel: f64,
    erase: &mut Mask,
) -> Vec<SheetSymbol> {
    let diagonal = |s: &&Segment| (SIDES[0] * 1.4..=SIDES[1] * 1.5).contains(&(s.length() * pixel));
    let diagonals: Vec<&Segment> = segments.iter().filter(diagonal).collect();
    let mut found = Vec::new();
    let near = Near::of(diagonals.iter().map(|d| d.middle()), together(SIDES[1] * 1.5 / pixel));
    for (i, a) in diagonals.iter().enumerate() {
        for b in near.around(a.middle()).into_iter().filter(|&k| k > i).map(|k| diagonals[k]) {
            if let Some(area) = cabin(plane, a, b, pixel) {
                erase_inside(ink, &area.grown([-2.0 * f64::from(plane.factor); 2]), erase);
                found.push(area.symbol("lift", 0.9));
            }
        }
    }
    found
}

/// The middles of two diagonals of this length are closer to each other.
fn together(long: f64) -> f64 {
    0.06 * long + 1.0
}

/// The rectangle whose diagonals these are, on the sheet.
fn cabin(plane: &Plane, a: &Segment, b: &Segment, pixel: f64) -> Option<Box2> {
    let (long, short) = (a.length().max(b.length()), a.length().min(b.length()));
    let crossed = distance(a.middle(), b.middle()) < together(long) && short > 0.88 * long;
    if !crossed || dot(a.along(), b.along()).abs() > 0.9 {
        return None;
    }
    let corners = [a.a, b.a, a.b, b.b];
    let side = |i: usize| (corners[i], corners[(i + 1) % 4]);
    let sized = (0..4).all(|i| (SIDES[0]..=SIDES[1]).contains(&(distance(side(i).0, side(i).1) * pixel)));
    let reach = (0.1 * long).max(2.5);
    let drawn = (0..4).all(|i| plane.covered(side(i).0, side(i).1, reach) >= LEAST_SIDE);
    (sized && drawn).then(|| on_sheet(plane, &corners))
}

fn on_sheet(plane: &Plane, corners: &[Vec2; 4]) -> Box2 {
    let scale = f64::from(plane.factor);
    let (along, length) = direction(corners[0], corners[1]);
    let height = distance(corners[1], corners[2]);
    let middle = [0, 1].map(|i| corners.iter().map(|c| c[i]).sum::<f64>() / 4.0 * scale);
    Box2 { centre: middle, along, half: [length / 2.0 * scale, height / 2.0 * scale] }
}
