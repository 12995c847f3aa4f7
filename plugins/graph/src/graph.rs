//! The graph of a layout.

use crate::place;
use crate::walking::{Floor, entry};
use planform_sdk::{
    Fitting, Layout, OpeningKind, PluginError, Point, Room, RoomId, RoomState, Segment, Wall,
};
use std::collections::BTreeMap;

/// What wrote the graph.
pub const GENERATOR: &str = concat!("planform ", env!("CARGO_PKG_VERSION"));

/// The id of the node for all that is outside.
const OUTSIDE: &str = "outside";

/// The value of an attribute.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A text.
    Text(String),
    /// A finite number.
    Number(f64),
    /// A number of a room.
    Whole(RoomId),
}

/// The attributes of a node or an edge.
pub type Attributes = Vec<(&'static str, Value)>;

/// A node.
pub struct Node {
    /// Its id, unique in the graph.
    pub id: String,
    /// What it says of itself.
    pub attributes: Attributes,
}

/// An edge, which has no direction.
pub struct Edge {
    /// The ids of the nodes that it joins.
    pub ends: [String; 2],
    /// What it says of itself.
    pub attributes: Attributes,
}

/// Rooms, doors, and what joins them.
#[derive(Default)]
pub struct Graph {
    /// Rooms, doors, and the outside, in this order.
    pub nodes: Vec<Node>,
    /// By room, then those to the outside.
    pub edges: Vec<Edge>,
}

/// A door with its pose and with what it joins.
struct Door {
    id: String,
    kind: &'static str,
    segment: Segment,
    /// None is the outside, which comes last.
    rooms: [Option<RoomId>; 2],
    heading: f64,
}

impl Graph {
    /// The graph of a layout. Fails if a coordinate is not finite.
    pub fn of(layout: &Layout) -> Result<Self, PluginError> {
        check_finite(layout)?;
        let doors = doors(layout);
        let mut graph = Self::default();
        graph.nodes.extend(layout.rooms.iter().map(room_node));
        graph.nodes.extend(doors.iter().map(door_node));
        if doors.iter().any(|d| d.rooms.contains(&None)) {
            graph.nodes.push(Node { id: OUTSIDE.into(), attributes: vec![("kind", text("outside"))] });
        }
        let mut ways = BTreeMap::new();
        layout.rooms.iter().for_each(|room| add_ways(&mut ways, room, &doors));
        graph.edges = ways.into_values().map(edge).collect();
        let out = doors.iter().filter(|d| d.rooms.contains(&None));
        let to_outside =
            |d: &Door| edge(Way { ends: [d.id.clone(), OUTSIDE.into()], distance: 0.0, room: None });
        graph.edges.extend(out.map(to_outside));
        Ok(graph)
    }
}

/// Fails unless every coordinate that the graph is made of is a finite number.
fn check_finite(layout: &Layout) -> Result<(), PluginError> {
    let rings = layout.rooms.iter().flat_map(|r| r.inner.rings().flatten());
    let walls = layout.walls.iter().flat_map(|w| [w.line.a, w.line.b]);
    let openings = layout.openings.iter().flat_map(|o| [o.segment.a, o.segment.b]);
    rings.copied().chain(walls).chain(openings).try_for_each(|p| p.finite().map(drop))
}

fn doors(layout: &Layout) -> Vec<Door> {
    let inner = layout.openings.iter().map(|o| {
        let kind = match o.kind {
            OpeningKind::Door => "door",
            OpeningKind::Passage => "passage",
        };
        (kind, o.segment, o.rooms.map(Some))
    });
    let further: Vec<_> = layout.further_doors().collect();
    let outer = further.iter().filter_map(|f| Some(("door", f.segment, rooms_of(f, &layout.walls)?)));
    let number = |(i, (kind, segment, rooms)): (usize, (&'static str, Segment, [Option<RoomId>; 2]))| {
        let id = format!("door-{}", i + 1);
        Door { id, kind, segment, rooms, heading: heading(&segment, rooms, &layout.rooms) }
    };
    inner.chain(outer).enumerate().map(number).collect()
}

/// What a door joins that is none of the layout's openings: the rooms of its wall. The outside comes last.
fn rooms_of(door: &Fitting, walls: &[Wall]) -> Option<[Option<RoomId>; 2]> {
    match walls.get(door.wall?)?.rooms {
        [None, None] => None,
        [None, some] => Some([some, None]),
        [Some(a), Some(b)] if a > b => Some([Some(b), Some(a)]),
        rooms => Some(rooms),
    }
}

/// The direction through a door, from the first of what it joins to the second, radians in (-pi, pi].
fn heading(segment: &Segment, rooms: [Option<RoomId>; 2], all: &[Room]) -> f64 {
    let (sin, cos) = segment.angle().sin_cos();
    let middle = segment.midpoint();
    let floor = |id: Option<RoomId>| all.iter().find(|r| Some(r.id) == id);
    // How far to the left of the door one comes to stand in a room: by the floor beside the door, wherever the rest is.
    let to_left = |room: &Room| {
        let entry = entry(&room.inner, middle);
        cos * (entry.y - middle.y) - sin * (entry.x - middle.x)
    };
    let [first, second] = rooms.map(|id| floor(id).map_or(0.0, to_left));
    let (x, y) = if second >= first { (-sin, cos) } else { (sin, -cos) };
    (y + 0.0).atan2(x + 0.0)
}

fn room_node(room: &Room) -> Node {
    let state = match room.state {
        RoomState::Complete => "complete",
        RoomState::Partial => "partial",
    };
    let (point, centroid) = (place::representative(&room.inner), place::centroid(&room.inner));
    let mut attributes = vec![("kind", text("room")), ("room", Value::Whole(room.id))];
    attributes.extend(room.name.as_deref().map(|name| ("name", text(name))));
    attributes.extend([
        ("state", text(state)),
        ("area", measure(room.area())),
        ("x", measure(point.x)),
        ("y", measure(point.y)),
        ("centroid_x", measure(centroid.x)),
        ("centroid_y", measure(centroid.y)),
    ]);
    Node { id: room_id(room.id), attributes }
}

fn door_node(door: &Door) -> Node {
    let middle = door.segment.midpoint();
    let [from, to] = door.rooms.map(|id| text(&id.map_or_else(|| OUTSIDE.into(), room_id)));
    let attributes = vec![
        ("kind", text(door.kind)),
        ("x", measure(middle.x)),
        ("y", measure(middle.y)),
        ("heading", measure(door.heading)),
        ("width", measure(door.segment.length())),
        ("from", from),
        ("to", to),
    ];
    Node { id: door.id.clone(), attributes }
}

/// A way between two nodes.
struct Way {
    ends: [String; 2],
    distance: f64,
    room: Option<RoomId>,
}

/// The ways, by the room or door that they begin at and the door that they end at. All doors come after all rooms.
type Ways = BTreeMap<(usize, Option<RoomId>, usize), Way>;

/// The ways in a room: from its point to its doors, and between these. Two doors may be in two rooms together: then the
/// shorter way counts.
fn add_ways(ways: &mut Ways, room: &Room, doors: &[Door]) {
    let here: Vec<_> = doors.iter().enumerate().filter(|(_, d)| d.rooms.contains(&Some(room.id))).collect();
    if here.is_empty() {
        return;
    }
    let floor = Floor::new(&room.inner);
    let entries: Vec<Point> = here.iter().map(|(_, d)| entry(&room.inner, d.segment.midpoint())).collect();
    let steps: Vec<f64> =
        here.iter().zip(&entries).map(|((_, d), e)| d.segment.midpoint().distance(*e)).collect();
    let of_room = floor.distances(place::representative(&room.inner), &entries);
    for ((distance, step), (i, door)) in of_room.iter().zip(&steps).zip(&here) {
        let ends = [room_id(room.id), door.id.clone()];
        let way = Way { ends, distance: distance + step, room: Some(room.id) };
        ways.insert((0, Some(room.id), *i), way);
    }
    for (n, (i, door)) in here.iter().enumerate() {
        let between = floor.distances(entries[n], &entries[n + 1..]);
        for ((distance, step), (j, other)) in between.iter().zip(&steps[n + 1..]).zip(&here[n + 1..]) {
            let ends = [door.id.clone(), other.id.clone()];
            let way = Way { ends, distance: steps[n] + distance + step, room: Some(room.id) };
            keep_shorter(ways, (1 + i, None, *j), way);
        }
    }
}

fn keep_shorter(ways: &mut Ways, key: (usize, Option<RoomId>, usize), way: Way) {
    if ways.get(&key).is_none_or(|known| way.distance < known.distance) {
        ways.insert(key, way);
    }
}

fn edge(way: Way) -> Edge {
    let mut attributes = vec![("distance", measure(way.distance))];
    attributes.extend(way.room.map(|room| ("room", Value::Whole(room))));
    Edge { ends: way.ends, attributes }
}

fn room_id(id: RoomId) -> String {
    format!("room-{id}")
}

fn text(text: &str) -> Value {
    Value::Text(text.into())
}

/// A measure to four decimals; one too large for that as it is.
fn measure(value: f64) -> Value {
    let rounded = (value * 1e4).round() / 1e4 + 0.0;
    Value::Number(if rounded.is_finite() { rounded } else { value.clamp(f64::MIN, f64::MAX) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, Polygon, Pose, Symbol};
    use std::f64::consts::{FRAC_PI_2, PI};

    fn rectangle(x: [f64; 2], y: [f64; 2]) -> Polygon {
        let ring = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        Polygon::new(ring.map(Point::from).to_vec(), vec![])
    }

    fn room(id: RoomId, inner: Polygon) -> Room {
        let centre = inner.clone();
        Room { id, name: None, stated_area: None, state: RoomState::Complete, inner, centre }
    }

    fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
        Segment::new(a.into(), b.into())
    }

    /// Two rooms, 2 to the north of 1, with two doors between them and one to the outside, in the west of 1.
    fn layout() -> Layout {
        let opening = |x| Opening {
            kind: OpeningKind::Door,
            segment: segment([x, 3.1], [x + 1.0, 3.1]),
            rooms: [1, 2],
        };
        let wall = Wall {
            line: segment([-0.1, 0.0], [-0.1, 3.0]),
            thickness: 0.2,
            weight: 1.0,
            rooms: [None, Some(1)],
        };
        let pose = Pose { x: -0.1, y: 1.5, yaw: FRAC_PI_2 };
        let symbol =
            Symbol { kind: "door".into(), pose, width: 0.9, height: 0.2, score: 1.0, leaves: vec![] };
        Layout {
            rooms: vec![
                room(1, rectangle([0.0, 8.0], [0.0, 3.0])),
                room(2, rectangle([0.0, 8.0], [3.2, 6.2])),
            ],
            walls: vec![wall],
            openings: vec![opening(1.0), opening(5.0)],
            symbols: vec![symbol],
            ..Layout::default()
        }
    }

    fn value<'a>(attributes: &'a Attributes, name: &str) -> &'a Value {
        &attributes.iter().find(|(n, _)| *n == name).unwrap().1
    }

    fn number(attributes: &Attributes, name: &str) -> f64 {
        match value(attributes, name) {
            Value::Number(v) => *v,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn rooms_doors_and_the_outside_are_nodes() {
        let graph = Graph::of(&layout()).unwrap();
        let ids: Vec<_> = graph.nodes.iter().map(|n| n.id.as_str()).collect();
        assert_eq!(ids, ["room-1", "room-2", "door-1", "door-2", "door-3", "outside"]);
        let headings = [2, 4].map(|i| number(&graph.nodes[i].attributes, "heading"));
        assert!((headings[0] - FRAC_PI_2).abs() < 1e-3 && (headings[1].abs() - PI).abs() < 1e-3);
        assert_eq!(value(&graph.nodes[4].attributes, "to"), &text("outside"));
    }

    #[test]
    fn every_pair_has_one_edge_with_the_way_on_the_floor() {
        let graph = Graph::of(&layout()).unwrap();
        let ends: Vec<_> = graph.edges.iter().map(|e| e.ends.join(" ")).collect();
        assert_eq!(
            ends,
            [
                "room-1 door-1",
                "room-1 door-2",
                "room-1 door-3",
                "room-2 door-1",
                "room-2 door-2",
                "door-1 door-2",
                "door-1 door-3",
                "door-2 door-3",
                "door-3 outside",
            ]
        );
        // Straight onto the floor, along the wall, and straight back into the door.
        assert!((number(&graph.edges[5].attributes, "distance") - 4.2).abs() < 0.01);
        assert_eq!(number(&graph.edges[8].attributes, "distance"), 0.0);
    }

    #[test]
    fn what_is_nowhere_is_refused() {
        let mut layout = layout();
        layout.rooms[0].inner.exterior[0].x = f64::NAN;
        assert!(Graph::of(&layout).is_err());
    }
}
