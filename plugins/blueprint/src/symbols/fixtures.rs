//! What is drawn in lines at its size in the building: toilets, sinks, a user's own symbols. Templates are searched for at
//! every place, at a coarse resolution first.

use super::library::{Action, Library, Template, Turned};
use super::shapes::{Box2, erase_inside};
use super::soft::Soft;
use super::zncc::{self, Searched};
use crate::found::SheetSymbol;
use crate::mask::Mask;
use crate::rows;
use std::f64::consts::TAU;

/// Metres per pixel of the search, and of the second look.
const COARSE: f64 = 0.05;
const FINE: f64 = 0.025;
/// Less than this, at first and at the second look, is chance.
const LEAST_COARSE: f64 = 0.6;
const LEAST_FINE: f64 = 0.7;
/// No more places than this are looked at a second time, the best ones.
const MOST_PLACES: usize = 150;
/// The picture is searched in squares of this many pixels, which the transform is quick with.
const TILE: u32 = 240;
/// Templates larger than this, metres, are not searched for.
const LARGEST: f64 = 3.0;
/// Turned by any angle means by so many.
const ANGLES: u32 = 16;
/// Each size is so many times the one before.
const SIZE_STEP: f64 = 1.2;
/// These are found by their geometry,
const ELSEWHERE: [&str; 2] = ["stairs", "lift"];
/// and these as well, but a user's own drawings may differ from all that is usual.
const USUAL: [&str; 2] = ["toilet", "sink"];

/// A template in one size and direction.
struct Look<'a> {
    template: &'a Template,
    drawing: usize,
    /// Length of the longer side, metres.
    size: f64,
    angle: f64,
    mirrored: bool,
    coarse: Soft,
}

/// A place that a look fits, metres.
struct Place {
    look: usize,
    centre: [f64; 2],
    score: f64,
}

/// All such symbols, and what draws them. `pixel` is metres per pixel of the ink.
pub fn find(ink: &Mask, library: &Library, pixel: f64, erase: &mut Mask) -> Vec<SheetSymbol> {
    let looks = looks(library);
    if looks.is_empty() {
        return Vec::new();
    }
    let coarse = picture(ink, COARSE / pixel).blurred();
    let places = places(&coarse, &looks);
    let fine = picture(ink, FINE / pixel).blurred();
    let mut found: Vec<SheetSymbol> =
        places.iter().filter_map(|p| second_look(&fine, &looks[p.look], p.centre, pixel)).collect();
    found = best(found);
    for symbol in &found {
        let keep = library.templates.iter().any(|t| t.kind == symbol.kind && t.action == Action::Keep);
        if !keep {
            erase_inside(ink, &Box2::of(symbol).grown([0.01 / pixel; 2]), erase);
        }
    }
    found
}

/// The ink so many times coarser.
fn picture(ink: &Mask, factor: f64) -> Soft {
    let size = |n: u32| ((f64::from(n) / factor).ceil() as u32).max(1);
    let (width, height) = (size(ink.width), size(ink.height));
    let mut values = vec![0.0; width as usize * height as usize];
    let column: Vec<usize> = (0..ink.width).map(|x| (f64::from(x) / factor) as usize).collect();
    for (y, row) in ink.set.chunks_exact(ink.width.max(1) as usize).enumerate() {
        let start = (y as f64 / factor) as usize * width as usize;
        for (x, _) in row.iter().enumerate().filter(|(_, s)| **s) {
            values[start + column[x]] += 1.0;
        }
    }
    // A line one pixel thick inks a share of 1 / factor of every pixel that it crosses.
    let full = (factor.max(1.0) * 1.5) as f32;
    values.iter_mut().for_each(|v| *v = (*v / full).min(1.0));
    Soft { width, height, values }
}

fn looks(library: &Library) -> Vec<Look<'_>> {
    let wanted = |t: &&Template| {
        let elsewhere = ELSEWHERE.contains(&&*t.kind) || !t.own && USUAL.contains(&&*t.kind);
        matches!(t.action, Action::Erase | Action::Keep) && !elsewhere
    };
    library.templates.iter().filter(wanted).flat_map(looks_of).collect()
}

fn looks_of(template: &Template) -> Vec<Look<'_>> {
    let Some([least, most]) = template.metres else { return Vec::new() };
    let angles = match template.turned {
        Turned::Upright => 1,
        Turned::Quarters => 4,
        Turned::Freely => ANGLES,
    };
    let mut looks = Vec::new();
    let mut size = least * 1.08;
    while size <= most.min(LARGEST) {
        for (drawing, k) in (0..template.drawings.len()).flat_map(|d| (0..angles).map(move |k| (d, k))) {
            let angle = TAU * f64::from(k) / f64::from(angles);
            for mirrored in [false, true].into_iter().filter(|m| !m || template.mirrored) {
                let coarse = rendered(template, drawing, [size, size], angle, mirrored, COARSE);
                looks.push(Look { template, drawing, size, angle, mirrored, coarse });
            }
        }
        size *= SIZE_STEP;
    }
    looks
}

/// A drawing at a resolution; `size` is what its longer side would be if it were so long along, and across.
fn rendered(t: &Template, drawing: usize, size: [f64; 2], angle: f64, mirrored: bool, metres: f64) -> Soft {
    let full = &t.drawings[drawing].ink;
    let longer = f64::from(full.width.max(full.height));
    let scaled = |n: u32, size: f64| ((f64::from(n) / longer * size / metres).round() as u32).max(2);
    let small = full.resized(scaled(full.width, size[0]), scaled(full.height, size[1]));
    let small = if mirrored { small.mirrored() } else { small };
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    let turned = if quarters.fract() == 0.0 { small.turned(quarters as u32) } else { small.rotated(angle) };
    let most = turned.values.iter().copied().fold(0.0, f32::max).max(1e-6);
    let strong = Soft { values: turned.values.iter().map(|v| (2.0 * v / most).min(1.0)).collect(), ..turned };
    strong.padded(1).blurred()
}

