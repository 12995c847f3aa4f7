//! DXF drawings: the plan in model space, to scale.

mod doors;
mod drawing;
mod extent;
mod hatch;
mod layers;
mod own;
mod pairs;
mod plane;
mod raster;
mod shapes;
mod splines;
mod symbols;
mod unfold;
mod units;
mod words;

use super::PageRequest;
use super::guard::{PATIENCE, guarded};
use super::kind::BINARY_DXF;
use super::no_such_page;
use crate::found::{SheetLeaf, SheetSymbol, SheetText};
use crate::page::Page;
use drawing::Drawing;
use layers::{Role, role};
use plane::Point;
use planform_sdk::{ErrorKind, PluginError};
use raster::Frame;
use shapes::Shape;
use std::collections::BTreeSet;
use symbols::Placed;
use unfold::Shown;
use words::Words;

/// Layers named for walls count if they hold at least as many lines.
const FEWEST_WALLS: usize = 4;
/// A closed line among walls that is no thicker than this, metres, is the outline of a wall; others are of rooms.
const THICKEST_WALL: f64 = 1.0;
/// The most layers that a message lists.
const LISTED: usize = 20;

/// Draws the walls of the drawing.
pub fn page(bytes: &[u8], request: &PageRequest) -> Result<Page, PluginError> {
    if request.page > 1 {
        return Err(no_such_page(request.page, 1));
    }
    if bytes.starts_with(BINARY_DXF) {
        return Err(PluginError::new(ErrorKind::Unsupported, "it is a binary DXF, which is not read")
            .advise("save it as DXF in text form (ASCII)"));
    }
    let (bytes, wanted) = (bytes.to_vec(), request.layers.clone());
    guarded("the DXF", PATIENCE, move || read(&bytes, wanted.as_deref()))
}

fn read(bytes: &[u8], wanted: Option<&[String]>) -> Result<Page, PluginError> {
    let text = pairs::decode(bytes);
    let pairs = pairs::pairs(&text)?;
    let drawing = Drawing::of(&pairs);
    let shown = Shown::of(&drawing, &|name| symbols::kind(name).is_some())?;
    let (lines, walls_only) = walls(&shown, wanted)?;
    let extent = extent::extent(lines.iter().copied()).filter(|e| e[0] != e[1]).ok_or_else(no_lines)?;
    let mut placed: Vec<_> = shown.insertions.iter().filter_map(symbols::placed).collect();
    if walls_only {
        placed.extend(loose_doors(&shown, wanted));
    }
    let (unit, warning) = unit(drawing.units, extent, &placed);
    let frame = Frame::of(extent, unit);
    let is_outline =
        |shape: &Shape| walls_only && shape.thickness().is_some_and(|t| t * unit <= THICKEST_WALL);
    let filled = |shape: &Shape| Shape { filled: shape.filled || is_outline(shape), ..shape.clone() };
    let drawn: Vec<Shape> = lines.into_iter().map(filled).collect();
    Ok(Page {
        picture: raster::draw(drawn.iter(), &frame)?,
        dpi: None,
        metres_per_pixel: Some(unit / frame.scale),
        origin: frame.low.map(|v| v * unit),
        texts: shown
            .words
            .iter()
            .map(|w| sheet_text(w, &frame))
            .filter(|t| within(t.centre, &frame))
            .collect(),
        drawn: false,
        symbols: placed
            .iter()
            .map(|s| sheet_symbol(s, &frame))
            .filter(|s| within(s.centre, &frame))
            .collect(),
        walls_only,
        warnings: warning.into_iter().collect(),
    })
}

/// The lines that walls are made of, and whether the drawing says that they are walls.
fn walls<'s>(shown: &'s Shown, wanted: Option<&[String]>) -> Result<(Vec<&'s Shape>, bool), PluginError> {
    let on = |fits: &dyn Fn(&str) -> bool| -> Vec<&Shape> {
        shown.lines.iter().filter(|(layer, _)| fits(layer)).map(|(_, shape)| shape).collect()
    };
    if let Some(wanted) = wanted {
        let wanted: BTreeSet<_> = wanted.iter().map(|l| l.trim().to_uppercase()).collect();
        check_layers(shown, &wanted)?;
        return Ok((on(&|layer| wanted.contains(layer)), true));
    }
    let walls = on(&|layer| role(layer) == Role::Wall);
    if walls.len() >= FEWEST_WALLS {
        return Ok((walls, true));
    }
    let likely = on(&|layer| role(layer) != Role::Aside);
    Ok((if likely.is_empty() { on(&|_| true) } else { likely }, false))
}

