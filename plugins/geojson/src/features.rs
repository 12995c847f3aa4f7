//! One feature for each thing in a layout.

use crate::frame::Frame;
use geojson::{Feature, Geometry, GeometryValue, feature::Id};
use planform_sdk::{
    Boundary, ErrorKind, Frontier, FrontierKind, Layout, Opening, OpeningKind, Options, PluginError, Point,
    Polygon, Pose, RepresentativeLine, Room, RoomState, Segment, Symbol, Text, Wall, ring_signed_area,
};
use serde_json::{Value, json};

/// An arc has so many edges.
const STEPS: u32 = 12;

type Made = Result<Feature, PluginError>;

/// All features: rooms, walls, openings, frontiers, lines (if asked for), texts, symbols, leaves of doors.
pub fn all(layout: &Layout, frame: &Frame, options: &Options) -> Result<Vec<Feature>, PluginError> {
    let boundary = Boundary::chosen(options);
    let lines = if options.flag("lines") { layout.lines.as_slice() } else { &[] };
    let rooms = layout.rooms.iter().map(|r| room(r, boundary, frame));
    let walls = numbered(&layout.walls).map(|(n, w)| wall(n, w, frame));
    let openings = numbered(&layout.openings).map(|(n, o)| opening(n, o, frame));
    let frontiers = numbered(&layout.frontiers).map(|(n, f)| frontier(n, f, frame));
    let lines = numbered(lines).map(|(n, l)| line(n, l, frame));
    let texts = numbered(&layout.texts).map(|(n, t)| text(n, t, frame));
    let symbols = numbered(&layout.symbols).map(|(n, s)| symbol(n, s, layout, frame));
    let leaves = numbered(&layout.symbols).flat_map(|(n, s)| leaves(n, s, frame));
    let drawn = rooms.chain(walls).chain(openings).chain(frontiers).chain(lines);
    drawn.chain(texts).chain(symbols).chain(leaves).collect()
}

/// The items with their numbers, from 1.
fn numbered<T>(items: &[T]) -> impl Iterator<Item = (usize, &T)> {
    (1..).zip(items)
}

fn room(room: &Room, boundary: Boundary, frame: &Frame) -> Made {
    let state = match room.state {
        RoomState::Complete => "complete",
        RoomState::Partial => "partial",
    };
    let id = format!("room-{}", room.id);
    let geometry = polygon(boundary.of(room), frame).map_err(|e| inside(&id, e));
    let properties = json!({
        "kind": "room", "room": room.id, "name": room.name, "state": state, "area": measure(room.area()),
    });
    feature(id, geometry?, properties)
}

fn wall(number: usize, wall: &Wall, frame: &Frame) -> Made {
    let properties = json!({
        "kind": "wall", "thickness": measure(wall.thickness), "weight": measure(wall.weight),
        "left": wall.rooms[0], "right": wall.rooms[1],
    });
    along(format!("wall-{number}"), &wall.line, properties, frame)
}

fn opening(number: usize, opening: &Opening, frame: &Frame) -> Made {
    let kind = match opening.kind {
        OpeningKind::Door => "door",
        OpeningKind::Passage => "passage",
    };
    let properties = json!({"kind": kind, "width": measure(opening.width()), "rooms": opening.rooms});
    along(format!("opening-{number}"), &opening.segment, properties, frame)
}

fn frontier(number: usize, frontier: &Frontier, frame: &Frame) -> Made {
    let leads = match frontier.leads {
        FrontierKind::Room => "room",
        FrontierKind::Space => "space",
    };
    let properties = json!({
        "kind": "frontier", "room": frontier.room, "leads": leads, "area": measure(frontier.area),
    });
    along(format!("frontier-{number}"), &frontier.segment, properties, frame)
}

fn line(number: usize, line: &RepresentativeLine, frame: &Frame) -> Made {
    let properties = json!({"kind": "line", "support": measure(line.support)});
    along(format!("line-{number}"), &line.segment, properties, frame)
}

fn text(number: usize, text: &Text, frame: &Frame) -> Made {
    let properties = json!({
        "kind": "text", "text": text.content, "yaw": measure(text.pose.yaw.to_degrees()),
        "width": measure(text.width), "height": measure(text.height), "confidence": measure(text.confidence),
    });
    at(format!("text-{number}"), &text.pose, properties, frame)
}

fn symbol(number: usize, symbol: &Symbol, layout: &Layout, frame: &Frame) -> Made {
    let opening = layout.fitting(symbol).and_then(|f| f.opening).map(|i| format!("opening-{}", i + 1));
    let mut properties = json!({
        "kind": "symbol", "symbol": symbol.kind, "yaw": measure(symbol.pose.yaw.to_degrees()),
        "width": measure(symbol.width), "height": measure(symbol.height), "score": measure(symbol.score),
    });
    if symbol.is_door() {
        properties["opening"] = json!(opening);
    }
    at(format!("symbol-{number}"), &symbol.pose, properties, frame)
}