/// Where looks fit, tile by tile on all cores.
fn places(coarse: &Soft, looks: &[Look]) -> Vec<Place> {
    let largest = looks.iter().map(|l| l.coarse.width.max(l.coarse.height)).max().unwrap_or(0);
    let across = |n: u32| n.div_ceil(TILE);
    let count = across(coarse.width) * across(coarse.height);
    let corner = |k: u32| [k % across(coarse.width) * TILE, k / across(coarse.width) * TILE];
    let tiles = rows::map(count as usize, |k| in_tile(coarse, looks, corner(k as u32), largest));
    let mut found: Vec<Place> = tiles.into_iter().flatten().collect();
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    found.truncate(MOST_PLACES);
    found
}

fn in_tile(coarse: &Soft, looks: &[Look], [left, top]: [u32; 2], largest: u32) -> Vec<Place> {
    let get = |x: u32, y: u32| coarse.get(i64::from(left + x), i64::from(top + y));
    let tile = Soft::from_fn(TILE + largest, TILE + largest, get);
    if tile.values.iter().all(|&v| v == 0.0) {
        return Vec::new();
    }
    let searched = Searched::new(&tile, largest);
    let mut found = Vec::new();
    for (look, l) in looks.iter().enumerate() {
        let scores = searched.scores(&l.coarse);
        for (x, y, score) in peaks(&scores) {
            let metres = |at: u32, n: u32| (f64::from(at) + f64::from(n) / 2.0) * COARSE;
            let centre = [metres(left + x, l.coarse.width), metres(top + y, l.coarse.height)];
            found.push(Place { look, centre, score });
        }
    }
    strongest(found)
}

/// Of places close together only the few best ones are looked at again.
fn strongest(mut places: Vec<Place>) -> Vec<Place> {
    const REACH: f64 = 0.3;
    places.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<Place> = Vec::new();
    for place in places {
        let near = |k: &&Place| (0..2).all(|i| (k.centre[i] - place.centre[i]).abs() < REACH);
        if kept.iter().filter(near).count() < 3 {
            kept.push(place);
        }
    }
    kept
}

/// Places that score better than all around them.
fn peaks(scores: &Soft) -> Vec<(u32, u32, f64)> {
    let mut found = Vec::new();
    for (i, &score) in scores.values.iter().enumerate() {
        if f64::from(score) < LEAST_COARSE {
            continue;
        }
        let (x, y) = (i as u32 % scores.width, i as u32 / scores.width);
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (i64::from(x) + dx, i64::from(y) + dy)));
        if around.into_iter().all(|(nx, ny)| scores.get(nx, ny) <= score) && x < TILE && y < TILE {
            found.push((x, y, f64::from(score)));
        }
    }
    found
}

/// The look held against the finer picture, in slightly different sizes and places.
fn second_look(fine: &Soft, look: &Look, centre: [f64; 2], pixel: f64) -> Option<SheetSymbol> {
    let mut best: Option<(f64, [f64; 2], [f64; 2])> = None;
    for (a, b) in [0.9, 1.0, 1.1].into_iter().flat_map(|a| [0.82, 0.91, 1.0, 1.1].map(|b| (a, b))) {
        let size = [look.size * b, look.size * a];
        let drawn = rendered(look.template, look.drawing, size, look.angle, look.mirrored, FINE);
        for (dx, dy) in (-2..=2).flat_map(|dy| (-2..=2).map(move |dx| (dx, dy))) {
            let at = [centre[0] + f64::from(dx) * FINE, centre[1] + f64::from(dy) * FINE];
            let score = score_at(fine, &drawn, at);
            if best.is_none_or(|b| score > b.0) {
                best = Some((score, at, size));
            }
        }
    }
    let (score, at, size) = best.filter(|b| b.0 >= LEAST_FINE)?;
    let full = &look.template.drawings[look.drawing].ink;
    let longer = f64::from(full.width.max(full.height));
    let side = |n: u32, size: f64| f64::from(n) / longer * size / pixel;
    Some(SheetSymbol {
        kind: look.template.kind.clone(),
        centre: at.map(|v| v / pixel),
        angle: look.angle,
        width: side(full.width, size[0]),
        height: side(full.height, size[1]),
        score,
        leaves: Vec::new(),
    })
}

fn score_at(fine: &Soft, drawn: &Soft, at: [f64; 2]) -> f64 {
    let corner = |v: f64, n: u32| (v / FINE - f64::from(n) / 2.0).round() as i64;
    let (left, top) = (corner(at[0], drawn.width), corner(at[1], drawn.height));
    let get = |x: u32, y: u32| fine.get(left + i64::from(x), top + i64::from(y));
    zncc::score(&Soft::from_fn(drawn.width, drawn.height, get).values, &drawn.values)
}

/// The best of those that lie over each other.
fn best(mut found: Vec<SheetSymbol>) -> Vec<SheetSymbol> {
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<SheetSymbol> = Vec::new();
    for symbol in found {
        let over = |k: &SheetSymbol| {
            let reach = 0.4 * (k.width.max(k.height) + symbol.width.max(symbol.height)) / 2.0;
            (0..2).all(|i| (k.centre[i] - symbol.centre[i]).abs() < reach.max(1.0))
        };
        if !kept.iter().any(over) {
            kept.push(symbol);
        }
    }
    kept
}
