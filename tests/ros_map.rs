//! The exporter `ros-map` on buildings whose truth is known: what it writes, read again, has the same rooms; and its two
//! files appear together or not at all.
//!
//! For other maps: `cargo test --test ros_map -- --ignored --nocapture`, with `MAPS` a list of YAML files, separated by
//! colons.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod cli_support;

use accuracy_support::{for_seeds, layout_of, shared, to_geo};
use cli_support::{Workshop, text};
use geo::Area;
use planform_sdk::{Document, Grid, Layout, Options, Output, Pose, Provenance, Room, Scene, Source};
use planform_synth::{Building, BuildingParams, ScanParams, Size};
use std::fs;

/// The least overlap of a room with itself when it was read back: common area over the area of both.
const SAME: f64 = 0.97;

/// The grid that a map server makes of the layout's map.
fn mapped(layout: &Layout, grid: &Grid) -> Grid {
    let scene = Scene::of_grid(grid.clone(), Provenance::default());
    let (mut yaml, mut pictures) = (vec![], [vec![]]);
    let output = Output { stem: "map", extension: "yaml", file: &mut yaml, companions: &mut pictures };
    let document = Document { layout, scene: Some(&scene) };
    planform_ros_map::exporter().write_files(&document, &Options::default(), output).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("map.yaml"), yaml).unwrap();
    fs::write(folder.path().join("map.pgm"), &pictures[0]).unwrap();
    let read = Source::open(folder.path().join("map.yaml"), Source::BYTE_LIMIT).unwrap();
    let adapter = planform_slam_grid::adapter();
    let options = Options::parse(&adapter.info().options, []).unwrap();
    adapter.read(&read, &options).unwrap().grid
}

/// For each room of the layout how much of it is the same in the layout of its map.
fn overlaps(layout: &Layout, grid: &Grid) -> Vec<f64> {
    let back = layout_of(mapped(layout, grid));
    let floors: Vec<_> = back.rooms.iter().map(|r| to_geo(&r.inner)).collect();
    let best = |room: &Room| {
        let floor = to_geo(&room.inner);
        let overlap = |other: &geo::Polygon<f64>| {
            let common = shared(&floor, other);
            common / (floor.unsigned_area() + other.unsigned_area() - common)
        };
        floors.iter().map(overlap).fold(0.0, f64::max)
    };
    layout.rooms.iter().map(best).collect()
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
        (i, overlaps(&layout, &grid))
    });
    let rooms: usize = all.iter().map(|(_, o)| o.len()).sum();
    assert!(rooms > 200, "{rooms} rooms");
    let low = |(i, overlaps): &(u64, Vec<f64>)| {
        let low: Vec<_> = (1..).zip(overlaps).filter(|(_, o)| **o < SAME).collect();
        (!low.is_empty()).then(|| format!("building {i}: {low:.3?}"))
    };
    let low: Vec<_> = all.iter().filter_map(low).collect();
    assert!(low.is_empty(), "of {rooms} rooms:\n{}", low.join("\n"));
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
        let mut overlaps = overlaps(&layout, &grid);
        overlaps.sort_by(f64::total_cmp);
        let low = overlaps.iter().filter(|o| **o < SAME).count();
        println!("{path}: {} rooms, {low} below {SAME}, lowest {:.3?}", overlaps.len(), overlaps.first());
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
