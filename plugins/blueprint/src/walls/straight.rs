//! How straight ink is: for every pixel the longest straight run of ink through it.

use super::tracks::{TURNS, Track};
use std::thread;

/// The longest straight run through every pixel.
pub struct Straight {
    /// Its length, pixels; 0 on paper.
    pub length: Vec<u16>,
    /// Its direction, in parts of half a turn of which there are [`TURNS`].
    pub turn: Vec<u8>,
}

/// Measures the runs of ink. A run may be a pixel aside, for a slanting line is stairs of pixels.
pub fn runs(ink: &[bool], width: usize) -> Straight {
    let nothing = || Straight { length: vec![0; ink.len()], turn: vec![0; ink.len()] };
    let parts = in_all_directions(ink.len(), width, nothing, |track, longest| along(ink, track, longest));
    parts.into_iter().reduce(Straight::longer).unwrap_or_else(nothing)
}

/// Walks all tracks, the directions shared among the cores, each core with a state of its own.
pub fn in_all_directions<T: Send>(
    pixels: usize,
    width: usize,
    state: impl Fn() -> T + Sync,
    visit: impl Fn(&Track, &mut T) + Sync,
) -> Vec<T> {
    let height = pixels.checked_div(width).unwrap_or(0);
    let cores = planform_sdk::parallel::threads().min(TURNS);
    let part = |core: usize| {
        let mut own = state();
        for turn in (core..TURNS).step_by(cores) {
            Track::all(turn, [width, height], |track| visit(track, &mut own));
        }
        own
    };
    let part = &part;
    thread::scope(|scope| {
        let work: Vec<_> = (0..cores).map(|core| scope.spawn(move || part(core))).collect();
        work.into_iter().filter_map(|w| w.join().ok()).collect()
    })
}

fn along(ink: &[bool], track: &Track, longest: &mut Straight) {
    track.stretches(ink, |from, to| {
        let length = (track.length(to - from)).min(f64::from(u16::MAX)) as u16;
        for p in (from..to).flat_map(|i| track.pixels(i)).filter(|&p| ink[p]) {
            if length > longest.length[p] {
                longest.length[p] = length;
                longest.turn[p] = track.turn as u8;
            }
        }
    });
}

impl Straight {
    /// Of equally long runs the one of the lesser turn, whichever core found it.
    fn longer(mut self, other: Self) -> Self {
        for i in 0..self.length.len() {
            let (a, b) = (self.length[i], other.length[i]);
            if b > a || (b == a && other.turn[i] < self.turn[i]) {
                self.length[i] = b;
                self.turn[i] = other.turn[i];
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_as_long_as_it_is_and_a_corner_no_longer() {
        let (width, height) = (40, 30);
        let ink: Vec<bool> = (0..width * height)
            .map(|i| (i % width, i / width))
            .map(|(x, y)| (y == 20 && (5..35).contains(&x)) || (x == 5 && (8..20).contains(&y)))
            .collect();
        let found = runs(&ink, width);
        assert_eq!(found.length[20 * width + 20], 30);
        assert_eq!(found.turn[20 * width + 20], 0);
        assert_eq!(found.length[10 * width + 5], 13);
        assert_eq!(usize::from(found.turn[10 * width + 5]), TURNS / 2);
        assert_eq!(found.length[0], 0);
    }
}
