//! A layout as cells.

use crate::canvas::{Canvas, Paint};
use crate::frame::Frame;
use planform_sdk::{Fitting, Frontier, Layout, Opening, PluginError, Point, Polygon, Segment, Wall};

/// The farthest that an opening is taken to reach from its wall's centre line to a room's floor, metres.
const REACH: f64 = 1.0;

/// How many places of an opening are asked how far it reaches.
const PLACES: u32 = 5;

const ALL: [Paint; 3] = [Paint::Occupied, Paint::Unknown, Paint::Free];

/// The map of a layout. Fails if a coordinate is not finite.
///
/// Later layers win: all that lies within rooms' centre lines and walls' faces is occupied, but for frontiers, where
/// nothing is known; floors are free; walls that are thinner than a cell are drawn once more, so that no two rooms run
/// into one; and openings are free from floor to floor.
pub fn draw(layout: &Layout, frame: &Frame) -> Result<Canvas, PluginError> {
    let mut drawing = Drawing { canvas: Canvas::new(frame), frame, layout };
    layout.rooms.iter().try_for_each(|r| drawing.polygon(&r.centre, Paint::Occupied))?;
    layout.frontiers.iter().try_for_each(|f| drawing.frontier(f))?;
    layout.walls.iter().try_for_each(|w| drawing.wall(w, w.thickness))?;
    layout.rooms.iter().try_for_each(|r| drawing.polygon(&r.inner, Paint::Free))?;
    layout.walls.iter().try_for_each(|w| drawing.wall(w, 0.0))?;
    layout.openings.iter().try_for_each(|o| drawing.opening(o))?;
    layout.further_doors().try_for_each(|d| drawing.outer_door(&d))?;
    Ok(drawing.canvas)
}

struct Drawing<'a> {
    canvas: Canvas,
    frame: &'a Frame,
    layout: &'a Layout,
}

impl Drawing<'_> {
    fn polygon(&mut self, polygon: &Polygon, paint: Paint) -> Result<(), PluginError> {
        let ring = |ring: &[Point]| ring.iter().map(|&p| self.cell(p)).collect();
        let rings: Vec<_> = polygon.rings().map(ring).collect::<Result<_, _>>()?;
        self.canvas.fill(&rings, paint, &ALL);
        Ok(())
    }

    /// A wall, at least so thick that its cells have no gap.
    fn wall(&mut self, wall: &Wall, thickness: f64) -> Result<(), PluginError> {
        let half = thickness.max(self.least_thickness(&wall.line)) / 2.0;
        self.band(&wall.line, [half, half], Paint::Occupied, &ALL)
    }

    /// The thickness with which a line's cells touch by their sides, metres: a cell's extent across it.
    fn least_thickness(&self, line: &Segment) -> f64 {
        let (sin, cos) = (line.angle() - self.frame.origin.yaw).sin_cos();
        self.frame.resolution * (sin.abs() + cos.abs())
    }

    /// No wall closes a room where it was not seen to its end.
    fn frontier(&mut self, frontier: &Frontier) -> Result<(), PluginError> {
        let reach = self.reach(&frontier.segment, 0.0);
        self.band(&frontier.segment, reach, Paint::Unknown, &[Paint::Occupied])
    }

    fn opening(&mut self, opening: &Opening) -> Result<(), PluginError> {
        let reach = self.reach(&opening.segment, 0.0);
        self.band(&opening.segment, reach, Paint::Free, &ALL)
    }

    fn outer_door(&mut self, door: &Fitting) -> Result<(), PluginError> {
        let reach = self.reach(&door.segment, door.thickness / 2.0);
        self.band(&door.segment, reach, Paint::Free, &ALL)
    }

    /// How far it is from a segment to the floors on its right and left, metres; `otherwise` where there is none.
    fn reach(&self, segment: &Segment, otherwise: f64) -> [f64; 2] {
        [-1.0, 1.0].map(|side| {
            let places = (0..PLACES).map(|i| (f64::from(i) + 0.5) / f64::from(PLACES));
            let reaches = places.filter_map(|share| self.reach_at(segment, share, side));
            reaches.fold(otherwise, f64::max)
        })
    }

    fn reach_at(&self, segment: &Segment, share: f64, side: f64) -> Option<f64> {
        let step = self.frame.resolution / 2.0;
        let steps = (REACH / step).ceil().min(1000.0) as u32;
        let (sin, cos) = segment.angle().sin_cos();
        let at = |far: f64| {
            let (a, b, out) = (segment.a, segment.b, far * side);
            Point::new(a.x + share * (b.x - a.x) - out * sin, a.y + share * (b.y - a.y) + out * cos)
        };
        let on_floor = |p: Point| self.layout.rooms.iter().any(|r| r.inner.contains(p));
        (0..=steps).map(|i| f64::from(i) * step).find(|&far| on_floor(at(far)))
    }

    /// Paints what lies within these distances to the right and left of a segment.
    fn band(
        &mut self,
        segment: &Segment,
        [right, left]: [f64; 2],
        paint: Paint,
        over: &[Paint],
    ) -> Result<(), PluginError> {
        let (sin, cos) = segment.angle().sin_cos();
        let beside = |p: Point, left: f64| self.cell(Point::new(p.x - left * sin, p.y + left * cos));
        let Segment { a, b } = *segment;
        let ring = [beside(a, -right)?, beside(b, -right)?, beside(b, left)?, beside(a, left)?];
        self.canvas.fill(&[ring.to_vec()], paint, over);
        Ok(())
    }

    fn cell(&self, p: Point) -> Result<Point, PluginError> {
        Ok(self.frame.to_cells(p.finite()?))
    }
}
