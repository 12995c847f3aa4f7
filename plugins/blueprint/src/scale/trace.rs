//! Straight lines of ink along a direction, as dimension lines and scale bars are.

use crate::mask::Mask;

/// A frame on the sheet: a point, and a direction of length 1 with what lies across it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// The point.
    pub at: [f64; 2],
    /// The direction.
    pub along: [f64; 2],
}

impl Ray {
    /// The frame at this point in the direction of this angle, radians clockwise as seen.
    pub fn new(at: [f64; 2], angle: f64) -> Self {
        Self { at, along: [angle.cos(), angle.sin()] }
    }

    /// The sheet's point at `s` along the direction and `t` across it (to its right as seen).
    pub fn point(&self, s: f64, t: f64) -> [f64; 2] {
        let ([x, y], [c, n]) = (self.at, self.along);
        [x + s * c - t * n, y + s * n + t * c]
    }

    /// Where a point lies: along, across.
    pub fn local(&self, p: [f64; 2]) -> [f64; 2] {
        let ([x, y], [c, n]) = (self.at, self.along);
        let (dx, dy) = (p[0] - x, p[1] - y);
        [dx * c + dy * n, dy * c - dx * n]
    }

    /// Whether there is ink at this place.
    pub fn ink(&self, ink: &Mask, s: f64, t: f64) -> bool {
        let [x, y] = self.point(s, t);
        ink.get(x.floor() as i64, y.floor() as i64)
    }

    /// The line of ink through `s = 0` at `t`: its first and last place. Gaps of up to `gap` pixels are stepped over, and
    /// whatever is missing within `hidden` of the middle, where a text may interrupt it. Nothing if there is none.
    pub fn run(&self, ink: &Mask, t: f64, gap: f64, hidden: f64) -> Option<[f64; 2]> {
        let forth = self.end(ink, t, gap, hidden, 1.0)?;
        let back = self.end(ink, t, gap, hidden, -1.0)?;
        Some([back, forth])
    }

    fn end(&self, ink: &Mask, t: f64, gap: f64, hidden: f64, sign: f64) -> Option<f64> {
        let longest = f64::from(ink.width).hypot(f64::from(ink.height));
        let mut last = None;
        let mut s = 0.0;
        while s < longest && s - last.unwrap_or(hidden) <= gap.max(if last.is_none() { 1.0 } else { 0.0 }) {
            if self.ink(ink, sign * s, t) {
                last = Some(s);
            }
            s += 1.0;
        }
        last.filter(|&l| l >= hidden.min(1.0)).map(|l| sign * (l + 0.5))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(from: u32, to: u32) -> Mask {
        let mut ink = Mask::empty(200, 20);
        (from..to).for_each(|x| ink.set[10 * 200 + x as usize] = true);
        ink
    }

    #[test]
    fn a_run_ends_where_the_ink_does() {
        let ray = Ray::new([100.0, 8.5], 0.0);
        let [a, b] = ray.run(&line(40, 161), 2.0, 2.0, 0.0).unwrap();
        assert!((a + 60.0).abs() < 1.5 && (b - 60.0).abs() < 1.5, "{a} {b}");
        assert_eq!(ray.run(&line(40, 161), 5.0, 2.0, 0.0), None);
    }

    #[test]
    fn places_and_points_are_inverse() {
        let ray = Ray::new([3.0, 4.0], 1.1);
        let [s, t] = ray.local(ray.point(7.0, -2.0));
        assert!((s - 7.0).abs() < 1e-9 && (t + 2.0).abs() < 1e-9);
    }

    #[test]
    fn a_text_may_interrupt_the_line() {
        let mut ink = line(20, 181);
        (80..121).for_each(|x| ink.set[10 * 200 + x] = false);
        let [a, b] = Ray::new([100.0, 10.5], 0.0).run(&ink, 0.0, 2.0, 25.0).unwrap();
        assert!((a + 80.0).abs() < 1.5 && (b - 80.0).abs() < 1.5, "{a} {b}");
    }
}
