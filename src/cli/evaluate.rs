//! `planform evaluate`.

use super::Failure;
use super::failure::{print, say};
use super::output::{check_file, write_file};
use crate::evaluate::report::{json, pair_table, set_table};
use crate::evaluate::{
    Clip, EvaluateError, LabelMode, Scores, SetScores, Settings, Units, evaluate, evaluate_set,
};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use planform_sdk::Pose;
use serde::Serialize;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  planform convert map.yaml -o rooms.geojson --set boundary=centre
  planform evaluate rooms.geojson --truth truth.png --resolution 0.05
  planform evaluate rooms.geojson --truth truth.png --resolution 0.05 --origin -12.5,3.1
  planform evaluate rooms.geojson --truth truth.geojson
  planform evaluate --manifest maps/manifest.json --predictions rooms/ --json scores.json

Files named *.geojson or *.json are layouts, all others are label images. The table shows percent; m2 is the area that
was counted. A_FC and Prec are low when rooms are merged, A_BC and Rec when they are split or missed; mIoU is the mean
intersection over union; M50 counts matches of at least one half; phant counts rooms where the truth shows none; spill
is the share of the predicted area in no true room.";

/// Measure how well the rooms found agree with the true ones
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct EvaluateArgs {
    /// The rooms found: a GeoJSON layout or a label image
    #[arg(value_name = "PREDICTION", required_unless_present = "manifest", requires = "truth")]
    prediction: Option<PathBuf>,
    /// The true rooms: a label image or a GeoJSON layout
    #[arg(long, value_name = "TRUTH", requires = "prediction")]
    truth: Option<PathBuf>,
    /// Evaluate all maps of this manifest that have a truth
    #[arg(long, value_name = "FILE", requires = "predictions", conflicts_with_all = ["prediction", "truth"])]
    manifest: Option<PathBuf>,
    /// The folder of the manifest's predictions, NAME.geojson; a missing one scores 0
    #[arg(long, value_name = "DIR", requires = "manifest")]
    predictions: Option<PathBuf>,
    /// Metres per pixel of the map [default: the manifest's, else 0.05]
    #[arg(long, value_name = "M", value_parser = positive)]
    resolution: Option<f64>,
    /// Where the outer corner of the map's lower left pixel lies, metres, and how the map is turned, radians
    /// [default: the manifest's, else 0,0]
    #[arg(long, value_name = "X,Y[,YAW]", value_parser = pose, allow_hyphen_values = true)]
    origin: Option<Pose>,
    /// What a predicted layout is in: metres, y up, or pixels, y down
    #[arg(long, default_value = "m", value_parser = choice(UNITS))]
    units: Units,
    /// What a truth layout is in
    #[arg(long, default_value = "m", value_parser = choice(UNITS))]
    truth_units: Units,
    /// Rows of the map's image; needed when only one of two layouts is in pixels
    #[arg(long, value_name = "PX")]
    map_height: Option<u32>,
    /// How a truth image shows rooms: as white areas, as colours without black and white, or as colours without black
    /// [default: the manifest's, else auto]
    #[arg(long, value_parser = choice(MODES))]
    gt_mode: Option<LabelMode>,
    /// How a predicted label image shows rooms
    #[arg(long, default_value = "auto", value_parser = choice(MODES))]
    prediction_mode: LabelMode,
    /// Rooms of at most this many pixels do not count [default: the manifest's, else 100]
    #[arg(long, value_name = "N")]
    min_px: Option<u64>,
    /// Ignore predicted area that lies in no true room (known), or count it (none); the JSON has both
    #[arg(long, default_value = "known", value_parser = choice(CLIPS))]
    clip: Clip,
    /// Write everything as JSON to this file; `-` writes it to standard output in place of the table
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Overwrite the JSON file if it is there already
    #[arg(long, requires = "json")]
    force: bool,
}

const UNITS: &[(&str, Units)] = &[("m", Units::Metres), ("px", Units::Pixels)];
const CLIPS: &[(&str, Clip)] = &[("known", Clip::Known), ("none", Clip::None)];
const MODES: &[(&str, LabelMode)] = &[
    ("auto", LabelMode::Auto),
    ("white", LabelMode::White),
    ("labels", LabelMode::Labels),
    ("ids", LabelMode::Ids),
];

