//! Lines that leave the building: dimension, grid and leader lines, which run from inside through the outer walls to what
//! is written beside the plan. No wall does that.

use super::distance;
use super::drawing::Drawing;
use super::straight::in_all_directions;

/// A line is outside where it is farther than this from the building, metres.
const BEYOND: f64 = 0.4;

/// Of a line that leaves at least this much lies outside, and as much inside, metres.
const LEAST: f64 = 0.6;

/// The ink of all straight lines that leave the building. `inside`: what its thick walls enclose, walls included.
pub fn lines(drawing: &Drawing, inside: &[bool]) -> Vec<bool> {
    let near = distance::within(inside, drawing.width, BEYOND * drawing.metre);
    let outside: Vec<bool> = near.iter().map(|n| !n).collect();
    let least = (LEAST * drawing.metre).max(2.0);
    let nothing = || vec![false; drawing.ink.len()];
    let parts = in_all_directions(drawing.ink.len(), drawing.width, nothing, |track, out| {
        track.stretches(&drawing.ink, |from, to| {
            let count = |set: &[bool]| track.length((from..to).filter(|&i| track.is(set, i)).count());
            if track.length(to - from) >= 2.0 * least && count(&outside) >= least && count(inside) >= least {
                (from..to)
                    .flat_map(|i| track.pixels(i))
                    .filter(|&p| drawing.ink[p])
                    .for_each(|p| out[p] = true);
            }
        });
    });
    parts.into_iter().fold(nothing(), |mut all, part| {
        all.iter_mut().zip(part).for_each(|(a, p)| *a |= p);
        all
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    #[test]
    fn what_runs_through_the_outer_wall_leaves() {
        let mut ink = Mask::empty(200, 100);
        (0..150).for_each(|x| ink.set[50 * 200 + x] = true);
        (60..190).for_each(|x| ink.set[70 * 200 + x] = true);
        let drawing = Drawing::of_sheet(&ink, 0.05);
        let inside: Vec<bool> = (0..200 * 100).map(|i| i % 200 >= 50).collect();
        let found = lines(&drawing, &inside);
        assert!(found[50 * 200 + 20] && found[50 * 200 + 140]);
        assert!(!found[70 * 200 + 100]);
    }
}
