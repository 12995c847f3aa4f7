//! Where the pieces of a ring meet.

use super::pieces::{Piece, Track};
use planform_sdk::Point;

/// The corners of a ring: neighbours meet where their lines do; if that is farther than `reach` from where the cells'
/// border goes from one to the other, a step across joins them.
pub fn corners(track: &Track, reach: f64) -> Vec<Point> {
    let n = track.pieces.len();
    let mut ring = Vec::with_capacity(n + 4);
    for i in 0..n {
        let (a, b) = (&track.pieces[i], &track.pieces[(i + 1) % n]);
        join(track, a, b, reach, &mut ring);
    }
    ring
}

fn join(track: &Track, a: &Piece, b: &Piece, reach: f64, ring: &mut Vec<Point>) {
    let at = track.end(a);
    match a.line.meet(&b.line).filter(|p| p.distance(at) <= reach) {
        Some(p) => ring.push(p),
        None => ring.extend([a.line.project(at), b.line.project(at)]),
    }
}
