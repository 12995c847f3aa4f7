//! Doors that the document shows as such: where they are in the grid, and which openings are theirs.

use super::directions::{difference, line_angle};
use super::openings::Gap;
use super::shown::from_corner;
use planform_sdk::{OpeningKind, Point, Scene, Segment, Symbol};

/// A door is wider than this, metres; what is drawn smaller is none.
const LEAST_WIDTH: f64 = 0.3;

/// And not wider than this, metres.
const MOST_WIDTH: f64 = 8.0;

/// An opening is a door's if they differ in direction by at most this, radians.
const TURN: f64 = 0.3;

/// And if it lies at most this far from the door's wall, metres.
const BESIDE: f64 = 0.2;

/// A door, metres from the grid's corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Door {
    /// From jamb to jamb along the middle of the wall.
    pub segment: Segment,
    /// Thickness of the wall.
    pub thickness: f64,
}

/// The doors that a scene's symbols show.
pub fn of_scene(scene: &Scene) -> Vec<Door> {
    let doors = scene.symbols.iter().filter(|s| s.is_door());
    doors.filter_map(|symbol| door(scene, symbol)).collect()
}

fn door(scene: &Scene, symbol: &Symbol) -> Option<Door> {
    let (sin, cos) = symbol.pose.yaw.sin_cos();
    let end = |sense: f64| {
        let half = sense * symbol.width / 2.0;
        from_corner(scene, Point::new(symbol.pose.x + half * cos, symbol.pose.y + half * sin))
    };
    let segment = Segment::new(end(-1.0), end(1.0));
    let width = LEAST_WIDTH..MOST_WIDTH;
    width.contains(&segment.length()).then(|| Door { segment, thickness: symbol.height.clamp(0.0, 1.0) })
}

/// The opening as the document shows it: the nearest door in its wall gives it its jambs. Others stay as they are.
pub fn settled(gap: &Gap, doors: &[Door]) -> Gap {
    let own = doors.iter().filter(|door| is_in(door, &gap.segment));
    let middle = gap.segment.midpoint();
    let own = own.min_by(|a, b| {
        let distance = |door: &Door| door.segment.midpoint().distance(middle);
        distance(a).total_cmp(&distance(b))
    });
    own.map_or_else(
        || gap.clone(),
        |door| Gap { kind: OpeningKind::Door, segment: on_wall(door, &gap.segment), rooms: gap.rooms },
    )
}

/// Whether a door lies on an opening's line, and there.
fn is_in(door: &Door, opening: &Segment) -> bool {
    let length = opening.length();
    if length <= 0.0 {
        return false;
    }
    let (along, beside) = place(door.segment.midpoint(), opening);
    let turned = difference(line_angle(&door.segment), line_angle(opening)).abs();
    turned <= TURN && beside.abs() <= door.thickness / 2.0 + BESIDE && (0.0..=length).contains(&along)
}

/// The door's jambs on the opening's line.
fn on_wall(door: &Door, opening: &Segment) -> Segment {
    let ends = [door.segment.a, door.segment.b].map(|jamb| place(jamb, opening).0);
    let at = |along: f64| {
        let share = along / opening.length();
        let (a, b) = (opening.a, opening.b);
        Point::new(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))
    };
    Segment::new(at(ends[0].min(ends[1])), at(ends[0].max(ends[1])))
}

/// Where a point lies: how far along a segment from its first end, and how far to its left.
fn place(p: Point, segment: &Segment) -> (f64, f64) {
    let (a, b) = (segment.a, segment.b);
    let length = segment.length();
    let (dx, dy) = ((b.x - a.x) / length, (b.y - a.y) / length);
    let (x, y) = (p.x - a.x, p.y - a.y);
    (x * dx + y * dy, y * dx - x * dy)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Cell, Grid, Pose, Provenance};

    fn symbol(kind: &str, x: f64, y: f64, yaw: f64, width: f64) -> Symbol {
        let pose = Pose { x, y, yaw };
        Symbol { kind: kind.into(), pose, width, height: 0.2, score: 0.9, leaves: Vec::new() }
    }

    fn scene(symbols: Vec<Symbol>) -> Scene {
        let origin = Pose { x: 5.0, y: -1.0, yaw: std::f64::consts::FRAC_PI_2 };
        let grid = Grid::new(100, 100, 0.1, origin, vec![Cell::FREE; 10_000]).unwrap();
        Scene { symbols, ..Scene::of_grid(grid, Provenance::default()) }
    }

    fn gap(from: [f64; 2], to: [f64; 2]) -> Gap {
        Gap { kind: OpeningKind::Passage, segment: Segment::new(from.into(), to.into()), rooms: [0, 1] }
    }

    #[test]
    fn doors_lie_in_the_grids_own_frame() {
        // The grid's x runs along the map's y.
        let doors = of_scene(&scene(vec![symbol("sliding-door", 3.0, 1.0, 0.0, 1.0)]));
        let found = doors[0].segment;
        assert!(
            found.a.distance(Point::new(2.0, 2.5)) < 1e-9 && found.b.distance(Point::new(2.0, 1.5)) < 1e-9
        );
    }

    #[test]
    fn other_symbols_and_impossible_widths_are_no_doors() {
        let none = [
            symbol("window", 3.0, 1.0, 0.0, 1.0),
            symbol("door", 3.0, 1.0, 0.0, 0.1),
            symbol("door", 3.0, 1.0, 0.0, f64::NAN),
            symbol("door", f64::INFINITY, 1.0, 0.0, 1.0),
            symbol("door", 3.0, 1.0, 0.0, 1e9),
        ];
        assert_eq!(of_scene(&scene(none.to_vec())), []);
    }

    #[test]
    fn an_opening_takes_the_jambs_of_its_door() {
        let segment = Segment::new(Point::new(2.1, 1.05), Point::new(3.0, 1.05));
        let doors = [Door { segment, thickness: 0.2 }];
        let found = settled(&gap([4.5, 1.0], [2.0, 1.0]), &doors);
        assert_eq!((found.kind, found.rooms), (OpeningKind::Door, [0, 1]));
        let ends = [found.segment.a, found.segment.b];
        assert!(
            ends[0].distance(Point::new(3.0, 1.0)) < 1e-9 && ends[1].distance(Point::new(2.1, 1.0)) < 1e-9
        );
    }

    #[test]
    fn openings_elsewhere_stay_as_they_are() {
        let segment = Segment::new(Point::new(2.1, 1.0), Point::new(3.0, 1.0));
        let doors = [Door { segment, thickness: 0.2 }];
        for other in [gap([2.0, 2.0], [3.0, 2.0]), gap([2.5, 0.5], [2.5, 1.5]), gap([5.0, 1.0], [6.0, 1.0])] {
            assert_eq!(settled(&other, &doors), other);
        }
        let point = gap([2.5, 1.0], [2.5, 1.0]);
        assert_eq!(settled(&point, &doors), point);
    }
}
