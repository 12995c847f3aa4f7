//! Openings: where the cells of two rooms touch.
//!
//! Each connected piece of the boundary runs from jamb to jamb. Along its normal the opening is as deep as there is
//! wall beside both jambs: those cells are doorway, and no room's floor.

use super::super::directions::{difference, line_angle};
use super::super::runs::meetings;
use super::Labelled;
use super::carrier::Carrier;
use super::trace::corner_point;
use planform_sdk::{OpeningKind, Point, Segment, StatedOpening};
use std::collections::BTreeMap;

/// An opening is turned to a main direction that is nearer than this, radians: the boundary of two labels may cross
/// a deep doorway from corner to corner.
const TURN: f64 = 0.6;

/// A jamb is sought this far beyond the end of the boundary, metres.
const JAMB: f64 = 0.5;

/// Wall beside a jamb is sought this far, metres; at least one and a half cells.
const BESIDE: f64 = 0.1;

/// A boundary without a wall bends by at most this much around a straight one, metres.
const BEND: f64 = 0.6;

/// A corner of cells.
type Corner = (i64, i64);

/// Where two rooms touch.
#[derive(Debug, Clone, PartialEq)]
pub struct Doorway {
    /// From jamb to jamb, in the middle of the depth.
    pub segment: Segment,
    /// How deep it is, metres; 0 where no wall is.
    pub depth: f64,
    /// The rooms, the smaller first.
    pub rooms: [usize; 2],
    /// What it is, if the document states it.
    pub kind: Option<OpeningKind>,
}

/// Finds the openings, and takes their cells out of `label`. Where there is no wall, the labels are parted along the
/// straight line from jamb to jamb.
pub fn take(input: &Labelled<'_>, main: &[f64], max_depth: f64, label: &mut [u32]) -> Vec<Doorway> {
    let mut found = Vec::new();
    for (rooms, pieces) in boundaries(input) {
        for piece in pieces {
            if let Some(stated) = stated(input, &piece) {
                let doorway = take_stated(input, stated, rooms, max_depth, label);
                if !found.contains(&doorway) {
                    found.push(doorway);
                }
                continue;
            }
            let Some(look) = Look::of(input, main, &piece, rooms) else { continue };
            let [below, above] = look.depth(max_depth);
            if below + above > 0.0 {
                look.clear(below, above, label);
            } else {
                look.part(&piece, label);
            }
            let to = |along| look.line.point(along, (above - below) / 2.0);
            let segment = Segment::new(to(look.from), to(look.to));
            let rooms = rooms.map(|l| l as usize - 1);
            found.push(Doorway { segment, depth: below + above, rooms, kind: None });
        }
    }
    found
}

/// The nearest stated opening that a piece of a boundary lies in.
fn stated<'a>(input: &Labelled<'a>, piece: &[Corner]) -> Option<&'a StatedOpening> {
    let middle = chord(piece, input.resolution)?.midpoint();
    let near = input.stated.iter().filter_map(|o| {
        let line = Carrier::of(&o.segment);
        let (from, to) = (line.along(o.segment.a), line.along(o.segment.b));
        let within = (from - JAMB..=to + JAMB).contains(&line.along(middle));
        let side = line.side(middle).abs();
        (within && side <= JAMB + o.depth.unwrap_or(0.0) / 2.0).then_some((side, o))
    });
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, o)| o)
}

/// A stated opening is where it is stated; if its depth is not, that is looked for.
fn take_stated(
    input: &Labelled<'_>,
    stated: &StatedOpening,
    rooms: [u32; 2],
    max_depth: f64,
    label: &mut [u32],
) -> Doorway {
    let segment = stated.segment;
    let line = Carrier::of(&segment);
    let look = Look { input, line, from: line.along(segment.a), to: line.along(segment.b), rooms };
    let found = stated.depth.map(|d| [d / 2.0, d / 2.0]);
    let [below, above] = found.unwrap_or_else(|| look.depth(max_depth));
    look.clear(below, above, label);
    let rooms = rooms.map(|l| l as usize - 1);
    Doorway { segment, depth: below + above, rooms, kind: Some(stated.kind) }
}

