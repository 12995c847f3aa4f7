//! The way a robot takes through a building: always to a near place that it has not seen from near.

use crate::building::Building;
use crate::obstacles::{Face, Obstacles};
use crate::params::RoomKind;
use crate::raster::Frame;
use planform_sdk::{GridError, Point, RoomId};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Side of a cell of the robot's own map, metres.
pub(crate) const STEP: f64 = 0.1;
/// The robot's middle keeps this far from everything, metres.
const CLEARANCE: f64 = 0.22;
/// Places to visit are about this far apart, metres.
const SPACING: f64 = 3.0;
/// A place counts as visited from here, metres.
const NEAR: f64 = 0.9;

/// The detour that a room is worth, in cells.
const PATIENCE: u32 = 70;

struct Drive {
    corridors: BTreeSet<RoomId>,
    frame: Frame,
    drivable: Vec<bool>,
    room: Vec<RoomId>,
    /// Cells to visit with their rooms.
    targets: BTreeMap<usize, RoomId>,
    parent: Vec<u32>,
    round: Vec<u32>,
}

/// The way through the rooms `open` (by id), as points 0.1 to 0.15 m apart, from the first room that has place. The
/// robot stops where it would enter more than `most` rooms.
pub(crate) fn drive(
    building: &Building,
    obstacles: &Obstacles,
    open: &[RoomId],
    most: usize,
) -> Result<Vec<Point>, GridError> {
    let mut drive = Drive::new(building, obstacles, open)?;
    let first = open.iter().find_map(|r| drive.targets.iter().find(|(_, room)| *room == r));
    let Some((&start, _)) = first else { return Ok(Vec::new()) };
    let mut way = vec![start];
    let mut round = 0;
    let mut at = start;
    while drive.rooms_on(&way) <= most {
        drive.leave_behind(at);
        round += 1;
        let Some(leg) = drive.nearest(at, round) else { break };
        leg.iter().for_each(|&cell| drive.leave_behind(cell));
        at = leg.last().copied().unwrap_or(at);
        way.extend(leg);
    }
    drive.cut(&mut way, most);
    Ok(way.into_iter().map(|cell| drive.point(cell)).collect())
}

impl Drive {
    fn new(building: &Building, obstacles: &Obstacles, open: &[RoomId]) -> Result<Self, GridError> {
        let frame = Frame::around(building.layout(), STEP)?;
        let mut drivable = vec![true; frame.len()];
        let mut room = vec![0; frame.len()];
        let mut floor = vec![false; frame.len()];
        for r in &building.layout().rooms {
            frame.fill(r.centre.rings(), |i| room[i] = r.id);
            frame.fill(r.inner.rings(), |i| floor[i] = true);
            if !open.contains(&r.id) {
                frame.fill(r.centre.rings(), |i| drivable[i] = false);
            }
        }
        for solid in building.solids() {
            frame.fill(solid.rings(), |i| floor[i] = false);
        }
        for face in obstacles.faces() {
            block(frame, face, &mut drivable);
        }
        let (parent, round) = (vec![0; frame.len()], vec![0; frame.len()]);
        let ids = building.layout().rooms.iter().map(|r| r.id);
        let corridors = ids.filter(|&id| building.kind(id) == Some(RoomKind::Corridor)).collect();
        let mut drive = Self { corridors, frame, drivable, room, targets: BTreeMap::new(), parent, round };
        drive.set_targets(&floor);
        Ok(drive)
    }

    fn rooms_on(&self, way: &[usize]) -> usize {
        way.iter().map(|&cell| self.room[cell]).collect::<BTreeSet<_>>().len()
    }

    /// Ends the way before the room after the first `most` ones.
    fn cut(&self, way: &mut Vec<usize>, most: usize) {
        let mut rooms = BTreeSet::new();
        let is_too_many = |&cell: &usize| {
            rooms.insert(self.room[cell]);
            rooms.len() > most
        };
        if let Some(end) = way.iter().position(is_too_many) {
            way.truncate(end);
        }
    }

    fn point(&self, cell: usize) -> Point {
        let width = self.frame.width as usize;
        let (column, row) = ((cell % width) as f64 + 0.5, (cell / width) as f64 + 0.5);
        Point::new(self.frame.origin.x + column * STEP, self.frame.origin.y + row * STEP)
    }

    /// In each room, the drivable cell of the floor nearest to the middle of each square of a coarse grid. The core
    /// of a thick wall keeps clear of everything too, but no robot gets there.
    fn set_targets(&mut self, floor: &[bool]) {
        let mut best: BTreeMap<(RoomId, i64, i64), (f64, usize)> = BTreeMap::new();
        for cell in (0..self.room.len()).filter(|&i| floor[i] && self.drivable[i]) {
            let p = self.point(cell);
            let (i, j) = ((p.x / SPACING).floor(), (p.y / SPACING).floor());
            let off = p.distance(Point::new((i + 0.5) * SPACING, (j + 0.5) * SPACING));
            let entry = best.entry((self.room[cell], i as i64, j as i64)).or_insert((off, cell));
            if off < entry.0 {
                *entry = (off, cell);
            }
        }
        self.targets = best.into_iter().map(|((room, _, _), (_, cell))| (cell, room)).collect();
    }

