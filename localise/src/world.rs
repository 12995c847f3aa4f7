//! A robot with a laser in a building that is known exactly.

use crate::{Frame, Motion, MotionNoise, Random, Sweep, turn};
use planform_sdk::{Cell, Grid, Point, Pose};
use std::collections::VecDeque;
use std::f64::consts::{PI, TAU};

/// The robot's middle keeps this far from all walls, metres.
const CLEARANCE: f64 = 0.3;

/// Metres between two sweeps.
const STEP: f64 = 0.1;

/// The most radians that the robot turns between two sweeps.
const TURN: f64 = 0.2;

/// A laser scanner.
#[derive(Debug, Clone, Copy)]
pub struct Laser {
    /// Beams of a sweep.
    pub beams: usize,
    /// Radians from the first beam to the last, about the heading.
    pub view: f64,
    /// Where echoes end, metres.
    pub max_range: f64,
    /// Standard deviation of a range, metres.
    pub noise: f64,
}

impl Default for Laser {
    fn default() -> Self {
        Self { beams: 181, view: PI, max_range: 20.0, noise: 0.02 }
    }
}

/// How a robot walks about.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    /// How far, metres.
    pub length: f64,
    /// How wrong its odometry is.
    pub noise: MotionNoise,
}

impl Default for Walk {
    fn default() -> Self {
        let noise =
            MotionNoise { turn_by_turn: 0.05, turn_by_way: 0.01, way_by_way: 0.05, way_by_turn: 0.01 };
        Self { length: 40.0, noise }
    }
}

/// A building to walk about in: the cells of its exact raster.
pub struct World {
    grid: Grid,
    /// For each cell whether the robot's middle can be there.
    open: Vec<bool>,
}

impl World {
    /// The building of this raster; what is neither free nor unknown stops beams.
    pub fn new(grid: Grid) -> Self {
        let field = crate::Field::new(grid.clone(), CLEARANCE);
        let middle = |i: usize| {
            let (column, row) = (i % grid.width() as usize, i / grid.width() as usize);
            grid.to_map(Point::new(column as f64 + 0.5, row as f64 + 0.5))
        };
        let is_open = |(i, cell): (usize, &Cell)| {
            *cell == Cell::FREE && f64::from(field.distance(middle(i))) >= CLEARANCE
        };
        let open = grid.cells().iter().enumerate().map(is_open).collect();
        Self { grid, open }
    }

    /// What a robot sees and counts that walks from place to place, all drawn from this seed. Empty where there is no
    /// place to walk.
    pub fn walk(&self, laser: &Laser, walk: &Walk, seed: u64) -> Vec<Frame> {
        let mut random = Random::new(seed);
        let poses = poses(&self.places(walk.length, &mut random));
        let mut frames: Vec<Frame> = vec![];
        let mut before: Option<Pose> = None;
        for truth in poses {
            // Odometry begins anywhere.
            let odometry = match (before, frames.last()) {
                (Some(before), Some(last)) => {
                    Motion::between(before, truth).sample(&walk.noise, &mut random).lead(last.odometry)
                }
                _ => Pose { x: 3.0, y: -2.0, yaw: 1.0 },
            };
            frames.push(Frame { odometry, truth, sweep: self.sweep(truth, laser, &mut random) });
            before = Some(truth);
        }
        frames
    }

    /// Points about a step apart on a way through the building, of about this length.
    fn places(&self, length: f64, random: &mut Random) -> Vec<Point> {
        let open: Vec<usize> = (0..self.open.len()).filter(|&i| self.open[i]).collect();
        let Some(mut at) = open.get(random.below(open.len())).copied() else { return vec![] };
        let (mut way, wanted) = (vec![at], (length / self.grid.resolution()) as usize);
        // A place that cannot be reached is given up, but not for ever.
        for _ in 0..100 {
            let to = open[random.below(open.len())];
            way.extend(self.route(at, to));
            at = way.last().copied().unwrap_or(at);
            if way.len() >= wanted {
                break;
            }
        }
        way.truncate(wanted.max(1));
        let every = (STEP / self.grid.resolution()).round().max(1.0) as usize;
        smooth(&way.into_iter().step_by(every).map(|cell| self.middle(cell)).collect::<Vec<_>>())
    }

    fn middle(&self, cell: usize) -> Point {
        let width = self.grid.width() as usize;
        self.grid.to_map(Point::new((cell % width) as f64 + 0.5, (cell / width) as f64 + 0.5))
    }

    /// The cells of a shortest way without the first; empty if there is none.
    fn route(&self, from: usize, to: usize) -> Vec<usize> {
        let width = self.grid.width() as usize;
        let mut came = vec![usize::MAX; self.open.len()];
        let mut queue = VecDeque::from([to]);
        came[to] = to;
        while let Some(cell) = queue.pop_front().filter(|&cell| cell != from) {
            for next in [cell.wrapping_sub(1), cell + 1, cell.wrapping_sub(width), cell + width] {
                if self.open.get(next) == Some(&true) && came[next] == usize::MAX {
                    came[next] = cell;
                    queue.push_back(next);
                }
            }
        }
        let mut route = vec![];
        let mut at = from;
        while came[at] != usize::MAX && at != to {
            at = came[at];
            route.push(at);
        }
        route
    }

