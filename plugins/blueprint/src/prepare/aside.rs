//! What stands around the drawing: frame, title block, legend, north arrow, scale bar and captions.
//!
//! Only what is plainly not of the building goes: a wing or a building of its own stays, and so does whatever
//! lies among the walls.

use super::clusters::{Cells, Cluster, Span, flood};
use crate::mask::Mask;
use crate::rows;

/// A gap of twice as many cells, half a per cent of the sheet, parts a frame from what it frames.
const FRAME_GAP: u32 = 1;
/// A gap of twice as many cells, one and a half per cent of the sheet, parts a drawing from its captions.
const GAP: u32 = 3;
/// A frame, or a table's border, is drawn along so much of each side.
const DRAWN: f32 = 0.95;
/// A frame encloses a drawing of at least this share of its own area.
const FRAMED: f32 = 0.08;
/// At most so much of a frame's cluster (its title block) lies away from its sides.
const INSIDE: f32 = 0.5;
/// What is this much shorter than the building, and apart from it, is no wing.
const SMALL: f32 = 0.15;
/// What is this thin is a line or two of text, a scale bar or a dimension.
const THIN: f32 = 0.05;
/// A table stands beside the drawing and is no larger than this share of it.
const TABLE: f32 = 0.5;
/// A table's fields are rectangles, so much of whose rims is empty; where a door's leaf stands in a room, it
/// is not.
const RECTANGULAR: f32 = 0.97;
/// Fewer fields make no table.
const FEWEST: usize = 4;
/// Fields below this share of a table are the insides of letters and emblems.
const FIELD: f32 = 0.01;
/// So much of a table's fields are rectangles; an emblem may cut some.
const REGULAR: f32 = 0.6;

/// All is drawing.
pub fn nothing(ink: Mask) -> (Mask, Mask) {
    let aside = Mask::empty(ink.width, ink.height);
    (ink, aside)
}

/// The ink of the drawing, and of what stands around it.
pub fn parted(ink: Mask) -> (Mask, Mask) {
    let mut cells = Cells::of(&ink);
    let mut aside = vec![false; cells.set.set.len()];
    let frames = frames(&cells.clusters(FRAME_GAP), cells.set.width as usize);
    frames.iter().for_each(|frame| set_aside(frame, &mut cells, &mut aside));
    let clusters = cells.clusters(GAP);
    let width = cells.set.width as usize;
    around(&clusters, width).into_iter().for_each(|cluster| set_aside(cluster, &mut cells, &mut aside));
    split(ink, &cells, &aside)
}

fn set_aside(cluster: &Cluster, cells: &mut Cells, aside: &mut [bool]) {
    for &cell in &cluster.cells {
        aside[cell] = true;
        cells.set.set[cell] = false;
    }
}

fn split(mut ink: Mask, cells: &Cells, aside: &[bool]) -> (Mask, Mask) {
    let mut apart = Mask::empty(ink.width, ink.height);
    let (width, columns) = (ink.width as usize, cells.set.width as usize);
    rows::for_each(&mut apart.set, width, |y, row| {
        let flags = &aside[y / cells.side * columns..];
        let pixels = row.iter_mut().zip(&ink.set[y * width..]).enumerate();
        pixels.for_each(|(x, (to, &from))| *to = from && flags[x / cells.side]);
    });
    ink = ink.without(&apart);
    (ink, apart)
}

/// Rectangles, one inside of the other perhaps, that enclose the drawing and touch nothing of it.
fn frames(clusters: &[Cluster], width: usize) -> Vec<Cluster> {
    clusters.iter().filter(|c| is_frame(c, clusters, width)).cloned().collect()
}

fn is_frame(frame: &Cluster, clusters: &[Cluster], width: usize) -> bool {
    let framed = clusters.iter().filter(|c| frame.encloses(c, 2)).map(Cluster::area).max().unwrap_or(0);
    let outside = clusters.iter().filter(|c| !frame.encloses(c, 0) && !c.encloses(frame, 0));
    // Nothing but other frames and stray marks lies outside of a frame: a hall around an inner core has
    // captions there.
    let alone = outside.map(Cluster::area).sum::<usize>() * 100 < frame.area();
    let mask = frame.mask(width);
    let inside = inside_share(&mask);
    framed as f32 >= FRAMED * frame.area() as f32
        && alone
        && inside <= INSIDE
        && is_bordered(&mask)
        && is_fine(&mask)
}

