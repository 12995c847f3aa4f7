//! Areas that are wider than any wall or line.

/// Half the side of the square that makes an area wide, metres: more than half of any wall's thickness.
const RADIUS: f64 = 0.25;

/// The same in pixels.
pub fn radius(resolution: f64) -> usize {
    ((RADIUS / resolution).round() as usize).clamp(2, 50)
}

/// The pixels of all squares of side 2 radius + 1, cut off at the border, that are filled.
pub fn areas(filled: &[bool], width: usize, radius: usize) -> Vec<bool> {
    let hollow: Vec<bool> = filled.iter().map(|f| !f).collect();
    let inner: Vec<bool> = near(&hollow, width, radius).iter().map(|near| !near).collect();
    near(&inner, width, radius)
}

/// The pixels within a square of side 2 radius + 1 around each that is set.
pub fn near(set: &[bool], width: usize, radius: usize) -> Vec<bool> {
    let width = width.max(1);
    let mut along = vec![false; set.len()];
    for (row, out) in set.chunks(width).zip(along.chunks_mut(width)) {
        let marked: Vec<usize> = row.iter().enumerate().filter(|(_, set)| **set).map(|(x, _)| x).collect();
        let mut from = 0;
        for x in marked {
            let end = (x + radius + 1).min(out.len());
            out[x.saturating_sub(radius).max(from).min(end)..end].fill(true);
            from = end;
        }
    }
    down(&along, width, radius)
}

/// The same along columns.
fn down(set: &[bool], width: usize, radius: usize) -> Vec<bool> {
    let height = set.len() / width;
    let mut out = vec![false; set.len()];
    // For each column, how many set pixels are in the rows around the current one.
    let mut counts = vec![0_u32; width];
    for y in 0..height + radius {
        if y < height {
            counts.iter_mut().zip(&set[y * width..]).for_each(|(n, set)| *n += u32::from(*set));
        }
        let Some(row) = y.checked_sub(radius) else { continue };
        out[row * width..][..width].iter_mut().zip(&counts).for_each(|(out, n)| *out = *n > 0);
        if let Some(gone) = row.checked_sub(radius) {
            counts.iter_mut().zip(&set[gone * width..]).for_each(|(n, set)| *n -= u32::from(*set));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_are_wide_and_lines_are_not() {
        let at = |i: usize| (i % 20, i / 20);
        let square = |(x, y): (usize, usize)| (3..10).contains(&x) && (4..12).contains(&y);
        let line = |(x, y): (usize, usize)| y == 15 || x == 16;
        let filled: Vec<bool> = (0..400).map(|i| square(at(i)) || line(at(i))).collect();
        let found = areas(&filled, 20, 2);
        assert!((0..400).all(|i| found[i] == square(at(i))));
    }

    #[test]
    fn near_is_a_square() {
        let mut set = vec![false; 15 * 9];
        set[4 * 15 + 1] = true;
        let found = near(&set, 15, 2);
        assert!((0..135).all(|i| found[i] == (i % 15 <= 3 && (2..=6).contains(&(i / 15)))));
    }
}
