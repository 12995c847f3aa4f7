//! Where one gets from each cell by always stepping to the highest neighbour: up to a peak.
//!
//! The cells of one peak are a slope. Slopes that meet hardly below the lower one's peak are joined, the highest meeting
//! first. Only the cells where slopes meet have to be put in order for that, so that a watershed costs little more than a
//! look at each cell's neighbours. Of two cells of equal height the one that comes first counts as higher.

use super::space::Space;
use planform_sdk::parallel;
use std::ops::Range;

/// The height of a cell that is on no slope.
pub const NEVER: f32 = -1.0;

/// The slopes of a relief.
pub struct Slopes {
    /// The slope of each cell, from 1; 0 where there is none.
    pub label: Vec<u32>,
    /// The height of each slope's peak; the first one belongs to none.
    peaks: Vec<f32>,
    /// From the highest to the lowest.
    meetings: Vec<Meeting>,
}

/// A cell with higher neighbours on several slopes.
struct Meeting {
    cell: u32,
    height: f32,
    /// Its own slope, then those of the higher neighbours on others; 0 is none.
    slopes: [u32; 8],
}

/// Finds the slopes. The border of the space is on none.
pub fn climb(space: &Space, height: &[f32]) -> Slopes {
    Relief { height, width: space.width }.climb()
}

struct Relief<'a> {
    height: &'a [f32],
    width: usize,
}

impl Relief<'_> {
    fn climb(&self) -> Slopes {
        let mut label = self.ways();
        let tops = lead_to_tops(&mut label);
        name(&mut label, &tops);
        let peaks = std::iter::once(0.0).chain(tops.iter().map(|&t| self.height[t as usize])).collect();
        let mut meetings = self.meetings(&label);
        meetings.sort_unstable_by(|a, b| b.height.total_cmp(&a.height).then(a.cell.cmp(&b.cell)));
        Slopes { label, peaks, meetings }
    }

    /// For each cell its highest neighbour, or itself if none is higher; 0 for a cell on no slope.
    fn ways(&self) -> Vec<u32> {
        let width = self.width;
        let mut ways = vec![0; self.height.len()];
        let last = self.height.len() / width - 1;
        parallel::for_each(&mut ways, width, |row, ways| {
            if row == 0 || row == last {
                return;
            }
            let first = row * width;
            let row = |first: usize| self.height[first..first + width].windows(3);
            let rows = row(first - width).zip(row(first)).zip(row(first + width));
            let targets = ways[1..].iter_mut().zip(first as u32 + 1..);
            for (((below, here), above), (way, cell)) in rows.zip(targets) {
                if here[1] != NEVER {
                    *way = cell.wrapping_add(step(below, here, above, width as u32));
                }
            }
        });
        ways
    }

    fn is_higher(&self, a: usize, b: usize) -> bool {
        self.height[a] > self.height[b] || (self.height[a] == self.height[b] && a < b)
    }

    fn meetings(&self, label: &[u32]) -> Vec<Meeting> {
        let width = self.width;
        let mut meetings = Vec::new();
        for first in (width..label.len() - width).step_by(width) {
            let row = |first: usize| &label[first..first + width];
            let rows = [row(first - width), row(first), row(first + width)];
            // Only where a run of one slope ends, here or in the rows beside, can be another one.
            for columns in changes(rows) {
                meetings.extend(columns.filter_map(|c| self.meeting(label, first + c)));
            }
        }
        meetings
    }

    fn meeting(&self, label: &[u32], cell: usize) -> Option<Meeting> {
        let own = Some(label[cell]).filter(|&l| l != 0)?;
        let w = self.width;
        let around =
            [cell - w - 1, cell - w, cell - w + 1, cell - 1, cell + 1, cell + w - 1, cell + w, cell + w + 1];
        let is_other = |j: &usize| label[*j] != own && label[*j] != 0 && self.is_higher(*j, cell);
        let mut slopes = [0; 8];
        slopes[0] = own;
        // A higher neighbour is on the cell's own slope, so there are seven others at most.
        let others = around.into_iter().filter(is_other);
        slopes[1..].iter_mut().zip(others).for_each(|(s, j)| *s = label[j]);
        (slopes[1] != 0).then_some(Meeting { cell: cell as u32, height: self.height[cell], slopes })
    }
}

/// The step from a cell to its highest neighbour, if that is higher, else 0: the cells below it, beside it and above it
/// with the cell in the middle. Steps back are large numbers that wrap around.
#[inline]
fn step(below: &[f32], here: &[f32], above: &[f32], width: u32) -> u32 {
    let back = |by: u32| 0u32.wrapping_sub(by);
    let around = [
        (below[0], back(width + 1)),
        (below[1], back(width)),
        (below[2], back(width - 1)),
        (here[0], back(1)),
        (here[2], 1),
        (above[0], width - 1),
        (above[1], width),
        (above[2], width + 1),
    ];
    let (mut top, mut step) = (NEVER, 0);
    for (height, to) in around {
        (top, step) = if height > top { (height, to) } else { (top, step) };
    }
    // Of the two the first one counts as higher.
    let is_higher = top > here[1] || (top == here[1] && step > width + 1);
    if is_higher { step } else { 0 }
}

/// Lets every cell's way lead to its top at once; the tops, rising.
fn lead_to_tops(ways: &mut [u32]) -> Vec<u32> {
    let mut tops = Vec::new();
    for start in 0..ways.len() as u32 {
        let mut top = ways[start as usize];
        if top == start && start != 0 {
            tops.push(start);
        }
        while ways[top as usize] != top {
            top = ways[top as usize];
        }
        let mut at = start;
        while ways[at as usize] != top {
            at = std::mem::replace(&mut ways[at as usize], top);
        }
    }
    tops
}

