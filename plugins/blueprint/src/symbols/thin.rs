//! Strokes thinned to lines of one pixel, after T. Y. Zhang and C. Y. Suen, "A fast parallel algorithm for thinning digital
//! patterns" (1984), and those lines as chains of pixels.

use crate::mask::Mask;

/// Chains of fewer pixels say nothing.
const SHORTEST: usize = 4;

/// The pixels of a stroke's middle line, one after the other.
pub type Chain = Vec<[i32; 2]>;

/// The eight pixels around one, clockwise from the upper one.
const AROUND: [(i64, i64); 8] = [(0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1)];

/// The middle lines of all strokes no wider than `widest` pixels, cut where they meet.
pub fn chains(ink: &Mask, widest: u32) -> Vec<Chain> {
    let mut lines = thinned(ink, widest.div_ceil(2) + 1);
    without_areas(&mut lines);
    without_junctions(&mut lines);
    trace(lines)
}

/// The ink, thinned so many times from both sides.
fn thinned(ink: &Mask, rounds: u32) -> Mask {
    let mut lines = ink.clone();
    let mut left: Vec<u32> = (0..lines.set.len()).filter(|&i| lines.set[i]).map(|i| i as u32).collect();
    for _ in 0..rounds {
        for first in [true, false] {
            let gone: Vec<u32> = left.iter().copied().filter(|&i| is_peeled(&lines, i, first)).collect();
            gone.iter().for_each(|&i| lines.set[i as usize] = false);
        }
        left.retain(|&i| lines.set[i as usize]);
    }
    lines
}

fn around(mask: &Mask, i: u32) -> [bool; 8] {
    let (x, y) = (i64::from(i % mask.width), i64::from(i / mask.width));
    AROUND.map(|(dx, dy)| mask.get(x + dx, y + dy))
}

/// How many strokes leave a pixel.
fn branches(n: &[bool; 8]) -> usize {
    (0..8).filter(|&k| !n[k] && n[(k + 1) % 8]).count()
}

fn is_peeled(mask: &Mask, i: u32, first: bool) -> bool {
    let n = around(mask, i);
    let [up, _, right, _, down, _, left, _] = n;
    let count = n.iter().filter(|&&v| v).count();
    let side = if first { !(right && down && (up || left)) } else { !(up && left && (right || down)) };
    (2..=6).contains(&count) && branches(&n) == 1 && side
}

/// Takes off what was too thick to become a line.
fn without_areas(lines: &mut Mask) {
    let full = |i: &usize| lines.set[*i] && around(lines, *i as u32).iter().filter(|&&v| v).count() >= 7;
    let areas: Vec<usize> = (0..lines.set.len()).filter(full).collect();
    clear_around(lines, &areas, 1);
}

fn without_junctions(lines: &mut Mask) {
    let junction = |i: &usize| lines.set[*i] && branches(&around(lines, *i as u32)) >= 3;
    let junctions: Vec<usize> = (0..lines.set.len()).filter(junction).collect();
    clear_around(lines, &junctions, 1);
}

fn clear_around(mask: &mut Mask, places: &[usize], reach: i64) {
    let (w, h) = (i64::from(mask.width), i64::from(mask.height));
    for &i in places {
        let (x, y) = (i as i64 % w, i as i64 / w);
        for (nx, ny) in (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (x + dx, y + dy))) {
            if (0..w).contains(&nx) && (0..h).contains(&ny) {
                mask.set[(ny * w + nx) as usize] = false;
            }
        }
    }
}

/// Open lines from their ends first, then rings from anywhere.
fn trace(mut lines: Mask) -> Vec<Chain> {
    let mut chains = Vec::new();
    for ends in [true, false] {
        for i in 0..lines.set.len() {
            let starts = lines.set[i] && (!ends || branches(&around(&lines, i as u32)) <= 1);
            if starts {
                chains.push(walk(&mut lines, i));
            }
        }
    }
    chains.retain(|c| c.len() >= SHORTEST);
    chains
}

fn walk(lines: &mut Mask, start: usize) -> Chain {
    let w = lines.width as usize;
    let (mut x, mut y) = ((start % w) as i64, (start / w) as i64);
    let mut chain = Vec::new();
    // Straight neighbours come before those at corners, or steps would be cut short.
    const ORDER: [usize; 8] = [0, 2, 4, 6, 1, 3, 5, 7];
    loop {
        lines.set[y as usize * w + x as usize] = false;
        chain.push([x as i32, y as i32]);
        let next = ORDER.iter().map(|&k| AROUND[k]).find(|(dx, dy)| lines.get(x + dx, y + dy));
        let Some((dx, dy)) = next else { return chain };
        (x, y) = (x + dx, y + dy);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(rows: &[&str]) -> Mask {
        let set = rows.iter().flat_map(|r| r.bytes().map(|b| b == b'#')).collect();
        Mask { width: rows[0].len() as u32, height: rows.len() as u32, set }
    }

    #[test]
    fn a_thick_stroke_becomes_its_middle_line() {
        let mut mask = Mask::empty(30, 9);
        (3..6).for_each(|y| (2..28).for_each(|x| mask.set[y * 30 + x] = true));
        let chains = chains(&mask, 4);
        assert_eq!(chains.len(), 1);
        assert!(chains[0].len() >= 22 && chains[0].iter().all(|p| p[1] == 4), "{chains:?}");
    }

    #[test]
    fn strokes_are_cut_where_they_meet_and_areas_are_left_out() {
        let mut rows = vec!["........................"; 12];
        rows[5] = "########################";
        let mut mask = picture(&rows);
        (0..5).for_each(|y| mask.set[y * 24 + 8] = true);
        let found = chains(&mask, 3);
        assert_eq!(found.len(), 3, "{found:?}");
        let solid = Mask { width: 24, height: 12, set: vec![true; 24 * 12] };
        assert!(chains(&solid, 3).iter().all(|c| c.len() < 30));
    }
}
