//! Whether a picture is a map that is better read here: one with colours that robots' maps have.

use super::backdrop;
use super::decode::{self, Picture, is_picture};
use super::wide;
use planform_sdk::{Confidence, Kept, Probe, Source};

/// How many of the pixels lines may take at most.
const MOST_LINES: f64 = 0.12;

/// How many of the pixels lines take at least.
const FEWEST_LINES: f64 = 0.0002;

/// How many of the grey pixels have the three most frequent greys at least.
const FEW_GREYS: f64 = 0.85;

/// How near to white paper is, and how much darker than the light areas unknown space around a map is.
const PAPER: u8 = 245;
const DARKER: u8 = 20;

/// How much of the border may be as light as paper or as free space in a map.
const BORDER: f64 = 0.5;

/// A grey and those so near to it are one: JPEG blurs them a little. Paper that is lit unevenly has many more.
const NEAR: usize = 4;

/// How much of a map is light areas, and how much is dark, at least.
const SPACE: f64 = 0.03;
const WALLS: f64 = 0.003;

/// Pixels are taken to be this wide here, metres.
const RESOLUTION: f64 = 0.05;

/// How sure the adapter is by the first bytes: less than others that read plain maps, but so near that all take a look.
/// GIF pictures nobody else reads.
pub fn probe(probe: &Probe<'_>) -> Confidence {
    if is_picture(probe.head) {
        Confidence::because(52, "a picture, which may be a map with a robot's way drawn on it")
    } else {
        Confidence::no()
    }
}

/// How sure the adapter is by the whole picture. Plain maps are left to others, and so are drawings: those are on white
/// paper, or have more greys or colours.
pub fn look(source: &Source, kept: &Kept) -> Option<Confidence> {
    let colourless = || Some(Confidence::because(40, "it shows no map with colours of its own"));
    if decode::is_grey(&source.bytes) {
        return colourless();
    }
    let picture = match kept.get() {
        Some(kept) => decode::coloured(kept),
        None => decode::coloured(&decode::decode(&source.bytes).ok()?),
    };
    let Some(picture) = picture else { return colourless() };
    let coloured = picture.coloured();
    let backdrop = backdrop::find(&picture, &coloured, wide::radius(RESOLUTION));
    let back = backdrop.contains(&true);
    let lines = coloured.iter().zip(&backdrop).filter(|(c, b)| **c && !**b).count();
    let lines = lines as f64 / coloured.len() as f64;
    let greys: Vec<Option<u8>> = picture.greys().zip(&coloured).map(|(g, c)| g.filter(|_| !c)).collect();
    let counts = counts(&greys);
    let map = few(counts) >= FEW_GREYS
        && paper(&picture, lightest(&counts)) <= BORDER
        && lines <= MOST_LINES
        && spacious(&greys, picture.width);
    match (map, back, lines >= FEWEST_LINES) {
        (true, true, _) => Some(Confidence::because(92, "it shows a map with a colour for unknown space")),
        (true, false, true) => {
            Some(Confidence::because(92, "it shows a map with coloured lines drawn on it"))
        }
        _ => colourless(),
    }
}

/// Whether light areas and something dark are among the greys: free space and walls.
fn spacious(greys: &[Option<u8>], width: usize) -> bool {
    let tone = |range: std::ops::Range<u8>| greys.iter().map(move |g| g.is_some_and(|g| range.contains(&g)));
    let of_all = |n: usize| n as f64 / greys.len().max(1) as f64;
    let light = wide::areas(
        &tone(200..u8::MAX).zip(greys).map(|(t, g)| t || *g == Some(u8::MAX)).collect::<Vec<_>>(),
        width,
        wide::radius(RESOLUTION),
    );
    of_all(light.iter().filter(|l| **l).count()) >= SPACE
        && of_all(tone(0..100).filter(|t| *t).count()) >= WALLS
}

/// How many pixels have each grey.
fn counts(greys: &[Option<u8>]) -> [u64; 256] {
    let mut counts = [0; 256];
    greys.iter().flatten().for_each(|g| counts[usize::from(*g)] += 1);
    counts
}

/// The share of grey pixels that have the three most frequent greys, or greys next to them.
fn few(mut counts: [u64; 256]) -> f64 {
    let all = counts.iter().sum::<u64>().max(1);
    let mut few = 0;
    for _ in 0..3 {
        let most = (0..256).max_by_key(|g| (counts[*g], 256 - g)).unwrap_or(0);
        let near = most.saturating_sub(NEAR)..(most + NEAR + 1).min(256);
        few += counts[near.clone()].iter().sum::<u64>();
        counts[near].fill(0);
    }
    few as f64 / all as f64
}

/// The lightest grey that many pixels have: one in fifty is lighter at most.
fn lightest(counts: &[u64; 256]) -> u8 {
    let mut lighter = counts.iter().sum::<u64>() / 50;
    let is_dark_enough = |count: &u64| {
        let reached = *count > lighter;
        lighter = lighter.saturating_sub(*count);
        reached
    };
    counts.iter().rev().position(is_dark_enough).map_or(u8::MAX, |below| u8::MAX - below as u8)
}

/// The share of the border that is white, transparent, or about as light as the lightest areas.
fn paper(picture: &Picture, lightest: u8) -> f64 {
    let paper = PAPER.min(lightest.saturating_sub(DARKER));
    let greys: Vec<Option<u8>> = picture.greys().collect();
    let (width, height) = (picture.width, picture.height);
    let border: Vec<usize> = (0..greys.len())
        .filter(|i| i % width == 0 || i % width + 1 == width || i / width == 0 || i / width + 1 == height)
        .collect();
    let white = border.iter().filter(|i| greys[**i].is_none_or(|g| g >= paper)).count();
    white as f64 / border.len().max(1) as f64
}
