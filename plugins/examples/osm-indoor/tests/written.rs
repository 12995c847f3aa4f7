//! What is written, read back as XML.

#![allow(clippy::unwrap_used)]

mod osm;

use osm::{Osm, Way};
use planform_sdk::{
    Document, ErrorKind, GeoAnchor, Layout, Options, PluginError, Point, Polygon, Room, RoomState,
};
use std::collections::{BTreeMap, BTreeSet};

const ANCHOR: &str = "47.3769,8.5417,12.5";

/// Six rooms, one of them a corridor and one around a pillar, five doors and a passage.
fn flat() -> Layout {
    serde_json::from_str(include_str!("../../../svg/tests/flat.json")).unwrap()
}

fn write(layout: &Layout, options: &[(&str, &str)]) -> Result<String, PluginError> {
    let exporter = planform_osm_indoor::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied())?;
    let mut bytes = Vec::new();
    exporter.write(&Document { layout, scene: None }, &options, &mut bytes)?;
    Ok(String::from_utf8(bytes).unwrap())
}

fn anchored(layout: &Layout) -> String {
    write(layout, &[("anchor", ANCHOR)]).unwrap()
}

fn read(layout: &Layout) -> Osm {
    Osm::read(&anchored(layout))
}

/// A room of this outline.
fn room(id: u32, name: &str, corners: [[f64; 2]; 4]) -> Room {
    let inner = Polygon::new(corners.map(Point::from).to_vec(), vec![]);
    let (name, centre) = (Some(name.into()), inner.clone());
    Room { id, name, stated_area: None, state: RoomState::Complete, centre, inner }
}

fn rooms(rooms: Vec<Room>) -> Layout {
    Layout { rooms, ..Layout::default() }
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];

#[test]
fn everything_resolves_and_is_there_once() {
    let (layout, osm) = (flat(), read(&flat()));
    osm.check();
    let count = |kind| osm.tagged("indoor", kind).count();
    assert_eq!((count("room"), count("corridor")), (5, 1));
    assert_eq!((count("wall"), count("door")), (layout.walls.len(), layout.openings.len()));
    let doors: Vec<_> = osm.nodes.values().filter_map(|n| n.tags.get("door")).collect();
    assert_eq!(doors.iter().filter(|d| **d == "yes").count(), 5);
    assert_eq!(doors.iter().filter(|d| **d == "no").count(), 1);
    for tags in osm.all_tags().filter(|t| t.contains_key("indoor")) {
        assert_eq!(tags["level"], "0");
    }
}

#[test]
fn names_are_names() {
    let osm = read(&flat());
    let names: BTreeSet<_> = osm.all_tags().filter_map(|t| t.get("name")).map(String::as_str).collect();
    assert_eq!(names, ["Küche & Bad", "Büro <A> \"Süd\"", "Flur", "会議室", "Lager 2"].into());
    assert_eq!(osm.tagged("name", "Flur").next().unwrap()["indoor"], "corridor");
    assert!(osm.tagged("name", "Lager 2").next().unwrap()["note"].contains("in part"));
}

#[test]
fn hostile_names_stay_names() {
    for (name, expected) in [
        ("\"/><node id='1'/>", Some("\"/><node id='1'/>")),
        ("&amp; ]]> <!--", Some("&amp; ]]> <!--")),
        ("one\r\n\ttwo\u{0}\u{b}three\u{ffff}", Some("one two three")),
        ("\u{1}\u{2}", None),
        ("", None),
    ] {
        let osm = read(&rooms(vec![room(1, name, SQUARE)]));
        osm.check();
        assert_eq!(osm.ways.values().next().unwrap().tags.get("name").map(String::as_str), expected);
    }
}

#[test]
fn a_number_is_a_reference() {
    let osm = read(&rooms(vec![room(1, "B 1.04", SQUARE)]));
    let tags = &osm.ways.values().next().unwrap().tags;
    assert_eq!((tags.get("ref").map(String::as_str), tags.get("name")), (Some("B 1.04"), None));
}

#[test]
fn areas_are_those_of_the_layout() {
    for boundary in ["inner", "centre"] {
        let layout = flat();
        let osm = Osm::read(&write(&layout, &[("anchor", ANCHOR), ("boundary", boundary)]).unwrap());
        osm.check();
        let mut written = osm.room_areas();
        written.sort_by(f64::total_cmp);
        let outline = |r: &Room| if boundary == "inner" { r.inner.area() } else { r.centre.area() };
        let mut expected: Vec<f64> = layout.rooms.iter().map(outline).collect();
        expected.sort_by(f64::total_cmp);
        assert_eq!(written.len(), expected.len());
        for (written, expected) in written.iter().zip(expected) {
            assert!((written / expected - 1.0).abs() < 1e-3, "{boundary}: {written} for {expected}");
        }
    }
}