/// The connected pieces of the boundary between each two rooms, as the corners they run through.
fn boundaries(input: &Labelled<'_>) -> BTreeMap<[u32; 2], Vec<Vec<Corner>>> {
    let mut sides: BTreeMap<[u32; 2], BTreeMap<Corner, Vec<Corner>>> = BTreeMap::new();
    let mut add = |a: u32, b: u32, from: Corner, to: Corner| {
        if a != b && a != 0 && b != 0 {
            let of_pair = sides.entry([a.min(b), a.max(b)]).or_default();
            of_pair.entry(from).or_default().push(to);
            of_pair.entry(to).or_default().push(from);
        }
    };
    let width = input.width();
    let room = |i: usize| if input.label[i] as usize <= input.rooms { input.label[i] } else { 0 };
    meetings(input.label, width, |m| {
        let (c, r) = ((m.cell % width) as i64, (m.cell / width) as i64);
        let from = if m.other == m.cell + 1 { (c + 1, r) } else { (c, r + 1) };
        add(room(m.cell), room(m.other), from, (c + 1, r + 1));
    });
    sides.into_iter().map(|(rooms, sides)| (rooms, connected(sides))).collect()
}

/// The connected parts, each with the corners at which it ends first.
fn connected(mut sides: BTreeMap<Corner, Vec<Corner>>) -> Vec<Vec<Corner>> {
    let mut parts = Vec::new();
    while let Some((&start, _)) = sides.first_key_value() {
        let (mut ends, mut middle, mut open) = (Vec::new(), Vec::new(), vec![start]);
        while let Some(at) = open.pop() {
            let Some(next) = sides.remove(&at) else { continue };
            if next.len() == 1 {
                ends.push(at)
            } else {
                middle.push(at)
            }
            open.extend(next);
        }
        ends.append(&mut middle);
        parts.push(ends);
    }
    parts
}

/// An opening as it is looked at: a line through the boundary's middle.
struct Look<'a> {
    input: &'a Labelled<'a>,
    line: Carrier,
    /// Where the jambs are on the line.
    from: f64,
    to: f64,
    /// The labels.
    rooms: [u32; 2],
}

impl<'a> Look<'a> {
    fn of(input: &'a Labelled<'a>, main: &[f64], piece: &[Corner], rooms: [u32; 2]) -> Option<Self> {
        let chord = chord(piece, input.resolution)?;
        let angle = line_angle(&chord);
        let turns = main.iter().map(|m| difference(*m, angle));
        let turn = turns.min_by(|a, b| a.abs().total_cmp(&b.abs())).filter(|t| t.abs() < TURN);
        let line = Carrier::through(chord.midpoint(), angle + turn.unwrap_or(0.0));
        let middle = line.along(chord.midpoint());
        let half = (line.along(chord.b) - line.along(chord.a)).abs() / 2.0;
        let look = Self { input, line, from: middle, to: middle, rooms };
        let (from, to) = (look.jamb(middle, -1.0, half), look.jamb(middle, 1.0, half));
        Some(Self { from, to, ..look })
    }

    /// Whether there is wall at a place: no room, and not seen free.
    fn wall(&self, along: f64, left: f64) -> bool {
        let (c, r) = self.cell(along, left);
        self.input.room(self.input.label, c, r) == 0 && !self.input.free.get(c, r)
    }

    fn cell(&self, along: f64, left: f64) -> Corner {
        let p = self.line.point(along, left);
        self.input.cell(p)
    }

    /// Where the wall begins from the middle in a sense; where the boundary ends if there is none near.
    fn jamb(&self, middle: f64, sense: f64, half: f64) -> f64 {
        let step = self.input.resolution / 4.0;
        let count = ((half + JAMB) / step) as usize;
        let near = (0..count).map(|i| middle + sense * (i as f64 + 0.5) * step);
        let at = near.into_iter().find(|&along| self.wall(along, 0.0));
        at.map_or(middle + sense * half, |along| along - sense * step / 2.0)
    }

