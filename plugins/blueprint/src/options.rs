//! What the adapter says of itself, and its options.

use crate::inputs::PageRequest;
use crate::words::measures::{self, Measure};
use crate::words::{OcrMode, WordOptions};
use planform_sdk::{
    Bounds, ErrorKind, OptionKind, OptionSpec, OptionValue, Options, PluginError, PluginInfo,
};
use std::path::PathBuf;

/// The adapter's name.
pub const NAME: &str = "blueprint";

/// What a run asks of the adapter.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Which page, from 1.
    pub page: u32,
    /// Pixels per inch of paper, if the user says so.
    pub dpi: Option<f64>,
    /// What the user knows of the scale.
    pub scale: KnownScale,
    /// How words are read.
    pub words: WordOptions,
    /// The folder of the user's own templates.
    pub templates: Option<PathBuf>,
    /// The layers of a CAD drawing that hold walls.
    pub layers: Option<Vec<String>>,
}

/// What the user knows of the scale.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum KnownScale {
    /// Nothing.
    #[default]
    Unknown,
    /// A pixel is this many metres.
    MetresPerPixel(f64),
    /// One on paper is this many in the world.
    Ratio(f64),
    /// These two points of the page, in pixels from its upper left corner, are this many metres apart.
    Distance([f64; 2], [f64; 2], f64),
}

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    let words = |list: &[&str]| list.iter().map(|&w| w.to_owned()).collect::<Vec<_>>();
    PluginInfo {
        name: NAME.into(),
        description: "Blueprints and evacuation plans: PDF, SVG, DXF, or PNG, JPEG, TIFF pictures".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: words(&["pdf", "svg", "svgz", "dxf", "png", "jpg", "jpeg", "tif", "tiff", "bmp"]),
        media_types: words(&[
            "application/pdf",
            "image/svg+xml",
            "image/vnd.dxf",
            "image/png",
            "image/jpeg",
            "image/tiff",
            "image/bmp",
        ]),
        options: specs(),
    }
}

fn specs() -> Vec<OptionSpec> {
    let number = |name: &str, help: &str, bounds, default: Option<f64>| {
        OptionSpec::new(name, help, OptionKind::Number(bounds), default.map(OptionValue::Number))
    };
    let text = |name: &str, help: &str, default: Option<&str>| {
        OptionSpec::new(name, help, OptionKind::Text, default.map(|d| OptionValue::Text(d.into())))
    };
    let metres = Bounds { min: Some(1e-4), max: Some(10.0), ..Bounds::default() };
    let whole = Bounds { min: Some(1.0), whole: true, ..Bounds::default() };
    let dpi = Bounds { min: Some(10.0), max: Some(2400.0), ..Bounds::default() };
    vec![
        number("page", "Which page of a document with several, from 1", whole, Some(1.0)),
        number("dpi", "Pixels per inch of paper; a PDF is drawn with so many, 200 by default", dpi, None),
        text(
            "scale",
            "The drawing's scale, such as 1:100; pictures need `dpi` with it unless they say it",
            None,
        ),
        number("metres-per-pixel", "Metres per pixel, where it is known", metres, None),
        number("resolution", "The same as metres-per-pixel", metres, None),
        text(
            "known-distance",
            "X1,Y1,X2,Y2,M: two points in pixels from the upper left corner that are M metres apart",
            None,
        ),
        OptionSpec::choice(
            "ocr",
            "Read the words: auto does if Tesseract is installed, on insists, off only takes them off the walls",
            &["auto", "on", "off"],
            "auto",
        ),
        text("lang", "The languages of the words, as Tesseract names them: eng+deu", Some("eng")),
        text("tessdata", "Tesseract's folder of languages, if it is not in its usual place", None),
        text("templates", "A folder with symbols of your own and their table symbols.toml", None),
        text(
            "layers",
            "The layers of a DXF drawing that hold walls: A-WALL,COLUMNS; a guess by default",
            None,
        ),
    ]
}

impl Request {
    /// Reads the options.
    pub fn of(options: &Options) -> Result<Self, PluginError> {
        let path = |name: &str| options.text(name).map(PathBuf::from);
        let layers = |list: &str| list.split(',').map(|l| l.trim().to_owned()).collect();
        Ok(Self {
            page: options.number("page").map_or(1, |n| n.min(f64::from(u32::MAX)) as u32),
            dpi: options.number("dpi"),
            scale: known_scale(options)?,
            words: WordOptions {
                ocr: match options.text("ocr") {
                    Some("on") => OcrMode::On,
                    Some("off") => OcrMode::Off,
                    _ => OcrMode::Auto,
                },
                lang: languages(options.text("lang").unwrap_or("eng"))?,
                tessdata: path("tessdata"),
            },
            templates: path("templates"),
            layers: options.text("layers").map(layers),
        })
    }
}

impl Request {
    /// What of the document is wanted.
    pub fn page_request(&self) -> PageRequest {
        let layers = self.layers.clone();
        let default = PageRequest::default();
        PageRequest { page: self.page, dpi: self.dpi.unwrap_or(default.dpi), layers }
    }
}

