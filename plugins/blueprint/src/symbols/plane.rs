//! Ink at a coarser resolution, at which symbols of a known size are a handy number of pixels wide.

use crate::mask::Mask;

/// A mask in which every pixel stands for `factor * factor` pixels of the sheet, set where any of them is, so that thin
/// lines survive. Coordinates here are pixels of this mask; those of the sheet are `factor` times as large.
#[derive(Debug, Clone)]
pub struct Plane {
    /// What is set.
    pub mask: Mask,
    /// Pixels of the sheet for each pixel here.
    pub factor: u32,
}

/// Metres per pixel at most for what is drawn small: a line is then a few centimetres wide, and lines that run side by
/// side stay apart.
const CLOSE: f64 = 0.018;

/// A point or a vector: x to the right, y down.
pub type Vec2 = [f64; 2];

impl Plane {
    /// The ink with pixels of at most [`CLOSE`], which `pixel` metres of the sheet are merged to, and metres per pixel of
    /// the plane.
    pub fn close(ink: &Mask, pixel: f64) -> (Self, f64) {
        let factor = ((CLOSE / pixel).floor() as u32).max(1);
        (Self::new(ink, factor), pixel * f64::from(factor))
    }

    /// The ink, coarser by this factor.
    pub fn new(ink: &Mask, factor: u32) -> Self {
        if factor <= 1 {
            return Self { mask: ink.clone(), factor: 1 };
        }
        let mut mask = Mask::empty(ink.width.div_ceil(factor), ink.height.div_ceil(factor));
        let rows = ink.set.chunks_exact(ink.width.max(1) as usize);
        for (y, row) in rows.enumerate() {
            let start = y / factor as usize * mask.width as usize;
            for (to, from) in mask.set[start..].iter_mut().zip(row.chunks(factor as usize)) {
                *to |= from.contains(&true);
            }
        }
        Self { mask, factor }
    }

    /// Whether there is ink at this point.
    pub fn at(&self, [x, y]: Vec2) -> bool {
        self.mask.get(x.floor() as i64, y.floor() as i64)
    }

    /// Whether there is ink on the line through `p` along `across`, not further from `p` than `reach`.
    pub fn near(&self, p: Vec2, across: Vec2, reach: f64) -> bool {
        let steps = (reach * 1.5).ceil().max(1.0) as i32;
        (-steps..=steps).any(|i| self.at(moved(p, across, f64::from(i) / f64::from(steps) * reach)))
    }

    /// The share of the way from `from` to `to` along which there is ink, at most `reach` beside it.
    pub fn covered(&self, from: Vec2, to: Vec2, reach: f64) -> f64 {
        let (along, length) = direction(from, to);
        let steps = length.ceil().max(1.0) as u32;
        let across = [-along[1], along[0]];
        let at = |i: u32| moved(from, along, (f64::from(i) + 0.5) / f64::from(steps) * length);
        f64::from((0..steps).filter(|&i| self.near(at(i), across, reach)).count() as u32) / f64::from(steps)
    }
}

/// `p` moved by `by` along `along`.
pub fn moved(p: Vec2, along: Vec2, by: f64) -> Vec2 {
    [p[0] + along[0] * by, p[1] + along[1] * by]
}

/// The unit vector from one point to another, and their distance.
pub fn direction(from: Vec2, to: Vec2) -> (Vec2, f64) {
    let d = [to[0] - from[0], to[1] - from[1]];
    let length = d[0].hypot(d[1]);
    if length > 0.0 { ([d[0] / length, d[1] / length], length) } else { ([1.0, 0.0], 0.0) }
}

/// The distance of two points.
pub fn distance(a: Vec2, b: Vec2) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The scalar product.
pub fn dot(a: Vec2, b: Vec2) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The unit vector of an angle, radians clockwise as seen.
pub fn unit(angle: f64) -> Vec2 {
    [angle.cos(), angle.sin()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_lines_survive() {
        let mut ink = Mask::empty(10, 9);
        (0..10).for_each(|x| ink.set[4 * 10 + x] = true);
        let plane = Plane::new(&ink, 4);
        assert_eq!((plane.mask.width, plane.mask.height), (3, 3));
        assert_eq!(plane.covered([0.0, 1.5], [3.0, 1.5], 0.1), 1.0);
        assert_eq!(plane.covered([0.0, 0.4], [3.0, 0.4], 0.1), 0.0);
    }
}
