//! Layouts to write, and the writing.

use planform_sdk::{
    Document, DoorLeaf, Frontier, FrontierKind, Layout, Opening, OpeningKind, Options, PluginError, Point,
    Polygon, Pose, Room, RoomState, Segment, Symbol, Text, Wall,
};

pub const VERSIONS: [&str; 4] = ["R12", "R2000", "R2013", "R2018"];

/// Names that have broken DXF writers.
pub const HARD_NAMES: [&str; 10] = [
    "Küche 🚪",
    "厨房与走廊",
    "غرفة الاجتماعات",
    "חדר 12",
    "\\U+0041 C:\\M+1",
    "20 %%d %%c %%% 5%",
    "a^J^ b",
    "",
    "1\n  0\nEOF\r\n",
    "\u{0}\u{7}\u{85}\t",
];

pub fn write(layout: &Layout, options: &[(&str, &str)]) -> Result<Vec<u8>, PluginError> {
    let exporter = planform_dxf::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied())?;
    let mut out = vec![];
    exporter.write(&Document { layout, scene: None }, &options, &mut out)?;
    Ok(out)
}

pub fn points(ring: &[[f64; 2]]) -> Vec<Point> {
    ring.iter().copied().map(Point::from).collect()
}

pub fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<Point> {
    points(&[[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
}

fn segment(a: [f64; 2], b: [f64; 2]) -> Segment {
    Segment::new(a.into(), b.into())
}

fn wall(a: [f64; 2], b: [f64; 2], left: u32, right: u32) -> Wall {
    let side = |id: u32| (id > 0).then_some(id);
    Wall { line: segment(a, b), thickness: 0.2, weight: 0.9, rooms: [side(left), side(right)] }
}

fn room(id: u32, name: Option<&str>, inner: Vec<Point>, centre: Vec<Point>) -> Room {
    let polygon = |ring| Polygon::new(ring, vec![]);
    Room {
        id,
        name: name.map(Into::into),
        stated_area: None,
        state: RoomState::Complete,
        inner: polygon(inner),
        centre: polygon(centre),
    }
}

fn opening(kind: OpeningKind, a: [f64; 2], b: [f64; 2], rooms: [u32; 2]) -> Opening {
    Opening { kind, segment: segment(a, b), rooms }
}

/// Five rooms: one with a hole, one partial, one with a slanted wall; doors, a passage, a frontier, a text, a symbol.
pub fn flat() -> Layout {
    let mut hall =
        room(1, Some("Küche 🚪\n厨房"), rectangle(0.1, 0.1, 5.9, 3.9), rectangle(0.0, 0.0, 6.0, 4.0));
    hall.inner = Polygon::new(hall.inner.exterior, vec![rectangle(2.6, 1.6, 3.4, 2.4)]);
    hall.centre = Polygon::new(hall.centre.exterior, vec![rectangle(2.7, 1.7, 3.3, 2.3)]);
    let mut partial = room(5, None, rectangle(10.1, 0.1, 13.0, 3.9), rectangle(10.0, 0.0, 13.0, 4.0));
    partial.state = RoomState::Partial;
    let slanted = room(
        4,
        Some("100 %%d \\U+0041"),
        points(&[[6.1, 4.1], [9.9, 4.1], [9.9, 5.7584], [6.1, 7.6584]]),
        points(&[[6.0, 4.0], [10.0, 4.0], [10.0, 5.8202], [6.0, 7.8202]]),
    );
    Layout {
        rooms: vec![
            hall,
            room(2, Some("غرفة"), rectangle(6.1, 0.1, 9.9, 3.9), rectangle(6.0, 0.0, 10.0, 4.0)),
            room(3, Some("Bad"), rectangle(0.1, 4.1, 5.9, 7.7202), rectangle(0.0, 4.0, 6.0, 7.8202)),
            slanted,
            partial,
        ],
        walls: vec![
            wall([0.0, 0.0], [6.0, 0.0], 1, 0),
            wall([6.0, 0.0], [10.0, 0.0], 2, 0),
            wall([10.0, 0.0], [13.0, 0.0], 5, 0),
            wall([0.0, 0.0], [0.0, 4.0], 0, 1),
            wall([6.0, 0.0], [6.0, 4.0], 1, 2),
            wall([10.0, 0.0], [10.0, 4.0], 2, 5),
            wall([0.0, 4.0], [6.0, 4.0], 3, 1),
            wall([6.0, 4.0], [10.0, 4.0], 4, 2),
            wall([10.0, 4.0], [13.0, 4.0], 0, 5),
            wall([0.0, 4.0], [0.0, 7.8202], 0, 3),
            wall([0.0, 7.8202], [6.0, 7.8202], 0, 3),
            wall([6.0, 4.0], [6.0, 7.8202], 3, 4),
            wall([6.0, 7.8202], [10.0, 5.8202], 0, 4),
            wall([10.0, 4.0], [10.0, 5.8202], 4, 0),
        ],
        openings: vec![
            opening(OpeningKind::Door, [6.0, 1.0], [6.0, 1.9], [1, 2]),
            opening(OpeningKind::Door, [1.0, 4.0], [1.9, 4.0], [1, 3]),
            opening(OpeningKind::Passage, [7.0, 4.0], [9.0, 4.0], [2, 4]),
            opening(OpeningKind::Door, [10.0, 2.0], [10.0, 2.9], [2, 5]),
        ],
        frontiers: vec![Frontier {
            segment: segment([13.0, 0.1], [13.0, 3.9]),
            room: 5,
            leads: FrontierKind::Room,
            area: 4.5,
        }],
        texts: vec![Text {
            content: "Flat Nº 7 ≈ 90 m²".into(),
            pose: Pose { x: 3.0, y: -0.8, yaw: 0.0 },
            width: 3.0,
            height: 0.3,
            confidence: 0.8,
        }],
        symbols: vec![Symbol {
            kind: "fire-extinguisher".into(),
            pose: Pose { x: 8.0, y: 0.6, yaw: 0.0 },
            width: 0.3,
            height: 0.1,
            score: 0.7,
            leaves: vec![],
        }],
        ..Layout::default()
    }
}

/// A room with a symbol of every way to draw one; its door lies to the outside.
pub fn symbols() -> Layout {
    let place = |i: usize| Pose { x: 1.0 + i as f64, y: 1.0, yaw: 0.5 };
    let symbol = |kind: &str, pose: Pose| Symbol {
        kind: kind.into(),
        pose,
        width: 0.9,
        height: 0.5,
        score: 0.7,
        leaves: vec![],
    };
    let kinds = ["lift", "toilet", "sink", "stairs", "toilet", "you-are-here", "coffee-machine"];
    let mut symbols: Vec<Symbol> = kinds.iter().enumerate().map(|(i, k)| symbol(k, place(i))).collect();
    let [hinge, closed, open] = [[7.0, 0.0], [7.9, 0.0], [7.0, -0.9]].map(Point::from);
    let mut door = symbol("door", Pose { x: 7.45, y: 0.0, yaw: 0.0 });
    door.leaves = vec![DoorLeaf { hinge, closed, open }];
    symbols.extend([symbol("window", Pose { x: 2.0, y: 0.0, yaw: 0.0 }), door]);
    let outline = rectangle(0.0, 0.0, 8.0, 1.5);
    Layout {
        rooms: vec![room(1, None, outline.clone(), outline)],
        walls: vec![wall([0.0, 0.0], [8.0, 0.0], 1, 0)],
        symbols,
        ..Layout::default()
    }
}

/// So many rooms side by side, 3 m by 2 m within, `from` being the lower left corner; with one wall each.
pub fn row(count: u32, from: Point, name: impl Fn(u32) -> Option<String>) -> Layout {
    let place = |id: u32| {
        let i = id - 1;
        (from.x + 3.0 * f64::from(i % 100), from.y + 2.0 * f64::from(i / 100))
    };
    let build = |id: u32| {
        let (x, y) = place(id);
        let ring = rectangle(x, y, x + 3.0, y + 2.0);
        Room { name: name(id), ..room(id, None, ring.clone(), ring) }
    };
    let side = |id: u32| {
        let (x, y) = place(id);
        wall([x, y], [x + 3.0, y], id, 0)
    };
    Layout {
        rooms: (1..=count).map(build).collect(),
        walls: (1..=count).map(side).collect(),
        ..Layout::default()
    }
}

/// A room for each hard name.
pub fn hard_names() -> Layout {
    row(HARD_NAMES.len() as u32, Point::default(), |id| Some(HARD_NAMES[id as usize - 1].into()))
}
