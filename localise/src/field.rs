//! The map as a likelihood field.

use planform_sdk::{Cell, Grid, Point};

/// A cell is a wall from this occupancy, percent.
const WALL: u8 = 65;

/// A cell is floor up to this occupancy, percent.
const FLOOR: u8 = 25;

/// For every cell of a map the distance to the nearest wall (Probabilistic Robotics, 6.4).
pub struct Field {
    grid: Grid,
    /// Metres, at most `most`; row by row from the bottom.
    distances: Vec<f32>,
    most: f32,
    floor: Vec<u32>,
}

impl Field {
    /// The field of a map; distances above `most` metres count as that.
    pub fn new(grid: Grid, most: f64) -> Self {
        let wall = |cell: &Cell| cell.occupancy().is_some_and(|percent| percent >= WALL);
        let (width, height) = (grid.width() as usize, grid.height() as usize);
        let squares = squared_distances(grid.cells().iter().map(wall), width, height);
        let metres = |squared: f32| squared.sqrt() * grid.resolution() as f32;
        let distances = squares.into_iter().map(|s| metres(s).min(most as f32)).collect();
        let is_floor = |cell: &Cell| cell.occupancy().is_some_and(|percent| percent <= FLOOR);
        let floor = (0..).zip(grid.cells()).filter(|(_, cell)| is_floor(cell)).map(|(i, _)| i).collect();
        Self { grid, distances, most: most as f32, floor }
    }

    /// The map itself.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Metres from a point of the map frame to the nearest wall.
    pub fn distance(&self, p: Point) -> f32 {
        let cell = self.grid.to_cells(p);
        let (column, row) = (cell.x.floor(), cell.y.floor());
        let (width, height) = (f64::from(self.grid.width()), f64::from(self.grid.height()));
        if !(0.0..width).contains(&column) || !(0.0..height).contains(&row) {
            return self.most;
        }
        self.distances[row as usize * self.grid.width() as usize + column as usize]
    }

    /// How many cells are floor.
    pub fn floor_cells(&self) -> usize {
        self.floor.len()
    }

    /// A point in the floor cell of this number, at these shares of its sides, in the map frame.
    pub fn on_floor(&self, number: usize, [x, y]: [f64; 2]) -> Option<Point> {
        let (cell, width) = (*self.floor.get(number)?, self.grid.width());
        let (column, row) = (f64::from(cell % width), f64::from(cell / width));
        Some(self.grid.to_map(Point::new(column + x, row + y)))
    }
}

/// For every cell the squared distance to the nearest that is set, in cells; infinite if none is (Felzenszwalb and
/// Huttenlocher, "Distance transforms of sampled functions", 2012).
fn squared_distances(set: impl Iterator<Item = bool>, width: usize, height: usize) -> Vec<f32> {
    let mut values: Vec<f32> = set.map(|s| if s { 0.0 } else { f32::INFINITY }).collect();
    for column in 0..width {
        let line: Vec<f32> = (0..height).map(|row| values[row * width + column]).collect();
        for (row, value) in transformed(&line).into_iter().enumerate() {
            values[row * width + column] = value;
        }
    }
    for row in values.chunks_exact_mut(width) {
        let line = transformed(row);
        row.copy_from_slice(&line);
    }
    values
}

/// The lower envelope of the parabolas that stand on a line of values.
fn transformed(line: &[f32]) -> Vec<f32> {
    let crossing = |p: usize, q: usize| {
        let (a, b) = (f64::from(line[p]) + (p * p) as f64, f64::from(line[q]) + (q * q) as f64);
        (b - a) / (2.0 * (q as f64 - p as f64))
    };
    let mut envelope: Vec<(usize, f64)> = vec![];
    for q in (0..line.len()).filter(|&q| line[q].is_finite()) {
        while envelope.last().is_some_and(|&(p, from)| crossing(p, q) <= from) {
            envelope.pop();
        }
        let from = envelope.last().map_or(f64::NEG_INFINITY, |&(p, _)| crossing(p, q));
        envelope.push((q, from));
    }
    let mut current = 0;
    let value = |q: usize| {
        while envelope.get(current + 1).is_some_and(|&(_, from)| from < q as f64) {
            current += 1;
        }
        envelope.get(current).map_or(f32::INFINITY, |&(p, _)| (q.abs_diff(p) as f32).powi(2) + line[p])
    };
    (0..line.len()).map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose;

    #[test]
    fn distances_are_those_to_the_nearest_wall() {
        let walls = [(3, 1), (17, 12), (18, 2)];
        let cell = |i: usize| if walls.contains(&(i % 20, i / 20)) { Cell::OCCUPIED } else { Cell::FREE };
        let grid = Grid::new(20, 15, 0.5, Pose::default(), (0..300).map(cell).collect()).unwrap();
        let field = Field::new(grid, 100.0);
        for i in 0..300_usize {
            let (x, y) = (i % 20, i / 20);
            let far = |w: &(usize, usize)| (w.0 as f64 - x as f64).hypot(w.1 as f64 - y as f64) * 0.5;
            let nearest = walls.iter().map(far).fold(f64::INFINITY, f64::min);
            let found = field.distance(Point::new(x as f64 * 0.5 + 0.2, y as f64 * 0.5 + 0.2));
            assert!((f64::from(found) - nearest).abs() < 1e-4, "{x} {y}: {found} for {nearest}");
        }
        assert_eq!(field.distance(Point::new(-0.1, 0.0)), 100.0);
        assert_eq!(field.floor_cells(), 297);
    }

    #[test]
    fn a_map_without_walls_is_far_from_them() {
        let grid = Grid::new(2, 1, 1.0, Pose::default(), vec![Cell::FREE; 2]).unwrap();
        assert_eq!(Field::new(grid, 3.0).distance(Point::new(0.5, 0.5)), 3.0);
    }
}
