//! The straight line that carries a piece of an outline.

use planform_sdk::{Point, Segment};

/// A directed line: the points p with `p.y * cos(angle) - p.x * sin(angle) = offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carrier {
    /// Radians.
    pub angle: f64,
    /// Signed distance from the origin, metres.
    pub offset: f64,
    sin: f64,
    cos: f64,
}

impl Carrier {
    /// The line of this angle at this distance from the origin.
    pub fn new(angle: f64, offset: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { angle, offset, sin, cos }
    }

    /// The line through a point.
    pub fn through(p: Point, angle: f64) -> Self {
        let line = Self::new(angle, 0.0);
        line.moved(line.side(p))
    }

    /// The line moved to the left, metres.
    pub fn moved(self, left: f64) -> Self {
        Self { offset: self.offset + left, ..self }
    }

    /// The line of a segment.
    pub fn of(s: &Segment) -> Self {
        Self::through(s.midpoint(), s.angle())
    }

    /// Signed distance of a point, positive to the left, metres.
    pub fn side(&self, p: Point) -> f64 {
        p.y * self.cos - p.x * self.sin - self.offset
    }

    /// Position of a point's projection, metres.
    pub fn along(&self, p: Point) -> f64 {
        p.x * self.cos + p.y * self.sin
    }

    /// The point at this position, moved to the left, metres.
    pub fn point(&self, along: f64, left: f64) -> Point {
        let left = self.offset + left;
        Point::new(along * self.cos - left * self.sin, along * self.sin + left * self.cos)
    }

    /// The nearest point on the line.
    pub fn project(&self, p: Point) -> Point {
        self.point(self.along(p), 0.0)
    }

    /// Where two lines meet that are not nearly parallel.
    pub fn meet(&self, other: &Self) -> Option<Point> {
        let cross = (other.angle - self.angle).sin();
        if cross.abs() < PARALLEL {
            return None;
        }
        let foot = self.point(0.0, 0.0);
        // Going along self by t changes the distance from the other line by -t * cross.
        Some(self.point(other.side(foot) / cross, 0.0))
    }
}

/// Lines whose angles' sine is less meet too far away.
const PARALLEL: f64 = 0.1;
