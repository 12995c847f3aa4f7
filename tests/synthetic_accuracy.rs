//! The paper's method on buildings whose truth is known.
//!
//! To see a building: `cargo run -p planform-synth -- --help`, then `planform convert` with `--debug-dir`.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;

use accuracy_support::{centres, coverage, for_seeds, layout_of};
use planform_synth::{Building, BuildingParams, Noise, ScanParams, Size};

/// What one building gave.
struct Score {
    seed: u64,
    found: usize,
    rooms: usize,
    forward: f64,
    backward: f64,
}

fn score(seed: u64) -> Score {
    let building = Building::generate(seed, &BuildingParams::of_size(Size::School));
    let params = ScanParams { seed, noise: Noise::default(), ..ScanParams::default() };
    let scan = building.scan(&params).unwrap();
    let truth = centres(&scan.seen_layout(building.layout()));
    let found = centres(&layout_of(scan.grid));
    Score {
        seed,
        found: found.len(),
        rooms: truth.len(),
        forward: coverage(&found, &truth),
        backward: coverage(&truth, &found),
    }
}

fn mean(scores: &[Score], of: impl Fn(&Score) -> f64) -> f64 {
    scores.iter().map(of).sum::<f64>() / scores.len() as f64
}

#[test]
fn noisy_schools_are_found_as_well_as_the_paper_says() {
    let scores = for_seeds(1..=20, score);
    for s in &scores {
        println!(
            "seed {:2}: {:2} rooms of {:2}, A_FC {:.3}, A_BC {:.3}",
            s.seed, s.found, s.rooms, s.forward, s.backward
        );
    }
    assert!(scores.iter().all(|s| s.rooms >= 20), "the robot did not see the whole school");
    let (forward, backward) = (mean(&scores, |s| s.forward), mean(&scores, |s| s.backward));
    println!("mean A_FC {forward:.3}, mean A_BC {backward:.3}");
    assert!(forward >= 0.87, "mean A_FC is {forward:.3}");
    assert!(backward >= 0.87, "mean A_BC is {backward:.3}");
}
