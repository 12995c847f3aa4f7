//! Runs: stretches of equal cells in a row, and the components that they make.
//!
//! Maps are a few long runs to the row, so that what is done run by run costs a tenth of what it costs cell by cell.
//! Runs that touch are joined from row to row by union-find (Rosenfeld and Pfaltz, "Sequential Operations in Digital
//! Picture Processing", 1966, on runs).

use planform_sdk::runs::leading;
use std::ops::Range;

/// A stretch of cells in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// Its row.
    pub row: usize,
    /// Its first column.
    pub from: usize,
    /// The column after its last one.
    pub to: usize,
}

impl Run {
    /// The indices of its cells where a row has `width` of them.
    pub fn cells(&self, width: usize) -> Range<usize> {
        self.row * width + self.from..self.row * width + self.to
    }

    /// How many cells it has.
    pub fn length(&self) -> usize {
        self.to - self.from
    }
}

/// The runs of cells that have this value, row by row.
pub fn runs(bits: &[bool], width: usize, value: bool) -> impl Iterator<Item = Run> + '_ {
    let rows = bits.chunks_exact(width.max(1)).enumerate();
    rows.flat_map(move |(row, cells)| {
        let mut at = 0;
        std::iter::from_fn(move || {
            let from = at + find(&cells[at..], value)?;
            at = find(&cells[from..], !value).map_or(cells.len(), |length| from + length);
            Some(Run { row, from, to: at })
        })
    })
}

/// The first cell with this value.
fn find(cells: &[bool], value: bool) -> Option<usize> {
    Some(leading(cells, |&c| c != value)).filter(|&at| at < cells.len())
}

/// The runs of equal labels in a row, as ranges of columns, with their labels.
pub fn label_runs(labels: &[u32]) -> impl Iterator<Item = (Range<usize>, u32)> + '_ {
    let mut at = 0;
    planform_sdk::runs::runs(labels).map(move |run| {
        let from = at;
        at += run.len();
        (from..at, run[0])
    })
}

/// Where a label meets another one to its right or above it, row by row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Meeting {
    /// Its cell.
    pub cell: usize,
    /// The other one's cell.
    pub other: usize,
}

/// Calls for all pairs of cells side by side, or one above the other, that have different labels, none of them 0; by
/// rising cell, the right neighbour first.
pub fn meetings(labels: &[u32], width: usize, mut call: impl FnMut(Meeting)) {
    let runs = |row: usize| {
        let cells = labels.get(row * width..(row + 1) * width).unwrap_or(&[]);
        label_runs(cells).filter(|(_, l)| *l != 0).collect::<Vec<_>>()
    };
    let mut here = runs(0);
    for row in 0..labels.len() / width.max(1) {
        let first = row * width;
        let above = runs(row + 1);
        let mut beyond = 0;
        for (i, (run, label)) in here.iter().enumerate() {
            let right = here.get(i + 1).is_some_and(|(next, _)| next.start == run.end);
            let last = first + run.end - 1;
            let mut told = !right;
            beyond += above[beyond..].iter().take_while(|(a, _)| a.end <= run.start).count();
            let meeting = above[beyond..].iter().take_while(|(a, _)| a.start < run.end);
            for (a, _) in meeting.filter(|(_, l)| l != label) {
                for cell in first + a.start.max(run.start)..first + a.end.min(run.end) {
                    if cell == last && !told {
                        told = true;
                        call(Meeting { cell, other: cell + 1 });
                    }
                    call(Meeting { cell, other: cell + width });
                }
            }
            if !told {
                call(Meeting { cell: last, other: last + 1 });
            }
        }
        here = above;
    }
}

/// The connected components of the cells of one value, as runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// Every run with the number of its component, row by row. Components are numbered from 0 in the order in which
    /// their first cells come.
    pub runs: Vec<(Run, u32)>,
    /// For each component its number of cells.
    pub sizes: Vec<usize>,
    width: usize,
}

impl Parts {
    /// The components of the cells with this value. `corners` joins cells that touch at a corner.
    pub fn of(bits: &[bool], width: usize, value: bool, corners: bool) -> Self {
        let runs: Vec<Run> = runs(bits, width, value).collect();
        let mut union = Union { parent: (0..runs.len() as u32).collect() };
        let reach = usize::from(corners);
        let mut below = 0;
        for (i, run) in runs.iter().enumerate() {
            // The runs of the row below that end before this one begins meet none after it either.
            let is_past = |b: &Run| b.row + 1 < run.row || (b.row < run.row && b.to + reach <= run.from);
            while is_past(&runs[below]) {
                below += 1;
            }
            let meeting = runs[below..i].iter().take_while(|b| b.row < run.row && b.from < run.to + reach);
            for k in below..below + meeting.count() {
                union.join(i as u32, k as u32);
            }
        }
        number(runs, union, width)
    }

