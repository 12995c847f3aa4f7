//! What is written, read back as JSON.

#![allow(clippy::unwrap_used)]

use geojson::{FeatureCollection, GeometryValue, feature::Id};
use planform_sdk::{
    Document, DoorLeaf, GeoAnchor, Layout, Options, PluginError, Point, Pose, Symbol, ring_signed_area,
};
use std::collections::BTreeSet;

fn flat() -> Layout {
    serde_json::from_str(include_str!("../../svg/tests/flat.json")).unwrap()
}

fn write(layout: &Layout, options: &[(&str, &str)]) -> Result<String, PluginError> {
    let exporter = planform_geojson::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied())?;
    let mut bytes = Vec::new();
    exporter.write(&Document { layout, scene: None }, &options, &mut bytes)?;
    Ok(String::from_utf8(bytes).unwrap())
}

fn read(text: &str) -> FeatureCollection {
    text.parse().unwrap()
}

fn count(collection: &FeatureCollection, kind: &str) -> usize {
    collection.features.iter().filter(|f| f.property("kind").unwrap() == kind).count()
}

/// Areas of all polygons by their coordinates, each ring checked for closure and direction.
fn areas(collection: &FeatureCollection) -> Vec<f64> {
    let polygons = collection.features.iter().filter_map(|f| match &f.geometry.as_ref().unwrap().value {
        GeometryValue::Polygon { coordinates } => Some(coordinates),
        _ => None,
    });
    polygons.map(|rings| rings.iter().enumerate().map(|(i, r)| ring_area(r, i > 0)).sum()).collect()
}

fn ring_area(ring: &[geojson::Position], hole: bool) -> f64 {
    assert!(ring.len() >= 4);
    assert_eq!(ring.first(), ring.last());
    let points: Vec<Point> = ring[1..].iter().map(|p| Point::new(p[0], p[1])).collect();
    let area = ring_signed_area(&points);
    assert_eq!(area < 0.0, hole, "RFC 7946: exteriors counter-clockwise, holes clockwise");
    area
}

#[test]
fn everything_is_there_once() {
    let layout = flat();
    let file = read(&write(&layout, &[("lines", "true")]).unwrap());
    for (kind, expected) in [
        ("room", layout.rooms.len()),
        ("wall", layout.walls.len()),
        ("door", 5),
        ("passage", 1),
        ("frontier", layout.frontiers.len()),
        ("line", layout.lines.len()),
        ("text", layout.texts.len()),
        ("symbol", layout.symbols.len()),
    ] {
        assert_eq!(count(&file, kind), expected, "{kind}");
    }
    let ids: BTreeSet<_> = file.features.iter().map(|f| format!("{:?}", f.id.as_ref().unwrap())).collect();
    assert_eq!(ids.len(), file.features.len());
    assert_eq!(file.features[0].id, Some(Id::String("room-1".into())));
}

#[test]
fn lines_are_left_out_unless_asked_for() {
    assert_eq!(count(&read(&write(&flat(), &[]).unwrap()), "line"), 0);
}

#[test]
fn doors_have_leaves_that_are_drawn_open_and_on_their_way() {
    let mut layout = flat();
    let door = layout.openings[0].segment;
    let middle = door.midpoint();
    let side = Point::new(door.a.x - (door.b.y - door.a.y), door.a.y + (door.b.x - door.a.x));
    layout.symbols.push(Symbol {
        kind: "door".into(),
        pose: Pose { x: middle.x, y: middle.y, yaw: door.angle() },
        width: door.length(),
        height: 0.1,
        score: 1.0,
        leaves: vec![DoorLeaf { hinge: door.a, closed: door.b, open: side }],
    });
    let file = read(&write(&layout, &[]).unwrap());
    let leaf = file.features.iter().find(|f| f.property("kind").unwrap() == "leaf").unwrap();
    assert_eq!(leaf.property("symbol").unwrap(), "symbol-2");
    assert_eq!(leaf.property("swing").unwrap(), 90.0);
    let symbol = file.features.iter().find(|f| f.id == Some(Id::String("symbol-2".into()))).unwrap();
    assert_eq!(symbol.property("opening").unwrap(), "opening-1");
    let GeometryValue::LineString { coordinates } = &leaf.geometry.as_ref().unwrap().value else {
        panic!("{leaf:?}")
    };
    let near = |i: usize, p: Point| Point::new(coordinates[i][0], coordinates[i][1]).distance(p) < 1e-3;
    assert!(near(0, door.a) && near(1, side) && near(coordinates.len() - 1, door.b), "{coordinates:?}");
}

