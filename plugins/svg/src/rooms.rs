//! The layers `rooms` and `labels`.

use crate::element::{layer, legal, number, title, with_text};
use crate::sheet::Sheet;
use crate::spot::roomiest;
use planform_sdk::{Boundary, Layout, Point, Polygon, Room, RoomId, RoomState};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use svg::node::element::{Element, Group, Path};

/// Number of the classes `fill-0`, `fill-1`, ... in the style sheet.
pub const FILLS: usize = 7;

/// Height of the lettering where there is space enough, metres.
const LETTERING: f64 = 0.45;

/// Smallest lettering, metres: a label that fits nowhere is still found.
const SMALLEST: f64 = 0.02;

/// Size of the area's line by that of the name's.
const AREA_LINE: f64 = 0.75;

/// Height of both lines, in ems of the name's.
const LINES: f64 = 2.2;

/// The layer `rooms`: one path for each, filled so that neighbours differ.
pub fn draw(layout: &Layout, boundary: Boundary, sheet: &Sheet) -> Group {
    let fills = fills(layout);
    let paths = layout.rooms.iter().map(|room| {
        let fill = fills.get(&room.id).copied().unwrap_or_default();
        path(room, &name(room, layout), boundary.of(room), fill, sheet)
    });
    paths.fold(layer("rooms"), Group::add)
}

fn path(room: &Room, name: &str, outline: &Polygon, fill: usize, sheet: &Sheet) -> Path {
    let state = match room.state {
        RoomState::Complete => "complete",
        RoomState::Partial => "partial",
    };
    let data: String = outline.rings().map(|r| sheet.path(r, true)).collect();
    Path::new()
        .set("id", format!("room-{}", room.id))
        .set("class", format!("room {state} fill-{fill}"))
        .set("data-id", room.id)
        .set("data-name", legal(room.name.as_deref().unwrap_or_default()))
        .set("data-area", number(room.area()))
        .set("fill-rule", "evenodd")
        .set("d", data)
        .add(title(&format!("{name}, {}, {state}", area(room))))
}

fn given_name(room: &Room) -> Option<&str> {
    room.name.as_deref().filter(|n| !n.trim().is_empty())
}

/// What people call a room: its name, or its number, as `#7` where other rooms have names, which may be numbers too.
fn name(room: &Room, layout: &Layout) -> String {
    let others = || layout.rooms.iter().any(|r| given_name(r).is_some());
    let number = || format!("{}{}", if others() { "#" } else { "" }, room.id);
    given_name(room).map_or_else(number, str::to_owned)
}

fn area(room: &Room) -> String {
    format!("{:.1} m²", room.area())
}

/// A fill for each room: rooms with many neighbours first, each the one that fewest neighbours have, then fewest
/// rooms.
fn fills(layout: &Layout) -> BTreeMap<RoomId, usize> {
    let neighbours = neighbours(layout);
    let degree = |id: &RoomId| neighbours.get(id).map_or(0, BTreeSet::len);
    let mut order: Vec<RoomId> = layout.rooms.iter().map(|r| r.id).collect();
    order.sort_by_key(|id| (Reverse(degree(id)), *id));
    let mut fills = BTreeMap::new();
    let mut uses = [0; FILLS];
    for id in order {
        let beside: Vec<usize> =
            neighbours.get(&id).into_iter().flatten().filter_map(|n| fills.get(n)).copied().collect();
        let clashes = |fill: usize| beside.iter().filter(|&&f| f == fill).count();
        let best = (0..FILLS).zip(&mut uses).min_by_key(|(fill, uses)| (clashes(*fill), **uses));
        if let Some((fill, uses)) = best {
            *uses += 1;
            fills.insert(id, fill);
        }
    }
    fills
}

/// The rooms that share a wall or an opening with each room.
fn neighbours(layout: &Layout) -> BTreeMap<RoomId, BTreeSet<RoomId>> {
    let across_walls = layout.walls.iter().filter_map(|w| match w.rooms {
        [Some(a), Some(b)] => Some([a, b]),
        _ => None,
    });
    let mut neighbours: BTreeMap<RoomId, BTreeSet<RoomId>> = BTreeMap::new();
    for [a, b] in across_walls.chain(layout.openings.iter().map(|o| o.rooms)).filter(|[a, b]| a != b) {
        neighbours.entry(a).or_default().insert(b);
        neighbours.entry(b).or_default().insert(a);
    }
    neighbours
}

