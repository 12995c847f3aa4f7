//! What plugins are tried with: bytes that are no documents, damaged documents, layouts of every kind.

use planform_sdk::{
    Annotations, Cell, DoorLeaf, GeoAnchor, Grid, Layout, Opening, OpeningKind, Point, Polygon, Pose,
    Provenance, Room, RoomState, Scale, Scene, Segment, Source, StatedOpening, Symbol, Text, Wall,
};
use std::path::PathBuf;

/// A document and what it is, for messages.
pub struct Specimen {
    pub what: String,
    pub source: Source,
}

impl Specimen {
    fn new(what: impl Into<String>, path: impl Into<PathBuf>, bytes: Vec<u8>) -> Self {
        Self { what: what.into(), source: Source { path: path.into(), bytes, byte_limit: 1 << 20 } }
    }
}

/// Numbers without pattern, the same on every run (xorshift64, Marsaglia 2003).
fn noise(seed: u64) -> impl Iterator<Item = u64> {
    std::iter::successors(Some(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1), |x| {
        let x = x ^ (x << 13);
        let x = x ^ (x >> 7);
        Some(x ^ (x << 17))
    })
    .skip(1)
}

/// Bytes that are nobody's documents, under the plugin's extension.
pub fn garbage(extension: &str) -> Vec<Specimen> {
    let path = format!("garbage.{extension}");
    let fixed: [(&str, Vec<u8>); 9] = [
        ("an empty document", vec![]),
        ("one zero byte", vec![0]),
        ("10,000 zero bytes", vec![0; 10_000]),
        ("10,000 bytes of 255", vec![255; 10_000]),
        ("every byte once", (0..=255).collect()),
        ("one long line", vec![b'a'; 1 << 20]),
        ("100,000 line ends", vec![b'\n'; 100_000]),
        ("numbers beyond all measure", "999999999999999999999 -1 1e999 nan\n".repeat(100).into_bytes()),
        ("open brackets", "[{(<".repeat(10_000).into_bytes()),
    ];
    let fixed = fixed.into_iter().map(|(what, bytes)| Specimen::new(what, &path, bytes));
    let random = (0..32u64).map(|seed| {
        let bytes = noise(seed).take(16 << (seed % 12)).map(|n| (n >> 32) as u8).collect();
        Specimen::new(format!("random bytes, number {seed}"), &path, bytes)
    });
    fixed.chain(random).collect()
}

/// Paths of every kind.
pub fn paths(extension: &str) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = vec![
        "".into(),
        ".".into(),
        format!("no such folder/a plan.{extension}").into(),
        format!("{}.{extension}", "long".repeat(2000)).into(),
        format!("zeilen\numbruch \u{1f6aa}.{extension}").into(),
        extension.into(),
    ];
    paths.extend(path_not_utf8(extension));
    paths
}

/// A path that is not UTF-8, where there can be one.
#[cfg(unix)]
pub fn path_not_utf8(extension: &str) -> Option<PathBuf> {
    use std::os::unix::ffi::OsStringExt;
    let name = [b"caf\xe9 \xff.".as_slice(), extension.as_bytes()].concat();
    Some(std::ffi::OsString::from_vec(name).into())
}

#[cfg(not(unix))]
pub fn path_not_utf8(_: &str) -> Option<PathBuf> {
    None
}

fn altered(sample: &Source, what: String, bytes: Vec<u8>) -> Specimen {
    Specimen { what, source: Source { bytes, path: sample.path.clone(), byte_limit: sample.byte_limit } }
}

/// Up to `most` places spread over a length.
fn spread(length: usize, most: usize) -> impl Iterator<Item = usize> {
    let count = length.min(most);
    (0..count).map(move |i| i * length / count)
}

/// The document cut short at many places, the first of its bytes each.
pub fn cut(sample: &Source) -> Vec<Specimen> {
    let length = sample.bytes.len();
    let places = (0..length.min(32)).chain(spread(length, 96)).chain([length.saturating_sub(1)]);
    places
        .map(|n| altered(sample, format!("the first {n} bytes of the sample"), sample.bytes[..n].to_vec()))
        .collect()
}

