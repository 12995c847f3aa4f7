//! The exporter `ros-map` on buildings whose truth is known: what it writes, read again, has the same rooms; and its
//! two files appear together or not at all.
//!
//! For other maps: `cargo test --test ros_map -- --ignored --nocapture`, with `MAPS` a list of YAML files, separated by
//! colons.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod cli_support;
#[path = "../localise/tests/mapped/mod.rs"]
mod mapped;

use accuracy_support::{for_seeds, layout_of, shared, to_geo};
use cli_support::{Workshop, text};
use geo::Area;
use mapped::mapped;
use planform_sdk::{Grid, Layout, Opening, Options, Pose, Provenance, Room, RoomId, Scene, Source};
use planform_synth::{Building, BuildingParams, ScanParams, Size};

/// The least overlap of a room with itself when it was read back: common area over the area of both.
const SAME: f64 = 0.97;

/// Less wall than this beside an opening is none, metres.
const JAMBS: f64 = 0.5;

/// A room and how much of its floor is the same when the layout's map is read.
struct Kept {
    room: RoomId,
    overlap: f64,
    /// Whether there is a piece of wall beside every opening of it. Where a passage is as wide as its wall there is
    /// nothing to draw, and the reader parts the floor as it sees fit.
    walled: bool,
}

/// What is kept of each room of the layout.
fn kept(layout: &Layout, grid: &Grid) -> Vec<Kept> {
    let scene = Scene::of_grid(grid.clone(), Provenance::default());
    let back = layout_of(mapped(layout, &scene, &[]));
    let floors: Vec<_> = back.rooms.iter().map(|r| to_geo(&r.inner)).collect();
    let of_room = |room: &Room| {
        let floor = to_geo(&room.inner);
        let overlap = |other: &geo::Polygon<f64>| {
            let common = shared(&floor, other);
            common / (floor.unsigned_area() + other.unsigned_area() - common)
        };
        Kept {
            room: room.id,
            overlap: floors.iter().map(overlap).fold(0.0, f64::max),
            walled: !layout.openings.iter().any(|o| o.rooms.contains(&room.id) && is_wall_less(layout, o)),
        }
    };
    layout.rooms.iter().map(of_room).collect()
}

/// Whether an opening leaves nearly nothing of the wall between its rooms.
fn is_wall_less(layout: &Layout, opening: &Opening) -> bool {
    let pair = |a: RoomId, b: RoomId| opening.rooms == [a.min(b), a.max(b)];
    let between = layout.walls.iter().filter(|w| matches!(w.rooms, [Some(a), Some(b)] if pair(a, b)));
    let others = layout.openings.iter().filter(|o| o.rooms == opening.rooms);
    let wall: f64 = between.map(|w| w.line.length()).sum::<f64>() - others.map(Opening::width).sum::<f64>();
    wall < JAMBS
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
    let changed = || rooms().filter(|(_, k)| k.overlap < SAME);
    let line = |(i, k): (&u64, &Kept)| format!("building {i}, room {}: {:.3}\n", k.room, k.overlap);
    let (count, walled) = (rooms().count(), rooms().filter(|(_, k)| k.walled).count());
    let list: String = changed().map(line).collect();
    println!("{count} rooms, {walled} of them walled, {} changed:\n{list}", changed().count());
    assert!(count > 300 && walled * 10 >= count * 6, "{count} rooms, {walled} of them walled");
    assert!(changed().count() * 40 <= count, "of {count} rooms changed\n{list}");
    assert!(!changed().any(|(_, k)| k.walled), "{list}");
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
        let low = kept.iter().filter(|k| k.overlap < SAME);
        let low: Vec<_> = low.map(|k| (k.room, (k.overlap * 1e3).round() / 1e3, k.walled)).collect();
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
