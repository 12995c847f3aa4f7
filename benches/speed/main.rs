//! How fast planform is, and how much memory it takes, as maps get larger and buildings get more walls: the program is
//! run on documents that are made here, and the best of some runs is told as tables in Markdown. `scripts/speed` puts
//! them into `docs/performance.md`.
//!
//!     cargo bench --bench speed
//!     cargo bench --bench speed -- --runs 5
//!     cargo bench --bench speed -- --quick     # small documents only, to see that it works
#![allow(clippy::unwrap_used)]

mod lines;
// The page's other functions are for the bench that it belongs to.
#[allow(dead_code)]
#[path = "../robustness/page.rs"]
mod page;
mod picture;
mod run;
mod size;
mod staircase;
mod tiles;

use std::path::Path;

/// How often each is run, unless the command line says otherwise.
const RUNS: usize = 3;

/// Where and how often is measured.
pub struct Bench<'a> {
    /// Documents and outputs are put here.
    folder: &'a Path,
    /// How often each is run; the quickest counts.
    runs: usize,
    /// Small documents only.
    quick: bool,
}

fn main() {
    // `cargo test` runs benchmarks as well, and they prove nothing there.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let quick = std::env::args().any(|a| a == "--quick");
    let bench = Bench { folder: folder.path(), runs: runs(), quick };
    println!("{}\n{}", size::report(&bench), lines::report(&bench));
}

fn runs() -> usize {
    let mut args = std::env::args().skip_while(|a| a != "--runs").skip(1);
    let count = args.next().map(|n| n.parse().ok().filter(|n| *n > 0));
    count.map_or(RUNS, |n| n.expect("`--runs` is followed by how many, 1 or more"))
}
