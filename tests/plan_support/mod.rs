//! How well the adapter `blueprint` and the reconstruction read a drawn plan whose truth is known.
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod ink;
mod rooms;
mod symbols;
mod words;

pub use rooms::Rooms;
pub use symbols::Kinds;

use planform::reconstruct::{Params, reconstruct};
use planform_blueprint::options::Request;
use planform_blueprint::page::Page;
use planform_blueprint::pipeline::{self, Reading};
use planform_blueprint::scene::{self, PageFrame};
use planform_blueprint::stages::Unwatched;
use planform_sdk::{Layout, Options, Point, Scene};
use planform_synth::{Plan, PlanStyle};
use std::fmt;

/// So many of so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Count {
    pub right: usize,
    pub all: usize,
}

impl Count {
    /// The share that is right; 1 of nothing.
    pub fn share(self) -> f64 {
        if self.all == 0 { 1.0 } else { self.right as f64 / self.all as f64 }
    }
}

/// What one plan gave.
#[derive(Debug, Clone, Default)]
pub struct PlanScore {
    pub name: String,
    /// Why it was not read, if it was not: then every share is 0.
    pub failure: Option<String>,
    /// Of the pixels of letters, those that were taken off.
    pub removed: f64,
    /// Of the pixels of walls, those that were taken off with the words.
    pub lost: f64,
    pub words: Count,
    pub symbols: Kinds,
    pub rooms: Rooms,
    /// Found metres per pixel over the true ones, less 1, without its sign.
    pub scale_error: f64,
    /// What the scale was found by.
    pub scale_source: String,
}

/// Draws the plan of this seed and reads it as the program would.
pub fn score(style: PlanStyle, seed: u64) -> PlanScore {
    let plan = Plan::draw(seed, style).unwrap();
    let kind = if style == PlanStyle::Blueprint { "blueprint" } else { "evacuation" };
    let name = format!("{kind} {seed}");
    match read(&plan) {
        Ok(found) => PlanScore { name, ..found.compare(&plan) },
        Err(e) => {
            let all = nothing_found(&plan);
            PlanScore { name, failure: Some(e), lost: 1.0, scale_error: 1.0, ..all }
        }
    }
}

/// The counts of a plan of which nothing was found.
fn nothing_found(plan: &Plan) -> PlanScore {
    let nothing = Layout::default();
    PlanScore {
        words: words::read_right(&[], &plan.truth, 1.0),
        symbols: Kinds::compare(&[], &plan.truth, 1.0),
        rooms: Rooms::compare(&nothing, &plan.truth, 1.0),
        ..PlanScore::default()
    }
}

/// What was found of a plan.
struct Found {
    reading: Reading,
    scene: Scene,
    layout: Layout,
}

fn read(plan: &Plan) -> Result<Found, String> {
    let page = Page {
        picture: plan.picture.clone(),
        dpi: plan.dpi,
        metres_per_pixel: None,
        origin: [0.0; 2],
        texts: Vec::new(),
        drawn: true,
        symbols: Vec::new(),
        walls_only: false,
        warnings: Vec::new(),
    };
    let options = Options::parse(&planform_blueprint::adapter().info().options, []).unwrap();
    let request = Request::of(&options).unwrap();
    let frame = PageFrame { height: f64::from(plan.picture.height()), origin: [0.0; 2] };
    let reading = pipeline::read(&page, &request, &mut Unwatched).map_err(|e| e.to_string())?;
    let scene = scene::scene(&reading, frame, "plan.png".into()).map_err(|e| e.to_string())?;
    let layout = reconstruct(&scene, &Params::default(), &mut ()).map_err(|e| e.to_string())?;
    Ok(Found { reading, scene, layout })
}

impl Found {
    fn compare(&self, plan: &Plan) -> PlanScore {
        let found = self.reading.scale.metres_per_pixel;
        // Found metres times this are true ones, so that a wrong scale counts once.
        let factor = plan.truth.metres_per_pixel / found;
        let (removed, lost) = ink::removed_and_lost(&self.reading, &plan.truth);
        PlanScore {
            removed,
            lost,
            words: words::read_right(&self.scene.texts, &plan.truth, factor),
            symbols: Kinds::compare(&self.scene.symbols, &plan.truth, factor),
            rooms: Rooms::compare(&self.layout, &plan.truth, factor),
            scale_error: (1.0 / factor - 1.0).abs(),
            scale_source: self.reading.scale.source.clone(),
            ..PlanScore::default()
        }
    }
}

/// The point with both coordinates times the factor.
fn scaled(x: f64, y: f64, factor: f64) -> Point {
    Point::new(x * factor, y * factor)
}

/// The mean of a measure.
pub fn mean(scores: &[PlanScore], of: impl Fn(&PlanScore) -> f64) -> f64 {
    scores.iter().map(of).sum::<f64>() / scores.len() as f64
}

/// The table's first line.
pub const HEAD: &str =
    "plan           removed   lost  words  sym-P  sym-R  hinges  names   A_FC   A_BC  scale-err by";

impl fmt::Display for PlanScore {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbols = self.symbols.total();
        write!(
            f,
            "{:14} {:7.3} {:6.4} {:6.3} {:6.3} {:6.3} {:7.3} {:6.3} {:6.3} {:6.3} {:10.4} {}",
            self.name,
            self.removed,
            self.lost,
            self.words.share(),
            symbols.precision(),
            symbols.recall(),
            self.symbols.swings.share(),
            self.rooms.names.share(),
            self.rooms.a_fc,
            self.rooms.a_bc,
            self.scale_error,
            self.failure.as_ref().unwrap_or(&self.scale_source)
        )
    }
}

/// Prints a line for each plan, the means, and the symbols by kind.
pub fn print(scores: &[PlanScore]) {
    println!("{HEAD}");
    scores.iter().for_each(|s| println!("{s}"));
    println!(
        "mean           {:7.3} {:6.4} {:6.3} {:6.3} {:6.3} {:7.3} {:6.3} {:6.3} {:6.3} {:10.4}",
        mean(scores, |s| s.removed),
        mean(scores, |s| s.lost),
        mean(scores, |s| s.words.share()),
        mean(scores, |s| s.symbols.total().precision()),
        mean(scores, |s| s.symbols.total().recall()),
        mean(scores, |s| s.symbols.swings.share()),
        mean(scores, |s| s.rooms.names.share()),
        mean(scores, |s| s.rooms.a_fc),
        mean(scores, |s| s.rooms.a_bc),
        mean(scores, |s| s.scale_error),
    );
    println!("{:22} {:>5} {:>5} {:>5} {:>6} {:>6}", "kind", "right", "found", "true", "P", "R");
    for (kind, tally) in Kinds::sum(scores.iter().map(|s| &s.symbols)) {
        let (precision, recall) = (tally.precision(), tally.recall());
        println!(
            "{kind:22} {:5} {:5} {:5} {precision:6.3} {recall:6.3}",
            tally.right, tally.found, tally.all
        );
    }
}
