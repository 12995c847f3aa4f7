//! The number of threads changes nothing but the time.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod batch_support;
mod cli_support;

use batch_support::log;
use cli_support::{FREE, UNKNOWN, WALL, Workshop, YAML, pgm};
use image::ImageFormat;
use planform_sdk::Grid;
use planform_synth::{Building, BuildingParams, Plan, PlanStyle, ScanParams, Size};

/// Converts the document on one, two and eight threads.
fn same_on_all(w: &Workshop, document: &str) {
    let convert = |threads: u32| {
        let outputs = ["geojson", "dxf", "layout.json"].map(|format| format!("{threads}.{format}"));
        let args = outputs.each_ref().map(|output| format!("-o {output}")).join(" ");
        w.does(&format!("convert {document} {args} --threads {threads}"));
        outputs.map(|output| w.read(&output))
    };
    let alone = convert(1);
    assert!(alone.iter().all(|output| !output.is_empty()));
    for threads in [2, 8] {
        for (output, expected) in convert(threads).iter().zip(&alone) {
            assert!(output == expected, "{document}: {threads} threads give something else than one");
        }
    }
}

/// The picture of a robot's map.
fn picture(grid: &Grid) -> Vec<u8> {
    pgm(grid.width(), grid.height(), |x, y| {
        match grid.cell(i64::from(x), i64::from(grid.height() - 1 - y)).occupancy() {
            None => UNKNOWN,
            Some(percent) if percent >= 65 => WALL,
            Some(_) => FREE,
        }
    })
}

#[test]
fn a_robots_map() {
    let building = Building::generate(2, &BuildingParams::of_size(Size::School));
    let grid = building.scan(&ScanParams { seed: 2, ..ScanParams::default() }).unwrap().grid;
    // Rows are parted among threads by 262144 bytes at least; this is enough for several, a byte for each cell.
    assert!(grid.cells().len() > 4 << 18, "{} x {}", grid.width(), grid.height());
    let w = Workshop::empty();
    w.write("map.yaml", YAML);
    w.write("map.pgm", picture(&grid));
    same_on_all(&w, "map.yaml");
}

#[test]
fn a_blueprint() {
    let plan = Plan::draw(3, PlanStyle::Blueprint).unwrap();
    let w = Workshop::empty();
    plan.picture.save_with_format(w.path("plan.png"), ImageFormat::Png).unwrap();
    same_on_all(&w, "plan.png");
}

#[test]
fn a_laser_log() {
    let w = Workshop::empty();
    w.write("turning.log", log());
    same_on_all(&w, "turning.log");
}

#[test]
fn there_is_at_least_one_thread() {
    let w = Workshop::new();
    for none in ["0", "-1", "many", "1.5", "1025"] {
        let sentence = format!("'{none}' for '--threads <N>': give a whole number from 1 to 1024");
        w.refuses(&format!("convert map.yaml -o a.svg --threads={none}"), 2, &[&sentence]);
    }
}
