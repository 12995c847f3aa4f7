//! What of a picture lies in areas, not in strokes.

use super::sample::Code;
use std::ops::Range;

/// The pixel is of the tones looked for.
const SET: u8 = 1;

/// So are it and those above it, as many as an area is wide.
const FULL: u8 = 2;

/// How many pixels of these tones lie in at least `size` of them in a row and in a column. `codes` are rows of this
/// width; an area is at most 255 pixels wide.
pub fn covered(codes: &[Code], width: usize, size: u8, tones: Range<Code>) -> usize {
    let mut marks: Vec<u8> = codes.iter().map(|code| u8::from(tones.contains(code)) * SET).collect();
    mark_full(&mut marks, width, size);
    // For each column, how many rows from this one up belong to the same run.
    let mut left = vec![0; width];
    let rows = marks.chunks(width.max(1)).rev();
    rows.map(|row| {
        left.iter_mut().zip(row).for_each(|(left, &mark)| *left = more(*left, mark, size));
        in_long_runs(row, &left, size)
    })
    .sum()
}

/// Marks where a run down a column has become long enough.
fn mark_full(marks: &mut [u8], width: usize, size: u8) {
    let mut run = vec![0_u8; width];
    for row in marks.chunks_mut(width.max(1)) {
        for (run, mark) in run.iter_mut().zip(row) {
            *run = if *mark == SET { run.saturating_add(1) } else { 0 };
            *mark |= if *run >= size { FULL } else { 0 };
        }
    }
}

/// How many rows up from a pixel belong to a long run, if `left` do so one row below.
fn more(left: u8, mark: u8, size: u8) -> u8 {
    if mark & FULL != 0 { size } else { left.saturating_sub(1) }
}

/// How many pixels of the row's long runs are in a long run down their column as well.
fn in_long_runs(row: &[u8], left: &[u8], size: u8) -> usize {
    let (mut from, mut count) = (0, 0);
    while let Some(before) = row[from..].iter().position(|mark| mark & SET != 0) {
        let start = from + before;
        from = row[start..].iter().position(|mark| mark & SET == 0).map_or(row.len(), |n| start + n);
        if from - start >= usize::from(size) {
            count += left[start..from].iter().filter(|left| **left > 0).count();
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The same by following the runs from each pixel.
    fn plain(codes: &[Code], width: usize, size: u8, tones: Range<Code>) -> usize {
        let height = codes.len() / width;
        let is_set = |x: usize, y: usize| tones.contains(&codes[y * width + x]);
        let run = |at: usize, end: usize, is_set: &dyn Fn(usize) -> bool| {
            let before = (0..at).rev().take_while(|&i| is_set(i)).count();
            before + (at..end).take_while(|&i| is_set(i)).count()
        };
        let is_in = |i: &usize| {
            let (x, y) = (i % width, i / width);
            let size = usize::from(size);
            is_set(x, y)
                && run(x, width, &|x| is_set(x, y)) >= size
                && run(y, height, &|y| is_set(x, y)) >= size
        };
        (0..codes.len()).filter(is_in).count()
    }

    #[test]
    fn squares_are_areas_and_strokes_are_not() {
        let code = |i: usize| Code::from(i / 20 == 15 || (3..10).contains(&(i % 20)) && i / 20 < 12);
        let codes: Vec<Code> = (0..400).map(code).collect();
        assert_eq!(covered(&codes, 20, 4, 1..2), 7 * 12);
        assert_eq!(covered(&[], 0, 4, 1..2), 0);
    }

    proptest! {
        #[test]
        fn as_many_as_by_following_the_runs(
            gaps in proptest::collection::vec(0..700_usize, 0..60),
            width in 1..60_usize,
            size in 1..9_u8,
        ) {
            let mut codes: Vec<Code> = vec![250; 700 / width * width];
            for at in gaps {
                let at = at % codes.len();
                codes[at] = 256;
            }
            prop_assert_eq!(covered(&codes, width, size, 246..256), plain(&codes, width, size, 246..256));
        }
    }
}
