//! From a layout's coordinates to the pixels of an image.

use super::error::bad;
use planform_sdk::{ErrorKind, PluginError, Point, Polygon, Pose};

/// In what a layout's coordinates are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Units {
    /// Metres in the map frame, y up.
    #[default]
    Metres,
    /// Pixels of the image, y down: pixel (column, row) covers [column, column + 1] x [row, row + 1].
    Pixels,
}

/// How coordinates become pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// What the coordinates are in.
    pub units: Units,
    /// Metres per pixel.
    pub resolution: f64,
    /// Where the outer corner of the image's lower left pixel lies in the map frame, and how the image is turned.
    pub origin: Pose,
}

impl Default for Frame {
    fn default() -> Self {
        Self { units: Units::Metres, resolution: 0.05, origin: Pose::default() }
    }
}

/// Farther from the image, in pixels, the pixels' centres could not be told apart.
const FARTHEST: f64 = 1e12;

impl Frame {
    /// Refuses a frame without a positive resolution and a finite origin.
    pub fn check(&self) -> Result<(), PluginError> {
        let refuse = |what| Err(PluginError::new(ErrorKind::BadOption, what));
        if !(self.resolution.is_finite() && self.resolution > 0.0) {
            return refuse(format!("the resolution cannot be {}; give metres per pixel", self.resolution));
        }
        let Pose { x, y, yaw } = self.origin;
        if ![x, y, yaw].iter().all(|v| v.is_finite()) {
            return refuse(format!("the origin cannot be {x},{y},{yaw}; give metres, metres, radians"));
        }
        Ok(())
    }

    /// The point in pixels of an image that is `height` pixels high, y down.
    pub fn to_pixels(&self, p: Point, height: f64) -> Point {
        match self.units {
            Units::Pixels => p,
            Units::Metres if self.origin.yaw == 0.0 => {
                let k = 1.0 / self.resolution;
                Point::new(k * p.x - self.origin.x * k, height - (k * p.y - self.origin.y * k))
            }
            Units::Metres => {
                let (sin, cos) = self.origin.yaw.sin_cos();
                let (x, y) = (p.x - self.origin.x, p.y - self.origin.y);
                let (u, v) = (x * cos + y * sin, y * cos - x * sin);
                Point::new(u / self.resolution, height - v / self.resolution)
            }
        }
    }

    /// The polygon in pixels, as [`Frame::to_pixels`].
    pub fn polygon_to_pixels(&self, polygon: &Polygon, height: f64) -> Result<Polygon, PluginError> {
        let ring = |ring: &[Point]| ring.iter().map(|&p| self.checked(p, height)).collect::<Result<_, _>>();
        let holes = polygon.holes.iter().map(|hole| ring(hole)).collect::<Result<_, _>>()?;
        Ok(Polygon { exterior: ring(&polygon.exterior)?, holes })
    }

    fn checked(&self, p: Point, height: f64) -> Result<Point, PluginError> {
        let pixel = self.to_pixels(p, height);
        let near = |v: f64| v.abs() <= FARTHEST;
        if near(pixel.x) && near(pixel.y) {
            return Ok(pixel);
        }
        Err(bad(format!("position [{:e}, {:e}] lies more than {FARTHEST:e} pixels from the map", p.x, p.y))
            .advise("check the units, the resolution and the origin"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metres_run_up_from_the_lower_left_corner() {
        let frame = Frame { resolution: 0.5, origin: Pose { x: -1.0, y: 2.0, yaw: 0.0 }, ..Frame::default() };
        assert_eq!(frame.to_pixels(Point::new(-1.0, 2.0), 80.0), Point::new(0.0, 80.0));
        assert_eq!(frame.to_pixels(Point::new(0.5, 3.0), 80.0), Point::new(3.0, 78.0));
    }

    #[test]
    fn a_turned_map_is_turned_back() {
        let yaw = std::f64::consts::FRAC_PI_2;
        let frame = Frame { resolution: 0.5, origin: Pose { x: 1.0, y: 1.0, yaw }, ..Frame::default() };
        let p = frame.to_pixels(Point::new(0.0, 3.0), 10.0);
        assert!(p.distance(Point::new(4.0, 8.0)) < 1e-12, "{p:?}");
    }

    #[test]
    fn pixels_stay() {
        let frame = Frame { units: Units::Pixels, ..Frame::default() };
        assert_eq!(frame.to_pixels(Point::new(3.0, 4.0), 80.0), Point::new(3.0, 4.0));
    }

    #[test]
    fn useless_frames_are_refused() {
        for resolution in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Frame { resolution, ..Frame::default() }.check().is_err());
        }
        let origin = Pose { yaw: f64::NAN, ..Pose::default() };
        assert!(Frame { origin, ..Frame::default() }.check().is_err());
        assert!(Frame::default().check().is_ok());
    }

    #[test]
    fn far_positions_are_refused() {
        for far in [1e300, -1e300, 1e12] {
            let square = Polygon { exterior: vec![Point::new(0.0, far)], holes: vec![] };
            assert!(Frame::default().polygon_to_pixels(&square, 1.0).is_err());
        }
    }
}
