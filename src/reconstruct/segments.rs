//! Line segments along the edges: the progressive probabilistic Hough transform of Matas, Galambos and Kittler,
//! "Robust Detection of Lines Using the Progressive Probabilistic Hough Transform", 2000.
//!
//! Edge cells vote in random order; as soon as a line has votes enough, the map is followed along it, and the cells
//! of the segment found neither vote nor count any more.

use super::random::mix;
use super::raster::{Extent, Mask};
use planform_sdk::{Point, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// What makes a segment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Segments {
    /// Distance between neighbouring lines that are told apart. Metres, but at least one cell.
    pub distance_step: f64,
    /// Angle between neighbouring lines that are told apart. Radians.
    pub angle_step: f64,
    /// A line needs edge cells that together are this long. Metres, but at least six cells.
    pub support: f64,
    /// The shortest segment. Metres, but at least three cells.
    pub min_length: f64,
    /// The longest gap within a segment. Metres, but at least one cell.
    pub max_gap: f64,
    /// Seed of the random order.
    pub seed: u64,
}

impl Default for Segments {
    fn default() -> Self {
        Self {
            distance_step: 0.05,
            angle_step: PI / 180.0,
            support: 1.0,
            min_length: 0.35,
            max_gap: 0.15,
            seed: 1,
        }
    }
}

/// The segments along the edge cells, in metres from the grid's corner. `resolution` in metres per cell.
pub fn detect(edges: &Mask, resolution: f64, params: &Segments) -> Vec<Segment> {
    let Some(centre) = Centre::of(edges) else { return Vec::new() };
    let mut cells: Vec<(i64, i64)> = edges.cells().map(|(c, r)| (c as i64, r as i64)).collect();
    cells.sort_by_cached_key(|&cell| centre.draw(cell, params.seed));
    let mut search = Search::new(edges, centre, resolution, params);
    let found: Vec<_> = cells.into_iter().filter_map(|cell| search.draw(cell)).collect();
    let metres =
        |(x, y): (i64, i64)| Point::new((x as f64 + 0.5) * resolution, (y as f64 + 0.5) * resolution);
    found.into_iter().map(|(a, b)| Segment::new(metres(a), metres(b))).collect()
}

/// The middle of all edge cells. Seen from it, a map that is shifted, mirrored or turned by a right angle has its cells
/// drawn in the same order and voting for the same lines, so the segments found hardly differ.
#[derive(Clone, Copy)]
struct Centre {
    /// Twice its column and row: it may lie between two cells.
    twice: (i64, i64),
}

impl Centre {
    fn of(edges: &Mask) -> Option<Self> {
        let Extent { low, high } = edges.extent()?;
        Some(Self { twice: ((low.0 + high.0) as i64, (low.1 + high.1) as i64) })
    }

    /// A cell's position from the centre, in half cells.
    fn from(self, (column, row): (i64, i64)) -> (i64, i64) {
        (2 * column - self.twice.0, 2 * row - self.twice.1)
    }

    /// When a cell is drawn: at random, but like its images under the symmetries of the square.
    fn draw(self, cell: (i64, i64), seed: u64) -> (u64, (i64, i64)) {
        let (x, y) = self.from(cell);
        let (a, b) = (x.unsigned_abs(), y.unsigned_abs());
        (mix(seed, a.max(b), a.min(b)), cell)
    }
}

/// State of a cell: no edge, an edge that has not voted, or one that has.
#[derive(Clone, Copy, PartialEq)]
enum Edge {
    None,
    Silent,
    Voted,
}

struct Search<'a> {
    edges: &'a Mask,
    centre: Centre,
    state: Vec<Edge>,
    votes: Vec<u16>,
    /// Cosine and sine of each angle, over the distance step in cells.
    trig: Vec<(f64, f64)>,
    distances: usize,
    threshold: u16,
    min_length: f64,
    max_gap: u32,
}

impl<'a> Search<'a> {
    fn new(edges: &'a Mask, centre: Centre, resolution: f64, params: &Segments) -> Self {
        let step = (params.distance_step / resolution).max(1.0);
        let angles = ((PI / params.angle_step).round() as usize).max(4);
        let trig =
            (0..angles).map(|i| (PI * i as f64 / angles as f64).sin_cos()).map(|(s, c)| (c / step, s / step));
        let distances = 2 * ((edges.width() + edges.height()) as f64 / step).ceil() as usize + 3;
        let cells = |metres: f64, least: f64| (metres / resolution).round().max(least);
        Self {
            state: edges.bits().iter().map(|&b| if b { Edge::Silent } else { Edge::None }).collect(),
            edges,
            centre,
            votes: vec![0; angles * distances],
            trig: trig.collect(),
            distances,
            threshold: cells(params.support, 6.0).min(f64::from(u16::MAX)) as u16,
            min_length: cells(params.min_length, 3.0),
            max_gap: cells(params.max_gap, 1.0) as u32,
        }
    }

    fn slot(&self, angle: usize, cell: (i64, i64)) -> usize {
        let (cos, sin) = self.trig[angle];
        let (x, y) = self.centre.from(cell);
        let distance = ((x as f64 * cos + y as f64 * sin) / 2.0).round() as i64 + self.distances as i64 / 2;
        angle * self.distances + distance as usize
    }

