//! The layers `walls`, `doors` and `frontiers`.

use crate::element::{layer, number, title};
use crate::sheet::Sheet;
use crate::spot::distance_to_segment;
use crate::symbols;
use planform_sdk::{Frontier, FrontierKind, Layout, Opening, OpeningKind, Point, RoomId, Segment, Wall};
use std::collections::BTreeMap;
use svg::node::element::{Group, Line, Path};

/// Least thickness drawn, metres: a wall without one is still seen.
const THINNEST: f64 = 0.02;

/// How much wider than its wall an opening is cut, metres, so that no hairline stays.
const CUT: f64 = 0.01;

/// Weights from which a wall is strong and medium.
const STRONG: f64 = 2.0 / 3.0;
const MEDIUM: f64 = 1.0 / 3.0;

/// The layer `walls`: the surest on top, so that they join without a seam.
pub fn draw(layout: &Layout, sheet: &Sheet) -> Group {
    let joints = joints(&layout.walls);
    let mut walls: Vec<(usize, &Wall)> = (1..).zip(&layout.walls).collect();
    walls.sort_by_key(|(_, w)| strength(w.weight));
    walls.iter().map(|(n, w)| wall(*n, w, cap(w, &joints), sheet)).fold(layer("walls"), Group::add)
}

fn wall(number_of: usize, wall: &Wall, cap: &str, sheet: &Sheet) -> Line {
    let class = ["weak", "medium", "strong"].get(strength(wall.weight)).copied().unwrap_or("weak");
    let room = |id: Option<RoomId>| id.map(|id| id.to_string()).unwrap_or_default();
    line(&wall.line, sheet)
        .set("id", format!("wall-{number_of}"))
        .set("class", format!("wall {class}"))
        .set("stroke-width", number(thickness(wall)))
        .set("stroke-linecap", cap)
        .set("data-weight", number(wall.weight))
        .set("data-left", room(wall.rooms[0]))
        .set("data-right", room(wall.rooms[1]))
}

fn strength(weight: f64) -> usize {
    usize::from(weight >= MEDIUM) + usize::from(weight >= STRONG)
}

fn thickness(wall: &Wall) -> f64 {
    if wall.thickness.is_finite() { wall.thickness.max(THINNEST) } else { THINNEST }
}

fn line(segment: &Segment, sheet: &Sheet) -> Line {
    let (a, b) = (sheet.place(segment.a), sheet.place(segment.b));
    Line::new().set("x1", number(a.x)).set("y1", number(a.y)).set("x2", number(b.x)).set("y2", number(b.y))
}

/// What meets in one point: the angle of the first wall, and whether all others are at right angles or in line.
struct Joint {
    angle: f64,
    square: bool,
}

/// A point to the millimetre.
type Place = (i64, i64);

fn place(p: Point) -> Place {
    ((p.x * 1e3).round() as i64, (p.y * 1e3).round() as i64)
}

fn joints(walls: &[Wall]) -> BTreeMap<Place, Joint> {
    let mut joints: BTreeMap<Place, Joint> = BTreeMap::new();
    for line in walls.iter().map(|w| &w.line) {
        for end in [line.a, line.b] {
            let joint = joints.entry(place(end)).or_insert(Joint { angle: line.angle(), square: true });
            joint.square &= is_square(line.angle() - joint.angle);
        }
    }
    joints
}

/// Whether the angle (radians) is a multiple of a right angle to about a degree.
fn is_square(angle: f64) -> bool {
    (2.0 * angle).sin().abs() < 0.035
}

/// Square ends fill the corner of two walls at right angles; at any other angle they would stick out.
fn cap(wall: &Wall, joints: &BTreeMap<Place, Joint>) -> &'static str {
    let square = |end| joints.get(&place(end)).is_none_or(|j| j.square);
    if square(wall.line.a) && square(wall.line.b) { "square" } else { "round" }
}

/// The layer `doors`: the wall cut from jamb to jamb, and what the opening is; over that the doors' leaves.
pub fn open(layout: &Layout, sheet: &Sheet) -> Group {
    let openings = (1..).zip(&layout.openings).map(|(n, o)| opening(n, o, cut(o, &layout.walls), sheet));
    openings.chain(symbols::doors(layout, sheet)).fold(layer("doors"), Group::add)
}

/// The thickness of the nearest wall between the opening's rooms, else of the thickest wall there is, metres.
fn cut(opening: &Opening, walls: &[Wall]) -> f64 {
    let middle = opening.segment.midpoint();
    let distance = |w: &Wall| distance_to_segment(middle, w.line.a, w.line.b);
    let [a, b] = opening.rooms.map(Some);
    let between = walls.iter().filter(|w| w.rooms == [a, b] || w.rooms == [b, a]);
    let nearest = between.min_by(|v, w| distance(v).total_cmp(&distance(w)));
    nearest.map_or_else(|| walls.iter().map(thickness).fold(THINNEST, f64::max), thickness)
}

