//! What some scans saw, drawn so that other scans can be laid over it.

use super::sweep::{Sweep, Vector};
use crate::log::Pose;

/// How far around a point a cell knows of it, metres.
pub const REACH: f64 = 0.3;

/// The largest half side of a submap, metres: what lies farther from its middle is left out.
const HALF_SIDE: f64 = 60.0;

/// How many times the sides of cells are doubled for the search.
const LEVELS: u32 = 4;

/// The points of some scans in one frame, the nearest of them and the likelihood of an echo for each cell, and ever
/// coarser grids of the greatest likelihood (Olson, "Real-time correlative scan matching", ICRA 2009).
pub struct Submap {
    /// Metres for each cell.
    pub resolution: f64,
    points: Vec<Vector>,
    normals: Vec<Option<Vector>>,
    corner: Vector,
    /// One more than the index of the nearest point, 0 for none within reach.
    nearest: Layer<u32>,
    levels: Vec<Layer<u8>>,
}

/// A grid without a place.
struct Layer<T> {
    width: usize,
    height: usize,
    cells: Vec<T>,
}

impl<T: Copy + Default> Layer<T> {
    fn new(width: usize, height: usize) -> Self {
        Self { width, height, cells: vec![T::default(); width * height] }
    }

    fn index(&self, x: i32, y: i32) -> Option<usize> {
        let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
        (x < self.width && y < self.height).then(|| y * self.width + x)
    }

    fn get(&self, x: i32, y: i32) -> T {
        self.index(x, y).and_then(|i| self.cells.get(i)).copied().unwrap_or_default()
    }
}

impl Submap {
    /// The scans as seen from their poses; `spread` is the standard deviation of an echo's place, metres.
    pub fn of<'a>(
        scans: impl Iterator<Item = (&'a Sweep, Pose)>,
        middle: Pose,
        resolution: f64,
        spread: f64,
    ) -> Self {
        let (mut points, mut normals) = (vec![], vec![]);
        for (sweep, pose) in scans {
            let turn = Turn::of(pose);
            for (point, normal) in sweep.points.iter().zip(&sweep.normals) {
                let point = turn.place(*point);
                if (point[0] - middle.x).abs().max((point[1] - middle.y).abs()) < HALF_SIDE {
                    points.push(point);
                    normals.push(normal.map(|n| turn.direct(n)));
                }
            }
        }
        let (corner, width, height) = extent(&points, middle, resolution);
        let nearest = Layer::new(width, height);
        let mut submap = Self { resolution, points, normals, corner, nearest, levels: vec![] };
        submap.levels = coarser(submap.draw(spread));
        submap
    }

    /// Notes every point in the cells around it, but one for each cell, as walls seen by many scans have many; the
    /// result is the likelihoods, 255 being the greatest.
    fn draw(&mut self, spread: f64) -> Layer<u8> {
        let (width, height) = (self.nearest.width, self.nearest.height);
        let disc = disc(self.resolution, spread);
        let mut taken = Layer::<bool>::new(width, height);
        let mut likelihoods = Layer::<u8>::new(width, height);
        for (i, point) in self.points.iter().enumerate().rev() {
            let [x, y] = self.cell(*point);
            let Some(own) = taken.index(x, y).filter(|own| !taken.cells[*own]) else { continue };
            taken.cells[own] = true;
            for (dx, dy, likelihood) in &disc {
                let Some(cell) = taken.index(x + dx, y + dy) else { continue };
                if *likelihood > likelihoods.cells[cell] {
                    likelihoods.cells[cell] = *likelihood;
                    self.nearest.cells[cell] = i as u32 + 1;
                }
            }
        }
        likelihoods
    }

    /// The column and row of a place, which may lie outside.
    pub fn cell(&self, place: Vector) -> [i32; 2] {
        cell_of(place, self.corner, self.resolution)
    }

    /// The most coarse level.
    pub fn top(&self) -> u32 {
        LEVELS
    }

    /// At level 0 the cell's likelihood, from 0 to 255; at the level n the greatest one of the cells from here to
    /// 2^n - 1 columns and rows farther on, or somewhat more.
    pub fn likelihood(&self, level: u32, x: i32, y: i32) -> u8 {
        self.levels.get(level as usize).map_or(0, |layer| layer.get(x >> level, y >> level))
    }