/// The share of a mask that is more than two cells from its sides.
fn inside_share(mask: &Mask) -> f32 {
    let inner = |i: usize| {
        let (x, y) = (i % mask.width as usize, i / mask.width as usize);
        x.min(mask.width as usize - 1 - x).min(y).min(mask.height as usize - 1 - y) > 2
    };
    let all = mask.count().max(1);
    (0..mask.set.len()).filter(|&i| mask.set[i] && inner(i)).count() as f32 / all as f32
}

/// Whether something is drawn along all four sides.
fn is_bordered(mask: &Mask) -> bool {
    let (w, h) = (i64::from(mask.width), i64::from(mask.height));
    let drawn = |length: i64, at: &dyn Fn(i64, i64) -> bool| {
        let hits = (0..length).filter(|&i| (0..2).any(|depth| at(i, depth))).count();
        hits as f32 >= DRAWN * length as f32
    };
    drawn(w, &|i, d| mask.get(i, d))
        && drawn(w, &|i, d| mask.get(i, h - 1 - d))
        && drawn(h, &|i, d| mask.get(d, i))
        && drawn(h, &|i, d| mask.get(w - 1 - d, i))
}

/// Whether the third cell from every side is mostly empty: walls are thicker than a frame's line, or have
/// rooms and doors at them.
fn is_fine(mask: &Mask) -> bool {
    let (w, h) = (i64::from(mask.width), i64::from(mask.height));
    let empty = |length: i64, at: &dyn Fn(i64) -> bool| {
        (0..length).filter(|&i| !at(i)).count() as f32 >= 0.5 * length as f32
    };
    empty(w, &|i| mask.get(i, 2)) && empty(w, &|i| mask.get(i, h - 3)) && empty(h, &|i| mask.get(2, i))
}

/// What stands beside the drawing: small or thin things, and tables with what is in them.
fn around(clusters: &[Cluster], width: usize) -> Vec<&Cluster> {
    let Some(main) = clusters.iter().max_by_key(|c| c.area()) else { return vec![] };
    let longest = main.size()[0].max(main.size()[1]) as f32;
    let tables: Vec<_> = clusters.iter().filter(|c| c.is_beside(main) && is_table(c, main, width)).collect();
    let buildings: Vec<_> = clusters
        .iter()
        .filter(|c| !is_small(c, longest) && !tables.iter().any(|t| t.encloses(c, 0)))
        .collect();
    let apart = |c: &Cluster| is_small(c, longest) && buildings.iter().all(|b| c.is_beside(b));
    clusters.iter().filter(|c| tables.iter().any(|t| t.encloses(c, 0)) || apart(c)).collect()
}

fn is_small(cluster: &Cluster, longest: f32) -> bool {
    let [w, h] = cluster.size();
    (w.max(h) as f32) < SMALL * longest || (w.min(h) as f32) < THIN * longest
}

/// Whether a cluster is a table: a border, and within it only closed rectangles.
fn is_table(cluster: &Cluster, main: &Cluster, width: usize) -> bool {
    let mask = cluster.mask(width);
    if cluster.area() as f32 > TABLE * main.area() as f32 || !is_bordered(&mask) {
        return false;
    }
    let fields = fields(&mask);
    let rectangles: Vec<_> = fields.iter().filter(|f| is_rectangle(f, mask.width as usize)).collect();
    let area = |all: &mut dyn Iterator<Item = usize>| all.sum::<usize>() as f32;
    let of_rectangles = area(&mut rectangles.iter().map(|f| f.len()));
    rectangles.len() >= FEWEST && of_rectangles >= REGULAR * area(&mut fields.iter().map(Vec::len))
}

/// The closed fields of a table.
fn fields(mask: &Mask) -> Vec<Vec<usize>> {
    let mut open = Mask { set: mask.set.iter().map(|&s| !s).collect(), ..*mask };
    let mut fields = vec![];
    for start in 0..open.set.len() {
        if open.set[start] {
            fields.push(flood(&mut open, start));
        }
    }
    fields.retain(|field| field.len() as f32 >= FIELD * mask.set.len() as f32);
    fields
}

