//! Pieces that nobody built: jogs, cut corners and dents within the tolerances go, and their neighbours take over.

use super::Straight;
use super::carrier::Carrier;
use super::pieces::{Piece, Track};

/// The longest run of pieces between two that is replaced at once: a dent has two sides and a bottom, each perhaps cut
/// at a corner.
const MOST_BETWEEN: usize = 4;

/// Angles differ by less than this between pieces on one line, as a cosine.
const SAME: f64 = 0.9986;

/// The least sine of the angle at which two pieces make a corner of what lies between.
const CORNER: f64 = 0.3;

/// A corner may lie this many tolerances outside of what it replaces.
const BEYOND: f64 = 2.0;

/// Removes what is smaller than the tolerances.
pub fn simplify(track: &mut Track, tolerance: f64, params: &Straight) {
    let (mut i, mut kept) = (0, 0);
    while track.pieces.len() > 3 && kept < track.pieces.len() {
        let most = MOST_BETWEEN.min(track.pieces.len() - 3);
        let found =
            (0..=most).find_map(|between| Some((between, replace(track, i, between, tolerance, params)?)));
        if let Some((between, pieces)) = found {
            put(track, i, between, &pieces);
            i = i.min(track.pieces.len() - 1);
            kept = 0;
        } else {
            kept += 1;
        }
        i = (i + 1) % track.pieces.len();
    }
}

/// Puts pieces in the place of piece `i`, those between and the one after them.
fn put(track: &mut Track, i: usize, between: usize, pieces: &[Piece]) {
    let n = track.pieces.len();
    track.pieces.rotate_left(i % n);
    track.pieces.splice(0..between + 2, pieces.iter().copied());
    let n = track.pieces.len();
    track.pieces.rotate_right(i % n);
}

/// What piece `i` and the one after those between become, if those between are not needed.
fn replace(track: &Track, i: usize, between: usize, tolerance: f64, params: &Straight) -> Option<Vec<Piece>> {
    let n = track.pieces.len();
    let (a, b) = (track.pieces[i % n], track.pieces[(i + between + 1) % n]);
    if (a.line.angle - b.line.angle).cos() > SAME {
        return one_line(track, &a, &b, tolerance, params).map(|p| vec![p]);
    }
    if between == 0 { None } else { corner(track, &a, &b, tolerance) }
}

/// The indices of the points from the end of one piece to the begin of another.
fn gap(track: &Track, a: &Piece, b: &Piece) -> std::ops::RangeInclusive<usize> {
    let n = track.points.len();
    let from = a.from + a.sides;
    from..=from + (b.from + n - from % n) % n
}

/// Both as one, if they lie on one line and what is between is a dent.
fn one_line(track: &Track, a: &Piece, b: &Piece, tolerance: f64, params: &Straight) -> Option<Piece> {
    let gap = gap(track, a, b);
    let line = mean(a, b);
    let middle = |p: &Piece| track.at(p.from).midpoint(track.end(p));
    let apart = (a.line.side(middle(b))).abs().max(b.line.side(middle(a)).abs());
    let width = track.at(*gap.start()).distance(track.at(*gap.end()));
    let depth = gap.clone().map(|i| line.side(track.at(i)).abs()).fold(0.0, f64::max);
    let dent = width <= params.dent_width && depth <= params.dent_depth.max(tolerance);
    let sides = gap.end() + b.sides - a.from;
    (apart <= tolerance && (dent || depth <= tolerance)).then_some(Piece { from: a.from, sides, line, ..*a })
}

/// The line between two that are nearly one, by their lengths.
fn mean(a: &Piece, b: &Piece) -> Carrier {
    let (m, n) = (a.sides as f64, b.sides as f64);
    let (long, short) = if m >= n { (a, b) } else { (b, a) };
    if a.bearing != b.bearing {
        return long.line;
    }
    let turn = (short.line.angle - long.line.angle).sin();
    let share = m.min(n) / (m + n).max(1.0);
    let offset = long.line.offset * (1.0 - share) + short.line.offset * share;
    Carrier::new(long.line.angle + turn * share, offset)
}

/// Both, prolonged to their corner, if what is between lies along them.
fn corner(track: &Track, a: &Piece, b: &Piece, tolerance: f64) -> Option<Vec<Piece>> {
    if (b.line.angle - a.line.angle).sin().abs() < CORNER {
        return None;
    }
    let at = a.line.meet(&b.line)?;
    let gap = gap(track, a, b);
    let away = |i: usize| a.line.side(track.at(i)).abs().min(b.line.side(track.at(i)).abs());
    if gap.clone().any(|i| away(i) > tolerance) {
        return None;
    }
    let distance = |i: &usize| track.at(*i).distance(at);
    let nearest = gap.clone().min_by(|i, k| distance(i).total_cmp(&distance(k)))?;
    let first = Piece { sides: nearest - a.from, ..*a };
    let n = track.points.len();
    let second = Piece { from: nearest % n, sides: b.sides + gap.end() - nearest, ..*b };
    (distance(&nearest) <= BEYOND * tolerance).then(|| vec![first, second])
}
