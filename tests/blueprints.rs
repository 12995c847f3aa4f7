//! The adapter `blueprint` on drawn plans whose truth is known.
//!
//! To see a plan: `cargo run -p planform-synth -- --plan blueprint --seed 3 --out plan`. The table alone, without
//! floors: `cargo test --test blueprints -- --ignored --nocapture`.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod plan_support;

use accuracy_support::for_seeds;
use image::{DynamicImage, ImageFormat};
use plan_support::{PlanScore, mean, print, score};
use planform::host::Registry;
use planform_sdk::Source;
use planform_synth::{Plan, PlanStyle};
use std::io::Cursor;

/// Means over the plans, a little under what is reached.
struct Floors {
    removed: f64,
    /// At most.
    lost: f64,
    words: f64,
    precision: f64,
    recall: f64,
    names: f64,
    a_fc: f64,
    a_bc: f64,
    /// At most.
    scale_error: f64,
}

const FLOORS: Floors = Floors {
    removed: 0.965,
    lost: 0.002,
    words: 0.895,
    precision: 0.93,
    recall: 0.885,
    names: 0.895,
    a_fc: 0.94,
    a_bc: 0.905,
    scale_error: 0.033,
};

const PLANS: u64 = 20;

const STYLES: [PlanStyle; 2] = [PlanStyle::Blueprint, PlanStyle::Evacuation];

fn scores() -> Vec<PlanScore> {
    for_seeds(0..2 * PLANS, |i| score(STYLES[(i / PLANS) as usize], i % PLANS + 1))
}

#[test]
fn forty_plans_are_read_well() {
    let scores = scores();
    print(&scores);
    let reached: [(&str, f64, f64); 9] = [
        ("words removed", mean(&scores, |s| s.removed), FLOORS.removed),
        ("walls kept", 1.0 - mean(&scores, |s| s.lost), 1.0 - FLOORS.lost),
        ("words read right", mean(&scores, |s| s.words.share()), FLOORS.words),
        ("symbols' precision", mean(&scores, |s| s.symbols.total().precision()), FLOORS.precision),
        ("symbols' recall", mean(&scores, |s| s.symbols.total().recall()), FLOORS.recall),
        ("room names right", mean(&scores, |s| s.rooms.names.share()), FLOORS.names),
        ("A_FC", mean(&scores, |s| s.rooms.a_fc), FLOORS.a_fc),
        ("A_BC", mean(&scores, |s| s.rooms.a_bc), FLOORS.a_bc),
        ("scale right", 1.0 - mean(&scores, |s| s.scale_error), 1.0 - FLOORS.scale_error),
    ];
    let missed: Vec<String> = reached
        .iter()
        .filter(|(_, value, floor)| value < floor)
        .map(|(name, value, floor)| format!("{name} {value:.3} < {floor:.3}"))
        .collect();
    assert!(missed.is_empty(), "{}", missed.join(", "));
}

#[test]
fn every_plan_is_given_to_the_reader_of_plans() {
    let readers = for_seeds(0..2 * PLANS, |i| {
        let plan = Plan::draw(i % PLANS + 1, STYLES[(i / PLANS) as usize]).unwrap();
        let mut png = Cursor::new(vec![]);
        DynamicImage::from(plan.picture).write_to(&mut png, ImageFormat::Png).unwrap();
        let source =
            Source { path: "plan.png".into(), bytes: png.into_inner(), byte_limit: Source::BYTE_LIMIT };
        (i, Registry::builtin().claims(&source)[0].adapter.info().name.clone())
    });
    let others: Vec<_> = readers.iter().filter(|(_, reader)| reader != "blueprint").collect();
    assert!(others.is_empty(), "{others:?}");
}

#[test]
#[ignore = "prints the table, and holds nobody to it"]
fn table() {
    print(&scores());
}
