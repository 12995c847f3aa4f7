//! Letters beside each other become lines: first each letter is linked with its nearest neighbour in reading direction,
//! across and along the sheet; a letter that has neighbours in both belongs to the direction in which they are nearer,
//! as letters stand closer than lines.

use super::components::Bounds;
use super::glyph::Glyph;

/// The farthest that letters of one chain are apart, in heights of the taller.
const LETTER_GAP: f64 = 1.0;
/// The same of letters that no word stands beside.
const CLOSE: f64 = 0.6;
/// How much they may overlap along the line, in widths of the narrower.
const LETTER_OVERLAP: f64 = 0.4;
/// How far apart words of a line are at most, in heights of the line.
const WORD_GAP: f64 = 1.6;
/// The same of a letter that stands alone: it is more often something else.
const SINGLE_GAP: f64 = 1.3;
/// How much taller than another letter one is at most.
const HEIGHT_RATIO: f64 = 2.2;
/// How much taller than another word of a line one is at most.
const WORD_RATIO: f64 = 1.5;
/// The same of a letter that stands alone: the x of "3.1 x 4.2".
const LETTER_RATIO: f64 = 2.0;
/// How much of the lower letter's height both have in common, at least.
const COMMON: f64 = 0.5;

/// Along which of the sheet's sides a line runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// From left to right, or upside down.
    Across,
    /// Upwards or downwards.
    Along,
}

/// Letters in one line, sorted along it.
#[derive(Debug, Clone)]
pub struct Line {
    /// Its direction.
    pub axis: Axis,
    /// Indices of its letters.
    pub glyphs: Vec<usize>,
    /// The box around them.
    pub bounds: Bounds,
    /// Height of its tall letters across it, pixels.
    pub height: f64,
}

impl Axis {
    /// The box as it is when the line runs from left to right.
    pub fn upright(self, b: Bounds) -> Bounds {
        match self {
            Self::Across => b,
            Self::Along => b.transposed(),
        }
    }
}

impl Line {
    /// A line of these letters, of which there must be at least one.
    pub fn of(axis: Axis, mut members: Vec<usize>, glyphs: &[Glyph]) -> Option<Self> {
        members.sort_by_key(|&g| (axis.upright(glyphs[g].bounds).x0, g));
        let bounds = members.iter().map(|&g| glyphs[g].bounds).reduce(Bounds::with)?;
        let mut heights: Vec<_> = members.iter().map(|&g| axis.upright(glyphs[g].bounds).height()).collect();
        heights.sort_unstable();
        let height = f64::from(heights[heights.len() * 4 / 5]);
        Some(Self { axis, glyphs: members, bounds, height })
    }
}

/// All letters in lines, also those that stand alone. `blocked` says whether a line is drawn between two words: through
/// the whole height of the box that it is given.
pub fn lines(glyphs: &[Glyph], blocked: &dyn Fn(Axis, Bounds) -> bool) -> Vec<Line> {
    let across = Chains::of(glyphs, Axis::Across);
    let along = Chains::of(glyphs, Axis::Along);
    let upright: Vec<bool> =
        (0..glyphs.len()).map(|g| across.cost(g, glyphs) <= along.cost(g, glyphs)).collect();
    let across = across.words(glyphs, &|g| upright[*g]);
    let along = along.words(glyphs, &|g| !upright[*g]);
    let mut alone = vec![false; glyphs.len()];
    across.iter().chain(&along).filter(|w| w.glyphs.len() == 1).for_each(|w| alone[w.glyphs[0]] = true);
    let mut lines = join_alone(glyphs, Axis::Across, across, &mut alone, blocked);
    lines.extend(join_alone(glyphs, Axis::Along, along, &mut alone, blocked));
    let single = |g| Line::of(Axis::Across, vec![g], glyphs);
    lines.extend((0..glyphs.len()).filter(|&g| alone[g]).filter_map(single));
    lines
}

/// Joins the words along an axis and the letters that stand alone into lines of more than one letter. Those of the
/// letters that are in one stand alone no more; two of them without a word are no line.
fn join_alone(
    glyphs: &[Glyph],
    axis: Axis,
    words: Vec<Line>,
    alone: &mut [bool],
    blocked: &dyn Fn(Axis, Bounds) -> bool,
) -> Vec<Line> {
    let words = words.into_iter().filter(|w| w.glyphs.len() > 1);
    let singles = (0..glyphs.len()).filter(|&g| alone[g]).filter_map(|g| Line::of(axis, vec![g], glyphs));
    let mut lines = join_words(glyphs, words.chain(singles).collect(), blocked);
    lines.retain(|l| l.glyphs.iter().any(|&g| !alone[g]) || (l.glyphs.len() > 1 && is_close(l, glyphs)));
    lines.iter().flat_map(|l| &l.glyphs).for_each(|&g| alone[g] = false);
    lines
}

