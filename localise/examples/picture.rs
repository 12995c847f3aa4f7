//! Draws docs/robots.svg: the way of a robot by the particle filter and as it was, on the layout that it finds itself
//! on.
//!
//! `cargo run --release -p planform-localise --example picture > docs/robots.svg`
#![allow(clippy::unwrap_used)]

#[path = "../tests/mapped/mod.rs"]
mod mapped;

use mapped::mapped;
use planform::reconstruct::{Params as Reconstruction, reconstruct};
use planform_localise::{Errors, Field, Filter, Frame, Laser, Params, Walk, World, follow};
use planform_sdk::{Layout, Point, Pose, Provenance, Scene};
use planform_synth::{Building, BuildingParams, ScanParams, Size};
use std::fmt::Write;

/// The building, and the seed of the walk in it.
const BUILDING: u64 = 4;
const WALK: u64 = 2;

/// Pixels per metre.
const SCALE: f64 = 16.0;

fn main() {
    let building = Building::generate(BUILDING, &BuildingParams::of_size(Size::Office));
    let grid = building.scan(&ScanParams::default()).unwrap().grid;
    let scene = Scene::of_grid(grid, Provenance::default());
    let layout = reconstruct(&scene, &Reconstruction::default(), &mut ()).unwrap();
    let field = Field::new(mapped(&layout, &scene, &[]), 1.0);
    let world = World::new(building.clean_grid(0.04).unwrap());
    let walk = Walk { length: 90.0, ..Walk::default() };
    let frames = world.walk(&Laser::default(), &walk, WALK);
    let mut filter = Filter::anywhere(&field, Params::default(), WALK);
    let errors = follow(&mut filter, &frames);
    print!("{}", drawing(&layout, &frames, &errors));
}

fn drawing(layout: &Layout, frames: &[Frame], errors: &Errors) -> String {
    let (low, high) = layout.bounds().unwrap();
    let (width, height) = ((high.x - low.x + 1.0) * SCALE, (high.y - low.y + 1.0) * SCALE);
    let at = |p: Point| format!("{:.1} {:.1}", (p.x - low.x + 0.5) * SCALE, (high.y - p.y + 0.5) * SCALE);
    let path = |points: &[Point]| points.iter().map(|p| at(*p)).collect::<Vec<_>>().join("L");
    let places =
        |poses: &mut dyn Iterator<Item = Pose>| poses.map(|p| Point::new(p.x, p.y)).collect::<Vec<_>>();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" fill=\"none\">\n\
         <path fill=\"#fff\" d=\"M0 0H{width:.0}V{height:.0}H0Z\"/>\n"
    );
    for room in &layout.rooms {
        let rings: String = room.inner.rings().map(|r| format!("M{}Z", path(r))).collect();
        let _ = writeln!(svg, "<path fill=\"#eef\" stroke=\"#335\" d=\"{rings}\"/>");
    }
    for opening in &layout.openings {
        let door = path(&[opening.segment.a, opening.segment.b]);
        let _ = writeln!(svg, "<path stroke=\"#fa0\" stroke-width=\"3\" d=\"M{door}\"/>");
    }
    let truth = path(&places(&mut frames.iter().map(|f| f.truth)));
    let _ = writeln!(svg, "<path stroke=\"#888\" stroke-width=\"4\" d=\"M{truth}\"/>");
    for (estimate, error) in errors.estimates.iter().zip(&errors.position) {
        let colour = if *error <= 0.3 { "#080" } else { "#c00" };
        let centre = at(Point::new(estimate.x, estimate.y));
        let (x, y) = centre.split_once(' ').unwrap();
        let _ = writeln!(svg, "<circle fill=\"{colour}\" cx=\"{x}\" cy=\"{y}\" r=\"2\"/>");
    }
    svg + "</svg>\n"
}
