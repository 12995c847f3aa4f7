//! Walls that go on are one wall, and walls meet where their centre lines do.

use super::StraightWall;
use super::carrier::Carrier;
use super::facing::near;
use planform_sdk::{Point, Segment};
use std::collections::BTreeMap;

/// Walls on one line: the cosine of their angle, their distance and the difference of their thickness, metres.
const SAME_ANGLE: f64 = 0.9986;
const SAME_LINE: f64 = 0.03;
const SAME_THICKNESS: f64 = 0.06;

/// Walls that are no farther apart along their line touch, metres.
const TOUCH: f64 = 0.03;

/// An end may be this much farther from the corner than the walls are thick, metres.
const SLACK: f64 = 0.1;

/// Joins walls on one line that touch and part the same rooms.
pub fn join(walls: Vec<StraightWall>) -> Vec<StraightWall> {
    let mut groups: BTreeMap<[Option<usize>; 2], Vec<StraightWall>> = BTreeMap::new();
    for wall in walls {
        let mut rooms = wall.rooms;
        rooms.sort_unstable();
        groups.entry(rooms).or_default().push(wall);
    }
    groups.into_values().flat_map(join_group).collect()
}

fn join_group(walls: Vec<StraightWall>) -> Vec<StraightWall> {
    let mut joined: Vec<StraightWall> = Vec::new();
    for mut wall in walls {
        while let Some((i, both)) =
            joined.iter().enumerate().find_map(|(i, other)| Some((i, one(other, &wall)?)))
        {
            joined.remove(i);
            wall = both;
        }
        joined.push(wall);
    }
    joined
}

/// Both as one, if they are one.
fn one(a: &StraightWall, b: &StraightWall) -> Option<StraightWall> {
    let line = Carrier::of(&a.line);
    let same = (line.angle - b.line.angle()).cos() > SAME_ANGLE && a.rooms == b.rooms;
    let opposite = (line.angle - b.line.angle()).cos() < -SAME_ANGLE && a.rooms == [b.rooms[1], b.rooms[0]];
    let straight = [b.line.a, b.line.b].iter().all(|&p| line.side(p).abs() <= SAME_LINE);
    if !(same || opposite) || !straight || (a.thickness - b.thickness).abs() > SAME_THICKNESS {
        return None;
    }
    let b_line = if same { b.line } else { Segment::new(b.line.b, b.line.a) };
    let (s, t) = (line.along(a.line.a), line.along(a.line.b));
    let (u, v) = (line.along(b_line.a), line.along(b_line.b));
    if u > t + TOUCH || v < s - TOUCH {
        return None;
    }
    let (m, n) = (a.line.length(), b.line.length());
    let share = n / (m + n).max(f64::MIN_POSITIVE);
    let left = line.side(b_line.midpoint()) * share;
    let segment = Segment::new(line.point(s.min(u), left), line.point(t.max(v), left));
    let thickness = a.thickness * (1.0 - share) + b.thickness * share;
    Some(StraightWall { line: segment, thickness, ..a.clone() })
}

/// Moves the ends of walls to where their centre lines meet others, if that is no farther than walls are thick.
pub fn meet(walls: &mut [StraightWall]) {
    let segments: Vec<Segment> = walls.iter().map(|w| w.line).collect();
    let thickest = walls.iter().map(|w| w.thickness).fold(0.0, f64::max);
    let mut best: Vec<[Option<(f64, Point)>; 2]> = vec![[None; 2]; walls.len()];
    for (a, b) in near(&segments, thickest + SLACK) {
        for (from, to) in [(a, b), (b, a)] {
            consider(&walls[from], &walls[to], &mut best[from]);
        }
    }
    for (wall, [a, b]) in walls.iter_mut().zip(best) {
        let (from, to) = (a.map_or(wall.line.a, |a| a.1), b.map_or(wall.line.b, |b| b.1));
        // A wall that is all corner stays as it is.
        if (to.x - from.x) * (wall.line.b.x - wall.line.a.x)
            + (to.y - from.y) * (wall.line.b.y - wall.line.a.y)
            > 0.0
        {
            wall.line = Segment::new(from, to);
        }
    }
}

/// Remembers where another wall is met, for each end the nearest.
fn consider(wall: &StraightWall, other: &StraightWall, best: &mut [Option<(f64, Point)>; 2]) {
    let (line, across) = (Carrier::of(&wall.line), Carrier::of(&other.line));
    let Some(at) = line.meet(&across) else { return };
    let reach = (wall.thickness + other.thickness) / 2.0 + SLACK;
    let along = across.along(at);
    let (low, high) = (across.along(other.line.a), across.along(other.line.b));
    if along < low - reach || along > high + reach {
        return;
    }
    for (end, best) in [wall.line.a, wall.line.b].into_iter().zip(best) {
        let distance = end.distance(at);
        if distance <= reach && best.is_none_or(|(d, _)| distance < d) {
            *best = Some((distance, at));
        }
    }
}