/// The document with single bytes changed, and with pieces doubled and lost.
pub fn damaged(sample: &Source) -> Vec<Specimen> {
    let length = sample.bytes.len();
    if length == 0 {
        return vec![];
    }
    let changed = noise(1).zip(noise(2)).take(200).map(|(place, value)| {
        let place =
            if place % 2 == 0 { place as usize / 2 % length } else { place as usize / 2 % length.min(64) };
        let mut bytes = sample.bytes.clone();
        bytes[place] = (value >> 8) as u8;
        altered(sample, format!("the sample with byte {place} changed to {}", bytes[place]), bytes)
    });
    let moved = spread(length, 32).flat_map(|place| {
        let end = (place + 1 + length / 16).min(length);
        let (before, piece, after) =
            (&sample.bytes[..place], &sample.bytes[place..end], &sample.bytes[end..]);
        let doubled = [before, piece, piece, after].concat();
        [
            altered(sample, format!("the sample with bytes {place} to {end} twice"), doubled),
            altered(sample, format!("the sample without bytes {place} to {end}"), [before, after].concat()),
        ]
    });
    changed.chain(moved).collect()
}

/// The document with numbers beyond all measure: those written in digits, and those that may lie in its bytes.
pub fn absurd(sample: &Source) -> Vec<Specimen> {
    let bytes = &sample.bytes;
    let digits = |i: &usize| bytes[*i].is_ascii_digit() && (*i == 0 || !bytes[*i - 1].is_ascii_digit());
    let written = (0..bytes.len()).filter(digits).take(24).flat_map(|start| {
        let end = (start..bytes.len()).find(|i| !bytes[*i].is_ascii_digit()).unwrap_or(bytes.len());
        ["0", "65537", "4294967295", "99999999999999999999", "-1"].map(|number| {
            let changed = [&bytes[..start], number.as_bytes(), &bytes[end..]].concat();
            altered(sample, format!("the sample with {number} at byte {start}"), changed)
        })
    });
    let packed = (0..bytes.len().saturating_sub(4).min(64)).map(|place| {
        let mut changed = bytes.clone();
        changed[place..place + 4].copy_from_slice(&[255; 4]);
        altered(sample, format!("the sample with bytes {place} to {} at 255", place + 4), changed)
    });
    written.chain(packed).collect()
}

/// The document with bytes that are no UTF-8.
pub fn not_utf8(sample: &Source) -> Vec<Specimen> {
    let length = sample.bytes.len();
    let broken = spread(length, 48).map(|place| {
        let changed = [&sample.bytes[..place], b"\xff\xc3", &sample.bytes[place..]].concat();
        altered(sample, format!("the sample with bytes that are no UTF-8 at {place}"), changed)
    });
    let latin =
        Specimen::new("a document in Latin-1", sample.path.clone(), b"caf\xe9 \xe4\xf6\xfc\n".repeat(100));
    broken.chain([latin]).collect()
}

/// A layout that every exporter can write: two rooms with a door between, on the Earth.
pub fn plain_layout() -> Layout {
    let (left, right) = (rectangle(0.0, 0.0, 4.0, 3.0), rectangle(4.0, 0.0, 7.0, 3.0));
    let room = |id, name: &str, polygon: &Polygon| Room {
        id,
        name: Some(name.into()),
        stated_area: Some(polygon.area()),
        state: RoomState::Complete,
        inner: polygon.clone(),
        centre: polygon.clone(),
    };
    let wall = |a: [f64; 2], b: [f64; 2], rooms| Wall {
        line: Segment::new(a.into(), b.into()),
        thickness: 0.2,
        weight: 1.0,
        rooms,
    };
    Layout {
        rooms: vec![room(1, "Office", &left), room(2, "Store", &right)],
        walls: vec![
            wall([0.0, 0.0], [7.0, 0.0], [None, None]),
            wall([4.0, 0.0], [4.0, 3.0], [Some(1), Some(2)]),
        ],
        openings: vec![Opening {
            kind: OpeningKind::Door,
            segment: Segment::new(Point::new(4.0, 1.0), Point::new(4.0, 2.0)),
            rooms: [1, 2],
        }],
        anchor: Some(GeoAnchor { latitude: 48.1, longitude: 11.5, bearing: 10.0, at: Point::default() }),
        provenance: Provenance { source: "plan.yaml".into(), adapter: "slam-grid".into() },
        method: "paper".into(),
        ..Layout::default()
    }
}

