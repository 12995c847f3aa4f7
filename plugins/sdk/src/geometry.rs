//! Points, segments, polygons and poses in metres.

use crate::{ErrorKind, PluginError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A point in metres. Written as `[x, y]`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[f64; 2]", into = "[f64; 2]")]
#[schemars(with = "[f64; 2]")]
pub struct Point {
    /// To the right, metres.
    pub x: f64,
    /// Up, metres.
    pub y: f64,
}

impl Point {
    /// The point (x, y).
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// Distance to another point, metres.
    ///
    /// ```
    /// # use planform_sdk::Point;
    /// assert_eq!(Point::new(0.0, 3.0).distance(Point::new(4.0, 0.0)), 5.0);
    /// ```
    pub fn distance(self, other: Self) -> f64 {
        (self.x - other.x).hypot(self.y - other.y)
    }

    /// The point, if it is somewhere: both coordinates are finite numbers.
    pub fn finite(self) -> Result<Self, PluginError> {
        if self.x.is_finite() && self.y.is_finite() {
            return Ok(self);
        }
        let message = format!("the point ({}, {}) is not finite", self.x, self.y);
        Err(PluginError::new(ErrorKind::BadInput, message).advise("correct the layout"))
    }

    /// The point half way to another one.
    pub fn midpoint(self, other: Self) -> Self {
        Self::new((self.x + other.x) / 2.0, (self.y + other.y) / 2.0)
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [f64; 2] {
    fn from(p: Point) -> Self {
        [p.x, p.y]
    }
}

/// A line segment in metres. Written as `[[x, y], [x, y]]`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(from = "[Point; 2]", into = "[Point; 2]")]
#[schemars(with = "[Point; 2]")]
pub struct Segment {
    /// One end.
    pub a: Point,
    /// The other end.
    pub b: Point,
}

impl Segment {
    /// The segment from `a` to `b`.
    pub const fn new(a: Point, b: Point) -> Self {
        Self { a, b }
    }

    /// Length, metres.
    pub fn length(&self) -> f64 {
        self.a.distance(self.b)
    }

    /// The point half way between the ends.
    pub fn midpoint(&self) -> Point {
        self.a.midpoint(self.b)
    }

    /// Angle of `b - a`, radians in (-pi, pi], counter-clockwise from the x axis.
    pub fn angle(&self) -> f64 {
        (self.b.y - self.a.y).atan2(self.b.x - self.a.x)
    }
}

impl From<[Point; 2]> for Segment {
    fn from([a, b]: [Point; 2]) -> Self {
        Self { a, b }
    }
}

impl From<Segment> for [Point; 2] {
    fn from(s: Segment) -> Self {
        [s.a, s.b]
    }
}

/// A polygon with holes. Rings are open (the first point is not repeated at the end);
/// the exterior runs counter-clockwise, the holes clockwise.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Polygon {
    /// The outer ring.
    #[schemars(length(min = 3))]
    pub exterior: Vec<Point>,
    /// The rings of the holes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[schemars(inner(length(min = 3)))]
    pub holes: Vec<Vec<Point>>,
}

impl Polygon {
    /// A polygon of these rings, each turned to its proper direction.
    ///
    /// ```
    /// # use planform_sdk::{Point, Polygon};
    /// let clockwise = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(Point::from).to_vec();
    /// let square = Polygon::new(clockwise, vec![]);
    /// assert_eq!(square.exterior[1], Point::new(1.0, 1.0).midpoint(Point::new(1.0, 1.0)));
    /// assert_eq!(square.area(), 1.0);
    /// ```
    pub fn new(mut exterior: Vec<Point>, mut holes: Vec<Vec<Point>>) -> Self {
        if ring_signed_area(&exterior) < 0.0 {
            exterior.reverse();
        }
        for hole in &mut holes {
            if ring_signed_area(hole) > 0.0 {
                hole.reverse();
            }
        }
        Self { exterior, holes }
    }

    /// Area without the holes, square metres.
    pub fn area(&self) -> f64 {
        let holes: f64 = self.holes.iter().map(|h| ring_signed_area(h).abs()).sum();
        ring_signed_area(&self.exterior).abs() - holes
    }

    /// The outer ring, then the holes.
    pub fn rings(&self) -> impl Iterator<Item = &[Point]> {
        std::iter::once(self.exterior.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }

    /// Whether the point lies inside, by the even-odd rule over all rings (Shimrat 1962). A point on a ring may
    /// fall on either side.
    pub fn contains(&self, p: Point) -> bool {
        self.rings().filter(|ring| ring_winds_around(ring, p)).count() % 2 == 1
    }
}

fn ring_winds_around(ring: &[Point], p: Point) -> bool {
    let mut inside = false;
    for (a, b) in edges(ring) {
        if (a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x {
            inside = !inside;
        }
    }
    inside
}

fn edges(ring: &[Point]) -> impl Iterator<Item = (Point, Point)> {
    ring.iter().copied().zip(ring.iter().copied().cycle().skip(1))
}

/// The smallest and the largest coordinates of the points, or `None` if there are none.
///
/// ```
/// # use planform_sdk::{Point, bounds};
/// let box_around = bounds([Point::new(1.0, 5.0), Point::new(3.0, 2.0)]);
/// assert_eq!(box_around, Some((Point::new(1.0, 2.0), Point::new(3.0, 5.0))));
/// ```
pub fn bounds(points: impl IntoIterator<Item = Point>) -> Option<(Point, Point)> {
    points.into_iter().fold(None, |bounds, p| {
        let (lo, hi) = bounds.unwrap_or((p, p));
        Some((Point::new(lo.x.min(p.x), lo.y.min(p.y)), Point::new(hi.x.max(p.x), hi.y.max(p.y))))
    })
}

/// Area of an open ring, square metres: positive when it runs counter-clockwise.
pub fn ring_signed_area(ring: &[Point]) -> f64 {
    let Some(&o) = ring.first() else { return 0.0 };
    // Relative to the first point: far from the origin the products would lose digits.
    edges(ring).map(|(a, b)| (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y)).sum::<f64>() / 2.0
}

/// A position and a heading: metres and radians.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Pose {
    /// To the right, metres.
    pub x: f64,
    /// Up, metres.
    pub y: f64,
    /// Radians, counter-clockwise from the x axis.
    pub yaw: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    #[test]
    fn area_is_without_holes() {
        let outer = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
        let hole = ring(&[[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]);
        let p = Polygon::new(outer, vec![hole]);
        assert_eq!(p.area(), 11.0);
        assert!(ring_signed_area(&p.holes[0]) < 0.0);
        assert!(p.contains(Point::new(0.5, 0.5)));
        assert!(!p.contains(Point::new(1.5, 1.5)));
    }

    #[test]
    fn area_keeps_its_digits_far_from_the_origin() {
        let far = ring(&[[1e9, 1e9], [1e9 + 1.0, 1e9], [1e9 + 1.0, 1e9 + 1.0], [1e9, 1e9 + 1.0]]);
        assert_eq!(ring_signed_area(&far), 1.0);
    }

    #[test]
    fn empty_ring_has_no_area() {
        assert_eq!(ring_signed_area(&[]), 0.0);
    }
}
