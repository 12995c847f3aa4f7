//! Cells to draw on.

use crate::frame::Frame;
use planform_sdk::{Point, Segment};

/// What a cell of the map is, as the grey that `map_saver` writes for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Paint {
    /// A wall.
    Occupied = 0,
    /// Nothing is known.
    Unknown = 205,
    /// Floor.
    Free = 254,
}

/// The cells of a map, row 0 at the bottom.
pub struct Canvas {
    width: usize,
    cells: Vec<Paint>,
}

impl Canvas {
    /// All cells unknown.
    pub fn new(frame: &Frame) -> Self {
        let (width, height) = (frame.width as usize, frame.height as usize);
        Self { width, cells: vec![Paint::Unknown; width * height] }
    }

    /// The rows, from the bottom.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[Paint]> + ExactSizeIterator {
        self.cells.chunks_exact(self.width)
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// What the cell is painted that holds a point in cell coordinates.
    pub fn at(&self, p: Point) -> Option<Paint> {
        let (x, y) = (p.x.floor(), p.y.floor());
        let inside =
            x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < (self.cells.len() / self.width) as f64;
        inside.then(|| self.cells[y as usize * self.width + x as usize])
    }

    /// Makes unknown cells beside free ones, or at their corners, occupied, but for those whose middles are `open`.
    pub fn close(&mut self, open: impl Fn(Point) -> bool) {
        let (width, height) = (self.width, self.cells.len() / self.width);
        let around = |v: usize, most: usize| v.saturating_sub(1)..(v + 2).min(most);
        let is_free = |x: usize, y: usize| self.cells[y * width + x] == Paint::Free;
        let beside_free = |i: usize| {
            let (x, y) = (i % width, i / width);
            around(y, height).any(|row| around(x, width).any(|column| is_free(column, row)))
        };
        let middle = |i: usize| Point::new((i % width) as f64 + 0.5, (i / width) as f64 + 0.5);
        let unknown = (0..self.cells.len()).filter(|&i| self.cells[i] == Paint::Unknown);
        let closed: Vec<usize> = unknown.filter(|&i| beside_free(i) && !open(middle(i))).collect();
        closed.into_iter().for_each(|i| self.cells[i] = Paint::Occupied);
    }

    /// Paints the cells whose middles lie within the rings, by the even-odd rule, if they are `over` what they may be
    /// painted over. The rings are in cell coordinates.
    pub fn fill(&mut self, rings: &[Vec<Point>], paint: Paint, over: &[Paint]) {
        let edges: Vec<_> = rings.iter().flat_map(|ring| edges(ring)).collect();
        let height = self.cells.len() / self.width;
        let low = edges.iter().map(|e| e.a.y.min(e.b.y)).fold(f64::INFINITY, f64::min);
        let high = edges.iter().map(|e| e.a.y.max(e.b.y)).fold(f64::NEG_INFINITY, f64::max);
        for row in first(low, height)..first(high, height) {
            let mut crossings = crossings(&edges, row as f64 + 0.5);
            crossings.sort_by(f64::total_cmp);
            for pair in crossings.chunks_exact(2) {
                let from = first(pair[0], self.width);
                // Crossings of edges that are absurdly long may be no numbers.
                let to = first(pair[1], self.width).max(from);
                let cells = &mut self.cells[row * self.width..][from..to];
                cells.iter_mut().filter(|c| over.contains(c)).for_each(|c| *c = paint);
            }
        }
    }
}

/// The first of `count` cells whose middle lies at this coordinate or beyond.
fn first(coordinate: f64, count: usize) -> usize {
    // Saturates, and takes what is not a number for 0.
    ((coordinate - 0.5).ceil().max(0.0) as usize).min(count)
}

fn edges(ring: &[Point]) -> impl Iterator<Item = Segment> {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(a, b)| Segment::new(*a, *b))
}

/// Where edges cross the line at this height.
fn crossings(edges: &[Segment], y: f64) -> Vec<f64> {
    let across = edges.iter().filter(|e| (e.a.y > y) != (e.b.y > y));
    across.map(|e| e.a.x + (e.b.x - e.a.x) * ((y - e.a.y) / (e.b.y - e.a.y))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose;

    const ALL: [Paint; 3] = [Paint::Occupied, Paint::Unknown, Paint::Free];

    fn canvas() -> Canvas {
        Canvas::new(&Frame { width: 6, height: 4, resolution: 1.0, origin: Pose::default() })
    }

    fn ring(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    /// The rows from the bottom: `#` for occupied, `.` for free.
    fn shown(canvas: &Canvas) -> Vec<String> {
        let letter = |p: &Paint| match p {
            Paint::Occupied => '#',
            Paint::Free => '.',
            Paint::Unknown => ' ',
        };
        canvas.rows().map(|row| row.iter().map(letter).collect()).collect()
    }

    #[test]
    fn cells_count_by_their_middles() {
        let mut canvas = canvas();
        canvas.fill(&[ring(&[[0.6, 0.4], [4.4, 0.4], [4.4, 2.6], [0.6, 2.6]])], Paint::Occupied, &ALL);
        assert_eq!(shown(&canvas), [" ###  ", " ###  ", " ###  ", "      "]);
    }

    #[test]
    fn holes_and_what_must_stay_are_left_out() {
        let mut canvas = canvas();
        let outer = ring(&[[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]]);
        let hole = ring(&[[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]]);
        canvas.fill(&[outer.clone(), hole], Paint::Free, &ALL);
        assert_eq!(shown(&canvas)[1], ".  ...");
        canvas.fill(&[outer], Paint::Occupied, &[Paint::Unknown]);
        assert_eq!(shown(&canvas)[1], ".##...");
    }

    #[test]
    fn what_lies_outside_is_cut_off() {
        let mut canvas = canvas();
        let far = f64::MAX;
        canvas.fill(&[ring(&[[-far, -far], [far, -far], [far, 1.0], [-far, 1.0]])], Paint::Free, &ALL);
        canvas.fill(&[ring(&[[7.0, 0.0], [9.0, 9.0], [1e300, 1.0]])], Paint::Occupied, &ALL);
        assert_eq!(shown(&canvas)[2], "      ");
    }
}
