//! The layout of a building: the result of a reconstruction.

use crate::{GeoAnchor, Point, Polygon, Provenance, Scale, Segment, Symbol, Text, bounds};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Number of a room, unique in its layout, from 1.
pub type RoomId = u32;

/// The layout of one floor. Every coordinate is in metres in the map frame, x right, y up.
///
/// Rings are valid by OGC simple features, exteriors run counter-clockwise, and no two rooms overlap.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Layout {
    /// The rooms, by rising id.
    pub rooms: Vec<Room>,
    /// The walls.
    pub walls: Vec<Wall>,
    /// Doors and passages between two rooms.
    pub openings: Vec<Opening>,
    /// Where explored space of a partial room meets the unexplored.
    pub frontiers: Vec<Frontier>,
    /// The lines along which the building's walls are aligned.
    pub lines: Vec<RepresentativeLine>,
    /// The document's texts.
    pub texts: Vec<Text>,
    /// The document's symbols.
    pub symbols: Vec<Symbol>,
    /// Where the map frame lies on the Earth, if known.
    pub anchor: Option<GeoAnchor>,
    /// How large the document shows the building, if that had to be found out, as for plans.
    #[serde(default)]
    pub scale: Option<Scale>,
    /// The document and the adapter that read it.
    pub provenance: Provenance,
    /// Name of the reconstruction method.
    pub method: String,
}

/// One room.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Room {
    /// Its number, from 1.
    #[schemars(range(min = 1))]
    pub id: RoomId,
    /// What the document calls it, if it does.
    pub name: Option<String>,
    /// The floor area that the document states for it, square metres, if it does.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub stated_area: Option<f64>,
    /// Whether all of it was seen.
    pub state: RoomState,
    /// Its floor: the polygon along the inner faces of its walls.
    pub inner: Polygon,
    /// The polygon along the centre lines of its walls. Neighbouring rooms share its edges.
    pub centre: Polygon,
}

impl Room {
    /// Floor area within the walls' inner faces, square metres.
    pub fn area(&self) -> f64 {
        self.inner.area()
    }

    /// Whether a text stands in the room and its words are a part of the room's name, which may be put together of several
    /// texts: then the room's label shows it already.
    pub fn is_called(&self, text: &Text) -> bool {
        let spaced =
            |s: &str| s.split_whitespace().flat_map(|word| [" ", word]).chain([" "]).collect::<String>();
        let middle = Point::new(text.pose.x, text.pose.y);
        let says =
            |name: &str| !text.content.trim().is_empty() && spaced(name).contains(&spaced(&text.content));
        self.name.as_deref().is_some_and(says)
            && (self.centre.contains(middle) || self.inner.contains(middle))
    }
}

/// Whether all of a room was seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RoomState {
    /// Seen whole.
    Complete,
    /// Seen in part; the unseen part of its outline is an estimate.
    Partial,
}

/// One straight wall.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Wall {
    /// Its centre line.
    pub line: Segment,
    /// Distance between its two faces, metres.
    #[schemars(range(min = 0))]
    pub thickness: f64,
    /// The share of it that the document shows as obstacle, 0 to 1: how sure the wall is.
    #[schemars(range(min = 0, max = 1))]
    pub weight: f64,
    /// The rooms to its left and right, seen from the first end of its line to the second; none is outside.
    #[schemars(inner(range(min = 1)))]
    pub rooms: [Option<RoomId>; 2],
}

/// Kind of an opening.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum OpeningKind {
    /// An opening of a door's width.
    Door,
    /// A wider opening.
    Passage,
}

/// An opening in the wall between two rooms.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Opening {
    /// Door or passage.
    pub kind: OpeningKind,
    /// From jamb to jamb, along the wall's centre line.
    pub segment: Segment,
    /// The two rooms it joins, the smaller id first.
    #[schemars(inner(range(min = 1)))]
    pub rooms: [RoomId; 2],
}

impl Opening {
    /// Clear width, metres.
    pub fn width(&self) -> f64 {
        self.segment.length()
    }
}

/// A boundary between explored and unexplored space.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Frontier {
    /// Where it runs.
    pub segment: Segment,
    /// The partial room it belongs to.
    #[schemars(range(min = 1))]
    pub room: RoomId,
    /// Where it leads.
    #[serde(default)]
    pub leads: FrontierKind,
    /// An estimate of the area behind it, square metres; 0 is none.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub area: f64,
}

/// Where a frontier leads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FrontierKind {
    /// To the rest of its room, whose outline is known or estimated: who goes there finds no other room.
    Room,
    /// To space of which nothing is known.
    #[default]
    Space,
}

