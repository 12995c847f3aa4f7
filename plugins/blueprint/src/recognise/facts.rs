//! What a sample of a picture shows.

use super::sample::{Sample, Tone};

/// Tones from this one on are white.
const WHITE: u8 = 246;

/// What is lighter than its surroundings is lighter by more than this.
const LIGHTER: u8 = 10;

/// A flat tone varies by at most this much, also where it was compressed.
const FLAT: u8 = 3;

/// The least share of the surroundings that is one tone, if they are flat.
const SAME: f64 = 0.55;

/// An area is at least this share of the longer side wide; strokes are thinner.
const AREA: f64 = 0.015;

/// The picture's margin, in which its surroundings are looked at, as a share of the longer side.
const MARGIN: f64 = 0.01;

/// Tones below this one are the black of walls.
const DARK: u8 = 60;

/// Areas behind white are at least this share of the longer side wide; filled walls are thinner.
const BEHIND_AREA: f64 = 0.05;

/// The least share of the picture that they cover.
const BEHIND: f64 = 0.05;

/// Where a map was cut out closely, at least this share of its margin and of all of it is unknown space.
const CUT: f64 = 0.02;

/// Areas of it are at least this share of the longer side wide.
const CUT_AREA: f64 = 0.025;

/// At least this share of the picture is white, black or that grey.
const THREE_TONES: f64 = 0.7;

/// With less than this share coloured, a picture is grey.
const PALE: f64 = 0.01;

/// How far behind white the first tone is looked for, pixels: what lies there is past the blurred edge.
const FIRST: usize = 4;

/// With more than this share a little lighter than the surroundings, the light is uneven.
const SHADED: f64 = 0.1;

/// The margin of a sheet that has to be empty, as a share of the picture's longer side.
const PAGE_MARGIN: f64 = 0.015;

/// The least share of that margin that is light.
const EMPTY: f64 = 0.997;

/// The least share of a sheet that is drawn on.
const DRAWN: f64 = 0.015;

/// What surrounds the building.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surround {
    /// White, or the lightest tone of the picture.
    Paper,
    /// Nothing: the picture is transparent there.
    Transparent,
    /// One tone that is not the lightest one.
    Flat(u8),
    /// White, or many tones, but behind it one flat tone that is not the lightest one.
    Inside(u8),
    /// Many tones.
    Uneven,
}

/// What tells a drawing from a map. Shares are of the whole picture.
#[derive(Debug)]
pub struct Facts {
    /// What surrounds the building.
    pub surround: Surround,
    /// The share that is coloured, the surroundings' own tone left out.
    pub colour: f64,
    /// The share that is lighter than the surroundings.
    pub light: f64,
    /// The share that is lighter and lies in areas.
    pub light_areas: f64,
    /// Whether what is lighter is one sheet of paper with an empty margin.
    pub page: bool,
}

/// A flat tone and the share of the places looked at that have it.
#[derive(Debug, Clone, Copy)]
struct Common {
    tone: Tone,
    share: f64,
}

impl Facts {
    /// Looks at a sample.
    pub fn of(sample: &Sample) -> Self {
        let surround = surround(sample);
        let above = match surround {
            Surround::Flat(tone) | Surround::Inside(tone) => tone.saturating_add(LIGHTER),
            _ => WHITE - 1,
        };
        let is_light = |i: usize| sample.tones[i].is_some_and(|tone| tone > above);
        let areas = sample.areas(width(sample, AREA), is_light);
        Self {
            surround,
            colour: colour(sample, surround),
            light: sample.share(is_light),
            light_areas: sample.share(|i| areas[i]),
            page: is_page(sample, is_light),
        }
    }
}

/// A share of the longer side, pixels of the sample.
fn width(sample: &Sample, share: f64) -> usize {
    ((sample.side() as f64 * share).round() as usize).max(4)
}

fn surround(sample: &Sample) -> Surround {
    let margin = common(&margin(sample));
    match margin.tone {
        _ if margin.share < SAME => unknown_inside(sample).unwrap_or(Surround::Uneven),
        None => Surround::Transparent,
        Some(tone) if tone >= WHITE => unknown_inside(sample).unwrap_or(Surround::Paper),
        Some(tone) if is_lit_unevenly(sample, tone) => Surround::Uneven,
        Some(tone) => Surround::Flat(tone),
    }
}

/// The tones in the picture's margin.
fn margin(sample: &Sample) -> Vec<Tone> {
    let depth = ((sample.side() as f64 * MARGIN).round() as usize).max(1);
    let outside = |at: usize, length: usize| at < depth || at + depth >= length;
    let places = (0..sample.tones.len())
        .filter(|i| outside(i % sample.width, sample.width) || outside(i / sample.width, sample.height));
    places.map(|i| sample.tones[i]).collect()
}

/// The most common flat tone.
fn common(tones: &[Tone]) -> Common {
    let mut counts = [0usize; 256];
    tones.iter().flatten().for_each(|&tone| counts[usize::from(tone)] += 1);
    let around = |tone: u8| {
        let range = usize::from(tone.saturating_sub(FLAT))..=usize::from(tone.saturating_add(FLAT));
        counts[range].iter().sum::<usize>()
    };
    // Of the tones around which as many lie, the most common one.
    let key = |&tone: &u8| (around(tone), counts[usize::from(tone)]);
    let best = (0..=u8::MAX).max_by_key(key).unwrap_or(u8::MAX);
    let clear = tones.iter().filter(|tone| tone.is_none()).count();
    let (tone, count) = if clear > around(best) { (None, clear) } else { (Some(best), around(best)) };
    Common { tone, share: count as f64 / tones.len().max(1) as f64 }
}

