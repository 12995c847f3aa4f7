//! Points to the millimetre: what is nearer than that is the same.

use planform_sdk::{ErrorKind, PluginError, Point, Segment};

/// Millimetres in a metre.
const UNIT: f64 = 1000.0;

/// The farthest that a point may lie from the map's origin, metres; products of grains stay far from overflow.
const FARTHEST: f64 = 2e7;

/// A point of the map frame in whole millimetres.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Grain {
    /// To the right.
    pub x: i64,
    /// Up.
    pub y: i64,
}

impl Grain {
    /// The grain of a point.
    pub fn of(p: Point) -> Result<Self, PluginError> {
        let p = p.finite()?;
        if p.x.abs().max(p.y.abs()) > FARTHEST {
            let message = format!("the point ({}, {}) is farther away than the Earth is wide", p.x, p.y);
            return Err(PluginError::new(ErrorKind::BadInput, message).advise("correct the layout"));
        }
        Ok(Self { x: (p.x * UNIT).round() as i64, y: (p.y * UNIT).round() as i64 })
    }

    /// Where it lies, metres.
    pub fn point(self) -> Point {
        Point::new(self.x as f64 / UNIT, self.y as f64 / UNIT)
    }

    /// How far along the segment the foot of the perpendicular lies, millimetres from `a`; and how far off the grain
    /// is from the segment's line. `None` for a segment without length.
    pub fn beside(self, a: Self, b: Self) -> Option<(f64, f64)> {
        let (dx, dy) = (b.x as f64 - a.x as f64, b.y as f64 - a.y as f64);
        let (px, py) = (self.x as f64 - a.x as f64, self.y as f64 - a.y as f64);
        let length = dx.hypot(dy);
        (length > 0.0).then(|| ((px * dx + py * dy) / length, ((px * dy - py * dx) / length).abs()))
    }
}

/// The grains of a line's ends.
pub fn ends(segment: &Segment) -> Result<[Grain; 2], PluginError> {
    Ok([Grain::of(segment.a)?, Grain::of(segment.b)?])
}
