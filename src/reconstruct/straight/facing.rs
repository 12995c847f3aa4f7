//! Which faces of walls look at each other: what lies beyond each stretch of each room's outline.

use super::carrier::Carrier;
use super::outer;
use super::{Labelled, Straight};
use planform_sdk::{Point, Polygon, Segment, bounds, parallel};

/// Faces look at each other when their angles differ from opposite by less than this, as a cosine (15 degrees).
const OPPOSITE: f64 = -0.966;

/// Faces may overlap by this much, metres: rounding.
const OVERLAP: f64 = 0.02;

/// A side of a floor, with the room to its left.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// The room.
    pub room: usize,
    /// Where it runs.
    pub segment: Segment,
}

/// A part of a face.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// Where it begins and ends, metres from the begin of the face.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// What is there.
    pub beyond: Beyond,
}

/// What lies beyond a stretch of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Beyond {
    /// Another face, at these distances at begin and end, metres.
    Face {
        /// Index of the face.
        other: usize,
        /// Distances at begin and end, metres.
        gaps: [f64; 2],
    },
    /// A wall with nothing behind it.
    Wall {
        /// Its thickness, metres.
        thickness: f64,
    },
    /// The end of another wall, or a room that does not face this one.
    Other,
    /// Nothing that was seen.
    Unknown,
}

/// The sides of all floors, room by room, ring by ring.
pub fn faces(floors: &[Option<Polygon>]) -> Vec<Face> {
    let mut faces = Vec::new();
    for (room, floor) in floors.iter().enumerate() {
        for ring in floor.iter().flat_map(Polygon::rings) {
            let next = ring.iter().cycle().skip(1);
            faces.extend(ring.iter().zip(next).map(|(&a, &b)| Face { room, segment: Segment::new(a, b) }));
        }
    }
    faces
}

/// For each face its stretches, from its begin to its end.
pub fn stretches(faces: &[Face], input: &Labelled<'_>, params: &Straight) -> Vec<Vec<Stretch>> {
    let mut seen: Vec<Vec<Stretch>> = vec![Vec::new(); faces.len()];
    let segments: Vec<Segment> = faces.iter().map(|f| f.segment).collect();
    for (a, b) in near(&segments, params.max_wall) {
        for (from, to) in [(a, b), (b, a)] {
            seen[from].extend(sight(faces, from, to, params.max_wall));
        }
    }
    parallel::map(faces.len(), |i| outer::complete(&faces[i], nearest(&seen[i]), input, params))
}

/// The pairs of segments whose boxes are no farther apart than `reach`, in rising order.
pub fn near(segments: &[Segment], reach: f64) -> Vec<(usize, usize)> {
    let around = |s: &Segment| bounds([s.a, s.b]).unwrap_or_default();
    let mut boxes: Vec<(usize, (Point, Point))> =
        segments.iter().enumerate().map(|(i, s)| (i, around(s))).collect();
    boxes.sort_by(|a, b| a.1.0.x.total_cmp(&b.1.0.x));
    let mut pairs = Vec::new();
    for (k, (a, (low, high))) in boxes.iter().enumerate() {
        let beside = boxes[k + 1..].iter().take_while(|(_, (l, _))| l.x <= high.x + reach);
        let meeting = beside.filter(|(_, (l, h))| l.y <= high.y + reach && low.y <= h.y + reach);
        pairs.extend(meeting.map(|(b, _)| (*a.min(b), *a.max(b))));
    }
    pairs.sort_unstable();
    pairs
}

/// The stretch of a face from which another one is seen.
fn sight(faces: &[Face], from: usize, to: usize, max_wall: f64) -> Option<Stretch> {
    let (face, other) = (&faces[from].segment, &faces[to].segment);
    let line = Carrier::of(face);
    if (line.angle - other.angle()).cos() > OPPOSITE {
        return None;
    }
    let begin = line.along(face.a);
    // The other face runs the other way, so that its end comes first.
    let (s, t) = (line.along(other.b) - begin, line.along(other.a) - begin);
    let (low, high) = (s.max(0.0), t.min(face.length()));
    let (g, h) = (-line.side(other.b), -line.side(other.a));
    let gap = |at: f64| g + (h - g) * (at - s) / (t - s).max(f64::MIN_POSITIVE);
    let gaps = [gap(low), gap(high)];
    let thin = gaps.iter().all(|g| (-OVERLAP..=max_wall).contains(g));
    let beyond = Beyond::Face { other: to, gaps: gaps.map(|g| g.max(0.0)) };
    (thin && high > low + OVERLAP).then_some(Stretch { from: low, to: high, beyond })
}

/// At every place the nearest of the faces that are seen from there; disjoint, rising.
fn nearest(sights: &[Stretch]) -> Vec<Stretch> {
    let mut cuts: Vec<f64> = sights.iter().flat_map(|s| [s.from, s.to]).collect();
    cuts.sort_by(f64::total_cmp);
    let mut found: Vec<Stretch> = Vec::new();
    for pair in cuts.windows(2).filter(|p| p[1] - p[0] > OVERLAP) {
        let here = sights.iter().filter(|s| s.from <= pair[0] && s.to >= pair[1]);
        let gap = |s: &Stretch| s.gap_at((pair[0] + pair[1]) / 2.0);
        let Some(best) = here.min_by(|a, b| gap(a).total_cmp(&gap(b))) else { continue };
        let part = best.part(pair[0], pair[1]);
        match (found.last_mut(), part.other()) {
            (Some(last), Some(other)) if last.other() == Some(other) && pair[0] - last.to <= OVERLAP => {
                *last = best.part(last.from, part.to);
            }
            _ => found.push(part),
        }
    }
    found
}

impl Stretch {
    /// The face that is seen from here.
    pub fn other(&self) -> Option<usize> {
        match self.beyond {
            Beyond::Face { other, .. } => Some(other),
            _ => None,
        }
    }

    /// How thick the wall is at a place, metres.
    pub fn gap_at(&self, at: f64) -> f64 {
        match self.beyond {
            Beyond::Face { gaps: [g, h], .. } => {
                g + (h - g) * (at - self.from) / (self.to - self.from).max(f64::MIN_POSITIVE)
            }
            Beyond::Wall { thickness } => thickness,
            Beyond::Other | Beyond::Unknown => 0.0,
        }
    }

    /// The part of the stretch between two places.
    fn part(&self, from: f64, to: f64) -> Self {
        let beyond = match self.beyond {
            Beyond::Face { other, .. } => Beyond::Face { other, gaps: [self.gap_at(from), self.gap_at(to)] },
            same => same,
        };
        Self { from, to, beyond }
    }
}
