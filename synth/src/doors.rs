//! Where the doors are: every room is reached, and some only through another.

use crate::params::{BuildingParams, RoomKind};
use crate::partition::{Partition, Run, is_straight};
use crate::rng::Rng;
use crate::shape::Shape;
use planform_sdk::{OpeningKind, Point};

/// An opening in a run of wall.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Door {
    /// Index into the partition's runs.
    pub(crate) run: usize,
    /// From the run's first corner to the first jamb, metres.
    pub(crate) from: f64,
    /// Clear width, metres.
    pub(crate) width: f64,
    pub(crate) kind: OpeningKind,
    /// Whether it is as wide as the walls beside it let it be, whatever `from` and `width` say.
    pub(crate) whole: bool,
}

/// Least wall between two doors, metres.
const PIER: f64 = 0.4;

struct Planner<'a> {
    partition: &'a Partition,
    shapes: &'a [Shape],
    params: &'a BuildingParams,
    rng: &'a mut Rng,
    doors: Vec<Door>,
}

/// The doors of a plan, and the rooms that no door can reach.
pub(crate) fn plan(
    partition: &Partition,
    shapes: &[Shape],
    params: &BuildingParams,
    rng: &mut Rng,
) -> (Vec<Door>, Vec<usize>) {
    let mut planner = Planner { partition, shapes, params, rng, doors: Vec::new() };
    planner.wished();
    planner.between_corridors();
    planner.reach_the_rest();
    planner.extra();
    let reached = planner.reached();
    let lost = (0..shapes.len()).filter(|&i| !reached[i]).collect();
    (planner.doors, lost)
}

/// Gives the whole openings their width, now that the walls have their thickness.
pub(crate) fn fit(doors: &mut [Door], partition: &Partition, thickness: &[f64]) {
    for door in doors.iter_mut().filter(|d| d.whole) {
        let run = &partition.runs[door.run];
        let beside = |corner: usize| {
            let others = partition.runs.iter().zip(thickness).enumerate();
            let meets = others.filter(|(i, (r, _))| *i != door.run && r.corners.contains(&corner));
            let across = meets.filter(|(_, (r, _))| !is_parallel(partition, run, r));
            across.map(|(_, (_, &t))| t / 2.0).fold(0.0, f64::max)
        };
        let [a, b] = run.ends().map(beside);
        (door.from, door.width) = (a, partition.length(run) - a - b);
    }
}

fn is_parallel(partition: &Partition, a: &Run, b: &Run) -> bool {
    let direction = |r: &Run| {
        let [from, to] = r.ends().map(|i| partition.points[i]);
        let length = from.distance(to);
        ((to.x - from.x) / length, (to.y - from.y) / length)
    };
    let ((ax, ay), (bx, by)) = (direction(a), direction(b));
    (ax * by - ay * bx).abs() < 0.1
}

fn turns_at(points: &[Point], ring: &[usize], corner: usize) -> bool {
    let n = ring.len();
    let here = ring.iter().position(|&c| c == corner);
    here.is_some_and(|i| {
        let [a, b, c] = [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]].map(|p| points[p]);
        !is_straight(a, b, c)
    })
}

