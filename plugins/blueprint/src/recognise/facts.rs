//! What a sample of a picture shows.

use super::counts::{Counts, FLAT, above, flat};
use super::sample::{CLEAR, Code, Sample};
use std::ops::Range;

/// Tones from this one on are white.
const WHITE: u8 = 246;

/// What is lighter than its surroundings is lighter by more than this.
const LIGHTER: u8 = 10;

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

impl Facts {
    /// Looks at a sample.
    pub fn of(sample: &Sample) -> Self {
        let surround = surround(sample);
        let light = match surround {
            Surround::Flat(tone) | Surround::Inside(tone) => above(tone, LIGHTER),
            _ => WHITE.into()..CLEAR,
        };
        Self {
            surround,
            colour: colour(sample, surround),
            light: sample.share(sample.tones.sum(light.clone())),
            light_areas: sample.in_areas(width(sample, AREA), light.clone()),
            page: is_page(sample, light),
        }
    }
}

/// A share of the longer side, pixels of the sample.
fn width(sample: &Sample, share: f64) -> u8 {
    ((sample.side() as f64 * share).round() as u8).max(4)
}

fn surround(sample: &Sample) -> Surround {
    let margin = margin(sample).common();
    match margin.tone {
        _ if margin.share < SAME => unknown_inside(sample).unwrap_or(Surround::Uneven),
        None => Surround::Transparent,
        Some(tone) if tone >= WHITE => unknown_inside(sample).unwrap_or(Surround::Paper),
        Some(tone) if is_lit_unevenly(sample, tone) => Surround::Uneven,
        Some(tone) => Surround::Flat(tone),
    }
}

/// The tones in the picture's margin.
fn margin(sample: &Sample) -> Counts {
    let depth = ((sample.side() as f64 * MARGIN).round() as usize).max(1);
    let in_margin = |y: usize| y < depth || y + depth >= sample.height;
    let rows = sample.rows().enumerate();
    Counts::of(rows.flat_map(|(y, row)| ends(row, if in_margin(y) { row.len() } else { depth })).flatten())
}

/// The first and the last pixels of a row, `depth` of them at either end.
fn ends(row: &[Code], depth: usize) -> [&[Code]; 2] {
    if 2 * depth >= row.len() { [row, &[]] } else { [&row[..depth], &row[row.len() - depth..]] }
}

/// The tone of unknown space that does not surround everything.
fn unknown_inside(sample: &Sample) -> Option<Surround> {
    behind_paper(sample).or_else(|| cut_through(sample)).map(Surround::Inside)
}

/// The flat grey that a map has beside white and black, where the map was cut out so closely that its free space or its
/// walls reach the picture's margin.
fn cut_through(sample: &Sample) -> Option<u8> {
    let between: Range<Code> = DARK.into()..WHITE.into();
    let margin = margin(sample);
    let greys = margin.within(between.clone());
    let most = greys.common();
    let tone = most.tone.filter(|_| most.share * greys.all() as f64 >= CUT * margin.all() as f64)?;
    let others = sample.tones.sum(0..between.start) + sample.tones.sum(between.end..CLEAR);
    let three = sample.share(others + sample.tones.within(between).sum(flat(tone)));
    (three >= THREE_TONES && is_grey(sample) && in_areas(sample, tone, CUT_AREA) >= CUT).then_some(tone)
}

fn is_grey(sample: &Sample) -> bool {
    sample.share(sample.coloured.all()) < PALE
}

/// The share of the picture that areas of a flat tone cover, if they are at least so wide.
fn in_areas(sample: &Sample, tone: u8, least: f64) -> f64 {
    sample.in_areas(width(sample, least), flat(tone))
}

/// The flat tone that lies all around behind white: a map was turned, or cut out, and the corners are white. A
/// drawing has strokes there, which are no areas.
fn behind_paper(sample: &Sample) -> Option<u8> {
    let first = first_tones(sample).common();
    let tone = first.tone.filter(|&tone| first.share >= SAME && tone >= DARK && is_grey(sample))?;
    (in_areas(sample, tone, BEHIND_AREA) >= BEHIND).then_some(tone)
}

