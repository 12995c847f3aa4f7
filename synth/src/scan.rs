//! The map that a robot with a laser makes of a building.

use crate::building::Building;
use crate::drift::{Drift, Growth};
use crate::drive;
use crate::furniture;
use crate::obstacles::{Gaps, Obstacles, Walk};
use crate::raster::Frame;
use crate::rng::Rng;
use crate::scan_params::{Laser, Noise, Output, ScanParams, within};
use planform_sdk::{Cell, Grid, GridError, Layout, Point, Polygon, Pose, RoomId, RoomState, Segment};
use std::f64::consts::TAU;

/// Share of a cell's rays that must have ended in it for the cell to be occupied; gmapping's default.
const OCCUPIED_SHARE: f64 = 0.25;
/// Probability that a ray passes through a pane.
const PANE_PASS: f64 = 0.45;
/// A room seen to this share counts as complete, below the other as unseen.
const COMPLETE: f64 = 0.9;
const UNSEEN: f64 = 0.05;

/// What the robot brought home.
#[derive(Debug, Clone, PartialEq)]
pub struct Scan {
    /// Its map, in the same frame as [`Building::clean_grid`].
    pub grid: Grid,
    /// The poses from which it looked around, without SLAM's error.
    pub path: Vec<Pose>,
    /// What it knows of each room, by rising id.
    pub rooms: Vec<RoomView>,
    /// What stood in the way: outlines of cupboards and of the legs of tables and chairs.
    pub furniture: Vec<Polygon>,
}

/// What a robot knows of a room.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoomView {
    /// The room.
    pub room: RoomId,
    /// Whether the robot looked around inside.
    pub entered: bool,
    /// Share of its floor that is known in the grid, 0 to 1.
    pub seen: f64,
}

impl RoomView {
    /// Complete, partial, or `None` when next to nothing of the room was seen.
    pub fn state(&self) -> Option<RoomState> {
        match self.seen {
            s if s >= COMPLETE => Some(RoomState::Complete),
            s if s >= UNSEEN => Some(RoomState::Partial),
            _ => None,
        }
    }
}

impl Scan {
    /// Share of the rooms that the robot entered, 0 to 1.
    pub fn visited_share(&self) -> f64 {
        let entered = self.rooms.iter().filter(|r| r.entered).count();
        entered as f64 / self.rooms.len().max(1) as f64
    }

    /// The part of the true layout that the robot saw: rooms with their state, and the openings and walls of these.
    pub fn seen_layout(&self, truth: &Layout) -> Layout {
        let state = |id: RoomId| self.rooms.iter().find(|v| v.room == id).and_then(RoomView::state);
        let mut layout = truth.clone();
        layout.rooms.retain_mut(|room| match state(room.id) {
            Some(seen) => {
                room.state = seen;
                true
            }
            None => false,
        });
        for wall in &mut layout.walls {
            wall.rooms = wall.rooms.map(|room| room.filter(|&id| state(id).is_some()));
        }
        layout.walls.retain(|w| w.rooms.iter().any(Option::is_some));
        layout.openings.retain(|o| o.rooms.iter().all(|&id| state(id).is_some()));
        layout
    }
}

impl Building {
    /// Drives a robot through the building and returns its map. The same building and parameters give the same map.
    /// Values beyond what makes sense are brought back to it: a share to 0..=1, the laser to at most 3600 rays, 100 m
    /// and a look every 0.1 m, a standard deviation to at most 1.
    ///
    /// # Errors
    /// When the resolution is not a positive number or makes more than [`planform_sdk::MAX_CELLS`] cells.
    ///
    /// ```
    /// # use planform_synth::{two_rooms, ScanParams};
    /// let scan = two_rooms().scan(&ScanParams::default())?;
    /// assert_eq!(scan.visited_share(), 1.0);
    /// # Ok::<(), planform_sdk::GridError>(())
    /// ```
    pub fn scan(&self, params: &ScanParams) -> Result<Scan, GridError> {
        let frame = Frame::around(self.layout(), params.resolution)?;
        let mut rng = Rng::new(params.seed, 100);
        let furniture = furniture::furnish(self, params.furniture, params.clutter, params.seed);
        let left_out = count_left_out(self.layout(), params.unexplored);
        let behind_doors = (left_out as f64 * params.closed_doors.clamp(0.0, 1.0)).round() as usize;
        let open = choose_open(self.layout(), behind_doors, &mut rng);
        let closed = doors_of_the_rest(self.layout(), &open);
        let windows = choose_windows(self.layout(), params.glass, &mut rng);
        let gaps = Gaps { closed: &closed, windows: &windows };
        let obstacles = Obstacles::new(self, &gaps, &furniture);
        let way = drive::drive(self, &obstacles, &open, self.layout().rooms.len() - left_out)?;
        let path = poses(&way, &params.laser);
        let mut map = Map { frame, counts: vec![[0; 2]; frame.len()] };
        look_around(&mut map, &obstacles, &path, params, &mut rng);
        let rooms = self.layout().rooms.iter().map(|r| RoomView {
            room: r.id,
            entered: path.iter().any(|p| r.inner.contains(Point::new(p.x, p.y))),
            seen: map.known_share(&r.inner),
        });
        let rooms = rooms.collect();
        Ok(Scan { grid: map.grid(params.output)?, path, rooms, furniture })
    }
}

