//! One beam in cell coordinates.

use super::Area;
use crate::log::{Pose, Scan};
use std::ops::Range;

/// A straight way through the grid, in cell coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Where it begins.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// Whether it ends at an obstacle.
    pub hit: bool,
}

/// The beams of a scan that say something, from the pose, as far as they reach, metres: those with an echo. Where
/// nothing came back a beam may have met open space, glass, or a wall at a slant, so it says nothing.
pub fn beams<'a>(scan: &'a Scan, pose: Pose, reach: f64) -> impl Iterator<Item = Ray> + 'a {
    scan.beams().filter(|(_, range)| scan.is_echo(*range)).map(move |(angle, range)| {
        let length = f64::from(range).min(reach);
        let (sin, cos) = (pose.theta + angle).sin_cos();
        let end = [pose.x + length * cos, pose.y + length * sin];
        Ray { end, hit: f64::from(range) <= reach }
    })
}

/// Where a beam ends, metres, and whether at an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Metres.
    pub end: [f64; 2],
    /// Whether there is an obstacle.
    pub hit: bool,
}

impl Beam {
    /// The beam of this ray, from the pose.
    pub fn of(ray: Ray, pose: Pose, area: &Area) -> Self {
        Self { from: area.to_cells([pose.x, pose.y]), to: area.to_cells(ray.end), hit: ray.hit }
    }

    /// The rows that it crosses.
    pub fn rows(&self) -> Range<i64> {
        let (low, high) = ordered(self.from[1], self.to[1]);
        low.floor() as i64..high.floor() as i64 + 1
    }

    /// The columns that it crosses within a row.
    ///
    /// It is of that row alone that these are found, so it does not matter which rows are looked at together.
    pub fn columns(&self, row: i64) -> Range<i64> {
        let (first, last) = ordered(self.at(row as f64), self.at(row as f64 + 1.0));
        first.floor() as i64..last.floor() as i64 + 1
    }

    /// The cell that it ends in: column and row.
    pub fn last(&self) -> [i64; 2] {
        self.to.map(|v| v.floor() as i64)
    }

    /// The x coordinate at this y, or at the nearest one on the beam.
    fn at(&self, y: f64) -> f64 {
        let [dx, dy] = [self.to[0] - self.from[0], self.to[1] - self.from[1]];
        if dy == 0.0 {
            // The whole beam is in one row, which is asked for by both of its ends.
            return if y <= self.from[1] { self.from[0] } else { self.to[0] };
        }
        let share = (y - self.from[1]) / dy;
        match share {
            share if share <= 0.0 => self.from[0],
            share if share >= 1.0 => self.to[0],
            share => self.from[0] + share * dx,
        }
    }
}

fn ordered(a: f64, b: f64) -> (f64, f64) {
    if a <= b { (a, b) } else { (b, a) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(from: [f64; 2], to: [f64; 2]) -> Vec<[i64; 2]> {
        let beam = Beam { from, to, hit: true };
        beam.rows().flat_map(|row| beam.columns(row).map(move |column| [column, row])).collect()
    }

    #[test]
    fn straight_beams_cross_one_line_of_cells() {
        assert_eq!(cells([0.5, 0.5], [2.5, 0.5]), [[0, 0], [1, 0], [2, 0]]);
        assert_eq!(cells([2.5, 0.5], [0.5, 0.5]), [[0, 0], [1, 0], [2, 0]]);
        assert_eq!(cells([0.5, 2.5], [0.5, 0.5]), [[0, 0], [0, 1], [0, 2]]);
        assert_eq!(cells([0.5, 0.5], [0.5, 0.5]), [[0, 0]]);
    }

    #[test]
    fn slanted_beams_cross_whatever_they_touch() {
        assert_eq!(cells([0.5, 0.5], [2.5, 1.5]), [[0, 0], [1, 0], [1, 1], [2, 1]]);
        assert_eq!(cells([-0.5, -0.5], [0.5, 0.6]), [[-1, -1], [-1, 0], [0, 0]]);
    }

    /// Every cell of which a beam crosses the inside, by clipping the beam to it.
    fn clipped(from: [f64; 2], to: [f64; 2], cell: [i64; 2]) -> f64 {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let (a, d) = (from[axis], to[axis] - from[axis]);
            let (low, high) = (cell[axis] as f64, cell[axis] as f64 + 1.0);
            if d == 0.0 {
                if a < low || a >= high {
                    return -1.0;
                }
                continue;
            }
            let (s, t) = ordered((low - a) / d, (high - a) / d);
            (enter, leave) = (enter.max(s), leave.min(t));
        }
        leave - enter
    }

    proptest::proptest! {
        #[test]
        fn beams_cross_the_cells_that_clipping_finds(x in -9.0..9.0, y in -9.0..9.0, u in -9.0..9.0, v in -9.0..9.0) {
            let found = cells([x, y], [u, v]);
            for row in -10..10 {
                for column in -10..10 {
                    let inside = clipped([x, y], [u, v], [column, row]);
                    // What a beam only grazes may be either.
                    if inside.abs() > 1e-9 {
                        proptest::prop_assert_eq!(found.contains(&[column, row]), inside > 0.0);
                    }
                }
            }
        }
    }
}
