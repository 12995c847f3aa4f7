//! Walls between faces that look at each other, and around the building.

use super::super::openings::Gap;
use super::carrier::Carrier;
use super::doorways::Doorway;
use super::facing::{Beyond, Face, Stretch};
use super::{Labelled, OpenSide, Straight, StraightWall};
use planform_sdk::{OpeningKind, Segment};

/// A wall shorter than this is a remnant, metres.
const SHORTEST: f64 = 0.05;

/// What is left of a wall beside an opening is no wall if it is shorter than this, metres: it lies within another wall.
const STUB: f64 = 0.15;

/// An opening belongs to a wall whose angle differs by less than this, as a cosine.
const ALONG: f64 = 0.85;

/// An opening may lie this far from the centre line of its wall, metres.
const BESIDE: f64 = 0.3;

/// The walls of all stretches, each once, and the open sides.
pub fn of_stretches(faces: &[Face], stretches: &[Vec<Stretch>]) -> (Vec<StraightWall>, Vec<OpenSide>) {
    let (mut walls, mut open) = (Vec::new(), Vec::new());
    for (i, (face, stretches)) in faces.iter().zip(stretches).enumerate() {
        for stretch in stretches {
            match stretch.beyond {
                Beyond::Face { other, .. } if i < other => {
                    walls.push(wall(face, stretch, Some(faces[other].room)));
                }
                Beyond::Wall { .. } => walls.push(wall(face, stretch, None)),
                Beyond::Unknown => {
                    open.push(OpenSide { segment: beside(face, stretch, [0.0; 2]), room: face.room })
                }
                Beyond::Face { .. } | Beyond::Other => {}
            }
        }
    }
    walls.retain(|w: &StraightWall| w.line.length() >= SHORTEST);
    (walls, open)
}

fn wall(face: &Face, stretch: &Stretch, other: Option<usize>) -> StraightWall {
    let gaps = [stretch.gap_at(stretch.from), stretch.gap_at(stretch.to)];
    StraightWall {
        line: beside(face, stretch, gaps.map(|g| g / 2.0)),
        thickness: (gaps[0] + gaps[1]) / 2.0,
        weight: 0.0,
        rooms: [Some(face.room), other],
    }
}

/// A stretch moved out of the room at its begin and end.
fn beside(face: &Face, stretch: &Stretch, out: [f64; 2]) -> Segment {
    let line = Carrier::of(&face.segment);
    let begin = line.along(face.segment.a);
    Segment::new(line.point(begin + stretch.from, -out[0]), line.point(begin + stretch.to, -out[1]))
}

/// The opening of a doorway, on its wall's centre line, if it is wide enough to go through.
pub fn opening(doorway: &Doorway, walls: &[StraightWall], params: &Straight) -> Option<Gap> {
    let middle = doorway.segment.midpoint();
    let away = |w: &&StraightWall| Carrier::of(&w.line).side(middle).abs();
    let own = walls.iter().filter(|w| holds(w, &doorway.segment, doorway.rooms));
    let segment = match own.min_by(|a, b| away(a).total_cmp(&away(b))) {
        Some(wall) => {
            let line = Carrier::of(&wall.line);
            Segment::new(line.project(doorway.segment.a), line.project(doorway.segment.b))
        }
        None => doorway.segment,
    };
    let width = segment.length();
    let usual = if width <= params.max_door { OpeningKind::Door } else { OpeningKind::Passage };
    let kind = doorway.kind.unwrap_or(usual);
    (width >= params.min_opening).then_some(Gap { kind, segment, rooms: doorway.rooms })
}

/// Whether an opening between two rooms is in a wall.
fn holds(wall: &StraightWall, opening: &Segment, rooms: [usize; 2]) -> bool {
    let between = wall.rooms == rooms.map(Some) || wall.rooms == [Some(rooms[1]), Some(rooms[0])];
    if !between {
        return false;
    }
    let line = Carrier::of(&wall.line);
    let along = (line.angle - opening.angle()).cos().abs() > ALONG;
    let (low, high) = (line.along(wall.line.a), line.along(wall.line.b));
    let (s, t) = (line.along(opening.a), line.along(opening.b));
    let beside = line.side(opening.midpoint()).abs() <= wall.thickness / 2.0 + BESIDE;
    along && beside && s.max(t) > low && s.min(t) < high
}

/// The walls without their openings.
pub fn without(walls: Vec<StraightWall>, openings: &[Doorway]) -> Vec<StraightWall> {
    let mut by_rooms: std::collections::BTreeMap<[usize; 2], Vec<&Doorway>> = Default::default();
    for opening in openings {
        by_rooms.entry(opening.rooms).or_default().push(opening);
    }
    let parts = |wall: StraightWall| {
        let [Some(a), Some(b)] = wall.rooms else { return vec![wall] };
        let here = by_rooms.get(&[a.min(b), a.max(b)]);
        let here = here.into_iter().flatten().filter(|o| holds(&wall, &o.segment, o.rooms));
        subtract(&wall, here.map(|o| o.segment))
    };
    walls.into_iter().flat_map(parts).collect()
}

fn subtract(wall: &StraightWall, openings: impl Iterator<Item = Segment>) -> Vec<StraightWall> {
    let line = Carrier::of(&wall.line);
    let mut taken: Vec<(f64, f64)> =
        openings.map(|o| (line.along(o.a), line.along(o.b))).map(|(s, t)| (s.min(t), s.max(t))).collect();
    taken.sort_by(|a, b| a.0.total_cmp(&b.0));
    if taken.is_empty() {
        return vec![wall.clone()];
    }
    let (mut at, end) = (line.along(wall.line.a), line.along(wall.line.b));
    let mut parts = Vec::new();
    taken.push((end, end));
    for (from, to) in taken {
        if from.min(end) - at >= STUB {
            let segment = Segment::new(line.point(at, 0.0), line.point(from.min(end), 0.0));
            parts.push(StraightWall { line: segment, ..wall.clone() });
        }
        at = at.max(to);
    }
    parts
}

/// Weighs every wall by what the map shows, and drops what stands in the open: no obstacle, but cells seen free.
pub fn weigh(walls: &mut Vec<StraightWall>, input: &Labelled<'_>) {
    walls.retain_mut(|wall| {
        let (obstacle, free) = shares(wall, input);
        wall.weight = obstacle;
        obstacle > 0.1 || free < 0.5
    });
}

/// The shares of a wall's length across which an obstacle stands, and on which it was seen free.
fn shares(wall: &StraightWall, input: &Labelled<'_>) -> (f64, f64) {
    let line = Carrier::of(&wall.line);
    let step = input.resolution;
    let count = ((wall.line.length() / step) as usize).max(1);
    let reach = ((wall.thickness / 2.0 + 1.5 * step) / (step / 2.0)).ceil() as i64;
    let (mut obstacle, mut free) = (0, 0);
    for i in 0..count {
        let along = line.along(wall.line.a) + (i as f64 + 0.5) * wall.line.length() / count as f64;
        let cell = |left: f64| input.cell(line.point(along, left));
        let stands = |k: i64| {
            let (c, r) = cell(k as f64 * step / 2.0);
            input.obstacles.get(c, r)
        };
        let (c, r) = cell(0.0);
        // From the middle on: it most likely stands there.
        obstacle += usize::from((0..=reach).any(|k| stands(k) || stands(-k)));
        free += usize::from(input.free.get(c, r));
    }
    (obstacle as f64 / count as f64, free as f64 / count as f64)
}
