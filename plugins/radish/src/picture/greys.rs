//! What the greys of a map picture mean.
//!
//! The frequent greys are the peaks of the histogram. Where the robot's way is drawn, it went through free space. Without
//! that, unknown is the grey of the picture's border, if another grey fills wide areas inside; free is the lightest of
//! the other wide ones, and walls are the grey that is farthest from free, but for unknown.

use super::wide;
use super::{Lines, PictureParams};
use planform_sdk::{Cell, ErrorKind, PluginError};

/// The least share of the pixels that a frequent grey has.
const FREQUENT: f64 = 0.003;

/// The least share of the pixels in wide areas of a grey that space has.
const WIDE: f64 = 0.02;

/// How far apart frequent greys are at least.
const APART: u8 = 14;

/// How far from unknown's grey a pixel is unknown at most.
const REACH: u8 = 12;

/// The least share of the border that unknown has.
const BORDER: f64 = 0.5;

/// The least share of the pixels beside lines that free space has.
const BESIDE: f64 = 0.5;

/// The greys of free space, of walls and of unknown space, if any is grey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// Free space.
    pub free: u8,
    /// Walls.
    pub wall: u8,
    /// Unknown space.
    pub unknown: Option<u8>,
}

impl Meaning {
    /// What a grey says; none is unknown.
    pub fn cell(&self, grey: Option<u8>) -> Cell {
        match grey {
            Some(grey) if !self.is_unknown(grey) => Cell::percent(self.percent(grey)),
            _ => Cell::UNKNOWN,
        }
    }

    /// How far on the way from free to wall, percent.
    fn percent(&self, grey: u8) -> u8 {
        let span = f64::from(self.wall) - f64::from(self.free);
        let share = (f64::from(grey) - f64::from(self.free)) / span;
        (100.0 * share.clamp(0.0, 1.0)).round() as u8
    }

    fn is_unknown(&self, grey: u8) -> bool {
        self.unknown.is_some_and(|unknown| {
            let others = unknown.abs_diff(self.free).min(unknown.abs_diff(self.wall));
            grey.abs_diff(unknown) <= REACH.min(others / 2)
        })
    }

    /// For the user's eyes.
    pub fn in_words(&self) -> String {
        let unknown = self.unknown.map_or("no grey".into(), |grey| format!("grey {grey}"));
        format!("grey {} is taken for free, {} for wall and {unknown} for unknown", self.free, self.wall)
    }
}

/// A frequent grey.
#[derive(Clone, Copy, Debug)]
struct Mode {
    grey: u8,
    /// Shares of the pixels in wide areas, of the border, and of the pixels beside lines.
    wide: f64,
    border: f64,
    beside: f64,
    /// Share of all pixels.
    all: f64,
}

/// What the greys mean; `drawn` are the pixels of lines, which do not count.
pub fn find(
    shades: &[Option<u8>],
    drawn: &[bool],
    width: usize,
    radius: usize,
    params: &PictureParams,
) -> Result<Meaning, PluginError> {
    let modes = modes(shades, drawn, width, radius);
    let backed = backed(shades, width);
    let unknown = params.unknown.or_else(|| unknown(&modes, backed, params));
    let other = |mode: &&Mode| unknown.is_none_or(|u| u.abs_diff(mode.grey) >= APART);
    let free = params.free.or_else(|| free(&modes, params, &other)).unwrap_or(255);
    let farthest = modes.iter().filter(other).map(|m| m.grey).max_by_key(|g| (g.abs_diff(free), u8::MAX - g));
    let wall = params.wall.or(farthest.filter(|g| g.abs_diff(free) >= APART)).unwrap_or(if free < 128 {
        255
    } else {
        0
    });
    if wall == free {
        return Err(PluginError::new(
            ErrorKind::BadOption,
            format!("walls and free space have the same grey {free}"),
        )
        .advise("give the options `free-grey` and `wall-grey` different values"));
    }
    Ok(Meaning { free, wall, unknown })
}

