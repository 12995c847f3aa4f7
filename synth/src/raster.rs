//! Draws a building into cells: the clean grid and the label image.

use crate::building::Building;
use planform_sdk::{Cell, Grid, GridError, Layout, Point, Pose, RoomId, Segment, Wall};

/// Unknown space around the building, metres.
const MARGIN: f64 = 2.0;

/// Where the cells of every picture of a building lie: its grids and its labels have the same frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub(crate) origin: Point,
    pub(crate) resolution: f64,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Frame {
    /// The frame around a layout; its origin is a multiple of the resolution.
    pub(crate) fn around(layout: &Layout, resolution: f64) -> Result<Self, GridError> {
        if !(resolution.is_finite() && resolution > 0.0) {
            return Err(GridError::Resolution(resolution));
        }
        let (lo, hi) = layout.bounds().unwrap_or_default();
        let cells = |metres: f64| metres / resolution;
        let (x, y) = (cells(lo.x - MARGIN).floor(), cells(lo.y - MARGIN).floor());
        let count =
            |from: f64, to: f64| (cells(to + MARGIN).ceil() - from).clamp(1.0, f64::from(u32::MAX)) as u32;
        let frame = Self {
            origin: Point::new(x * resolution, y * resolution),
            resolution,
            width: count(x, hi.x),
            height: count(y, hi.y),
        };
        Grid::check_size(frame.width, frame.height)?;
        Ok(frame)
    }

    pub(crate) fn len(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// From metres to cells.
    pub(crate) fn to_cells(self, p: Point) -> (f64, f64) {
        ((p.x - self.origin.x) / self.resolution, (p.y - self.origin.y) / self.resolution)
    }

    /// The index of the cell in this column and row, if it is in the frame.
    pub(crate) fn index(self, column: i64, row: i64) -> Option<usize> {
        let inside =
            (0..i64::from(self.width)).contains(&column) && (0..i64::from(self.height)).contains(&row);
        inside.then(|| row as usize * self.width as usize + column as usize)
    }

    pub(crate) fn grid(self, cells: Vec<Cell>) -> Result<Grid, GridError> {
        let origin = Pose { x: self.origin.x, y: self.origin.y, yaw: 0.0 };
        Grid::new(self.width, self.height, self.resolution, origin, cells)
    }

    /// Calls `set` with the index of every cell whose centre lies within the rings, by the even-odd rule.
    pub(crate) fn fill<'a>(self, rings: impl Iterator<Item = &'a [Point]>, mut set: impl FnMut(usize)) {
        let edges: Vec<[(f64, f64); 2]> = rings.flat_map(|ring| self.edges(ring)).collect();
        let ys = || edges.iter().flatten().map(|p| p.1);
        let (low, high) = (ys().fold(f64::MAX, f64::min), ys().fold(f64::MIN, f64::max));
        for row in low.floor().max(0.0) as i64..(high.ceil() as i64).min(i64::from(self.height)) {
            for span in crossings(&edges, row as f64 + 0.5).chunks_exact(2) {
                let (from, to) = ((span[0] - 0.5).ceil() as i64, (span[1] - 0.5).ceil() as i64);
                (from..to).filter_map(|column| self.index(column, row)).for_each(&mut set);
            }
        }
    }

    fn edges(self, ring: &[Point]) -> Vec<[(f64, f64); 2]> {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(&a, &b)| [self.to_cells(a), self.to_cells(b)]).collect()
    }
}

/// Where the edges cross the height `y`, from left to right.
fn crossings(edges: &[[(f64, f64); 2]], y: f64) -> Vec<f64> {
    let crossing = edges.iter().filter(|[a, b]| (a.1 > y) != (b.1 > y));
    let mut xs: Vec<f64> = crossing.map(|[a, b]| a.0 + (b.0 - a.0) * (y - a.1) / (b.1 - a.1)).collect();
    xs.sort_by(f64::total_cmp);
    xs
}

/// The rectangle `half` to both sides of a segment and `beyond` its ends.
pub(crate) fn band(s: &Segment, half: f64, beyond: f64) -> [Point; 4] {
    let length = s.length().max(1e-9);
    let (ux, uy) = ((s.b.x - s.a.x) / length, (s.b.y - s.a.y) / length);
    let at = |p: Point, along: f64, left: f64| {
        Point::new(p.x + ux * along - uy * left, p.y + uy * along + ux * left)
    };
    [at(s.a, -beyond, -half), at(s.b, beyond, -half), at(s.b, beyond, half), at(s.a, -beyond, half)]
}

/// Which outline of a room a label covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Outline {
    /// Up to the middle of the walls: neighbours touch.
    #[default]
    Centre,
    /// Up to the inner faces of the walls.
    Inner,
}

/// The room of every cell, row by row from the bottom, 0 where there is none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Labels {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The cells.
    pub rooms: Vec<RoomId>,
}

