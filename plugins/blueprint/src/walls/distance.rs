//! Distance transforms: how far every pixel is from the nearest one of a set.
//!
//! The exact Euclidean transform of Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions", 2012:
//! columns first, then the lower envelope of parabolas in every row, so that the cost is linear in the pixels.

use crate::rows;

/// Squared distances, pixels, to the nearest pixel that `far` says no of. Where there is none, a huge number.
pub fn squared(far: &[bool], width: usize) -> Vec<u32> {
    let height = far.len().checked_div(width).unwrap_or(0);
    let columns = down(far, width, height);
    let mut out = vec![0; far.len()];
    rows::for_each(&mut out, width, |y, row| across(&columns[y * width..][..width], row));
    out
}

/// Of every pixel whether it is set, or no farther than `reach` pixels from one that is.
pub fn within(set: &[bool], width: usize, reach: f64) -> Vec<bool> {
    let far: Vec<bool> = set.iter().map(|s| !s).collect();
    squared(&far, width).iter().map(|&d| f64::from(d) <= reach * reach).collect()
}

/// The farthest that a column's distance is told, so that its square fits.
const FARTHEST: u16 = 30_000;

/// For every pixel the distance within its column.
fn down(far: &[bool], width: usize, height: usize) -> Vec<u16> {
    let mut out = vec![FARTHEST; far.len()];
    for y in 0..height {
        for x in 0..width {
            let above = if y > 0 { out[(y - 1) * width + x] } else { FARTHEST };
            out[y * width + x] = if far[y * width + x] { above.saturating_add(1).min(FARTHEST) } else { 0 };
        }
    }
    for y in (0..height.saturating_sub(1)).rev() {
        for x in 0..width {
            let below = out[(y + 1) * width + x].saturating_add(1);
            let here = &mut out[y * width + x];
            *here = (*here).min(below);
        }
    }
    out
}

/// The lower envelope of the parabolas that stand on a row's columns.
fn across(column: &[u16], row: &mut [u32]) {
    let height = |x: usize| i64::from(column[x]).pow(2);
    let mut stack: Vec<(usize, i64)> = Vec::with_capacity(column.len());
    for x in 0..column.len() {
        let meets = |&(v, _): &(usize, i64)| {
            let (a, b) = (height(x) + (x * x) as i64, height(v) + (v * v) as i64);
            (a - b).div_euclid(2 * (x - v) as i64) + 1
        };
        while stack.last().is_some_and(|top| meets(top) <= top.1) {
            stack.pop();
        }
        let from = stack.last().map_or(0, meets);
        stack.push((x, from));
    }
    let mut at = 0;
    for (x, out) in row.iter_mut().enumerate() {
        while stack.get(at + 1).is_some_and(|next| next.1 <= x as i64) {
            at += 1;
        }
        let v = stack[at].0;
        *out = (height(v) + (x.abs_diff(v) as i64).pow(2)).min(i64::from(u32::MAX)) as u32;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_definition() {
        let (width, height) = (23, 17);
        let near = |i: usize| i * 7919 % 61 == 3;
        let far: Vec<bool> = (0..width * height).map(|i| !near(i)).collect();
        let found = squared(&far, width);
        for (i, &d) in found.iter().enumerate() {
            let to =
                |j: usize| (i % width).abs_diff(j % width).pow(2) + (i / width).abs_diff(j / width).pow(2);
            let truth = (0..far.len()).filter(|&j| near(j)).map(to).min().unwrap();
            assert_eq!(d as usize, truth, "at {i}");
        }
    }

    #[test]
    fn nothing_near_is_far_away() {
        assert!(squared(&[true; 6], 3).iter().all(|&d| d > 100_000_000));
        assert!(squared(&[], 0).is_empty());
    }
}
