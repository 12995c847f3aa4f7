//! Where one gets from each cell by always stepping to the highest neighbour: up to a peak.
//!
//! The cells of one peak are a slope. Slopes that meet hardly below the lower one's peak are joined, the highest meeting
//! first. Only the cells where slopes meet have to be put in order for that, so that a watershed costs little more than a
//! look at each cell's neighbours. Of two cells of equal height the one that comes first counts as higher.

use super::space::Space;

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

/// Finds the slopes.
pub fn climb(space: &Space, height: &[f32]) -> Slopes {
    Relief { height, steps: space.steps() }.climb()
}

struct Relief<'a> {
    height: &'a [f32],
    steps: [i64; 8],
}

impl Relief<'_> {
    fn climb(&self) -> Slopes {
        let (label, peaks) = self.slopes();
        let mut meetings = self.meetings(&label);
        meetings.sort_unstable_by(|a, b| b.height.total_cmp(&a.height).then(a.cell.cmp(&b.cell)));
        Slopes { label, peaks, meetings }
    }

    fn around(&self, cell: usize) -> [usize; 8] {
        self.steps.map(|s| (cell as i64 + s) as usize)
    }

    /// The slope of each cell, and the peaks' heights.
    fn slopes(&self) -> (Vec<u32>, Vec<f32>) {
        let mut label = vec![0u32; self.height.len()];
        let mut peaks = vec![0.0];
        let mut way = Vec::new();
        for start in (0..label.len()).filter(|&i| self.height[i] != NEVER) {
            let mut at = start;
            while label[at] == 0 {
                way.push(at);
                match self.up(at) {
                    Some(next) => at = next,
                    None => {
                        label[at] = peaks.len() as u32;
                        peaks.push(self.height[at]);
                    }
                }
            }
            let slope = label[at];
            way.drain(..).for_each(|i| label[i] = slope);
        }
        (label, peaks)
    }

    /// The highest neighbour, if it is higher.
    fn up(&self, cell: usize) -> Option<usize> {
        let (mut best, mut top) = (cell, NEVER);
        for j in self.around(cell) {
            let h = self.height[j];
            (best, top) = if h > top { (j, h) } else { (best, top) };
        }
        self.is_higher(best, cell).then_some(best)
    }

    fn is_higher(&self, a: usize, b: usize) -> bool {
        self.height[a] > self.height[b] || (self.height[a] == self.height[b] && a < b)
    }

    fn meetings(&self, label: &[u32]) -> Vec<Meeting> {
        let mut meetings = Vec::new();
        for (cell, &own) in label.iter().enumerate().filter(|(_, l)| **l != 0) {
            let around = self.around(cell);
            if around.iter().all(|&j| label[j] == own || label[j] == 0) {
                continue;
            }
            let others = around.into_iter().filter(|&j| {
                label[j] != own && label[j] != 0 && self.is_higher(j, cell)
            });
            let mut slopes = [0; 8];
            slopes[0] = own;
            // A higher neighbour is on the cell's own slope, so there are seven others at most.
            slopes[1..].iter_mut().zip(others).for_each(|(s, j)| *s = label[j]);
            if slopes[1] != 0 {
                meetings.push(Meeting { cell: cell as u32, height: self.height[cell], slopes });
            }
        }
        meetings
    }
}

impl Slopes {
    /// Joins slopes of which one hardly rises above the cell where they meet: less than this share of the lower peak,
    /// and less than this in metres.
    pub fn joined(&self, rise: f32) -> Union {
        let parent = (0..self.peaks.len() as u32).collect();
        let mut union = Union { parent, peak: self.peaks.clone(), count: self.peaks.len() as u32 - 1 };
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
    pub count: u32,
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
            let around = relief.around(cell).map(|j| (label[j], relief.height[j]));
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
            let relief = Relief { height: &height, steps: [-15, -14, -13, -1, 1, 13, 14, 15] };
            let rise = f32::from(rise) / 10.0;
            let slopes = relief.climb();
            let roots = slopes.joined(rise).roots();
            let found = first_names(slopes.label.iter().map(|&l| roots[l as usize]));
            prop_assert_eq!(found, flooded(&relief, rise));
        }
    }
}