#[test]
fn areas_are_those_of_the_layout() {
    let layout = flat();
    for boundary in ["inner", "centre"] {
        let file = read(&write(&layout, &[("boundary", boundary)]).unwrap());
        let written = areas(&file);
        assert_eq!(written.len(), layout.rooms.len());
        for ((room, area), feature) in layout.rooms.iter().zip(written).zip(&file.features) {
            let outline = if boundary == "inner" { &room.inner } else { &room.centre };
            assert!((area / outline.area() - 1.0).abs() < 1e-4, "room {}", room.id);
            let property = feature.property("area").unwrap().as_f64().unwrap();
            assert!((property - room.area()).abs() <= 5.1e-5, "the floor's area, whatever the outline");
        }
    }
}

#[test]
fn winding_is_right_though_the_layout_be_wrong() {
    let mut layout = flat();
    for room in &mut layout.rooms {
        room.inner.exterior.reverse();
        room.inner.holes.iter_mut().for_each(|h| h.reverse());
    }
    areas(&read(&write(&layout, &[]).unwrap()));
    areas(&read(&write(&layout, &[("anchor", "-47,8,200")]).unwrap()));
}

#[test]
fn metres_have_a_crs_and_degrees_none() {
    let layout = flat();
    let metres = read(&write(&layout, &[]).unwrap()).foreign_members.unwrap();
    assert!(metres["crs"]["properties"]["name"].as_str().unwrap().starts_with("LOCAL_CS"));
    assert_eq!(metres["provenance"]["source"], "Erdgeschoß & Hof.png");
    assert_eq!(metres["method"], "default");
    let degrees =
        read(&write(&layout, &[("anchor", "47.3769,8.5417,12.5")]).unwrap()).foreign_members.unwrap();
    assert!(!degrees.contains_key("crs"));
    assert_eq!(degrees["anchor"]["bearing"], 12.5);
}

#[test]
fn anchor_of_the_layout_serves_too() {
    let at = Point::new(-3.5, 2.25);
    let anchor = Some(GeoAnchor { latitude: 47.0, longitude: 8.0, bearing: 0.0, at });
    let file = read(&write(&Layout { anchor, ..flat() }, &[("boundary", "centre")]).unwrap());
    let GeometryValue::Polygon { coordinates } = &file.features[0].geometry.as_ref().unwrap().value else {
        panic!("a room is a polygon")
    };
    assert_eq!(coordinates[0][0].as_slice(), [8.0, 47.0]);
    assert!(areas(&file).iter().all(|&a| a > 0.0));
}

#[test]
fn names_survive() {
    let file = read(&write(&flat(), &[]).unwrap());
    let names: Vec<_> = file.features[..6].iter().map(|f| f.property("name").unwrap().as_str()).collect();
    assert_eq!(
        names,
        [Some("Küche & Bad"), None, Some("Büro <A> \"Süd\""), Some("Flur"), Some("会議室"), Some("Lager 2")]
    );
}

#[test]
fn empty_layout_is_an_empty_collection() {
    let file = read(&write(&Layout::default(), &[]).unwrap());
    assert!(file.features.is_empty() && file.foreign_members.unwrap().contains_key("crs"));
}

#[test]
fn same_layout_same_bytes() {
    assert_eq!(write(&flat(), &[]).unwrap(), write(&flat(), &[]).unwrap());
}
