//! From a drawing to a robot: a made-up building's plan is read, its layout written as a map, and a robot in the
//! building finds itself on that map, wherever it starts.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod mapped;

use image::{DynamicImage, ImageFormat};
use mapped::mapped;
use planform::reconstruct::{Params as Reconstruction, reconstruct};
use planform_localise::{Field, Filter, Laser, Params, Walk, World, follow};
use planform_sdk::{Cell, Grid, Layout, Options, Point, Pose, Scene, Source, bounds};
use planform_synth::{Plan, PlanStyle};
use std::io::Cursor;

/// The robot is found if it is no farther from its estimate than this, metres, for its last sweeps.
const FOUND: f64 = 0.3;
const LAST: usize = 10;

const SEEDS: u64 = 10;
/// Of so many starts so many find the robot.
const FLOOR: usize = 9;

/// A wall of the building is at most so thick, metres: openings reach half as far to both sides.
const THICKEST: f64 = 0.5;

/// The plan as the program reads it.
fn read(plan: &Plan) -> Scene {
    let mut png = Cursor::new(vec![]);
    DynamicImage::from(plan.picture.clone()).write_to(&mut png, ImageFormat::Png).unwrap();
    let adapter = planform_blueprint::adapter();
    let source = Source { path: "plan.png".into(), bytes: png.into_inner(), byte_limit: Source::BYTE_LIMIT };
    // The scale is what the user knows, as that of the sheet.
    let scale = plan.truth.metres_per_pixel.to_string();
    let options = Options::parse(&adapter.info().options, [("metres-per-pixel", scale.as_str())]).unwrap();
    adapter.read(&source, &options).unwrap()
}

/// The building as it truly is: floors and open doors free, all else solid. Drawn apart from the exporter.
fn building(truth: &Layout) -> Grid {
    const CELL: f64 = 0.04;
    let (low, high) = bounds(truth.rooms.iter().flat_map(|r| r.centre.exterior.clone())).unwrap();
    let cells = |a: f64, b: f64| ((b - a) / CELL).ceil() as u32;
    let (width, height) = (cells(low.x, high.x), cells(low.y, high.y));
    let in_door = |p: Point| {
        truth.openings.iter().any(|o| {
            let (a, b, length) = (o.segment.a, o.segment.b, o.width());
            let (x, y) = ((b.x - a.x) / length, (b.y - a.y) / length);
            let along = (p.x - a.x) * x + (p.y - a.y) * y;
            let across = (p.y - a.y) * x - (p.x - a.x) * y;
            (0.0..=length).contains(&along) && across.abs() <= THICKEST / 2.0
        })
    };
    let is_free = |p: Point| truth.rooms.iter().any(|r| r.inner.contains(p)) || in_door(p);
    let cell = |i: u32| {
        let (column, row) = (f64::from(i % width) + 0.5, f64::from(i / width) + 0.5);
        let p = Point::new(low.x + column * CELL, low.y + row * CELL);
        if is_free(p) { Cell::FREE } else { Cell::OCCUPIED }
    };
    let origin = Pose { x: low.x, y: low.y, yaw: 0.0 };
    Grid::new(width, height, CELL, origin, (0..width * height).map(cell).collect()).unwrap()
}

/// How far off the robot is at the end of its walk, metres, for each seed.
fn ends(style: PlanStyle, seed: u64) -> Vec<f64> {
    let plan = Plan::draw(seed, style).unwrap();
    let scene = read(&plan);
    let layout = reconstruct(&scene, &Reconstruction::default(), &mut ()).unwrap();
    let field = Field::new(mapped(&layout, &scene, &[("resolution", "0.05")]), 1.0);
    let world = World::new(building(&plan.truth.layout));
    let end = |seed| {
        let frames = world.walk(&Laser::default(), &Walk::default(), seed);
        let mut filter = Filter::anywhere(&field, Params::default(), seed);
        follow(&mut filter, &frames).at_the_end(LAST)
    };
    let seeds: Vec<u64> = (0..SEEDS).collect();
    planform_synth::parallel_map(&seeds, |&seed| end(seed))
}

#[test]
fn a_robot_finds_itself_on_the_map_of_a_blueprint() {
    let ends = ends(PlanStyle::Blueprint, 3);
    let found = ends.iter().filter(|end| **end <= FOUND).count();
    println!("{found} of {SEEDS} starts: {ends:.2?} m");
    assert!(found >= FLOOR, "{found} of {SEEDS} starts: {ends:.2?} m");
}
