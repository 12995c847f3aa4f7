//! How much a line looks like one of text, by its shape alone.

use super::components::Bounds;
use super::glyph::Glyph;
use super::lines::Line;

/// How far a letter's foot may be off the line's, in heights of the line.
const LEVEL: f64 = 0.13;
/// Letters of one line have at least this part of its height.
const LOWEST: f64 = 0.55;
/// Sizes that differ by less than this part are the same.
const SAME: f64 = 0.07;

/// From 0 (surely none) to 1 (surely text).
pub fn likeness(line: &Line, glyphs: &[Glyph]) -> f64 {
    let members: Vec<_> = line.glyphs.iter().map(|&g| &glyphs[g]).collect();
    let boxes: Vec<_> = members.iter().map(|g| line.axis.upright(g.bounds)).collect();
    let bars = members.iter().filter(|g| g.bar).count() as f64 / members.len() as f64;
    if bars == 1.0 {
        return 0.0;
    }
    let bars = if bars > 0.6 { 0.4 } else { 1.0 };
    let varied = if repeats(&members, &boxes) { 0.3 } else { 1.0 };
    count(letters(line, &boxes)) * level(line, &boxes) * even(line, &boxes) * bars * varied
}

/// About how many letters there are, those counted that run into each other.
pub fn letters(line: &Line, boxes: &[Bounds]) -> f64 {
    boxes.iter().map(|b| (f64::from(b.width()) / (0.9 * line.height)).floor().max(1.0)).sum()
}

/// The more letters, the less likely they are in line by chance.
fn count(letters: f64) -> f64 {
    match letters as u32 {
        0 | 1 => 0.3,
        2 => 0.6,
        3 => 0.85,
        _ => 1.0,
    }
}

/// Which part of the letters stands on one level, with their feet or their heads.
fn level(line: &Line, boxes: &[Bounds]) -> f64 {
    let share = |side: &dyn Fn(&Bounds) -> i32| {
        let mut sides: Vec<_> = boxes.iter().map(side).collect();
        sides.sort_unstable();
        let near =
            |s: &&i32| f64::from((*s - sides[sides.len() / 2]).abs()) <= (LEVEL * line.height).max(1.0);
        sides.iter().filter(near).count() as f64 / sides.len() as f64
    };
    share(&|b| b.y0).max(share(&|b| b.y1))
}

/// Which part of the letters is about as high as the line.
fn even(line: &Line, boxes: &[Bounds]) -> f64 {
    let fits = |b: &&Bounds| (LOWEST..=1.5).contains(&(f64::from(b.height()) / line.height));
    boxes.iter().filter(fits).count() as f64 / boxes.len() as f64
}

/// Whether all are the same, as chairs at a table are and letters are not.
fn repeats(members: &[&Glyph], boxes: &[Bounds]) -> bool {
    let same = |a: f64, b: f64| (a - b).abs() <= (SAME * a.max(b)).max(1.0);
    let alike = |(g, b): (&&Glyph, &Bounds)| {
        same(f64::from(b.width()), f64::from(boxes[0].width()))
            && same(f64::from(b.height()), f64::from(boxes[0].height()))
            && same(g.area as f64, members[0].area as f64)
    };
    members.len() > 2 && members.iter().zip(boxes).all(alike)
}