#[test]
fn a_room_with_a_hole_is_a_multipolygon() {
    let osm = read(&flat());
    let [relation] = osm.relations.values().collect::<Vec<_>>()[..] else { panic!("there is one") };
    assert_eq!((relation.tags["type"].as_str(), relation.tags["indoor"].as_str()), ("multipolygon", "room"));
    assert_eq!(relation.members.iter().map(|m| m.1.as_str()).collect::<Vec<_>>(), ["outer", "inner"]);
    assert!(relation.members.iter().all(|m| osm.ways[&m.0].tags.is_empty()));
}

#[test]
fn a_room_within_a_room_shares_its_outline() {
    let mut outer = room(1, "Hall", [[-5.0, -5.0], [9.0, -5.0], [9.0, 9.0], [-5.0, 9.0]]);
    outer.centre.holes = vec![SQUARE.iter().rev().copied().map(Point::from).collect()];
    for layout in [
        rooms(vec![outer.clone(), room(2, "Kiosk", SQUARE)]),
        rooms(vec![room(2, "Kiosk", SQUARE), outer.clone()]),
    ] {
        let osm = read(&layout);
        osm.check();
        assert_eq!((osm.ways.len(), osm.relations.len()), (2, 1));
        let inner = &osm.relations.values().next().unwrap().members[1];
        assert_eq!(osm.ways[&inner.0].tags["name"], "Kiosk");
    }
}

/// The closed ways with the tag `indoor`, or of which a tagged relation is made, by the node.
fn rings_at(osm: &Osm, node: &str) -> usize {
    osm.ways.values().filter(|w| w.is_closed() && w.nodes.iter().any(|n| n == node)).count()
}

#[test]
fn doors_are_nodes_of_both_rooms_and_of_the_wall() {
    let osm = read(&flat());
    for (id, node) in osm.nodes.iter().filter(|(_, n)| n.tags.contains_key("door")) {
        assert_eq!(rings_at(&osm, id), 2, "{node:?}");
        let walls = osm.ways.values().filter(|w| w.tags.get("indoor").is_some_and(|v| v == "wall"));
        assert_eq!(walls.filter(|w| w.nodes.contains(id)).count(), 1, "{node:?}");
        assert!(node.tags["width"].parse::<f64>().unwrap() >= 0.8);
    }
}

#[test]
fn walls_measured_beside_the_outlines_make_no_nodes_of_their_own() {
    let mut layout = flat();
    let beside = |p: &mut Point| *p = Point::new(p.x + 0.07, p.y - 0.05);
    for segment in layout.walls.iter_mut().map(|w| &mut w.line) {
        beside(&mut segment.a);
        beside(&mut segment.b);
    }
    for segment in layout.openings.iter_mut().map(|o| &mut o.segment) {
        beside(&mut segment.a);
        beside(&mut segment.b);
    }
    let osm = read(&layout);
    osm.check();
    assert_eq!(osm.nodes.len(), read(&flat()).nodes.len());
    let doors = osm.nodes.iter().filter(|(_, n)| n.tags.contains_key("door"));
    assert!(doors.into_iter().all(|(id, _)| rings_at(&osm, id) == 2));
}

#[test]
fn along_the_inner_faces_rooms_meet_neither_doors_nor_walls() {
    let osm = Osm::read(&write(&flat(), &[("anchor", ANCHOR), ("boundary", "inner")]).unwrap());
    let walls = osm.ways.values().filter(|w| w.tags.get("indoor").is_some_and(|v| v == "wall"));
    let on_walls: BTreeSet<_> = walls.flat_map(|w| &w.nodes).collect();
    assert!(on_walls.iter().all(|node| rings_at(&osm, node) == 0));
    let doors = osm.nodes.iter().filter(|(_, n)| n.tags.contains_key("door"));
    assert!(doors.into_iter().all(|(id, _)| on_walls.contains(id)));
}