/// The grey of unknown: that of the border, unless it is where the robot went or no other grey is space.
fn unknown(modes: &[Mode], backed: bool, params: &PictureParams) -> Option<u8> {
    let around = modes.iter().max_by(|a, b| a.border.total_cmp(&b.border))?;
    let spaces = || modes.iter().filter(|m| m.wide >= WIDE);
    let others = spaces().filter(|m| m.grey != around.grey).count();
    let given = params.free.is_some_and(|free| free.abs_diff(around.grey) < APART);
    let is = !backed && around.border >= BORDER && around.beside < BESIDE && others > 0 && !given;
    if is {
        return Some(around.grey);
    }
    // A wide grey between the lightest space and the darkest grey.
    let lightest = spaces().map(|m| m.grey).max()?;
    let darkest = modes.iter().map(|m| m.grey).min()?;
    let between = spaces().filter(|m| m.grey < lightest && m.grey > darkest && m.beside < BESIDE);
    between.max_by(|a, b| a.wide.total_cmp(&b.wide)).map(|m| m.grey)
}

/// The grey of free space: the one that lines were drawn on, or else the widest of those that are not unknown, or the
/// lightest where two are about as wide.
fn free(modes: &[Mode], params: &PictureParams, other: &dyn Fn(&&Mode) -> bool) -> Option<u8> {
    let drawn_on = modes.iter().filter(other).max_by(|a, b| a.beside.total_cmp(&b.beside));
    if let Some(mode) = drawn_on.filter(|m| m.beside >= BESIDE && params.lines == Lines::Remove) {
        return Some(mode.grey);
    }
    let widest = modes.iter().filter(other).map(|m| m.wide).fold(0.0, f64::max);
    let spaces = modes.iter().filter(other).filter(|m| m.wide >= widest / 3.0);
    spaces.max_by(|a, b| a.grey.cmp(&b.grey)).map(|m| m.grey)
}

/// Whether most of the border is unknown by its colour.
fn backed(shades: &[Option<u8>], width: usize) -> bool {
    let none = border(shades.len(), width).filter(|i| shades[*i].is_none()).count();
    none as f64 >= BORDER * border(shades.len(), width).count() as f64
}

fn border(pixels: usize, width: usize) -> impl Iterator<Item = usize> {
    let (width, height) = (width.max(1), pixels / width.max(1));
    (0..pixels).filter(move |i| {
        let (x, y) = (i % width, i / width);
        x == 0 || y == 0 || x + 1 == width || y + 1 == height
    })
}

/// The frequent greys, the most frequent first.
fn modes(shades: &[Option<u8>], drawn: &[bool], width: usize, radius: usize) -> Vec<Mode> {
    let plain: Vec<Option<u8>> = shades.iter().zip(drawn).map(|(s, drawn)| s.filter(|_| !drawn)).collect();
    let histogram = histogram(plain.iter().flatten());
    let total = plain.iter().flatten().count().max(1) as f64;
    let near = wide::near(drawn, width, 2);
    let beside: Vec<Option<u8>> = plain.iter().zip(&near).map(|(p, near)| p.filter(|_| *near)).collect();
    let edge: Vec<Option<u8>> = border(plain.len(), width).map(|i| plain[i]).collect();
    let mut greys: Vec<u8> = (0..=u8::MAX).collect();
    greys.sort_by_key(|g| std::cmp::Reverse(histogram[usize::from(*g)]));
    let mut modes: Vec<Mode> = vec![];
    for grey in greys {
        let is = |shade: &Option<u8>| shade.is_some_and(|s| s.abs_diff(grey) < APART / 2);
        let all = plain.iter().filter(|s| is(s)).count() as f64 / total;
        if histogram[usize::from(grey)] == 0 || modes.iter().map(|m| m.all).sum::<f64>() > 0.999 {
            break;
        }
        if all < FREQUENT || modes.iter().any(|m| m.grey.abs_diff(grey) < APART) {
            continue;
        }
        let areas = wide::areas(&plain.iter().map(is).collect::<Vec<_>>(), width, radius);
        let wide = areas.iter().filter(|a| **a).count() as f64 / plain.len().max(1) as f64;
        modes.push(Mode { grey, wide, border: share(&edge, is), beside: share(&beside, is), all });
        if modes.len() == 8 {
            break;
        }
    }
    modes
}

/// The share of the greys that fulfil a condition.
fn share(greys: &[Option<u8>], is: impl Fn(&Option<u8>) -> bool) -> f64 {
    let all = greys.iter().flatten().count().max(1);
    greys.iter().filter(|g| is(g)).count() as f64 / all as f64
}

fn histogram<'a>(greys: impl Iterator<Item = &'a u8>) -> [u64; 256] {
    let mut counts = [0; 256];
    greys.for_each(|grey| counts[usize::from(*grey)] += 1);
    counts
}
