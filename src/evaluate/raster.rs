//! Which pixels a polygon covers: those whose centres lie inside it.
//!
//! A scan line runs through the centres of each row of pixels, and the even-odd rule says which parts of it lie
//! inside. A centre on an edge is not inside, so that rooms that share an edge never share a pixel. Whether a centre
//! lies left of an edge, right of it or on it is decided exactly (Shewchuk 1997).

use super::budget::Budget;
use geo::Coord;
use geo::kernels::{Kernel, Orientation, RobustKernel};
use planform_sdk::{PluginError, Point, Polygon};
use std::ops::Range;

/// The size of an image, in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

/// Tells `visit` the row and the columns of each stretch of pixels that the polygons cover, from the top to the
/// bottom and from the left to the right, each pixel once. What lies outside the image is left out.
///
/// Coordinates are pixels, y down, and must be finite.
pub(super) fn scan(
    polygons: &[Polygon],
    size: Size,
    budget: &mut Budget,
    mut visit: impl FnMut(usize, Range<usize>),
) -> Result<(), PluginError> {
    let edges = edges(polygons, size);
    let mut waiting = edges.iter().peekable();
    let mut active: Vec<&Edge> = vec![];
    let mut row = edges.first().map_or(0, |e| e.rows.start);
    while waiting.peek().is_some() || !active.is_empty() {
        active.retain(|e| row < e.rows.end);
        while let Some(edge) = waiting.next_if(|e| e.rows.start <= row) {
            active.push(edge);
        }
        budget.spend(active.len() + 1)?;
        for columns in covered(&active, row, size.width) {
            budget.spend(columns.len())?;
            visit(row, columns);
        }
        row += 1;
    }
    Ok(())
}

/// An edge of a polygon that touches the centre line of some row.
#[derive(Debug)]
struct Edge {
    /// The polygon it belongs to.
    part: usize,
    /// The end with the smaller y.
    top: Point,
    /// The other end.
    bottom: Point,
    /// The rows whose centre lines it touches.
    rows: Range<usize>,
}

fn edges(polygons: &[Polygon], size: Size) -> Vec<Edge> {
    let mut edges = vec![];
    for (part, polygon) in polygons.iter().enumerate() {
        for ring in polygon.rings() {
            let ends = ring.iter().zip(ring.iter().cycle().skip(1));
            edges.extend(ends.filter_map(|(&a, &b)| Edge::new(part, a, b, size.height)));
        }
    }
    edges.sort_by_key(|e| e.rows.start);
    edges
}

impl Edge {
    fn new(part: usize, a: Point, b: Point, height: usize) -> Option<Self> {
        let (top, bottom) = if a.y <= b.y { (a, b) } else { (b, a) };
        // A cast takes what lies outside the numbers to the nearest one.
        let start = (top.y - 0.5).ceil().max(0.0) as usize;
        let end = ((bottom.y - 0.5).floor() + 1.0).clamp(0.0, height as f64) as usize;
        (start < end).then_some(Self { part, top, bottom, rows: start..end })
    }

    /// The columns whose centres in this row lie on the edge.
    fn touched(&self, row: usize, width: usize) -> Range<usize> {
        if self.top.y < self.bottom.y {
            let first = self.first_right(row, width);
            let on = |column: &usize| self.side(*column, row) == Orientation::Collinear;
            return first.checked_sub(1).filter(on).map_or(0..0, |column| column..first);
        }
        let (left, right) = (self.top.x.min(self.bottom.x), self.top.x.max(self.bottom.x));
        let within = |v: f64| v.clamp(0.0, width as f64) as usize;
        within((left - 0.5).ceil())..within((right - 0.5).floor() + 1.0)
    }

    /// Whether the edge leads from above the row's centre line, or from it, to below it.
    fn crosses(&self, row: usize) -> bool {
        let y = row as f64 + 0.5;
        self.top.y <= y && y < self.bottom.y
    }