/// The layer `labels`: name or number, and area, as large as the room allows.
pub fn label(layout: &Layout, boundary: Boundary, sheet: &Sheet) -> Group {
    layout
        .rooms
        .iter()
        .filter_map(|r| label_one(r, &name(r, layout), boundary.of(r), sheet))
        .fold(layer("labels"), Group::add)
}

fn label_one(room: &Room, name: &str, outline: &Polygon, sheet: &Sheet) -> Option<Group> {
    let area = area(room);
    let width = ems(name).max(AREA_LINE * ems(&area));
    let spot = roomiest(outline, width / LINES)?;
    // The largest box in the spot's ellipse is smaller than it by the root of two.
    let size = (std::f64::consts::SQRT_2 * spot.radius / LINES).clamp(SMALLEST, LETTERING);
    let at = sheet.place(spot.centre);
    Some(
        Group::new()
            .set("id", format!("label-{}", room.id))
            .set("class", "label")
            .add(line(name, "name", Point::new(at.x, at.y - 0.15 * size), size))
            .add(line(&area, "area", Point::new(at.x, at.y + 0.8 * size), AREA_LINE * size)),
    )
}

fn line(text: &str, class: &str, at: Point, size: f64) -> Element {
    let mut line = with_text("text", text);
    for (name, value) in [("x", number(at.x)), ("y", number(at.y)), ("font-size", number(size))] {
        svg::Node::assign(&mut line, name, value);
    }
    svg::Node::assign(&mut line, "class", class);
    line
}

/// About how wide a text is set, in ems: the fonts of the reader are not known.
pub fn ems(text: &str) -> f64 {
    // From Hangul on, writing is mostly as wide as high.
    let em = |c: char| if c >= '\u{1100}' { 1.0 } else { 0.62 };
    text.chars().map(em).sum::<f64>().max(0.62)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Segment, Wall};

    fn room(id: RoomId) -> Room {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
        let outline = Polygon::new(square, vec![]);
        let (inner, centre) = (outline.clone(), outline);
        Room { id, name: None, stated_area: None, state: RoomState::Complete, inner, centre }
    }

    fn wall(a: RoomId, b: RoomId) -> Wall {
        Wall { line: Segment::default(), thickness: 0.1, weight: 1.0, rooms: [Some(a), Some(b)] }
    }

    #[test]
    fn neighbours_differ() {
        // A wheel: a corridor between twelve rooms in a ring.
        let spokes = (2..14).map(|i| wall(1, i));
        let rim = (2..14).map(|i| wall(i, if i == 13 { 2 } else { i + 1 }));
        let walls: Vec<Wall> = spokes.chain(rim).collect();
        let layout = Layout { rooms: (1..14).map(room).collect(), walls, ..Layout::default() };
        let fills = fills(&layout);
        assert_eq!(fills.len(), 13);
        for w in &layout.walls {
            let [a, b] = w.rooms.map(|r| fills[&r.unwrap()]);
            assert_ne!(a, b, "{:?}", w.rooms);
        }
    }

    #[test]
    fn more_neighbours_than_fills_is_no_fault() {
        let ids = || 1..=10;
        let walls = ids().flat_map(|a| (a + 1..=10).map(move |b| wall(a, b))).collect();
        let layout = Layout { rooms: ids().map(room).collect(), walls, ..Layout::default() };
        assert!(fills(&layout).values().all(|&f| f < FILLS));
    }

    #[test]
    fn long_names_are_set_smaller() {
        let sheet = Sheet { origin: Point::new(0.0, 4.0), width: 4.0, height: 4.0 };
        let size = |name: &str| {
            let text = label_one(&room(1), name, &room(1).inner, &sheet).unwrap().to_string();
            let rest = text.split_once("font-size=\"").unwrap().1;
            rest[..rest.find('"').unwrap()].parse::<f64>().unwrap()
        };
        assert_eq!(size("Hall"), LETTERING);
        let name = "A very long name of a very small room";
        let width = size(name) * ems(name);
        assert!(width < 4.0 && width > 2.5, "{width}");
    }

    #[test]
    fn blank_name_gives_the_number() {
        let blank = Room { name: Some(" ".into()), ..room(7) };
        let mut layout = Layout { rooms: vec![blank.clone(), room(8)], ..Layout::default() };
        assert_eq!(name(&blank, &layout), "7");
        layout.rooms[1].name = Some("7".into());
        assert_eq!([name(&blank, &layout), name(&layout.rooms[1], &layout)], ["#7", "7"]);
    }
}
