//! Where one room ends and the next begins: what the picture alone does not tell.

use crate::canvas::Paint;
use crate::drawing::{Drawing, REACH, is_at};
use planform_sdk::{Opening, OpeningKind, Point, Room, RoomId, Segment};

/// Places across the end of a floor that must all be free, cells: even a thin wall lies on one of them.
const ACROSS: [f64; 5] = [-0.75, -0.375, 0.0, 0.375, 0.75];

/// An opening as the map states it, metres in the map frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Stated {
    /// Door or passage.
    pub kind: OpeningKind,
    /// From one end to the other, in the middle between the floors.
    pub segment: Segment,
    /// How far the floors are apart.
    pub depth: f64,
}

/// All openings: where a floor ends and no wall is, the line on which it does; else the layout's opening and how deep
/// it is.
pub fn stated(drawing: &Drawing<'_>) -> Vec<Stated> {
    let ends: Vec<End> = drawing.layout.rooms.iter().flat_map(|room| ends(drawing, room)).collect();
    let own = |end: &End| {
        let at = |o: &&Opening| o.rooms == end.rooms && is_at(end.segment.midpoint(), o);
        drawing.layout.openings.iter().find(at)
    };
    let is_deep = |o: &&Opening| {
        let met = ends.iter().filter(|end| own(end).is_some_and(|own| std::ptr::eq(own, *o)));
        met.map(|end| end.segment.length()).sum::<f64>() < o.width() / 2.0
    };
    let shallow = ends.iter().map(|end| {
        let kind = own(end).map_or(OpeningKind::Door, |o| o.kind);
        Stated { kind, segment: end.segment, depth: 0.0 }
    });
    let deep = drawing.layout.openings.iter().filter(is_deep).filter_map(|o| centred(drawing, o));
    shallow.chain(deep).collect()
}

/// The opening in the middle between the floors, slanting as they do; none if it does not lie between those of its
/// rooms.
fn centred(drawing: &Drawing<'_>, opening: &Opening) -> Option<Stated> {
    let Opening { kind, segment, rooms } = *opening;
    let depths = drawing.depths(&segment, rooms)?;
    let [first, second] = depths.map(|[right, left]| (left - right) / 2.0);
    let (sin, cos) = segment.angle().sin_cos();
    let moved = |p: Point, off: f64| Point::new(p.x - off * sin, p.y + off * cos);
    // Each half tells of its middle: the ends are as far again from there.
    let slant = (second - first) / 2.0;
    let segment = Segment::new(moved(segment.a, first - slant), moved(segment.b, second + slant));
    Some(Stated { kind, segment, depth: depths.as_flattened().iter().sum::<f64>() / 2.0 })
}

/// A stretch of a room's outline beyond which the map is free.
struct End {
    segment: Segment,
    /// The room and the one beyond, the smaller first; twice the same if a doorway to others is there.
    rooms: [RoomId; 2],
}

/// The ends of a room's floor at other floors, each told by the room of the smaller number, and at doorways that are
/// none of the room's own.
fn ends(drawing: &Drawing<'_>, room: &Room) -> Vec<End> {
    let layout = drawing.layout;
    let look = Look {
        drawing,
        room,
        near: layout.rooms.iter().filter(|other| other.id != room.id && are_near(room, other)).collect(),
        own: layout.openings.iter().filter(|o| o.rooms.contains(&room.id)).collect(),
    };
    let sides = room.inner.rings().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    sides.flat_map(|(a, b)| look.along(&Segment::new(*a, *b))).collect()
}

/// Whether two rooms' boxes touch.
fn are_near(a: &Room, b: &Room) -> bool {
    let bounds = |room: &Room| planform_sdk::bounds(room.inner.exterior.iter().copied());
    bounds(a).zip(bounds(b)).is_some_and(|((low, high), (other_low, other_high))| {
        low.x <= other_high.x + REACH
            && other_low.x <= high.x + REACH
            && low.y <= other_high.y + REACH
            && other_low.y <= high.y + REACH
    })
}

/// A room and what may lie beyond its outline.
struct Look<'a> {
    drawing: &'a Drawing<'a>,
    room: &'a Room,
    near: Vec<&'a Room>,
    own: Vec<&'a Opening>,
}

impl Look<'_> {
    /// The stretches of a side of the room.
    fn along(&self, side: &Segment) -> Vec<End> {
        let count = (2.0 * side.length() / self.drawing.frame.resolution).ceil();
        // A side that is longer than the map's own is absurd.
        let most = 4.0 * (f64::from(self.drawing.frame.width) + f64::from(self.drawing.frame.height));
        if !(1.0..=most).contains(&count) {
            return Vec::new();
        }
        let places = (0..count as u32).map(|i| f64::from(i) / count);
        let beyond: Vec<Option<RoomId>> =
            places.map(|share| self.beyond(side, share + 0.5 / count)).collect();
        let mut ends = Vec::new();
        let mut from = 0;
        for run in beyond.chunk_by(|a, b| a == b) {
            let to = from + run.len();
            if let Some(other) = run[0] {
                let [a, b] = [from, to].map(|i| self.place(side, i as f64 / count, 0.0));
                let rooms = [other.min(self.room.id), other.max(self.room.id)];
                ends.push(End { segment: Segment::new(a, b), rooms });
            }
            from = to;
        }
        ends
    }

    /// The room beyond a place of a side, if nothing parts the two and it is not up to the other one to tell; the room
    /// itself for a doorway.
    fn beyond(&self, side: &Segment, share: f64) -> Option<RoomId> {
        let cell = self.drawing.frame.resolution;
        let is_free =
            |right: &f64| self.drawing.paint(self.place(side, share, right * cell)) == Some(Paint::Free);
        if !ACROSS.iter().all(is_free) {
            return None;
        }
        let p = self.place(side, share, ACROSS[4] * cell);
        match self.near.iter().find(|other| other.inner.contains(p)) {
            Some(other) => Some(other.id).filter(|id| *id > self.room.id),
            None => {
                let is_own = self.room.inner.contains(p) || self.own.iter().any(|o| is_at(p, o));
                Some(self.room.id).filter(|_| !is_own)
            }
        }
    }

    fn place(&self, side: &Segment, share: f64, right: f64) -> Point {
        let (sin, cos) = side.angle().sin_cos();
        let (a, b) = (side.a, side.b);
        Point::new(a.x + share * (b.x - a.x) + right * sin, a.y + share * (b.y - a.y) - right * cos)
    }
}