/// How many rooms the robot does not enter; it is always in one.
fn count_left_out(layout: &Layout, unexplored: f64) -> usize {
    let rooms = layout.rooms.len();
    let count = (rooms as f64 * unexplored.clamp(0.0, 1.0)).round() as usize;
    count.min(rooms.saturating_sub(1))
}

/// All rooms but `closed` of them; the first one stays, and no other is cut off.
fn choose_open(layout: &Layout, closed: usize, rng: &mut Rng) -> Vec<RoomId> {
    let mut open: Vec<RoomId> = layout.rooms.iter().map(|r| r.id).collect();
    let keep = open.len().saturating_sub(closed).max(1);
    let mut order: Vec<RoomId> = open.iter().skip(1).copied().collect();
    rng.shuffle(&mut order);
    while open.len() > keep {
        let rest = |out: RoomId| open.iter().copied().filter(|&r| r != out).collect::<Vec<_>>();
        let Some(at) = order.iter().position(|&out| is_connected(layout, &rest(out))) else { break };
        open = rest(order.remove(at));
    }
    open
}

fn is_connected(layout: &Layout, rooms: &[RoomId]) -> bool {
    let mut reached: Vec<RoomId> = rooms.first().copied().into_iter().collect();
    let mut next = 0;
    while let Some(&room) = reached.get(next) {
        next += 1;
        for [a, b] in layout.openings.iter().map(|o| o.rooms).filter(|r| r.contains(&room)) {
            let other = if a == room { b } else { a };
            if rooms.contains(&other) && !reached.contains(&other) {
                reached.push(other);
            }
        }
    }
    reached.len() == rooms.len()
}

/// The indices of all openings of the rooms that are not open.
fn doors_of_the_rest(layout: &Layout, open: &[RoomId]) -> Vec<usize> {
    let is_closed = |i: &usize| layout.openings[*i].rooms.iter().any(|r| !open.contains(r));
    (0..layout.openings.len()).filter(is_closed).collect()
}

/// A row of windows in the middle of some of the outer walls, with the wall's thickness. Between any two is a pier,
/// which keeps the wall legible.
fn choose_windows(layout: &Layout, share: f64, rng: &mut Rng) -> Vec<(Segment, f64)> {
    let outer = layout.walls.iter().filter(|w| w.rooms.contains(&None) && w.line.length() > 2.0);
    let mut windows = Vec::new();
    for wall in outer {
        if rng.chance(share) {
            let (rim, pier) = (rng.range((0.4, 0.8)), rng.range((0.15, 0.5)));
            let row = wall.line.length() - 2.0 * rim;
            let count = (row / rng.range((1.0, 1.8))).floor().max(1.0);
            let pitch = row / count;
            windows.extend((0..count as u32).map(|i| {
                let from = rim + f64::from(i) * pitch + pier / 2.0;
                (part(&wall.line, from, from + pitch - pier), wall.thickness)
            }));
        }
    }
    windows
}

/// The part of a segment between two distances from its start, metres.
fn part(line: &Segment, from: f64, to: f64) -> Segment {
    let (a, b, length) = (line.a, line.b, line.length());
    let at = |d: f64| Point::new(a.x + (b.x - a.x) * d / length, a.y + (b.y - a.y) * d / length);
    Segment::new(at(from), at(to))
}