    /// Drops the targets of the same room that are near the cell.
    fn leave_behind(&mut self, cell: usize) {
        let (room, p) = (self.room[cell], self.point(cell));
        let near = |&(t, r): &(usize, RoomId)| r == room && self.point(t).distance(p) < NEAR;
        let done: Vec<usize> =
            self.targets.iter().map(|(&t, &r)| (t, r)).filter(near).map(|(t, _)| t).collect();
        for t in done {
            self.targets.remove(&t);
        }
    }

    /// The shortest way to a target, without its start; breadth first. A target in a corridor has to wait for one in
    /// a room that is not much farther: a robot looks into the rooms that it passes.
    fn nearest(&mut self, from: usize, round: u32) -> Option<Vec<usize>> {
        let mut queue = VecDeque::from([(from, 0)]);
        let mut waiting: Option<(usize, u32)> = None;
        self.round[from] = round;
        while let Some((cell, depth)) = queue.pop_front() {
            if waiting.is_some_and(|(_, found)| depth > found + PATIENCE) {
                break;
            }
            match self.targets.get(&cell) {
                Some(room) if self.corridors.contains(room) => waiting = waiting.or(Some((cell, depth))),
                Some(_) => return Some(self.way_back(from, cell)),
                None => (),
            }
            for next in self.beside(cell) {
                if self.drivable[next] && self.round[next] != round {
                    self.round[next] = round;
                    self.parent[next] = cell as u32;
                    queue.push_back((next, depth + 1));
                }
            }
        }
        waiting.map(|(cell, _)| self.way_back(from, cell))
    }

    /// The eight cells around, the four straight ones first.
    fn beside(&self, cell: usize) -> impl Iterator<Item = usize> + use<> {
        const AROUND: [(i64, i64); 8] =
            [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1)];
        let (frame, width) = (self.frame, self.frame.width as usize);
        let (column, row) = ((cell % width) as i64, (cell / width) as i64);
        AROUND.into_iter().filter_map(move |(dx, dy)| frame.index(column + dx, row + dy))
    }

    fn way_back(&self, from: usize, to: usize) -> Vec<usize> {
        let mut way = Vec::new();
        let mut at = to;
        while at != from {
            way.push(at);
            at = self.parent[at] as usize;
        }
        way.reverse();
        way
    }
}

/// Makes the cells too near to a face undrivable.
fn block(frame: Frame, face: &Face, drivable: &mut [bool]) {
    let reach = CLEARANCE / STEP;
    let ((ax, ay), (bx, by)) = (frame.to_cells(face.segment.a), frame.to_cells(face.segment.b));
    let span = |a: f64, b: f64| (a.min(b) - reach - 1.0).floor() as i64..=(a.max(b) + reach).ceil() as i64;
    for row in span(ay, by) {
        for column in span(ax, bx) {
            let middle = (column as f64 + 0.5, row as f64 + 0.5);
            if let Some(i) = frame.index(column, row)
                && distance_to((ax, ay), (bx, by), middle) < reach
            {
                drivable[i] = false;
            }
        }
    }
}

fn distance_to(a: (f64, f64), b: (f64, f64), p: (f64, f64)) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let squared = (dx * dx + dy * dy).max(1e-12);
    let t = (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / squared).clamp(0.0, 1.0);
    (p.0 - a.0 - t * dx).hypot(p.1 - a.1 - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{SimpleParams, corridor_with_rooms, simple};
    use crate::obstacles::Gaps;

    fn way(open: &[RoomId], most: usize) -> Vec<Point> {
        let building = corridor_with_rooms(4);
        let walls = Obstacles::new(&building, &Gaps { closed: &[], windows: &[] }, &[]);
        drive(&building, &walls, open, most).unwrap()
    }

    fn visits(way: &[Point], room: usize) -> bool {
        way.iter().any(|&p| corridor_with_rooms(4).layout().rooms[room].inner.contains(p))
    }

    #[test]
    fn enters_the_rooms_it_shall_and_no_other() {
        let way = way(&[1, 2, 4], 9);
        assert_eq!([0, 1, 2, 3, 4].map(|room| visits(&way, room)), [true, true, false, true, false]);
    }

    #[test]
    fn stops_early() {
        let way = way(&[1, 2, 3, 4, 5], 3);
        assert_eq!((0..5).filter(|&room| visits(&way, room)).count(), 3);
    }

    #[test]
    fn starts_on_the_floor_however_thick_the_walls() {
        let thick = SimpleParams { wall: 0.6, ..SimpleParams::default() };
        let building = simple(2, 1, &thick);
        let walls = Obstacles::new(&building, &Gaps { closed: &[], windows: &[] }, &[]);
        let way = drive(&building, &walls, &[1, 2], 9).unwrap();
        let [first, second] = [0, 1].map(|room| &building.layout().rooms[room].inner);
        assert!(first.contains(way[0]), "{:?}", way[0]);
        assert!(way.iter().any(|&p| second.contains(p)));
    }

    #[test]
    fn goes_step_by_step() {
        let way = way(&[1, 2, 3, 4, 5], 9);
        assert!(way.windows(2).all(|w| w[0].distance(w[1]) < 0.15));
        assert!(way.len() > 200);
    }
}
