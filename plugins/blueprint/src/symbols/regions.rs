//! Regions of paper that lines enclose: a bowl is one, its basin around it another, a leaf drawn as a box a third. Unlike
//! strokes they stay apart from what the lines touch.

use super::plane::Plane;
use crate::mask::Mask;

/// Pixels without ink that hang together, corners not included.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Left, top, right and bottom, pixels of the plane; the last two are one past.
    pub bounds: [u32; 4],
    /// How many pixels.
    pub area: u32,
    /// For every row from the top: where it begins, and one past where it ends.
    pub rows: Vec<[u32; 2]>,
}

/// A row's pixels without ink, from one past the ink to the next.
#[derive(Clone, Copy)]
struct Run {
    row: u32,
    from: u32,
    to: u32,
}

impl Region {
    /// Columns and rows.
    pub fn size(&self) -> [f64; 2] {
        let [left, top, right, bottom] = self.bounds;
        [f64::from(right - left), f64::from(bottom - top)]
    }

    /// Its middle, pixels of the plane.
    pub fn middle(&self) -> [f64; 2] {
        let [left, top, right, bottom] = self.bounds.map(f64::from);
        [(left + right) / 2.0, (top + bottom) / 2.0]
    }

    /// The share of its bounds that it fills, islands in it included.
    pub fn fullness(&self) -> f64 {
        let [width, height] = self.size();
        self.rows.iter().map(|[from, to]| f64::from(to - from)).sum::<f64>() / (width * height)
    }

    /// How far its outline is off an ellipse that fills its bounds, as a share of its size, on the left, right, upper and
    /// lower half. Islands in it do not count.
    pub fn off_ellipse(&self) -> [f64; 4] {
        let [cx, cy] = self.middle();
        let [a, b] = self.size().map(|s| s / 2.0);
        let (mut off, mut rows) = ([0.0; 4], [0.0; 2]);
        for (row, &[from, to]) in (self.bounds[1]..).zip(&self.rows) {
            let v = (f64::from(row) + 0.5 - cy) / b;
            let half = a * (1.0 - v * v).max(0.0).sqrt();
            let [left, right] = [(f64::from(from) - cx + half).abs(), (f64::from(to) - cx - half).abs()];
            let vertical = if v < 0.0 { 2 } else { 3 };
            off[0] += left;
            off[1] += right;
            off[vertical] += left + right;
            rows[vertical - 2] += 1.0;
        }
        let all = rows[0] + rows[1];
        let share = |sum: f64, rows: f64| sum / (rows * a).max(1.0);
        [share(off[0], all), share(off[1], all), share(off[2], 2.0 * rows[0]), share(off[3], 2.0 * rows[1])]
    }
}

/// All regions whose bounds are at least `least` and at most `most` pixels wide and high, by where they begin, row by row.
pub fn regions(plane: &Plane, least: f64, most: f64) -> Vec<Region> {
    let runs = runs(&plane.mask);
    let roots = roots(&runs);
    let bounds = bounds(&runs, &roots);
    let sized = |b: &[u32; 4]| {
        let [w, h] = [b[2] - b[0], b[3] - b[1]].map(f64::from);
        w.min(h) >= least && w.max(h) <= most
    };
    let mut places = vec![u32::MAX; runs.len()];
    let mut found: Vec<Region> = Vec::new();
    for (run, &root) in runs.iter().zip(&roots) {
        let b = bounds[root as usize];
        if !sized(&b) {
            continue;
        }
        let place = &mut places[root as usize];
        if *place == u32::MAX {
            *place = found.len() as u32;
            found.push(Region { bounds: b, area: 0, rows: vec![[u32::MAX, 0]; (b[3] - b[1]) as usize] });
        }
        let region = &mut found[*place as usize];
        let [from, to] = &mut region.rows[(run.row - b[1]) as usize];
        (*from, *to) = ((*from).min(run.from), (*to).max(run.to));
        region.area += run.to - run.from;
    }
    found
}

