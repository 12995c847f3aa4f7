//! One prediction and its truth.

use super::MIN_PX;
use super::error::{EvaluateError, Over, bad};
use super::frame::{Frame, Units};
use super::labels::{LabelImage, LabelMode};
use super::measures::{Clip, Score, measure};
use super::overlap::Overlap;
use super::rooms::{RoomShape, read_rooms};
use super::truth::{Drawing, draw};
use planform_sdk::{PluginError, Pose, Source};
use serde::Serialize;
use std::path::Path;

/// How to read a prediction and its truth. What is `None` comes from the manifest, if there is one, and has a default.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    /// What the coordinates of a predicted layout are in.
    pub units: Units,
    /// Metres per pixel; 0.05 by default.
    pub resolution: Option<f64>,
    /// Where the lower left corner of the map's image lies, metres and radians; (0, 0) by default.
    pub origin: Option<Pose>,
    /// How a truth image shows its rooms; `Auto` by default.
    pub truth_mode: Option<LabelMode>,
    /// How a predicted label image shows its rooms; `Auto` by default.
    pub prediction_mode: Option<LabelMode>,
    /// Rooms of at most this many pixels do not count; [`MIN_PX`] by default.
    pub min_px: Option<u64>,
    /// What the coordinates of a truth layout are in.
    pub truth_units: Units,
    /// Rows of the map's image: needed where a truth layout is in pixels and the prediction in metres, or the reverse.
    pub map_height: Option<u32>,
}

impl Settings {
    /// The frame of a predicted layout.
    pub fn frame(&self) -> Frame {
        let default = Frame::default();
        Frame {
            units: self.units,
            resolution: self.resolution.unwrap_or(default.resolution),
            origin: self.origin.unwrap_or(default.origin),
        }
    }

    /// The frame of a truth layout.
    pub fn truth_frame(&self) -> Frame {
        Frame { units: self.truth_units, ..self.frame() }
    }

    /// Rooms of at most this many pixels do not count.
    pub fn min_px(&self) -> u64 {
        self.min_px.unwrap_or(MIN_PX)
    }
}

/// What a comparison found, with both ways of clipping.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Scores {
    /// With [`Clip::Known`].
    pub clipped: Score,
    /// With [`Clip::None`].
    pub raw: Score,
    /// The file name of the prediction; none if it is missing.
    pub prediction: Option<String>,
    /// Metres per pixel of those that were counted.
    pub resolution: f64,
}

impl Scores {
    /// The score with this way of clipping.
    pub fn get(&self, clip: Clip) -> &Score {
        match clip {
            Clip::Known => &self.clipped,
            Clip::None => &self.raw,
        }
    }

    fn new(overlap: &Overlap, min_px: f64, resolution: f64) -> Self {
        Self {
            clipped: measure(overlap, Clip::Known, min_px),
            raw: measure(overlap, Clip::None, min_px),
            prediction: None,
            resolution,
        }
    }
}

/// Compares a prediction with its truth.
///
/// Either is a GeoJSON layout if its name ends in `.geojson` or `.json`, else a label image. A predicted label image
/// needs a truth image of its size. No prediction scores 0, and then the truth must be an image.
pub fn evaluate(
    prediction: Option<&Path>,
    truth: &Path,
    settings: &Settings,
) -> Result<Scores, EvaluateError> {
    settings.frame().check().over(truth)?;
    let scores = match prediction {
        Some(prediction) if is_layout(truth) => compare_layouts(prediction, truth, settings)?,
        _ if is_layout(truth) => return Err(bad("is no label image")).over(truth),
        _ => compare_with_image(prediction, truth, settings)?,
    };
    let name = prediction.and_then(Path::file_name).map(|n| n.to_string_lossy().into_owned());
    Ok(Scores { prediction: name, ..scores })
}

