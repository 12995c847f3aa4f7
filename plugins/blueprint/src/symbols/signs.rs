//! Signs: areas of one strong colour, or of black, that are as large and look inside as a template does. The coloured
//! areas are the candidates, so that nothing has to be searched for at every place and scale.

use super::blobs::{Blob, blobs};
use super::library::{Colour, Library, Template, Turned};
use super::soft::Soft;
use super::zncc;
use crate::found::SheetSymbol;
use crate::mask::Mask;
use crate::sheet::Sheet;
use image::RgbImage;

/// Candidates are sought on a picture no longer than this, pixels.
const SOUGHT_ON: u32 = 3000;
/// Less than this score is chance.
const LEAST_SCORE: f64 = 0.62;
/// Black areas may be so much else that they have to fit better.
const LEAST_BLACK_SCORE: f64 = 0.75;
/// No sign is smaller than this, pixels of the sheet.
const LEAST_SIDE: f64 = 9.0;
/// No sign is longer than this share of the sheet.
const LARGEST_SHARE: f64 = 0.12;
/// Templates are compared at this size of the shorter side, pixels, and with this margin around it.
const COMPARED: u32 = 28;
const MARGIN: u32 = 2;
/// No more areas than this of each colour are looked at, the largest ones.
const MOST_AREAS: usize = 2000;

/// A sign's place: left, top, width and height in pixels of the sheet.
type Frame = [f64; 4];

/// All signs of the sheet, best first.
pub fn find(sheet: &Sheet, library: &Library) -> Vec<SheetSymbol> {
    let factor = sheet.colour.width().max(sheet.colour.height()).div_ceil(SOUGHT_ON).max(1);
    let small = shrunk(&sheet.colour, factor);
    let mut found = Vec::new();
    for paint in Paint::ALL {
        let patterns = patterns(library, paint);
        for area in areas(&small, paint, f64::from(factor)) {
            found.extend(best_of(sheet, &patterns, &area, paint));
        }
    }
    without_overlaps(found)
}

/// Signs of one plan are about as large as each other: without what is much smaller than most, and without the rows that
/// only explain them.
pub fn alike(mut signs: Vec<SheetSymbol>) -> Vec<SheetSymbol> {
    let side = |s: &SheetSymbol| s.width.min(s.height);
    let mut sides: Vec<f64> = signs.iter().filter(|s| s.kind != HERE).map(side).collect();
    sides.sort_by(f64::total_cmp);
    if sides.len() >= 3 {
        let usual = sides[sides.len() / 2];
        signs.retain(|s| side(s) >= SMALLEST * usual);
    }
    let explained: Vec<bool> = (0..signs.len()).map(|i| is_explained(&signs, i)).collect();
    let mut explained = explained.into_iter();
    signs.retain(|_| explained.next() != Some(true));
    signs
}

/// A sign is at least this share of the usual side.
const SMALLEST: f64 = 0.45;
/// The kind of sign that may be confused with letters' bowls and dots.
const HERE: &str = "you-are-here";
/// So many different signs, one below the other at even distances, are a legend.
const LEGEND: usize = 4;

/// Whether a sign is one of a column of different signs, all as far apart as the first two.
fn is_explained(signs: &[SheetSymbol], own: usize) -> bool {
    let left = |s: &SheetSymbol| s.centre[0] - s.width / 2.0;
    let side = signs[own].width.min(signs[own].height);
    let mut column: Vec<&SheetSymbol> =
        signs.iter().filter(|s| (left(s) - left(&signs[own])).abs() < 0.2 * side).collect();
    column.sort_by(|a, b| a.centre[1].total_cmp(&b.centre[1]));
    (0..column.len()).any(|from| {
        let run = even(&column[from..]);
        let different = (0..run.len()).all(|i| run[..i].iter().all(|s| s.kind != run[i].kind));
        run.len() >= LEGEND && different && run.iter().any(|s| s.centre == signs[own].centre)
    })
}

