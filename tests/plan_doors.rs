//! A drawn plan with a door, from its drawing to every format: the door keeps its leaf, its hinge and its swing.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod cli_support;

use cli_support::Workshop;
use planform_sdk::{DoorLeaf, Layout, OpeningKind, Point};

/// Two rooms at 1:100, a unit being a metre, with a door between them that opens to the right.
const PLAN: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='120mm' height='80mm' viewBox='0 0 12 8'>\
    <path fill='none' stroke='#000' stroke-width='0.2' d='M1 1H11V7H1ZM6 1V3M6 3.9V7'/>\
    <path fill='none' stroke='#000' stroke-width='0.03' d='M6 3H6.9A0.9 0.9 0 0 1 6 3.9'/></svg>";

/// The door of the plan, in the map frame, whose y runs up.
const LEAF: DoorLeaf =
    DoorLeaf { hinge: Point::new(6.0, 5.0), closed: Point::new(6.0, 4.1), open: Point::new(6.9, 5.0) };

/// How far a point of the door may be found from where it is, metres: the thickness of the wall's half.
const NEAR: f64 = 0.1;

fn converted() -> Workshop {
    let workshop = Workshop::empty();
    workshop.write("plan.svg", PLAN);
    workshop.does(
        "convert plan.svg --from blueprint --set scale=1:100 -o a.layout.json -o a.dxf -o a.svg -o a.geojson",
    );
    workshop
}

fn near(found: Point, truth: Point) {
    assert!(found.distance(truth) < NEAR, "{found:?} is not {truth:?}");
}

#[test]
fn a_drawn_door_is_a_door_in_every_format() {
    let workshop = converted();
    let text = |name: &str| String::from_utf8(workshop.read(name)).unwrap();
    let layout: Layout = serde_json::from_str(&text("a.layout.json")).unwrap();
    is_the_door(&layout);
    is_drawn_in_svg(&text("a.svg"));
    is_drawn_in_dxf(&text("a.dxf"));
    assert_eq!(text("a.geojson").matches("\"kind\":\"leaf\"").count(), 1);
}

fn is_the_door(layout: &Layout) {
    assert_eq!(layout.rooms.len(), 2);
    let [opening] = layout.openings.as_slice() else { panic!("one opening: {:?}", layout.openings) };
    assert_eq!(opening.kind, OpeningKind::Door);
    near(opening.segment.midpoint(), LEAF.hinge.midpoint(LEAF.closed));
    assert!((opening.width() - LEAF.length()).abs() < NEAR, "{opening:?}");
    let [door] = layout.symbols.as_slice() else { panic!("one symbol: {:?}", layout.symbols) };
    assert_eq!(door.kind, "door");
    let [leaf] = door.leaves.as_slice() else { panic!("one leaf: {door:?}") };
    near(leaf.hinge, LEAF.hinge);
    near(leaf.closed, LEAF.closed);
    near(leaf.open, LEAF.open);
}

fn is_drawn_in_svg(svg: &str) {
    for part in ["class=\"leaf\"", "class=\"swing\"", "data-opening=\"opening-1\""] {
        assert_eq!(svg.matches(part).count(), 1, "{part}");
    }
}

/// Centre, radius and the angles of the one arc, which runs from where the door closes, below, to where it is open.
fn is_drawn_in_dxf(dxf: &str) {
    let lines: Vec<&str> = dxf.lines().map(str::trim).collect();
    let arcs: Vec<usize> = (1..lines.len()).filter(|&i| lines[i - 1] == "0" && lines[i] == "ARC").collect();
    let [arc] = arcs.as_slice() else { panic!("{} arcs", arcs.len()) };
    let pairs: Vec<(&str, &str)> = lines[arc + 1..].chunks_exact(2).map(|p| (p[0], p[1])).collect();
    let value = |code: &str| pairs.iter().find(|(c, _)| *c == code).unwrap().1;
    let number = |code: &str| value(code).parse::<f64>().unwrap();
    assert_eq!(value("8"), "A-DOOR");
    near(Point::new(number("10"), number("20")), LEAF.hinge);
    assert!((number("40") - LEAF.length()).abs() < NEAR);
    let turned = |code: &str, truth: f64| (number(code) - truth + 180.0).rem_euclid(360.0) - 180.0;
    assert!(
        turned("50", 270.0).abs() < 8.0 && turned("51", 0.0).abs() < 8.0,
        "{} {}",
        number("50"),
        number("51")
    );
}
