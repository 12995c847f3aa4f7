//! The straight line that carries a piece of an outline.

use super::super::collinear::offset;
use planform_sdk::{Point, Segment};

/// A directed line: the points p with `p.y * cos(angle) - p.x * sin(angle) = offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carrier {
    /// Radians.
    pub angle: f64,
    /// Signed distance from the origin, metres.
    pub offset: f64,
}

impl Carrier {
    /// The line through a point.
    pub fn through(p: Point, angle: f64) -> Self {
        Self { angle, offset: offset(p, angle) }
    }

    /// The line of a segment.
    pub fn of(s: &Segment) -> Self {
        Self::through(s.midpoint(), s.angle())
    }

    /// Signed distance of a point, positive to the left, metres.
    pub fn side(&self, p: Point) -> f64 {
        offset(p, self.angle) - self.offset
    }

    /// Position of a point's projection, metres.
    pub fn along(&self, p: Point) -> f64 {
        p.x * self.angle.cos() + p.y * self.angle.sin()
    }

    /// The point at this position, moved to the left, metres.
    pub fn point(&self, along: f64, left: f64) -> Point {
        let (sin, cos) = self.angle.sin_cos();
        let left = self.offset + left;
        Point::new(along * cos - left * sin, along * sin + left * cos)
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
