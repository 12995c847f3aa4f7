//! What each step found, as drawings: the pictures of the paper's Fig. 1.

use super::arrangement::{Arrangement, Edge};
use super::boundary::Run;
use super::collinear::Collinears;
use super::directions::Direction;
use super::observer::{Drawing, Shape};
use super::raster::Mask;
use planform_sdk::{Point, Polygon, Segment};
use std::collections::BTreeMap;

const GREEN: [u8; 3] = [0, 150, 60];
const RED: [u8; 3] = [210, 30, 30];
const YELLOW: [u8; 3] = [240, 200, 40];
const BLACK: [u8; 3] = [0, 0, 0];
const BLUE: [u8; 3] = [40, 90, 220];
const GREY: [u8; 3] = [150, 150, 150];

/// Metres from the grid's corner to cells.
#[derive(Clone, Copy)]
pub struct Scale(pub f64);

impl Scale {
    fn point(self, p: Point) -> Point {
        Point::new(p.x / self.0, p.y / self.0)
    }

    fn line(self, s: Segment, colour: [u8; 3], width: f64) -> Shape {
        Shape::Line { segment: Segment::new(self.point(s.a), self.point(s.b)), colour, width }
    }

    fn area(self, p: &Polygon, colour: [u8; 3]) -> Shape {
        let ring = |r: &Vec<Point>| r.iter().map(|&p| self.point(p)).collect();
        let polygon = Polygon { exterior: ring(&p.exterior), holes: p.holes.iter().map(ring).collect() };
        Shape::Area { polygon, colour }
    }

    /// The segments, one colour for all.
    pub fn segments(self, segments: &[Segment]) -> Drawing {
        Drawing { shapes: segments.iter().map(|&s| self.line(s, GREEN, 2.0)).collect() }
    }

    /// The segments, one colour for each direction.
    pub fn directions(self, directions: &[Direction]) -> Drawing {
        self.groups(directions.iter().map(|d| d.segments.as_slice()))
    }

    /// The segments, one colour for each spatial cluster.
    pub fn collinears(self, clusters: &[Collinears]) -> Drawing {
        self.groups(clusters.iter().map(|c| c.segments.as_slice()))
    }

    fn groups<'a>(self, groups: impl Iterator<Item = &'a [Segment]>) -> Drawing {
        let shapes = groups
            .enumerate()
            .flat_map(|(i, g)| g.iter().map(move |&s| self.line(s, colour(i), 2.0)))
            .collect();
        Drawing { shapes }
    }

    /// The representative lines across the area.
    pub fn lines(self, lines: &[Segment]) -> Drawing {
        Drawing { shapes: lines.iter().map(|&s| self.line(s, RED, 1.0)).collect() }
    }

    /// The faces' edges; inner faces filled, the partial ones in blue.
    pub fn faces(
        self,
        arrangement: &Arrangement,
        edges: &[Edge],
        inner: impl Fn(usize) -> bool,
        partial: impl Fn(usize) -> bool,
    ) -> Drawing {
        let fill = |f: usize| self.area(&arrangement.polygon(f), if partial(f) { BLUE } else { YELLOW });
        let mut shapes: Vec<Shape> = (0..arrangement.count()).filter(|&f| inner(f)).map(fill).collect();
        shapes.extend(edges.iter().map(|e| self.line(ends(arrangement, e), RED, 1.0)));
        Drawing { shapes }
    }

    /// The edges of inner faces, the thicker the more wall lies along them.
    pub fn weights(
        self,
        arrangement: &Arrangement,
        edges: &[Edge],
        weights: &[f64],
        inner: impl Fn(usize) -> bool,
    ) -> Drawing {
        let seen = |e: &Edge| inner(e.left) || e.right.is_some_and(&inner);
        let edges = edges.iter().zip(weights).filter(|(e, _)| seen(e));
        Drawing { shapes: edges.map(|(e, w)| self.line(ends(arrangement, e), RED, 0.5 + 4.0 * w)).collect() }
    }

    /// The rooms' polygons.
    pub fn rooms<'a>(self, rooms: impl Iterator<Item = (&'a Polygon, bool)>) -> Drawing {
        let colour = |i: usize, partial: bool| if partial { GREY } else { colour(i) };
        Drawing {
            shapes: rooms.enumerate().map(|(i, (p, partial))| self.area(p, colour(i, partial))).collect(),
        }
    }

    /// The rooms with their boundaries, bold where there is a wall, and the openings.
    pub fn layout<'a>(
        self,
        rooms: impl Iterator<Item = (&'a Polygon, bool)>,
        runs: &[Run],
        openings: impl Iterator<Item = Segment>,
    ) -> Drawing {
        self.plan(rooms, runs.iter().map(|r| (r.segment, r.weight)), openings)
    }

    /// The rooms with their walls, the bolder the more of them the map shows, and the openings.
    pub fn plan<'a>(
        self,
        rooms: impl Iterator<Item = (&'a Polygon, bool)>,
        walls: impl Iterator<Item = (Segment, f64)>,
        openings: impl Iterator<Item = Segment>,
    ) -> Drawing {
        let mut drawing = self.rooms(rooms);
        drawing.shapes.extend(walls.map(|(line, weight)| self.line(line, BLACK, 0.5 + 3.0 * weight)));
        drawing.shapes.extend(openings.map(|s| self.line(s, RED, 3.0)));
        drawing
    }
}

/// The edge cells.
pub fn edges(mask: &Mask) -> Drawing {
    marked(mask, RED)
}

/// The walls' cells, and in red the obstacles taken away.
pub fn cleared(obstacles: &Mask, walls: &Mask) -> Drawing {
    let mut drawing = marked(walls, BLACK);
    drawing.shapes.extend(marked(&obstacles.without(walls), RED).shapes);
    drawing
}

/// The inner area, as the paper shows it.
pub fn area(mask: &Mask) -> Drawing {
    marked(mask, YELLOW)
}

/// The cells of a mask, one colour for each label; those without one stay as they are.
pub fn labels(mask: &Mask, label: &[u32]) -> Drawing {
    let mut groups: BTreeMap<u32, Vec<(u32, u32)>> = BTreeMap::new();
    for (column, row) in mask.cells() {
        let l = label[row * mask.width() + column];
        if l != 0 {
            groups.entry(l).or_default().push((column as u32, row as u32));
        }
    }
    let cells = |(l, cells)| Shape::Cells { cells, colour: colour(l as usize) };
    Drawing { shapes: groups.into_iter().map(cells).collect() }
}

fn marked(mask: &Mask, colour: [u8; 3]) -> Drawing {
    let cells = mask.cells().map(|(c, r)| (c as u32, r as u32)).collect();
    Drawing { shapes: vec![Shape::Cells { cells, colour }] }
}

fn ends(arrangement: &Arrangement, edge: &Edge) -> Segment {
    Segment::new(arrangement.vertices[edge.ends[0]], arrangement.vertices[edge.ends[1]])
}

/// Colours that neighbours in a list tell apart: the hue goes on by the golden angle.
fn colour(i: usize) -> [u8; 3] {
    let hue = (i as f64 * 0.618_033_988_75).fract() * 6.0;
    let ramp = |shift: f64| {
        let h = (hue + shift).rem_euclid(6.0);
        (60.0 + 170.0 * (2.0 - (h - 3.0).abs()).clamp(0.0, 1.0)) as u8
    };
    [ramp(3.0), ramp(1.0), ramp(5.0)]
}