/// Doors that are drawn on layers beside those that walls are taken from.
fn loose_doors(shown: &Shown, wanted: Option<&[String]>) -> Vec<Placed> {
    let is_wall = |layer: &str| wanted.is_some_and(|w| w.iter().any(|l| l.trim().to_uppercase() == layer));
    let beside = |layer: &str| doors::is_layer(layer) && !is_wall(layer);
    let shapes = shown.lines.iter().filter(|(layer, _)| beside(layer)).map(|(_, shape)| shape.clone());
    doors::doors(&shapes.collect::<Vec<_>>(), &shown.sills)
}

fn check_layers(shown: &Shown, wanted: &BTreeSet<String>) -> Result<(), PluginError> {
    let there: BTreeSet<_> = shown.lines.iter().map(|(layer, _)| layer.as_str()).collect();
    let Some(missing) = wanted.iter().find(|l| !there.contains(l.as_str())) else { return Ok(()) };
    if there.is_empty() {
        return Err(no_lines());
    }
    let listed: Vec<_> = there.iter().copied().take(LISTED).collect();
    let more = if there.len() > LISTED { ", and more" } else { "" };
    let message = format!("no visible line of the DXF lies on the layer `{missing}`");
    let advice = format!("lines lie on {}{more}", listed.join(", "));
    Err(PluginError::new(ErrorKind::BadOption, message).advise(advice))
}

fn no_lines() -> PluginError {
    PluginError::new(ErrorKind::BadInput, "the DXF has no lines in model space that walls could be made of")
        .advise("check that its layers are neither off nor frozen, and that it is no drawing of solids")
}

/// Metres of the drawing's unit, and what the reader should know of it.
fn unit(stated: Option<i32>, [low, high]: [Point; 2], placed: &[Placed]) -> (f64, Option<String>) {
    let length = (high[0] - low[0]).max(high[1] - low[1]);
    let is_door = |s: &&Placed| s.kind == "door" && !s.leaves.is_empty();
    let doors: Vec<_> = placed.iter().filter(is_door).map(|s| s.width).collect();
    let (guessed, by) = units::guess(length, &doors);
    match stated.and_then(units::metres) {
        None => (guessed, Some(format!("the DXF does not say its unit; {by}"))),
        Some(unit) if units::is_building(unit * length) || !units::is_building(guessed * length) => {
            (unit, None)
        }
        // Many a program writes a unit that nobody chose.
        Some(unit) => {
            let size = unit * length;
            (
                guessed,
                Some(format!(
                    "by the unit that the DXF states its plan would be {size:.2} m long; {by} instead"
                )),
            )
        }
    }
}

fn within([x, y]: Point, frame: &Frame) -> bool {
    (0.0..=f64::from(frame.width)).contains(&x) && (0.0..=f64::from(frame.height)).contains(&y)
}

fn sheet_text(words: &Words, frame: &Frame) -> SheetText {
    SheetText {
        content: words.content.clone(),
        centre: frame.pixel(words.centre),
        angle: -words.angle,
        width: words.width * frame.scale,
        height: words.height * frame.scale,
        confidence: 1.0,
    }
}

fn sheet_symbol(placed: &Placed, frame: &Frame) -> SheetSymbol {
    let leaf = |&[hinge, closed, open]: &[Point; 3]| SheetLeaf {
        hinge: frame.pixel(hinge),
        closed: frame.pixel(closed),
        open: frame.pixel(open),
    };
    SheetSymbol {
        kind: placed.kind.to_owned(),
        centre: frame.pixel(placed.centre),
        angle: -placed.angle,
        width: placed.width * frame.scale,
        height: placed.height * frame.scale,
        score: 1.0,
        leaves: placed.leaves.iter().map(leaf).collect(),
    }
}

#[cfg(test)]
mod tests;