/// The signs from the first one on that follow each other closely and evenly.
fn even<'a, 'b>(column: &'b [&'a SheetSymbol]) -> &'b [&'a SheetSymbol] {
    let gap = |i: usize| column[i + 1].centre[1] - column[i].centre[1];
    let close = |i: usize| {
        let side = column[i].height.max(column[i + 1].height);
        (0.9..2.5).contains(&(gap(i) / side)) && (gap(i) / gap(0) - 1.0).abs() < 0.15
    };
    let count = (0..column.len().saturating_sub(1)).take_while(|&i| close(i)).count();
    &column[..(count + 1).min(column.len())]
}

/// What makes an area a candidate.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Paint {
    Hue(Colour),
    /// The darker shade of green, where a sign lies on a green route.
    DarkGreen,
    Black,
}

impl Paint {
    const ALL: [Self; 5] = [
        Self::Hue(Colour::Red),
        Self::Hue(Colour::Green),
        Self::Hue(Colour::Blue),
        Self::DarkGreen,
        Self::Black,
    ];

    /// How much of this paint a pixel shows, from 0 to 1.
    fn amount(self, [r, g, b]: [u8; 3]) -> f32 {
        let [r, g, b] = [r, g, b].map(f32::from);
        let amount = match self {
            Self::Hue(Colour::Red) => (r - g.max(b)) / 90.0,
            Self::Hue(Colour::Green) => (g - r.max(b * 0.9)) / 50.0,
            Self::Hue(Colour::Blue) => (b - r.max(g)) / 50.0,
            Self::Hue(Colour::Any) => 0.0,
            Self::DarkGreen => ((g - r.max(b)) / 40.0).min((150.0 - g) / 30.0).min((110.0 - r) / 30.0),
            Self::Black => (120.0 - r.max(g).max(b)) / 60.0,
        };
        amount.clamp(0.0, 1.0)
    }

    fn may_be(self, colour: Colour) -> bool {
        match self {
            Self::Hue(own) => own == colour,
            Self::DarkGreen => colour == Colour::Green,
            Self::Black => colour != Colour::Blue,
        }
    }

    fn least_score(self) -> f64 {
        if self == Self::Black { LEAST_BLACK_SCORE } else { LEAST_SCORE }
    }
}

/// One way in which a sign may look.
struct Pattern<'a> {
    kind: &'a str,
    angle: f64,
    aspect: f64,
    values: Vec<f32>,
    size: [u32; 2],
}

fn patterns(library: &Library, paint: Paint) -> Vec<Pattern<'_>> {
    // What has no colour but a size in the building is searched for by that size, elsewhere.
    let is_sign = |t: &&Template| t.colour != Colour::Any || t.metres.is_none();
    library
        .templates
        .iter()
        .filter(is_sign)
        .filter(|t| paint.may_be(t.colour))
        .flat_map(patterns_of)
        .collect()
}

fn patterns_of(template: &Template) -> Vec<Pattern<'_>> {
    let quarters = if template.turned == Turned::Upright { 1 } else { 4 };
    let mut patterns = Vec::new();
    for drawing in &template.drawings {
        let look = if template.colour == Colour::Any { &drawing.ink } else { &drawing.colour };
        let sides = [Some(look.clone()), template.mirrored.then(|| look.mirrored())];
        for side in sides.into_iter().flatten() {
            patterns.extend((0..quarters).map(|q| pattern(template, &side.turned(q), q)));
        }
    }
    patterns
}

fn pattern<'a>(template: &'a Template, look: &Soft, quarter: u32) -> Pattern<'a> {
    let aspect = f64::from(look.width) / f64::from(look.height);
    let size = compared_size(aspect);
    let values = look.resized(size[0], size[1]).padded(MARGIN).values;
    let angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
    Pattern { kind: &template.kind, angle, aspect, values, size }
}

fn compared_size(aspect: f64) -> [u32; 2] {
    let long = |a: f64| (f64::from(COMPARED) * a).round() as u32;
    if aspect >= 1.0 { [long(aspect), COMPARED] } else { [COMPARED, long(1.0 / aspect)] }
}