fn rectangle(x0: f64, y0: f64, x1: f64, y1: f64) -> Polygon {
    Polygon::new([[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Point::from).to_vec(), vec![])
}

/// A scene for a layout, its grid so wide and high.
pub fn scene(width: u32, height: u32) -> Option<Scene> {
    let cells = vec![Cell::FREE; (width * height) as usize];
    let grid = Grid::new(width, height, 0.05, Pose { x: -1.0, y: 2.0, yaw: 0.3 }, cells).ok()?;
    let pose = Pose { x: 1.0, y: 1.0, yaw: 0.0 };
    let text = Text { content: "Küche".into(), pose, width: 1.0, height: 0.3, confidence: 0.9 };
    let at = |x: f64, y: f64| Point::new(x, y);
    let leaf = DoorLeaf { hinge: at(0.5, 1.0), closed: at(1.5, 1.0), open: at(0.5, 2.0) };
    let size = (0.3, 0.3, 0.8);
    let symbol = |kind: &str, leaves| {
        let (width, height, score) = size;
        Symbol { kind: kind.into(), pose, width, height, score, leaves }
    };
    let annotations = Annotations {
        texts: vec![text],
        symbols: vec![symbol("fire-extinguisher", vec![]), symbol("door", vec![leaf])],
        openings: Some(vec![StatedOpening {
            kind: OpeningKind::Door,
            segment: Segment::new(at(0.5, 1.0), at(1.5, 1.0)),
            depth: Some(0.1),
        }]),
        scale: Some(Scale { metres_per_pixel: 0.02, source: "door widths".into(), confidence: 0.5 }),
        ..Annotations::default()
    };
    Some(Scene::new(grid, annotations))
}

/// Layouts with one odd thing each, and what it is.
pub fn odd_layouts() -> Vec<(&'static str, Layout)> {
    let plain = plain_layout;
    let named = |name: &str| {
        let mut layout = plain();
        layout.rooms[0].name = Some(name.into());
        layout
    };
    let moved = |x: f64, scale: f64| {
        let mut layout = plain();
        let place = |p: &mut Point| *p = Point::new(p.x * scale + x, p.y * scale);
        for room in &mut layout.rooms {
            room.inner.exterior.iter_mut().chain(&mut room.centre.exterior).for_each(place);
        }
        layout
    };
    let mut holed = plain();
    holed.rooms[0].inner.holes = vec![[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0]].map(Point::from).to_vec()];
    let mut many = plain();
    many.rooms = (0..500).map(|i| Room { id: i + 1, ..many.rooms[0].clone() }).collect();
    let mut lost = plain();
    lost.openings[0].rooms = [7, 4_294_967_295];
    lost.walls[0].rooms = [Some(99), None];
    vec![
        ("no rooms at all", Layout::default()),
        ("no place on the Earth", Layout { anchor: None, ..plain() }),
        ("a room without a name", {
            let mut l = plain();
            l.rooms[0].name = None;
            l
        }),
        ("a room of an empty name", named("")),
        ("a name full of quotes and brackets", named("\"'<&>;,|\\{}()[]$`%s%n")),
        ("a name with line ends and control characters", named("a\r\nb\tc\u{1b}[31m\u{7f}")),
        ("a name with a zero byte", named("a\0b")),
        ("a name in several scripts", named("مطبخ 厨房 Küche \u{1f6aa}\u{202e}x")),
        ("a name of 100,000 characters", named(&"ä".repeat(100_000))),
        ("a room far away", moved(1e9, 1.0)),
        ("a room too small to see", moved(0.0, 1e-9)),
        ("a room with a hole", holed),
        ("500 rooms", many),
        ("a door between rooms that are not there", lost),
        ("a room without an outline", {
            let mut l = plain();
            l.rooms[0].inner = Polygon::default();
            l
        }),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn material_is_the_same_every_time_and_harmless_to_make() {
        let sample =
            Source { path: "a.map".into(), bytes: b"width 12\nheight 7\n....".to_vec(), byte_limit: 9 };
        let all = |s: &Source| {
            [cut(s), damaged(s), absurd(s), not_utf8(s), garbage("map")]
                .map(|v| v.into_iter().map(|x| x.source.bytes).collect::<Vec<_>>())
        };
        assert_eq!(all(&sample), all(&sample));
        let empty = Source { bytes: vec![], ..sample.clone() };
        assert_eq!(all(&empty).map(|v| v.len())[..3], [1, 0, 0]);
        assert!(absurd(&sample).iter().any(|s| s.source.bytes.starts_with(b"width 4294967295\nheight 7")));
        assert!(paths("map").len() > 5 && odd_layouts().len() > 10);
    }
}
