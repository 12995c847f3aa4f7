//! Where the map's cells lie.

use planform_sdk::{Document, ErrorKind, Grid, Layout, PluginError, Point, Pose};

/// Metres per cell of a layout that does not come with its grid.
const RESOLUTION: f64 = 0.05;

/// Unknown space around a layout that does not come with its grid, metres.
const MARGIN: f64 = 1.0;

/// The place of a map's cells in the map frame, as that of a [`Grid`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Metres per cell.
    pub resolution: f64,
    /// Pose of the lower left corner of the lower left cell.
    pub origin: Pose,
}

impl Frame {
    /// The frame of the document's grid, in cells of this many metres if given; without a grid, one around the layout.
    pub fn of(document: &Document<'_>, resolution: Option<f64>) -> Result<Self, PluginError> {
        match document.scene {
            Some(scene) => Self::of_grid(&scene.grid, resolution.unwrap_or(scene.grid.resolution())),
            None => Self::around(document.layout, resolution.unwrap_or(RESOLUTION)),
        }
    }

    fn of_grid(grid: &Grid, resolution: f64) -> Result<Self, PluginError> {
        if resolution == grid.resolution() {
            let (width, height) = (grid.width(), grid.height());
            return Ok(Self { width, height, resolution, origin: grid.origin() });
        }
        let metres = |cells: u32| f64::from(cells) * grid.resolution();
        Self::sized(metres(grid.width()), metres(grid.height()), resolution, grid.origin())
    }

    fn around(layout: &Layout, resolution: f64) -> Result<Self, PluginError> {
        let (low, high) = layout.bounds().unwrap_or_default();
        let (low, high) = (low.finite()?, high.finite()?);
        // On whole cells, so that layouts of one building have the same cells.
        let whole = |v: f64| ((v - MARGIN) / resolution).floor() * resolution;
        let origin = Pose { x: whole(low.x), y: whole(low.y), yaw: 0.0 };
        Self::sized(high.x + MARGIN - origin.x, high.y + MARGIN - origin.y, resolution, origin)
    }

    /// A frame of so many metres, in as many cells as cover them.
    fn sized(width: f64, height: f64, resolution: f64, origin: Pose) -> Result<Self, PluginError> {
        // The sizes are quotients: a hair above a whole number is that number.
        let cells = |metres: f64| (metres / resolution - 1e-6).ceil().max(1.0) as u32;
        let (width, height) = (cells(width), cells(height));
        let checked = Grid::check_size(width, height);
        checked.map_err(|e| {
            let message = format!("at {resolution} m per cell, {e}");
            PluginError::new(ErrorKind::Limit, message).advise("set the option resolution to more metres")
        })?;
        Ok(Self { width, height, resolution, origin })
    }

    /// From metres in the map frame to cell coordinates.
    pub fn to_cells(self, p: Point) -> Point {
        let (sin, cos) = self.origin.yaw.sin_cos();
        let (x, y) = (p.x - self.origin.x, p.y - self.origin.y);
        Point::new((cos * x + sin * y) / self.resolution, (cos * y - sin * x) / self.resolution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Cell, Provenance, Scene};

    fn scene() -> Scene {
        let origin = Pose { x: -3.0, y: 2.5, yaw: 0.4 };
        let grid = Grid::new(30, 20, 0.05, origin, vec![Cell::UNKNOWN; 600]).unwrap();
        Scene::of_grid(grid, Provenance::default())
    }

    fn frame(resolution: Option<f64>) -> Result<Frame, PluginError> {
        let (layout, scene) = (Layout::default(), scene());
        Frame::of(&Document { layout: &layout, scene: Some(&scene) }, resolution)
    }

    #[test]
    fn cells_are_those_of_the_grid() {
        let (frame, grid) = (frame(None).unwrap(), scene().grid);
        assert_eq!((frame.width, frame.height, frame.resolution), (30, 20, 0.05));
        let p = Point::new(1.0, -7.0);
        assert_eq!((frame.origin, frame.to_cells(p)), (grid.origin(), grid.to_cells(p)));
    }

    #[test]
    fn other_cells_cover_the_grid() {
        let sides = |r| frame(Some(r)).map(|f| (f.width, f.height)).unwrap();
        assert_eq!([sides(0.1), sides(0.07), sides(0.025)], [(15, 10), (22, 15), (60, 40)]);
        assert_eq!(frame(Some(1e-6)).unwrap_err().kind, ErrorKind::Limit);
        assert_eq!(frame(Some(1e-300)).unwrap_err().kind, ErrorKind::Limit);
    }

    #[test]
    fn a_layout_alone_gets_a_margin() {
        let layout = Layout::default();
        let frame = Frame::of(&Document { layout: &layout, scene: None }, None).unwrap();
        assert_eq!((frame.width, frame.height, frame.origin.x), (40, 40, -1.0));
    }
}
