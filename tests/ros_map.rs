//! The exporter `ros-map` on buildings whose truth is known: what it writes, read again, has the same rooms; and its
//! two files appear together or not at all.
//!
//! For other maps: `cargo test --test ros_map -- --ignored --nocapture`, with `MAPS` a list of YAML files or
//! pictures, separated by colons.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod cli_support;

use accuracy_support::{for_seeds, layout_of, shared, to_geo};
use cli_support::{Workshop, text};
use geo::Area;
use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{
    Cell, Document, Grid, Layout, OpeningKind, Options, Output, Point, Pose, Provenance, Room, RoomId, Scene,
    Segment, Source, StatedOpening,
};
use planform_synth::{Building, BuildingParams, ScanParams, Size};
use std::fs;

/// The least overlap of a room with itself when it was read back: common area over the area of both.
const SAME: f64 = 0.97;

/// The layout's map: its YAML file and its picture.
fn written(layout: &Layout, grid: &Grid) -> (String, Vec<u8>) {
    let scene = Scene::of_grid(grid.clone(), Provenance::default());
    let (mut yaml, mut pictures) = (vec![], [vec![]]);
    let output = Output { stem: "map", extension: "yaml", file: &mut yaml, companions: &mut pictures };
    let document = Document { layout, scene: Some(&scene) };
    planform_ros_map::exporter().write_files(&document, &Options::default(), output).unwrap();
    let [picture] = pictures;
    (String::from_utf8(yaml).unwrap(), picture)
}

/// The layout of a map, read from its two files.
fn read_back(yaml: &str, picture: &[u8]) -> Layout {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("map.yaml"), yaml).unwrap();
    fs::write(folder.path().join("map.pgm"), picture).unwrap();
    let read = Source::open(folder.path().join("map.yaml"), Source::BYTE_LIMIT).unwrap();
    let adapter = planform_slam_grid::adapter();
    let options = Options::parse(&adapter.info().options, []).unwrap();
    let scene = adapter.read(&read, &options).unwrap();
    assert_eq!(scene.warnings, [""; 0]);
    reconstruct(&scene, &Params::default(), &mut ()).unwrap()
}

/// Each room of a layout, and how much of its floor is the same in another one.
fn overlaps(layout: &Layout, back: &Layout) -> Vec<(RoomId, f64)> {
    let floors: Vec<_> = back.rooms.iter().map(|r| to_geo(&r.inner)).collect();
    let of_room = |room: &Room| {
        let floor = to_geo(&room.inner);
        let overlap = |other: &geo::Polygon<f64>| {
            let common = shared(&floor, other);
            common / (floor.unsigned_area() + other.unsigned_area() - common)
        };
        (room.id, floors.iter().map(overlap).fold(0.0, f64::max))
    };
    layout.rooms.iter().map(of_room).collect()
}

/// What is kept of each room when the layout's map is read.
fn kept(layout: &Layout, grid: &Grid) -> Vec<(RoomId, f64)> {
    let (yaml, picture) = written(layout, grid);
    overlaps(layout, &read_back(&yaml, &picture))
}

/// The grid elsewhere in the map frame.
fn turned(grid: &Grid) -> Grid {
    let origin = Pose { x: -7.3, y: 2.11, yaw: 0.4 };
    Grid::new(grid.width(), grid.height(), grid.resolution(), origin, grid.cells().to_vec()).unwrap()
}

#[test]
fn what_is_written_has_the_same_rooms() {
    let sizes = [Size::House, Size::Office, Size::School];
    let all = for_seeds(0..24, |i| {
        let building = Building::generate(i, &BuildingParams::of_size(sizes[i as usize % 3]));
        let grid = if i % 2 == 0 {
            building.clean_grid(0.05).unwrap()
        } else {
            building.scan(&ScanParams { seed: i, ..ScanParams::default() }).unwrap().grid
        };
        let grid = turned(&grid);
        let layout = layout_of(grid.clone());
        (i, kept(&layout, &grid))
    });
    let rooms = || all.iter().flat_map(|(i, kept)| kept.iter().map(move |k| (i, k)));
    let changed = rooms().filter(|(_, (_, overlap))| *overlap < SAME);
    let list: String = changed.map(|(i, (room, o))| format!("building {i}, room {room}: {o:.3}\n")).collect();
    assert!(rooms().count() > 300, "{} rooms", rooms().count());
    assert_eq!(list, "");
}

