//! The search for lines of text on one sheet.

use super::components::{Bounds, Components, Run};
use super::context::{self, Place, Sure};
use super::crop::{self, Reading, Source};
use super::cut::{self, Cut};
use super::engine::{OcrEngines, OcrError, OcrWord};
use super::extras::{self, FullLine};
use super::glyph::{self, Glyph, Layer};
use super::lines::{self, Axis, Line};
use super::read::{self, Answer, Job};
use super::verdict::{self, Case};
use super::{plausible, shape};
use crate::found::SheetText;
use crate::mask::Mask;
use crate::sheet::Sheet;

/// Without reading, lines that look like text this much are, if they have so many letters.
const TEXT_BY_SHAPE: f64 = 0.6;
const LETTERS_BY_SHAPE: f64 = 3.0;
/// Lines that look like text less than this are not read.
const WORTH_READING: f64 = 0.2;
/// The most lines that are read, those first that look most like text.
const MOST_READ: usize = 4000;
/// A letter that stands alone is about as high as those in lines.
const SAME_HEIGHT: f64 = 0.35;

/// Strokes that bound a band are so near to what fills it, in heights of the line, and along so much of it.
const BAND: f64 = 0.2;
const BESIDE: f64 = 0.6;

/// A raised 2 is at most so high, at least so wide and stands at least so high over the line's foot, in heights of it.
const RAISED_HIGH: f64 = 0.8;
const RAISED_WIDE: f64 = 0.2;
const RAISED_BY: f64 = 0.25;

/// Lines and the parts they are made of.
pub struct Search {
    whole: Components,
    cut: Components,
    kept: Mask,
    ink: Mask,
    glyphs: Vec<Glyph>,
    /// All lines that may be text.
    pub lines: Vec<FullLine>,
}

/// A line that is text.
pub struct Found {
    /// Its parts.
    pub parts: Vec<(Layer, usize)>,
    /// What it says, if it was read.
    pub text: Option<SheetText>,
}

impl Search {
    /// Looks for lines among all ink of the sheet.
    pub fn of(sheet: &Sheet) -> Self {
        let ink = sheet.ink.clone().with(&sheet.aside);
        let (width, height) = (ink.width, ink.height);
        let tallest = glyph::tallest(width, height);
        let whole = Components::of(&ink);
        let mut glyphs = glyph::glyphs(&whole, Layer::Whole, tallest);
        let blocked = |axis, b| blocked(&ink, axis, b);
        let first = lines::lines(&glyphs, &blocked);
        let (cut, kept) = match letter_height(&first, &glyphs) {
            Some(letter) => {
                let letters = letters(&first, &glyphs, whole.list.len());
                let Cut { rest, kept } = cut::cut(&whole, &letters, (width, height), letter);
                (Components::of(&rest), kept)
            }
            None => (Components::default(), Mask::empty(width, height)),
        };
        glyphs.extend(glyph::glyphs(&cut, Layer::Cut, tallest));
        let lines = lines::lines(&glyphs, &blocked);
        let lines = extras::complete(lines, &glyphs, [&whole, &cut], tallest);
        Self { whole, cut, kept, ink, glyphs, lines }
    }

    /// The parts of a layer.
    pub fn parts(&self, layer: Layer) -> &Components {
        match layer {
            Layer::Whole => &self.whole,
            Layer::Cut => &self.cut,
        }
    }

    /// Marks those pixels of the parts that are ink of the drawing, and of no wall or line that a letter crosses.
    pub fn erase(&self, parts: &[(Layer, usize)], ink: &Mask, erase: &mut Mask) {
        for run in parts.iter().flat_map(|p| self.runs(p)) {
            let row = run.y as usize * ink.width as usize;
            for i in row + run.x0 as usize..row + run.x1 as usize {
                erase.set[i] |= ink.set[i] && !self.kept.set[i];
            }
        }
    }

    fn runs(&self, &(layer, part): &(Layer, usize)) -> &[Run] {
        let parts = self.parts(layer);
        parts.runs(&parts.list[part])
    }

