//! How accuracy falls as maps get worse: made-up buildings, mapped by a robot, reconstructed with the default
//! parameters and compared with their truth, while one thing at a time is varied. Writes `docs/robustness.svg` and the
//! tables between the markers of `docs/accuracy.md`; the same buildings give the same bytes.
//!
//!     cargo bench --bench robustness
//!     cargo bench --bench robustness -- --buildings 30
#![allow(clippy::unwrap_used)]

#[path = "../../tests/accuracy_support/mod.rs"]
mod accuracy_support;
mod curves;
mod exploration;
mod factors;
mod page;
mod plot;
mod trial;

use std::fs;
use std::path::Path;
use std::time::Instant;

/// How many buildings, unless the command line says otherwise.
const BUILDINGS: u64 = 12;

fn main() {
    // `cargo test` runs benchmarks as well, and they prove nothing there.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    let buildings = buildings();
    let start = Instant::now();
    let curves = curves::draw(buildings);
    let steps = exploration::explore(buildings);
    let (robustness, exploration) =
        (curves::report(&curves, buildings), exploration::report(&steps, buildings));
    println!("{robustness}\n{exploration}\n{:.0} s", start.elapsed().as_secs_f64());
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    fs::write(docs.join("robustness.svg"), plot::plot(&curves)).unwrap();
    let file = docs.join("accuracy.md");
    let page = fs::read_to_string(&file).unwrap();
    let page = page::between(&page, "robustness", &robustness).unwrap();
    let page = page::between(&page, "exploration", &exploration).unwrap();
    fs::write(file, page).unwrap();
}

fn buildings() -> u64 {
    let mut args = std::env::args().skip_while(|a| a != "--buildings").skip(1);
    let count = args.next().map(|n| n.parse().ok().filter(|n| *n > 0));
    count.map_or(BUILDINGS, |n| n.expect("`--buildings` is followed by how many, 1 or more"))
}
