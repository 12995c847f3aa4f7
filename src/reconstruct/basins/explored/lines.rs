//! The lines that close rooms: where floors end at walls.

use super::super::super::straight::{Labelled, floor};
use super::Explored;
use super::field::{Field, Frame, Shown, Side};
use planform_sdk::parallel;

/// A wall stands within this many cells of its floor.
const BESIDE: f64 = 2.0;

/// A glimpse reaches at most this far beyond its door before its frontier begins, metres.
const WAY: f64 = 1.5;

/// A wall line has at least this much wall near a door, metres.
const OWN: f64 = 0.5;

/// Faces within this of each other lie on one line, metres; at least two cells.
const ALONE: f64 = 0.15;

/// So many cells at walls are looked at by a thread at a time.
const CELLS: usize = 4096;

/// Where a cell of a room ends at a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Face {
    /// Position outwards.
    at: f64,
    /// Position along the wall.
    aside: f64,
    room: usize,
}

/// All faces of walls in a frame.
pub struct Lines {
    pub frame: Frame,
    resolution: f64,
    /// For each side, by its index, the faces that close rooms there, by rising position.
    faces: Vec<Vec<Face>>,
    /// How well each room's walls gather on lines of the frame.
    sharpness: Vec<usize>,
}

impl Lines {
    /// Finds the faces; `at_walls` are the cells of [`at_walls`].
    pub fn of(input: &Labelled<'_>, at_walls: &[usize], frame: Frame) -> Self {
        let field = Field { input, label: input.label, frame };
        let parts: Vec<&[usize]> = at_walls.chunks(CELLS).collect();
        let found = parallel::map(parts.len(), |i| faces_of(&field, parts[i]));
        let faces = parallel::map(Side::ALL.len(), |side| {
            let mut faces: Vec<Face> = found.iter().flat_map(|f| f[side].iter().copied()).collect();
            faces.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.aside.total_cmp(&b.aside)));
            faces
        });
        let sharpness = sharpness(&faces, input);
        Self { frame, resolution: input.resolution, faces, sharpness }
    }

    /// The faces of a side from one position to another.
    fn between(&self, side: Side, from: f64, to: f64) -> &[Face] {
        let faces = &self.faces[side.index()];
        let (from, to) = (from.min(to), from.max(to));
        &faces[faces.partition_point(|f| f.at < from)..faces.partition_point(|f| f.at <= to)]
    }

    /// The wall line of a room on a side that is nearest to `before` from inside, in the sense of the side.
    pub fn own(&self, room: usize, side: Side, before: f64, aside: [f64; 2]) -> Option<f64> {
        let width = ALONE.max(2.0 * self.resolution);
        let near = |f: &&Face| f.room == room && f.aside > aside[0] && f.aside < aside[1];
        let faces = self.between(side, before * side.sense(), (before - WAY) * side.sense());
        let outs = faces.iter().filter(near).map(|f| f.at * side.sense());
        let mut outs: Vec<f64> = outs.filter(|&o| o < before && o > before - WAY).collect();
        outs.sort_by(|a, b| b.total_cmp(a));
        let count = |i: usize| outs[i..].iter().take_while(|&&o| o >= outs[i] - width).count();
        let need = (OWN / self.resolution).ceil() as usize;
        let first = (0..outs.len()).find(|&i| count(i) >= need)?;
        let within = outs[first..].iter().take_while(|&&o| o >= outs[first] - 2.0 * width).count();
        let best = (first..first + within).rev().max_by_key(|&i| count(i))?;
        Some(outs[best + count(best) / 2])
    }

    /// Whether a room has a wall on a side at this position.
    pub fn is_wall(&self, room: usize, side: Side, at: f64) -> bool {
        self.covered(room, side, at, [f64::MIN, f64::MAX]) >= OWN
    }

    /// How much of a range of a room's wall line is wall, metres.
    pub fn covered(&self, room: usize, side: Side, at: f64, aside: [f64; 2]) -> f64 {
        let width = ALONE.max(2.0 * self.resolution);
        let faces = &self.faces[side.index()];
        let begin = faces.partition_point(|f| f.at < at - width);
        let here = faces[begin..].iter().take_while(|f| f.at <= at + width);
        let own = here.filter(|f| f.room == room && f.aside > aside[0] && f.aside < aside[1]);
        let mut places: Vec<i64> = own.map(|f| (f.aside / self.resolution).floor() as i64).collect();
        places.sort_unstable();
        places.dedup();
        places.len() as f64 * self.resolution
    }

    /// The nearest line that closes rooms on a side: at least nearly at `from`, at most `params.reach` away, with faces
    /// no farther aside of the range than `params.row`.
    pub fn nearest(&self, side: Side, from: f64, aside: [f64; 2], params: &Explored) -> Option<f64> {
        let width = ALONE.max(2.0 * self.resolution);
        let (low, high) = (aside[0] - params.row, aside[1] + params.row);
        let sense = side.sense();
        let near = |f: &&Face| {
            let out = (f.at - from) * sense;
            f.aside > low && f.aside < high && out > -width && out < params.reach
        };
        let faces = self.between(side, from - 2.0 * width * sense, from + (params.reach + width) * sense);
        let mut outs: Vec<f64> = faces.iter().filter(near).map(|f| f.at * sense).collect();
        outs.sort_by(f64::total_cmp);
        let need = (params.support / self.resolution).ceil() as usize;
        // The first place with enough faces, and of those around it the one with most.
        let count = |i: usize| outs[i..].iter().take_while(|&&o| o <= outs[i] + width).count();
        let first = (0..outs.len()).find(|&i| count(i) >= need)?;
        let within = outs[first..].iter().take_while(|&&o| o <= outs[first] + 2.0 * width).count();
        let best = (first..first + within).rev().max_by_key(|&i| count(i))?;
        Some(outs[best + count(best) / 2] * sense)
    }
}

