//! Doors and windows that a document shows as symbols, as they stand in the walls of a layout.

use crate::{Layout, Opening, Point, Segment, Symbol, Wall};
use std::f64::consts::PI;

/// What stands in a wall runs along it, but for so much, radians: symbols are found a little turned.
const TURN: f64 = 0.3;

/// The thickest wall that a symbol without one is drawn in, metres.
const THICKEST: f64 = 1.0;

/// Where a door or a window stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitting {
    /// From jamb to jamb, on the middle line of its wall.
    pub segment: Segment,
    /// Thickness of the wall, metres; as the document has it where the layout has no wall.
    pub thickness: f64,
    /// Which of [`Layout::walls`] it stands in; none where the layout has no wall.
    pub wall: Option<usize>,
    /// Which of [`Layout::openings`] it is; none for windows, and for doors to the outside.
    pub opening: Option<usize>,
}

/// The two lines of a window are this share of the wall's thickness apart.
const GLASS: f64 = 0.3;

impl Fitting {
    /// The wall's faces and between them the two lines of a window's glass, each from jamb to jamb, from the right of the
    /// segment to its left.
    pub fn lines(&self) -> [Segment; 4] {
        let (sin, cos) = self.segment.angle().sin_cos();
        [-0.5, -GLASS / 2.0, GLASS / 2.0, 0.5].map(|share| {
            let left = share * self.thickness;
            let moved = |p: Point| Point::new(p.x - left * sin, p.y + left * cos);
            Segment::new(moved(self.segment.a), moved(self.segment.b))
        })
    }
}

impl Layout {
    /// Where the door or the window that a symbol shows stands: in its wall, or where the document has it if the layout
    /// has no wall there. `None` for all other symbols.
    ///
    /// ```
    /// use planform_sdk::{Layout, Point, Pose, Segment, Symbol, Wall};
    /// let line = Segment::new(Point::new(0.0, 0.0), Point::new(5.0, 0.0));
    /// let walls = vec![Wall { line, thickness: 0.2, weight: 1.0, rooms: [Some(1), None] }];
    /// let layout = Layout { walls, ..Layout::default() };
    /// let (kind, pose) = ("window".to_owned(), Pose { x: 2.0, y: 0.05, yaw: 0.0 });
    /// let window = Symbol { kind, pose, width: 1.0, height: 0.1, score: 1.0, leaves: vec![] };
    /// let fitting = layout.fitting(&window).ok_or("a window stands somewhere")?;
    /// assert_eq!(fitting.segment, Segment::new(Point::new(1.5, 0.0), Point::new(2.5, 0.0)));
    /// assert_eq!(fitting.thickness, 0.2);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn fitting(&self, symbol: &Symbol) -> Option<Fitting> {
        if !(symbol.is_door() || symbol.is_window()) {
            return None;
        }
        let own = along(symbol);
        let wall = wall_of(symbol, &own, &self.walls);
        let (segment, thickness) = match wall.and_then(|i| self.walls.get(i)) {
            Some(wall) => (Segment::new(onto(&wall.line, own.a), onto(&wall.line, own.b)), wall.thickness),
            None => (own, symbol.height.clamp(0.0, THICKEST)),
        };
        let opening = if symbol.is_door() { opening_of(&own, &self.openings) } else { None };
        Some(Fitting { segment, thickness, wall, opening })
    }

    /// The doors of the document that stand in a wall and are none of the layout's openings: those to the outside.
    pub fn further_doors(&self) -> impl Iterator<Item = Fitting> {
        let doors = self.symbols.iter().filter(|s| s.is_door());
        doors.filter_map(|s| self.fitting(s)).filter(|f| f.opening.is_none() && f.wall.is_some())
    }
}

/// A symbol's length along its direction, through its middle.
fn along(symbol: &Symbol) -> Segment {
    let (sin, cos) = symbol.pose.yaw.sin_cos();
    let end = |half: f64| Point::new(symbol.pose.x + half * cos, symbol.pose.y + half * sin);
    Segment::new(end(-symbol.width / 2.0), end(symbol.width / 2.0))
}

/// The nearest wall along the symbol that the symbol's box touches.
fn wall_of(symbol: &Symbol, own: &Segment, walls: &[Wall]) -> Option<usize> {
    let middle = own.midpoint();
    let beside = |w: &Wall| distance(&w.line, middle);
    let reach = |w: &Wall| (w.thickness + symbol.height.clamp(0.0, THICKEST)) / 2.0;
    let touched = (0..).zip(walls).filter(|(_, w)| is_parallel(&w.line, own) && beside(w) <= reach(w));
    touched.min_by(|(_, v), (_, w)| beside(v).total_cmp(&beside(w))).map(|(i, _)| i)
}

