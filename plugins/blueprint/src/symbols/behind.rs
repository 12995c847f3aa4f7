//! Walls behind signs. A sign is laid over the drawing: what runs into it at one side and out of it at the opposite one,
//! in line, goes on behind it.

use crate::found::SheetSymbol;
use crate::mask::Mask;
use std::ops::Range;

/// A wall ends within so many pixels of the sign's edge,
const REACH: i64 = 5;

/// and is at least so many pixels thick: lines of routes and lettering are not. What covers more than this share of the
/// edge is a wall along it.
const THINNEST: usize = 3;
const THICKEST: f64 = 0.5;

/// Both ends of a wall lie side by side over at least this share of what they cover together.
const IN_LINE: f64 = 0.6;

/// A sign that is turned by more than this hides no upright wall from one edge to the other, radians.
const TURNED: f64 = 0.15;

/// Adds the pixels behind a sign of the walls that run through it. `ink`: what is left without the sign.
pub fn walls(ink: &Mask, sign: &SheetSymbol, out: &mut Mask) {
    let quarter = std::f64::consts::FRAC_PI_2;
    let turns = (sign.angle / quarter).round();
    if (sign.angle - turns * quarter).abs() > TURNED {
        return;
    }
    let is_upright = turns.rem_euclid(2.0) < 0.5;
    let [w, h] = if is_upright { [sign.width, sign.height] } else { [sign.height, sign.width] };
    let low = [sign.centre[0] - w / 2.0, sign.centre[1] - h / 2.0].map(|c| c.floor() as i64 - 1);
    let high = [sign.centre[0] + w / 2.0, sign.centre[1] + h / 2.0].map(|c| c.ceil() as i64 + 1);
    for along in [0, 1] {
        through(ink, low, high, along, out);
    }
}

/// The walls along one axis, 0 for x.
fn through(ink: &Mask, low: [i64; 2], high: [i64; 2], along: usize, out: &mut Mask) {
    let across = 1 - along;
    let place = |a: i64, b: i64| if along == 0 { [a, b] } else { [b, a] };
    let has_ink = |mut range: Range<i64>, b: i64| {
        range.any(|a| {
            let [x, y] = place(a, b);
            ink.get(x, y)
        })
    };
    let side = |range: Range<i64>| -> Vec<i64> {
        (low[across]..=high[across]).filter(|&b| has_ink(range.clone(), b)).collect()
    };
    let (before, after) =
        (side(low[along] - REACH..low[along]), side(high[along] + 1..high[along] + 1 + REACH));
    let thickest = THICKEST * (high[across] - low[across]) as f64;
    for end in ends(&before).filter(|end| (end.end - end.start) as f64 <= thickest) {
        for other in ends(&after).filter(|other| is_in_line(&end, other)) {
            for b in end.start.max(other.start)..end.end.min(other.end) {
                (low[along] - REACH..=high[along] + REACH).for_each(|a| set(out, place(a, b)));
            }
        }
    }
}

/// The ends of walls among the lines that have ink.
fn ends(lines: &[i64]) -> impl Iterator<Item = Range<i64>> {
    let walls = lines.chunk_by(|a, b| a + 1 == *b).filter(|wall| wall.len() >= THINNEST);
    walls.map(|wall| wall[0]..wall[0] + wall.len() as i64)
}

fn is_in_line(a: &Range<i64>, b: &Range<i64>) -> bool {
    let common = a.end.min(b.end) - a.start.max(b.start);
    let together = a.end.max(b.end) - a.start.min(b.start);
    common as f64 >= IN_LINE * together as f64
}

fn set(mask: &mut Mask, [x, y]: [i64; 2]) {
    if x >= 0 && y >= 0 && x < i64::from(mask.width) && y < i64::from(mask.height) {
        mask.set[y as usize * mask.width as usize + x as usize] = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is restored where a sign of 40 pixels hides the middle of these bars `[x0, y0, x1, y1]`.
    fn behind(bars: &[[i64; 4]]) -> Mask {
        let mut ink = Mask::empty(120, 120);
        for (x, y) in (0..120).flat_map(|x| (0..120).map(move |y| (x, y))) {
            let is_hidden = (40..80).contains(&x) && (40..80).contains(&y);
            let is_bar = bars.iter().any(|b| (b[0]..b[2]).contains(&x) && (b[1]..b[3]).contains(&y));
            ink.set[(y * 120 + x) as usize] = is_bar && !is_hidden;
        }
        let kind = "fire-hose-reel".to_owned();
        let sign = SheetSymbol {
            kind,
            centre: [60.0, 60.0],
            angle: 0.0,
            width: 40.0,
            height: 40.0,
            score: 1.0,
            leaves: vec![],
        };
        let mut out = Mask::empty(120, 120);
        walls(&ink, &sign, &mut out);
        out
    }

    #[test]
    fn a_wall_goes_on_behind_a_sign() {
        let level = behind(&[[0, 50, 120, 58]]);
        assert!((40..80).all(|x| level.get(x, 54)) && !level.get(60, 70));
        let upright = behind(&[[70, 0, 76, 120]]);
        assert!((40..80).all(|y| upright.get(73, y)) && !upright.get(60, 60));
    }

    #[test]
    fn walls_along_its_edges_do_not_meet_behind_it() {
        assert_eq!(behind(&[[20, 30, 100, 40], [20, 80, 100, 90]]).count(), 0);
    }

    #[test]
    fn a_wall_that_ends_there_and_a_thin_line_do_not() {
        assert_eq!(behind(&[[0, 50, 60, 58]]).count(), 0);
        assert_eq!(behind(&[[0, 50, 120, 51]]).count(), 0);
        assert_eq!(behind(&[[0, 44, 60, 50], [60, 66, 120, 72]]).count(), 0);
        assert_eq!(behind(&[[0, 44, 60, 54], [60, 51, 120, 61]]).count(), 0);
    }
}
