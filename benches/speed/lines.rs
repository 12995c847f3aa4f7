//! What becomes of the time of the method `paper` as buildings get more representative lines, with whose square the
//! faces grow.

use crate::Bench;
use crate::page::table;
use crate::run::Run;
use crate::staircase::{RESOLUTION, rooms};
use std::fs;

/// How many lines.
const COUNTS: [usize; 5] = [10, 100, 500, 1000, 2000];

/// How many of these are few.
const QUICK: usize = 2;

/// The steps that work on lines and faces.
const STEPS: [&str; 3] = ["faces", "affinity", "rooms"];

/// The table.
pub fn report(bench: &Bench<'_>) -> String {
    let counts = &COUNTS[..if bench.quick { QUICK } else { COUNTS.len() }];
    let header = ["lines", "faces, s", "affinity, s", "rooms, s", "all three, s", "whole, s", "peak, MiB"];
    let rows: Vec<_> = counts.iter().map(|&count| row(bench, count)).collect();
    format!("### Lines\n\n{}", table(&header.map(String::from), &rows))
}

fn row(bench: &Bench<'_>, count: usize) -> Vec<String> {
    // Four lines each, and a tenth of the rooms to spare: where walls of several rooms meet, a line may be missed.
    rooms(count / 4 + count / 40 + 2).save(bench.folder, RESOLUTION);
    let most = count.to_string();
    let arguments =
        ["-o", "out.layout.json", "--method", "paper", "--max-faces", "2000000", "--max-lines", &most];
    let run = Run::best(bench.runs, bench.folder, &arguments);
    let seconds = |s: f64| format!("{s:.3}");
    let steps = STEPS.map(|s| run.step(s));
    let times = steps.into_iter().chain([steps.iter().sum(), run.whole]).map(seconds);
    [found(bench).to_string()].into_iter().chain(times).chain([run.told_peak()]).collect()
}

/// How many representative lines the layout has.
fn found(bench: &Bench<'_>) -> usize {
    let layout = fs::read(bench.folder.join("out.layout.json")).unwrap();
    let layout: planform_sdk::Layout = serde_json::from_slice(&layout).unwrap();
    layout.lines.len()
}
