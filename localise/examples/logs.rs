//! How well a robot finds itself on the grid that was made of its log, and on the map of that grid's layout.
//!
//! `cargo run --release -p planform-localise --example logs -- LOG...`, with CARMEN logs that hold corrected poses and
//! odometry, plain or packed; for a log that keeps no odometry it is simulated. Prints a table for
//! docs/robots.md.
#![allow(clippy::unwrap_used)]

#[path = "../tests/mapped/mod.rs"]
mod mapped;

use mapped::mapped;
use planform::reconstruct::{Params as Reconstruction, reconstruct};
use planform_localise::{
    Errors, Field, Filter, Frame, Motion, Params, Random, Sweep, Walk, distance, follow,
};
use planform_radish::log::{self, LaserChoice, Log, Scan};
use planform_radish::unpack;
use planform_sdk::{Options, Pose, Source};
use std::path::Path;
use std::time::Instant;

/// How many starts from anywhere each map gets, evenly along the log.
const STARTS: usize = 10;

/// A start from anywhere has this way to find the robot, metres.
const WAY: f64 = 40.0;

/// It is found if it is no farther off than this, metres, for its last sweeps.
const FOUND: f64 = 0.5;
const LAST: usize = 10;

/// Standard deviations of where tracking begins: metres and radians.
const START: [f64; 2] = [0.1, 0.05];

fn main() {
    println!("| log | map | position: median, 95 % (m) | heading: median, 95 % (°) | found from anywhere |");
    println!("| --- | --- | --- | --- | --- |");
    for path in std::env::args().skip(1) {
        measure(Path::new(&path));
    }
}

fn measure(path: &Path) {
    let source = Source::open(path, Source::BYTE_LIMIT).unwrap();
    let frames = frames(&log::read(unpack::text(&source.bytes), LaserChoice::default()).unwrap());
    let adapter = planform_radish::adapter();
    let scene = adapter.read(&source, &Options::parse(&adapter.info().options, []).unwrap()).unwrap();
    let layout = reconstruct(&scene, &Reconstruction::default(), &mut ()).unwrap();
    for (name, grid) in [("its grid", scene.grid.clone()), ("its layout", mapped(&layout, &scene, &[]))] {
        let begun = Instant::now();
        let field = Field::new(grid, 1.0);
        let [position, far, heading, turned] = tracked(&field, &frames).summary();
        let (found, starts) = found(&field, &frames);
        let (heading, turned) = (heading.to_degrees(), turned.to_degrees());
        println!(
            "| {} | {name} | {position:.3}, {far:.3} | {heading:.2}, {turned:.2} | {found} of {starts} |",
            source.name()
        );
        eprintln!("{:.1?}", begun.elapsed());
    }
}

/// The scans with both their poses.
fn frames(log: &Log) -> Vec<Frame> {
    let pose = |p: log::Pose| Pose { x: p.x, y: p.y, yaw: p.theta };
    let sweep = |s: &Scan| Sweep {
        ranges: s.ranges.clone(),
        first_angle: s.first_angle,
        step: s.step,
        max_range: s.max_range,
    };
    let truth: Vec<_> = log.scans.iter().map(|s| pose(s.pose)).collect();
    let of_log: Option<Vec<_>> = log.scans.iter().map(|s| s.odometry.map(pose)).collect();
    let odometry = of_log.unwrap_or_else(|| simulated(&truth));
    let frame = |((s, truth), odometry)| Frame { odometry, truth, sweep: sweep(s) };
    log.scans.iter().zip(truth).zip(odometry).map(frame).collect()
}

/// Odometry of a robot that took this way, for a log that keeps none.
fn simulated(truth: &[Pose]) -> Vec<Pose> {
    let (mut random, noise) = (Random::new(1), Walk::default().noise);
    let mut odometry: Vec<Pose> = truth.first().copied().into_iter().collect();
    for (pair, i) in truth.windows(2).zip(0..) {
        let step = Motion::between(pair[0], pair[1]).sample(&noise, &mut random);
        let next = step.lead(odometry[i]);
        odometry.push(next);
    }
    odometry
}

fn tracked(field: &Field, frames: &[Frame]) -> Errors {
    let Some(first) = frames.first() else { return Errors::default() };
    let mut filter = Filter::at(field, Params::default(), first.truth, START, 1);
    follow(&mut filter, frames)
}

/// How many starts from anywhere find the robot, and how many there were.
fn found(field: &Field, frames: &[Frame]) -> (usize, usize) {
    let starts: Vec<usize> = (0..STARTS).map(|i| i * frames.len() / STARTS).collect();
    let finds = |start: &usize| {
        let mut filter = Filter::anywhere(field, Params::default(), *start as u64);
        follow(&mut filter, a_way(&frames[*start..])).at_the_end(LAST) <= FOUND
    };
    let found = planform_synth::parallel_map(&starts, finds);
    (found.into_iter().filter(|f| *f).count(), STARTS)
}

/// The first frames, up to the way that a start from anywhere has.
fn a_way(frames: &[Frame]) -> &[Frame] {
    let mut way = 0.0;
    let short = frames.windows(2).take_while(|pair| {
        way += distance(pair[0].odometry, pair[1].odometry);
        way < WAY
    });
    &frames[..short.count()]
}