    /// The first column whose centre in this row lies right of the edge; `width` if none does.
    fn first_right(&self, row: usize, width: usize) -> usize {
        let share = (row as f64 + 0.5 - self.top.y) / (self.bottom.y - self.top.y);
        let x = self.top.x + share * (self.bottom.x - self.top.x);
        let mut first = (x + 0.5).floor().clamp(0.0, width as f64) as usize;
        // The sum above is rounded; the centres next to it are told apart exactly.
        while first > 0 && self.side(first - 1, row) == RIGHT {
            first -= 1;
        }
        while first < width && self.side(first, row) != RIGHT {
            first += 1;
        }
        first
    }

    /// On which side of the edge a pixel's centre lies.
    fn side(&self, column: usize, row: usize) -> Orientation {
        let coord = |p: Point| Coord { x: p.x, y: p.y };
        let centre = Coord { x: column as f64 + 0.5, y: row as f64 + 0.5 };
        RobustKernel::orient2d(coord(self.top), coord(self.bottom), centre)
    }
}

/// The side of larger x, seen from an edge that leads to larger y.
const RIGHT: Orientation = Orientation::Clockwise;

/// The columns that the polygons cover in this row, from the left, apart from each other.
fn covered(active: &[&Edge], row: usize, width: usize) -> Vec<Range<usize>> {
    let mut edges = active.to_vec();
    edges.sort_by_key(|e| e.part);
    let mut spans: Vec<_> =
        edges.chunk_by(|a, b| a.part == b.part).flat_map(|part| covered_by_one(part, row, width)).collect();
    spans.sort_by_key(|s| s.start);
    union(spans)
}

fn covered_by_one(edges: &[&Edge], row: usize, width: usize) -> Vec<Range<usize>> {
    let mut crossings: Vec<_> =
        edges.iter().filter(|e| e.crosses(row)).map(|e| e.first_right(row, width)).collect();
    crossings.sort_unstable();
    let mut touched: Vec<_> = edges.iter().map(|e| e.touched(row, width)).filter(|t| !t.is_empty()).collect();
    touched.sort_by_key(|t| t.start);
    without(crossings.chunks_exact(2).map(|pair| pair[0]..pair[1]), &union(touched))
}

/// Joins ranges that are sorted by their starts.
fn union(ranges: Vec<Range<usize>>) -> Vec<Range<usize>> {
    let mut joined: Vec<Range<usize>> = vec![];
    for range in ranges {
        match joined.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => joined.push(range),
        }
    }
    joined
}

