//! What is written, read back as a layout.

#![allow(clippy::unwrap_used)]

use planform_sdk::{
    Document, DoorLeaf, ErrorKind, GeoAnchor, Layout, Options, PluginError, Point, Pose, Scale, Symbol,
};

fn flat() -> Layout {
    serde_json::from_str(include_str!("../../svg/tests/flat.json")).unwrap()
}

fn write(layout: &Layout) -> Result<String, PluginError> {
    let mut bytes = vec![];
    planform_json::exporter().write(&Document { layout, scene: None }, &Options::default(), &mut bytes)?;
    Ok(String::from_utf8(bytes).unwrap())
}

/// A layout whose numbers are hard to write, and texts as well.
fn hard() -> Layout {
    let mut layout = flat();
    let numbers =
        [0.1 + 0.2, -0.0, 5e-324, f64::MIN_POSITIVE, f64::MAX, 1.0 / 3.0, 1e21, 123_456_789.123_456_79];
    layout.rooms[0].inner.exterior = numbers.map(|x| Point::new(x, -x)).to_vec();
    layout.rooms[0].inner.holes = vec![layout.rooms[0].inner.exterior.clone(), vec![]];
    layout.rooms[1].name = Some("\0 \" \\ \u{7f} \u{2028} \u{1f6aa}\r\n".into());
    layout.rooms[2].name = Some(String::new());
    layout.walls[0].rooms = [None, Some(u32::MAX)];
    let pose = Pose { x: f64::EPSILON, y: 1e-300, yaw: std::f64::consts::PI };
    let at = Point::new(0.1, 0.3);
    let leaves = vec![DoorLeaf { hinge: at, closed: Point::new(-0.0, 5e-324), open: at }];
    layout.symbols.push(Symbol { kind: String::new(), pose, width: 0.1, height: 0.7, score: 1.0, leaves });
    layout.rooms[0].stated_area = Some(0.1 + 0.2);
    layout.scale =
        Some(Scale { metres_per_pixel: 1.0 / 3.0, source: "\0\u{2028}".into(), confidence: 1e-300 });
    layout.anchor = Some(GeoAnchor { latitude: 47.376_9, longitude: -8.541_7, bearing: 359.999, at });
    layout
}

#[test]
fn the_same_layout_comes_back_to_the_last_bit() {
    for layout in [Layout::default(), flat(), hard()] {
        let text = write(&layout).unwrap();
        let back: Layout = serde_json::from_str(&text).unwrap();
        assert_eq!(back, layout);
        // Equality takes -0 for 0; the digits do not.
        assert_eq!(write(&back).unwrap(), text);
        assert_eq!(format!("{back:?}"), format!("{layout:?}"));
    }
}

#[test]
fn each_thing_has_its_line() {
    let layout = flat();
    let text = write(&layout).unwrap();
    let things = [
        layout.rooms.len(),
        layout.walls.len(),
        layout.openings.len(),
        layout.frontiers.len(),
        layout.lines.len(),
        layout.texts.len(),
        layout.symbols.len(),
    ];
    // The braces, anchor, scale, provenance and method; a list is on one line if it is empty, else it has two more.
    let lists = things.iter().map(|n| if *n == 0 { 1 } else { n + 2 }).sum::<usize>();
    assert_eq!(text.lines().count(), 6 + lists);
    assert!(text.lines().any(|l| l.starts_with("{\"id\":1,") && l.ends_with("},")), "{text}");
    assert!(text.ends_with("\n}\n"));
}

#[test]
fn nothing_is_lost_beside_what_the_sdk_writes() {
    for layout in [flat(), hard()] {
        let written: serde_json::Value = serde_json::from_str(&write(&layout).unwrap()).unwrap();
        assert_eq!(written, serde_json::to_value(&layout).unwrap());
    }
}

#[test]
fn numbers_that_json_cannot_hold_are_refused() {
    let mut wall = flat();
    wall.walls[2].thickness = f64::NAN;
    let mut room = flat();
    room.rooms[0].centre.exterior[1].x = f64::INFINITY;
    let mut anchor = hard();
    anchor.anchor.as_mut().unwrap().bearing = f64::NEG_INFINITY;
    for (layout, words) in
        [(wall, "number 3 of the walls"), (room, "number 1 of the rooms"), (anchor, "anchor")]
    {
        let e = write(&layout).unwrap_err();
        assert_eq!(e.kind, ErrorKind::BadInput);
        assert!(e.message.contains(words), "{e}");
    }
}
