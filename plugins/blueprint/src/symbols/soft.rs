//! A picture of how much: one number from 0 to 1 for every pixel.

/// Row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Soft {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` numbers.
    pub values: Vec<f32>,
}

impl Soft {
    /// A picture of this size, each pixel by its column and row.
    pub fn from_fn(width: u32, height: u32, f: impl Fn(u32, u32) -> f32) -> Self {
        let values =
            (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| f(x, y)).collect();
        Self { width, height, values }
    }

    /// The number of a pixel; 0 outside.
    pub fn get(&self, x: i64, y: i64) -> f32 {
        let inside = x >= 0 && y >= 0 && x < i64::from(self.width) && y < i64::from(self.height);
        if inside { self.values[y as usize * self.width as usize + x as usize] } else { 0.0 }
    }

    /// The number between pixels, interpolated; pixel centres lie at halves.
    pub fn at(&self, x: f64, y: f64) -> f32 {
        let (x, y) = (x - 0.5, y - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let (fx, fy) = ((x - left) as f32, (y - top) as f32);
        let (i, j) = (left as i64, top as i64);
        let row = |j| self.get(i, j) * (1.0 - fx) + self.get(i + 1, j) * fx;
        row(j) * (1.0 - fy) + row(j + 1) * fy
    }

    /// The mean over a rectangle, of up to `16` samples in each direction.
    pub fn mean(&self, x: f64, y: f64, width: f64, height: f64) -> f32 {
        let steps = |length: f64| (length.ceil().max(1.0) as u32).min(16);
        let (nx, ny) = (steps(width), steps(height));
        let at = |i: u32, n: u32, length: f64| (f64::from(i) + 0.5) / f64::from(n) * length;
        let samples = (0..ny).flat_map(|j| (0..nx).map(move |i| (i, j)));
        let sum: f32 = samples.map(|(i, j)| self.at(x + at(i, nx, width), y + at(j, ny, height))).sum();
        sum / (nx * ny) as f32
    }

    /// The same at another size.
    pub fn resized(&self, width: u32, height: u32) -> Self {
        let (sx, sy) = (f64::from(self.width) / f64::from(width), f64::from(self.height) / f64::from(height));
        Self::from_fn(width, height, |x, y| self.mean(f64::from(x) * sx, f64::from(y) * sy, sx, sy))
    }

    /// Turned by `quarters` of a full turn, clockwise as seen.
    pub fn turned(&self, quarters: u32) -> Self {
        let (w, h) = (self.width, self.height);
        let get = |x: u32, y: u32| self.get(i64::from(x), i64::from(y));
        match quarters % 4 {
            0 => self.clone(),
            1 => Self::from_fn(h, w, |x, y| get(y, h - 1 - x)),
            2 => Self::from_fn(w, h, |x, y| get(w - 1 - x, h - 1 - y)),
            _ => Self::from_fn(h, w, |x, y| get(w - 1 - y, x)),
        }
    }

    /// Turned by any angle, radians clockwise as seen, and as large as it then has to be.
    pub fn rotated(&self, angle: f64) -> Self {
        let (w, h) = (f64::from(self.width), f64::from(self.height));
        let (s, c) = angle.sin_cos();
        let whole = |length: f64| (length - 1e-6).ceil().max(1.0);
        let (nw, nh) = (whole(w * c.abs() + h * s.abs()), whole(w * s.abs() + h * c.abs()));
        let source = |x: f64, y: f64| (c * x + s * y + w / 2.0, c * y - s * x + h / 2.0);
        Self::from_fn(nw as u32, nh as u32, |x, y| {
            let (x, y) = source(f64::from(x) + 0.5 - nw / 2.0, f64::from(y) + 0.5 - nh / 2.0);
            self.at(x, y)
        })
    }

    /// As in a mirror, left for right.
    pub fn mirrored(&self) -> Self {
        Self::from_fn(self.width, self.height, |x, y| self.get(i64::from(self.width - 1 - x), i64::from(y)))
    }

    /// With a margin of nothing all around.
    pub fn padded(&self, margin: u32) -> Self {
        let get =
            |x: u32, y: u32| self.get(i64::from(x) - i64::from(margin), i64::from(y) - i64::from(margin));
        Self::from_fn(self.width + 2 * margin, self.height + 2 * margin, get)
    }

    /// Smoothed by a box of three by three, so that thin lines may lie a pixel beside each other.
    pub fn blurred(&self) -> Self {
        Self::from_fn(self.width, self.height, |x, y| {
            let (x, y) = (i64::from(x), i64::from(y));
            let row = |j: i64| (-1..=1).map(|i| self.get(x + i, y + j)).sum::<f32>();
            (row(-1) + row(0) + row(1)) / 9.0
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_clockwise() {
        let row = Soft { width: 2, height: 1, values: vec![1.0, 2.0] };
        assert_eq!(row.turned(1), Soft { width: 1, height: 2, values: vec![1.0, 2.0] });
        assert_eq!(row.turned(2).values, [2.0, 1.0]);
        assert_eq!(row.turned(3).values, [2.0, 1.0]);
        let free = row.rotated(std::f64::consts::FRAC_PI_2);
        assert!((free.get(0, 0) - 1.0).abs() < 0.01 && (free.get(0, 1) - 2.0).abs() < 0.01, "{free:?}");
    }

    #[test]
    fn resizing_keeps_the_mean() {
        let s = Soft::from_fn(8, 8, |x, _| if x < 4 { 1.0 } else { 0.0 });
        assert_eq!(s.resized(2, 2).values, [1.0, 0.0, 1.0, 0.0]);
    }
}
