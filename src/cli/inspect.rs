//! `planform inspect`.

use super::Failure;
use super::caps::CapArgs;
use super::failure::{print, safe};
use super::input::{InputArgs, Opened};
use super::outside::{OutsideArgs, tell_messages, tell_refusals};
use super::progress::Voice;
use crate::host::Claim;
use crate::reconstruct::Contour;
use clap::Args;
use planform_sdk::{Confidence, GeoAnchor, Grid, Pose, Scale, Scene, Symbol};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;

const EXAMPLES: &str = "\
Examples:
  planform inspect map.yaml
  planform inspect scan.png --resolution 0.05
  planform inspect map.yaml --json";

/// Tell what a document is and what it shows, without reconstructing anything
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct InspectArgs {
    #[command(flatten)]
    input: InputArgs,
    /// Print as JSON
    #[arg(long)]
    json: bool,
    /// Show what plugins from outside print
    #[arg(short, long)]
    verbose: bool,
    #[command(flatten)]
    caps: CapArgs,
    #[command(flatten)]
    outside: OutsideArgs,
}

pub fn run(args: &InspectArgs) -> Result<(), Failure> {
    let registry = args.outside.registry(args.verbose)?;
    let mut opened = Opened::open(&args.input, args.caps.caps(), &registry, &[])?;
    let options = opened.options(&args.input.reading.settings(), &[])?;
    tell_refusals(&registry, Voice::Normal);
    let scene = opened.read(&options[0], &mut ());
    tell_messages(Voice::Normal);
    let scene = scene?;
    let report = Report::of(&opened.shown(), opened.claims(&registry), &scene);
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
    /// How many there are of each kind.
    symbols: BTreeMap<String, usize>,
    scale: Option<Scale>,
    anchor: Option<GeoAnchor>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct ClaimReport {
    adapter: String,
    /// How sure its probe is.
    percent: u8,
    reason: String,
    /// How sure it is after a closer look, if it took one.
    look: Option<Confidence>,
}

/// How much of the grid is what, each 0 to 1, as the reconstruction judges by default.
#[derive(Serialize, Debug, PartialEq)]
struct Shares {
    free: f64,
    obstacle: f64,
    between: f64,
    unknown: f64,
}

impl Shares {
    fn of(grid: &Grid) -> Self {
        let limits = Contour::default();
        let mut counts = [0usize; 4];
        for cell in grid.cells() {
            let kind = match cell.occupancy() {
                Some(o) if o >= limits.obstacle => 1,
                Some(o) if o <= limits.free => 0,
                Some(_) => 2,
                None => 3,
            };
            counts[kind] += 1;
        }
        let [free, obstacle, between, unknown] = counts.map(|n| n as f64 / grid.cells().len() as f64);
        Self { free, obstacle, between, unknown }
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
            symbols: kinds(&scene.symbols),
            scale: scene.scale.clone(),
            anchor: scene.anchor,
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
        let _ = writeln!(t, "  resolution  {} m per cell", rounded(self.resolution));
        let _ = writeln!(
            t,
            "  origin      x {} m, y {} m, yaw {} rad",
            rounded(origin.x),
            rounded(origin.y),
            rounded(origin.yaw)
        );
        let _ = writeln!(t, "  cells, as the reconstruction judges them by default:");
        let limits = Contour::default();
        for (name, share, meaning) in [
            ("free", shares.free, format!("occupancy of at most {} %", limits.free)),
            ("obstacle", shares.obstacle, format!("occupancy of at least {} %", limits.obstacle)),
            ("between", shares.between, String::from("seen, but neither")),
            ("unknown", shares.unknown, String::from("not seen")),
        ] {
            let _ = writeln!(t, "  {name:<10}{:>6.1} %  ({meaning})", share * 100.0);
        }
        if self.texts > 0 {
            let _ = writeln!(t, "  texts       {}", self.texts);
        }
        if !self.symbols.is_empty() {
            let kinds: Vec<_> = self.symbols.iter().map(|(kind, n)| format!("{n} {}", safe(kind))).collect();
            let _ = writeln!(t, "  symbols     {}", kinds.join(", "));
        }
        if let Some(scale) = &self.scale {
            let (length, percent) = (rounded(scale.metres_per_pixel), scale.confidence * 100.0);
            let told = scale.told();
            let _ = writeln!(t, "  scale       {length} m per pixel {}, {percent:.0} % sure", safe(&told));
        }
        if let Some(GeoAnchor { latitude, longitude, bearing, at }) = self.anchor {
            let _ = writeln!(
                t,
                "  anchor      latitude {latitude}, longitude {longitude} at x {} m, y {} m; the y axis points to {bearing} degrees",
                rounded(at.x),
                rounded(at.y)
            );
        }
        for warning in &self.warnings {
            let _ = writeln!(t, "  warning     {warning}");
        }
        t
    }
}

/// How many symbols there are of each kind.
fn kinds(symbols: &[Symbol]) -> BTreeMap<String, usize> {
    let mut kinds = BTreeMap::new();
    symbols.iter().for_each(|s| *kinds.entry(s.kind.clone()).or_default() += 1);
    kinds
}

/// The number with at most six digits after the point. A resolution finer than that stays as it is.
fn rounded(v: f64) -> f64 {
    let rounded = (v * 1e6).round() / 1e6;
    if rounded == 0.0 || !rounded.is_finite() { v } else { rounded }
}

impl ClaimReport {
    fn of(claim: &Claim<'_>) -> Self {
        Self {
            adapter: claim.adapter.info().name.clone(),
            percent: claim.probe.percent,
            reason: claim.probe.reason.clone(),
            look: claim.look.clone(),
        }
    }

    fn text(&self) -> String {
        let sure = |percent: u8, reason: &str| {
            let reason = if reason.is_empty() { "not its kind of document" } else { reason };
            format!("{percent} % sure: {reason}")
        };
        let probe = format!("{} is {}", self.adapter, sure(self.percent, &self.reason));
        let look =
            self.look.as_ref().map(|l| format!("; after a closer look {}", sure(l.percent, &l.reason)));
        probe + &look.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Cell;

    #[test]
    fn numbers_are_rounded() {
        assert_eq!([6.299999999999997, -12.5, 0.0].map(rounded), [6.3, -12.5, 0.0]);
        assert_eq!((rounded(1e-9), rounded(1e307)), (1e-9, 1e307));
    }

    #[test]
    fn shares_add_up_at_the_thresholds() {
        let Contour { free, obstacle, .. } = Contour::default();
        let cells = [free, free + 1, obstacle - 1, obstacle].map(Cell::percent).to_vec();
        let grid = Grid::new(4, 1, 0.05, Pose::default(), cells).unwrap();
        assert_eq!(Shares::of(&grid), Shares { free: 0.25, obstacle: 0.25, between: 0.5, unknown: 0.0 });
    }
}
