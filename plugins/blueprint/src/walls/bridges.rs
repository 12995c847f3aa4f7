//! Gaps in line: where a line of ink stops and goes on, or meets a wall, within a door's width.

use super::straight::{self, Straight};
use super::tracks::Track;

/// What a bridge may be, pixels.
#[derive(Debug, Clone, Copy)]
pub struct Span {
    /// The least length of the lines that it joins.
    pub line: f64,
    /// The widest gap.
    pub reach: f64,
}

/// The pixels of gaps that a line of ink points across, at a wall or at another line.
pub fn find(ink: &[bool], wall: &[bool], lines: &Straight, width: usize, span: Span) -> Vec<bool> {
    let solid: Vec<bool> = ink.iter().zip(wall).map(|(i, w)| i | w).collect();
    let nothing = || vec![false; ink.len()];
    let view = View { ink, solid: &solid, wall, lines, span };
    let parts = straight::in_all_directions(ink.len(), width, nothing, |track, out| view.along(track, out));
    let either = |mut a: Vec<bool>, b: Vec<bool>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a |= b);
        a
    };
    parts.into_iter().reduce(either).unwrap_or_default()
}

struct View<'a> {
    ink: &'a [bool],
    /// Ink and walls.
    solid: &'a [bool],
    wall: &'a [bool],
    lines: &'a Straight,
    span: Span,
}

impl View<'_> {
    fn along(&self, track: &Track, out: &mut [bool]) {
        track.stretches(self.ink, |from, to| {
            if self.is_line(track, from, to) {
                self.bridge(track, to..track.steps, out);
                self.bridge(track, (0..from).rev(), out);
            }
        });
    }

    /// Whether these steps are a line in the track's direction, not one that the track crosses.
    fn is_line(&self, track: &Track, from: usize, to: usize) -> bool {
        let length = track.length(to - from);
        length >= self.span.line && self.longest(track, (from + to) / 2) <= length * 1.05 + 2.0
    }

    fn longest(&self, track: &Track, step: usize) -> f64 {
        track.pixels(step).map(|p| f64::from(self.lines.length[p])).fold(0.0, f64::max)
    }

    fn bridge(&self, track: &Track, ahead: impl Iterator<Item = usize> + Clone, out: &mut [bool]) {
        let far = track.steps_in(self.span.reach);
        let met = ahead.clone().take(far + 1).enumerate().find(|&(_, step)| track.is(self.solid, step));
        let Some((gap, step)) = met else { return };
        if track.is(self.wall, step) || self.longest(track, step) >= self.span.line {
            ahead.take(gap).flat_map(|step| track.pixels(step)).for_each(|p| out[p] = true);
        }
    }
}
