//! The connected parts of a mask, as runs of pixels in rows (two-pass labelling of runs with union-find; parts that touch
//! at a corner are connected).

use crate::mask::Mask;
use std::ops::Range;

/// Pixels `x0..x1` of row `y`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// Row.
    pub y: i32,
    /// First column.
    pub x0: i32,
    /// The column after the last.
    pub x1: i32,
}

/// A box of whole pixels, right and bottom exclusive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bounds {
    /// Left.
    pub x0: i32,
    /// Top.
    pub y0: i32,
    /// Right, exclusive.
    pub x1: i32,
    /// Bottom, exclusive.
    pub y1: i32,
}

impl Bounds {
    /// Columns.
    pub fn width(&self) -> i32 {
        self.x1 - self.x0
    }

    /// Rows.
    pub fn height(&self) -> i32 {
        self.y1 - self.y0
    }

    /// The smallest box around both.
    pub fn with(self, o: Self) -> Self {
        Self { x0: self.x0.min(o.x0), y0: self.y0.min(o.y0), x1: self.x1.max(o.x1), y1: self.y1.max(o.y1) }
    }

    /// This box with columns and rows exchanged.
    pub fn transposed(self) -> Self {
        Self { x0: self.y0, y0: self.x0, x1: self.y1, y1: self.x1 }
    }

    /// The box, larger by this much on every side.
    pub fn grown(self, by: i32) -> Self {
        Self { x0: self.x0 - by, y0: self.y0 - by, x1: self.x1 + by, y1: self.y1 + by }
    }

    /// The middle.
    pub fn middle(&self) -> [f64; 2] {
        [f64::from(self.x0 + self.x1) / 2.0, f64::from(self.y0 + self.y1) / 2.0]
    }
}

/// One connected part.
#[derive(Debug, Clone)]
pub struct Component {
    /// Its box.
    pub bounds: Bounds,
    /// Its pixels.
    pub area: i64,
    runs: Range<usize>,
}

/// All connected parts of a mask, in the order of their first pixels.
#[derive(Debug, Default)]
pub struct Components {
    /// The parts.
    pub list: Vec<Component>,
    runs: Vec<Run>,
}

impl Components {
    /// The parts of this mask.
    pub fn of(mask: &Mask) -> Self {
        let (runs, rows) = all_runs(mask);
        let labels = labels(&runs, &rows);
        gather(&runs, &labels)
    }

    /// The pixels of a part, row by row.
    pub fn runs(&self, part: &Component) -> &[Run] {
        &self.runs[part.runs.clone()]
    }
}

/// All runs row by row, and where each row's begin.
fn all_runs(mask: &Mask) -> (Vec<Run>, Vec<usize>) {
    let width = (mask.width as usize).max(1);
    let (mut runs, mut rows) = (Vec::new(), vec![0]);
    for (y, row) in mask.set.chunks_exact(width).enumerate() {
        let mut x = 0;
        while let Some(start) = row[x..].iter().position(|&s| s).map(|i| x + i) {
            let end = row[start..].iter().position(|&s| !s).map_or(width, |i| start + i);
            runs.push(Run { y: y as i32, x0: start as i32, x1: end as i32 });
            x = end;
        }
        rows.push(runs.len());
    }
    (runs, rows)
}

/// For every run the first run of its part.
fn labels(runs: &[Run], rows: &[usize]) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..runs.len() as u32).collect();
    for pair in rows.windows(3) {
        join_rows(&mut parent, runs, pair[0]..pair[1], pair[1]..pair[2]);
    }
    // Parents come before their children, so that one pass is enough.
    for i in 0..parent.len() {
        parent[i] = parent[parent[i] as usize];
    }
    parent
}

/// Joins the runs of two rows that touch.
fn join_rows(parent: &mut [u32], runs: &[Run], above: Range<usize>, below: Range<usize>) {
    let (mut a, mut b) = (above.start, below.start);
    while a < above.end && b < below.end {
        if runs[a].x0 <= runs[b].x1 && runs[b].x0 <= runs[a].x1 {
            join(parent, a as u32, b as u32);
        }
        if runs[a].x1 < runs[b].x1 { a += 1 } else { b += 1 }
    }
}

fn join(parent: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parent, a), root(parent, b));
    parent[a.max(b) as usize] = a.min(b);
}

fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Sorts the runs by their parts, keeping the order within each.
fn gather(runs: &[Run], labels: &[u32]) -> Components {
    let mut numbers = vec![0_u32; runs.len()];
    let mut list: Vec<Component> = Vec::new();
    for (i, (run, &label)) in runs.iter().zip(labels).enumerate() {
        if label as usize == i {
            numbers[i] = list.len() as u32;
            let bounds = Bounds { x0: run.x0, y0: run.y, x1: run.x1, y1: run.y + 1 };
            list.push(Component { bounds, area: 0, runs: 0..0 });
        }
        let part = &mut list[numbers[label as usize] as usize];
        part.bounds = part.bounds.with(Bounds { x0: run.x0, y0: run.y, x1: run.x1, y1: run.y + 1 });
        part.area += i64::from(run.x1 - run.x0);
        part.runs.end += 1;
    }
    let mut start = 0;
    for part in &mut list {
        let count = part.runs.end;
        part.runs = start..start;
        start += count;
    }
    let mut sorted = runs.to_vec();
    for (run, &label) in runs.iter().zip(labels) {
        let part = &mut list[numbers[label as usize] as usize];
        sorted[part.runs.end] = *run;
        part.runs.end += 1;
    }
    Components { list, runs: sorted }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::drawn::mask;

    #[test]
    fn parts_touch_at_corners() {
        let m = mask(&["#..#", ".#.#", "...#", "#..."]);
        let parts = Components::of(&m);
        let areas: Vec<_> = parts.list.iter().map(|p| p.area).collect();
        assert_eq!(areas, [2, 3, 1]);
        assert_eq!(parts.list[1].bounds, Bounds { x0: 3, y0: 0, x1: 4, y1: 3 });
    }

    #[test]
    fn a_part_may_be_joined_late() {
        let m = mask(&["#.#.#", "#.#.#", "#####"]);
        let parts = Components::of(&m);
        assert_eq!(parts.list.len(), 1);
        assert_eq!(parts.runs(&parts.list[0]).len(), 7);
        assert!(parts.runs(&parts.list[0]).is_sorted_by_key(|r| (r.y, r.x0)));
    }

    #[test]
    fn an_empty_mask_has_none() {
        assert!(Components::of(&Mask::empty(0, 0)).list.is_empty());
        assert!(Components::of(&Mask::empty(5, 5)).list.is_empty());
    }
}
