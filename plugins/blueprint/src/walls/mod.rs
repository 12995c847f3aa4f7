//! Walls: told from all else that is drawn, and made the cells of a grid.
//!
//! Two things are walls wherever they are: ink that is thicker than lines are (`stroke`), and narrow bands between
//! lines (`narrow`), hatched or not. Whether a thin line is one is told by what it parts. The gaps in line are closed
//! (`bridges`), so that ink and walls enclose faces (`faces`); faces that are too small for a room, and those with more
//! gap than line between them, become one with the face beside (`merge`), for they are furniture, stairs, hatching. A
//! line that still has different rooms on its two sides is a wall, all others are not, nor are lines from words to dots
//! (`leaders`), or lines that run through an outer wall (`leaving`) or lie beyond it (`beyond`), nor is what stands alone
//! (`standing`). Gates may be drawn too faintly for ink (`gates`). What walls enclose is the building (`inside`).

mod apart;
mod beyond;
mod bridges;
mod cells;
mod components;
mod distance;
mod drawing;
mod faces;
mod gates;
mod inside;
mod leaders;
mod leaving;
mod merge;
mod narrow;
mod openings;
mod outline;
mod picture;
mod scale;
mod standing;
mod straight;
mod stroke;
mod tracks;

pub use cells::{Cells, cells};

use crate::found::{SheetSymbol, SheetText};
use crate::mask::Mask;
use crate::prepare::faint;
use crate::sheet::Sheet;
use crate::stages::Stages;
use drawing::Drawing;
use faces::Faces;
use merge::Rooms;
use picture::Kinds;
use straight::Straight;

/// Lines of at least this length point across gaps, metres,
const LINE: f64 = 0.5;

/// which are at most this wide, metres: doors and a little more.
const DOORWAY: f64 = 1.2;

/// The sure walls are the outer ones if they enclose this share of what all lines enclose.
const MOST: f64 = 0.6;

/// The walls of a drawing.
#[derive(Debug, Clone)]
pub struct Walls {
    /// The walls, filled, at the sheet's size. The openings of doors are not set, windows are.
    pub occupied: Mask,
    /// The building: all that is not outside, walls included.
    pub inside: Mask,
    /// The usual thickness of thin lines, pixels of the sheet.
    pub stroke: f64,
    /// The usual thickness of walls, pixels of the sheet; 0 if there is none.
    pub thickness: f64,
    /// Metres per pixel that the search went by: those given, or a rough guess.
    pub metres_per_pixel: f64,
    /// The share of the walls' outline that is straight, from 0 to 1. Of plans it is 0.3 and more, of photographs
    /// seldom 0.2.
    pub straightness: f64,
    /// From 0 (nothing is enclosed) to 1: the share of floor in the building's area. Under about 0.3 the sheet shows
    /// hardly a building.
    pub confidence: f64,
}

/// What was read of the sheet, and erased from its ink.
#[derive(Debug, Clone, Copy)]
pub struct Read<'a> {
    /// The words.
    pub texts: &'a [SheetText],
    /// The symbols, doors and windows among them.
    pub symbols: &'a [SheetSymbol],
}

/// Finds the walls in the ink of a sheet, of which words and symbols have been erased. Without `metres_per_pixel` the
/// scale is guessed, by the doors if there are some.
pub fn find(
    ink: &Mask,
    sheet: &Sheet,
    read: Read,
    metres_per_pixel: Option<f64>,
    stages: &mut dyn Stages,
) -> Walls {
    let given = metres_per_pixel.filter(|m| m.is_finite() && *m > 0.0);
    let metres_per_pixel = given.unwrap_or_else(|| scale::guess(ink));
    let mut drawing = Drawing::of_sheet(ink, metres_per_pixel);
    let stroke = stroke::usual(&drawing);
    let mut lines = straight::runs(&drawing.ink, drawing.width);
    let mut sure = sure(&drawing, &lines, stroke, read);
    add_gates(&drawing, sheet, &mut sure);
    let leaders = leaders::ink(&drawing, &sure.solid, stroke, read.texts);
    let leaders = leaders.iter().zip(&sure.wall).map(|(l, w)| *l && !w).collect();
    erase(&mut drawing, &mut lines, leaders);
    let none = none_of_it(&drawing, &sure, read);
    erase(&mut drawing, &mut lines, none);
    let mut kinds = tell(&drawing, &lines, sure);
    let mut inside = inside::find(&drawing, &kinds.occupied);
    apart::remove(&drawing, read.symbols, &mut kinds.occupied, &mut inside);
    standing::remove(&drawing, &inside, &openings::all(&drawing, read.symbols), &mut kinds.occupied);
    let straightness = outline::straightness(&drawing, &kinds.occupied);
    let inside = drawing.on_sheet(&inside, ink);
    let occupied = drawing.on_sheet(&kinds.occupied, ink);
    stages.stage("walls", &mut || picture::of(&sheet.colour, &drawing, &kinds, &inside));
    let factor = drawing.factor as f64;
    let thickness = thickness(&drawing, &kinds) * factor;
    let confidence = confidence(&occupied, &inside);
    Walls { occupied, inside, stroke: stroke * factor, thickness, metres_per_pixel, straightness, confidence }
}

