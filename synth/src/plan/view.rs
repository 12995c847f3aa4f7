//! From the sheet to the picture.
//!
//! Everything is laid out in the frame of the sheet: metres of the building at the plan's scale, x to the right, y up,
//! the origin at the sheet's lower left corner. The scanner then turns the sheet a little about its middle; what is
//! told as truth is in the frame of the turned picture, metres, with its origin at the picture's lower left corner.

use planform_sdk::{Point, Pose};
use tiny_skia::Transform;

/// How a sheet becomes a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    /// Columns of the picture.
    pub(super) width: u32,
    /// Rows of the picture.
    pub(super) height: u32,
    pub(super) dpi: f64,
    /// The plan is drawn at 1 to this.
    pub(super) denominator: f64,
    /// By this angle the sheet lies turned, radians counter-clockwise.
    pub(super) skew: f64,
}

impl View {
    pub(super) fn metres_per_pixel(&self) -> f64 {
        self.mm(25.4) / self.dpi
    }

    /// So many millimetres of paper, in metres of the building.
    pub(super) fn mm(&self, millimetres: f64) -> f64 {
        millimetres * self.denominator / 1000.0
    }

    /// Width and height of the sheet.
    pub(super) fn size(&self) -> (f64, f64) {
        let m = self.metres_per_pixel();
        (f64::from(self.width) * m, f64::from(self.height) * m)
    }

    /// A point of the sheet in the frame of the truth.
    pub(super) fn point(&self, p: Point) -> Point {
        let ((w, h), (sin, cos)) = (self.size(), self.skew.sin_cos());
        let (x, y) = (p.x - w / 2.0, p.y - h / 2.0);
        Point::new(w / 2.0 + cos * x - sin * y, h / 2.0 + sin * x + cos * y)
    }

    /// A pose on the sheet in the frame of the truth.
    pub(super) fn pose(&self, p: Point, yaw: f64) -> Pose {
        let Point { x, y } = self.point(p);
        Pose { x, y, yaw: yaw + self.skew }
    }

    /// From the sheet to pixels, y down.
    pub(super) fn transform(&self) -> Transform {
        let (o, x, y) = (
            self.pixel(Point::new(0.0, 0.0)),
            self.pixel(Point::new(1.0, 0.0)),
            self.pixel(Point::new(0.0, 1.0)),
        );
        let [a, b, c, d] = [x.0 - o.0, x.1 - o.1, y.0 - o.0, y.1 - o.1];
        Transform::from_row(a as f32, b as f32, c as f32, d as f32, o.0 as f32, o.1 as f32)
    }

    /// Column and row of a point of the sheet.
    pub(super) fn pixel(&self, p: Point) -> (f64, f64) {
        let (p, m) = (self.point(p), self.metres_per_pixel());
        (p.x / m, f64::from(self.height) - p.y / m)
    }
}
