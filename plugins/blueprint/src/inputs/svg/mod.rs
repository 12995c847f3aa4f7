//! SVG drawings.
//!
//! Nothing outside of the document is loaded, neither files nor fonts: what a plan is read as depends on the plan alone.
//! Its words are taken from the document as texts, and from the pictures that it holds.

mod bombs;
mod pictures;
mod texts;
mod unpack;

use super::PageRequest;
use super::guard::{PATIENCE, guarded};
use super::limit::{MAX_PIXELS, largest_scale};
use super::no_such_page;
use crate::page::Page;
use image::RgbImage;
use pictures::Pictures;
use planform_sdk::{ErrorKind, Place, PluginError};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Error, Options, Tree};
use roxmltree::{Document, ParsingOptions};

/// The longer side of a drawing that does not say how large it is on paper, pixels.
const LONG_SIDE: f64 = 3000.0;
/// SVG's own unit: pixels per inch.
const UNITS_PER_INCH: f64 = 96.0;
/// The most elements of a document.
const MAX_NODES: u32 = 2_000_000;

/// Draws the document.
pub fn page(bytes: &[u8], request: &PageRequest) -> Result<Page, PluginError> {
    if request.page > 1 {
        return Err(no_such_page(request.page, 1));
    }
    let (bytes, dpi) = (bytes.to_vec(), request.dpi);
    guarded("the SVG", PATIENCE, move || read(&bytes, dpi))
}

fn read(bytes: &[u8], dpi: f64) -> Result<Page, PluginError> {
    let text = unpack::text(bytes)?;
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..Default::default() };
    let document = Document::parse_with_options(&text, options).map_err(|e| broken(&e))?;
    bombs::check_document(&document)?;
    let pictures = Pictures::default();
    let tree = Tree::from_xmltree(&document, &sealed(&pictures)).map_err(cannot)?;
    bombs::check_tree(&tree)?;
    let size = [f64::from(tree.size().width()), f64::from(tree.size().height())];
    let scale = Scale::of(size, texts::paper_size(&document), dpi);
    let to_page = texts::view_transform(&document, size).scaled(scale.factor);
    Ok(Page {
        picture: render(&tree, &scale)?,
        dpi: scale.dpi,
        metres_per_pixel: None,
        origin: [0.0; 2],
        texts: texts::texts(&document, to_page),
        drawn: pictures.are_drawn(),
        symbols: vec![],
        walls_only: false,
        warnings: warnings(&pictures, &scale),
    })
}

/// Options by which no file, address or font is opened.
fn sealed(pictures: &Pictures) -> Options<'_> {
    Options { image_href_resolver: pictures.resolver(), ..Options::default() }
}

/// How large the drawing becomes.
struct Scale {
    /// Pixels per unit.
    factor: f64,
    /// Pixels.
    width: u32,
    height: u32,
    /// Pixels per inch, if the drawing says how large it is on paper.
    dpi: Option<f64>,
    /// Whether it had to become smaller than wanted.
    shrunk: bool,
}

impl Scale {
    /// For a drawing of this size in units; `on_paper` if these are real lengths.
    fn of([width, height]: [f64; 2], on_paper: bool, dpi: f64) -> Self {
        let wanted = if on_paper { dpi / UNITS_PER_INCH } else { LONG_SIDE / width.max(height) };
        let largest = largest_scale(width, height) * 0.999;
        let factor = wanted.min(largest);
        let [w, h] = [width, height].map(|side| (side * factor).round().max(1.0) as u32);
        let dpi = on_paper.then_some(factor * UNITS_PER_INCH);
        Self { factor, width: w, height: h, dpi, shrunk: factor < wanted }
    }
}

fn render(tree: &Tree, scale: &Scale) -> Result<RgbImage, PluginError> {
    let failed =
        || PluginError::new(ErrorKind::Limit, "the SVG is too large to be drawn").advise("scale it down");
    let mut pixmap = Pixmap::new(scale.width, scale.height).ok_or_else(failed)?;
    pixmap.fill(Color::WHITE);
    let factor = scale.factor as f32;
    resvg::render(tree, Transform::from_scale(factor, factor), &mut pixmap.as_mut());
    let mut samples = Vec::with_capacity(scale.width as usize * scale.height as usize * 3);
    samples.extend(pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    RgbImage::from_raw(scale.width, scale.height, samples).ok_or_else(failed)
}

fn warnings(pictures: &Pictures, scale: &Scale) -> Vec<String> {
    let mut warnings = vec![];
    if pictures.are_refused() {
        let advice = "export the plan as PDF or PNG if its walls are missing";
        let drawn = "only those are that the file itself holds as PNG or JPEG";
        warnings.push(format!("a picture of the SVG is not drawn: {drawn}; {advice}"));
    }
    if scale.shrunk {
        let limit = MAX_PIXELS / 1_000_000;
        let (width, height) = (scale.width, scale.height);
        warnings.push(format!(
            "the drawing is drawn with {width} x {height} pixels only, since at most {limit} million are read"
        ));
    }
    warnings
}

fn broken(e: &roxmltree::Error) -> PluginError {
    match e {
        roxmltree::Error::NodesLimitReached => bombs::refuse(&format!("more than {MAX_NODES} elements")),
        roxmltree::Error::EntityReferenceLoop(_) => {
            bombs::refuse("entities that refer to each other without end")
        }
        other => {
            // The parser's words end with line and column, which have their own place here.
            let words = other.to_string();
            let words = words.rsplit_once(" at ").map_or(words.as_str(), |(words, _)| words);
            PluginError::new(ErrorKind::BadInput, format!("the SVG is no sound XML: {words}"))
                .at(Place::Line(other.pos().row as usize))
                .advise("save it again")
        }
    }
}

fn cannot(e: Error) -> PluginError {
    match e {
        Error::InvalidSize => PluginError::new(ErrorKind::BadInput, "the SVG has no size")
            .advise("give its svg element a viewBox, or a width and a height"),
        Error::ElementsLimitReached => bombs::refuse("too many elements"),
        other => PluginError::new(ErrorKind::BadInput, format!("the SVG cannot be read: {other}"))
            .advise("save it again"),
    }
}

#[cfg(test)]
mod tests;
