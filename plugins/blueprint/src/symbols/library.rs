//! The templates that symbols are recognised by: those that are built in, and a user's own.

use super::drawing::{self, Drawing};
use planform_sdk::{ErrorKind, PluginError};
use serde::Deserialize;
use std::path::Path;

/// No table is longer than this, bytes.
const LARGEST_TABLE: u64 = 1 << 20;
/// No drawing is larger than this, bytes.
const LARGEST_FILE: u64 = 1 << 24;
/// A library has no more drawings than this: each costs time on every sheet.
const MOST_DRAWINGS: usize = 200;
const TABLE: &str = "symbols.toml";

/// What is done with a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Action {
    /// It is taken off the drawing.
    Erase,
    /// It is taken off, and the wall that it stands in is open there.
    Opening,
    /// The wall that it stands in goes on there.
    Window,
    /// It stays in the drawing.
    Keep,
}

/// How a symbol may be turned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Turned {
    /// By any angle.
    Freely,
    /// By 0, 90, 180 and 270 degrees.
    Quarters,
    /// Not at all.
    Upright,
}

/// What a symbol is drawn in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Colour {
    /// Whatever the drawing itself is drawn in.
    #[default]
    Any,
    /// As signs of fire-fighting equipment.
    Red,
    /// As signs of escape.
    Green,
    /// As signs of where one stands.
    Blue,
}

/// A symbol, with every way to draw it.
#[derive(Debug, Clone)]
pub struct Template {
    /// What it is called in layouts.
    pub kind: String,
    /// What is done with it.
    pub action: Action,
    /// How long its longer side is in the building, metres.
    pub metres: Option<[f64; 2]>,
    /// How it may be turned.
    pub turned: Turned,
    /// Whether it may be mirrored.
    pub mirrored: bool,
    /// What it is drawn in.
    pub colour: Colour,
    /// The ways to draw it.
    pub drawings: Vec<Drawing>,
    /// Whether a user drew it, and not we.
    pub own: bool,
}

/// All templates that a sheet is searched for.
#[derive(Debug, Clone)]
pub struct Library {
    /// The templates, those that are built in first.
    pub templates: Vec<Template>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    symbol: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    kind: String,
    #[serde(rename = "meaning")]
    _meaning: Option<String>,
    files: Vec<String>,
    action: Action,
    metres: Option<[f64; 2]>,
    paper_mm: Option<[f64; 2]>,
    turned: Turned,
    #[serde(default)]
    mirrored: bool,
    #[serde(default)]
    colour: Colour,
}

impl Library {
    /// The templates that are built in.
    ///
    /// # Errors
    /// None, unless the program was built of a damaged table.
    pub fn builtin() -> Result<Self, PluginError> {
        let read = |file: &str| match planform_templates::drawing(file) {
            Some(svg) => drawing::of_svg(svg.as_bytes()),
            None => Err(bad("is not built in")),
        };
        Ok(Self { templates: templates(planform_templates::TABLE, &read)? })
    }

    /// The templates that are built in, and those of a folder: `symbols.toml`, and the SVG and PNG files that it names.
    ///
    /// # Errors
    /// If the table cannot be read or makes no sense, or a drawing that it names cannot be read; the message names
    /// the file and the key.
    pub fn with_folder(folder: &Path) -> Result<Self, PluginError> {
        let mut library = Self::builtin()?;
        let table = read_file(&folder.join(TABLE), LARGEST_TABLE)?;
        let table = String::from_utf8(table).map_err(|_| bad(format!("`{TABLE}` is not text")))?;
        let own = templates(&table, &|file| own_drawing(folder, file))?;
        library.templates.extend(own.into_iter().map(|t| Template { own: true, ..t }));
        let drawings: usize = library.templates.iter().map(|t| t.drawings.len()).sum();
        if drawings > MOST_DRAWINGS {
            let message =
                format!("`{TABLE}` makes {drawings} drawings of symbols, more than {MOST_DRAWINGS}");
            return Err(PluginError::new(ErrorKind::Limit, message).advise("name fewer"));
        }
        Ok(library)
    }
}

fn bad(message: impl Into<String>) -> PluginError {
    PluginError::new(ErrorKind::BadOption, message)
}

type ReadDrawing<'a> = &'a dyn Fn(&str) -> Result<Drawing, PluginError>;

fn templates(table: &str, read: ReadDrawing) -> Result<Vec<Template>, PluginError> {
    let table: Table = toml::from_str(table).map_err(|e| {
        bad(format!("`{TABLE}`: {}", e.message())).advise("templates/README.md says what each key is")
    })?;
    table.symbol.into_iter().map(|entry| template(entry, read)).collect()
}

