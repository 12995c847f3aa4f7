//! Where a wall's two faces are, how thick it is and where it is open, measured on the map across each boundary.
//!
//! At stations along a boundary the map is read across it. The cells that are not free and nearest to the centre
//! line are the wall; where they end are its faces.

use super::boundary::Run;
use super::raster::Mask;
use planform_sdk::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How walls' faces and openings are measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Walls {
    /// The wall is sought this far to either side of its line: as far as segments of the line may lie. Metres.
    pub reach: f64,
    /// A boundary of less weight than this is open: what stands near it is no wall along it. 0 to 1.
    pub min_weight: f64,
    /// Thickness of a wall of which only one face was seen. Metres.
    pub unseen_thickness: f64,
    /// An opening narrower than this is a gap in the map. Metres.
    pub min_opening: f64,
    /// An opening up to this width is a door, a wider one a passage. Metres.
    pub max_door: f64,
    /// A room with less floor within its walls' inner faces is part of a wall. Square metres.
    pub min_floor: f64,
}

impl Default for Walls {
    fn default() -> Self {
        Self {
            reach: 0.9,
            min_weight: 0.1,
            unseen_thickness: 0.2,
            min_opening: 0.5,
            max_door: 2.1,
            min_floor: 0.25,
        }
    }
}

/// What the map shows: obstacles, and free cells. What is neither is unknown.
pub struct Seen<'a> {
    /// The walls' cells.
    pub obstacles: &'a Mask,
    /// The free cells.
    pub free: &'a Mask,
    /// Metres per cell.
    pub resolution: f64,
}

/// A wall across a station: the positions of its left and right face, metres to the left of the centre line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Faces {
    /// The left face.
    pub left: f64,
    /// The right face.
    pub right: f64,
}

impl Faces {
    /// A wall of this thickness on its centre line.
    pub fn around(thickness: f64) -> Self {
        Self { left: thickness / 2.0, right: -thickness / 2.0 }
    }

    /// Distance between the faces, metres.
    pub fn thickness(self) -> f64 {
        self.left - self.right
    }

    /// Middle between the faces, metres to the left of the centre line.
    pub fn middle(self) -> f64 {
        (self.left + self.right) / 2.0
    }
}

/// One run as the map shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Distance between stations, metres.
    pub step: f64,
    /// At each station the wall's faces, if there is a wall.
    pub stations: Vec<Option<Faces>>,
    /// The faces of the whole run: the medians. None where there is no wall at all.
    pub faces: Option<Faces>,
}

/// What a station shows at one place across the wall.
#[derive(Clone, Copy, PartialEq)]
enum Look {
    Free,
    Obstacle,
    Unknown,
}

impl Seen<'_> {
    fn look(&self, p: Point) -> Look {
        let cell = Point::new(p.x / self.resolution, p.y / self.resolution);
        if self.obstacles.at(cell) {
            Look::Obstacle
        } else if self.free.at(cell) {
            Look::Free
        } else {
            Look::Unknown
        }
    }

    /// Reads the map across a run.
    pub fn profile(&self, run: &Run, params: &Walls) -> Profile {
        let length = run.segment.length();
        let count = ((length / self.resolution).round() as usize).max(1);
        let step = length / count as f64;
        let walled = run.weight >= params.min_weight;
        let station = |i: usize| self.station(run, (i as f64 + 0.5) * step, params).filter(|_| walled);
        let stations: Vec<Option<Faces>> = (0..count).map(station).collect();
        let faces = median_faces(stations.iter().flatten());
        Profile { step, stations, faces }
    }

    /// Reads the map across a run at one place.
    fn station(&self, run: &Run, along: f64, params: &Walls) -> Option<Faces> {
        let step = self.resolution / 2.0;
        let reach = (params.reach / step).ceil() as i64;
        let looks: Vec<Look> =
            (-reach..=reach).map(|i| self.look(run.point(along, i as f64 * step))).collect();
        let (low, high) = nearest_wall(&looks)?;
        let at = |i: usize| (i as f64 - reach as f64) * step;
        let seen = |i: usize| looks.get(i).is_some_and(|&l| l == Look::Free);
        let right_seen = low > 0 && seen(low - 1);
        let left_seen = seen(high + 1);
        let obstacle = |i: &usize| looks[*i] == Look::Obstacle;
        let first = (low..=high).find(obstacle)?;
        let last = (low..=high).rev().find(obstacle)?;
        let (right, left) = (
            at(if right_seen { low } else { first }) - step / 2.0,
            at(if left_seen { high } else { last }) + step / 2.0,
        );
        Some(match (left_seen, right_seen) {
            (true, true) => Faces { left, right },
            (true, false) => Faces { left, right: right.max(left - params.unseen_thickness) },
            (false, true) => Faces { left: left.min(right + params.unseen_thickness), right },
            (false, false) => return None,
        })
    }
}