/// Reads one of these words.
fn choice<T: Copy + Send + Sync + 'static>(
    words: &'static [(&'static str, T)],
) -> impl TypedValueParser<Value = T> {
    let value = |word: String| words.iter().find(|(w, _)| *w == word).map(|(_, value)| *value);
    PossibleValuesParser::new(words.iter().map(|(word, _)| *word))
        .try_map(move |word| value(word).ok_or("not one of the words"))
}

fn positive(text: &str) -> Result<f64, &'static str> {
    text.parse().ok().filter(|v: &f64| v.is_finite() && *v > 0.0).ok_or("give a number above 0")
}

fn pose(text: &str) -> Result<Pose, &'static str> {
    let numbers: Vec<f64> = text.split(',').filter_map(|v| v.trim().parse().ok()).collect();
    let finite = numbers.iter().all(|v| v.is_finite()) && numbers.len() == text.split(',').count();
    match numbers.as_slice() {
        [x, y] if finite => Ok(Pose { x: *x, y: *y, yaw: 0.0 }),
        [x, y, yaw] if finite => Ok(Pose { x: *x, y: *y, yaw: *yaw }),
        _ => Err("give two or three numbers with commas between"),
    }
}

pub fn run(args: &EvaluateArgs) -> Result<(), Failure> {
    let settings = args.settings();
    if let Some(file) = args.json.as_deref().filter(|f| *f != Path::new("-")) {
        check_file(file, args.force)?;
    }
    match (&args.prediction, &args.truth, &args.manifest, &args.predictions) {
        (Some(prediction), Some(truth), ..) => args.run_pair(prediction, truth, &settings),
        (.., Some(manifest), Some(predictions)) => args.run_set(manifest, predictions, &settings),
        _ => Err(Failure::Usage("give a prediction and --truth, or --manifest and --predictions".into())),
    }
}

impl EvaluateArgs {
    fn settings(&self) -> Settings {
        Settings {
            units: self.units,
            resolution: self.resolution,
            origin: self.origin,
            truth_mode: self.gt_mode,
            prediction_mode: Some(self.prediction_mode),
            min_px: self.min_px,
            truth_units: self.truth_units,
            map_height: self.map_height,
        }
    }

    fn run_pair(&self, prediction: &Path, truth: &Path, settings: &Settings) -> Result<(), Failure> {
        let scores = evaluate(Some(prediction), truth, settings).map_err(failure)?;
        warn(&truth.display().to_string(), &prediction.display().to_string(), &scores);
        let name = prediction.file_stem().unwrap_or_default().to_string_lossy();
        self.output(&scores, || pair_table(&name, &scores, self.clip))
    }

    fn run_set(&self, manifest: &Path, predictions: &Path, settings: &Settings) -> Result<(), Failure> {
        if !predictions.is_dir() {
            return Err(Failure::over(predictions, "is not a folder"));
        }
        let scores: SetScores = evaluate_set(manifest, predictions, settings).map_err(failure)?;
        for (name, scores) in &scores.maps {
            warn(&format!("the truth of {name}"), &format!("the prediction of {name}"), scores);
        }
        self.output(&scores, || set_table(&scores, self.clip))
    }

    fn output(&self, scores: &impl Serialize, table: impl FnOnce() -> String) -> Result<(), Failure> {
        let Some(file) = &self.json else { return print(table().as_bytes()) };
        let text = json(scores).map_err(|e| Failure::over(file, e))?;
        if file == Path::new("-") {
            return print(text.as_bytes());
        }
        write_file(file, text.as_bytes(), self.force)?;
        print(table().as_bytes())
    }
}

fn failure(e: EvaluateError) -> Failure {
    Failure::of_plugin(e.file, e.error)
}

const SAME_FRAME: &str = "are prediction and truth of the same map and frame?";

/// Warns of scores that tell more of how the files were read than of the rooms.
fn warn(truth: &str, prediction: &str, scores: &Scores) {
    let m = &scores.raw.measures;
    if m.n_gt == 0 {
        say(&format!("warning: {truth} shows no room; check --gt-mode and --min-px"));
    }
    if scores.prediction.is_none() {
        say(&format!("warning: {prediction} is missing, which scores 0"));
    } else if m.n_pred == 0 {
        say(&format!("warning: {prediction} shows no room there; {SAME_FRAME}"));
    } else if m.n_gt > 0 && m.spill > 0.5 {
        say(&format!("warning: {:.0} % of {prediction} lies in no true room; {SAME_FRAME}", m.spill * 100.0));
    }
}