    fn bounds(&self, &(layer, part): &(Layer, usize)) -> Bounds {
        self.parts(layer).list[part].bounds
    }

    /// Those lines that look like text.
    pub fn by_shape(&self, lines: Vec<FullLine>) -> Vec<Found> {
        let text = |l: &FullLine| {
            !self.fills_band(&l.line)
                && shape::likeness(&l.line, &self.glyphs) >= TEXT_BY_SHAPE
                && self.letters(&l.line) >= LETTERS_BY_SHAPE
        };
        lines.into_iter().filter(text).map(|l| Found { parts: l.parts, text: None }).collect()
    }

    fn letters(&self, line: &Line) -> f64 {
        let boxes: Vec<_> = line.glyphs.iter().map(|&g| line.axis.upright(self.glyphs[g].bounds)).collect();
        shape::letters(line, &boxes)
    }

    /// Those lines that read like text, with what they say.
    pub fn read(
        &self,
        lines: Vec<FullLine>,
        sheet: &Sheet,
        engines: &dyn OcrEngines,
    ) -> Result<Vec<Found>, OcrError> {
        let lines = self.worth_reading(lines);
        let job = |(line, likeness): &(FullLine, f64)| Job {
            axis: line.line.axis,
            letter: line.line.height,
            likeness: *likeness,
            letters: self.letters(&line.line),
        };
        let jobs: Vec<_> = lines.iter().map(job).collect();
        let source = Source { grey: &sheet.grey, ink: &self.ink };
        let picture = |i: usize| {
            let line: &FullLine = &lines[i].0;
            let runs: Vec<_> = line.parts.iter().map(|p| self.runs(p)).collect();
            crop::alone(&source, line.bounds, &runs)
        };
        let answers = read::read(&jobs, &picture, engines)?;
        Ok(self.found(self.judged(self.chosen(lines, answers))))
    }

    /// Each line the way round that it reads.
    fn chosen(&self, lines: Vec<(FullLine, f64)>, answers: Vec<Vec<Answer>>) -> Vec<Read> {
        let place = |l: &FullLine| Place { bounds: l.bounds, height: l.line.height };
        let sure: Vec<Sure> =
            lines.iter().zip(&answers).filter_map(|((l, _), a)| Sure::of(place(l), a)).collect();
        let read = lines.into_iter().zip(answers).filter_map(|((line, likeness), answers)| {
            let beside = context::beside(place(&line), &sure);
            let answer = context::choose(answers, self.letters(&line.line), beside)?;
            let raised = self.ends_raised(&line, answer.reading);
            Some(Read { beside: beside == Some(answer.reading), ..Read::of(line, likeness, answer, raised) })
        });
        read.collect()
    }

    /// Whether the line's last sign is a small raised one, as that of "m²", and no foot mark.
    fn ends_raised(&self, line: &FullLine, reading: Reading) -> bool {
        let boxes: Vec<_> = line.parts.iter().map(|p| reading.turned(self.bounds(p))).collect();
        let (Some(last), height) = (boxes.iter().max_by_key(|b| (b.x1, b.x0)), line.line.height) else {
            return false;
        };
        let mut feet: Vec<_> = boxes.iter().map(|b| b.y1).collect();
        feet.sort_unstable();
        // Of most letters: a q reaches lower.
        let foot = feet[feet.len() / 2];
        let part = |pixels: i32| f64::from(pixels) / height;
        part(last.height()) <= RAISED_HIGH
            && part(last.width()) >= RAISED_WIDE
            && part(foot - last.y1) >= RAISED_BY
    }

    /// Those that are text.
    fn judged(&self, read: Vec<Read>) -> Vec<Read> {
        let mut cases: Vec<_> = read.iter().map(|r| self.case(r)).collect();
        verdict::find_rows(&mut cases);
        let heights = verdict::heights(&cases);
        let text: Vec<_> = cases.iter().map(|c| verdict::is_text(c, &heights)).collect();
        read.into_iter().zip(text).filter_map(|(r, is_text)| is_text.then_some(r)).collect()
    }