#[test]
fn neighbours_share_nodes_though_their_corners_do_not_meet() {
    let left = room(1, "left", [[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [0.0, 6.0]]);
    let right = room(2, "right", [[4.0, 1.0], [8.0, 1.0], [8.0, 3.0], [4.0, 3.0]]);
    let osm = read(&rooms(vec![left, right]));
    osm.check();
    assert_eq!(osm.nodes.len(), 8);
    let nodes = |w: &Way| w.nodes.iter().cloned().collect::<BTreeSet<_>>();
    let [a, b] = osm.ways.values().map(nodes).collect::<Vec<_>>().try_into().unwrap();
    assert_eq!(a.intersection(&b).count(), 2);
}

/// The identifier of each room by its name.
fn room_ids(osm: &Osm) -> BTreeMap<&str, &str> {
    let ways = osm.ways.iter().map(|(id, w)| (id, &w.tags));
    let all = ways.chain(osm.relations.iter().map(|(id, r)| (id, &r.tags)));
    all.filter_map(|(id, tags)| Some((tags.get("name")?.as_str(), id.as_str()))).collect()
}

/// The identifier of each node by its place.
fn node_ids(osm: &Osm) -> BTreeMap<[&str; 2], &str> {
    osm.nodes.iter().map(|(id, n)| ([n.lat.as_str(), n.lon.as_str()], id.as_str())).collect()
}

#[test]
fn what_did_not_change_keeps_its_identifiers() {
    let mut layout = flat();
    let before = read(&layout);
    layout.rooms.remove(0);
    layout.walls.retain(|w| !w.rooms.contains(&Some(1)));
    layout.openings.retain(|o| !o.rooms.contains(&1));
    let after = read(&layout);
    let (rooms, rooms_left) = (room_ids(&before), room_ids(&after));
    assert_eq!((rooms.len(), rooms_left.len()), (5, 4));
    assert!(rooms_left.iter().all(|(name, id)| rooms[name] == *id));
    let (nodes, nodes_left) = (node_ids(&before), node_ids(&after));
    assert!(nodes_left.len() > 20 && nodes_left.iter().all(|(place, id)| nodes[place] == *id));
    assert!(after.ways.keys().all(|id| before.ways.contains_key(id)));
}

#[test]
fn floors_have_identifiers_of_their_own() {
    let (ground, upper) =
        (read(&flat()), Osm::read(&write(&flat(), &[("anchor", ANCHOR), ("level", "1")]).unwrap()));
    assert!(upper.nodes.keys().all(|id| !ground.nodes.contains_key(id)));
    assert!(upper.ways.keys().all(|id| !ground.ways.contains_key(id)));
    assert_eq!(upper.tagged("level", "1").count(), ground.tagged("level", "0").count());
}

#[test]
fn same_layout_same_bytes() {
    assert_eq!(anchored(&flat()), anchored(&flat()));
}

#[test]
fn the_header_is_josms() {
    let text = anchored(&Layout::default());
    let [first, second, last] = text.lines().collect::<Vec<_>>()[..] else { panic!("{text}") };
    assert_eq!(first, r#"<?xml version="1.0" encoding="UTF-8"?>"#);
    assert!(second.starts_with(r#"<osm version="0.6" generator="planform-osm-indoor "#), "{second}");
    assert_eq!(last, "</osm>");
    assert!(!anchored(&flat()).contains("action="));
}

#[test]
fn without_an_anchor_there_is_advice() {
    let e = write(&flat(), &[]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::BadOption);
    assert!(e.advice.unwrap().contains("--anchor LAT,LON,BEARING"));
}

#[test]
fn anchor_of_the_layout_serves_too() {
    let at = Point::new(4.0, 3.0);
    let anchor = Some(GeoAnchor { latitude: 47.0, longitude: 8.0, bearing: 0.0, at });
    let layout = Layout { anchor, ..rooms(vec![room(1, "a", SQUARE)]) };
    let osm = Osm::read(&write(&layout, &[]).unwrap());
    assert!(osm.nodes.values().any(|n| (n.lat.as_str(), n.lon.as_str()) == ("47", "8")));
}

#[test]
fn poles_and_the_antimeridian_are_refused_and_what_is_beside_them_is_not() {
    for (anchor, kind) in [
        ("90,0,0", Some(ErrorKind::BadOption)),
        ("89.99999,0,0", Some(ErrorKind::Unsupported)),
        ("89.9,0,0", None),
        ("-17,180,0", Some(ErrorKind::Unsupported)),
        ("-17,179.99999,0", Some(ErrorKind::Unsupported)),
        ("-17,-179.9,0", None),
    ] {
        let written = write(&rooms(vec![room(1, "a", SQUARE)]), &[("anchor", anchor)]);
        assert_eq!(written.as_ref().err().map(|e| e.kind), kind, "{anchor}");
        if let Ok(text) = written {
            let osm = Osm::read(&text);
            let longitudes = || osm.nodes.values().map(|n| n.lon.parse::<f64>().unwrap());
            assert!(longitudes().all(|l| l.abs() <= 180.0), "{anchor}");
            assert!((osm.room_areas()[0] / 12.0 - 1.0).abs() < 1e-3, "{anchor}: {:?}", osm.room_areas());
        }
    }
}

#[test]
fn unusable_layouts_are_refused_by_the_thing_at_fault() {
    let nan = room(7, "a", [[f64::NAN, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
    let flat_one = room(8, "a", [[0.0, 0.0], [1e-4, 0.0], [0.0, 1e-4], [2.0, 0.0]]);
    for (room, words) in [(nan, "room 7: the point (NaN, 0)"), (flat_one, "room 8: a ring has 2 distinct")] {
        let e = write(&rooms(vec![room]), &[("anchor", ANCHOR)]).unwrap_err();
        assert_eq!(e.kind, ErrorKind::BadInput);
        assert!(e.message.starts_with(words), "{e}");
    }
    let far = room(9, "a", [[1e300, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
    assert!(write(&rooms(vec![far]), &[("anchor", ANCHOR)]).unwrap_err().message.starts_with("room 9"));
}