fn opening(number_of: usize, opening: &Opening, cut: f64, sheet: &Sheet) -> Group {
    let kind = match opening.kind {
        OpeningKind::Door => "door",
        OpeningKind::Passage => "passage",
    };
    let [a, b] = opening.rooms;
    let group = Group::new()
        .set("id", format!("opening-{number_of}"))
        .set("class", kind)
        .set("data-rooms", format!("{a} {b}"))
        .set("data-width", number(opening.width()))
        .add(title(&format!("{kind} between {a} and {b}, {:.2} m", opening.width())));
    cut_out(group, &opening.segment, cut, sheet)
        .add(line(&opening.segment, sheet).set("class", format!("sill {kind}-sill")))
}

/// Adds the wall's gap, and a jamb at each of its ends. `cut` is the wall's thickness, metres.
pub fn cut_out(group: Group, segment: &Segment, cut: f64, sheet: &Sheet) -> Group {
    let gap = line(segment, sheet).set("class", "gap").set("stroke-width", number(cut.max(THINNEST) + CUT));
    group.add(gap).add(Path::new().set("class", "jamb").set("d", jambs(segment, cut, sheet)))
}

/// Path data of a stroke across the wall at each end of the opening.
fn jambs(segment: &Segment, cut: f64, sheet: &Sheet) -> String {
    let (sin, cos) = segment.angle().sin_cos();
    let (dx, dy) = (-sin * cut / 2.0, cos * cut / 2.0);
    let across = |p: Point| [Point::new(p.x - dx, p.y - dy), Point::new(p.x + dx, p.y + dy)];
    [segment.a, segment.b].map(|end| sheet.path(&across(end), false)).concat()
}

/// The layer `frontiers`.
pub fn frontiers(layout: &Layout, sheet: &Sheet) -> Group {
    (1..).zip(&layout.frontiers).map(|(n, f)| frontier(n, f, sheet)).fold(layer("frontiers"), Group::add)
}

fn frontier(number_of: usize, frontier: &Frontier, sheet: &Sheet) -> Line {
    let leads = match frontier.leads {
        FrontierKind::Room => "room",
        FrontierKind::Space => "space",
    };
    line(&frontier.segment, sheet)
        .set("id", format!("frontier-{number_of}"))
        .set("class", "frontier")
        .set("data-room", frontier.room)
        .set("data-leads", leads)
        .set("data-area", number(frontier.area))
        .add(title(&description(frontier)))
}

/// What a pointer that rests on the frontier shows.
fn description(frontier: &Frontier) -> String {
    let room = frontier.room;
    let whither = match frontier.leads {
        FrontierKind::Room => format!("frontier to the rest of room {room}"),
        FrontierKind::Space => format!("frontier of room {room} to new space"),
    };
    if frontier.area > 0.0 { format!("{whither}, about {:.1} m²", frontier.area) } else { whither }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(a: [f64; 2], b: [f64; 2], thickness: f64, rooms: [RoomId; 2]) -> Wall {
        let line = Segment::new(a.into(), b.into());
        Wall { line, thickness, weight: 1.0, rooms: rooms.map(Some) }
    }

    #[test]
    fn ends_are_square_only_at_right_angles() {
        let walls = [
            wall([0.0, 0.0], [4.0, 0.0], 0.2, [1, 2]),
            wall([0.0, 3.0], [0.0, 0.0], 0.2, [1, 2]),
            wall([4.0, 0.0], [6.0, 2.0], 0.2, [1, 2]),
        ];
        let joints = joints(&walls);
        assert_eq!(walls.each_ref().map(|w| cap(w, &joints)), ["round", "square", "round"]);
    }

    #[test]
    fn opening_is_cut_as_thick_as_its_wall() {
        let walls = [
            wall([0.0, 0.0], [4.0, 0.0], 0.1, [2, 1]),
            wall([0.0, 5.0], [4.0, 5.0], 0.3, [1, 2]),
            wall([0.0, 0.1], [4.0, 0.1], 0.5, [1, 3]),
        ];
        let opening = |rooms| Opening {
            kind: OpeningKind::Door,
            segment: Segment::new(Point::new(1.0, 0.0), Point::new(2.0, 0.0)),
            rooms,
        };
        assert_eq!(cut(&opening([1, 2]), &walls), 0.1);
        assert_eq!(cut(&opening([4, 5]), &walls), 0.5);
        assert_eq!(cut(&opening([4, 5]), &[]), THINNEST);
    }

    #[test]
    fn thickness_is_always_drawable() {
        for t in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(thickness(&wall([0.0, 0.0], [1.0, 0.0], t, [1, 2])), THINNEST);
        }
    }

    #[test]
    fn weights_make_three_classes() {
        assert_eq!([0.0, 0.33, 0.34, 0.66, 0.67, 1.0, f64::NAN].map(strength), [0, 0, 1, 1, 2, 2, 0]);
    }
}
