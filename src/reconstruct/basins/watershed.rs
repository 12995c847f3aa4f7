//! The free space cut into basins: a watershed (Vincent and Soille, "Watersheds in Digital Spaces", 1991) of the
//! clearance, flooded from its peaks. Neighbouring basins meet where the space is narrowest, so nearly every true
//! boundary between two rooms lies on a boundary between basins.

use super::clearance::Clearance;
use super::space::Space;

/// How wide the clearance is smoothed before the cells are put in order, standard deviation in metres: two cells at
/// 0.04 m, so that a jagged wall makes no ridge.
const SMOOTHING: f64 = 0.08;

/// Two basins are one if the lower peak rises less than this above the saddle between them, metres and share of the
/// peak: what remains of the smoothed steps between cells.
const RISE: f32 = 0.002;

/// The most basins; a floor of 50 rooms has 200 to 700. A space with more is noise, and is cut more coarsely.
const MOST: u32 = 3_000;

/// For each cell the number of its basin from 1, 0 where it is not free; and the number of basins.
pub struct Basins {
    /// The basin of each cell.
    pub label: Vec<u32>,
    /// How many there are.
    pub count: u32,
}

/// Cuts the space. No basin crosses the cells that `doors` marks, if it marks any.
pub fn cut(space: &Space, clearance: &Clearance, doors: &[bool]) -> Basins {
    let smooth = smoothed(space, &clearance.metres);
    let mut order = falling(space, &smooth);
    if !doors.is_empty() {
        order.retain(|&cell| !doors[cell as usize]);
    }
    let mut rise = RISE;
    let mut basins = flood(space, &smooth, &order, rise);
    while basins.count > MOST {
        rise *= 4.0;
        basins = flood(space, &smooth, &order, rise);
    }
    share_out(space, doors, &mut basins.label);
    basins
}

/// Gives the cells of doors to the basins beside them, the nearest first.
fn share_out(space: &Space, doors: &[bool], label: &mut [u32]) {
    let mut left: Vec<usize> = (0..doors.len()).filter(|&i| doors[i]).collect();
    loop {
        let beside = |i: usize| {
            let around = [i - 1, i + 1, i - space.width, i + space.width];
            around.into_iter().map(|j| label[j]).find(|&l| l != 0)
        };
        let given: Vec<(usize, u32)> = left.iter().filter_map(|&i| Some((i, beside(i)?))).collect();
        if given.is_empty() {
            return;
        }
        given.iter().for_each(|&(i, basin)| label[i] = basin);
        left.retain(|&i| label[i] == 0);
    }
}

/// The clearance through a Gaussian, one row and one column at a time.
fn smoothed(space: &Space, metres: &[f32]) -> Vec<f32> {
    let kernel = gaussian(SMOOTHING / space.resolution);
    let reach = kernel.len() - 1;
    let (width, height) = (space.width, space.height);
    let mut across = vec![0.0f32; metres.len()];
    for row in 0..height {
        let line = &metres[row * width..(row + 1) * width];
        for (column, out) in across[row * width..(row + 1) * width].iter_mut().enumerate() {
            let at = |c: i64| line[c.clamp(0, width as i64 - 1) as usize];
            *out = kernel[0] * line[column];
            for (k, weight) in kernel.iter().enumerate().skip(1) {
                *out += weight * (at(column as i64 - k as i64) + at(column as i64 + k as i64));
            }
        }
    }
    let mut out = vec![0.0f32; metres.len()];
    for row in 0..height {
        let target = &mut out[row * width..(row + 1) * width];
        for k in -(reach as i64)..=reach as i64 {
            let from = (row as i64 + k).clamp(0, height as i64 - 1) as usize;
            let weight = kernel[k.unsigned_abs() as usize];
            for (o, a) in target.iter_mut().zip(&across[from * width..(from + 1) * width]) {
                *o += weight * a;
            }
        }
    }
    out
}

/// The right half of a normalised Gaussian kernel out to four standard deviations, its middle first.
pub fn gaussian(sigma: f64) -> Vec<f32> {
    let reach = (4.0 * sigma + 0.5) as usize;
    let half: Vec<f64> = (0..=reach).map(|k| (-0.5 * (k as f64 / sigma.max(1e-9)).powi(2)).exp()).collect();
    let total = half[0] + 2.0 * half[1..].iter().sum::<f64>();
    half.iter().map(|w| (w / total) as f32).collect()
}