/// The poses on the way from which the laser is read.
fn poses(way: &[Point], laser: &Laser) -> Vec<Pose> {
    let every = (within(laser.stride, 0.05, 100.0) / drive::STEP).round().max(1.0) as usize;
    let heading = |i: usize| {
        let (a, b) = (way[i.saturating_sub(1)], way[(i + 4).min(way.len() - 1)]);
        if a == b { 0.0 } else { (b.y - a.y).atan2(b.x - a.x) }
    };
    (0..way.len()).step_by(every).map(|i| Pose { x: way[i].x, y: way[i].y, yaw: heading(i) }).collect()
}

fn look_around(map: &mut Map, obstacles: &Obstacles, path: &[Pose], params: &ScanParams, rng: &mut Rng) {
    let mut drift = Drift::default();
    let mut growth = Growth::new(params.seed);
    let mut last = path.first().copied().unwrap_or_default();
    for &pose in path {
        let step = (pose.x - last.x, pose.y - last.y);
        drift.wander(&params.noise, step.0.hypot(step.1), rng);
        growth.follow(&params.noise, step);
        last = pose;
        read_laser(map, obstacles, pose, drift.moved(growth.moved(pose)), params, rng);
    }
}

fn read_laser(
    map: &mut Map,
    obstacles: &Obstacles,
    pose: Pose,
    believed: Pose,
    params: &ScanParams,
    rng: &mut Rng,
) {
    let (rays, view) = (params.laser.rays.clamp(1, 3600), within(params.laser.view, 0.0, TAU));
    let reach = within(params.laser.max_range, 0.1, 100.0);
    let from = Point::new(pose.x, pose.y);
    for i in 0..rays {
        let bearing = view * ((f64::from(i) + 0.5) / f64::from(rays) - 0.5);
        let unit = |yaw: f64| ((yaw + bearing).cos(), (yaw + bearing).sin());
        let distance = obstacles.cast(from, unit(pose.yaw), reach, || rng.chance(PANE_PASS));
        let (range, ends) = match distance {
            Some(d) => (measured(d, reach, &params.noise, rng), true),
            None => (reach, false),
        };
        map.add_ray((believed.x, believed.y), unit(believed.yaw), range, ends);
    }
}

/// A range with its noise; a few are far off, both ways.
fn measured(distance: f64, reach: f64, noise: &Noise, rng: &mut Rng) -> f64 {
    let range = if rng.chance(noise.outliers) {
        if rng.chance(0.9) { rng.range((0.1, distance)) } else { distance + rng.range((0.0, 1.2)) }
    } else {
        distance + within(noise.range, 0.0, 1.0) * rng.gauss()
    };
    range.clamp(0.01, reach)
}

/// For each cell, how many rays ended in it and how many passed.
struct Map {
    frame: Frame,
    counts: Vec<[u16; 2]>,
}

impl Map {
    fn add_ray(&mut self, (x, y): (f64, f64), unit: (f64, f64), range: f64, ends: bool) {
        let frame = self.frame;
        let length = range / frame.resolution;
        let start = frame.to_cells(Point::new(x, y));
        let end = ((start.0 + unit.0 * length).floor() as i64, (start.1 + unit.1 * length).floor() as i64);
        let mut walk = Walk::new(start, unit);
        for _ in 0..(end.0 - walk.cell.0).abs() + (end.1 - walk.cell.1).abs() {
            self.count(walk.cell, 1);
            walk.next();
        }
        if ends {
            self.count(end, 0);
        }
    }

    fn count(&mut self, (column, row): (i64, i64), what: usize) {
        if let Some(i) = self.frame.index(column, row) {
            let count = &mut self.counts[i][what];
            *count = count.saturating_add(1);
        }
    }

    fn known_share(&self, floor: &Polygon) -> f64 {
        let (mut known, mut all) = (0u32, 0u32);
        self.frame.fill(floor.rings(), |i| {
            all += 1;
            known += u32::from(self.counts[i] != [0; 2]);
        });
        f64::from(known) / f64::from(all.max(1))
    }

    fn grid(self, output: Output) -> Result<Grid, GridError> {
        let cell = |&[hits, passes]: &[u16; 2]| {
            let rays = f64::from(hits) + f64::from(passes);
            let share = f64::from(hits) / rays;
            match output {
                _ if rays == 0.0 => Cell::UNKNOWN,
                Output::Probabilities => Cell::percent((share * 100.0).round() as u8),
                Output::Thresholded if share >= OCCUPIED_SHARE => Cell::OCCUPIED,
                Output::Thresholded => Cell::FREE,
            }
        };
        let cells = self.counts.iter().map(cell).collect();
        self.frame.grid(cells)
    }
}