/// Whether the letters stand as close as those of a word.
fn is_close(line: &Line, glyphs: &[Glyph]) -> bool {
    let boxes: Vec<_> = line.glyphs.iter().map(|&g| line.axis.upright(glyphs[g].bounds)).collect();
    boxes.windows(2).all(|p| f64::from(p[1].x0 - p[0].x1) <= CLOSE * line.height)
}

/// Letters linked along one axis.
struct Chains {
    axis: Axis,
    /// For each letter the number of its chain.
    chain: Vec<usize>,
    /// The links: letter, next letter.
    links: Vec<(usize, usize)>,
    /// The median gap in each chain, pixels; infinite where it is of one letter.
    gaps: Vec<f64>,
    /// The links in each chain.
    counts: Vec<u32>,
}

impl Chains {
    fn of(glyphs: &[Glyph], axis: Axis) -> Self {
        let boxes: Vec<_> = glyphs.iter().map(|g| axis.upright(g.bounds)).collect();
        let next = nearest_to_the_right(&boxes, &|a, b| linked(glyphs, &boxes, a, b));
        let links: Vec<_> = next.iter().enumerate().filter_map(|(a, b)| Some((a, (*b)?))).collect();
        let chain = sets(glyphs.len(), &links);
        let gaps = median_gaps(&boxes, &chain, &links);
        let mut counts = vec![0; glyphs.len()];
        links.iter().for_each(|&(a, _)| counts[chain[a]] += 1);
        Self { axis, chain, links, gaps, counts }
    }

    /// How badly a letter belongs to its chain: little where letters are many and close.
    fn cost(&self, glyph: usize, glyphs: &[Glyph]) -> f64 {
        let (chain, bounds) = (self.chain[glyph], glyphs[glyph].bounds);
        let size = f64::from(bounds.width().max(bounds.height()));
        (self.gaps[chain] + size) / f64::from(self.counts[chain]).sqrt()
    }

    /// The chains of those letters that are members, broken where others stood.
    fn words(&self, glyphs: &[Glyph], member: &dyn Fn(&usize) -> bool) -> Vec<Line> {
        let links: Vec<_> = self.links.iter().filter(|(a, b)| member(a) && member(b)).copied().collect();
        let chain = sets(glyphs.len(), &links);
        let mut words = vec![Vec::new(); glyphs.len()];
        (0..glyphs.len()).filter(member).for_each(|g| words[chain[g]].push(g));
        words.into_iter().filter_map(|w| Line::of(self.axis, w, glyphs)).collect()
    }
}

/// How well `b` follows `a`: the gap in pixels, or nothing if they do not belong together.
fn linked(glyphs: &[Glyph], boxes: &[Bounds], a: usize, b: usize) -> Option<f64> {
    let gap = gap(boxes[a], boxes[b], HEIGHT_RATIO, LETTER_GAP)?;
    let alike = glyphs[a].stroke.max(glyphs[b].stroke) <= 2.5 * glyphs[a].stroke.min(glyphs[b].stroke);
    alike.then_some(gap)
}

/// The gap between a box and one to its right, if they are of about the same height, side by side, and close.
fn gap(a: Bounds, b: Bounds, ratio: f64, farthest: f64) -> Option<f64> {
    let (ha, hb) = (f64::from(a.height()), f64::from(b.height()));
    let (low, tall) = (ha.min(hb), ha.max(hb));
    let common = f64::from(a.y1.min(b.y1) - a.y0.max(b.y0));
    let gap = f64::from(b.x0 - a.x1);
    let deepest = -LETTER_OVERLAP * f64::from(a.width().min(b.width()));
    let fits = tall <= ratio * low && common >= COMMON * low && (deepest..=farthest * tall).contains(&gap);
    fits.then_some(gap)
}

/// Joins the words of a line that stand beside each other.
fn join_words(glyphs: &[Glyph], words: Vec<Line>, blocked: &dyn Fn(Axis, Bounds) -> bool) -> Vec<Line> {
    let boxes: Vec<_> = words.iter().map(|w| w.axis.upright(w.bounds)).collect();
    let joined = |a: usize, b: usize| {
        let single = words[a].glyphs.len() == 1 || words[b].glyphs.len() == 1;
        let (ratio, farthest) = if single { (LETTER_RATIO, SINGLE_GAP) } else { (WORD_RATIO, WORD_GAP) };
        let gap = gap(boxes[a], boxes[b], HEIGHT_RATIO, farthest)?;
        let alike = words[a].height.max(words[b].height) <= ratio * words[a].height.min(words[b].height);
        (alike && !blocked(words[a].axis, words[a].axis.upright(between(boxes[a], boxes[b])))).then_some(gap)
    };
    let next = nearest_to_the_right(&boxes, &joined);
    let links: Vec<_> = next.iter().enumerate().filter_map(|(a, b)| Some((a, (*b)?))).collect();
    let set = sets(words.len(), &links);
    let mut lines = vec![Vec::new(); words.len()];
    words.iter().zip(&set).for_each(|(w, &s)| lines[s].extend(&w.glyphs));
    let axis = words.first().map_or(Axis::Across, |w| w.axis);
    lines.into_iter().filter_map(|l| Line::of(axis, l, glyphs)).collect()
}