    fn sweep(&self, pose: Pose, laser: &Laser, random: &mut Random) -> Sweep {
        let step = laser.view / (laser.beams.max(2) - 1) as f64;
        let first_angle = -laser.view / 2.0;
        let range = |i: usize| {
            let angle = pose.yaw + first_angle + i as f64 * step;
            let echo = self.cast(Point::new(pose.x, pose.y), angle, laser.max_range);
            echo.map_or(laser.max_range, |far| (far + random.normal(laser.noise)).max(0.01)) as f32
        };
        Sweep { ranges: (0..laser.beams).map(range).collect(), first_angle, step, max_range: laser.max_range }
    }

    /// How far a beam goes, metres; `None` if nothing stops it. Cell by cell, after Amanatides and Woo, "A fast voxel
    /// traversal algorithm for ray tracing" (1987).
    fn cast(&self, from: Point, angle: f64, most: f64) -> Option<f64> {
        let start = self.grid.to_cells(from);
        let (sin, cos) = (angle - self.grid.origin().yaw).sin_cos();
        let most = most / self.grid.resolution();
        let axis = |at: f64, along: f64| {
            let next = if along > 0.0 { at.floor() + 1.0 - at } else { at - at.floor() };
            (next / along.abs(), 1.0 / along.abs())
        };
        let ((mut next_x, each_x), (mut next_y, each_y)) = (axis(start.x, cos), axis(start.y, sin));
        let (mut column, mut row, mut far) = (start.x.floor() as i64, start.y.floor() as i64, 0.0);
        while far < most {
            if self.grid.cell(column, row).occupancy().is_some_and(|percent| percent > 50) {
                return Some(far * self.grid.resolution());
            }
            if next_x < next_y {
                far = next_x;
                next_x += each_x;
                column += if cos > 0.0 { 1 } else { -1 };
            } else {
                far = next_y;
                next_y += each_y;
                row += if sin > 0.0 { 1 } else { -1 };
            }
        }
        None
    }
}

/// Points moved to the mean of their neighbourhood: a way from cell to cell has corners that no robot drives.
fn smooth(way: &[Point]) -> Vec<Point> {
    let mean = |i: usize| {
        let near = &way[i.saturating_sub(2)..(i + 3).min(way.len())];
        let sum = near.iter().fold(Point::default(), |s, p| Point::new(s.x + p.x, s.y + p.y));
        Point::new(sum.x / near.len() as f64, sum.y / near.len() as f64)
    };
    (0..way.len()).map(mean).collect()
}

/// The poses of a robot that looks where it goes, with turns on the spot in between where it turns fast.
fn poses(way: &[Point]) -> Vec<Pose> {
    let mut poses: Vec<Pose> = vec![];
    for pair in way.windows(2) {
        let yaw = (pair[1].y - pair[0].y).atan2(pair[1].x - pair[0].x);
        let before = poses.last().map_or(yaw, |p| p.yaw);
        let turned = turn(before, yaw);
        let turns = (turned.abs() / TURN).ceil().clamp(1.0, TAU / TURN) as u32;
        let at = |i: u32| Pose {
            x: pair[0].x,
            y: pair[0].y,
            yaw: before + turned * f64::from(i) / f64::from(turns),
        };
        poses.extend((1..=turns).map(at));
    }
    poses
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hall of 10 m by 6 m with walls around it.
    fn hall() -> World {
        let wall = |x: usize, y: usize| !(2..102).contains(&x) || !(2..62).contains(&y);
        let cell = |i: usize| if wall(i % 104, i / 104) { Cell::OCCUPIED } else { Cell::FREE };
        let origin = Pose { x: 1.0, y: -1.0, yaw: 0.5 };
        World::new(Grid::new(104, 64, 0.1, origin, (0..104 * 64).map(cell).collect()).unwrap())
    }

    #[test]
    fn beams_end_at_walls() {
        let world = hall();
        let at = world.grid.to_map(Point::new(32.0, 32.0));
        for (angle, far) in [(0.0, 7.0), (PI, 3.0), (PI / 2.0, 3.0), (PI / 4.0, 18.0_f64.sqrt())] {
            let found = world.cast(at, 0.5 + angle, 20.0).unwrap();
            assert!((found - far).abs() < 0.15, "{angle}: {found} for {far}");
        }
        assert_eq!(world.cast(at, 0.5, 5.0), None);
    }

    #[test]
    fn a_walk_stays_on_the_floor_and_is_repeated() {
        let (world, walk) = (hall(), Walk { length: 20.0, ..Walk::default() });
        let frames = world.walk(&Laser::default(), &walk, 3);
        assert!(frames.len() > 150, "{}", frames.len());
        let cell = |p: Pose| world.grid.to_cells(Point::new(p.x, p.y));
        assert!(frames.iter().map(|f| cell(f.truth)).all(|c| (2.0..102.0).contains(&c.x) && c.y > 2.0));
        let again = world.walk(&Laser::default(), &walk, 3);
        assert!(frames.iter().zip(&again).all(|(a, b)| a.truth == b.truth && a.odometry == b.odometry));
    }
}
