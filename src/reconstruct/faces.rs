//! What the faces between the representative lines are: within the map, outside of it, or within a wall.

use super::arrangement::{Arrangement, Edge};
use super::raster::Mask;
use planform_sdk::{Point, ring_signed_area};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Which faces lie outside.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Faces {
    /// The threshold delta of the paper: a face with a smaller share of its area in the inner area is external.
    /// 0 to 1.
    pub inner_share: f64,
    /// How far beyond the inner area the lines are drawn. Metres.
    pub margin: f64,
    /// The most faces; a map with more is refused.
    pub max_count: usize,
}

impl Default for Faces {
    fn default() -> Self {
        Self { inner_share: 0.3, margin: 1.0, max_count: 500_000 }
    }
}

/// The external faces that lie within a wall between rooms: narrower than `width` on average, and bounded by faces of
/// the selection for four fifths of their outline. Two lines along the faces of one thick wall make such ones.
pub fn within_walls(
    arrangement: &Arrangement,
    edges: &[Edge],
    width: f64,
    member: impl Fn(usize) -> bool,
) -> Vec<usize> {
    let (mut outline, mut shared) = (vec![0.0; arrangement.count()], vec![0.0; arrangement.count()]);
    for edge in edges {
        let length = arrangement.vertices[edge.ends[0]].distance(arrangement.vertices[edge.ends[1]]);
        for (face, other) in [(Some(edge.left), edge.right), (edge.right, Some(edge.left))] {
            let Some(face) = face else { continue };
            outline[face] += length;
            shared[face] += if other.is_some_and(&member) { length } else { 0.0 };
        }
    }
    let narrow = |f: usize| 2.0 * ring_signed_area(&arrangement.ring(f)) < width * outline[f];
    (0..outline.len()).filter(|&f| !member(f) && narrow(f) && shared[f] >= 0.8 * outline[f]).collect()
}

/// For each face the share of its cells that the mask sets; a face that holds no cell's middle has 0.
pub fn shares(arrangement: &Arrangement, mask: &Mask, resolution: f64) -> Vec<f64> {
    let sums = RowSums::of(mask);
    (0..arrangement.count()).map(|f| sums.share(&arrangement.ring(f), resolution)).collect()
}

/// The middles of the set cells in a convex ring, metres.
pub fn set_cells(ring: &[Point], mask: &Mask, resolution: f64) -> Vec<Point> {
    let middle = |v: i64| (v as f64 + 0.5) * resolution;
    let inside = rows(ring, resolution).filter(|(row, _)| (0..mask.height() as i64).contains(row));
    inside
        .flat_map(|(row, columns)| {
            let columns = columns.start.max(0)..columns.end.min(mask.width() as i64);
            columns.filter(move |&c| mask.get(c, row)).map(move |c| Point::new(middle(c), middle(row)))
        })
        .collect()
}

/// The cells whose middles lie in a convex ring: each row with its columns.
fn rows(ring: &[Point], resolution: f64) -> impl Iterator<Item = (i64, Range<i64>)> + '_ {
    let first = move |from: f64| (from / resolution - 0.5).ceil() as i64;
    let last = move |to: f64| (to / resolution - 0.5).floor() as i64;
    let (low, high) = ring.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p.y), h.max(p.y)));
    (first(low)..=last(high)).filter_map(move |row| {
        let (left, right) = span(ring, (row as f64 + 0.5) * resolution)?;
        Some((row, first(left)..last(right) + 1))
    })
}

/// For each row the number of set cells before each column.
struct RowSums {
    width: usize,
    height: usize,
    sums: Vec<u32>,
}

impl RowSums {
    fn of(mask: &Mask) -> Self {
        let (width, height) = (mask.width(), mask.height());
        let mut sums = Vec::with_capacity((width + 1) * height);
        for row in mask.bits().chunks(width) {
            let mut sum = 0;
            sums.push(0);
            for bit in row {
                sum += u32::from(*bit);
                sums.push(sum);
            }
        }
        Self { width, height, sums }
    }

    fn share(&self, ring: &[Point], resolution: f64) -> f64 {
        let (mut set, mut all) = (0.0, 0.0);
        for (row, columns) in rows(ring, resolution) {
            all += (columns.end - columns.start).max(0) as f64;
            set += f64::from(self.count(row, columns.start, columns.end));
        }
        if all > 0.0 { set / all } else { 0.0 }
    }

    /// Set cells of a row from one column up to before another.
    fn count(&self, row: i64, from: i64, to: i64) -> u32 {
        if !(0..self.height as i64).contains(&row) || to <= from {
            return 0;
        }
        let sum = |column: i64| {
            self.sums[row as usize * (self.width + 1) + column.clamp(0, self.width as i64) as usize]
        };
        sum(to) - sum(from)
    }
}

/// Where the horizontal line at `y` enters and leaves a convex ring.
fn span(ring: &[Point], y: f64) -> Option<(f64, f64)> {
    let mut span: Option<(f64, f64)> = None;
    for (i, a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        if (a.y > y) != (b.y > y) {
            let x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
            let (low, high) = span.unwrap_or((x, x));
            span = Some((low.min(x), high.max(x)));
        }
    }
    span
}

#[cfg(test)]
mod tests {
    use super::super::lines::Line;
    use super::*;

    #[test]
    fn a_strip_between_rooms_is_within_a_wall() {
        let line = |offset| Line { angle: 0.0, offset, covered: Vec::new(), support: 1.0 };
        let (low, high) = (Point::new(0.0, 0.0), Point::new(10.0, 10.0));
        let a = Arrangement::of_lines(low, high, &[line(4.9), line(5.1), line(9.8)], usize::MAX).unwrap();
        let at = |y: f64| (0..4).find(|&f| a.polygon(f).contains(Point::new(5.0, y))).unwrap();
        let rooms = [at(1.0), at(7.0)];
        assert_eq!(within_walls(&a, &a.edges(), 0.5, |f| rooms.contains(&f)), [at(5.0)]);
    }
}