fn template(entry: Entry, read: ReadDrawing) -> Result<Template, PluginError> {
    check(&entry)?;
    let load = |file: &String| {
        read(file).map_err(|e| PluginError {
            message: format!("`{TABLE}`, `files` of `{}`: `{file}`: {}", entry.kind, e.message),
            ..e
        })
    };
    let drawings = entry.files.iter().map(load).collect::<Result<_, _>>()?;
    let Entry { kind, action, metres, turned, mirrored, colour, .. } = entry;
    Ok(Template { kind, action, metres, turned, mirrored, colour, drawings, own: false })
}

fn check(entry: &Entry) -> Result<(), PluginError> {
    let fault = |key: &str, wrong: &str| Err(bad(format!("`{TABLE}`, `{key}` of `{}`: {wrong}", entry.kind)));
    let word = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if entry.kind.is_empty() || !entry.kind.chars().all(word) {
        return fault("kind", "is not of lower case letters, digits and dashes");
    }
    if entry.files.is_empty() {
        return fault("files", "names no drawing");
    }
    match (entry.metres, entry.paper_mm) {
        (Some(range), None) if !rises(range) => fault("metres", "is not a range from small to large"),
        (None, Some(range)) if !rises(range) => fault("paper_mm", "is not a range from small to large"),
        (Some(_), Some(_)) => fault("paper_mm", "is given beside `metres`"),
        (None, None) => fault("metres", "is missing, and so is `paper_mm`"),
        _ => Ok(()),
    }
}

fn rises([from, to]: [f64; 2]) -> bool {
    from > 0.0 && from <= to && to.is_finite()
}

fn own_drawing(folder: &Path, file: &str) -> Result<Drawing, PluginError> {
    if file.contains(['/', '\\']) || file.starts_with("..") {
        return Err(bad("lies outside the folder").advise("name files of the folder itself"));
    }
    let bytes = read_file(&folder.join(file), LARGEST_FILE)?;
    match Path::new(file).extension().and_then(|e| e.to_str()) {
        Some("svg") => drawing::of_svg(&bytes),
        Some("png") => drawing::of_png(&bytes),
        _ => Err(bad("is neither an SVG nor a PNG file")),
    }
}

fn read_file(path: &Path, limit: u64) -> Result<Vec<u8>, PluginError> {
    let name = path.display();
    let io = |e: std::io::Error| {
        let e = PluginError::from(e);
        PluginError { message: format!("template file `{name}`: {}", e.message), ..e }
    };
    if std::fs::metadata(path).map_err(io)?.len() > limit {
        return Err(PluginError::new(
            ErrorKind::Limit,
            format!("template file `{name}` is larger than {limit} bytes"),
        ));
    }
    std::fs::read(path).map_err(io)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str =
        r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><rect width="6" height="9"/></svg>"##;

    fn own(table: &str) -> Result<Library, PluginError> {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join(TABLE), table).expect("written");
        std::fs::write(folder.path().join("square.svg"), SQUARE).expect("written");
        Library::with_folder(folder.path())
    }

    fn message(table: &str) -> String {
        own(table).expect_err("it is wrong").to_string()
    }

    const GOOD: &str =
        "[[symbol]]\nkind='box'\nfiles=['square.svg']\naction='erase'\nmetres=[0.5,1.0]\nturned='upright'\n";

    #[test]
    fn every_drawing_is_built_in_and_in_the_table() {
        let library = Library::builtin().expect("it is sound");
        let named: usize = library.templates.iter().map(|t| t.drawings.len()).sum();
        assert_eq!(named, planform_templates::DRAWINGS.len());
        for kind in ["door", "window", "stairs", "lift", "toilet", "sink", "you-are-here", "first-aid"] {
            assert!(library.templates.iter().any(|t| t.kind == kind), "{kind}");
        }
    }

    #[test]
    fn a_folder_adds_its_own() {
        let library = own(GOOD).expect("it is sound");
        let last = library.templates.last().expect("there are some");
        assert_eq!((last.kind.as_str(), last.action, last.colour), ("box", Action::Erase, Colour::Any));
    }

    #[test]
    fn what_is_wrong_is_named() {
        assert!(message("[[symbol]]\nkind='box'").contains("missing field"));
        assert!(message(&GOOD.replace("square", "circle")).contains("`files` of `box`: `circle.svg`"));
        assert!(message(&GOOD.replace("square.svg", "../a.svg")).contains("outside the folder"));
        assert!(message(&GOOD.replace("0.5,1.0", "2.0,1.0")).contains("`metres` of `box`"));
        assert!(message(&GOOD.replace("metres=[0.5,1.0]", "")).contains("`paper_mm`"));
        assert!(message(&GOOD.replace("'box'", "'A box'")).contains("`kind` of `A box`"));
        assert!(message(&GOOD.replace("'erase'", "'eat'")).contains("unknown variant"));
        assert!(Library::with_folder(Path::new("/nowhere")).expect_err("none").to_string().contains(TABLE));
    }
}