/// What is left of sorted ranges without the `cuts`, which are sorted and apart.
fn without(ranges: impl Iterator<Item = Range<usize>>, cuts: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut left = vec![];
    for Range { mut start, end } in ranges {
        let first = cuts.partition_point(|cut| cut.end <= start);
        for cut in cuts[first..].iter().take_while(|cut| cut.start < end) {
            left.push(start..cut.start.max(start));
            start = cut.end;
        }
        left.push(start..end);
    }
    left.retain(|range| range.start < range.end);
    left
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ring(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().copied().map(Point::from).collect()
    }

    fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Polygon {
        Polygon::new(ring(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]), vec![])
    }

    fn draw(polygons: &[Polygon], width: usize, height: usize) -> Vec<String> {
        let mut rows = vec![vec!['.'; width]; height];
        scan(polygons, Size { width, height }, &mut Budget::new(Budget::STEPS), |row, columns| {
            for pixel in &mut rows[row][columns] {
                assert_eq!(*pixel, '.', "told twice");
                *pixel = '#';
            }
        })
        .unwrap();
        rows.into_iter().map(String::from_iter).collect()
    }

    #[test]
    fn a_rectangle_covers_its_pixels() {
        assert_eq!(draw(&[rectangle(1.0, 1.0, 3.0, 2.0)], 4, 3), ["....", ".##.", "...."]);
    }

    #[test]
    fn a_centre_on_an_edge_is_outside() {
        // Centres at 0.5, 1.5, 2.5, 3.5: the first and the last lie on the edges, in both directions.
        assert_eq!(draw(&[rectangle(0.5, 0.5, 3.5, 3.5)], 4, 4), ["....", ".##.", ".##.", "...."]);
        let (left, right) = (rectangle(0.0, 0.0, 1.5, 1.0), rectangle(1.5, 0.0, 4.0, 1.0));
        assert_eq!(
            (draw(&[left], 4, 1), draw(&[right], 4, 1)),
            (vec!["#...".into()], vec!["..##".to_string()])
        );
    }

    #[test]
    fn a_centre_on_a_slanted_edge_is_outside() {
        let triangle = Polygon::new(ring(&[[0.0, 0.0], [4.0, 4.0], [0.0, 4.0]]), vec![]);
        assert_eq!(draw(&[triangle], 4, 4), ["....", "#...", "##..", "###."]);
        let tip = Polygon::new(ring(&[[1.5, 0.5], [2.5, 1.5], [1.5, 2.5], [0.5, 1.5]]), vec![]);
        assert_eq!(draw(&[tip], 3, 3), ["...", ".#.", "..."]);
    }

    #[test]
    fn holes_are_left_out_with_their_edges() {
        let hole = rectangle(1.5, 1.5, 3.5, 3.5).exterior;
        let frame = Polygon::new(rectangle(0.0, 0.0, 5.0, 5.0).exterior, vec![hole]);
        assert_eq!(draw(&[frame], 5, 5), ["#####", "#...#", "#...#", "#...#", "#####"]);
    }

    #[test]
    fn parts_count_once() {
        let parts =
            [rectangle(0.0, 0.0, 3.0, 1.0), rectangle(2.0, 0.0, 5.0, 1.0), rectangle(6.0, 0.0, 7.0, 1.0)];
        assert_eq!(draw(&parts, 8, 1), ["#####.#."]);
    }

    #[test]
    fn what_lies_outside_is_clipped() {
        assert_eq!(draw(&[rectangle(-1e9, -1e9, 1e9, 1e9)], 2, 2), ["##", "##"]);
        assert_eq!(draw(&[rectangle(5.0, 0.0, 9.0, 2.0)], 2, 2), ["..", ".."]);
        assert_eq!(draw(&[rectangle(-9.0, -9.0, 1.0, 1.0)], 2, 2), ["#.", ".."]);
        assert_eq!(draw(&[rectangle(0.0, 7.0, 2.0, 9.0)], 2, 2), ["..", ".."]);
        assert_eq!(draw(&[rectangle(0.0, 0.0, 2.0, 2.0)], 0, 0), [""; 0]);
    }

    #[test]
    fn degenerate_rings_cover_nothing() {
        for points in [vec![], vec![[0.5, 0.5]], vec![[0.0, 0.5], [3.0, 0.5]], vec![[1.0, 1.0]; 4]] {
            let polygon = Polygon { exterior: ring(&points), holes: vec![] };
            assert_eq!(draw(&[polygon], 3, 1), ["..."]);
        }
    }

    #[test]
    fn a_crossing_ring_follows_the_even_odd_rule() {
        let bow =
            Polygon { exterior: ring(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]]), holes: vec![] };
        assert_eq!(draw(&[bow], 4, 4), ["....", "#..#", "#..#", "...."]);
    }

    #[test]
    fn too_much_work_is_refused() {
        let size = Size { width: 100, height: 100 };
        let everything = rectangle(0.0, 0.0, 100.0, 100.0);
        assert!(scan(&[everything], size, &mut Budget::new(9_000), |_, _| ()).is_err());
    }

    proptest! {
        /// The definition, pixel by pixel.
        #[test]
        fn agrees_with_the_point_in_polygon_rule(points in prop::collection::vec((-4i32..24, -4i32..24), 3..9)) {
            // Odd eighths never meet a centre; edges may, but only by chance of their slopes.
            let exterior = points.iter().map(|&(x, y)| Point::new(f64::from(x) + 0.125, f64::from(y) + 0.125)).collect();
            let polygon = Polygon { exterior, holes: vec![] };
            for (y, row) in draw(std::slice::from_ref(&polygon), 20, 20).iter().enumerate() {
                for (x, pixel) in row.chars().enumerate() {
                    let centre = Point::new(x as f64 + 0.5, y as f64 + 0.5);
                    let edge = edges(std::slice::from_ref(&polygon), Size { width: 20, height: 20 })
                        .iter()
                        .any(|e| e.rows.contains(&y) && e.side(x, y) == Orientation::Collinear);
                    prop_assert!(edge || (pixel == '#') == polygon.contains(centre), "{x} {y}");
                }
            }
        }
    }
}
