//! The building's main directions, and pieces turned to them.

use super::super::directions::{self, Directions, difference};
use super::pieces::{Piece, Track};
use super::{Labelled, Straight};
use planform_sdk::Segment;
use std::f64::consts::{FRAC_PI_2, PI};

/// Pieces are turned by at most this angle under the strongest alignment, radians.
const MOST_TURN: f64 = 0.35;

/// A turn moves a piece's ends by at most this much under the strongest alignment, metres.
const MOST_SHIFT: f64 = 0.4;

/// Two directions that cross at a right angle but for this, radians, do so.
const SQUARE: f64 = 0.05;

/// Pieces shorter than this many tolerances do not know their angle.
const SHORT: f64 = 3.0;

/// The main directions: angles in [0, pi), by rising angle. Where two rooms adjoin is no wall, and says nothing.
pub fn main(tracks: &[Track], input: &Labelled<'_>, tolerance: f64, params: &Straight) -> Vec<f64> {
    let long =
        |t: &Track, p: &Piece| t.length(p) > SHORT * tolerance && t.across(p, input.label, input).is_none();
    let of_track = |t: &Track| -> Vec<Segment> {
        let long = t.pieces.iter().filter(|p| long(t, p));
        long.map(|p| Segment::new(p.line.project(t.at(p.from)), p.line.project(t.end(p)))).collect()
    };
    let segments: Vec<Segment> = tracks.iter().flat_map(of_track).collect();
    let clusters =
        directions::cluster(&segments, &Directions { min_share: params.min_share, ..Directions::default() });
    let length = |s: &[Segment]| s.iter().map(Segment::length).sum::<f64>();
    let mut found: Vec<(f64, f64)> =
        clusters.iter().map(|c| (sharpened(c.angle, &c.segments), length(&c.segments))).collect();
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut angles = square(&found);
    angles.sort_by(f64::total_cmp);
    angles
}

/// The median of the segments' angles near a mode, each counted by the square of its length: how well a segment knows
/// its angle grows faster than its length.
fn sharpened(mode: f64, segments: &[Segment]) -> f64 {
    let turn = |s: &Segment| difference(directions::line_angle(s), mode);
    let mut turns: Vec<(f64, f64)> = segments.iter().map(|s| (turn(s), s.length().powi(2))).collect();
    turns.retain(|t| t.0.abs() < SQUARE);
    turns.sort_by(|a, b| a.0.total_cmp(&b.0));
    let half = turns.iter().map(|t| t.1).sum::<f64>() / 2.0;
    let mut sum = 0.0;
    let middle = turns.iter().find(|t| {
        sum += t.1;
        sum >= half
    });
    directions::wrap(mode + middle.map_or(0.0, |m| m.0))
}

/// Makes nearly right angles right, from the longest direction on.
fn square(found: &[(f64, f64)]) -> Vec<f64> {
    let mut angles: Vec<f64> = Vec::new();
    for (i, &(angle, length)) in found.iter().enumerate() {
        let crossing = (0..i).find(|&k| difference(angles[k] + FRAC_PI_2, angle).abs() < SQUARE);
        let Some(k) = crossing else {
            angles.push(angle);
            continue;
        };
        let turn = difference(angles[k] + FRAC_PI_2, angle) * length / (length + found[k].1);
        angles[k] = directions::wrap(angles[k] - turn);
        angles.push(directions::wrap(angles[k] + FRAC_PI_2));
    }
    angles
}

/// Turns a track's pieces to main directions.
pub fn turn(track: &mut Track, main: &[f64], tolerance: f64, params: &Straight) {
    for i in 0..track.pieces.len() {
        let piece = track.pieces[i];
        let away = |k: &usize| difference(main[*k], piece.line.angle).abs();
        let Some(k) = (0..main.len()).min_by(|a, b| away(a).total_cmp(&away(b))) else { continue };
        let length = track.length(&piece);
        let shift = length / 2.0 * away(&k).sin();
        let near = away(&k) <= MOST_TURN * params.alignment && shift <= MOST_SHIFT * params.alignment;
        if near || (length < SHORT * tolerance && params.alignment > 0.0) {
            let angle = towards(main[k], piece.line.angle);
            let line = track.through_median(piece.from, piece.sides, angle);
            track.pieces[i] = Piece { line, bearing: Some(k), ..piece };
        }
    }
}

/// The angle of a line in the sense that is nearer to another angle.
fn towards(line: f64, angle: f64) -> f64 {
    if (line - angle).cos() < 0.0 { line + PI } else { line }
}