/// The free cells from the highest to the lowest; equal ones in their order on the map. A radix sort: the bits of
/// positive floats rise with their values.
fn falling(space: &Space, height: &[f32]) -> Vec<u32> {
    let key = |i: u32| !height[i as usize].to_bits();
    let mut order: Vec<u32> = (0..space.free.len() as u32).filter(|&i| space.free[i as usize]).collect();
    let mut sorted = vec![0u32; order.len()];
    for shift in [0, 11, 22] {
        let digit = |i: u32| ((key(i) >> shift) & 0x7ff) as usize;
        let mut start = vec![0usize; 0x800];
        for &i in &order {
            start[digit(i)] += 1;
        }
        let mut sum = 0;
        for s in &mut start {
            (sum, *s) = (sum + *s, sum);
        }
        for &i in &order {
            let slot = &mut start[digit(i)];
            sorted[*slot] = i;
            *slot += 1;
        }
        std::mem::swap(&mut order, &mut sorted);
    }
    order
}

/// Basins that were joined point to the one that took them.
struct Union {
    parent: Vec<u32>,
    peak: Vec<f32>,
}

impl Union {
    fn root(&mut self, mut basin: u32) -> u32 {
        while self.parent[basin as usize] != basin {
            let above = self.parent[self.parent[basin as usize] as usize];
            self.parent[basin as usize] = above;
            basin = above;
        }
        basin
    }

    fn add(&mut self, peak: f32) -> u32 {
        let basin = self.parent.len() as u32;
        self.parent.push(basin);
        self.peak.push(peak);
        basin
    }

    /// Joins two basins that meet at this height if one of them hardly rises above it; the one that remains.
    fn meet(&mut self, a: u32, b: u32, saddle: f32, rise: f32) -> u32 {
        let (pa, pb) = (self.peak[a as usize], self.peak[b as usize]);
        let low = pa.min(pb);
        if low - saddle >= rise.max(rise * low) {
            return a;
        }
        let (kept, gone) = if pb > pa { (b, a) } else { (a, b) };
        self.parent[gone as usize] = kept;
        kept
    }
}

/// Gives every cell, from the highest down, to the basin of its highest neighbour; a cell without one is a peak.
fn flood(space: &Space, height: &[f32], order: &[u32], rise: f32) -> Basins {
    let mut label = vec![0u32; height.len()];
    let mut union = Union { parent: vec![0], peak: vec![0.0] };
    let steps = space.steps();
    for &cell in order {
        let around = steps.map(|s| (i64::from(cell) + s) as usize).map(|j| (label[j], height[j]));
        let highest =
            around.iter().filter(|n| n.0 != 0).fold(None, |best: Option<(u32, f32)>, n| match best {
                Some(b) if b.1 >= n.1 => best,
                _ => Some(*n),
            });
        let here = height[cell as usize];
        let Some((name, _)) = highest else {
            label[cell as usize] = union.add(here);
            continue;
        };
        let mut basin = union.root(name);
        for (other, _) in around.iter().filter(|n| n.0 != 0 && n.0 != name) {
            let other = union.root(*other);
            if other != basin {
                basin = union.meet(basin, other, here, rise);
            }
        }
        label[cell as usize] = basin;
    }
    number(label, union)
}

/// Numbers the basins from 1 in the order in which the map shows them.
fn number(mut label: Vec<u32>, mut union: Union) -> Basins {
    let mut names = vec![0u32; union.parent.len()];
    let mut count = 0;
    for l in label.iter_mut().filter(|l| **l != 0) {
        let root = union.root(*l) as usize;
        if names[root] == 0 {
            count += 1;
            names[root] = count;
        }
        *l = names[root];
    }
    Basins { label, count }
}

#[cfg(test)]
mod tests {
    use super::super::clearance;
    use super::super::space::tests::space;
    use super::*;

    #[test]
    fn two_rooms_and_a_door_are_basins_that_meet_in_the_door() {
        let wall = format!("{}##{}", "#".repeat(20), "#".repeat(20));
        let room = format!("{}##{}", ".".repeat(20), ".".repeat(20));
        let door = ".".repeat(42);
        let mut rows = vec![room.as_str(); 9];
        rows.extend([door.as_str(); 4]);
        rows.extend(vec![room.as_str(); 9]);
        rows.push(&wall);
        let space = space(&rows, 0.1);
        let basins = cut(&space, &clearance::measure(&space), &[]);
        let at = |x: usize, y: usize| basins.label[(y + 1) * space.width + x + 1];
        assert!(at(3, 11) != at(38, 11));
        assert_eq!(at(3, 11), at(15, 11));
        let cells = basins.label.iter().filter(|&&l| l != 0).count();
        assert_eq!(cells, space.free.iter().filter(|&&f| f).count());
    }

    #[test]
    fn equal_heights_keep_their_order() {
        let space = space(&["...."], 1.0);
        let mut height = vec![0.0; space.free.len()];
        let row = space.width + 1;
        height[row..row + 4].copy_from_slice(&[0.5, 1.0, 0.5, 2.0]);
        let row = row as u32;
        assert_eq!(falling(&space, &height), [row + 3, row + 1, row, row + 2]);
    }
}