impl Planner<'_> {
    fn kind(&self, room: usize) -> RoomKind {
        self.shapes[room].kind
    }

    /// Clear wall from a run's corner to a door, metres: crossing walls are this thick at most.
    fn margin(&self) -> f64 {
        self.params.outer_wall.1.max(self.params.inner_wall.1) / 2.0 + 0.12
    }

    /// The longest run between two rooms.
    fn longest(&self, a: usize, b: usize) -> Option<usize> {
        let between = |r: &Run| r.left == a.min(b) && r.right == Some(a.max(b));
        let runs = self.partition.runs.iter().enumerate().filter(|(_, r)| between(r));
        runs.map(|(i, r)| (i, self.partition.length(r))).max_by(|x, y| x.1.total_cmp(&y.1)).map(|(i, _)| i)
    }

    /// The neighbours of a room, the one with the longest common wall first.
    fn neighbours(&self, room: usize) -> Vec<usize> {
        let mut found: Vec<(f64, usize)> = Vec::new();
        for run in &self.partition.runs {
            let Some(right) = run.right else { continue };
            let other = if run.left == room { right } else { run.left };
            if run.left == room || right == room {
                found.push((self.partition.length(run), other));
            }
        }
        found.sort_by(|x, y| y.0.total_cmp(&x.0).then(x.1.cmp(&y.1)));
        found.into_iter().map(|(_, room)| room).collect()
    }

    /// The width that a door between rooms of these kinds has.
    fn width(&mut self, a: usize, b: usize) -> (f64, OpeningKind) {
        use RoomKind::{Corridor, Hall, Small};
        let kinds = [self.kind(a), self.kind(b)];
        let double = if kinds.contains(&Hall) { 0.8 } else { 0.1 };
        let passage = if kinds == [Corridor; 2] { 0.5 } else { 0.07 };
        let is_small = kinds.contains(&Small);
        if !is_small && self.rng.chance(passage) {
            (self.rng.range(self.params.passage), OpeningKind::Passage)
        } else if !is_small && (kinds == [Corridor; 2] || self.rng.chance(double)) {
            (self.rng.range(self.params.double_door), OpeningKind::Door)
        } else {
            (self.rng.range(self.params.single_door), OpeningKind::Door)
        }
    }

    /// Puts an opening into the longest wall between two rooms; false when there is no place.
    fn join(&mut self, a: usize, b: usize) -> bool {
        let Some(run) = self.longest(a, b) else { return false };
        if self.is_cap(run) && self.rng.wants(self.params.variety.open_ends) {
            let width = self.partition.length(&self.partition.runs[run]);
            self.doors.push(Door { run, from: 0.0, width, kind: OpeningKind::Passage, whole: true });
            return true;
        }
        let small = [a, b].iter().any(|&r| self.kind(r) == RoomKind::Small);
        if !small && self.rng.wants(self.params.variety.open_fronts) && self.open_front(run) {
            return true;
        }
        let (width, kind) = self.width(a, b);
        let narrow = self.params.single_door.0;
        self.place(run, width, kind) || self.place(run, narrow, OpeningKind::Door)
    }

    /// Whether the run is all of a corridor's end, and the room beyond it is not a small one.
    fn is_cap(&self, run: usize) -> bool {
        let run = &self.partition.runs[run];
        let Some(right) = run.right else { return false };
        let (corridor, other) =
            if self.kind(run.left) == RoomKind::Corridor { (run.left, right) } else { (right, run.left) };
        let fits = (1.6..4.5).contains(&self.partition.length(run));
        let kinds = [self.kind(corridor), self.kind(other)];
        let rings = &self.partition.rooms[corridor];
        let turns = |corner: usize| rings.iter().any(|r| turns_at(&self.partition.points, r, corner));
        fits && matches!(kinds, [RoomKind::Corridor, RoomKind::Room | RoomKind::Hall])
            && run.ends().into_iter().all(turns)
    }

    /// Puts a passage into a run that leaves little of it, at times with more beside it.
    fn open_front(&mut self, run: usize) -> bool {
        let most = (self.partition.length(&self.partition.runs[run]) - 2.0 * self.margin()).min(7.0);
        let width = most * self.rng.range((0.4, 0.95));
        let placed = width > 1.0 && self.place(run, width, OpeningKind::Passage);
        if placed && self.rng.chance(0.4) {
            for _ in 0..3 {
                let width = self.rng.range((1.0, 2.5));
                self.place(run, width, OpeningKind::Passage);
            }
        }
        placed
    }

    fn place(&mut self, run: usize, width: f64, kind: OpeningKind) -> bool {
        let margin = self.margin();
        let free = self.partition.length(&self.partition.runs[run]) - 2.0 * margin - width;
        if free < 0.0 {
            return false;
        }
        let near = self.rng.range((0.0, free.min(0.4)));
        let from = margin
            + match self.rng.index(4) {
                0 => near,
                1 => free - near,
                _ => self.rng.range((0.0, free)),
            };
        let clear = |d: &Door| d.run != run || from + width + PIER < d.from || d.from + d.width + PIER < from;
        let placed = self.doors.iter().all(clear);
        if placed {
            self.doors.push(Door { run, from, width, kind, whole: false });
        }
        placed
    }

    /// Doors that the plan asks for: through another room, or else from a corridor.
    fn wished(&mut self) {
        for room in 0..self.shapes.len() {
            if self.kind(room) == RoomKind::Corridor {
                continue;
            }
            if let Some(through) = self.shapes[room].access {
                self.join(room, through);
                continue;
            }
            let ways = self.neighbours(room).into_iter().filter(|&n| self.kind(n) == RoomKind::Corridor);
            for way in ways.collect::<Vec<_>>() {
                if self.join(room, way) {
                    break;
                }
            }
        }
    }

    fn between_corridors(&mut self) {
        for room in 0..self.shapes.len() {
            for other in self.neighbours(room) {
                let both = self.kind(room) == RoomKind::Corridor && self.kind(other) == RoomKind::Corridor;
                if both && room < other && !self.is_joined(room, other) {
                    self.join(room, other);
                }
            }
        }
    }

    fn is_joined(&self, a: usize, b: usize) -> bool {
        self.doors.iter().any(|d| {
            let run = &self.partition.runs[d.run];
            run.left == a.min(b) && run.right == Some(a.max(b))
        })
    }

    /// The rooms that can be reached from the first one.
    fn reached(&self) -> Vec<bool> {
        let mut reached = vec![false; self.shapes.len()];
        let mut queue = vec![0];
        while let Some(room) = queue.pop() {
            if std::mem::replace(&mut reached[room], true) {
                continue;
            }
            for door in &self.doors {
                let run = &self.partition.runs[door.run];
                let Some(right) = run.right.filter(|&r| r == room || run.left == room) else { continue };
                queue.push(if run.left == room { right } else { run.left });
            }
        }
        reached
    }

    /// Joins unreached rooms to reached neighbours until no more can be done.
    fn reach_the_rest(&mut self) {
        loop {
            let reached = self.reached();
            let lost: Vec<usize> = (0..reached.len()).filter(|&i| !reached[i]).collect();
            let joined = lost.into_iter().any(|room| {
                let ways = self.neighbours(room).into_iter().filter(|&n| reached[n]);
                ways.collect::<Vec<_>>().into_iter().any(|way| self.join(room, way))
            });
            if !joined {
                return;
            }
        }
    }

    /// A few doors more: between neighbours, and second ones into large rooms.
    fn extra(&mut self) {
        for i in 0..self.partition.runs.len() {
            let run = &self.partition.runs[i];
            let (left, Some(right)) = (run.left, run.right) else { continue };
            let kinds = [self.kind(left), self.kind(right)];
            let en_suite = [left, right].iter().any(|&r| self.shapes[r].access.is_some());
            let chance = if en_suite || kinds.contains(&RoomKind::Small) {
                0.0
            } else if kinds.contains(&RoomKind::Hall) {
                0.4
            } else if kinds.contains(&RoomKind::Corridor) {
                if self.partition.length(run) > 7.5 { 0.3 } else { 0.0 }
            } else {
                0.07
            };
            if self.rng.chance(chance) {
                let (width, kind) = self.width(left, right);
                self.place(i, width, kind);
            }
        }
    }
}
