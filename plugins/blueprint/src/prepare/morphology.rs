//! Growing, shrinking and opening masks by squares, in time that does not depend on the square's size.

use crate::mask::Mask;

/// Every pixel from which a set one is at most `reach` columns and rows away.
pub fn grown(mask: &Mask, reach: u32) -> Mask {
    let rows = along_rows(mask, |run, _| run > 0, reach);
    along_columns(&rows, |run, _| run > 0, reach)
}

/// Every pixel around which all within `reach` columns and rows are set; what lies outside of the mask counts
/// as set.
pub fn shrunk(mask: &Mask, reach: u32) -> Mask {
    let rows = along_rows(mask, |run, all| run == all, reach);
    along_columns(&rows, |run, all| run == all, reach)
}

/// What is set and at least `2 * reach + 1` pixels thick.
pub fn opened(mask: &Mask, reach: u32) -> Mask {
    grown(&shrunk(mask, reach), reach)
}

fn along_rows(mask: &Mask, keep: impl Fn(u32, u32) -> bool, reach: u32) -> Mask {
    let mut out = Mask::empty(mask.width, mask.height);
    let width = mask.width as usize;
    if width > 0 {
        let lines = mask.set.chunks_exact(width).zip(out.set.chunks_exact_mut(width));
        lines.for_each(|(from, to)| {
            slide(width, |i| from[i], |i, run, all| to[i] = keep(run, all), reach as usize)
        });
    }
    out
}

/// The same for all columns at once: one count for each, carried from row to row, as memory lies.
fn along_columns(mask: &Mask, keep: impl Fn(u32, u32) -> bool, reach: u32) -> Mask {
    let mut out = Mask::empty(mask.width, mask.height);
    let (width, height, reach) = (mask.width as usize, mask.height as usize, reach as usize);
    let mut runs = vec![0u32; width];
    let line = |y: usize| &mask.set[y * width..(y + 1) * width];
    (0..reach.min(height)).for_each(|y| runs.iter_mut().zip(line(y)).for_each(|(r, &s)| *r += u32::from(s)));
    for y in 0..height {
        if y + reach < height {
            runs.iter_mut().zip(line(y + reach)).for_each(|(r, &s)| *r += u32::from(s));
        }
        let all = ((y + reach).min(height - 1) + 1 - y.saturating_sub(reach)) as u32;
        let to = &mut out.set[y * width..(y + 1) * width];
        to.iter_mut().zip(&runs).for_each(|(t, &r)| *t = keep(r, all));
        if y >= reach {
            runs.iter_mut().zip(line(y - reach)).for_each(|(r, &s)| *r -= u32::from(s));
        }
    }
    out
}

/// Tells for every place how many are set within reach, and of how many.
fn slide(length: usize, set: impl Fn(usize) -> bool, mut tell: impl FnMut(usize, u32, u32), reach: usize) {
    let mut run: u32 = (0..reach.min(length)).map(|i| u32::from(set(i))).sum();
    for i in 0..length {
        if i + reach < length {
            run += u32::from(set(i + reach));
        }
        tell(i, run, ((i + reach).min(length - 1) + 1 - i.saturating_sub(reach)) as u32);
        if i >= reach {
            run -= u32::from(set(i - reach));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn slow(mask: &Mask, reach: i64, all: bool) -> Mask {
        let mut out = Mask::empty(mask.width, mask.height);
        let (w, h) = (i64::from(mask.width), i64::from(mask.height));
        for (i, set) in out.set.iter_mut().enumerate() {
            let (x, y) = (i as i64 % w, i as i64 / w);
            let near = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (x + dx, y + dy)));
            let mut inside = near.filter(|&(x, y)| x >= 0 && y >= 0 && x < w && y < h);
            *set =
                if all { inside.all(|(x, y)| mask.get(x, y)) } else { inside.any(|(x, y)| mask.get(x, y)) };
        }
        out
    }

    proptest! {
        #[test]
        fn squares_slide_as_if_counted(
            width in 1u32..12, height in 1u32..12, reach in 0u32..5, bits in any::<[u64; 3]>(),
        ) {
            let cells = 0..(width * height) as usize;
            let set = cells.map(|i| bits[i / 64] >> (i % 64) & 1 == 1).collect();
            let mask = Mask { width, height, set };
            prop_assert_eq!(grown(&mask, reach), slow(&mask, i64::from(reach), false));
            prop_assert_eq!(shrunk(&mask, reach), slow(&mask, i64::from(reach), true));
        }
    }

    #[test]
    fn an_opening_keeps_the_thick_and_drops_the_thin() {
        let mut mask = Mask::empty(20, 20);
        (0..400).for_each(|i| mask.set[i] = i / 20 == 2 || (i / 20 > 8 && i / 20 < 14));
        let thick = opened(&mask, 2);
        assert!(!thick.get(5, 2) && thick.get(5, 9) && thick.get(0, 13) && !thick.get(5, 14));
    }

    #[test]
    fn an_empty_mask_stays_empty() {
        assert_eq!(opened(&Mask::empty(0, 5), 3).count(), 0);
    }
}