fn is_rectangle(field: &[usize], width: usize) -> bool {
    let span = |place: &dyn Fn(usize) -> usize| -> Span {
        let ends = |(low, high): (usize, usize), p: usize| (low.min(p), high.max(p));
        let (low, high) = field.iter().map(|&c| place(c)).fold((usize::MAX, 0), ends);
        [low, high]
    };
    let (columns, rows) = (span(&|c| c % width), span(&|c| c / width));
    let on_rim = |c: usize| columns.contains(&(c % width)) || rows.contains(&(c / width));
    let rim = 2 * (columns[1] - columns[0] + rows[1] - rows[0]);
    field.iter().filter(|&&c| on_rim(c)).count() as f32 >= RECTANGULAR * rim as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sheet with a building of two rooms and an opening between them.
    fn sheet() -> Mask {
        let mut ink = Mask::empty(400, 300);
        outline(&mut ink, [100, 60, 300, 200], 3);
        fill(&mut ink, [200, 60, 202, 120]);
        fill(&mut ink, [200, 150, 202, 200]);
        ink
    }

    fn fill(ink: &mut Mask, [left, top, right, bottom]: [usize; 4]) {
        (top..=bottom).for_each(|y| ink.set[y * 400 + left..=y * 400 + right].fill(true));
    }

    fn outline(ink: &mut Mask, [left, top, right, bottom]: [usize; 4], thick: usize) {
        fill(ink, [left, top, right, top + thick - 1]);
        fill(ink, [left, bottom + 1 - thick, right, bottom]);
        fill(ink, [left, top, left + thick - 1, bottom]);
        fill(ink, [right + 1 - thick, top, right, bottom]);
    }

    /// Checks that the building stays, and that what was added to it is set aside.
    fn assert_aside(add: impl Fn(&mut Mask)) {
        let mut ink = sheet();
        add(&mut ink);
        let (drawing, aside) = parted(ink.clone());
        assert!(drawing == sheet());
        assert!(drawing.with(&aside) == ink);
    }

    /// Checks that what was added is taken for a part of the building.
    fn assert_stays(add: impl Fn(&mut Mask)) {
        let mut ink = sheet();
        add(&mut ink);
        assert!(parted(ink.clone()).0 == ink);
    }

    fn table(ink: &mut Mask, [left, top]: [usize; 2]) {
        outline(ink, [left, top, left + 90, top + 30], 1);
        fill(ink, [left, top + 15, left + 90, top + 15]);
        fill(ink, [left + 40, top, left + 40, top + 30]);
        fill(ink, [left + 50, top + 5, left + 70, top + 8]);
    }

    #[test]
    fn the_building_alone_stays_whole() {
        assert_stays(|_| ());
    }

    #[test]
    fn a_frame_goes_with_the_title_block_in_its_corner() {
        assert_aside(|ink| {
            outline(ink, [5, 5, 394, 294], 1);
            table(ink, [304, 264]);
        });
    }

    #[test]
    fn a_table_goes_with_its_words() {
        assert_aside(|ink| table(ink, [150, 230]));
    }

    #[test]
    fn arrows_captions_and_scale_bars_go() {
        assert_aside(|ink| {
            outline(ink, [340, 20, 355, 35], 1);
            fill(ink, [100, 230, 180, 233]);
            (0..10).for_each(|i| fill(ink, [200 + 8 * i, 240, 204 + 8 * i, 244]));
        });
    }

    #[test]
    fn a_detached_building_stays() {
        assert_stays(|ink| {
            outline(ink, [10, 60, 70, 130], 3);
            (80..100).for_each(|y| ink.set[y * 400 + 10..y * 400 + 13].fill(false));
        });
    }

    #[test]
    fn what_stands_free_among_the_walls_stays() {
        assert_stays(|ink| outline(ink, [120, 90, 140, 110], 2));
    }

    #[test]
    fn the_outer_wall_around_a_free_core_is_no_frame() {
        let mut ink = Mask::empty(400, 300);
        outline(&mut ink, [60, 60, 340, 240], 6);
        (100..130).for_each(|y| ink.set[y * 400 + 60..y * 400 + 66].fill(false));
        outline(&mut ink, [150, 110, 250, 190], 4);
        assert!(parted(ink.clone()).0 == ink);
    }

    #[test]
    fn sheets_without_ink_are_survived() {
        for (width, height) in [(0, 0), (1, 1), (30, 2)] {
            assert_eq!(parted(Mask::empty(width, height)).1.count(), 0);
        }
    }
}
