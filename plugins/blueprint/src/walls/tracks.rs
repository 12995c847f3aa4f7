//! Parallel digital lines that cover a picture, to walk it in any direction.

use std::f64::consts::PI;

/// In how many directions pictures are walked: every 7.5 degrees.
pub const TURNS: usize = 24;

/// One digital line, two pixels wide, so that no line of ink slips through between its pixels.
pub struct Track<'a> {
    /// Its direction, in parts of half a turn of which there are [`TURNS`].
    pub turn: usize,
    /// How many steps it has.
    pub steps: usize,
    /// The length of one step, pixels.
    stretch: f64,
    rise: &'a [i64],
    offset: i64,
    flat: bool,
    width: usize,
    across: i64,
}

impl Track<'_> {
    /// Visits all tracks of one direction.
    pub fn all(turn: usize, [width, height]: [usize; 2], mut visit: impl FnMut(&Track)) {
        let (sin, cos) = (turn as f64 * PI / TURNS as f64).sin_cos();
        let flat = cos.abs() >= sin.abs();
        let slope = if flat { sin / cos } else { cos / sin };
        let (steps, across) = if flat { (width, height as i64) } else { (height, width as i64) };
        let rise: Vec<i64> = (0..steps).map(|i| (i as f64 * slope).round() as i64).collect();
        let last = rise.last().copied().unwrap_or(0);
        for offset in -last.max(0) - 1..across - last.min(0) {
            let stretch = 1.0f64.hypot(slope);
            visit(&Track { turn, steps, stretch, rise: &rise, offset, flat, width, across });
        }
    }

    /// The pixels of a step: two, or fewer at the picture's edge.
    pub fn pixels(&self, step: usize) -> impl Iterator<Item = usize> + use<> {
        let j = self.offset + self.rise[step];
        let (flat, width, across) = (self.flat, self.width, self.across);
        let inside = move |j: &i64| (0..across).contains(j);
        let at = move |j: i64| if flat { j as usize * width + step } else { step * width + j as usize };
        [j, j + 1].into_iter().filter(inside).map(at)
    }

    /// Whether a pixel of this step is set.
    pub fn is(&self, set: &[bool], step: usize) -> bool {
        self.pixels(step).any(|p| set[p])
    }

    /// The length of so many steps, pixels.
    pub fn length(&self, steps: usize) -> f64 {
        steps as f64 * self.stretch
    }

    /// How many steps are at most so long.
    pub fn steps_in(&self, pixels: f64) -> usize {
        (pixels / self.stretch) as usize
    }

    /// Visits every stretch of steps that are set: the first step, and the one after the last.
    pub fn stretches(&self, set: &[bool], mut visit: impl FnMut(usize, usize)) {
        let mut from = None;
        for step in 0..=self.steps {
            let is = step < self.steps && self.is(set, step);
            match from {
                None if is => from = Some(step),
                Some(first) if !is => {
                    visit(first, step);
                    from = None;
                }
                _ => {}
            }
        }
    }
}