fn runs(ink: &Mask) -> Vec<Run> {
    let mut runs = Vec::new();
    for (row, line) in (0..).zip(ink.set.chunks_exact(ink.width.max(1) as usize)) {
        let mut from = 0;
        for part in line.split_inclusive(|&set| set) {
            let end = from + part.len() as u32;
            let to = if part.last() == Some(&true) { end - 1 } else { end };
            if to > from {
                runs.push(Run { row, from, to });
            }
            from = end;
        }
    }
    runs
}

/// For each run the first one that it hangs together with.
fn roots(runs: &[Run]) -> Vec<u32> {
    let mut parents: Vec<u32> = (0..runs.len() as u32).collect();
    let mut above = 0;
    for i in 0..runs.len() {
        let own = runs[i];
        while above < i && (runs[above].row + 1 < own.row || is_before(&runs[above], &own)) {
            above += 1;
        }
        let mut k = above;
        while k < i && runs[k].row + 1 == own.row && runs[k].from < own.to {
            join(&mut parents, k as u32, i as u32);
            k += 1;
        }
    }
    (0..runs.len() as u32).map(|i| root(&mut parents, i)).collect()
}

/// Whether a run of the row above ends before this one begins.
fn is_before(above: &Run, own: &Run) -> bool {
    above.row + 1 == own.row && above.to <= own.from
}

fn root(parents: &mut [u32], mut i: u32) -> u32 {
    while parents[i as usize] != i {
        parents[i as usize] = parents[parents[i as usize] as usize];
        i = parents[i as usize];
    }
    i
}

fn join(parents: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a.max(b) as usize] = a.min(b);
}

fn bounds(runs: &[Run], roots: &[u32]) -> Vec<[u32; 4]> {
    let mut bounds = vec![[u32::MAX, u32::MAX, 0, 0]; runs.len()];
    for (run, &root) in runs.iter().zip(roots) {
        let b = &mut bounds[root as usize];
        *b = [b[0].min(run.from), b[1].min(run.row), b[2].max(run.to), b[3].max(run.row + 1)];
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(width: u32, height: u32, inked: impl Fn(f64, f64) -> bool) -> Plane {
        let place = |i: u32| (f64::from(i % width) + 0.5, f64::from(i / width) + 0.5);
        let set = (0..width * height).map(|i| inked(place(i).0, place(i).1)).collect();
        Plane { mask: Mask { width, height, set }, factor: 1 }
    }

    #[test]
    fn a_ring_encloses_a_region_that_is_round() {
        let ring = plane(60, 50, |x, y| {
            let r = ((x - 30.0) / 20.0).hypot((y - 25.0) / 15.0);
            (1.0..1.15).contains(&r)
        });
        let found = regions(&ring, 5.0, 45.0);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].bounds, found[0].middle()), ([10, 10, 50, 40], [30.0, 25.0]));
        assert!(found[0].off_ellipse().iter().all(|&o| o < 0.04), "{:?}", found[0].off_ellipse());
        assert!((found[0].fullness() - 0.785).abs() < 0.02);
    }

    #[test]
    fn a_box_is_not_round_and_what_leaks_is_no_region() {
        let side = |x: f64, y: f64| (x - 30.0).abs().max((y - 25.0).abs());
        let drawn = plane(60, 50, |x, y| (15.0..16.0).contains(&side(x, y)));
        let found = regions(&drawn, 5.0, 45.0);
        assert_eq!((found.len(), found[0].area), (1, 900));
        assert!(found[0].off_ellipse().iter().all(|&o| o > 0.15), "{:?}", found[0].off_ellipse());
        let open = plane(60, 50, |x, y| (15.0..16.0).contains(&side(x, y)) && !(20.0..22.0).contains(&y));
        assert!(regions(&open, 5.0, 45.0).is_empty());
    }

    #[test]
    fn parts_that_meet_below_are_one_region() {
        let rows = ["#########", "#..#..#.#", "#..#..#.#", "#.....#.#", "#########"];
        let set = rows.iter().flat_map(|r| r.bytes().map(|b| b == b'#')).collect();
        let found = regions(&Plane { mask: Mask { width: 9, height: 5, set }, factor: 1 }, 1.0, 8.0);
        let told: Vec<_> = found.iter().map(|r| (r.bounds, r.area)).collect();
        assert_eq!(told, [([1, 1, 6, 4], 13), ([7, 1, 8, 4], 3)]);
    }
}