/// The leaves of a door, each as it is drawn: from the hinge to the free end, open, and on its way to where it closes.
fn leaves(number: usize, symbol: &Symbol, frame: &Frame) -> impl Iterator<Item = Made> {
    numbered(&symbol.leaves).map(move |(n, leaf)| {
        let properties = json!({
            "kind": "leaf", "symbol": format!("symbol-{number}"), "width": measure(leaf.length()),
            "swing": measure(leaf.swing().to_degrees()),
        });
        let way = (0..=STEPS).rev().map(|i| leaf.at(f64::from(i) / f64::from(STEPS)));
        let points: Vec<Point> = std::iter::once(leaf.hinge).chain(way).collect();
        path(format!("leaf-{number}-{n}"), &points, properties, frame)
    })
}

fn along(id: String, segment: &Segment, properties: Value, frame: &Frame) -> Made {
    path(id, &[segment.a, segment.b], properties, frame)
}

fn path(id: String, points: &[Point], properties: Value, frame: &Frame) -> Made {
    let positions = frame.project(points).map_err(|e| inside(&id, e))?;
    let positions = positions.into_iter().map(|p| frame.round(p));
    feature(id, GeometryValue::new_line_string(positions), properties)
}

fn at(id: String, pose: &Pose, properties: Value, frame: &Frame) -> Made {
    let position = frame.project_point(Point::new(pose.x, pose.y)).map_err(|e| inside(&id, e))?;
    feature(id, GeometryValue::new_point(frame.round(position)), properties)
}

/// All rings of an outline, projected together so that the antimeridian parts none from another.
fn polygon(outline: &Polygon, frame: &Frame) -> Result<GeometryValue, PluginError> {
    let points: Vec<Point> = outline.rings().flatten().copied().collect();
    let mut positions = frame.project(&points)?.into_iter();
    let rings = outline
        .rings()
        .enumerate()
        .map(|(i, r)| ring(positions.by_ref().take(r.len()).map(|p| frame.round(p)).collect(), i > 0))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(GeometryValue::new_polygon(rings))
}

/// A closed ring without repeated positions: clockwise for a hole, else counter-clockwise (RFC 7946, 3.1.6).
fn ring(mut ring: Vec<[f64; 2]>, hole: bool) -> Result<Vec<[f64; 2]>, PluginError> {
    ring.dedup();
    while ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    if ring.len() < 3 {
        let what = if hole { "a hole" } else { "the outline" };
        let message = format!("{what} has {} distinct corners at 0.1 mm, and a ring needs 3", ring.len());
        return Err(PluginError::new(ErrorKind::BadInput, message)
            .advise("correct the layout, or try the option boundary with its other value"));
    }
    let points: Vec<Point> = ring.iter().copied().map(Point::from).collect();
    if (ring_signed_area(&points) > 0.0) == hole {
        ring.reverse();
    }
    ring.extend(ring.first().copied());
    Ok(ring)
}

/// The error with the feature that it befell.
fn inside(id: &str, e: PluginError) -> PluginError {
    PluginError { message: format!("{id}: {}", e.message), ..e }
}

/// A measure to four decimals, or null when it is not finite.
fn measure(value: f64) -> Value {
    json!((value * 1e4).round() / 1e4 + 0.0)
}

fn feature(id: String, geometry: GeometryValue, properties: Value) -> Made {
    Ok(Feature {
        id: Some(Id::String(id)),
        geometry: Some(Geometry::new(geometry)),
        properties: properties.as_object().cloned(),
        ..Feature::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn rings_are_closed_and_wound_whatever_the_input() {
        let (there, mut back) = (SQUARE.to_vec(), SQUARE.to_vec());
        back.reverse();
        for (input, hole) in [(&there, false), (&back, false), (&there, true), (&back, true)] {
            let made = ring(input.clone(), hole).unwrap();
            assert_eq!((made.len(), made.first()), (5, made.last()));
            let points: Vec<Point> = made[..4].iter().copied().map(Point::from).collect();
            assert_eq!(ring_signed_area(&points), if hole { -1.0 } else { 1.0 });
        }
    }

    #[test]
    fn repeated_positions_go() {
        let twice = SQUARE.iter().flat_map(|&p| [p, p]).chain([SQUARE[0]]).collect();
        assert_eq!(ring(twice, false).unwrap().len(), 5);
    }

    #[test]
    fn ring_of_two_corners_is_refused() {
        let e = ring(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], false).unwrap_err();
        assert!(e.to_string().contains("has 2 distinct corners"), "{e}");
        assert!(ring(vec![], true).is_err());
    }

    #[test]
    fn fault_names_its_feature() {
        let far = Segment::new(Point::new(f64::NAN, 0.0), Point::default());
        let walls = vec![Wall { line: far, thickness: 0.1, weight: 1.0, rooms: [None, None] }];
        let layout = Layout { walls, ..Layout::default() };
        let e = all(&layout, &Frame::Map, &Options::default()).unwrap_err();
        assert_eq!(e.kind, ErrorKind::BadInput);
        assert!(e.message.starts_with("wall-1: the point (NaN, 0)"), "{e}");
    }
}
