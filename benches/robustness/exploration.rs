//! Rooms seen in part: the robot stops ever later, and its map grows.

use crate::accuracy_support::for_seeds;
use crate::accuracy_support::states::Tally;
use crate::page::{percent, table};
use crate::trial::{Trial, layout};

/// Shares of the rooms that the robot has entered when it stops.
const SHARES: [f64; 9] = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];

/// What was right when the robot had entered this share of the rooms.
pub struct Step {
    share: f64,
    tally: Tally,
}

/// Maps each building again and again, a little more of it each time.
pub fn explore(buildings: u64) -> Vec<Step> {
    let tallies = for_seeds(0..SHARES.len() as u64 * buildings, |job| {
        let mut trial = Trial::usual(job % buildings + 1);
        trial.scan.unexplored = 1.0 - SHARES[(job / buildings) as usize];
        // No door is closed: what is missing is what the robot has not come to yet.
        trial.scan.closed_doors = 0.0;
        let (building, scan) = trial.map();
        Tally::of(&layout(scan.grid), building.layout(), &scan.rooms)
    });
    let steps = tallies.chunks(buildings as usize).zip(SHARES);
    steps.map(|(tallies, share)| Step { share, tally: tallies.iter().sum() }).collect()
}

/// The table's columns: numbers of rooms up to `missed`, percent from there.
const HEADER: [&str; 9] = [
    "rooms entered, %",
    "complete",
    "partial",
    "missed",
    "state right",
    "complete right",
    "partial right",
    "IoU of partial",
    "seen of partial",
];

/// The table, with a row for all steps together.
pub fn report(steps: &[Step], buildings: u64) -> String {
    let all: Tally = steps.iter().map(|s| &s.tally).sum();
    let mut rows: Vec<_> = steps.iter().map(|s| row(percent(s.share), &s.tally)).collect();
    rows.push(row("all".into(), &all));
    let (table, right) = (table(&HEADER.map(String::from), &rows), percent(all.right()));
    let counts = format!("{buildings} buildings; numbers of rooms, and percent.");
    format!("{counts}\n\n{table}\nThe state of {right} % of the rooms is right.\n")
}

fn row(name: String, tally: &Tally) -> Vec<String> {
    let shares = [tally.right(), tally.complete_right(), tally.partial_right(), tally.iou(), tally.seen()];
    let counts = [tally.complete, tally.partial, tally.missed].map(|n| n.to_string());
    [name].into_iter().chain(counts).chain(shares.map(percent)).collect()
}