    /// Lets one edge cell vote, and follows its best line if that has votes enough.
    fn draw(&mut self, cell: (i64, i64)) -> Option<((i64, i64), (i64, i64))> {
        let i = self.edges.index(cell.0, cell.1)?;
        if self.state[i] != Edge::Silent {
            return None;
        }
        self.state[i] = Edge::Voted;
        let angle = self.vote(cell)?;
        let ends = [self.follow(cell, angle, 1), self.follow(cell, angle, -1)];
        let length = ((ends[0].0 - ends[1].0) as f64).hypot((ends[0].1 - ends[1].1) as f64);
        let good = length >= self.min_length;
        for (direction, end) in [(1, ends[0]), (-1, ends[1])] {
            self.erase(cell, angle, direction, end, good);
        }
        good.then_some((ends[1], ends[0]))
    }

    /// Adds a cell's votes; returns the angle of its strongest line if that has votes enough.
    fn vote(&mut self, cell: (i64, i64)) -> Option<usize> {
        let angles = 0..self.trig.len();
        let mut most = 0;
        for angle in angles.clone() {
            let slot = self.slot(angle, cell);
            self.votes[slot] = self.votes[slot].saturating_add(1);
            most = most.max(self.votes[slot]);
        }
        if most < self.threshold {
            return None;
        }
        let votes: Vec<u16> = angles.map(|angle| self.votes[self.slot(angle, cell)]).collect();
        middle_of_ties(&votes, most)
    }

    /// The cells along a line from `start`: whole steps along the steeper axis.
    fn walk(&self, start: (i64, i64), angle: usize, sign: i64) -> impl Iterator<Item = (i64, i64)> + use<> {
        let (cos, sin) = self.trig[angle];
        let (dx, dy) = (-sin, cos);
        let steps = dx.abs().max(dy.abs());
        let (dx, dy) = (dx / steps * sign as f64, dy / steps * sign as f64);
        (0..).map(move |k| {
            let along = |v: i64, d: f64| v + (d * f64::from(k)).round() as i64;
            (along(start.0, dx), along(start.1, dy))
        })
    }

    /// The last edge cell along the line before a gap that is too long.
    fn follow(&self, start: (i64, i64), angle: usize, sign: i64) -> (i64, i64) {
        let mut last = start;
        let mut gap = 0;
        for (column, row) in self.walk(start, angle, sign) {
            let Some(i) = self.edges.index(column, row) else { break };
            if self.state[i] != Edge::None {
                last = (column, row);
                gap = 0;
            } else {
                gap += 1;
                if gap > self.max_gap {
                    break;
                }
            }
        }
        last
    }

    /// Takes the cells up to `end` out of the search and, if they made a segment, their votes too.
    fn erase(&mut self, start: (i64, i64), angle: usize, sign: i64, end: (i64, i64), good: bool) {
        for cell in self.walk(start, angle, sign) {
            let Some(i) = self.edges.index(cell.0, cell.1) else { break };
            if self.state[i] == Edge::Voted && good {
                for angle in 0..self.trig.len() {
                    let slot = self.slot(angle, cell);
                    self.votes[slot] = self.votes[slot].saturating_sub(1);
                }
            }
            self.state[i] = Edge::None;
            if cell == end {
                break;
            }
        }
    }
}

/// Of the angles with the most votes the middle one: a short line has neighbouring angles tie, and the first of them
/// would lean. Angles go around, so the count starts where there is no tie.
fn middle_of_ties(votes: &[u16], most: u16) -> Option<usize> {
    let start = votes.iter().position(|&v| v < most).unwrap_or(0);
    let around = (0..votes.len()).map(|i| (start + i) % votes.len());
    let ties: Vec<usize> = around.filter(|&angle| votes[angle] == most).collect();
    ties.get(ties.len() / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;

    fn line_of(length: usize) -> Mask {
        let blank = ".".repeat(60);
        let line = format!("{}{}", "#".repeat(length), ".".repeat(60 - length));
        mask(&[&blank, &blank, &line, &blank])
    }

    #[test]
    fn a_line_is_one_segment() {
        let found = detect(&line_of(50), 0.05, &Segments::default());
        assert_eq!(found.len(), 1);
        assert!((found[0].length() - 2.45).abs() < 1e-9);
        assert!((found[0].a.y - 0.075).abs() < 1e-9 && (found[0].b.y - 0.075).abs() < 1e-9);
    }

    #[test]
    fn ties_go_to_the_middle_also_around_the_end() {
        assert_eq!(middle_of_ties(&[1, 3, 3, 3, 2], 3), Some(2));
        assert_eq!(middle_of_ties(&[3, 3, 1, 1, 3], 3), Some(0));
        assert_eq!(middle_of_ties(&[3, 3, 3], 3), Some(1));
    }

    #[test]
    fn too_few_cells_are_no_line() {
        assert!(detect(&line_of(10), 0.05, &Segments::default()).is_empty());
    }

    #[test]
    fn the_same_seed_gives_the_same_segments() {
        let rows: Vec<String> = (0..40)
            .map(|r| (0..60).map(|c| if (c * 7 + r * 13) % 5 == 0 { '#' } else { '.' }).collect())
            .collect();
        let m = mask(&rows.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(detect(&m, 0.05, &Segments::default()), detect(&m, 0.05, &Segments::default()));
    }
}
