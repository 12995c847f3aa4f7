//! The free space of a map, as fine as the work needs it, with furniture taken away.
//!
//! A robot's map shows table legs, boxes and people as small islands in the free space; an island that stands in line
//! with a wall, or hangs together with one but for a cell or two, is the rest of a wall.

use super::super::raster::Mask;
use super::super::runs::Parts;
use planform_sdk::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_3, PI, TAU};

/// What counts as free space.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Furniture {
    /// An island of cells that are not free is furniture if it covers less than this. Square metres; 0 keeps all.
    pub area: f64,
    /// It also has to be shorter than this. Metres.
    pub extent: f64,
    /// An island this near to a wall, or to another one that is, is part of the wall. Metres.
    pub gap: f64,
    /// An elongated island is the rest of a wall if it points at a wall at both ends within this distance. Metres.
    pub reach: f64,
}

impl Default for Furniture {
    fn default() -> Self {
        Self { area: 2.2, extent: 3.0, gap: 0.2, reach: 1.5 }
    }
}

/// Cells are at most this large, metres: coarser maps are refined, for a door has to be some cells wide.
const COARSEST: f64 = 0.1;

/// A free region smaller than this is no room, square metres.
const SPECK: f64 = 0.25;

/// An island shorter than this is no rest of a wall, metres.
const REST: f64 = 0.5;

/// An arm of an island is at least this long and at most this wide, metres: a wall, not a table.
const ARM_LENGTH: f64 = 0.4;
const ARM_WIDTH: f64 = 0.35;

/// A colonnade has at least this many islands, which fill at least this share of its length.
const ROW: usize = 3;
const FILLED: f64 = 0.4;

/// The farthest that two of them are apart, metres.
const SPACED: f64 = 2.0;

/// How far an arm may lean from the direction that it points in, as a share of its length: 7 degrees for each half.
const LEAN: f64 = 0.125;

/// What is fixed reaches this far, metres.
const FIXED: f64 = 0.25;

/// In how many directions arms are looked for.
const TURNS: u32 = 72;

/// The free space of a map: the box around its free cells with a border of one cell that is not free.
pub struct Space {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Metres per cell.
    pub resolution: f64,
    /// How many cells of the space lie along a cell of the map.
    pub fineness: usize,
    /// Column and row of the map's cell at the space's second column and row.
    pub corner: (usize, usize),
    /// Whether each cell is free, row by row from the bottom.
    pub free: Vec<bool>,
}

impl Space {
    /// The free space of a map without furniture and specks, if there is any; `mask` are the free cells.
    /// What lies at one of `fixed`, in metres from the grid's corner, is no furniture.
    pub fn of_mask(mask: &Mask, resolution: f64, furniture: &Furniture, fixed: &[Point]) -> Option<Self> {
        let mut space = Self::refined(mask, resolution)?;
        space.clear(furniture, fixed);
        space.drop_specks();
        space.free.contains(&true).then_some(space)
    }

    /// The set cells, so fine that a door is some cells wide.
    fn refined(mask: &Mask, resolution: f64) -> Option<Self> {
        let extent = mask.extent()?;
        let fineness = (resolution / COARSEST).ceil().clamp(1.0, 8.0) as usize;
        let (columns, rows) = (extent.high.0 - extent.low.0 + 1, extent.high.1 - extent.low.1 + 1);
        let (width, height) = (columns * fineness + 2, rows * fineness + 2);
        let mut free = vec![false; width * height];
        for run in mask.runs() {
            let (x, y) = ((run.from - extent.low.0) * fineness + 1, (run.row - extent.low.1) * fineness + 1);
            for dy in 0..fineness {
                free[(y + dy) * width + x..][..run.length() * fineness].fill(true);
            }
        }
        let resolution = resolution / fineness as f64;
        Some(Self { width, height, resolution, fineness, corner: extent.low, free })
    }

    /// Steps from a cell's index to those of its eight neighbours.
    pub fn steps(&self) -> [i64; 8] {
        let w = self.width as i64;
        [-w - 1, -w, -w + 1, -1, 1, w - 1, w, w + 1]
    }