/// A line along which walls are aligned, clipped to the building's surroundings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RepresentativeLine {
    /// Where it runs.
    pub segment: Segment,
    /// Total length of the wall segments that it stands for, metres.
    #[schemars(range(min = 0))]
    pub support: f64,
}

/// Rooms and the ways between them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RoomGraph {
    /// The rooms, by rising id.
    pub nodes: Vec<RoomId>,
    /// Pairs of rooms joined by at least one opening, smaller id first, in rising order.
    pub edges: Vec<GraphEdge>,
}

/// Two rooms that are joined.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct GraphEdge {
    /// The two rooms, smaller id first.
    pub rooms: [RoomId; 2],
    /// Indices into [`Layout::openings`].
    pub openings: Vec<usize>,
}

impl Layout {
    /// The room graph: a node for each room, an edge for each pair that an opening joins.
    pub fn graph(&self) -> RoomGraph {
        let mut edges: BTreeMap<[RoomId; 2], Vec<usize>> = BTreeMap::new();
        for (i, opening) in self.openings.iter().enumerate() {
            edges.entry(opening.rooms).or_default().push(i);
        }
        let edges = edges.into_iter().map(|(rooms, openings)| GraphEdge { rooms, openings }).collect();
        RoomGraph { nodes: self.rooms.iter().map(|r| r.id).collect(), edges }
    }

    /// The smallest and the largest coordinates of rooms and walls, or `None` for an empty layout.
    pub fn bounds(&self) -> Option<(Point, Point)> {
        let rooms =
            self.rooms.iter().flat_map(|r| r.centre.exterior.iter().chain(&r.inner.exterior)).copied();
        let walls = self.walls.iter().flat_map(|w| [w.line.a, w.line.b]);
        bounds(rooms.chain(walls))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opening(rooms: [RoomId; 2]) -> Opening {
        Opening { kind: OpeningKind::Door, segment: Segment::default(), rooms }
    }

    #[test]
    fn graph_joins_each_pair_once() {
        let layout =
            Layout { openings: vec![opening([2, 3]), opening([1, 2]), opening([2, 3])], ..Layout::default() };
        let edges = layout.graph().edges;
        assert_eq!(edges.len(), 2);
        assert_eq!((edges[1].rooms, edges[1].openings.as_slice()), ([2, 3], [0, 2].as_slice()));
    }

    fn text_at(content: &str, x: f64) -> Text {
        let pose = crate::Pose { x, y: 2.0, yaw: 0.0 };
        Text { content: content.into(), pose, width: 1.0, height: 0.2, confidence: 1.0 }
    }

    #[test]
    fn a_room_is_called_what_its_name_is_made_of() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
        let outline = Polygon::new(square, vec![]);
        let (name, centre) = (Some("Meeting Room 12".into()), outline.clone());
        let room =
            Room { id: 1, name, stated_area: None, state: RoomState::Complete, inner: outline, centre };
        for (content, x, is) in [
            ("Meeting  Room", 1.0, true),
            ("12", 1.0, true),
            ("12", 5.0, false),
            ("1", 1.0, false),
            ("Meeting Room 13", 1.0, false),
            (" ", 1.0, false),
        ] {
            assert_eq!(room.is_called(&text_at(content, x)), is, "{content} at {x}");
        }
    }

    #[test]
    fn layout_survives_json() {
        let square = Polygon::new([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]].map(Point::from).to_vec(), vec![]);
        let room = Room {
            id: 1,
            name: Some("Küche".into()),
            stated_area: Some(12.5),
            state: RoomState::Partial,
            inner: square.clone(),
            centre: square,
        };
        let layout = Layout { rooms: vec![room], ..Layout::default() };
        let text = serde_json::to_string(&layout).unwrap();
        assert_eq!(serde_json::from_str::<Layout>(&text).unwrap(), layout);
    }

    #[test]
    fn layouts_of_before_there_were_scales_can_be_read() {
        let symbol = r#"{"kind":"door","pose":{"x":1,"y":2,"yaw":0},"width":1,"height":1,"score":1}"#;
        let room = r#"{"id":1,"name":null,"state":"complete","inner":{"exterior":[],"holes":[]},
            "centre":{"exterior":[],"holes":[]}}"#;
        let text = format!(
            r#"{{"rooms":[{room}],"walls":[],"openings":[],"frontiers":[],"lines":[],"texts":[],
            "symbols":[{symbol}],"anchor":null,"provenance":{{"source":"","adapter":""}},"method":""}}"#
        );
        let layout: Layout = serde_json::from_str(&text).unwrap();
        assert_eq!((layout.scale, layout.rooms[0].stated_area), (None, None));
        assert!(layout.symbols[0].leaves.is_empty());
    }
}
