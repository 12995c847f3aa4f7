//! The free space cut into basins: a watershed (Vincent and Soille, "Watersheds in Digital Spaces", 1991) of the
//! clearance, flooded from its peaks. Neighbouring basins meet where the space is narrowest, so nearly every true
//! boundary between two rooms lies on a boundary between basins.

use super::clearance::Clearance;
use super::slopes::{self, NEVER};
use super::space::Space;
use planform_sdk::parallel;

/// How wide the clearance is smoothed before the cells are put in order, standard deviation in metres: two cells at
/// 0.04 m, so that a jagged wall makes no ridge.
const SMOOTHING: f64 = 0.08;

/// Two basins are one if the lower peak rises less than this above the saddle between them, metres and share of the
/// peak: what remains of the smoothed steps between cells.
const RISE: f32 = 0.002;

/// The most basins; a floor of 50 rooms has 200 to 700. A space with more is noise, and is cut more coarsely. Of a large
/// one, so many to the square metre: buildings have a tenth to a half.
const MOST: usize = 3_000;
const MOST_PER_AREA: f64 = 1.0;

/// For each cell the number of its basin from 1, 0 where it is not free; and the number of basins.
pub struct Basins {
    /// The basin of each cell.
    pub label: Vec<u32>,
    /// How many there are.
    pub count: u32,
}

/// Cuts the space. No basin crosses the cells that `doors` marks, if it marks any.
pub fn cut(space: &Space, clearance: &Clearance, doors: &[bool]) -> Basins {
    let mut height = smoothed(space, &clearance.metres);
    for (i, h) in height.iter_mut().enumerate() {
        if !space.free[i] || doors.get(i) == Some(&true) {
            *h = NEVER;
        }
    }
    let slopes = slopes::climb(space, &height);
    let area = space.area(space.free.iter().filter(|&&free| free).count());
    let most = MOST.max((MOST_PER_AREA * area) as usize);
    let mut rise = RISE;
    let mut union = slopes.joined(rise);
    while union.count > most {
        rise *= 4.0;
        union = slopes.joined(rise);
    }
    let mut basins = number(slopes.label, &union.roots());
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
    let mut out = vec![0.0f32; metres.len()];
    parallel::for_each_band(&mut out, width, |first, band| {
        // The smoothed rows around the one that is made, each in its turn; none of what is not free.
        let mut across: Vec<Option<Vec<Block>>> = vec![None; 2 * reach + 1];
        let mut padded = Vec::with_capacity(width + 2 * reach);
        let mut ready = first.saturating_sub(reach);
        for (row, target) in (first..).zip(band.chunks_exact_mut(width)) {
            // Beyond the space all is as on its border: not free.
            let around = row.saturating_sub(reach)..(row + reach + 1).min(height);
            for from in ready..around.end {
                let line = &metres[from * width..(from + 1) * width];
                across[from % (2 * reach + 1)] = smoothed_row(line, &kernel, &mut padded);
            }
            ready = around.end;
            let near = around.filter_map(|from| {
                Some((kernel[from.abs_diff(row)], across[from % (2 * reach + 1)].as_deref()?))
            });
            weigh(&near.collect::<Vec<_>>(), target);
        }
    });
    out
}

/// So many columns are made at a time: they stay in registers.
const BLOCK: usize = 8;

/// Some columns of a row.
type Block = [f32; BLOCK];

/// The sum of rows with their weights.
fn weigh(rows: &[(f32, &[Block])], out: &mut [f32]) {
    if rows.is_empty() {
        return;
    }
    for (i, out) in out.chunks_mut(BLOCK).enumerate() {
        let mut sum = [0.0; BLOCK];
        for (weight, row) in rows {
            let row: Block = row[i];
            for j in 0..BLOCK {
                sum[j] += weight * row[j];
            }
        }
        out.copy_from_slice(&sum[..out.len()]);
    }
}

/// A row through a kernel; none if it is all zero. `padded` is a place to work in.
fn smoothed_row(line: &[f32], kernel: &[f32], padded: &mut Vec<f32>) -> Option<Vec<Block>> {
    if line.iter().all(|&v| v == 0.0) {
        return None;
    }
    let reach = kernel.len() - 1;
    let blocks = line.len().div_ceil(BLOCK);
    padded.clear();
    padded.resize(reach, line[0]);
    padded.extend_from_slice(line);
    padded.resize(blocks * BLOCK + 2 * reach, line[line.len() - 1]);
    let at = |from: usize| -> Block { padded[from..].first_chunk().copied().unwrap_or_default() };
    let block = |i: usize| {
        let middle = i * BLOCK + reach;
        let mut sum = at(middle).map(|v| kernel[0] * v);
        for (k, weight) in kernel.iter().enumerate().skip(1) {
            let (left, right) = (at(middle - k), at(middle + k));
            for j in 0..BLOCK {
                sum[j] += weight * (left[j] + right[j]);
            }
        }
        sum
    };
    Some((0..blocks).map(block).collect())
}

/// The right half of a normalised Gaussian kernel out to four standard deviations, its middle first.
pub fn gaussian(sigma: f64) -> Vec<f32> {
    let reach = (4.0 * sigma + 0.5) as usize;
    let half: Vec<f64> = (0..=reach).map(|k| (-0.5 * (k as f64 / sigma.max(1e-9)).powi(2)).exp()).collect();
    let total = half[0] + 2.0 * half[1..].iter().sum::<f64>();
    half.iter().map(|w| (w / total) as f32).collect()
}

/// Numbers the basins from 1 in the order in which the map shows them; `roots` are the basins that slopes became.
fn number(mut label: Vec<u32>, roots: &[u32]) -> Basins {
    let mut names = vec![0u32; roots.len()];
    let mut count = 0;
    for l in label.iter_mut().filter(|l| **l != 0) {
        let name = &mut names[roots[*l as usize] as usize];
        if *name == 0 {
            count += 1;
            *name = count;
        }
        *l = *name;
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
}
