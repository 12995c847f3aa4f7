//! The order of the steps.

use super::super::inner;
use super::align::{Around, align};
use super::bearings;
use super::doorways;
use super::pieces::Track;
use super::simplify::simplify;
use super::trace::{self, Cells, Ring, corner_point};
use super::{Labelled, Plan, RoomPlan, Straight, centre, corners, facing, guard, joints, walls};
use planform_sdk::{Point, Polygon, parallel};

/// The share of a room's area by which its polygon may differ from its cells, beyond what the tolerance allows.
const MOST_DIFFERENCE: f64 = 0.02;

/// Corners may lie this many tolerances from the cells' border.
const REACH: f64 = 4.0;

/// See [`super::plan`].
pub fn plan(input: &Labelled<'_>, main: &[f64], params: &Straight) -> Plan {
    let tolerance = tolerance(input, params);
    let mut label = input.label.to_vec();
    let doorways = doorways::take(input, main, params.max_wall, &mut label);
    let rooms = cells(input, &label, params);
    let drawing = Drawing { input, params, main, label: &label, tolerance };
    let floors = drawing.floors(&rooms);
    let faces = facing::faces(&floors);
    let stretches = facing::stretches(&faces, input, params);
    let centres = centre::centres(&floors, &faces, &stretches);
    let (walls, frontiers) = walls::of_stretches(&faces, &stretches);
    let mut walls = joints::join(walls);
    joints::meet(&mut walls);
    let openings = doorways.iter().filter_map(|d| walls::opening(d, &walls, params)).collect();
    let mut walls = walls::without(walls, &doorways);
    walls::weigh(&mut walls, input);
    let rooms = floors.into_iter().zip(centres);
    let rooms = rooms.map(|(f, c)| f.zip(c).map(|(floor, centre)| RoomPlan { floor, centre })).collect();
    Plan { rooms, walls, openings, frontiers }
}

/// See [`super::directions`].
pub fn directions(input: &Labelled<'_>, params: &Straight) -> Vec<f64> {
    let tolerance = tolerance(input, params);
    bearings::main(&tracks(input, tolerance), input, tolerance, params)
}

fn tolerance(input: &Labelled<'_>, params: &Straight) -> f64 {
    params.tolerance.max(1.5 * input.resolution)
}

/// The cells of each room's floor with the rings around them; of a room that is all doorway, all.
fn cells(input: &Labelled<'_>, label: &[u32], params: &Straight) -> Vec<Option<(Cells, Vec<Ring>)>> {
    let (whole, left) = (trace::boxes(input, input.label), trace::boxes(input, label));
    parallel::map(whole.len(), |room| {
        let (label, around) = left[room].map_or((input.label, whole[room]?), |around| (label, around));
        Some(Cells::of(input, label, room, around, params))
    })
}

/// All borders of rooms, doorways included.
fn tracks(input: &Labelled<'_>, tolerance: f64) -> Vec<Track> {
    let boxes = trace::boxes(input, input.label);
    let of_room = |room: usize| -> Vec<Track> {
        let rings = boxes[room].map(|around| Cells::all(input, input.label, room, around).rings());
        rings.iter().flatten().map(|r| Track::of(r, input.resolution, tolerance)).collect()
    };
    parallel::map(boxes.len(), of_room).into_iter().flatten().collect()
}

/// What rooms are drawn with.
struct Drawing<'a> {
    input: &'a Labelled<'a>,
    params: &'a Straight,
    main: &'a [f64],
    label: &'a [u32],
    tolerance: f64,
}

impl Drawing<'_> {
    /// The floors, disjoint.
    fn floors(&self, rooms: &[Option<(Cells, Vec<Ring>)>]) -> Vec<Option<Polygon>> {
        let of_room = |room: usize| -> Vec<Around> {
            let rings = rooms[room].iter().flat_map(|(_, rings)| rings);
            rings.map(|r| Around { room, track: self.track(r, self.tolerance) }).collect()
        };
        let mut tracks = parallel::map(rooms.len(), of_room).into_iter().flatten().collect::<Vec<_>>();
        align(&mut tracks, self.main, self.label, self.input, self.params);
        let (mut floors, exact): (Vec<_>, Vec<_>) = parallel::map(rooms.len(), |room| {
            let own = tracks.partition_point(|a| a.room < room)..tracks.partition_point(|a| a.room <= room);
            let cells = rooms[room].as_ref();
            let floor = cells.map(|(cells, rings)| self.floor(cells, rings, &tracks[own]));
            (floor, cells.map_or_else(Polygon::default, |(_, rings)| self.exact(rings)))
        })
        .into_iter()
        .unzip();
        inner::part(&mut floors, &exact);
        inner::separate(&mut floors, &exact);
        floors
    }

    fn track(&self, ring: &Ring, tolerance: f64) -> Track {
        let mut track = Track::of(ring, self.input.resolution, tolerance);
        bearings::turn(&mut track, self.main, tolerance, self.params);
        simplify(&mut track, tolerance, self.params);
        track
    }

    /// The first of these that fits the cells: the aligned outline, one of its own with half the tolerance, the cells'
    /// border.
    fn floor(&self, cells: &Cells, rings: &[Ring], aligned: &[Around]) -> Polygon {
        let first = polygon(aligned.iter().map(|a| &a.track), self.tolerance);
        if let Some(fitting) = self.fitting(first, cells) {
            return fitting;
        }
        let closer: Vec<Track> = rings.iter().map(|r| self.track(r, self.tolerance / 2.0)).collect();
        let second = polygon(closer.iter(), self.tolerance / 2.0);
        self.fitting(second, cells).unwrap_or_else(|| self.exact(rings))
    }

    fn fitting(&self, polygon: Polygon, cells: &Cells) -> Option<Polygon> {
        let polygon = inner::settled(polygon)?;
        let size = self.input.resolution;
        let differing = guard::difference(&polygon, cells, size) as f64 * size * size;
        let border: f64 = polygon.rings().map(length).sum();
        let most = MOST_DIFFERENCE * polygon.area() + 0.5 * self.tolerance * border;
        (differing <= most).then_some(polygon)
    }

    /// The cells' border itself.
    fn exact(&self, rings: &[Ring]) -> Polygon {
        let ring = |r: &Ring| -> Vec<Point> {
            inner::clean(r.iter().map(|&c| corner_point(c, self.input.resolution)).collect())
        };
        let mut rings = rings.iter().map(ring);
        Polygon::new(rings.next().unwrap_or_default(), rings.collect())
    }
}

/// The polygon of tracks, the outer ring first.
fn polygon<'a>(tracks: impl Iterator<Item = &'a Track>, tolerance: f64) -> Polygon {
    let mut rings = tracks.map(|t| inner::clean(corners::corners(t, REACH * tolerance)));
    Polygon { exterior: rings.next().unwrap_or_default(), holes: rings.filter(|r| r.len() > 2).collect() }
}

fn length(ring: &[Point]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(a, b)| a.distance(*b)).sum()
}
