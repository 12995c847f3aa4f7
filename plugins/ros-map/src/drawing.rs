//! A layout as cells.

use crate::canvas::{Canvas, Paint};
use crate::frame::Frame;
use planform_sdk::{
    Fitting, Frontier, FrontierKind, Layout, Opening, PluginError, Point, Polygon, RoomId, Segment, Wall,
};

/// The farthest that an opening is taken to reach from its wall's centre line to a room's floor, metres.
pub const REACH: f64 = 1.0;

/// A wall is across an opening if the sine of the angle between them is more than this.
const ACROSS: f64 = 0.3;

/// The outline of a room is open this near to a frontier, metres.
const OPEN: f64 = 0.3;

/// How many places of an opening are asked how far it reaches.
const PLACES: u32 = 5;

const ALL: [Paint; 3] = [Paint::Occupied, Paint::Unknown, Paint::Free];

/// The map of a layout. Fails if a coordinate is not finite.
///
/// Later layers win: all that lies within rooms' centre lines and walls' faces is occupied, but for frontiers, where
/// nothing is known; floors are free; walls that are thinner than a cell are drawn once more, so that no two rooms run
/// into one; openings are free from floor to floor; and a floor that still borders on the unknown is closed by a wall,
/// but for frontiers.
pub fn draw<'a>(layout: &'a Layout, frame: &'a Frame) -> Result<Drawing<'a>, PluginError> {
    let mut drawing = Drawing { canvas: Canvas::new(frame), frame, layout };
    layout.rooms.iter().try_for_each(|r| drawing.polygon(&r.centre, Paint::Occupied))?;
    layout.frontiers.iter().try_for_each(|f| drawing.frontier(f))?;
    let walls = || layout.walls.iter().filter(|w| !layout.openings.iter().any(|o| bars(w, o)));
    walls().try_for_each(|w| drawing.wall(w, w.thickness))?;
    layout.rooms.iter().try_for_each(|r| drawing.polygon(&r.inner, Paint::Free))?;
    walls().try_for_each(|w| drawing.wall(w, 0.0))?;
    layout.openings.iter().try_for_each(|o| drawing.opening(o))?;
    layout.further_doors().try_for_each(|d| drawing.outer_door(&d))?;
    drawing.close();
    Ok(drawing)
}

/// Whether a wall stands across an opening between its own two rooms: where their floors meet at a slant, only the
/// opening is real.
fn bars(wall: &Wall, opening: &Opening) -> bool {
    let pair = opening.rooms.map(Some);
    let between = wall.rooms == pair || wall.rooms == [pair[1], pair[0]];
    let across = (wall.line.angle() - opening.segment.angle()).sin().abs() > ACROSS;
    between && across && is_at(wall.line.midpoint(), opening)
}

/// Whether a place lies within an opening, or before it.
pub fn is_at(p: Point, opening: &Opening) -> bool {
    let a = opening.segment.a;
    let (sin, cos) = opening.segment.angle().sin_cos();
    let (x, y) = (p.x - a.x, p.y - a.y);
    let (along, beside) = (x * cos + y * sin, y * cos - x * sin);
    (0.0..=opening.width()).contains(&along) && beside.abs() <= REACH
}

/// A layout on its canvas.
pub struct Drawing<'a> {
    /// The cells.
    pub canvas: Canvas,
    /// Where they lie.
    pub frame: &'a Frame,
    /// What they show.
    pub layout: &'a Layout,
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
        [-1.0, 1.0].map(|side| self.reaches(segment, side).fold(otherwise, f64::max))
    }

    /// How far it is from each half of an opening to the floors of its rooms on its right and left, as most places of
    /// the half have it, metres; none if these floors are not on its two sides.
    pub fn depths(&self, segment: &Segment, rooms: [RoomId; 2]) -> Option<[[f64; 2]; 2]> {
        let middle = segment.midpoint();
        let halves = [Segment::new(segment.a, middle), Segment::new(middle, segment.b)];
        let depths = |rooms| {
            let [a, b] = halves.each_ref().map(|half| self.depth(half, rooms));
            Some([a?, b?])
        };
        let [a, b] = rooms;
        depths([a, b]).or_else(|| depths([b, a]))
    }

    /// How far it is from a segment to the floors of the rooms on its right and left, as most places of it have it.
    fn depth(&self, segment: &Segment, [right, left]: [RoomId; 2]) -> Option<[f64; 2]> {
        // What is found is up to half a cell too far.
        let off = self.frame.resolution / 4.0;
        let side = |side: f64, room: RoomId| {
            let found = self.floors(segment, side).filter(|(_, found)| *found == room);
            let mut reaches: Vec<f64> = found.map(|(reach, _)| reach).collect();
            reaches.sort_by(f64::total_cmp);
            let half = reaches.len() / 2;
            reaches.get(half).filter(|_| 2 * reaches.len() > PLACES as usize).map(|r| (r - off).max(0.0))
        };
        Some([side(-1.0, right)?, side(1.0, left)?])
    }

    fn reaches(&self, segment: &Segment, side: f64) -> impl Iterator<Item = f64> {
        self.floors(segment, side).map(|(reach, _)| reach)
    }

    /// How far the next floor is from some places of a segment, and whose it is.
    fn floors(&self, segment: &Segment, side: f64) -> impl Iterator<Item = (f64, RoomId)> {
        let places = (0..PLACES).map(|i| (f64::from(i) + 0.5) / f64::from(PLACES));
        places.filter_map(move |share| self.floor_at(segment, share, side))
    }

    fn floor_at(&self, segment: &Segment, share: f64, side: f64) -> Option<(f64, RoomId)> {
        let step = self.frame.resolution / 2.0;
        let steps = (REACH / step).ceil().min(1000.0) as u32;
        let (sin, cos) = segment.angle().sin_cos();
        let at = |far: f64| {
            let (a, b, out) = (segment.a, segment.b, far * side);
            Point::new(a.x + share * (b.x - a.x) - out * sin, a.y + share * (b.y - a.y) + out * cos)
        };
        let floor = |p: Point| self.layout.rooms.iter().find(|r| r.inner.contains(p)).map(|r| r.id);
        (0..=steps).map(|i| f64::from(i) * step).find_map(|far| Some((far, floor(at(far))?)))
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

    /// Walls off the floors where their outlines have no wall, as that of a room that was not seen to its end; it stays
    /// open where it leads to space of which nothing is known.
    fn close(&mut self) {
        let open: Vec<[Point; 2]> = self
            .layout
            .frontiers
            .iter()
            .filter(|f| f.leads == FrontierKind::Space)
            .map(|f| [f.segment.a, f.segment.b].map(|p| self.frame.to_cells(p)))
            .collect();
        let near = OPEN / self.frame.resolution;
        self.canvas.close(|p| open.iter().any(|[a, b]| distance(*a, *b, p) <= near));
    }

    /// What a place is painted.
    pub fn paint(&self, p: Point) -> Option<Paint> {
        self.canvas.at(self.frame.to_cells(p))
    }

    fn cell(&self, p: Point) -> Result<Point, PluginError> {
        Ok(self.frame.to_cells(p.finite()?))
    }
}

/// How far a point is from a segment.
fn distance(a: Point, b: Point, p: Point) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let share = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
    let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
    p.distance(Point::new(a.x + share * dx, a.y + share * dy))
}
