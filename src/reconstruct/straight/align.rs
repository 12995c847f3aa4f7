//! Collinear walls are collinear: over the whole building, pieces that run the same way at nearly the same offset get
//! one line, and where two rooms adjoin without a wall both have the same line.

use super::carrier::Carrier;
use super::pieces::{Piece, Track};
use super::{Labelled, Straight};
use std::f64::consts::PI;

/// Offsets within this are one under the strongest alignment, metres.
const MOST_APART: f64 = 0.2;

/// A track and the room that it goes around.
#[derive(Debug, Clone)]
pub struct Around {
    /// The room.
    pub room: usize,
    /// One ring of its cells' border.
    pub track: Track,
}

/// Moves pieces onto common lines. `label` is the raster whose borders were traced.
pub fn align(tracks: &mut [Around], main: &[f64], label: &[u32], input: &Labelled<'_>, params: &Straight) {
    for (bearing, &angle) in main.iter().enumerate() {
        for facing in [false, true] {
            let distance = MOST_APART * params.alignment;
            common_offsets(tracks, distance, |p| p.bearing == Some(bearing) && backwards(p, angle) == facing);
        }
    }
    join_open_sides(tracks, label, input);
}

/// Whether a piece runs against its main direction.
fn backwards(piece: &Piece, main: f64) -> bool {
    (piece.line.angle - main).cos() < 0.0
}

fn common_offsets(tracks: &mut [Around], distance: f64, is: impl Fn(&Piece) -> bool) {
    let mut found: Vec<(f64, usize, usize)> = Vec::new();
    for (t, around) in tracks.iter().enumerate() {
        let here = around.track.pieces.iter().enumerate().filter(|(_, p)| is(p));
        found.extend(here.map(|(i, p)| (p.line.offset, t, i)));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut rest = found.as_slice();
    while let Some(first) = rest.first() {
        let (group, after) = rest.split_at(rest.partition_point(|f| f.0 - first.0 <= distance));
        let weight = |t: usize, i: usize| tracks[t].track.pieces[i].sides as f64;
        let total: f64 = group.iter().map(|&(_, t, i)| weight(t, i)).sum();
        let mean = group.iter().map(|&(o, t, i)| o * weight(t, i)).sum::<f64>() / total.max(1.0);
        for &(_, t, i) in group {
            tracks[t].track.pieces[i].line.offset = mean;
        }
        rest = after;
    }
}

/// Gives both sides of an open boundary the line of the longer one.
fn join_open_sides(tracks: &mut [Around], label: &[u32], input: &Labelled<'_>) {
    let mut open: Vec<(usize, usize, usize, usize)> = Vec::new();
    for (t, around) in tracks.iter().enumerate() {
        for (i, piece) in around.track.pieces.iter().enumerate() {
            if let Some(other) = around.track.across(piece, label, input) {
                open.push((around.room.min(other), around.room.max(other), t, i));
            }
        }
    }
    open.sort_unstable();
    for group in open.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        for (k, &(.., t, i)) in group.iter().enumerate() {
            for &(.., u, j) in &group[k + 1..] {
                join(tracks, (t, i), (u, j), 2.5 * input.resolution);
            }
        }
    }
}

fn join(tracks: &mut [Around], a: (usize, usize), b: (usize, usize), most: f64) {
    let piece = |(t, i): (usize, usize)| (&tracks[t].track, tracks[t].track.pieces[i]);
    let ((s, p), (t, q)) = (piece(a), piece(b));
    if tracks[a.0].room == tracks[b.0].room || (p.line.angle - q.line.angle).cos() > -0.97 {
        return;
    }
    let ends = [t.at(q.from), t.end(&q)];
    let (low, high) = (p.line.along(s.at(p.from)), p.line.along(s.end(&p)));
    let far = ends.iter().all(|&e| p.line.along(e) < low) || ends.iter().all(|&e| p.line.along(e) > high);
    if far || ends.iter().any(|&e| p.line.side(q.line.project(e)).abs() > most) {
        return;
    }
    let (line, bearing, to) =
        if p.sides >= q.sides { (p.line, p.bearing, b) } else { (q.line, q.bearing, a) };
    let turned = Carrier::new(line.angle + PI, -line.offset);
    let shorter = &mut tracks[to.0].track.pieces[to.1];
    (shorter.line, shorter.bearing) = (turned, bearing);
}