fn known_scale(options: &Options) -> Result<KnownScale, PluginError> {
    let metres = options.number("metres-per-pixel").or_else(|| options.number("resolution"));
    if let Some(metres) = metres {
        return Ok(KnownScale::MetresPerPixel(metres));
    }
    if let Some(text) = options.text("scale") {
        let ratio =
            ratio(text).ok_or_else(|| refuse("scale", text, "a scale such as 1:100 or 1/8\"=1'0\""))?;
        return Ok(KnownScale::Ratio(ratio));
    }
    options.text("known-distance").map_or(Ok(KnownScale::Unknown), |text| {
        distance(text).ok_or_else(|| {
            refuse("known-distance", text, "five numbers, X1,Y1,X2,Y2,METRES, of two points that differ")
        })
    })
}

/// Tesseract's names of languages, joined by `+`. Anything else is refused here: its library may crash on it.
fn languages(text: &str) -> Result<String, PluginError> {
    let names: Vec<&str> = text.split('+').map(str::trim).collect();
    let is_name = |name: &str| {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        !name.is_empty() && name.split('/').all(|part| !part.is_empty() && part.chars().all(plain))
    };
    if names.iter().all(|n| is_name(n)) {
        return Ok(names.join("+"));
    }
    Err(refuse("lang", text, "Tesseract's names of languages, joined by `+`, such as eng+deu"))
}

fn refuse(name: &str, value: &str, expected: &str) -> PluginError {
    PluginError::new(ErrorKind::BadOption, format!("option `{name}` cannot be `{value}`"))
        .advise(format!("give {expected}"))
}

fn ratio(text: &str) -> Option<f64> {
    let (paper, world) = text.split_once(':').or_else(|| text.split_once('/')).unwrap_or(("1", text));
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let plain = number(world).zip(number(paper)).map(|(world, paper)| world / paper);
    let written = || match measures::parse(text) {
        Some(Measure::Ratio(ratio)) => Some(ratio),
        _ => None,
    };
    plain.or_else(written).filter(|ratio| (0.1..=1e5).contains(ratio))
}

fn distance(text: &str) -> Option<KnownScale> {
    let numbers: Vec<f64> = text.split(',').map(|n| n.trim().parse().ok()).collect::<Option<_>>()?;
    let [x1, y1, x2, y2, metres] = numbers[..] else { return None };
    let apart = (x2 - x1).hypot(y2 - y1);
    (apart.is_finite() && apart > 1.0 && metres.is_finite() && metres > 0.0).then_some(KnownScale::Distance(
        [x1, y1],
        [x2, y2],
        metres,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(given: &[(&str, &str)]) -> Result<Request, String> {
        let options = Options::parse(&specs(), given.iter().copied()).map_err(|e| e.to_string())?;
        Request::of(&options).map_err(|e| e.to_string())
    }

    #[test]
    fn without_options_everything_is_found_out() {
        let found = request(&[]).unwrap();
        assert_eq!((found.page, found.dpi, found.scale), (1, None, KnownScale::Unknown));
        assert_eq!((found.words.ocr, found.words.lang.as_str(), found.layers), (OcrMode::Auto, "eng", None));
    }

    #[test]
    fn scales_can_be_given_in_many_ways() {
        let scale = |name, value| request(&[(name, value)]).map(|r| r.scale);
        assert_eq!(scale("scale", "1:50"), Ok(KnownScale::Ratio(50.0)));
        assert_eq!(scale("scale", "50"), Ok(KnownScale::Ratio(50.0)));
        assert_eq!(scale("metres-per-pixel", "0.02"), Ok(KnownScale::MetresPerPixel(0.02)));
        assert_eq!(scale("resolution", "0.02"), Ok(KnownScale::MetresPerPixel(0.02)));
        let two_points = KnownScale::Distance([1.0, 2.0], [11.0, 2.0], 5.0);
        assert_eq!(scale("known-distance", "1, 2, 11, 2, 5"), Ok(two_points));
    }

    #[test]
    fn wrong_scales_get_their_sentence() {
        for (name, value) in [
            ("scale", "fifty"),
            ("scale", "1:0"),
            ("scale", "0:1"),
            ("known-distance", "1,2,1,2,5"),
            ("known-distance", "1,2,3"),
        ] {
            let error = request(&[(name, value)]).unwrap_err();
            assert!(error.starts_with(&format!("option `{name}` cannot be `{value}`; give ")), "{error}");
        }
    }

    #[test]
    fn languages_are_names() {
        assert_eq!(request(&[("lang", "eng+ deu")]).unwrap().words.lang, "eng+deu");
        assert!(request(&[("lang", "script/Latin+chi_sim")]).is_ok());
        for lang in ["", "+", " ", "~eng", "../eng", "eng,deu", "eng+"] {
            let error = request(&[("lang", lang)]).unwrap_err();
            assert!(error.starts_with(&format!("option `lang` cannot be `{lang}`; give ")), "{error}");
        }
    }

    #[test]
    fn layers_are_a_list() {
        let layers = request(&[("layers", "A-WALL, MUR")]).unwrap().layers;
        assert_eq!(layers, Some(vec!["A-WALL".to_owned(), "MUR".to_owned()]));
    }
}