/// Numbers the tops from 1, in their order.
fn name(label: &mut [u32], tops: &[u32]) {
    let (mut last, mut number) = (0, 0);
    for l in label.iter_mut().filter(|l| **l != 0) {
        if *l != last {
            last = *l;
            number = tops.partition_point(|&t| t < last) as u32 + 1;
        }
        *l = number;
    }
}

/// The ranges of columns that are no farther than one column from the end of a run of labels in one of three rows; or
/// where the rows differ.
fn changes(rows: [&[u32]; 3]) -> impl Iterator<Item = Range<usize>> + '_ {
    const BLOCK: usize = 16;
    let width = rows[1].len();
    (1..width - 1).step_by(BLOCK).map(move |from| from..(from + BLOCK).min(width - 1)).filter(move |block| {
        let label = rows[1][block.start];
        let wide = block.start - 1..block.end + 1;
        rows.iter().any(|row| row[wide.clone()].iter().fold(0, |differing, l| differing | (l ^ label)) != 0)
    })
}

impl Slopes {
    /// Joins slopes of which one hardly rises above the cell where they meet: less than this share of the lower peak,
    /// and less than this in metres.
    pub fn joined(&self, rise: f32) -> Union {
        let parent = (0..self.peaks.len() as u32).collect();
        let mut union = Union { parent, peak: self.peaks.clone(), count: self.peaks.len() - 1 };
        for meeting in &self.meetings {
            let mut basin = union.root(meeting.slopes[0]);
            for other in meeting.slopes[1..].iter().take_while(|s| **s != 0) {
                let other = union.root(*other);
                if other != basin {
                    basin = union.meet(basin, other, meeting.height, rise);
                }
            }
        }
        union
    }
}

/// Slopes that were joined point to the one that took them.
pub struct Union {
    parent: Vec<u32>,
    peak: Vec<f32>,
    /// How many are left.
    pub count: usize,
}

impl Union {
    /// The slope that took this one, or itself.
    pub fn root(&mut self, mut slope: u32) -> u32 {
        while self.parent[slope as usize] != slope {
            let above = self.parent[self.parent[slope as usize] as usize];
            self.parent[slope as usize] = above;
            slope = above;
        }
        slope
    }

    /// For every slope the one that took it, or itself.
    pub fn roots(mut self) -> Vec<u32> {
        (0..self.parent.len() as u32).map(|slope| self.root(slope)).collect()
    }

    /// Joins two that meet at this height if one of them hardly rises above it; the one that remains.
    fn meet(&mut self, a: u32, b: u32, saddle: f32, rise: f32) -> u32 {
        let (pa, pb) = (self.peak[a as usize], self.peak[b as usize]);
        let low = pa.min(pb);
        if low - saddle >= rise.max(rise * low) {
            return a;
        }
        let (kept, gone) = if pb > pa { (b, a) } else { (a, b) };
        self.parent[gone as usize] = kept;
        self.count -= 1;
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The basins by flooding: every cell, from the highest down, joins its highest neighbour's.
    fn flooded(relief: &Relief<'_>, rise: f32) -> Vec<u32> {
        let mut order: Vec<usize> = (0..relief.height.len()).filter(|&i| relief.height[i] != NEVER).collect();
        order.sort_by(|&a, &b| relief.height[b].total_cmp(&relief.height[a]));
        let mut label = vec![0u32; relief.height.len()];
        let mut union = Union { parent: vec![0], peak: vec![0.0], count: 0 };
        for cell in order {
            let w = relief.width;
            let around = [
                cell - w - 1,
                cell - w,
                cell - w + 1,
                cell - 1,
                cell + 1,
                cell + w - 1,
                cell + w,
                cell + w + 1,
            ];
            let around = around.map(|j| (label[j], relief.height[j]));
            let known = around.iter().filter(|n| n.0 != 0);
            let Some(highest) = known.clone().rev().max_by(|a, b| a.1.total_cmp(&b.1)) else {
                label[cell] = union.parent.len() as u32;
                union.parent.push(label[cell]);
                union.peak.push(relief.height[cell]);
                union.count += 1;
                continue;
            };
            let mut basin = union.root(highest.0);
            for (other, _) in known {
                let other = union.root(*other);
                if other != basin {
                    basin = union.meet(basin, other, relief.height[cell], rise);
                }
            }
            label[cell] = basin;
        }
        let roots = union.roots();
        first_names(label.iter().map(|&l| roots[l as usize]))
    }

    /// Names that only tell which are the same.
    fn first_names(names: impl Iterator<Item = u32>) -> Vec<u32> {
        let mut seen = vec![0];
        let mut name = |l: u32| {
            let known = seen.iter().position(|&s| s == l);
            known.unwrap_or_else(|| {
                seen.push(l);
                seen.len() - 1
            })
        };
        names.map(|l| name(l) as u32).collect()
    }

    proptest! {
        #[test]
        fn joined_slopes_are_flooded_basins(
            heights in prop::collection::vec(0..9u8, 12 * 9),
            rise in 0..4u8,
        ) {
            let mut height = vec![NEVER; 14 * 11];
            for (i, &h) in heights.iter().enumerate() {
                // Some cells are on no slope.
                height[(i / 12 + 1) * 14 + i % 12 + 1] = if h == 0 { NEVER } else { f32::from(h) };
            }
            let relief = Relief { height: &height, width: 14 };
            let rise = f32::from(rise) / 10.0;
            let slopes = relief.climb();
            let roots = slopes.joined(rise).roots();
            let found = first_names(slopes.label.iter().map(|&l| roots[l as usize]));
            prop_assert_eq!(found, flooded(&relief, rise));
        }
    }
}
