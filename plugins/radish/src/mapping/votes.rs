//! Counts what beams say of each cell, on all cores.

use super::Area;
use super::beam::{Beam, beams};
use crate::log::{Pose, Scan};
use std::ops::Range;
use std::sync::Mutex;
use std::thread;

/// How many bands of rows each thread has to do, so that one full of beams does not keep all waiting.
const BANDS_EACH: usize = 4;

/// How many beams end in a cell, and how many pass through it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Votes {
    /// Beams that end here at an obstacle.
    pub ends: u32,
    /// Beams that go on, or whose reach ends here.
    pub passes: u32,
}

/// The votes for each cell of the area, row by row from the bottom.
pub fn count(placed: &[(&Scan, Pose)], area: &Area, reach: f64) -> Vec<Votes> {
    count_with(placed, area, reach, planform_sdk::parallel::threads())
}

/// The same with so many threads. Each cell is counted by one of them.
fn count_with(placed: &[(&Scan, Pose)], area: &Area, reach: f64, threads: usize) -> Vec<Votes> {
    let (width, height) = (area.width as usize, area.height as usize);
    let mut votes = vec![Votes::default(); width * height];
    let sweeps: Vec<_> = placed.iter().map(|(scan, pose)| Sweep::of(scan, *pose, area, reach)).collect();
    let rows = height.div_ceil(threads * BANDS_EACH);
    let bands = Mutex::new((0_i64..).step_by(rows).zip(votes.chunks_mut(rows * width)));
    let work = || {
        while let Some((first, cells)) = next(&bands) {
            let mut band = Band { first, width, cells };
            sweeps.iter().for_each(|sweep| band.sweep(sweep, area, reach));
        }
    };
    thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    votes
}

fn next<T>(bands: &Mutex<impl Iterator<Item = T>>) -> Option<T> {
    bands.lock().ok()?.next()
}

/// A scan at its place.
struct Sweep<'a> {
    scan: &'a Scan,
    pose: Pose,
    /// The rows that its beams cross.
    rows: Range<i64>,
}

impl<'a> Sweep<'a> {
    fn of(scan: &'a Scan, pose: Pose, area: &Area, reach: f64) -> Self {
        let rows = beams(scan, pose, reach).map(|ray| Beam::of(ray, pose, area).rows());
        let rows = rows.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end)).unwrap_or(0..0);
        Self { scan, pose, rows }
    }
}

/// Some rows of the grid.
struct Band<'a> {
    first: i64,
    width: usize,
    cells: &'a mut [Votes],
}