/// The run of looks that are not free, hold an obstacle and lie nearest to the middle: first and last index.
fn nearest_wall(looks: &[Look]) -> Option<(usize, usize)> {
    let middle = looks.len() / 2;
    let mut best: Option<(usize, (usize, usize))> = None;
    let mut start = 0;
    while start < looks.len() {
        let solid = looks[start..].iter().take_while(|&&l| l != Look::Free).count();
        if solid > 0 && looks[start..start + solid].contains(&Look::Obstacle) {
            let end = start + solid - 1;
            let away = if end < middle { middle - end } else { start.saturating_sub(middle) };
            if best.is_none_or(|(b, _)| away < b) {
                best = Some((away, (start, end)));
            }
        }
        start += solid.max(1);
    }
    best.map(|b| b.1)
}

/// The medians of the left and of the right faces.
pub fn median_faces<'a>(faces: impl Iterator<Item = &'a Faces>) -> Option<Faces> {
    let (mut left, mut right): (Vec<f64>, Vec<f64>) = faces.map(|f| (f.left, f.right)).unzip();
    Some(Faces { left: median(&mut left)?, right: median(&mut right)? })
}

/// The middle value; of an even number the mean of the middle two.
pub fn median(values: &mut [f64]) -> Option<f64> {
    let n = values.len();
    if n == 0 {
        return None;
    }
    let (below, middle, _) = values.select_nth_unstable_by(n / 2, f64::total_cmp);
    let before = if n % 2 == 1 { *middle } else { below.iter().copied().max_by(f64::total_cmp)? };
    Some((before + *middle) / 2.0)
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;
    use planform_sdk::Segment;

    fn profile(obstacles: &[&str], free: &[&str], y: f64) -> Profile {
        let (obstacles, free) = (mask(obstacles), mask(free));
        let seen = Seen { obstacles: &obstacles, free: &free, resolution: 0.1 };
        let segment = Segment::new(Point::new(0.0, y), Point::new(1.0, y));
        let run = Run { line: Some(0), segment, weight: 1.0, rooms: [Some(0), Some(1)] };
        seen.profile(&run, &Walls::default())
    }

    #[test]
    fn both_faces_are_found() {
        let wall = ["..........", "..........", "##########", "##########", "..........", ".........."];
        let free = ["##########", "##########", "..........", "..........", "##########", "##########"];
        let p = profile(&wall, &free, 0.32);
        let faces = p.faces.unwrap();
        assert!((faces.left - 0.08).abs() < 0.03 && (faces.right + 0.12).abs() < 0.03, "{faces:?}");
        assert!(p.stations.iter().all(Option::is_some));
    }

    #[test]
    fn an_opening_has_no_wall() {
        let wall = ["..........", "..........", "##......##", "..........", "..........", ".........."];
        let free = ["##########", "##########", "..######..", "##########", "##########", "##########"];
        let p = profile(&wall, &free, 0.35);
        assert_eq!(p.stations.iter().filter(|s| s.is_none()).count(), 6);
    }

    #[test]
    fn an_outer_wall_seen_from_one_side_gets_a_thickness() {
        let wall = ["##########", "##########", "##########", "##########", "##########", ".........."];
        let free = ["..........", "..........", "..........", "..........", "..........", "##########"];
        let faces = profile(&wall, &free, 0.2).faces.unwrap();
        assert!((faces.left - faces.right - 0.2).abs() < 1e-9);
    }
}
