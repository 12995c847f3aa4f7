//! Reads a map server's YAML file and its picture into a scene.

use crate::document::{picture_format, refuse_other_picture};
use crate::metadata::Metadata;
use crate::mode::{Mode, Rules};
use crate::options::{self, NAME, Unknown};
use crate::picture::{Picture, Tone};
use crate::stated;
use planform_sdk::{Cell, ErrorKind, Grid, Options, PluginError, Provenance, Scene, Source};

/// The grey that `map_saver` writes for unknown.
const SAVED_UNKNOWN: Tone = Tone { shade: 205.0 / 255.0, alpha: 1.0 };

/// Reads the whole document.
pub fn read(source: &Source, options: &Options) -> Result<Scene, PluginError> {
    let metadata = Metadata::parse(&source.bytes)?;
    let picture = read_picture(source, &metadata.image)?;
    let cells = picture.map(|tone| metadata.rules.cell(tone, picture.has_alpha()));
    let resolution = options.number("resolution").unwrap_or(metadata.resolution);
    let grid = Grid::new(picture.width(), picture.height(), resolution, metadata.origin, cells)
        .map_err(|e| PluginError::new(ErrorKind::BadInput, e.to_string()))?;
    let mut scene = Scene::of_grid(grid, Provenance { source: source.name(), adapter: NAME.into() });
    let of_options = option_warnings(&metadata, options)?;
    scene.warnings = [metadata.warnings, of_options, picture_warnings(&metadata.rules, &picture)].concat();
    let scale = resolution / metadata.resolution;
    scene.openings = metadata.openings.map(|o| stated::placed(o, &scene.grid, scale, &mut scene.warnings));
    Ok(scene)
}

fn read_picture(source: &Source, reference: &str) -> Result<Picture, PluginError> {
    let bytes = source.read_sibling(reference).map_err(|e| {
        let advice = "the YAML file's `image` names it, relative to the YAML file's folder";
        PluginError { message: format!("the map's picture {}", e.message), ..e }.advise(advice)
    })?;
    decode(&bytes).map_err(|e| PluginError { message: format!("{reference}: {}", e.message), ..e })
}

fn decode(bytes: &[u8]) -> Result<Picture, PluginError> {
    if bytes.is_empty() {
        return Err(PluginError::new(ErrorKind::BadInput, "the map's picture is empty"));
    }
    refuse_other_picture(bytes)?;
    let format = picture_format(bytes).ok_or_else(|| {
        PluginError::new(ErrorKind::BadInput, "the map's picture is no picture by its first bytes")
            .advise("PGM, PNG, BMP, TIFF and JPEG are read")
    })?;
    Picture::decode(bytes, format)
}

fn option_warnings(metadata: &Metadata, options: &Options) -> Result<Vec<String>, PluginError> {
    let mut warnings = vec![];
    let written = metadata.resolution;
    if let Some(given) = options.number("resolution").filter(|&given| given != written) {
        warnings
            .push(format!("the option `resolution` {given} is used instead of the YAML file's {written}"));
    }
    for (name, given) in
        [("negate", options.flag("negate")), ("unknown", options::unknown(options)? != Unknown::Auto)]
    {
        if given {
            warnings.push(format!(
                "the option `{name}` is for bare pictures; here the YAML file decides, and it is not used"
            ));
        }
    }
    Ok(warnings)
}

/// What a map server does silently, and what surprises people.
fn picture_warnings(rules: &Rules, picture: &Picture) -> Vec<String> {
    if rules.mode != Mode::Trinary {
        return vec![];
    }
    let mut warnings = vec![];
    if picture.has_alpha() {
        warnings.push(
            "the picture has an alpha channel, which counts as a fourth colour, as in map servers: greys look lighter"
                .into(),
        );
    }
    if rules.cell(SAVED_UNKNOWN, picture.has_alpha()) == Cell::FREE && holds_saved_unknown(picture) {
        let free = rules.free_thresh;
        warnings.push(format!(
            "the grey 205, which usually is unknown, counts as free with `free_thresh` {free}; 0.196 keeps it unknown"
        ));
    }
    warnings
}

/// Whether at least one pixel in a hundred has the grey.
fn holds_saved_unknown(picture: &Picture) -> bool {
    let saved = picture.map(|tone| tone.shade == SAVED_UNKNOWN.shade);
    let count = saved.iter().filter(|&&saved| saved).count();
    count * 100 >= saved.len()
}