    fn case<'a>(&self, read: &'a Read) -> Case<'a> {
        Case {
            text: &read.text,
            belief: read.answer.belief,
            likeness: read.likeness,
            height: read.line.line.height,
            cut: self.is_cut(&read.line.line),
            usual: matches!(read.answer.reading, Reading::Right | Reading::Up),
            level: f64::from(read.line.bounds.y0 + read.line.bounds.y1) / 2.0,
            beside: read.beside,
            in_row: false,
        }
    }

    /// The texts from the top down. Where two share a place, the better one is it, and the other's ink belongs to it.
    fn found(&self, mut read: Vec<Read>) -> Vec<Found> {
        read.sort_by(|a, b| b.weight().total_cmp(&a.weight()));
        let mut found: Vec<(Bounds, Found)> = Vec::new();
        for read in read {
            let Some(new) = self.text(&read) else { continue };
            match found.iter_mut().find(|(b, _)| shared(*b, read.line.bounds)) {
                Some((_, better)) => better.parts.extend(new.parts),
                None => found.push((read.line.bounds, new)),
            }
        }
        found.sort_by_key(|(b, _)| (b.y0, b.x0));
        found.into_iter().map(|(_, f)| f).collect()
    }

    /// Whether the line was cut out from between two strokes, as the hatching of a wall is.
    fn fills_band(&self, line: &Line) -> bool {
        let upright = line.axis.upright(line.bounds);
        let near = (BAND * line.height).ceil() as i32 + 1;
        let kept = |x: i32, y: i32| match line.axis {
            Axis::Across => self.kept.get(x.into(), y.into()),
            Axis::Along => self.kept.get(y.into(), x.into()),
        };
        let beside = |edge: i32| {
            let hit = |x: &i32| (edge - near..edge + near).any(|y| kept(*x, y));
            (upright.x0..upright.x1).filter(hit).count() as f64 >= BESIDE * f64::from(upright.width())
        };
        self.is_cut(line) && beside(upright.y0) && beside(upright.y1)
    }

    fn is_cut(&self, line: &Line) -> bool {
        2 * line.glyphs.iter().filter(|&&g| self.glyphs[g].layer == Layer::Cut).count() > line.glyphs.len()
    }

    /// The lines that may be text with their likeness to it, best first.
    fn worth_reading(&self, lines: Vec<FullLine>) -> Vec<(FullLine, f64)> {
        let lines = lines.into_iter().filter(|l| !self.fills_band(&l.line));
        let mut rated: Vec<_> = lines.map(|l| (shape::likeness(&l.line, &self.glyphs), l)).collect();
        let sure = rated.iter().filter(|(s, l)| *s >= TEXT_BY_SHAPE && l.line.glyphs.len() > 2);
        let heights: Vec<_> = sure.map(|(_, l)| l.line.height).collect();
        let usual = |h: f64| heights.is_empty() || heights.iter().any(|s| (h - s).abs() <= SAME_HEIGHT * s);
        rated.retain(|(s, l)| *s >= WORTH_READING && (l.line.glyphs.len() > 1 || usual(l.line.height)));
        rated.sort_by(|a, b| b.0.total_cmp(&a.0));
        rated.truncate(MOST_READ);
        rated.into_iter().map(|(s, l)| (l, s)).collect()
    }

    /// The line as text, without what was read beside it.
    fn text(&self, read: &Read) -> Option<Found> {
        let own = |p: &&(Layer, usize)| {
            !read.stray.iter().any(|w| covers(w, self.bounds(p), &read.line, &read.answer))
        };
        let parts: Vec<_> = read.line.parts.iter().filter(own).copied().collect();
        let bounds = parts.iter().map(|p| self.bounds(p)).reduce(Bounds::with)?;
        Some(Found { parts, text: Some(sheet_text(read, bounds)) })
    }
}