fn shrunk(picture: &RgbImage, factor: u32) -> RgbImage {
    let (w, h) = (picture.width().div_ceil(factor), picture.height().div_ceil(factor));
    RgbImage::from_fn(w, h, |x, y| {
        let span = |at: u32, end: u32| (at * factor)..((at + 1) * factor).min(end);
        let mut sum = [0u32; 3];
        for (sx, sy) in
            span(y, picture.height()).flat_map(|sy| span(x, picture.width()).map(move |sx| (sx, sy)))
        {
            let p = picture.get_pixel(sx, sy).0;
            (0..3).for_each(|i| sum[i] += u32::from(p[i]));
        }
        let n = span(x, picture.width()).len() * span(y, picture.height()).len();
        image::Rgb(sum.map(|s| (s / n.max(1) as u32) as u8))
    })
}

/// Frames of what is painted so, in pixels of the sheet.
fn areas(small: &RgbImage, paint: Paint, factor: f64) -> Vec<Frame> {
    let set = small.pixels().map(|p| paint.amount(p.0) > 0.5).collect();
    let mask = Mask { width: small.width(), height: small.height(), set };
    let largest = f64::from(small.width().max(small.height())) * LARGEST_SHARE;
    let mut found: Vec<Blob> =
        blobs(&mask).into_iter().filter(|b| may_hold_signs(b, largest, factor)).collect();
    found.sort_by_key(|b| std::cmp::Reverse(b.count));
    found.truncate(MOST_AREAS);
    found.iter().map(|b| frame(b, factor)).collect()
}

fn frame(blob: &Blob, factor: f64) -> Frame {
    let [left, top, ..] = blob.bounds;
    let [width, height] = blob.size();
    [left, top, width, height].map(|v| f64::from(v) * factor)
}

/// A few signs side by side may have run together.
fn may_hold_signs(blob: &Blob, largest: f64, factor: f64) -> bool {
    let [w, h] = blob.size().map(f64::from);
    let full = f64::from(blob.count) / (w * h);
    w.min(h) * factor >= LEAST_SIDE && w.min(h) <= largest && w.max(h) <= 4.0 * largest && full > 0.2
}

/// The signs that one area holds: itself one, or several side by side.
fn best_of(sheet: &Sheet, patterns: &[Pattern], area: &Frame, paint: Paint) -> Vec<SheetSymbol> {
    let mut found = Vec::new();
    for pattern in patterns {
        for place in places(area, pattern.aspect) {
            let score = best_near(sheet, pattern, place, paint);
            if score.0 >= paint.least_score() {
                found.push(symbol(pattern, score));
            }
        }
    }
    without_overlaps(found)
}

/// Where a sign of this shape may lie in the area: all of it, or windows as high or as wide.
fn places(&[left, top, width, height]: &Frame, aspect: f64) -> Vec<Frame> {
    let own = width / height;
    let near = (own / aspect).ln().abs();
    if near < 0.3 {
        return vec![[left, top, width, height]];
    }
    let slid = |room: f64, step: f64| (0..=((room / step) as u32).min(60)).map(move |i| f64::from(i) * step);
    if own > aspect {
        let w = height * aspect;
        slid(width - w, w / 8.0).map(|d| [left + d, top, w, height]).collect()
    } else {
        let h = width / aspect;
        slid(height - h, h / 8.0).map(|d| [left, top + d, width, h]).collect()
    }
}

/// The best score at the place and slightly around it, with the place.
fn best_near(sheet: &Sheet, pattern: &Pattern, place: Frame, paint: Paint) -> (f64, Frame) {
    let first = compare(sheet, pattern, place, paint);
    if first < paint.least_score() - 0.25 {
        return (first, place);
    }
    let step = place[2].min(place[3]) / 16.0;
    let mut best = (first, place);
    for (dx, dy) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (-0.5, -0.5), (0.5, 0.5)] {
        let moved = [place[0] + dx * step, place[1] + dy * step, place[2], place[3]];
        let score = compare(sheet, pattern, moved, paint);
        if score > best.0 {
            best = (score, moved);
        }
    }
    best
}

