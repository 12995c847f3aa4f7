//! Scenes and layouts of every kind, with every field set in some.

use planform_sdk::{
    Annotations, Cell, DoorLeaf, Frontier, FrontierKind, GeoAnchor, Grid, Layout, Opening, OpeningKind,
    Point, Polygon, Pose, Provenance, RepresentativeLine, Room, RoomState, Scale, Segment, StatedOpening,
    Symbol, Text, Wall,
};
use proptest::collection::vec;
use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
use proptest::option;
use proptest::prelude::*;

fn number() -> impl Strategy<Value = f64> {
    POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO
}

fn string() -> impl Strategy<Value = String> {
    prop_oneof![".{0,12}", Just("\0 \" \\ \u{1f6aa}\n".to_owned())]
}

fn point() -> impl Strategy<Value = Point> {
    (number(), number()).prop_map(|(x, y)| Point::new(x, y))
}

fn pose() -> impl Strategy<Value = Pose> {
    (number(), number(), number()).prop_map(|(x, y, yaw)| Pose { x, y, yaw })
}

fn segment() -> impl Strategy<Value = Segment> {
    (point(), point()).prop_map(|(a, b)| Segment::new(a, b))
}

fn polygon() -> impl Strategy<Value = Polygon> {
    (vec(point(), 0..5), vec(vec(point(), 0..4), 0..3))
        .prop_map(|(exterior, holes)| Polygon { exterior, holes })
}

pub fn grid() -> impl Strategy<Value = Grid> {
    let origin = (-1e9..1e9, -1e9..1e9, -7.0..7.0).prop_map(|(x, y, yaw)| Pose { x, y, yaw });
    (1u32..12, 1u32..12, 1e-4..1e3, origin).prop_flat_map(|(width, height, resolution, origin)| {
        let cells = vec((-1i8..=100).prop_map(|v| Cell::of_ros(v).unwrap()), (width * height) as usize);
        cells.prop_map(move |cells| Grid::new(width, height, resolution, origin, cells).unwrap())
    })
}

prop_compose! {
    fn text()(content in string(), pose in pose(), sizes in [number(), number(), number()]) -> Text {
        let [width, height, confidence] = sizes;
        Text { content, pose, width, height, confidence }
    }
}

prop_compose! {
    fn leaf()(hinge in point(), closed in point(), open in point()) -> DoorLeaf {
        DoorLeaf { hinge, closed, open }
    }
}

prop_compose! {
    fn symbol()(
        kind in string(),
        pose in pose(),
        sizes in [number(), number(), number()],
        leaves in vec(leaf(), 0..3),
    ) -> Symbol {
        let [width, height, score] = sizes;
        Symbol { kind, pose, width, height, score, leaves }
    }
}

prop_compose! {
    fn scale()(metres_per_pixel in number(), source in string(), confidence in number()) -> Scale {
        Scale { metres_per_pixel, source, confidence }
    }
}

prop_compose! {
    fn anchor()(at in point(), numbers in [number(), number(), number()]) -> GeoAnchor {
        let [latitude, longitude, bearing] = numbers;
        GeoAnchor { latitude, longitude, bearing, at }
    }
}

prop_compose! {
    fn provenance()(source in string(), adapter in string()) -> Provenance {
        Provenance { source, adapter }
    }
}

prop_compose! {
    fn stated()(
        kind in prop_oneof![Just(OpeningKind::Door), Just(OpeningKind::Passage)],
        segment in segment(),
        depth in option::of(POSITIVE),
    ) -> StatedOpening {
        StatedOpening { kind, segment, depth }
    }
}

prop_compose! {
    pub fn annotations()(
        texts in vec(text(), 0..4),
        symbols in vec(symbol(), 0..4),
        openings in option::of(vec(stated(), 0..4)),
        anchor in option::of(anchor()),
        scale in option::of(scale()),
        provenance in provenance(),
        warnings in vec(string(), 0..3),
    ) -> Annotations {
        Annotations { texts, symbols, openings, anchor, scale, provenance, warnings }
    }
}

prop_compose! {
    fn room()(
        id: u32,
        name in option::of(string()),
        stated_area in option::of(number()),
        state in prop_oneof![Just(RoomState::Complete), Just(RoomState::Partial)],
        inner in polygon(),
        centre in polygon(),
    ) -> Room {
        Room { id, name, stated_area, state, inner, centre }
    }
}

prop_compose! {
    fn wall()(line in segment(), thickness in number(), weight in number(), rooms: [Option<u32>; 2]) -> Wall {
        Wall { line, thickness, weight, rooms }
    }
}

prop_compose! {
    fn opening()(
        kind in prop_oneof![Just(OpeningKind::Door), Just(OpeningKind::Passage)],
        segment in segment(),
        rooms: [u32; 2],
    ) -> Opening {
        Opening { kind, segment, rooms }
    }
}

prop_compose! {
    fn frontier()(
        segment in segment(),
        room: u32,
        leads in prop_oneof![Just(FrontierKind::Room), Just(FrontierKind::Space)],
        area in number(),
    ) -> Frontier {
        Frontier { segment, room, leads, area }
    }
}

prop_compose! {
    pub fn layout()(
        rooms in vec(room(), 0..4),
        walls in vec(wall(), 0..4),
        openings in vec(opening(), 0..4),
        frontiers in vec(frontier(), 0..3),
        lines in vec((segment(), number()), 0..3),
        notes in annotations(),
        method in string(),
    ) -> Layout {
        let lines = lines.into_iter().map(|(segment, support)| RepresentativeLine { segment, support });
        let Annotations { texts, symbols, anchor, scale, provenance, openings: _, warnings: _ } = notes;
        Layout {
            rooms, walls, openings, frontiers, lines: lines.collect(), texts, symbols, anchor, scale, provenance,
            method,
        }
    }
}