/// A line that was read.
struct Read {
    line: FullLine,
    likeness: f64,
    answer: Answer,
    /// What was read, without what is no word.
    text: String,
    words: Vec<OcrWord>,
    /// What is no word.
    stray: Vec<OcrWord>,
    /// Whether it belongs to a label of words that are sure.
    beside: bool,
}

impl Read {
    fn of(line: FullLine, likeness: f64, mut answer: Answer, raised: bool) -> Self {
        if raised {
            plausible::square(&mut answer.words);
        }
        let (words, stray) = plausible::parted(&answer.words);
        let text = plausible::mended(&plausible::joined(&words));
        Self { line, likeness, text, words, stray, answer, beside: false }
    }

    fn weight(&self) -> f64 {
        self.answer.belief * plausible::alphanumerics(&self.text) as f64
    }
}

/// Whether two boxes share more than half of the smaller one.
fn shared(a: Bounds, b: Bounds) -> bool {
    let area = |b: Bounds| i64::from(b.width().max(0)) * i64::from(b.height().max(0));
    let both = Bounds { x0: a.x0.max(b.x0), y0: a.y0.max(b.y0), x1: a.x1.min(b.x1), y1: a.y1.min(b.y1) };
    2 * area(both) > area(a).min(area(b))
}

/// Whether the word's box in the picture that was read holds the part's middle.
fn covers(word: &OcrWord, part: Bounds, line: &FullLine, answer: &Answer) -> bool {
    let area = line.bounds;
    let [x, y] = part.middle();
    let (along, length) = match answer.reading {
        Reading::Right => (x - f64::from(area.x0), area.width()),
        Reading::Left => (f64::from(area.x1) - x, area.width()),
        Reading::Down => (y - f64::from(area.y0), area.height()),
        Reading::Up => (f64::from(area.y1) - y, area.height()),
    };
    let at = crop::along(along, f64::from(length), answer.width);
    (f64::from(word.bounds[0])..=f64::from(word.bounds[2])).contains(&at)
}

fn sheet_text(read: &Read, bounds: Bounds) -> SheetText {
    let reading = read.answer.reading;
    let (w, h) = (f64::from(bounds.width()), f64::from(bounds.height()));
    let upright = matches!(reading, Reading::Right | Reading::Left);
    let (width, height) = if upright { (w, h) } else { (h, w) };
    SheetText {
        content: read.text.clone(),
        centre: bounds.middle(),
        angle: reading.angle(),
        width,
        height,
        confidence: plausible::confidence(&read.words),
    }
}

/// Lines that are surely text.
fn sure<'a>(lines: &'a [Line], glyphs: &'a [Glyph]) -> impl Iterator<Item = &'a Line> {
    lines.iter().filter(|l| l.glyphs.len() > 2 && shape::likeness(l, glyphs) >= TEXT_BY_SHAPE)
}

/// The height of most letters in what is surely text, pixels.
fn letter_height(lines: &[Line], glyphs: &[Glyph]) -> Option<f64> {
    let all = sure(lines, glyphs).flat_map(|l| std::iter::repeat_n(l.height, l.glyphs.len()));
    let mut heights: Vec<_> = all.collect();
    heights.sort_by(f64::total_cmp);
    heights.get(heights.len() / 2).copied()
}

/// For each part of the ink whether it is surely a letter.
fn letters(lines: &[Line], glyphs: &[Glyph], parts: usize) -> Vec<bool> {
    let mut letters = vec![false; parts];
    sure(lines, glyphs).flat_map(|l| &l.glyphs).for_each(|&g| letters[glyphs[g].part] = true);
    letters
}

/// Whether a stroke is drawn through the whole box, across the line.
fn blocked(ink: &Mask, axis: Axis, b: Bounds) -> bool {
    let b = axis.upright(b);
    let at = |x: i32, y: i32| match axis {
        Axis::Across => ink.get(x.into(), y.into()),
        Axis::Along => ink.get(y.into(), x.into()),
    };
    b.width() > 0 && b.height() > 0 && (b.y0..b.y1).all(|y| (b.x0..b.x1).any(|x| at(x, y)))
}
