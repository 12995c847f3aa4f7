//! Pictures of what was found, one pixel for each cell, for whoever wants to see them.

use crate::log::{Pose, Scan};
use planform_sdk::{Cell, Grid, Picture, Point, ReadWatcher};

type Rgb = [u8; 3];

/// Of cells of which nothing is known.
const UNKNOWN: Rgb = [130, 160, 200];
const PAPER: Rgb = [255; 3];
const ECHO: Rgb = [0; 3];
/// Of the ways that the laser went.
const WAY: Rgb = [220, 30, 30];

/// A picture that is painted.
struct Canvas<'a> {
    grid: &'a Grid,
    rgb: Vec<u8>,
}

impl<'a> Canvas<'a> {
    fn new(grid: &'a Grid, colour: impl Fn(Cell) -> Rgb) -> Self {
        let rows = grid.cells().chunks(grid.width() as usize).rev();
        Self { grid, rgb: rows.flatten().flat_map(|cell| colour(*cell)).collect() }
    }

    fn dot(&mut self, x: f64, y: f64, colour: Rgb) {
        let cell = self.grid.to_cells(Point::new(x, y));
        let (column, row) = (cell.x.floor(), f64::from(self.grid.height()) - 1.0 - cell.y.floor());
        let inside = column >= 0.0 && column < f64::from(self.grid.width()) && row >= 0.0;
        let at = (row * f64::from(self.grid.width()) + column) as usize * 3;
        if let Some(pixel) = self.rgb.get_mut(at..at + 3).filter(|_| inside) {
            pixel.copy_from_slice(&colour);
        }
    }

    fn show(&self, name: &str, watcher: &mut dyn ReadWatcher) {
        watcher.stage(name, Picture::new(self.grid.width(), self.grid.height(), &self.rgb));
    }
}

/// Shows where echoes came from, and the ways of the laser.
pub fn scans(scans: &[Scan], poses: &[Pose], reach: f64, grid: &Grid, watcher: &mut dyn ReadWatcher) {
    if !watcher.wants_pictures() {
        return watcher.stage("scans", None);
    }
    let mut canvas = Canvas::new(grid, |_| PAPER);
    for (scan, pose) in scans.iter().zip(poses) {
        for (angle, range) in scan.beams().filter(|(_, r)| scan.is_echo(*r) && f64::from(*r) <= reach) {
            let (sin, cos) = (pose.theta + angle).sin_cos();
            canvas.dot(pose.x + f64::from(range) * cos, pose.y + f64::from(range) * sin, ECHO);
        }
    }
    poses.iter().for_each(|pose| canvas.dot(pose.x, pose.y, WAY));
    canvas.show("scans", watcher);
}

/// Shows the grid: the darker the more occupied.
pub fn grid(grid: &Grid, watcher: &mut dyn ReadWatcher) {
    if !watcher.wants_pictures() {
        return watcher.stage("grid", None);
    }
    Canvas::new(grid, colour).show("grid", watcher);
}

/// Every occupancy has a grey of its own.
fn colour(cell: Cell) -> Rgb {
    cell.occupancy().map_or(UNKNOWN, |percent| [255 - (u16::from(percent) * 255 / 100) as u8; 3])
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose as MapPose;

    #[test]
    fn row_0_is_at_the_bottom() {
        let cells = vec![Cell::FREE, Cell::OCCUPIED, Cell::UNKNOWN, Cell::percent(50)];
        let grid = Grid::new(2, 2, 0.5, MapPose { x: -1.0, y: 2.0, yaw: 0.0 }, cells).unwrap();
        let mut canvas = Canvas::new(&grid, colour);
        assert_eq!(canvas.rgb, [UNKNOWN, [128; 3], [255; 3], [0; 3]].concat());
        canvas.dot(-0.9, 2.9, WAY);
        canvas.dot(-0.1, 2.1, ECHO);
        canvas.dot(-1.1, 2.1, WAY);
        canvas.dot(0.1, 2.9, WAY);
        assert_eq!(canvas.rgb, [WAY, [128; 3], [255; 3], ECHO].concat());
    }
}