/// The lines in the frame in which a room's walls gather best.
pub fn sharpest(lines: &[Lines], room: usize) -> Option<&Lines> {
    lines.iter().max_by_key(|l| l.sharpness.get(room).copied().unwrap_or(0))
}

/// The faces of some cells at walls, for each side by its index.
fn faces_of(field: &Field<'_>, cells: &[usize]) -> [Vec<Face>; 4] {
    let input = field.input;
    let mut faces: [Vec<Face>; 4] = Default::default();
    for &cell in cells {
        let place = field.middle(cell);
        for side in Side::ALL {
            let mut out = place;
            out[side.axis] += side.sense() * input.resolution;
            let wall = (0..BESIDE as usize).any(|_| {
                let shown = field.at(out);
                out[side.axis] += side.sense() * input.resolution;
                shown == Shown::Obstacle
            });
            if wall {
                let at = place[side.axis] + side.sense() * input.resolution / 2.0;
                let room = input.label[cell] as usize - 1;
                faces[side.index()].push(Face { at, aside: place[1 - side.axis], room });
            }
        }
    }
    faces
}

/// For each room the sum of the squared numbers of faces on each line. The faces of each side are in order.
fn sharpness(faces: &[Vec<Face>], input: &Labelled<'_>) -> Vec<usize> {
    let width = ALONE.max(2.0 * input.resolution);
    let line = |f: &Face| floor(f.at / width);
    let (mut sharpness, mut counts) = (vec![0; input.rooms], vec![0usize; input.rooms]);
    for on_line in faces.iter().flat_map(|faces| faces.chunk_by(|a, b| line(a) == line(b))) {
        on_line.iter().for_each(|f| counts[f.room] += 1);
        for f in on_line {
            sharpness[f.room] += std::mem::take(&mut counts[f.room]).pow(2);
        }
    }
    sharpness
}

/// The cells of rooms with an obstacle within two cells, rising.
pub fn at_walls(input: &Labelled<'_>) -> Vec<usize> {
    let near = input.obstacles.grown(2);
    let is_room = |i: &usize| (1..=input.rooms).contains(&(input.label[*i] as usize));
    near.runs().flat_map(|run| run.cells(near.width())).filter(is_room).collect()
}