    /// The point nearest to this place, of those within reach, and its normal.
    pub fn nearest(&self, place: Vector) -> Option<(Vector, Option<Vector>)> {
        let [x, y] = self.cell(place);
        let i = self.nearest.get(x, y).checked_sub(1)? as usize;
        Some((*self.points.get(i)?, *self.normals.get(i)?))
    }
}

/// A pose with its sine and cosine at hand.
#[derive(Clone, Copy)]
pub struct Turn {
    pose: Pose,
    sin: f64,
    cos: f64,
}

impl Turn {
    /// Of this pose.
    pub fn of(pose: Pose) -> Self {
        let (sin, cos) = pose.theta.sin_cos();
        Self { pose, sin, cos }
    }

    /// A direction as seen from the pose, in the frame of the pose.
    pub fn direct(self, v: Vector) -> Vector {
        [self.cos * v[0] - self.sin * v[1], self.sin * v[0] + self.cos * v[1]]
    }

    /// A place as seen from the pose, in the frame of the pose.
    pub fn place(self, v: Vector) -> Vector {
        let [x, y] = self.direct(v);
        [x + self.pose.x, y + self.pose.y]
    }
}

fn cell_of(place: Vector, corner: Vector, resolution: f64) -> [i32; 2] {
    // A float that does not fit becomes the nearest number that does.
    [0, 1].map(|axis| ((place[axis] - corner[axis]) / resolution).floor() as i32)
}

/// The cells within reach of a point's and the likelihood of an echo there, at least 1.
fn disc(resolution: f64, spread: f64) -> Vec<(i32, i32, u8)> {
    let reach = (REACH / resolution).ceil() as i32;
    let around = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)));
    let distance = |dx: i32, dy: i32| f64::from(dx).hypot(f64::from(dy)) * resolution / spread;
    let likelihood = |dx, dy| (255.0 * (-0.5 * distance(dx, dy).powi(2)).exp()).round().max(1.0) as u8;
    around
        .filter(|(dx, dy)| distance(*dx, *dy) * spread <= REACH)
        .map(|(dx, dy)| (dx, dy, likelihood(dx, dy)))
        .collect()
}

/// The lower left corner, columns and rows that hold all points and what is within reach of them; on the lower sides
/// with room for a block of the coarsest level, that those beyond may count as empty.
fn extent(points: &[Vector], middle: Pose, resolution: f64) -> (Vector, usize, usize) {
    let start = [[middle.x, middle.y], [middle.x, middle.y]];
    let [low, high] = points.iter().fold(start, |[low, high], p| {
        [[low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]]
    });
    let cells = |axis: usize| {
        ((high[axis] - low[axis] + 2.0 * REACH) / resolution).ceil() as usize + 1 + (1 << LEVELS)
    };
    let margin = REACH + resolution * f64::from(1 << LEVELS);
    ([low[0] - margin, low[1] - margin], cells(0), cells(1))
}

/// The grid and its coarser ones. The block of level n at (x, y) bounds what lies up to 2^n - 1 cells farther on from
/// anywhere in it, hence what is in three blocks of the level below each way.
fn coarser(finest: Layer<u8>) -> Vec<Layer<u8>> {
    let mut levels = vec![finest];
    for _ in 0..LEVELS {
        let next = levels.last().map(halved);
        levels.extend(next);
    }
    levels
}

/// The greatest of the three by three cells from each second one on.
fn halved(layer: &Layer<u8>) -> Layer<u8> {
    let mut half = Layer::new(layer.width.div_ceil(2), layer.height.div_ceil(2));
    for (y, row) in half.cells.chunks_mut(half.width).enumerate() {
        for (x, cell) in row.iter_mut().enumerate() {
            let rows = (2 * y..2 * y + 3).take_while(|y| *y < layer.height);
            let end = (2 * x + 3).min(layer.width);
            let greatest = rows.filter_map(|y| layer.cells[y * layer.width..][2 * x..end].iter().max());
            *cell = greatest.max().copied().unwrap_or(0);
        }
    }
    half
}