/// The tone of unknown space that does not surround everything.
fn unknown_inside(sample: &Sample) -> Option<Surround> {
    behind_paper(sample).or_else(|| cut_through(sample)).map(Surround::Inside)
}

/// The flat grey that a map has beside white and black, where the map was cut out so closely that its free space or its
/// walls reach the picture's margin.
fn cut_through(sample: &Sample) -> Option<u8> {
    let greys: Vec<Tone> = margin(sample);
    let between = |tone: &Tone| tone.is_some_and(|t| (DARK..WHITE).contains(&t));
    let count = greys.len();
    let greys: Vec<Tone> = greys.into_iter().filter(between).collect();
    let most = common(&greys);
    let tone = most.tone.filter(|_| most.share * greys.len() as f64 >= CUT * count as f64)?;
    let near = |t: u8| t.abs_diff(tone) <= FLAT;
    let three = sample.share(|i| sample.tones[i].is_some_and(|t| !(DARK..WHITE).contains(&t) || near(t)));
    (three >= THREE_TONES && is_grey(sample) && in_areas(sample, tone, CUT_AREA) >= CUT).then_some(tone)
}

fn is_grey(sample: &Sample) -> bool {
    sample.share(|i| sample.coloured[i]) < PALE
}

/// The share of the picture that areas of a flat tone cover, if they are at least so wide.
fn in_areas(sample: &Sample, tone: u8, least: f64) -> f64 {
    let near = |i: usize| sample.tones[i].is_some_and(|t| t.abs_diff(tone) <= FLAT);
    let areas = sample.areas(width(sample, least), near);
    sample.share(|i| areas[i])
}

/// The flat tone that lies all around behind white: a map was turned, or cut out, and the corners are white. A
/// drawing has strokes there, which are no areas.
fn behind_paper(sample: &Sample) -> Option<u8> {
    let first = common(&first_tones(sample));
    let tone = first.tone.filter(|&tone| first.share >= SAME && tone >= DARK && is_grey(sample))?;
    (in_areas(sample, tone, BEHIND_AREA) >= BEHIND).then_some(tone)
}

/// What comes first behind white, from all four sides: the darkest tone within [`FIRST`] pixels.
fn first_tones(sample: &Sample) -> Vec<Tone> {
    let (width, height) = (sample.width, sample.height);
    let rows = (0..height).map(|y| (0..width).map(|x| sample.tone(x, y)).collect());
    let columns = (0..width).map(|x| (0..height).map(|y| sample.tone(x, y)).collect());
    let lines: Vec<Vec<Tone>> = rows.chain(columns).collect();
    let both = lines.iter().flat_map(|line| [first(line.iter()), first(line.iter().rev())]);
    both.flatten().map(Some).collect()
}

fn first<'a>(line: impl Iterator<Item = &'a Tone>) -> Option<u8> {
    let behind = line.skip_while(|tone| tone.is_none_or(|t| t >= WHITE));
    behind.take(FIRST).flatten().copied().min()
}

/// Whether what is a little lighter than the surroundings is as much as what a shadow makes.
fn is_lit_unevenly(sample: &Sample, tone: u8) -> bool {
    let little = |t: u8| t > tone.saturating_add(FLAT) && t <= tone.saturating_add(LIGHTER);
    sample.share(|i| sample.tones[i].is_some_and(little)) > SHADED
}

fn colour(sample: &Sample, surround: Surround) -> f64 {
    let of_surround = |tone: Tone| match (surround, tone) {
        (Surround::Flat(s) | Surround::Inside(s), Some(t)) => t.abs_diff(s) <= FLAT,
        _ => false,
    };
    sample.share(|i| sample.coloured[i] && !of_surround(sample.tones[i]))
}

/// Whether what is light is a sheet: its box is all paper along its sides, and something is drawn on it. The rooms of
/// a map have walls between them.
fn is_page(sample: &Sample, is_light: impl Fn(usize) -> bool) -> bool {
    let Some([left, top, right, bottom]) = extent(sample, &is_light) else { return false };
    let depth = width(sample, PAGE_MARGIN);
    if right - left < 4 * depth || bottom - top < 4 * depth {
        return false;
    }
    let light: Vec<Tone> =
        (0..sample.tones.len()).filter(|&i| is_light(i)).map(|i| sample.tones[i]).collect();
    let paper = common(&light).tone.unwrap_or(WHITE).saturating_sub(LIGHTER);
    let mut paper_of = [[0usize; 2]; 2];
    for y in top..=bottom {
        for x in left..=right {
            let inside = x >= left + depth && x + depth <= right && y >= top + depth && y + depth <= bottom;
            let is_paper = sample.tone(x, y).is_some_and(|t| t >= paper);
            paper_of[usize::from(inside)][usize::from(is_paper)] += 1;
        }
    }
    let [margin, drawing] = paper_of.map(|[other, paper]| paper as f64 / (other + paper).max(1) as f64);
    margin >= EMPTY && 1.0 - drawing >= DRAWN
}

/// The box around what is light: its left, top, right and bottom.
fn extent(sample: &Sample, is_light: impl Fn(usize) -> bool) -> Option<[usize; 4]> {
    let places = (0..sample.tones.len()).filter(|&i| is_light(i));
    places.map(|i| (i % sample.width, i / sample.width)).fold(None, |found: Option<[usize; 4]>, (x, y)| {
        let [left, top, right, bottom] = found.unwrap_or([x, y, x, y]);
        Some([left.min(x), top.min(y), right.max(x), bottom.max(y)])
    })
}