impl Band<'_> {
    /// Adds the votes of a scan.
    fn sweep(&mut self, sweep: &Sweep<'_>, area: &Area, reach: f64) {
        if !self.within(&sweep.rows).is_empty() {
            let rays = beams(sweep.scan, sweep.pose, reach);
            rays.for_each(|ray| self.beam(&Beam::of(ray, sweep.pose, area)));
        }
    }

    fn beam(&mut self, beam: &Beam) {
        for row in self.within(&beam.rows()) {
            let columns = beam.columns(row);
            let start = self.index(columns.start, row);
            let crossed = self.cells.get_mut(start..start + columns.count());
            crossed.unwrap_or_default().iter_mut().for_each(|v| v.passes += 1);
        }
        let [column, row] = beam.last();
        if beam.hit && !self.within(&(row..row + 1)).is_empty() {
            let last = self.index(column, row);
            // It was counted as one that is passed.
            self.cells
                .get_mut(last)
                .into_iter()
                .for_each(|v| (v.ends, v.passes) = (v.ends + 1, v.passes.saturating_sub(1)));
        }
    }

    /// Those of the rows that are in this band.
    fn within(&self, rows: &Range<i64>) -> Range<i64> {
        let end = self.first + (self.cells.len() / self.width) as i64;
        rows.start.max(self.first)..rows.end.min(end)
    }

    /// Where a cell of this band is kept; the area holds all beams.
    fn index(&self, column: i64, row: i64) -> usize {
        (row - self.first) as usize * self.width + column as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mapping::{MappingParams, Odds};

    const REACH: f64 = 6.0;

    /// A laser that turns and moves between walls of odd shapes.
    fn scans() -> Vec<Scan> {
        let ranges = |i: usize| (0..90).map(|j| ((i * 7 + j * 13) % 83) as f32 * 0.1 - 0.2).collect();
        let pose = |i: usize| Pose { x: i as f64 * 0.37, y: (i as f64 * 0.7).sin(), theta: i as f64 * 0.9 };
        let scan = |i| Scan {
            ranges: ranges(i),
            first_angle: -1.5,
            step: 0.04,
            max_range: 8.0,
            pose: pose(i),
            odometry: None,
            time: 0.0,
        };
        (0..20).map(scan).collect()
    }

    fn area(placed: &[(&Scan, Pose)]) -> Area {
        let odds = Odds { hit: 0.7, miss: 0.4 };
        Area::of(placed, &MappingParams { resolution: 0.05, reach: REACH, odds }).unwrap()
    }

    /// The votes by walking along each beam from one crossed line of the grid to the next.
    fn walked(placed: &[(&Scan, Pose)], area: &Area) -> Vec<Votes> {
        let mut votes = vec![Votes::default(); area.width as usize * area.height as usize];
        for (scan, pose) in placed {
            for (i, range) in scan.ranges.iter().map(|r| f64::from(*r)).enumerate() {
                if range <= 0.0 || range >= scan.max_range {
                    continue;
                }
                let angle = pose.theta + scan.first_angle + i as f64 * scan.step;
                let end = |d: f64| [pose.x + d * angle.cos(), pose.y + d * angle.sin()];
                let (from, to) = (area.to_cells(end(0.0)), area.to_cells(end(range.min(REACH))));
                let lines = (0..2).flat_map(|axis| {
                    let (a, b) = (from[axis], to[axis]);
                    let between = (a.min(b).ceil() as i64)..=(a.max(b).floor() as i64);
                    between.map(move |line| (line as f64 - a) / (b - a))
                });
                let mut shares: Vec<f64> =
                    lines.chain([0.0, 1.0]).filter(|s| (0.0..=1.0).contains(s)).collect();
                shares.sort_by(f64::total_cmp);
                let mut cells: Vec<usize> = shares
                    .windows(2)
                    .map(|s| (s[0] + s[1]) / 2.0)
                    .chain([1.0])
                    .map(|s| [0, 1].map(|k| (from[k] + s * (to[k] - from[k])).floor() as usize))
                    .map(|[x, y]| y * area.width as usize + x)
                    .collect();
                cells.dedup();
                let last = cells.pop().unwrap();
                cells.iter().for_each(|c| votes[*c].passes += 1);
                if range <= REACH { votes[last].ends += 1 } else { votes[last].passes += 1 }
            }
        }
        votes
    }

    #[test]
    fn the_votes_are_those_of_walking_along_each_beam() {
        let scans = scans();
        let placed: Vec<_> = scans.iter().map(|s| (s, s.pose)).collect();
        let area = area(&placed);
        let (found, expected) = (count(&placed, &area, REACH), walked(&placed, &area));
        let total = |votes: &[Votes]| votes.iter().map(|v| v.ends + v.passes).sum::<u32>();
        assert!(total(&expected) > 50_000);
        let differ = found.iter().zip(&expected).filter(|(a, b)| a != b).count();
        // Rounding may put what only touches a cell's corner into either.
        assert!(differ <= 2, "{differ} of {} cells differ", found.len());
    }

    #[test]
    fn the_number_of_threads_changes_nothing() {
        let scans = scans();
        let placed: Vec<_> = scans.iter().map(|s| (s, s.pose)).collect();
        let area = area(&placed);
        let one = count_with(&placed, &area, REACH, 1);
        for threads in [2, 3, 7, 64] {
            assert!(count_with(&placed, &area, REACH, threads) == one, "{threads} threads");
        }
    }
}