impl Labels {
    /// The labels that belong to a grid [made smaller](crate::shrunk) by the factor.
    pub fn shrunk(&self, factor: u32) -> Self {
        let factor = factor.max(1);
        let (width, height) = (self.width / factor, self.height / factor);
        let middle = |i: u32| (i * factor + factor / 2) as usize;
        let cell = |row: u32, column: u32| self.rooms[middle(row) * self.width as usize + middle(column)];
        let rooms = (0..height).flat_map(|row| (0..width).map(move |column| cell(row, column))).collect();
        Self { width, height, rooms }
    }
}

impl Building {
    /// The exact raster, `resolution` in metres per cell: floor and open doors free, walls occupied, all else
    /// unknown. A cell is what its centre is.
    ///
    /// # Errors
    /// When the resolution is not a positive number or makes more than [`planform_sdk::MAX_CELLS`] cells.
    pub fn clean_grid(&self, resolution: f64) -> Result<Grid, GridError> {
        let frame = Frame::around(self.layout(), resolution)?;
        let mut cells = vec![Cell::UNKNOWN; frame.len()];
        let is_outer = |w: &&Wall| w.rooms.contains(&None);
        for wall in self.layout().walls.iter().filter(is_outer) {
            let body = band(&wall.line, wall.thickness / 2.0, wall.thickness / 2.0);
            frame.fill([body.as_slice()].into_iter(), |i| cells[i] = Cell::OCCUPIED);
        }
        for room in &self.layout().rooms {
            frame.fill(room.centre.rings(), |i| cells[i] = Cell::OCCUPIED);
        }
        for room in &self.layout().rooms {
            frame.fill(room.inner.rings(), |i| cells[i] = Cell::FREE);
        }
        for (opening, depth) in self.openings() {
            let gap = band(&opening.segment, depth / 2.0, 0.0);
            frame.fill([gap.as_slice()].into_iter(), |i| cells[i] = Cell::FREE);
        }
        for solid in self.solids() {
            frame.fill(solid.rings(), |i| cells[i] = Cell::OCCUPIED);
        }
        frame.grid(cells)
    }

    /// The room of every cell, in the same frame as [`Building::clean_grid`].
    ///
    /// # Errors
    /// As for [`Building::clean_grid`].
    pub fn labels(&self, resolution: f64, outline: Outline) -> Result<Labels, GridError> {
        let frame = Frame::around(self.layout(), resolution)?;
        let mut rooms = vec![0; frame.len()];
        for room in &self.layout().rooms {
            let polygon = match outline {
                Outline::Centre => &room.centre,
                Outline::Inner => &room.inner,
            };
            frame.fill(polygon.rings(), |i| rooms[i] = room.id);
        }
        Ok(Labels { width: frame.width, height: frame.height, rooms })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::two_rooms;

    #[test]
    fn clean_grid_is_exact_to_the_cell() {
        let grid = two_rooms().clean_grid(0.05).unwrap();
        let count = |cell| grid.cells().iter().filter(|&&c| c == cell).count();
        let door = 20 * 4;
        assert_eq!(count(Cell::FREE), 2 * 76 * 96 + door);
        assert_eq!(count(Cell::OCCUPIED), 164 * 104 - 2 * 76 * 96 - door);
    }

    #[test]
    fn grid_lies_in_the_map_frame() {
        let grid = two_rooms().clean_grid(0.05).unwrap();
        let at = |x, y| {
            let p = grid.to_cells(Point::new(x, y));
            grid.cell(p.x.floor() as i64, p.y.floor() as i64)
        };
        assert_eq!(at(0.12, 0.12), Cell::FREE);
        assert_eq!(at(0.08, 0.12), Cell::OCCUPIED);
        assert_eq!(at(-0.12, 2.0), Cell::UNKNOWN);
        assert_eq!(at(4.0, 2.5), Cell::FREE);
        assert_eq!(at(4.0, 1.0), Cell::OCCUPIED);
    }

    #[test]
    fn labels_touch_at_the_middle_of_the_wall() {
        let labels = two_rooms().labels(0.05, Outline::Centre).unwrap();
        let count = |room| labels.rooms.iter().filter(|&&r| r == room).count();
        assert_eq!((count(1), count(2)), (80 * 100, 80 * 100));
        let inner = two_rooms().labels(0.05, Outline::Inner).unwrap();
        assert_eq!(inner.rooms.iter().filter(|&&r| r == 1).count(), 76 * 96);
    }

    #[test]
    fn refuses_a_resolution_that_makes_no_grid() {
        assert!(matches!(two_rooms().clean_grid(0.0), Err(GridError::Resolution(_))));
        assert!(matches!(two_rooms().clean_grid(f64::NAN), Err(GridError::Resolution(_))));
        assert!(matches!(two_rooms().clean_grid(1e-6), Err(GridError::TooLarge { .. })));
    }
}
