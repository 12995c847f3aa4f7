//! Maps with a truth: synthetic ones, and sets of real ones with a manifest.

use planform::evaluate::{LabelImage, LabelMode, MIN_PX};
use planform_sdk::{Grid, InputAdapter, Options, Source};
use serde_json::Value;
use std::path::Path;

/// A map and its true rooms.
pub struct Map {
    /// The set that it belongs to.
    pub set: String,
    /// Its name in the set.
    pub name: String,
    /// The building that it shows: maps of one building are never on both sides of a split.
    pub building: String,
    /// The map.
    pub grid: Grid,
    /// The room of each pixel, row by row from the top.
    pub truth: LabelImage,
    /// Rooms of at most this many pixels do not count.
    pub min_px: u64,
}

impl Map {
    /// The true room of each cell, row by row from the bottom as in the grid; 0 is none.
    pub fn truth_on_grid(&self) -> Vec<u32> {
        self.truth.labels.chunks(self.truth.width).rev().flatten().copied().collect()
    }
}

/// The maps of a manifest that have a truth; `key` names the map in it: `map`, `map_furnished`.
pub fn of_manifest(folder: &Path, key: &str) -> Result<Vec<Map>, String> {
    let text = std::fs::read_to_string(folder.join("manifest.json"))
        .map_err(|e| format!("{}: {e}", folder.display()))?;
    let manifest: Value = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let set = folder.file_name().unwrap_or_default().to_string_lossy();
    let set = if key == "map" { set.into_owned() } else { format!("{set} {key}") };
    let entries = manifest["maps"].as_array().cloned().unwrap_or_default();
    let wanted = entries.iter().filter(|e| e["gt"].is_string() && e[key].is_string());
    wanted.map(|e| of_entry(folder, &set, key, e)).collect()
}

fn of_entry(folder: &Path, set: &str, key: &str, entry: &Value) -> Result<Map, String> {
    let name = entry["name"].as_str().unwrap_or_default().to_string();
    let wrong = |e: String| format!("{set}, {name}: {e}");
    let file = |key: &str| folder.join(entry[key].as_str().unwrap_or_default());
    let min_px = entry["min_px"].as_u64().unwrap_or(MIN_PX);
    let bytes = std::fs::read(file("gt")).map_err(|e| wrong(e.to_string()))?;
    let mode = match entry["gt_mode"].as_str() {
        Some("white") => LabelMode::White,
        Some("labels") => LabelMode::Labels,
        Some("ids") => LabelMode::Ids,
        _ => LabelMode::Auto,
    };
    let truth = LabelImage::decode(&bytes, mode, min_px).map_err(|e| wrong(e.to_string()))?;
    let resolution = entry["resolution"].as_f64().unwrap_or(0.05).to_string();
    let adapter: Box<dyn InputAdapter> = planform_slam_grid::adapter();
    let options = Options::parse(&adapter.info().options, [("resolution", resolution.as_str())])
        .map_err(|e| wrong(e.to_string()))?;
    let source = Source::open(file(key), Source::BYTE_LIMIT).map_err(|e| wrong(e.to_string()))?;
    let scene = adapter.read(&source, &options).map_err(|e| wrong(e.to_string()))?;
    Ok(Map { set: set.into(), building: name.clone(), name, grid: scene.grid, truth, min_px })
}

/// The synthetic map of a seed, drawn as irregular as real ones.
pub fn synthetic(seed: u64) -> Result<Map, String> {
    let sample = planform_synth::Sample::draw(seed).map_err(|e| format!("seed {seed}: {e}"))?;
    let (width, height) = (sample.labels.width as usize, sample.labels.height as usize);
    let rows = sample.labels.rooms.chunks(width).rev();
    let labels: Vec<u32> = rows.flatten().copied().collect();
    let count = labels.iter().max().copied().unwrap_or(0);
    let names = (1..=count).map(|n| n.to_string()).collect();
    Ok(Map {
        set: "synthetic".into(),
        name: format!("{seed}"),
        building: format!("synthetic {seed}"),
        grid: sample.grid,
        truth: LabelImage { width, height, labels, names },
        min_px: MIN_PX,
    })
}