    /// The components cell by cell, of a raster of so many cells.
    pub fn components(&self, cells: usize) -> Components {
        let mut label = vec![Components::NONE; cells];
        for (run, part) in &self.runs {
            label[run.cells(self.width)].fill(*part);
        }
        Components { label, sizes: self.sizes.clone() }
    }
}

/// Numbers the components in the order of their first runs.
fn number(runs: Vec<Run>, mut union: Union, width: usize) -> Parts {
    let mut names = vec![Components::NONE; runs.len()];
    let mut sizes = Vec::new();
    let named = |(i, run): (usize, Run)| {
        let root = union.root(i as u32) as usize;
        if names[root] == Components::NONE {
            names[root] = sizes.len() as u32;
            sizes.push(0);
        }
        sizes[names[root] as usize] += run.length();
        (run, names[root])
    };
    let runs = runs.into_iter().enumerate().map(named).collect();
    Parts { runs, sizes, width }
}

/// Runs that were joined point to an earlier one.
struct Union {
    parent: Vec<u32>,
}

impl Union {
    fn root(&mut self, mut run: u32) -> u32 {
        while self.parent[run as usize] != run {
            let above = self.parent[self.parent[run as usize] as usize];
            self.parent[run as usize] = above;
            run = above;
        }
        run
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        let first = a.min(b);
        self.parent[a as usize] = first;
        self.parent[b as usize] = first;
    }
}

/// The connected components of a mask.
#[derive(Debug, Clone, PartialEq)]
pub struct Components {
    /// For each cell the number of its component, or [`Components::NONE`].
    pub label: Vec<u32>,
    /// For each component its number of cells.
    pub sizes: Vec<usize>,
}

impl Components {
    /// The label of a cell in no component.
    pub const NONE: u32 = u32::MAX;
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The components by walking from cell to cell.
    fn walked(bits: &[bool], width: usize, corners: bool) -> Components {
        let mut label = vec![Components::NONE; bits.len()];
        let mut sizes = Vec::new();
        let at = |i: usize| ((i % width) as i64, (i / width) as i64);
        for start in 0..bits.len() {
            if !bits[start] || label[start] != Components::NONE {
                continue;
            }
            let name = sizes.len() as u32;
            sizes.push(0);
            let mut open = vec![start];
            label[start] = name;
            while let Some(i) = open.pop() {
                sizes[name as usize] += 1;
                for j in (0..bits.len()).filter(|&j| bits[j]) {
                    let (dx, dy) = ((at(i).0 - at(j).0).abs(), (at(i).1 - at(j).1).abs());
                    let beside = dx.max(dy) <= 1 && (corners || dx + dy <= 1);
                    if beside && label[j] == Components::NONE {
                        label[j] = name;
                        open.push(j);
                    }
                }
            }
        }
        Components { label, sizes }
    }

    proptest! {
        #[test]
        fn components_are_what_a_walk_reaches(
            (width, bits) in (1..40usize).prop_flat_map(|width| {
                let rows = 1..10usize;
                (Just(width), rows.prop_flat_map(move |r| prop::collection::vec(prop::bool::weighted(0.6), width * r)))
            }),
            corners: bool,
        ) {
            let found = Parts::of(&bits, width, true, corners).components(bits.len());
            prop_assert_eq!(found, walked(&bits, width, corners));
        }

        #[test]
        fn meetings_are_where_labels_differ(labels in prop::collection::vec(0..3u32, 0..300), width in 1..40usize) {
            let labels = &labels[..labels.len() / width * width];
            let mut found = vec![];
            meetings(labels, width, |m| found.push(m));
            let label = |i: usize| labels.get(i).copied().unwrap_or(0);
            let mut expected = vec![];
            for cell in (0..labels.len()).filter(|&i| label(i) != 0) {
                let right = Some(cell + 1).filter(|r| r % width != 0);
                let beside = right.into_iter().chain([cell + width]);
                let differing = beside.filter(|&other| label(other) != 0 && label(other) != label(cell));
                expected.extend(differing.map(|other| Meeting { cell, other }));
            }
            prop_assert_eq!(found, expected);
        }

        #[test]
        fn runs_are_the_cells_of_their_value(bits in prop::collection::vec(prop::bool::ANY, 0..200), value: bool) {
            let width = 37;
            let mut expected = vec![!value; bits.len() / width * width];
            for run in runs(&bits, width, value) {
                expected[run.cells(width)].fill(value);
            }
            prop_assert_eq!(&bits[..expected.len()], &expected[..]);
        }
    }
}