/// Takes ink away that is no wall.
fn erase(drawing: &mut Drawing, lines: &mut Straight, gone: Vec<bool>) {
    (0..gone.len()).filter(|&i| gone[i]).for_each(|i| {
        drawing.ink[i] = false;
        lines.length[i] = 0;
    });
}

/// What is wall whatever it parts: solid ink, bands and windows, but no doors.
struct Sure {
    solid: Vec<bool>,
    band: Vec<bool>,
    doors: Vec<bool>,
    wall: Vec<bool>,
}

fn sure(drawing: &Drawing, lines: &Straight, stroke: f64, read: Read) -> Sure {
    let doors = openings::doors(drawing, read.symbols);
    let solid = stroke::solid(drawing, stroke);
    let windows = openings::windows(drawing, read.symbols);
    let openings: Vec<bool> = doors.iter().zip(&windows).map(|(d, w)| *d || *w).collect();
    let mut band = outlined(drawing, &narrow::bands(drawing, lines, &openings, read.texts), stroke);
    windows.into_iter().zip(&mut band).for_each(|(w, b)| *b |= w);
    let wall = (0..band.len()).map(|i| (solid[i] || band[i]) && !doors[i]).collect();
    Sure { solid, band, doors, wall }
}

/// Adds gates that are drawn too faintly to be ink.
fn add_gates(drawing: &Drawing, sheet: &Sheet, sure: &mut Sure) {
    let faint = drawing.of_mask(&faint::lines(&sheet.grey, &sheet.ink));
    let gates = gates::find(drawing, &sure.wall, &faint);
    for i in (0..gates.len()).filter(|&i| gates[i] && !sure.doors[i]) {
        (sure.band[i], sure.wall[i]) = (true, true);
    }
}

/// Thin lines that are none of the building's, if the sure walls enclose most of what is enclosed by any line: then
/// they are its outer walls, and lines beyond them or through them are not.
fn none_of_it(drawing: &Drawing, sure: &Sure, read: Read) -> Vec<bool> {
    let count = |set: &[bool]| set.iter().filter(|&&s| s).count() as f64;
    let by_walls = inside::find(drawing, &sure.wall);
    let by_lines = inside::find(drawing, &drawing.ink);
    if count(&by_walls) < MOST * count(&by_lines) {
        return vec![false; drawing.ink.len()];
    }
    let leaving = leaving::lines(drawing, &by_walls);
    let beyond = beyond::ink(drawing, &by_walls, &by_lines, read);
    (0..leaving.len()).map(|i| (leaving[i] || beyond[i]) && !sure.wall[i]).collect()
}

/// Tells what is what.
fn tell(drawing: &Drawing, lines: &Straight, sure: Sure) -> Kinds {
    let Sure { solid, band, doors, wall } = sure;
    let span = bridges::Span { line: LINE * drawing.metre, reach: DOORWAY * drawing.metre };
    let mut bridge = bridges::find(&drawing.ink, &wall, lines, drawing.width, span);
    doors.iter().zip(&mut bridge).for_each(|(d, b)| *b |= d);
    let faces = Faces::find(drawing, &wall, &bridge);
    let rooms = Rooms::find(&faces, &faces.boundaries(drawing, lines, &doors));
    let mut occupied = wall;
    faces.contacts(drawing, |at, beside| {
        let apart = rooms.parts(faces.label[at], faces.label[beside]);
        let is_line = drawing.ink[at] || drawing.ink[beside] || !(bridge[at] || bridge[beside]);
        if apart && is_line {
            occupied[at] = true;
            occupied[beside] = true;
        }
    });
    doors.iter().zip(&mut occupied).for_each(|(d, o)| *o &= !d);
    Kinds { solid, band, occupied }
}

/// Bands with the lines along them.
fn outlined(drawing: &Drawing, band: &[bool], stroke: f64) -> Vec<bool> {
    let near = distance::within(band, drawing.width, stroke + 0.5);
    (0..band.len()).map(|i| band[i] || (drawing.ink[i] && near[i])).collect()
}

/// The median thickness of what is occupied, pixels, measured where walls are thickest.
fn thickness(drawing: &Drawing, kinds: &Kinds) -> f64 {
    let depth = distance::squared(&kinds.occupied, drawing.width);
    let is_ridge = |i: &usize| {
        let beside = components::Neighbours::Four.of(*i, drawing.width, drawing.height);
        depth[*i] > 0 && beside.into_iter().all(|b| depth[b] <= depth[*i])
    };
    let mut ridge: Vec<u32> = (0..depth.len()).filter(is_ridge).map(|i| depth[i]).collect();
    ridge.sort_unstable();
    ridge.get(ridge.len() / 2).map_or(0.0, |&d| 2.0 * f64::from(d).sqrt() - 1.0)
}

/// The share of floor in all that is inside or wall; 0 if there is no wall.
fn confidence(occupied: &Mask, inside: &Mask) -> f64 {
    let floor = inside.count().saturating_sub(occupied.count()) as f64;
    let walls = occupied.count() as f64;
    if walls == 0.0 { 0.0 } else { (floor / (floor + walls)).min(1.0) }
}

#[cfg(test)]
mod tests;
