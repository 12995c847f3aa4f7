//! Cuts letters off the walls and lines that they touch: what is thicker than a letter's stroke, or straight along the
//! sheet's sides and longer than letters are, is taken away; letters are among what stays.

use super::components::{Bounds, Components, Run};
use crate::mask::Mask;

/// What is thicker than this part of a letter's height is no stroke of a letter.
const THICK: f64 = 0.4;
/// What is longer than this many heights of a letter is no stroke of a letter.
const LONG: f64 = 1.5;

/// What is longer than this many heights of a letter, on either side, may be a letter and something else.
const LARGE: f64 = 1.6;

/// The parts of large things that may be letters.
pub struct Cut {
    /// What stays, letters whole again where a line crossed them.
    pub rest: Mask,
    /// What was taken away: never to be erased with a letter.
    pub kept: Mask,
}

/// Cuts all parts that are larger than letters of this height and no `letters` themselves.
pub fn cut(parts: &Components, letters: &[bool], (width, height): (u32, u32), letter: f64) -> Cut {
    let mut rest = Mask::empty(width, height);
    let large = |b: Bounds| f64::from(b.width().max(b.height())) > LARGE * letter;
    for (part, _) in parts.list.iter().zip(letters).filter(|(p, l)| !**l && large(p.bounds)) {
        parts.runs(part).iter().for_each(|r| paint(&mut rest, r));
    }
    let side = ((letter * THICK).ceil() as u8).clamp(3, 100);
    let long = (letter * LONG).ceil() as u32;
    let mut kept = thick(&rest, side);
    take(&mut rest, &kept);
    for lines in [long_rows(&rest, long), long_columns(&rest, long)] {
        kept = kept.with(&lines);
    }
    take(&mut rest, &kept);
    mend(&mut rest, &kept, f64::from(side) as i32);
    Cut { rest, kept }
}

/// Sets the pixels of a run.
fn paint(mask: &mut Mask, run: &Run) {
    let row = run.y as usize * mask.width as usize;
    mask.set[row + run.x0 as usize..row + run.x1 as usize].fill(true);
}

fn take(mask: &mut Mask, other: &Mask) {
    mask.set.iter_mut().zip(&other.set).for_each(|(s, &o)| *s &= !o);
}

/// The union of all squares of this side that lie in the mask (a morphological opening), in two passes: the largest
/// square that ends at each pixel, then how far each pixel is from such an end, in king's moves.
fn thick(mask: &Mask, side: u8) -> Mask {
    let (width, height) = (mask.width as usize, mask.height as usize);
    let mut squares = vec![0_u8; mask.set.len()];
    for i in 0..mask.set.len() {
        let inner = i % width > 0 && i >= width;
        let around =
            if inner { squares[i - 1].min(squares[i - width]).min(squares[i - width - 1]) } else { 0 };
        squares[i] = if mask.set[i] { (around + 1).min(side) } else { 0 };
    }
    let mut reach = squares;
    for i in (0..reach.len()).rev() {
        let (right, below) = (i % width + 1 < width, i / width + 1 < height);
        let at = |ok: bool, j: usize| if ok { reach[j].saturating_sub(1) } else { 0 };
        let around = at(right, i + 1).max(at(below, i + width)).max(at(right && below, i + width + 1));
        reach[i] = if reach[i] == side { side } else { around };
    }
    Mask { width: mask.width, height: mask.height, set: reach.into_iter().map(|r| r > 0).collect() }
}

/// Runs in rows of at least this length.
fn long_rows(mask: &Mask, long: u32) -> Mask {
    let mut lines = Mask::empty(mask.width, mask.height);
    let width = mask.width.max(1) as usize;
    for (row, out) in mask.set.chunks_exact(width).zip(lines.set.chunks_exact_mut(width)) {
        let mut x = 0;
        while x < width {
            let length = row[x..].iter().position(|&s| s != row[x]).unwrap_or(width - x);
            out[x..x + length].fill(row[x] && length >= long as usize);
            x += length;
        }
    }
    lines
}

/// Runs in columns of at least this length.
fn long_columns(mask: &Mask, long: u32) -> Mask {
    let mut lines = Mask::empty(mask.width, mask.height);
    let width = mask.width as usize;
    let mut length = vec![0_u32; width];
    for y in 0..=mask.height {
        for (x, length) in length.iter_mut().enumerate() {
            if y < mask.height && mask.set[y as usize * width + x] {
                *length += 1;
                continue;
            }
            if *length >= long {
                (y - *length..y).for_each(|y| lines.set[y as usize * width + x] = true);
            }
            *length = 0;
        }
    }
    lines
}

/// Gives letters back what lies between two of their pixels, across a line of at most this thickness.
fn mend(rest: &mut Mask, kept: &Mask, thickness: i32) {
    let original = rest.clone();
    let (width, height) = (i64::from(rest.width), i64::from(rest.height));
    let gap = |x: i64, y: i64, dx: i64, dy: i64| {
        let inside = |k: &i64| kept.get(x + k * dx, y + k * dy);
        let n = (1..=i64::from(thickness) + 1).take_while(inside).count() as i64;
        let bridged = n > 0 && n <= i64::from(thickness) && original.get(x + (n + 1) * dx, y + (n + 1) * dy);
        if bridged { n } else { 0 }
    };
    for y in 0..height {
        for x in 0..width {
            if !original.set[(y * width + x) as usize] {
                continue;
            }
            for (dx, dy) in [(1, 0), (0, 1)] {
                for k in 1..=gap(x, y, dx, dy) {
                    rest.set[((y + k * dy) * width + x + k * dx) as usize] = true;
                }
            }
        }
    }
}