    /// How deep the opening is to the right and to the left of the line, metres.
    fn depth(&self, most: f64) -> [f64; 2] {
        let step = self.input.resolution / 4.0;
        let beside = BESIDE.max(1.5 * self.input.resolution);
        let count = (most / step) as usize;
        [-1.0, 1.0].map(|sense| {
            let walled = |i: usize| {
                let left = sense * (i as f64 + 0.5) * step;
                self.walled(self.from, -1.0, left, beside) && self.walled(self.to, 1.0, left, beside)
            };
            let deep = (0..count).take_while(|&i| walled(i)).count();
            if deep < count { deep as f64 * step } else { 0.0 }
        })
    }

    /// Whether there is wall beside a jamb.
    fn walled(&self, jamb: f64, sense: f64, left: f64, beside: f64) -> bool {
        let step = self.input.resolution / 2.0;
        let count = (beside / step).ceil() as i64;
        (-1..=count).any(|i| self.wall(jamb + sense * (i as f64 + 0.5) * step, left))
    }

    /// Calls with the index of every cell of the two rooms whose centre lies in the box around the line, with the
    /// centre's distance to the left.
    fn each(&self, low: f64, high: f64, mut call: impl FnMut(usize, f64)) {
        let resolution = self.input.resolution;
        let slack = 1.5 * resolution;
        let corners = [(self.from, low), (self.to, low), (self.to, high), (self.from, high)];
        let cells = corners.map(|(along, left)| self.cell(along, left));
        let range = |of: fn(&Corner) -> i64| {
            let values = || cells.iter().map(of);
            values().min().unwrap_or(0) - 2..=values().max().unwrap_or(0) + 2
        };
        for r in range(|c| c.1) {
            for c in range(|c| c.0) {
                let p = Point::new((c as f64 + 0.5) * resolution, (r as f64 + 0.5) * resolution);
                let (along, left) = (self.line.along(p), self.line.side(p));
                let within =
                    along > self.from - slack && along < self.to + slack && left > low && left < high;
                let room = self.input.room(self.input.label, c, r);
                if let Some(i) = self.input.free.index(c, r).filter(|_| within && self.rooms.contains(&room))
                {
                    call(i, left);
                }
            }
        }
    }

    /// Takes the doorway out of the labels.
    fn clear(&self, below: f64, above: f64, label: &mut [u32]) {
        self.each(-below, above, |i, _| label[i] = 0);
    }

    /// Parts the labels along the line.
    fn part(&self, piece: &[Corner], label: &mut [u32]) {
        let sides = piece.iter().map(|&c| self.line.side(corner_point(c, self.input.resolution)));
        let (low, high) = sides.fold((0.0f64, 0.0f64), |(l, h), s| (l.min(s), h.max(s)));
        if high - low > BEND {
            return;
        }
        let (low, high) = (low - self.input.resolution, high + self.input.resolution);
        let mut first = [0usize; 2];
        self.each(low, high, |i, left| {
            let of_first = self.input.label[i] == self.rooms[0];
            first[usize::from((left > 0.0) == of_first)] += 1;
        });
        let [on_left, on_right] =
            if first[1] >= first[0] { self.rooms } else { [self.rooms[1], self.rooms[0]] };
        self.each(low, high, |i, left| label[i] = if left > 0.0 { on_left } else { on_right });
    }
}

/// From one end of a boundary to the other; of one without ends, between two points that are far apart.
fn chord(piece: &[Corner], resolution: f64) -> Option<Segment> {
    let square = |a: Corner, b: Corner| (a.0 - b.0).pow(2) + (a.1 - b.1).pow(2);
    let far = |from: Corner| piece.iter().copied().max_by_key(|&p| square(p, from));
    let a = *piece.first()?;
    let b = far(a)?;
    Some(Segment::new(corner_point(a, resolution), corner_point(b, resolution)))
}