/// What comes first behind white, from all four sides: the darkest tone within [`FIRST`] pixels.
fn first_tones(sample: &Sample) -> Counts {
    let of_rows = sample.rows().flat_map(|row| [first(row), first(row.iter().rev())]);
    let columns = (0..sample.width).map(|x| sample.column(x));
    let of_columns = columns.flat_map(|column| [first(column.clone()), first(column.rev())]);
    Counts::of(of_rows.chain(of_columns).flatten())
}

fn first<'a>(line: impl IntoIterator<Item = &'a Code>) -> Option<&'a Code> {
    // What is transparent has the largest code.
    line.into_iter().skip_while(|code| **code >= WHITE.into()).take(FIRST).min()
}

/// Whether what is a little lighter than the surroundings is as much as what a shadow makes.
fn is_lit_unevenly(sample: &Sample, tone: u8) -> bool {
    let little = above(tone, FLAT).start..above(tone, LIGHTER).start;
    sample.share(sample.tones.sum(little)) > SHADED
}

fn colour(sample: &Sample, surround: Surround) -> f64 {
    let of_surround = match surround {
        Surround::Flat(tone) | Surround::Inside(tone) => sample.coloured.sum(flat(tone)),
        _ => 0,
    };
    sample.share(sample.coloured.all() - of_surround)
}

/// Whether what is light is a sheet: its box is all paper along its sides, and something is drawn on it. The rooms of
/// a map have walls between them.
fn is_page(sample: &Sample, light: Range<Code>) -> bool {
    let Some([columns, rows]) = extent(sample, &light) else { return false };
    let depth = usize::from(width(sample, PAGE_MARGIN));
    if columns.len() <= 4 * depth || rows.len() <= 4 * depth {
        return false;
    }
    let paper = sample.tones.within(light).common().tone.unwrap_or(WHITE).saturating_sub(LIGHTER);
    let inside = [&columns, &rows].map(|range| range.start + depth..range.end - depth);
    let drawing = paper_in(sample, inside, paper);
    let [all, sheet] = paper_in(sample, [columns, rows], paper);
    let share = |[all, paper]: [usize; 2]| paper as f64 / all.max(1) as f64;
    let margin = [all - drawing[0], sheet - drawing[1]];
    share(margin) >= EMPTY && 1.0 - share(drawing) >= DRAWN
}

/// How many pixels a box of these columns and rows has, and how many of them are at least as light as paper.
fn paper_in(sample: &Sample, [columns, rows]: [Range<usize>; 2], paper: u8) -> [usize; 2] {
    let is_paper = |code: &&Code| (paper.into()..CLEAR).contains(*code);
    let lines = sample.rows().take(rows.end).skip(rows.start);
    let papers = lines.map(|row| row[columns.clone()].iter().filter(is_paper).count());
    [columns.len() * rows.len(), papers.sum()]
}

/// The columns and rows of the box around what is light.
fn extent(sample: &Sample, light: &Range<Code>) -> Option<[Range<usize>; 2]> {
    let is_light = |code: &Code| light.contains(code);
    let (mut left, mut right) = (sample.width, 0);
    let mut rows = 0..0;
    for (y, row) in sample.rows().enumerate() {
        // Only what lies beyond the box so far makes it wider.
        let first = row[..left].iter().position(is_light);
        let last = row[right..].iter().rposition(is_light);
        if first.is_none() && last.is_none() && !row.iter().any(is_light) {
            continue;
        }
        left = first.unwrap_or(left);
        right = last.map_or(right, |x| right + x + 1);
        rows = if rows.is_empty() { y..y + 1 } else { rows.start..y + 1 };
    }
    (!rows.is_empty()).then_some([left..right, rows])
}