fn compare_layouts(prediction: &Path, truth: &Path, settings: &Settings) -> Result<Scores, EvaluateError> {
    if !is_layout(prediction) {
        let e = bad("is not named *.geojson or *.json, and its truth is")
            .advise("compare a GeoJSON layout with this truth, or a picture with a picture");
        return Err(e).over(prediction);
    }
    let (true_rooms, rooms) = (read_layout(truth)?, read_layout(prediction)?);
    let predicted = in_pixels(rooms, &settings.frame(), height(settings).over(truth)?).over(prediction)?;
    let wanted = in_pixels(true_rooms, &settings.truth_frame(), height(settings).over(truth)?).over(truth)?;
    scores(&draw(&wanted, &predicted, settings).over(truth)?).over(prediction)
}

/// Compares rooms with the true ones, both in metres: what [`evaluate`] does with two GeoJSON layouts.
pub fn evaluate_rooms(
    prediction: Vec<RoomShape>,
    truth: Vec<RoomShape>,
    settings: &Settings,
) -> Result<Scores, PluginError> {
    let frame = Frame { units: Units::Metres, ..settings.frame() };
    frame.check()?;
    let (predicted, wanted) = (in_pixels(prediction, &frame, 0.0)?, in_pixels(truth, &frame, 0.0)?);
    scores(&draw(&wanted, &predicted, settings)?)
}

fn scores(drawing: &Drawing) -> Result<Scores, PluginError> {
    let overlap = Overlap::of_rooms(&drawing.predicted, &drawing.truth)?;
    Ok(Scores::new(&overlap, drawing.min_px, drawing.resolution))
}

fn compare_with_image(
    prediction: Option<&Path>,
    truth: &Path,
    settings: &Settings,
) -> Result<Scores, EvaluateError> {
    let min_px = settings.min_px();
    let wanted = read_image(truth, settings.truth_mode.unwrap_or_default(), min_px)?;
    let overlap = match prediction {
        None => Overlap::of_nothing(&wanted),
        Some(file) if is_layout(file) => {
            let rooms = in_pixels(read_layout(file)?, &settings.frame(), wanted.height as f64).over(file)?;
            Overlap::of_rooms(&rooms, &wanted).over(file)?
        }
        Some(file) => {
            let rooms = read_image(file, settings.prediction_mode.unwrap_or_default(), min_px)?;
            Overlap::of_images(&rooms, &wanted).over(file)?
        }
    };
    Ok(Scores::new(&overlap, min_px as f64, settings.frame().resolution))
}

/// The most bytes of a layout: a million corners take 40 MB.
const LAYOUT_BYTES: u64 = 1 << 27;

fn is_layout(file: &Path) -> bool {
    file.extension().is_some_and(|e| e.eq_ignore_ascii_case("geojson") || e.eq_ignore_ascii_case("json"))
}

fn read_layout(file: &Path) -> Result<Vec<RoomShape>, EvaluateError> {
    Source::open(file, LAYOUT_BYTES).and_then(|source| read_rooms(&source.bytes)).over(file)
}

fn read_image(file: &Path, mode: LabelMode, min_px: u64) -> Result<LabelImage, EvaluateError> {
    let source = Source::open(file, Source::BYTE_LIMIT).over(file)?;
    LabelImage::decode(&source.bytes, mode, min_px).over(file)
}

fn in_pixels(rooms: Vec<RoomShape>, frame: &Frame, height: f64) -> Result<Vec<RoomShape>, PluginError> {
    let room = |room: RoomShape| {
        let parts =
            room.parts.iter().map(|p| frame.polygon_to_pixels(p, height)).collect::<Result<_, _>>()?;
        Ok(RoomShape { parts, ..room })
    };
    rooms.into_iter().map(room).collect()
}

/// The rows of the image that both layouts lie on. Layouts in the same units need none.
fn height(settings: &Settings) -> Result<f64, PluginError> {
    match settings.map_height {
        Some(rows) => Ok(rows.into()),
        None if settings.units == settings.truth_units => Ok(0.0),
        None => {
            let message = "the truth and the prediction are in different units, metres up and pixels down";
            let e = PluginError::new(planform_sdk::ErrorKind::BadOption, message);
            Err(e.advise("tell how many rows the map's image has"))
        }
    }
}
