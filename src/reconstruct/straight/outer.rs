//! What lies beyond the stretches of a face from which no other face is seen, read off the map.

use super::carrier::Carrier;
use super::facing::{Beyond, Face, Stretch};
use super::{Labelled, Straight};

/// A stretch shorter than this is what its neighbour is, metres.
const SHORTEST: f64 = 0.3;

/// Gaps shorter than this between stretches are rounding, metres.
const ROUNDING: f64 = 0.02;

/// Fills the gaps between the stretches of a face.
pub fn complete(face: &Face, seen: Vec<Stretch>, input: &Labelled<'_>, params: &Straight) -> Vec<Stretch> {
    let length = face.segment.length();
    let mut all = Vec::new();
    let mut at = 0.0;
    let beside_wall = !seen.is_empty();
    for stretch in seen {
        all.extend(gap(face, (at, stretch.from), beside_wall, input, params));
        at = stretch.to;
        all.push(stretch);
    }
    all.extend(gap(face, (at, length), beside_wall, input, params));
    all
}

/// The stretches of a gap. A short one beside a wall is the end of another wall.
fn gap(
    face: &Face,
    (from, to): (f64, f64),
    beside_wall: bool,
    input: &Labelled<'_>,
    params: &Straight,
) -> Vec<Stretch> {
    if to - from < ROUNDING {
        return Vec::new();
    }
    let looks = Looks { face, line: Carrier::of(&face.segment), input, params };
    let step = input.resolution.min((to - from) / 2.0);
    let count = (((to - from) / step) as usize).max(1);
    let step = (to - from) / count as f64;
    let found: Vec<Beyond> = (0..count).map(|i| looks.beyond(from + (i as f64 + 0.5) * step)).collect();
    let mut runs = runs(&found);
    smooth(&mut runs, (SHORTEST / step).ceil() as usize);
    let end_of_wall = beside_wall && to - from <= params.max_wall;
    let stretch = |&(begin, end): &(usize, usize)| {
        let beyond = common(&found[begin..end]);
        let hidden = end_of_wall && matches!(beyond, Beyond::Wall { .. });
        let beyond = if hidden { Beyond::Other } else { beyond };
        Stretch { from: from + begin as f64 * step, to: from + end as f64 * step, beyond }
    };
    runs.iter().map(stretch).collect()
}

/// Begin and end of every run of the same kind.
fn runs(found: &[Beyond]) -> Vec<(usize, usize)> {
    let kind = |i: usize| std::mem::discriminant(&found[i]);
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for i in 0..found.len() {
        match runs.last_mut() {
            Some(last) if kind(last.0) == kind(i) => last.1 = i + 1,
            _ => runs.push((i, i + 1)),
        }
    }
    runs
}

/// Adds short runs to the longer one of their neighbours.
fn smooth(runs: &mut Vec<(usize, usize)>, shortest: usize) {
    let length = |r: &(usize, usize)| r.1 - r.0;
    while runs.len() > 1 {
        let Some(i) = (0..runs.len()).min_by_key(|&i| length(&runs[i])) else { return };
        if length(&runs[i]) >= shortest {
            return;
        }
        let before = if i > 0 { length(&runs[i - 1]) } else { 0 };
        let after = runs.get(i + 1).map_or(0, length);
        let first = if before >= after { i - 1 } else { i };
        runs[first].1 = runs[first + 1].1;
        runs.remove(first + 1);
    }
}

/// What most are; of walls with the median thickness.
fn common(found: &[Beyond]) -> Beyond {
    let mut walls: Vec<f64> = Vec::new();
    let (mut other, mut unknown) = (0, 0);
    for beyond in found {
        match beyond {
            Beyond::Wall { thickness } => walls.push(*thickness),
            Beyond::Unknown => unknown += 1,
            Beyond::Other | Beyond::Face { .. } => other += 1,
        }
    }
    if unknown > walls.len().max(other) {
        return Beyond::Unknown;
    }
    if other > walls.len() {
        return Beyond::Other;
    }
    super::super::walls::median(&mut walls).map_or(Beyond::Other, |thickness| Beyond::Wall { thickness })
}

struct Looks<'a> {
    face: &'a Face,
    line: Carrier,
    input: &'a Labelled<'a>,
    params: &'a Straight,
}

impl Looks<'_> {
    /// Looks out of the room at a place of the face.
    fn beyond(&self, at: f64) -> Beyond {
        let step = self.input.resolution / 2.0;
        let along = self.line.along(self.face.segment.a) + at;
        let mut wall: Option<f64> = None;
        let mut solid = true;
        let count = (self.params.max_wall / step) as usize;
        for i in 0..count {
            let out = (i as f64 + 0.5) * step;
            let (c, r) = self.input.cell(self.line.point(along, -out));
            let room = self.input.room(self.input.label, c, r) as usize;
            if self.input.obstacles.get(c, r) && room == 0 {
                if solid {
                    wall = Some(out + step / 2.0);
                }
                continue;
            }
            let another = room != 0 && room != self.face.room + 1;
            if another || (wall.is_some() && self.input.free.get(c, r)) {
                // Both faces were seen.
                return wall.map_or(Beyond::Other, |_| Beyond::Wall { thickness: out - step / 2.0 });
            }
            if wall.is_none() && out > self.params.frontier_reach.max(1.5 * self.input.resolution) {
                return Beyond::Unknown;
            }
            solid = wall.is_none();
        }
        let unseen = self.params.unseen_thickness;
        match wall {
            Some(thickness) if thickness < self.params.max_wall - 2.0 * step => {
                Beyond::Wall { thickness: thickness.max(unseen) }
            }
            Some(_) => Beyond::Wall { thickness: unseen },
            None => Beyond::Unknown,
        }
    }
}
