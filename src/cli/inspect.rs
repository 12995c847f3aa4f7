//! `planform inspect`.

use super::input::{InputArgs, Opened};
use super::{Failure, failure::print};
use crate::host::{Claim, Registry};
use clap::Args;
use planform_sdk::{Grid, Pose, Scene};
use serde::Serialize;
use std::fmt::Write;

const EXAMPLES: &str = "\
Examples:
  planform inspect map.yaml
  planform inspect scan.png --resolution 0.05
  planform inspect map.yaml --json";

/// From this occupancy on, in percent, a cell counts as occupied.
const OCCUPIED: u8 = 65;
/// Up to this occupancy, in percent, a cell counts as free.
const FREE: u8 = 25;

/// Tell what a document is and what it shows, without reconstructing anything
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct InspectArgs {
    #[command(flatten)]
    input: InputArgs,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &InspectArgs) -> Result<(), Failure> {
    let registry = Registry::builtin();
    let opened = Opened::open(&args.input, &registry)?;
    let options = opened.options(&args.input.settings(), &[])?;
    let scene = opened.read(&options[0])?;
    let report = Report::of(&opened.shown(), &registry.claims(&opened.source), &scene);
    print(&if args.json { report.json().into_bytes() } else { report.text().into_bytes() })
}

#[derive(Serialize)]
struct Report {
    file: String,
    adapter: String,
    claims: Vec<ClaimReport>,
    /// Columns and rows.
    cells: [u32; 2],
    /// Width and height, metres.
    metres: [f64; 2],
    /// Metres per cell.
    resolution: f64,
    origin: Pose,
    shares: Shares,
    texts: usize,
    symbols: usize,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct ClaimReport {
    adapter: String,
    percent: u8,
    reason: String,
}

/// How much of the grid is what, each 0 to 1.
#[derive(Serialize, Debug, PartialEq)]
struct Shares {
    free: f64,
    occupied: f64,
    between: f64,
    unknown: f64,
}

impl Shares {
    fn of(grid: &Grid) -> Self {
        let mut counts = [0usize; 4];
        for cell in grid.cells() {
            let kind = match cell.occupancy() {
                Some(..=FREE) => 0,
                Some(OCCUPIED..) => 1,
                Some(_) => 2,
                None => 3,
            };
            counts[kind] += 1;
        }
        let [free, occupied, between, unknown] = counts.map(|n| n as f64 / grid.cells().len() as f64);
        Self { free, occupied, between, unknown }
    }
}

impl Report {
    fn of(file: &str, claims: &[Claim<'_>], scene: &Scene) -> Self {
        let grid = &scene.grid;
        let metres = |cells: u32| f64::from(cells) * grid.resolution();
        Self {
            file: file.into(),
            adapter: scene.provenance.adapter.clone(),
            claims: claims.iter().map(ClaimReport::of).collect(),
            cells: [grid.width(), grid.height()],
            metres: [metres(grid.width()), metres(grid.height())],
            resolution: grid.resolution(),
            origin: grid.origin(),
            shares: Shares::of(grid),
            texts: scene.texts.len(),
            symbols: scene.symbols.len(),
            warnings: scene.warnings.clone(),
        }
    }

    fn json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    fn text(&self) -> String {
        let Self { origin, shares, cells, metres, .. } = self;
        let mut t = String::new();
        // Writing to a text cannot fail.
        let _ = writeln!(t, "{}", self.file);
        let _ = writeln!(t, "  read by     {}", self.adapter);
        for claim in &self.claims {
            let _ = writeln!(t, "              {}", claim.text());
        }
        let _ = writeln!(
            t,
            "  size        {} x {} cells, {:.2} x {:.2} m",
            cells[0], cells[1], metres[0], metres[1]
        );
        let _ = writeln!(t, "  resolution  {} m per cell", self.resolution);
        let _ = writeln!(t, "  origin      x {} m, y {} m, yaw {} rad", origin.x, origin.y, origin.yaw);
        for (name, share, meaning) in [
            ("free", shares.free, format!("occupancy of at most {FREE} %")),
            ("occupied", shares.occupied, format!("occupancy of at least {OCCUPIED} %")),
            ("between", shares.between, String::from("seen, but neither")),
            ("unknown", shares.unknown, String::from("not seen")),
        ] {
            let _ = writeln!(t, "  {name:<10}{:>6.1} %  ({meaning})", share * 100.0);
        }
        for warning in &self.warnings {
            let _ = writeln!(t, "  warning     {warning}");
        }
        t
    }
}

impl ClaimReport {
    fn of(claim: &Claim<'_>) -> Self {
        Self {
            adapter: claim.adapter.info().name.clone(),
            percent: claim.confidence.percent,
            reason: claim.confidence.reason.clone(),
        }
    }

    fn text(&self) -> String {
        let reason = if self.reason.is_empty() { "not its kind of document" } else { &self.reason };
        format!("{} is {} % sure: {reason}", self.adapter, self.percent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Cell;

    #[test]
    fn shares_add_up_at_the_thresholds() {
        let cells = [25, 26, 64, 65].map(Cell::percent).to_vec();
        let grid = Grid::new(4, 1, 0.05, Pose::default(), cells).unwrap();
        assert_eq!(Shares::of(&grid), Shares { free: 0.25, occupied: 0.25, between: 0.5, unknown: 0.0 });
    }
}
