//! Maps of the plane.

pub type Point = [f64; 2];

/// An affine map: x' = a x + c y + e, y' = b x + d y + f.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Map {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub d: f64,
    pub e: f64,
    pub f: f64,
}

impl Map {
    pub const SAME: Self = Self::scale(1.0, 1.0);

    pub const fn scale(x: f64, y: f64) -> Self {
        Self { a: x, b: 0.0, c: 0.0, d: y, e: 0.0, f: 0.0 }
    }

    pub const fn shift([x, y]: Point) -> Self {
        Self { a: 1.0, b: 0.0, c: 0.0, d: 1.0, e: x, f: y }
    }

    /// Counter-clockwise, radians.
    pub fn turn(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { a: cos, b: sin, c: -sin, d: cos, e: 0.0, f: 0.0 }
    }

    /// This map after the other one.
    pub fn after(self, first: Self) -> Self {
        let [a, b] = self.turned([first.a, first.b]);
        let [c, d] = self.turned([first.c, first.d]);
        let [e, f] = self.at([first.e, first.f]);
        Self { a, b, c, d, e, f }
    }

    pub fn at(self, p: Point) -> Point {
        let [x, y] = self.turned(p);
        [x + self.e, y + self.f]
    }

    /// Where a direction leads.
    pub fn turned(self, [x, y]: Point) -> Point {
        [self.a * x + self.c * y, self.b * x + self.d * y]
    }

    /// By how much lengths grow, on the mean.
    pub fn growth(self) -> f64 {
        (self.a * self.d - self.b * self.c).abs().sqrt()
    }
}

pub fn distance([ax, ay]: Point, [bx, by]: Point) -> f64 {
    (ax - bx).hypot(ay - by)
}