/// The nearest opening along the door that the door's middle lies in, or its own middle in the door.
fn opening_of(door: &Segment, openings: &[Opening]) -> Option<usize> {
    let apart = |o: &Opening| o.segment.midpoint().distance(door.midpoint());
    let near = (0..)
        .zip(openings)
        .filter(|(_, o)| is_parallel(&o.segment, door) && apart(o) <= o.width().max(door.length()) / 2.0);
    near.min_by(|(_, o), (_, p)| apart(o).total_cmp(&apart(p))).map(|(i, _)| i)
}

fn is_parallel(a: &Segment, b: &Segment) -> bool {
    let turned = (a.angle() - b.angle()).rem_euclid(PI);
    turned.min(PI - turned) <= TURN
}

/// The share of a line, from its first end, at which a point stands beside it.
fn share(line: &Segment, p: Point) -> f64 {
    let (dx, dy) = (line.b.x - line.a.x, line.b.y - line.a.y);
    ((p.x - line.a.x) * dx + (p.y - line.a.y) * dy) / (dx * dx + dy * dy)
}

fn at(line: &Segment, share: f64) -> Point {
    Point::new(line.a.x + share * (line.b.x - line.a.x), line.a.y + share * (line.b.y - line.a.y))
}

/// The foot of a point on a line, beyond its ends as well.
fn onto(line: &Segment, p: Point) -> Point {
    at(line, share(line, p))
}

/// How far a point is from a line between its ends, metres; not a number for a line without length.
fn distance(line: &Segment, p: Point) -> f64 {
    at(line, share(line, p).clamp(0.0, 1.0)).distance(p)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OpeningKind, Pose};

    fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
        Segment::new(a.into(), b.into())
    }

    fn symbol(kind: &str, at: [f64; 2], yaw: f64) -> Symbol {
        let (kind, pose) = (kind.to_owned(), Pose { x: at[0], y: at[1], yaw });
        Symbol { kind, pose, width: 0.9, height: 0.2, score: 1.0, leaves: vec![] }
    }

    /// Two walls at right angles, and a door in the one along x.
    fn layout() -> Layout {
        let wall = |line| Wall { line, thickness: 0.3, weight: 1.0, rooms: [Some(1), Some(2)] };
        let walls = vec![wall(segment([0.0, 0.0], [6.0, 0.0])), wall(segment([0.0, 0.0], [0.0, 4.0]))];
        let segment = segment([1.0, 0.0], [1.9, 0.0]);
        let openings = vec![Opening { kind: OpeningKind::Door, segment, rooms: [1, 2] }];
        Layout { walls, openings, ..Layout::default() }
    }

    #[test]
    fn a_door_knows_its_wall_and_its_opening() {
        let mut layout = layout();
        let inner = layout.fitting(&symbol("door", [1.5, 0.1], 0.1)).unwrap();
        assert_eq!((inner.opening, inner.wall, inner.thickness), (Some(0), Some(0), 0.3));
        assert!(inner.segment.a.y.abs() < 1e-12 && (inner.segment.midpoint().x - 1.5).abs() < 1e-9);
        let outer = symbol("sliding-door", [0.1, 2.0], std::f64::consts::FRAC_PI_2);
        layout.symbols = vec![symbol("door", [1.5, 0.1], 3.1), outer, symbol("window", [4.0, 0.0], 0.0)];
        let further: Vec<Fitting> = layout.further_doors().collect();
        assert_eq!(further.len(), 1);
        assert!(further[0].segment.midpoint().distance(Point::new(0.0, 2.0)) < 1e-9, "{further:?}");
    }

    #[test]
    fn what_has_no_wall_stays_where_it_is() {
        let far = layout().fitting(&symbol("window", [3.0, 1.0], 0.0)).unwrap();
        assert_eq!((far.segment.midpoint(), far.thickness), (Point::new(3.0, 1.0), 0.2));
        let across = layout().fitting(&symbol("window", [3.0, 0.0], 1.0)).unwrap();
        assert_eq!((across.thickness, across.wall), (0.2, None));
        let mut layout = layout();
        layout.symbols = vec![symbol("door", [3.0, 1.0], 0.0)];
        assert_eq!(layout.further_doors().count(), 0);
        assert_eq!(layout.fitting(&symbol("toilet", [3.0, 0.0], 0.0)), None);
    }

    #[test]
    fn walls_without_length_hold_nothing() {
        let line = segment([3.0, 0.0], [3.0, 0.0]);
        let walls = vec![Wall { line, thickness: 0.3, weight: 1.0, rooms: [None, None] }];
        let layout = Layout { walls, ..Layout::default() };
        assert_eq!(layout.fitting(&symbol("window", [3.0, 0.0], 0.0)).unwrap().thickness, 0.2);
    }
}
