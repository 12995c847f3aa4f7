//! What belongs to a line but is no letter by its shape or place: dots, accents, dashes, feet and inch marks, the raised 2
//! of "m²".

use super::components::{Bounds, Components};
use super::glyph::{Glyph, Layer};
use super::lines::{Line, Rows};

/// How far from the line's box its extras' middles are at most, in heights of the line: along it, and across it.
const ALONG: f64 = 0.6;
const ACROSS: f64 = 0.35;
/// How large they are at most, in heights of the line; `FULL` is for what stands in the line.
const WIDE: f64 = 1.0;
const HIGH: f64 = 0.7;
const FULL: f64 = 1.1;

/// A line with all that belongs to it.
#[derive(Debug, Clone)]
pub struct FullLine {
    /// Its letters.
    pub line: Line,
    /// All parts of it, letters and others.
    pub parts: Vec<(Layer, usize)>,
    /// The box around all parts.
    pub bounds: Bounds,
}

/// A part that may belong to a line.
struct Loose {
    layer: Layer,
    part: usize,
}

/// Gives each line what belongs to it, to long lines first; letters that stand alone and went to a line are no lines any
/// more.
pub fn complete(lines: Vec<Line>, glyphs: &[Glyph], layers: [&Components; 2], tallest: i32) -> Vec<FullLine> {
    let mut lines = lines;
    lines.sort_by_key(|l| (std::cmp::Reverse(l.glyphs.len()), l.bounds.y0, l.bounds.x0));
    let letters = taken_letters(&lines, glyphs, layers);
    let (loose, boxes) = loose(&letters, layers, tallest);
    let rows = Rows::of(&boxes);
    let mut taken = vec![false; loose.len()];
    let mut full = Vec::new();
    for line in lines {
        let own = |g: &usize| (glyphs[*g].layer, glyphs[*g].part);
        let mut all = FullLine { parts: line.glyphs.iter().map(own).collect(), bounds: line.bounds, line };
        if all.line.glyphs.len() > 1 {
            claim(&mut all, &loose, &boxes, &rows, &mut taken);
        } else if loose_index(&loose, all.parts[0]).is_some_and(|i| taken[i]) {
            continue;
        }
        full.push(all);
    }
    full
}

/// For each part of each layer whether it is a letter beside others.
fn taken_letters(lines: &[Line], glyphs: &[Glyph], layers: [&Components; 2]) -> [Vec<bool>; 2] {
    let mut taken = layers.map(|l| vec![false; l.list.len()]);
    for g in lines.iter().filter(|l| l.glyphs.len() > 1).flat_map(|l| &l.glyphs) {
        taken[glyphs[*g].layer as usize][glyphs[*g].part] = true;
    }
    taken
}

fn loose(letters: &[Vec<bool>; 2], layers: [&Components; 2], tallest: i32) -> (Vec<Loose>, Vec<Bounds>) {
    let of = |layer: Layer| {
        let parts = layers[layer as usize].list.iter().zip(&letters[layer as usize]).enumerate();
        let small =
            parts.filter(|(_, (p, taken))| !**taken && p.bounds.width().max(p.bounds.height()) <= tallest);
        small.map(|(part, (p, _))| (Loose { layer, part }, p.bounds)).collect::<Vec<_>>()
    };
    of(Layer::Whole).into_iter().chain(of(Layer::Cut)).unzip()
}

/// Loose parts are sorted by layer and number.
fn loose_index(loose: &[Loose], (layer, part): (Layer, usize)) -> Option<usize> {
    loose.binary_search_by_key(&(layer as usize, part), |l| (l.layer as usize, l.part)).ok()
}

fn claim(line: &mut FullLine, loose: &[Loose], boxes: &[Bounds], rows: &Rows<'_>, taken: &mut [bool]) {
    let reach = line.line.height.ceil() as i32;
    let near = line.line.bounds.grown(reach);
    let near = Bounds { y0: near.y0.max(0), ..near };
    let mut found: Vec<_> = rows.within(near, 0).collect();
    found.sort_unstable();
    for i in found {
        if !taken[i] && belongs(&line.line, boxes[i], loose[i].layer) {
            taken[i] = true;
            line.parts.push((loose[i].layer, loose[i].part));
            line.bounds = line.bounds.with(boxes[i]);
        }
    }
}

/// Whether a part of this box belongs to the line. What was cut off a wall does only inside of it.
fn belongs(line: &Line, part: Bounds, layer: Layer) -> bool {
    let (l, p) = (line.axis.upright(line.bounds), line.axis.upright(part));
    let [x, y] = p.middle();
    let (along, across) = if layer == Layer::Cut { (0.0, 0.0) } else { (ALONG, ACROSS) };
    let (along, across) = (along * line.height, across * line.height);
    let within = |v: f64, low: i32, high: i32, by: f64| v >= f64::from(low) - by && v <= f64::from(high) + by;
    let inside = within(x, l.x0, l.x1, 0.0) && within(y, l.y0, l.y1, 0.0);
    let high = if inside { FULL } else { HIGH } * line.height;
    let small = f64::from(p.width()) <= WIDE * line.height && f64::from(p.height()) <= high;
    small && within(x, l.x0, l.x1, along) && within(y, l.y0, l.y1, across)
}
