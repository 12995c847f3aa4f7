//! Edges of the obstacles: Canny, "A Computational Approach to Edge Detection", 1986.
//!
//! A derivative of Gaussian (the 5 x 5 Sobel kernel), suppression of what is no maximum across the edge, and
//! hysteresis between two thresholds. The map is thresholded first, so every wall shows its two faces as edges.

use super::raster::Mask;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Thresholds of the edge detector.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Edges {
    /// An edge goes on where the gradient is above this. Grey levels of 255 per cell, times the kernel's 48.
    pub low: f64,
    /// An edge begins where the gradient is above this. The same unit.
    pub high: f64,
}

impl Default for Edges {
    fn default() -> Self {
        Self { low: 90.0, high: 100.0 }
    }
}

/// Smoothing part of the kernel; its derivative part is [-1, -2, 0, 2, 1].
const SMOOTH: [i32; 5] = [1, 4, 6, 4, 1];
const DERIVE: [i32; 5] = [-1, -2, 0, 2, 1];

/// Tangent of 22.5 degrees: the border between the four directions across an edge.
const TAN_22_5: f64 = 0.414_213_562_373_095_03;

/// The edge cells of the obstacles.
pub fn detect(obstacles: &Mask, params: &Edges) -> Mask {
    let gradient = Gradient::of(obstacles);
    let maxima = gradient.maxima(params.low);
    hysteresis(obstacles, &maxima, &gradient, params.high)
}

struct Gradient {
    width: usize,
    height: usize,
    x: Vec<i32>,
    y: Vec<i32>,
}

impl Gradient {
    fn of(mask: &Mask) -> Self {
        let (width, height) = (mask.width(), mask.height());
        let grey: Vec<i32> = mask.bits().iter().map(|&b| if b { 0 } else { 255 }).collect();
        let x = convolve(&convolve(&grey, width, height, &DERIVE, true), width, height, &SMOOTH, false);
        let y = convolve(&convolve(&grey, width, height, &SMOOTH, true), width, height, &DERIVE, false);
        Self { width, height, x, y }
    }

    /// Length of the gradient in the L1 norm.
    fn magnitude(&self, column: i64, row: i64) -> i32 {
        let inside = (0..self.width as i64).contains(&column) && (0..self.height as i64).contains(&row);
        if !inside {
            return 0;
        }
        let i = row as usize * self.width + column as usize;
        self.x[i].abs() + self.y[i].abs()
    }

    fn maxima(&self, low: f64) -> Vec<bool> {
        (0..self.x.len()).map(|i| self.is_maximum(i, low)).collect()
    }

    /// Whether the gradient is above `low` and largest across the edge. Of two equal neighbours the one in the open
    /// gives way: an edge between two cells is marked once, on the obstacle's side whichever way the map lies.
    fn is_maximum(&self, i: usize, low: f64) -> bool {
        let (column, row) = ((i % self.width) as i64, (i / self.width) as i64);
        let here = self.magnitude(column, row);
        if f64::from(here) <= low {
            return false;
        }
        let (gx, gy) = (f64::from(self.x[i]), f64::from(self.y[i]));
        // The step towards the open, in one of the eight directions.
        let (sx, sy) = (gx.signum() as i64, gy.signum() as i64);
        let (dx, dy) = if gy.abs() < gx.abs() * TAN_22_5 {
            (sx, 0)
        } else if gx.abs() < gy.abs() * TAN_22_5 {
            (0, sy)
        } else {
            (sx, sy)
        };
        here > self.magnitude(column - dx, row - dy) && here >= self.magnitude(column + dx, row + dy)
    }
}

/// One pass of a separable convolution; the border cells are repeated outwards.
fn convolve(values: &[i32], width: usize, height: usize, kernel: &[i32; 5], along_rows: bool) -> Vec<i32> {
    let (stride, length) = if along_rows { (1, width) } else { (width, height) };
    let mut out = vec![0; values.len()];
    for (i, o) in out.iter_mut().enumerate() {
        let position = if along_rows { i % width } else { i / width };
        let base = i - position * stride;
        *o = (0..5)
            .map(|k| kernel[k] * values[base + (position + k).saturating_sub(2).min(length - 1) * stride])
            .sum();
    }
    out
}

/// The maxima that hang together with one above `high`.
fn hysteresis(mask: &Mask, maxima: &[bool], gradient: &Gradient, high: f64) -> Mask {
    let strong = |i: usize| {
        let (column, row) = ((i % mask.width()) as i64, (i / mask.width()) as i64);
        f64::from(gradient.magnitude(column, row)) > high
    };
    let candidates = mask.with_bits(maxima.to_vec());
    let components = candidates.components(true);
    let mut kept = vec![false; components.sizes.len()];
    for (i, &label) in components.label.iter().enumerate() {
        if maxima[i] && strong(i) {
            kept[label as usize] = true;
        }
    }
    let bits = components.label.iter().enumerate().map(|(i, &l)| maxima[i] && kept[l as usize]).collect();
    mask.with_bits(bits)
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;

    #[test]
    fn a_wall_shows_both_faces() {
        let rows = [
            "....................",
            "....................",
            "....................",
            "####################",
            "####################",
            "####################",
            "####################",
            "####################",
            "....................",
            "....................",
            "....................",
        ];
        let edges = detect(&mask(&rows), &Edges::default());
        let rows_with_edges: Vec<usize> = (0..rows.len()).filter(|&r| edges.get(10, r as i64)).collect();
        assert_eq!(rows_with_edges.len(), 2);
    }

    #[test]
    fn a_mirrored_map_has_mirrored_edges() {
        let rows = ["........", "..####..", "..######", "..##....", "..##..##", ".#....##", "........"];
        let mirrored: Vec<String> = rows.iter().map(|r| r.chars().rev().collect()).collect();
        let mirrored: Vec<&str> = mirrored.iter().map(String::as_str).collect();
        let (a, b) = (mask(&rows), mask(&mirrored));
        let (a, b) = (detect(&a, &Edges::default()), detect(&b, &Edges::default()));
        assert!(a.count() > 0);
        assert!(a.cells().all(|(c, r)| b.get(7 - c as i64, r as i64)) && a.count() == b.count());
    }

    #[test]
    fn nothing_has_no_edges() {
        let m = mask(&["....", "....", "...."]);
        assert_eq!(detect(&m, &Edges::default()).count(), 0);
    }

    #[test]
    fn a_single_cell_is_survived() {
        detect(&mask(&["#"]), &Edges::default());
    }
}
