//! All maps of a manifest.

use super::error::{EvaluateError, Over, bad, bad_json};
use super::labels::LabelMode;
use super::measures::{Clip, Measures, mean};
use super::pair::{Scores, Settings, evaluate};
use planform_sdk::{PluginError, Pose, Source};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What was found for the maps of a manifest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetScores {
    /// Each map with a truth, in the order of the manifest. In JSON an object by name.
    #[serde(serialize_with = "by_name")]
    pub maps: Vec<(String, Scores)>,
    /// The maps that have no truth.
    pub skipped: Vec<String>,
    /// Over all maps with a truth.
    pub summary: Summary,
}

/// Mean and spread over maps, with both ways of clipping.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// With [`Clip::Known`].
    pub clipped: Spread,
    /// With [`Clip::None`].
    pub raw: Spread,
}

/// Mean and spread of each measure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spread {
    /// The mean.
    pub mean: Measures<f64>,
    /// The standard deviation of the population.
    pub std: Measures<f64>,
}

/// Compares the layouts in the folder `predictions` with the truths of a manifest.
///
/// A manifest is `{"maps": [{"name": ..., "gt": ..., "gt_mode": ..., "resolution": ..., "origin": [x, y], "min_px":
/// ...}]}`, of which `name` is needed; `gt` is a label image, relative to the manifest. Maps without `gt` are skipped.
/// What `settings` leave open comes from the manifest. The prediction of a map is the first that exists of
/// `NAME.geojson`, `NAME.json`, `NAME.png`, `NAME/layout.geojson`, `NAME/layout.json`; a missing one scores 0.
pub fn evaluate_set(
    manifest: &Path,
    predictions: &Path,
    settings: &Settings,
) -> Result<SetScores, EvaluateError> {
    let maps = read(manifest).over(manifest)?;
    let (with_truth, without): (Vec<_>, Vec<_>) = maps.into_iter().partition(|map| map.gt.is_some());
    if with_truth.is_empty() {
        return Err(bad("has no map with a truth").advise("give a map a `gt`")).over(manifest);
    }
    let folder = manifest.parent().unwrap_or(Path::new(""));
    let score = |map: Map| {
        let settings = map.fill_in(settings).over(manifest)?;
        let truth = folder.join(map.gt.unwrap_or_default());
        let scores = evaluate(find(predictions, &map.name).as_deref(), &truth, &settings)?;
        Ok((map.name, scores))
    };
    let maps = with_truth.into_iter().map(score).collect::<Result<Vec<_>, _>>()?;
    let skipped = without.into_iter().map(|map| map.name).collect();
    Ok(SetScores { summary: summary(&maps), maps, skipped })
}

#[derive(Deserialize)]
struct Manifest {
    maps: Vec<Map>,
}

#[derive(Deserialize)]
struct Map {
    name: String,
    gt: Option<PathBuf>,
    gt_mode: Option<LabelMode>,
    resolution: Option<f64>,
    /// x, y and perhaps yaw.
    origin: Option<Vec<f64>>,
    min_px: Option<u64>,
}

/// The most bytes of a manifest.
const MANIFEST_BYTES: u64 = 1 << 24;

fn read(file: &Path) -> Result<Vec<Map>, PluginError> {
    let source = Source::open(file, MANIFEST_BYTES)?;
    let manifest: Manifest = serde_json::from_slice(&source.bytes).map_err(bad_json)?;
    let mut names = BTreeSet::new();
    match manifest.maps.iter().find(|map| !names.insert(&map.name)) {
        Some(map) => Err(bad(format!("has two maps named `{}`", map.name))),
        None => Ok(manifest.maps),
    }
}

impl Map {
    /// The settings with what they leave open.
    fn fill_in(&self, settings: &Settings) -> Result<Settings, PluginError> {
        let filled = Settings {
            resolution: settings.resolution.or(self.resolution),
            origin: settings.origin.or(self.origin()?),
            truth_mode: settings.truth_mode.or(self.gt_mode),
            min_px: settings.min_px.or(self.min_px),
            ..settings.clone()
        };
        let wrong = |e: PluginError| bad(format!("map `{}`: {}", self.name, e.message));
        filled.frame().check().map_err(wrong)?;
        Ok(filled)
    }

    fn origin(&self) -> Result<Option<Pose>, PluginError> {
        match self.origin.as_deref() {
            None => Ok(None),
            Some([x, y]) => Ok(Some(Pose { x: *x, y: *y, yaw: 0.0 })),
            Some([x, y, yaw]) => Ok(Some(Pose { x: *x, y: *y, yaw: *yaw })),
            Some(_) => Err(bad(format!("the origin of map `{}` is not two or three numbers", self.name))),
        }
    }
}

fn find(folder: &Path, name: &str) -> Option<PathBuf> {
    ["{}.geojson", "{}.json", "{}.png", "{}/layout.geojson", "{}/layout.json"]
        .map(|pattern| folder.join(pattern.replace("{}", name)))
        .into_iter()
        .find(|file| file.is_file())
}

fn summary(maps: &[(String, Scores)]) -> Summary {
    let spread = |clip| Spread::of(maps.iter().map(|(_, scores)| scores.get(clip).measures).collect());
    Summary { clipped: spread(Clip::Known), raw: spread(Clip::None) }
}

impl Spread {
    fn of(measures: Vec<Measures>) -> Self {
        let values: Vec<_> = measures.into_iter().map(|m| m.values()).collect();
        let column = |i: usize| values.iter().map(move |row| row[i]);
        let means = std::array::from_fn(|i| mean(column(i)));
        let std = std::array::from_fn(|i| mean(column(i).map(|v| (v - means[i]).powi(2))).sqrt());
        Self { mean: Measures::from_values(means), std: Measures::from_values(std) }
    }
}

fn by_name<S: Serializer>(maps: &[(String, Scores)], serializer: S) -> Result<S::Ok, S::Error> {
    let mut object = serializer.serialize_map(Some(maps.len()))?;
    for (name, scores) in maps {
        object.serialize_entry(name, scores)?;
    }
    object.end()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_is_of_the_population() {
        let with = |a_fc, n_pred| Measures { a_fc, n_pred, ..Measures::default() };
        let spread = Spread::of(vec![with(0.0, 2), with(1.0, 4)]);
        assert_eq!((spread.mean.a_fc, spread.std.a_fc), (0.5, 0.5));
        assert_eq!((spread.mean.n_pred, spread.std.n_pred), (3.0, 1.0));
    }

    #[test]
    fn what_the_user_says_comes_before_the_manifest() {
        let text =
            r#"{"name": "a", "resolution": 0.1, "origin": [1, 2, 0], "gt_mode": "white", "min_px": 7}"#;
        let map: Map = serde_json::from_str(text).unwrap();
        let settings = map.fill_in(&Settings { resolution: Some(0.2), ..Settings::default() }).unwrap();
        assert_eq!((settings.resolution, settings.min_px), (Some(0.2), Some(7)));
        assert_eq!(settings.origin, Some(Pose { x: 1.0, y: 2.0, yaw: 0.0 }));
        assert_eq!(settings.truth_mode, Some(LabelMode::White));
    }

    #[test]
    fn useless_numbers_are_refused() {
        for wrong in [r#""resolution": 0"#, r#""origin": [1]"#] {
            let map: Map = serde_json::from_str(&format!(r#"{{"name": "a", {wrong}}}"#)).unwrap();
            assert!(map.fill_in(&Settings::default()).unwrap_err().to_string().contains("map `a`"));
        }
    }
}