/// The box between two boxes, as high as both have in common.
fn between(a: Bounds, b: Bounds) -> Bounds {
    Bounds { x0: a.x1, x1: b.x0.max(a.x1), y0: a.y0.max(b.y0), y1: a.y1.min(b.y1) }
}

/// For each box the best one to its right, by the least `cost`; each is the best of one at most.
fn nearest_to_the_right(boxes: &[Bounds], cost: &dyn Fn(usize, usize) -> Option<f64>) -> Vec<Option<usize>> {
    let rows = Rows::of(boxes);
    let mut offers = Vec::new();
    for (a, bounds) in boxes.iter().enumerate() {
        let reach = bounds.height() * 4;
        let costs = rows.within(*bounds, reach).filter(|&b| b != a && boxes[b].x0 > bounds.x0);
        let best = costs
            .filter_map(|b| Some((cost(a, b)?, b)))
            .min_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        offers.extend(best.map(|(cost, b)| (b, cost, a)));
    }
    offers.sort_by(|x, y| x.0.cmp(&y.0).then(x.1.total_cmp(&y.1)).then(x.2.cmp(&y.2)));
    offers.dedup_by_key(|o| o.0);
    let mut next = vec![None; boxes.len()];
    offers.into_iter().for_each(|(b, _, a)| next[a] = Some(b));
    next
}

/// Boxes by the strips of the sheet that they lie in, for looking up neighbours.
pub struct Rows<'a> {
    boxes: &'a [Bounds],
    strips: Vec<Vec<usize>>,
}

/// Rows of pixels in one strip.
const STRIP: i32 = 32;

impl<'a> Rows<'a> {
    /// Sorts the boxes, which lie at or right of and below (0, 0).
    pub fn of(boxes: &'a [Bounds]) -> Self {
        let lowest = boxes.iter().map(|b| b.y1).max().unwrap_or(0);
        let mut strips = vec![Vec::new(); (lowest / STRIP + 1) as usize];
        for (i, b) in boxes.iter().enumerate() {
            (b.y0 / STRIP..=(b.y1 - 1) / STRIP).for_each(|s| strips[s as usize].push(i));
        }
        strips.iter_mut().for_each(|s| s.sort_by_key(|&i| (boxes[i].x0, i)));
        Self { boxes, strips }
    }

    /// Boxes whose left side lies from this box's left side to `reach` right of its right side, in its strips. Some come
    /// more than once.
    pub fn within(&self, b: Bounds, reach: i32) -> impl Iterator<Item = usize> + '_ {
        let last = self.strips.len() as i32 - 1;
        (b.y0.clamp(0, last + 1) / STRIP..=((b.y1 - 1) / STRIP).min(last)).flat_map(move |s| {
            let strip = &self.strips[s as usize];
            let start = strip.partition_point(|&i| self.boxes[i].x0 < b.x0);
            strip[start..].iter().copied().take_while(move |&i| self.boxes[i].x0 <= b.x1 + reach)
        })
    }
}

/// For each of `count` things the first one that it is linked with, over however many links.
fn sets(count: usize, links: &[(usize, usize)]) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..count).collect();
    fn root(parent: &[usize], mut i: usize) -> usize {
        while parent[i] != i {
            i = parent[i];
        }
        i
    }
    for &(a, b) in links {
        let (a, b) = (root(&parent, a), root(&parent, b));
        parent[a.max(b)] = a.min(b);
    }
    for i in 0..count {
        parent[i] = parent[parent[i]];
    }
    parent
}

fn median_gaps(boxes: &[Bounds], chain: &[usize], links: &[(usize, usize)]) -> Vec<f64> {
    let mut all = vec![Vec::new(); boxes.len()];
    links.iter().for_each(|&(a, b)| all[chain[a]].push(boxes[b].x0 - boxes[a].x1));
    let median = |gaps: &mut Vec<i32>| {
        gaps.sort_unstable();
        gaps.get(gaps.len() / 2).map_or(f64::INFINITY, |&g| f64::from(g))
    };
    all.iter_mut().map(median).collect()
}
