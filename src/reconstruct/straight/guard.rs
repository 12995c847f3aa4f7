//! Whether a polygon may stand for a room's cells.

use super::trace::Cells;
use planform_sdk::{Point, Polygon};

/// The area, in cells, in which the polygon and the cells differ. Corners are metres.
pub fn difference(polygon: &Polygon, cells: &Cells, resolution: f64) -> usize {
    let inside = fill(polygon, cells, resolution);
    inside.iter().zip(cells.mask.bits()).filter(|(a, b)| a != b).count()
}

/// Which cells of the mask have their centre in the polygon; those outside of the mask are not counted.
fn fill(polygon: &Polygon, cells: &Cells, resolution: f64) -> Vec<bool> {
    let (width, height) = (cells.mask.width(), cells.mask.height());
    let local = |p: &Point| {
        (p.x / resolution - cells.corner.0 as f64 - 0.5, p.y / resolution - cells.corner.1 as f64 - 0.5)
    };
    let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); height];
    for ring in polygon.rings() {
        for (i, p) in ring.iter().enumerate() {
            let (a, b) = (local(p), local(&ring[(i + 1) % ring.len()]));
            let (low, high) = (a.1.min(b.1).ceil().max(0.0), a.1.max(b.1).ceil().min(height as f64));
            let rows = crossings.iter_mut().enumerate().take(high.max(0.0) as usize);
            for (row, xs) in rows.skip(low as usize) {
                xs.push(a.0 + (row as f64 - a.1) * (b.0 - a.0) / (b.1 - a.1));
            }
        }
    }
    let mut inside = vec![false; width * height];
    for (row, xs) in crossings.iter_mut().enumerate() {
        xs.sort_by(f64::total_cmp);
        for pair in xs.chunks_exact(2) {
            let column = |x: f64| (x.ceil().max(0.0) as usize).min(width);
            inside[row * width + column(pair[0])..row * width + column(pair[1])].fill(true);
        }
    }
    inside
}
