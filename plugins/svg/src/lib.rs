//! Writes layouts as SVG drawings to scale.
//!
//! One unit of the drawing is one metre, x right, y down; `width` and `height` of the root are its size on paper, in
//! millimetres at the scale 1:100 or what the option `scale` says. The attribute `data-origin` of the root holds the
//! map coordinates of the drawing's upper left corner: the point (x, y) of the drawing is the point
//! (x0 + x, y0 - y) of the map frame, for all elements but those with a `transform` (the grid's picture, turned
//! texts). Coordinates have four decimals, that is 0.1 mm.
//!
//! The layers, from the bottom, are groups with these ids, which Inkscape lists as layers:
//!
//! | layer | holds |
//! | --- | --- |
//! | `paper` | a white sheet |
//! | `grid` | the occupancy grid as a picture; only with the option `grid` |
//! | `rooms` | a path for each, id `room-1`, class `room complete` or `room partial`, `data-id`, `data-name`, `data-area` (floor, m²) |
//! | `walls` | a line for each, id `wall-1`, class `wall` and `strong`, `medium` or `weak` by thirds of its `data-weight` |
//! | `windows` | the document's windows: two thin lines in the wall, a group for each as in `symbols` |
//! | `doors` | a group for each opening, id `opening-1`, class `door` or `passage`, `data-rooms`, `data-width` (m); then the document's doors, a group for each as in `symbols`: a line (class `leaf`) and an arc (`swing`) for each leaf, and `data-opening`, the id of its opening; a door without one, as to the outside, is cut out of the wall |
//! | `frontiers` | dashed lines, id `frontier-1`, `data-room`, `data-leads` (`room`, `space`), `data-area` (behind it, m²; 0 is no estimate) |
//! | `symbols` | the document's other symbols in a drawing of their kind, else as a box with a tick in its direction; a group for each, id `symbol-1`, `data-kind`, `data-score`; before them the drawings, id `kind-toilet` |
//! | `texts` | the document's texts, id `text-1`; those that a label repeats have the class `named` and are hidden |
//! | `labels` | name or number, and floor area, of each room, id `label-1`; not with the option `labels=false` |
//! | `scale` | a scale bar |
//!
//! Colours are in the one `<style>` element, so that a drawing can be restyled by classes.

mod element;
mod notes;
mod options;
mod picture;
mod rooms;
mod sheet;
mod spot;
mod style;
mod symbols;
mod walls;

use element::{layer, number, title, with_text};
use picture::Part;
use planform_sdk::{
    Boundary, Document, ErrorKind, Exporter, Grid, Layout, Options, PluginError, Point, Scale, Scene,
};
use sheet::Sheet;
use std::io::Write;
use svg::node::element::{Group, Rectangle, SVG, Style};

/// The exporter `svg`.
pub fn exporter() -> Box<dyn Exporter> {
    planform_sdk::exporter(options::info(), write)
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

fn write(document: &Document<'_>, options: &Options, out: &mut dyn Write) -> Result<(), PluginError> {
    let drawing = draw(document, options)?;
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{drawing}")?;
    Ok(())
}

fn draw(document: &Document<'_>, options: &Options) -> Result<SVG, PluginError> {
    let layout = document.layout;
    let grid = grid(document.scene, options)?;
    let part = grid.and_then(Part::known);
    let known = grid.zip(part).map(|(g, p)| p.corners().map(|c| g.to_map(c)));
    let sheet = Sheet::around(layout, &known.map(Vec::from).unwrap_or_default())?;
    let rules = [style::RULES, if grid.is_some() { style::OVER_GRID } else { "" }].concat();
    let root = root(&sheet, options::ratio(options)?)?
        .add(title(&layout.provenance.source))
        .add(with_text("desc", &description(layout, &sheet)))
        .add(Style::new(rules).set("type", "text/css"))
        .add(paper(&sheet));
    let root = match grid.zip(part) {
        Some((grid, part)) => root.add(picture::draw(grid, &part, &sheet)?),
        None => root,
    };
    Ok(layers(layout, options, &sheet).into_iter().fold(root, SVG::add))
}

/// The grid to lie underneath, if it is asked for.
fn grid<'a>(scene: Option<&'a Scene>, options: &Options) -> Result<Option<&'a Grid>, PluginError> {
    if !options.flag("grid") {
        return Ok(None);
    }
    let missing = || {
        PluginError::new(
            ErrorKind::BadOption,
            "option `grid` cannot be `true`: there is no grid beside the layout",
        )
        .advise("start from the map itself, or leave the option out")
    };
    scene.map(|s| Some(&s.grid)).ok_or_else(missing)
}

fn root(sheet: &Sheet, scale: f64) -> Result<SVG, PluginError> {
    let millimetres = |metres: f64| metres * 1000.0 / scale;
    if !(millimetres(sheet.size()).is_finite()) {
        let message = format!("option `scale` cannot be `{scale}`: the drawing would have no finite size");
        return Err(PluginError::new(ErrorKind::BadOption, message).advise("give a number such as 100"));
    }
    let Point { x, y } = sheet.origin;
    Ok(SVG::new()
        .set("xmlns:xlink", "http://www.w3.org/1999/xlink")
        .set("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape")
        .set("width", format!("{}mm", number(millimetres(sheet.width))))
        .set("height", format!("{}mm", number(millimetres(sheet.height))))
        .set("viewBox", format!("0 0 {} {}", number(sheet.width), number(sheet.height)))
        .set("data-origin", format!("{} {}", number(x), number(y)))
        .set("data-scale", number(scale)))
}

fn description(layout: &Layout, sheet: &Sheet) -> String {
    let Point { x, y } = sheet.origin;
    let drawn = format!(
        "Drawn by planform {} with the method {:?}. One unit is one metre; the point (x, y) of the drawing is \
         ({} + x, {} - y) in the map frame.",
        env!("CARGO_PKG_VERSION"),
        layout.method,
        number(x),
        number(y),
    );
    drawn + &layout.scale.as_ref().map(scale_found).unwrap_or_default()
}

/// How large the building is was not measured: whoever measures in the drawing should know.
fn scale_found(scale: &Scale) -> String {
    format!(" The scale is {}, {:.0} % sure.", scale.told(), 100.0 * scale.confidence)
}

fn paper(sheet: &Sheet) -> Group {
    let (width, height) = (number(sheet.width), number(sheet.height));
    layer("paper").add(Rectangle::new().set("class", "paper").set("width", width).set("height", height))
}

/// The layers over the grid, from the bottom.
fn layers(layout: &Layout, options: &Options, sheet: &Sheet) -> Vec<Group> {
    let boundary = Boundary::chosen(options);
    let labels = options.flag("labels");
    let mut layers = vec![
        rooms::draw(layout, boundary, sheet),
        walls::draw(layout, sheet),
        symbols::windows(layout, sheet),
        walls::open(layout, sheet),
        walls::frontiers(layout, sheet),
        symbols::others(layout, sheet),
        notes::texts(layout, labels, sheet),
    ];
    if labels {
        layers.push(rooms::label(layout, boundary, sheet));
    }
    layers.push(notes::scale(sheet));
    layers
}