fn compare(sheet: &Sheet, pattern: &Pattern, [left, top, width, height]: Frame, paint: Paint) -> f64 {
    let [nx, ny] = pattern.size;
    let (sx, sy) = (width / f64::from(nx), height / f64::from(ny));
    let amount = |x: u32, y: u32| {
        let place = |i: u32, from: f64, step: f64| from + (f64::from(i) - f64::from(MARGIN)) * step;
        mean_amount(&sheet.colour, paint, [place(x, left, sx), place(y, top, sy), sx, sy])
    };
    zncc::score(&Soft::from_fn(nx + 2 * MARGIN, ny + 2 * MARGIN, amount).values, &pattern.values)
}

/// The mean amount of a paint over a small rectangle.
fn mean_amount(picture: &RgbImage, paint: Paint, [left, top, width, height]: Frame) -> f32 {
    let samples = |length: f64| (length.round() as u32).clamp(2, 4);
    let (nx, ny) = (samples(width), samples(height));
    let at = |i: u32, n: u32, from: f64, length: f64| {
        (from + (f64::from(i) + 0.5) / f64::from(n) * length).floor()
    };
    let mut sum = 0.0;
    for (i, j) in (0..ny).flat_map(|j| (0..nx).map(move |i| (i, j))) {
        let (x, y) = (at(i, nx, left, width), at(j, ny, top, height));
        if x >= 0.0 && y >= 0.0 {
            sum += picture.get_pixel_checked(x as u32, y as u32).map_or(0.0, |p| paint.amount(p.0));
        }
    }
    sum / (nx * ny) as f32
}

fn symbol(pattern: &Pattern, (score, [left, top, width, height]): (f64, Frame)) -> SheetSymbol {
    let quarter = (pattern.angle / std::f64::consts::FRAC_PI_2).round() as u32 % 2 == 1;
    let (along, across) = if quarter { (height, width) } else { (width, height) };
    SheetSymbol {
        kind: pattern.kind.into(),
        centre: [left + width / 2.0, top + height / 2.0],
        angle: pattern.angle,
        width: along,
        height: across,
        score,
        leaves: Vec::new(),
    }
}

/// The best of those that lie over each other.
fn without_overlaps(mut found: Vec<SheetSymbol>) -> Vec<SheetSymbol> {
    found.sort_by(|a, b| b.score.total_cmp(&a.score));
    let mut kept: Vec<SheetSymbol> = Vec::new();
    for symbol in found {
        if kept.iter().all(|k| !overlap(k, &symbol)) {
            kept.push(symbol);
        }
    }
    kept
}

fn overlap(a: &SheetSymbol, b: &SheetSymbol) -> bool {
    let near = |i: usize| {
        let reach = (a.width.min(a.height) + b.width.min(b.height)) / 2.0;
        (a.centre[i] - b.centre[i]).abs() < 0.7 * reach
    };
    near(0) && near(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign(kind: &str, x: f64, y: f64, side: f64) -> SheetSymbol {
        let (kind, leaves) = (kind.into(), Vec::new());
        SheetSymbol { kind, centre: [x, y], angle: 0.0, width: side, height: side, score: 0.9, leaves }
    }

    fn four(step: f64) -> Vec<SheetSymbol> {
        let kinds = ["first-aid", "fire-extinguisher", "fire-hose-reel", "emergency-exit"];
        (0..4).map(|i| sign(kinds[i], 100.0, 50.0 + step * i as f64, 30.0)).collect()
    }

    #[test]
    fn the_dot_of_a_letter_is_no_sign() {
        let mut signs = four(300.0);
        signs.push(sign(HERE, 400.0, 80.0, 9.0));
        signs.push(sign(HERE, 500.0, 80.0, 25.0));
        let kept = alike(signs);
        assert_eq!(kept.len(), 5);
        assert!(kept.iter().all(|s| s.width > 20.0));
    }

    #[test]
    fn an_even_column_of_different_signs_is_a_legend() {
        let mut signs = four(40.0);
        signs.push(sign("first-aid", 400.0, 80.0, 28.0));
        let kept = alike(signs);
        assert_eq!(kept.len(), 1);
        assert_eq!(kept[0].centre, [400.0, 80.0]);
        let same = (0..4).map(|i| sign("first-aid", 100.0, 50.0 + 40.0 * f64::from(i), 30.0)).collect();
        assert_eq!(alike(same).len(), 4);
    }
}
