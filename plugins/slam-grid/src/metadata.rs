//! Reads the YAML file of a map server.

use crate::mode::{Mode, Rules};
use crate::{scalar, stated};
use planform_sdk::{ErrorKind, Place, PluginError, Pose, StatedOpening};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_saphyr::{Location, NonFiniteFloatPolicy, Spanned};

/// The most bytes that a YAML file may have. Real ones have a few hundred.
const BYTE_LIMIT: usize = 1 << 20;
/// Thresholds for files that leave them out: those that tell the three greys of `map_saver` apart.
const OCCUPIED_THRESH: f64 = 0.65;
const FREE_THRESH: f64 = 0.196;

/// What a map server's YAML file says.
#[derive(Debug, Clone, PartialEq)]
pub struct Metadata {
    /// The picture's path as it stands in the file.
    pub image: String,
    /// Metres per pixel.
    pub resolution: f64,
    /// Pose of the picture's lower left corner in the map frame.
    pub origin: Pose,
    /// How pixels become cells.
    pub rules: Rules,
    /// All openings between rooms, if the file states them.
    pub openings: Option<Vec<StatedOpening>>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// The keys as texts with their lines: map servers and their users write numbers in ways that YAML does not know.
#[derive(Deserialize)]
#[serde(expecting = "the keys of a map server's YAML file, such as `image` and `resolution`")]
struct Raw {
    image: Option<Scalar>,
    resolution: Option<Scalar>,
    origin: Option<Spanned<Vec<Scalar>>>,
    negate: Option<Scalar>,
    occupied_thresh: Option<Scalar>,
    free_thresh: Option<Scalar>,
    mode: Option<Scalar>,
}

type Scalar = Spanned<String>;

impl Metadata {
    /// Reads the whole file.
    pub fn parse(bytes: &[u8]) -> Result<Self, PluginError> {
        let text = text(bytes)?;
        let raw = parse_yaml(&text)?;
        let mut warnings = vec![];
        Ok(Self {
            image: image(raw.image)?,
            resolution: resolution(raw.resolution)?,
            origin: origin(raw.origin, &mut warnings)?,
            rules: Rules {
                mode: mode(raw.mode)?,
                negate: negate(raw.negate, &mut warnings)?,
                ..thresholds(raw.occupied_thresh, raw.free_thresh, &mut warnings)?
            },
            openings: stated::read(&text, &mut warnings),
            warnings,
        })
    }
}

/// Comments may be in any encoding, and no key that matters but `image` holds letters.
fn text(bytes: &[u8]) -> Result<String, PluginError> {
    if bytes.len() > BYTE_LIMIT {
        let message = format!("the YAML file has {} bytes; the most are {BYTE_LIMIT}", bytes.len());
        return Err(PluginError::new(ErrorKind::Limit, message).advise("is it the map's YAML file?"));
    }
    Ok(String::from_utf8_lossy(bytes).trim_start_matches('\u{feff}').to_owned())
}

/// The keys that are asked for; whatever else is in the file may be no number.
pub fn keys<T: DeserializeOwned>(text: &str) -> Result<T, serde_saphyr::Error> {
    let options = serde_saphyr::options! { non_finite_float_policy: NonFiniteFloatPolicy::PassThrough };
    serde_saphyr::from_str_with_options(text, options)
}

fn parse_yaml(text: &str) -> Result<Raw, PluginError> {
    keys(text).map_err(|e| {
        let reason = e.without_snippet().to_string();
        let reason = shorten(reason.lines().next().unwrap_or_default(), 200);
        let message = format!("the file is not the YAML of a map server: {reason}");
        let error = PluginError::new(ErrorKind::BadInput, message);
        located(error, e.location())
    })
}

/// The picture that the YAML of a map server names, whatever else is wrong with it.
pub fn image_of(bytes: &[u8]) -> Option<String> {
    image(parse_yaml(&text(bytes).ok()?).ok()?.image).ok()
}

fn image(value: Option<Scalar>) -> Result<String, PluginError> {
    let value = required(value, "image", "the path of the map's picture")?;
    if value.value.trim().is_empty() {
        return Err(bad(&value, "`image` is empty").advise("give the path of the map's picture"));
    }
    Ok(value.value)
}

fn resolution(value: Option<Scalar>) -> Result<f64, PluginError> {
    let value = required(value, "resolution", "metres per pixel")?;
    match scalar::number(&value.value) {
        Some(v) if v.is_finite() && v > 0.0 => Ok(v),
        _ => Err(cannot_be("resolution", &value).advise("give metres per pixel, a number above 0")),
    }
}

fn origin(value: Option<Spanned<Vec<Scalar>>>, warnings: &mut Vec<String>) -> Result<Pose, PluginError> {
    let list = required(value, "origin", "the pose [x, y, yaw] of the picture's lower left corner")?;
    let [x, y, yaw] = list.value.as_slice() else {
        let message = format!("`origin` must have three numbers [x, y, yaw], not {}", list.value.len());
        return Err(bad(&list, message));
    };
    Ok(Pose { x: coordinate(x)?, y: coordinate(y)?, yaw: heading(yaw, warnings)? })
}

fn coordinate(value: &Scalar) -> Result<f64, PluginError> {
    scalar::number(&value.value).filter(|v| v.is_finite()).ok_or_else(|| bad_origin(value, "metres"))
}

/// `map_saver` writes the yaw of a broken pose as not-a-number, and such maps are used unturned.
fn heading(value: &Scalar, warnings: &mut Vec<String>) -> Result<f64, PluginError> {
    match scalar::number(&value.value) {
        Some(yaw) if yaw.is_nan() => {
            let line = value.referenced.line();
            warnings.push(format!("line {line}: the yaw of `origin` is not a number; it is taken as 0"));
            Ok(0.0)
        }
        Some(yaw) if yaw.is_finite() => Ok(yaw),
        _ => Err(bad_origin(value, "radians")),
    }
}

fn bad_origin(value: &Scalar, unit: &str) -> PluginError {
    bad(value, format!("`origin` cannot have `{}` in it", shorten(&value.value, 40)))
        .advise(format!("give a finite number of {unit}"))
}

fn mode(value: Option<Scalar>) -> Result<Mode, PluginError> {
    let Some(value) = value else { return Ok(Mode::Trinary) };
    Mode::named(value.value.trim())
        .ok_or_else(|| cannot_be("mode", &value).advise("give trinary, scale or raw"))
}

fn negate(value: Option<Scalar>, warnings: &mut Vec<String>) -> Result<bool, PluginError> {
    let Some(value) = value else {
        warnings.push("`negate` is missing; 0 is used: dark is occupied".into());
        return Ok(false);
    };
    scalar::flag(&value.value)
        .ok_or_else(|| cannot_be("negate", &value).advise("give 0 where dark is occupied, 1 where light is"))
}

/// Both thresholds, in rules of which nothing else counts.
fn thresholds(
    occupied: Option<Scalar>,
    free: Option<Scalar>,
    warnings: &mut Vec<String>,
) -> Result<Rules, PluginError> {
    let place = free.as_ref().or(occupied.as_ref()).map(|v| v.referenced);
    let occupied_thresh = threshold(occupied, "occupied_thresh", OCCUPIED_THRESH, warnings)?;
    let free_thresh = threshold(free, "free_thresh", FREE_THRESH, warnings)?;
    if free_thresh < occupied_thresh {
        return Ok(Rules { mode: Mode::Trinary, negate: false, occupied_thresh, free_thresh });
    }
    let message = format!("`free_thresh` {free_thresh} is not below `occupied_thresh` {occupied_thresh}");
    let error = PluginError::new(ErrorKind::BadInput, message).advise("are the two swapped?");
    Err(located(error, place))
}

fn threshold(
    value: Option<Scalar>,
    key: &str,
    default: f64,
    warnings: &mut Vec<String>,
) -> Result<f64, PluginError> {
    let Some(value) = value else {
        warnings.push(format!("`{key}` is missing; {default} is used"));
        return Ok(default);
    };
    scalar::number(&value.value)
        .filter(|v| (0.0..=1.0).contains(v))
        .ok_or_else(|| cannot_be(key, &value).advise("give a number from 0 to 1"))
}

fn required<T>(value: Option<T>, key: &str, what: &str) -> Result<T, PluginError> {
    value.ok_or_else(|| {
        PluginError::new(ErrorKind::BadInput, format!("the YAML file has no `{key}`"))
            .advise(format!("add it: {what}"))
    })
}

fn bad<T>(value: &Spanned<T>, message: impl Into<String>) -> PluginError {
    located(PluginError::new(ErrorKind::BadInput, message), Some(value.referenced))
}

fn located(error: PluginError, location: Option<Location>) -> PluginError {
    match location.and_then(|l| usize::try_from(l.line()).ok()) {
        Some(line) if line > 0 => error.at(Place::Line(line)),
        _ => error,
    }
}

fn cannot_be(key: &str, value: &Scalar) -> PluginError {
    bad(value, format!("`{key}` cannot be `{}`", shorten(&value.value, 40)))
}

/// As much of a text as a message can bear.
fn shorten(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}