    /// The cell's index if it lies in the space.
    pub fn index(&self, column: f64, row: f64) -> Option<usize> {
        let inside = |v: f64, n: usize| v > -0.5 && v < n as f64 - 0.5;
        let is_inside = inside(column, self.width) && inside(row, self.height);
        is_inside.then(|| (row + 0.5) as usize * self.width + (column + 0.5) as usize)
    }

    /// The place of a point in metres from the grid's corner, in columns and rows of cell centres.
    pub fn cell(&self, p: Point) -> Point {
        let place = |metres: f64, corner: usize| {
            metres / self.resolution - (corner * self.fineness) as f64 + 1.0 - 0.5
        };
        Point::new(place(p.x, self.corner.0), place(p.y, self.corner.1))
    }

    /// Square metres of a number of cells.
    pub fn area(&self, cells: usize) -> f64 {
        cells as f64 * self.resolution * self.resolution
    }

    /// Labels grown into the unlabelled cells around them, up to a distance in metres: each cell gets the nearest
    /// label. Distances are those of steps by 5 straight ahead and 7 over a corner (Borgefors, "Distance
    /// Transformations in Digital Images", 1986).
    pub fn grown(&self, label: &[u32], reach: f64) -> Vec<u32> {
        let limit = (reach / self.resolution * 5.0).floor().clamp(0.0, 60_000.0) as usize;
        let mut waiting: Vec<Vec<u32>> = vec![Vec::new(); limit + 8];
        waiting[0] = self.rims(label);
        let mut grown = label.to_vec();
        let mut distance: Vec<u16> = label.iter().map(|&l| if l == 0 { u16::MAX } else { 0 }).collect();
        let costs =
            self.steps().map(|s| (s, if s.abs() == 1 || s.abs() == self.width as i64 { 5 } else { 7 }));
        let inside = |i: usize| !i.is_multiple_of(self.width) && !(i + 1).is_multiple_of(self.width);
        for d in 0..=limit {
            for i in std::mem::take(&mut waiting[d]) {
                if usize::from(distance[i as usize]) != d || !inside(i as usize) {
                    continue;
                }
                for (step, cost) in costs {
                    let j = (i64::from(i) + step) as usize;
                    if j < label.len() && d + cost <= limit && d + cost < usize::from(distance[j]) {
                        distance[j] = (d + cost) as u16;
                        grown[j] = grown[i as usize];
                        waiting[d + cost].push(j as u32);
                    }
                }
            }
        }
        grown
    }

    /// The labelled cells with an unlabelled one among their eight neighbours, rising.
    fn rims(&self, label: &[u32]) -> Vec<u32> {
        let bare = self.mask(label.iter().map(|&l| l == 0).collect());
        let rims = bare.grown(1).without(&bare);
        rims.runs().flat_map(|run| run.cells(self.width)).map(|i| i as u32).collect()
    }

    /// A mask of the space's cells.
    pub fn mask(&self, bits: Vec<bool>) -> Mask {
        Mask::new(self.width, self.height, bits)
    }

    /// Drops free regions that are too small to be a room.
    fn drop_specks(&mut self) {
        let regions = Parts::of(&self.free, self.width, true, true);
        let cell = self.area(1);
        let is_speck = |part: u32| (regions.sizes[part as usize] as f64 * cell) < SPECK;
        let specks: Vec<_> = regions.runs.iter().filter(|(_, part)| is_speck(*part)).collect();
        for (run, _) in specks {
            self.free[run.cells(self.width)].fill(false);
        }
    }

    /// Makes furniture free.
    fn clear(&mut self, furniture: &Furniture, fixed: &[Point]) {
        let mut islands = Islands::of(self, furniture);
        islands.fix(self, fixed);
        let gone = islands.furniture(self, furniture);
        for (run, _) in islands.parts.runs.iter().filter(|(_, part)| gone[*part as usize]) {
            self.free[run.cells(self.width)].fill(true);
        }
    }
}