/// A hall of 12 x 5 m in the middle of a map, whose right end was parted from the rest though no wall is there.
fn parted_hall() -> (Layout, Grid) {
    let cell = |x: u32, y: u32| match (x, y) {
        (20..260, 20..120) => Cell::FREE,
        (18..262, 18..122) => Cell::OCCUPIED,
        _ => Cell::UNKNOWN,
    };
    let cells = (0..140).flat_map(|y| (0..280).map(move |x| cell(x, y))).collect();
    let grid = Grid::new(280, 140, 0.05, Pose::default(), cells).unwrap();
    let line = Segment::new(Point::new(9.0, 1.0), Point::new(9.0, 6.0));
    let passage = StatedOpening { kind: OpeningKind::Passage, segment: line, depth: Some(0.0) };
    let mut scene = Scene::of_grid(grid.clone(), Provenance::default());
    scene.openings = Some(vec![passage]);
    (reconstruct(&scene, &Params::default(), &mut ()).unwrap(), grid)
}

fn areas(layout: &Layout) -> Vec<f64> {
    layout.rooms.iter().map(|r| (r.area() * 10.0).round() / 10.0).collect()
}

#[test]
fn an_opening_as_wide_as_its_rooms_is_stated() {
    let (layout, grid) = parted_hall();
    assert_eq!(areas(&layout), [40.0, 20.0]);
    assert_eq!(layout.openings.len(), 1);
    let (yaml, picture) = written(&layout, &grid);
    let back = read_back(&yaml, &picture);
    assert_eq!((areas(&back), &back.openings), (areas(&layout), &layout.openings));
    let (without, _) = yaml.split_once("planform:").unwrap();
    assert_eq!(areas(&read_back(without, &picture)), [60.0]);
}

#[test]
fn what_was_drawn_into_the_picture_counts() {
    let (layout, grid) = parted_hall();
    let (yaml, mut picture) = written(&layout, &grid);
    let cells = picture.len() - 280 * 140;
    // A wall across the hall at 4 m, and another one where the opening was.
    for (row, column) in (0..140).flat_map(|row| [(row, 100), (row, 101), (row, 179), (row, 180)]) {
        picture[cells + row * 280 + column] = 0;
    }
    let back = read_back(&yaml, &picture);
    assert_eq!((back.rooms.len(), back.openings.len()), (3, 0));
}

#[test]
#[ignore = "needs maps, and holds nobody to what it prints"]
fn table() {
    let adapter = planform_slam_grid::adapter();
    for path in std::env::var("MAPS").unwrap().split(':') {
        let source = Source::open(path, Source::BYTE_LIMIT).unwrap();
        let options = Options::parse(&adapter.info().options, []).unwrap();
        let grid = adapter.read(&source, &options).unwrap().grid;
        let layout = layout_of(grid.clone());
        let kept = kept(&layout, &grid);
        let low = kept.iter().filter(|(_, overlap)| *overlap < SAME);
        let low: Vec<_> = low.map(|(room, o)| (room, (o * 1e3).round() / 1e3)).collect();
        println!("{path}: {} rooms, {} below {SAME}: {low:?}", kept.len(), low.len());
    }
}

#[test]
fn two_files_appear_together_or_not_at_all() {
    let w = Workshop::new();
    w.write("out.pgm", b"precious");
    w.refuses("convert map.yaml -o out.yaml", 1, &["out.pgm: is there already"]);
    w.does("convert map.yaml -o out.yaml --force");
    assert!(text(&w.read("out.yaml")).starts_with("image: out.pgm\n"));
    assert!(w.read("out.pgm").starts_with(b"P5\n"));
}

#[test]
fn a_map_needs_a_place_for_its_picture() {
    let w = Workshop::new();
    w.refuses("convert map.yaml -o - --to ros-map", 2, &["`.pgm` file beside it"]);
    w.refuses("convert map.yaml -o a.yaml -o a.yml", 2, &["a.pgm: belongs to two outputs"]);
    w.refuses(
        "convert map.pgm --resolution 0.05 -o map.yml --force",
        2,
        &["map.pgm: is both input and output"],
    );
}