/// The connected components of the cells that are not free.
struct Islands {
    parts: Parts,
    /// The island of each cell; for free cells their number.
    label: Vec<u32>,
    /// The cells of those that are small enough to be furniture; none of the others.
    cells: Vec<Vec<(f64, f64)>>,
    /// The longer side of the box around each, metres.
    extent: Vec<f64>,
    small: Vec<bool>,
}

impl Islands {
    fn of(space: &Space, furniture: &Furniture) -> Self {
        let parts = Parts::of(&space.free, space.width, false, true);
        let count = parts.sizes.len();
        let extent: Vec<f64> = extents(&parts).map(|side| side as f64 * space.resolution).collect();
        // Free cells share one more label at the end, so that every label is an index.
        let mut label = vec![count as u32; space.free.len()];
        for (run, part) in &parts.runs {
            label[run.cells(space.width)].fill(*part);
        }
        let mut small: Vec<bool> = (0..count)
            .map(|i| space.area(parts.sizes[i]) < furniture.area && extent[i] < furniture.extent)
            .collect();
        // The border of the space is no island.
        small[label[0] as usize] = false;
        let mut cells = vec![Vec::new(); count];
        for (run, part) in parts.runs.iter().filter(|(_, part)| small[*part as usize]) {
            cells[*part as usize].extend((run.from..run.to).map(|c| (c as f64, run.row as f64)));
        }
        Self { parts, label, cells, extent, small }
    }

    /// Islands at these places are no furniture.
    fn fix(&mut self, space: &Space, places: &[Point]) {
        let reach = FIXED / space.resolution;
        let steps = reach.floor() as i32;
        let disc =
            || (-steps..=steps).flat_map(|y| (-steps..=steps).map(move |x| (f64::from(x), f64::from(y))));
        for place in places.iter().map(|p| space.cell(*p)) {
            let near = disc().filter(|(x, y)| x.hypot(*y) <= reach);
            for i in near.filter_map(|(x, y)| space.index(place.x + x, place.y + y)) {
                if let Some(small) = self.small.get_mut(self.label[i] as usize) {
                    *small = false;
                }
            }
        }
    }

    /// For each label whether its cells are furniture; the last one is that of the free cells.
    fn furniture(&self, space: &Space, furniture: &Furniture) -> Vec<bool> {
        let mut gone = self.small.clone();
        for i in self.chained(space, furniture.gap) {
            gone[i] = false;
        }
        let rests: Vec<usize> =
            (0..gone.len()).filter(|&i| gone[i] && self.is_rest(space, i, &gone, furniture.reach)).collect();
        for i in rests {
            gone[i] = false;
        }
        for i in (0..gone.len()).filter(|&i| self.small[i]).flat_map(|i| self.row(space, i)) {
            gone[i] = false;
        }
        gone.push(false);
        gone
    }

    /// The small islands that hang together with a wall over gaps of at most `gap`.
    fn chained(&self, space: &Space, gap: f64) -> Vec<usize> {
        let near = self.neighbours(space, gap);
        let mut joined: Vec<bool> = self.small.iter().map(|s| !s).collect();
        let mut queue: Vec<usize> = (0..joined.len()).filter(|&i| joined[i]).collect();
        let mut beside: Vec<Vec<usize>> = vec![Vec::new(); joined.len()];
        for (a, b) in near {
            beside[a].push(b);
            beside[b].push(a);
        }
        let mut found = Vec::new();
        while let Some(i) = queue.pop() {
            for &j in &beside[i] {
                if !joined[j] {
                    joined[j] = true;
                    queue.push(j);
                    found.push(j);
                }
            }
        }
        found
    }

    /// The pairs of a small island and another one that is near it.
    fn neighbours(&self, space: &Space, gap: f64) -> Vec<(usize, usize)> {
        let reach = (gap / space.resolution).clamp(1.5, 12.0);
        let r = reach as i64;
        let disc: Vec<(f64, f64)> = (-r..=r)
            .flat_map(|y| (-r..=r).map(move |x| (x as f64, y as f64)))
            .filter(|(x, y)| x.hypot(*y) <= reach)
            .collect();
        let mut pairs = Vec::new();
        for (i, cells) in self.cells.iter().enumerate() {
            for (c, r) in cells {
                let around = disc.iter().filter_map(|(x, y)| space.index(c + x, r + y));
                pairs.extend(around.map(|j| (i, self.label[j] as usize)));
            }
        }
        pairs.retain(|&(a, b)| a != b && b < self.small.len());
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }

    /// The islands that stand in a row with this one, from wall to wall along its longer axis, if they fill enough of
    /// the way: a colonnade.
    fn row(&self, space: &Space, island: usize) -> Vec<usize> {
        if self.extent[island] < REST {
            return Vec::new();
        }
        let (middle, (dx, dy)) = axis(&self.cells[island]);
        let mut row = Vec::new();
        let (mut filled, mut steps) = (0usize, 0usize);
        for sign in [1.0, -1.0] {
            let mut open = 0;
            let mut t = 0.0;
            loop {
                let Some(i) = space.index(middle.0 + sign * dx * t, middle.1 + sign * dy * t) else {
                    return Vec::new();
                };
                let l = self.label[i] as usize;
                let solid = l < self.small.len();
                if solid && !self.small[l] {
                    break;
                }
                if solid && self.extent[l] >= REST {
                    row.push(l);
                }
                open = if solid { 0 } else { open + 1 };
                filled += usize::from(solid);
                steps += 1;
                t += 1.0;
                if open as f64 * space.resolution > SPACED {
                    return Vec::new();
                }
            }
        }
        row.sort_unstable();
        row.dedup();
        if row.len() >= ROW && filled as f64 >= FILLED * steps as f64 { row } else { Vec::new() }
    }

    /// Whether an island has at least two arms that point at walls, or at other islands large enough to be the rest
    /// of one: a straight piece with its two ends, or a corner with the ends of its legs.
    fn is_rest(&self, space: &Space, island: usize, gone: &[bool], reach: f64) -> bool {
        if self.extent[island] < REST {
            return false;
        }
        let wall = |l: u32| {
            let l = l as usize;
            l < gone.len() && l != island && (!gone[l] || self.extent[l] >= REST)
        };
        let steps = (reach / space.resolution) as usize;
        let meets = |tip: (f64, f64), angle: f64| {
            let (sin, cos) = angle.sin_cos();
            (2..steps + 2).any(|k| {
                let hit = space.index(tip.0 + cos * k as f64, tip.1 + sin * k as f64);
                hit.is_some_and(|i| wall(self.label[i]))
            })
        };
        let angles = (0..TURNS).map(|k| TAU * f64::from(k) / f64::from(TURNS));
        let tips = angles.filter_map(|a| Some((a, arm(&self.cells[island], a, space.resolution)?)));
        let found: Vec<f64> = tips.filter(|(a, tip)| meets(*tip, *a)).map(|t| t.0).collect();
        let apart = |a: f64, b: f64| ((a - b + PI).rem_euclid(TAU) - PI).abs() > FRAC_PI_3;
        found.iter().enumerate().any(|(i, &a)| found[..i].iter().any(|&b| apart(a, b)))
    }
}

/// The longer side of the box around each component, in cells.
fn extents(parts: &Parts) -> impl Iterator<Item = usize> + use<> {
    let mut boxes = vec![[usize::MAX, usize::MAX, 0, 0]; parts.sizes.len()];
    for (run, part) in &parts.runs {
        let b = &mut boxes[*part as usize];
        *b = [b[0].min(run.from), b[1].min(run.row), b[2].max(run.to - 1), b[3].max(run.row)];
    }
    boxes.into_iter().map(|b| (b[2] - b[0]).max(b[3] - b[1]) + 1)
}

/// The middle of some cells, and the direction in which they are spread most.
fn axis(cells: &[(f64, f64)]) -> ((f64, f64), (f64, f64)) {
    let n = cells.len() as f64;
    let (x, y) = cells.iter().fold((0.0, 0.0), |(x, y), c| (x + c.0 / n, y + c.1 / n));
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for (cx, cy) in cells {
        let (dx, dy) = (cx - x, cy - y);
        (xx, xy, yy) = (xx + dx * dx, xy + dx * dy, yy + dy * dy);
    }
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    ((x, y), (angle.cos(), angle.sin()))
}

/// The tip of an island's arm that points in a direction: the middle of its outermost cells, if the island is narrow
/// there.
fn arm(cells: &[(f64, f64)], angle: f64, resolution: f64) -> Option<(f64, f64)> {
    let (sin, cos) = angle.sin_cos();
    let along = |c: &(f64, f64)| c.0 * cos + c.1 * sin;
    let across = |c: &(f64, f64)| c.1 * cos - c.0 * sin;
    let end = cells.iter().map(along).fold(f64::MIN, f64::max);
    let near = |depth: f64| {
        let outer = cells.iter().filter(move |c| along(c) >= end - depth / resolution);
        outer.map(across).fold((f64::MAX, f64::MIN), |(l, h), t| (l.min(t), h.max(t)))
    };
    let back = cells.iter().map(along).fold(f64::MAX, f64::min);
    let (low, high) = near(ARM_LENGTH);
    if (high - low) * resolution > ARM_WIDTH || (end - back) * resolution < ARM_LENGTH {
        return None;
    }
    // Across the outer and the inner half of the arm: their difference tells whether it points that way.
    let mean = |from: f64, to: f64| {
        let depth = |c: &&(f64, f64)| (from..to).contains(&((end - along(c)) * resolution));
        let (sum, count) = cells.iter().filter(depth).fold((0.0, 0.0), |(s, n), c| (s + across(c), n + 1.0));
        sum / f64::max(count, 1.0)
    };
    let lean = mean(0.0, ARM_LENGTH / 2.0) - mean(ARM_LENGTH / 2.0, ARM_LENGTH);
    if lean.abs() > LEAN * ARM_LENGTH / resolution {
        return None;
    }
    let middle = (low + high) / 2.0;
    Some((end * cos - middle * sin, end * sin + middle * cos))
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A space from a picture, the top row first; `.` is free. A border is added.
    pub fn space(rows: &[&str], resolution: f64) -> Space {
        let (width, height) = (rows[0].len() + 2, rows.len() + 2);
        let mut free = vec![false; width * height];
        for (r, row) in rows.iter().rev().enumerate() {
            for (c, b) in row.bytes().enumerate() {
                free[(r + 1) * width + c + 1] = b == b'.';
            }
        }
        Space { width, height, resolution, fineness: 1, corner: (0, 0), free }
    }

    fn cleared(rows: &[&str]) -> String {
        let mut space = space(rows, 0.25);
        space.clear(&Furniture::default(), &[]);
        let row = |r: usize| -> String {
            (1..space.width - 1).map(|c| if space.free[r * space.width + c] { '.' } else { '#' }).collect()
        };
        (1..space.height - 1).rev().map(row).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn a_table_goes_and_a_wall_stays() {
        let rows = ["......#...", "......#...", "..##..#...", "..##..#...", "......#...", ".........."];
        let without = ["......#...", "......#...", "......#...", "......#...", "......#...", ".........."];
        assert_eq!(cleared(&rows), without.join("\n"));
    }

    #[test]
    fn an_island_in_line_with_walls_is_the_rest_of_one() {
        let rows = ["................", "####..####..####", "................"];
        assert_eq!(cleared(&rows), rows.join("\n"));
        let row = |middle: &str| format!("{0}{middle}{0}", ".".repeat(12));
        let rows = [row("...."), row("####"), row("....")];
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        assert!(!cleared(&rows).contains('#'));
    }

    #[test]
    fn a_coarse_map_is_refined() {
        let mask = super::super::super::raster::tests::mask(&["##", ".#"]);
        let space = Space::refined(&mask, 0.2).unwrap();
        assert_eq!((space.width, space.height, space.resolution), (6, 6, 0.1));
        assert_eq!(space.free.iter().filter(|&&f| f).count(), 12);
    }
}
