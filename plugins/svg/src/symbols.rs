//! The document's symbols: doors' leaves, windows, and everything else in a drawing of its kind.

use crate::element::{layer, legal, number, title};
use crate::sheet::{Sheet, corners};
use crate::walls::cut_out;
use planform_sdk::{DoorLeaf, Fitting, Layout, Point, Segment, Symbol};
use std::collections::BTreeSet;
use svg::node::Blob;
use svg::node::element::{Group, Path, Use};

/// A symbol with its number, from 1, in the order of the layout.
type Numbered<'a> = (usize, &'a Symbol);

fn numbered(layout: &Layout) -> impl Iterator<Item = Numbered<'_>> {
    (1..).zip(&layout.symbols)
}

/// The doors of the document, to lie over the openings: the leaves, open, and the arcs of their way.
pub fn doors<'a>(layout: &'a Layout, sheet: &'a Sheet) -> impl Iterator<Item = Group> + 'a {
    let fitted = |(n, s): Numbered<'a>| Some((n, s, layout.fitting(s)?));
    let doors = numbered(layout).filter(|(_, s)| s.is_door()).filter_map(fitted);
    doors.map(move |(n, symbol, fitting)| door(group(n, symbol), symbol, &fitting, sheet))
}

fn door(group: Group, symbol: &Symbol, fitting: &Fitting, sheet: &Sheet) -> Group {
    let group = match (fitting.opening, fitting.wall) {
        (Some(opening), _) => group.set("data-opening", format!("opening-{}", opening + 1)),
        (None, Some(_)) => cut_out(group, &fitting.segment, fitting.thickness, sheet).add(slab(
            "sill door-sill",
            &fitting.segment,
            sheet,
        )),
        (None, None) => group,
    };
    let leaves = symbol.leaves.iter().flat_map(|leaf| [slab("leaf", &open(leaf), sheet), swing(leaf, sheet)]);
    leaves.fold(group, Group::add)
}

fn open(leaf: &DoorLeaf) -> Segment {
    Segment::new(leaf.hinge, leaf.at(1.0))
}

fn slab(class: &str, line: &Segment, sheet: &Sheet) -> Path {
    Path::new().set("class", class).set("d", sheet.path(&[line.a, line.b], false))
}

/// The way of a leaf's free end, from open to closed.
fn swing(leaf: &DoorLeaf, sheet: &Sheet) -> Path {
    let (from, to) = (sheet.place(leaf.at(1.0)), sheet.place(leaf.at(0.0)));
    let radius = number(leaf.length());
    // On the sheet, whose y runs down, 1 is clockwise as seen.
    let clockwise = u8::from(leaf.swing() > 0.0);
    let ends = [from.x, from.y, to.x, to.y].map(number);
    let data = format!("M{} {}A{radius} {radius} 0 0 {clockwise} {} {}", ends[0], ends[1], ends[2], ends[3]);
    Path::new().set("class", "swing").set("d", data)
}

/// The layer `windows`: two thin lines for the glass between the wall's faces, the wall cut from jamb to jamb.
pub fn windows(layout: &Layout, sheet: &Sheet) -> Group {
    let fitted = |(n, s): Numbered<'_>| Some(window(group(n, s), &layout.fitting(s)?, sheet));
    numbered(layout).filter(|(_, s)| s.is_window()).filter_map(fitted).fold(layer("windows"), Group::add)
}

fn window(group: Group, fitting: &Fitting, sheet: &Sheet) -> Group {
    let Fitting { segment, thickness, wall, .. } = fitting;
    let lines = fitting.lines().map(|line| sheet.path(&[line.a, line.b], false)).concat();
    let group = if wall.is_some() { cut_out(group, segment, *thickness, sheet) } else { group };
    group.add(Path::new().set("class", "glass").set("d", lines))
}

/// The layer `symbols`: all that stands in no wall.
pub fn others(layout: &Layout, sheet: &Sheet) -> Group {
    let others = || numbered(layout).filter(|(_, s)| !(s.is_door() || s.is_window()));
    let kinds: BTreeSet<&str> = others().map(|(_, s)| s.kind.as_str()).collect();
    let drawings = kinds.into_iter().filter_map(definition).fold(layer("symbols"), Group::add);
    others().map(|(n, s)| other(group(n, s), s, sheet)).fold(drawings, Group::add)
}

/// What is used for every symbol of the kind, if there is a drawing of it.
fn definition(kind: &str) -> Option<Blob> {
    let drawing = drawing(kind)?.replacen("<svg xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    let (head, rest) = drawing.trim_end().trim_end_matches("</svg>").split_once('>')?;
    // Signs keep their shape; what is built is as wide and as deep as it was drawn.
    let fit = if matches!(kind, "lift" | "sink" | "toilet") { "none" } else { "xMidYMid" };
    Some(Blob::new(format!(
        "<symbol id=\"kind-{kind}\" preserveAspectRatio=\"{fit}\"{head}>{}</symbol>",
        rest.trim_end()
    )))
}

/// The drawing that all symbols of a kind share. Flights have steps by their length, each its own.
fn drawing(kind: &str) -> Option<&'static str> {
    if kind == "stairs" { None } else { planform_templates::of_kind(kind) }
}

fn other(group: Group, symbol: &Symbol, sheet: &Sheet) -> Group {
    if symbol.kind == "stairs" {
        return group.add(Path::new().set("class", "steps").set("d", steps(symbol, sheet)));
    }
    match drawing(&symbol.kind) {
        Some(_) => group.add(placed(symbol, sheet)),
        None => group.add(Path::new().set("class", "symbol-box").set("d", boxed(symbol, sheet))),
    }
}

/// The drawing of the symbol's kind in the symbol's box.
fn placed(symbol: &Symbol, sheet: &Sheet) -> Use {
    let middle = sheet.place(Point::new(symbol.pose.x, symbol.pose.y));
    // The sheet's y runs down, so that the map's counter-clockwise is negative on it.
    let turn = -symbol.pose.yaw.to_degrees();
    let (x, y) = (number(middle.x), number(middle.y));
    Use::new()
        .set("xlink:href", format!("#kind-{}", symbol.kind))
        .set("x", number(middle.x - symbol.width / 2.0))
        .set("y", number(middle.y - symbol.height / 2.0))
        .set("width", number(symbol.width.max(0.0)))
        .set("height", number(symbol.height.max(0.0)))
        .set("transform", format!("rotate({} {x} {y})", number(turn)))
}

/// A flight's outline, and a line across it for each step.
fn steps(symbol: &Symbol, sheet: &Sheet) -> String {
    let [a, b, c, d] = corners(&symbol.pose, symbol.width, symbol.height);
    let count = symbol.steps();
    let part = |p: Point, q: Point, i: u32| {
        let share = f64::from(i) / f64::from(count);
        Point::new(p.x + share * (q.x - p.x), p.y + share * (q.y - p.y))
    };
    let lines = (1..count).map(|i| sheet.path(&[part(a, b, i), part(d, c, i)], false));
    std::iter::once(sheet.path(&[a, b, c, d], true)).chain(lines).collect()
}

/// A box with a tick in the symbol's direction.
fn boxed(symbol: &Symbol, sheet: &Sheet) -> String {
    let [a, b, c, d] = corners(&symbol.pose, symbol.width, symbol.height);
    let middle = Point::new(symbol.pose.x, symbol.pose.y);
    sheet.path(&[a, b, c, d], true) + &sheet.path(&[middle, b.midpoint(c)], false)
}

fn group(number_of: usize, symbol: &Symbol) -> Group {
    Group::new()
        .set("id", format!("symbol-{number_of}"))
        .set("class", "symbol")
        .set("data-kind", legal(&symbol.kind))
        .set("data-score", number(symbol.score))
        .add(title(&symbol.kind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Pose, Wall};

    const SHEET: Sheet = Sheet { origin: Point::new(0.0, 10.0), width: 10.0, height: 10.0 };

    fn symbol(kind: &str, leaves: Vec<DoorLeaf>) -> Symbol {
        let pose = Pose { x: 2.0, y: 3.0, yaw: 0.0 };
        Symbol { kind: kind.into(), pose, width: 1.0, height: 0.5, score: 0.8, leaves }
    }

    fn leaf(open: [f64; 2]) -> DoorLeaf {
        DoorLeaf { hinge: Point::new(1.5, 3.0), closed: Point::new(2.5, 3.0), open: open.into() }
    }

    #[test]
    fn a_leaf_is_open_and_its_way_ends_where_it_closes() {
        let up = swing(&leaf([1.5, 4.0]), &SHEET).to_string();
        assert!(up.contains("d=\"M1.5 6A1 1 0 0 1 2.5 7\""), "{up}");
        let down = swing(&leaf([1.5, 2.0]), &SHEET).to_string();
        assert!(down.contains("d=\"M1.5 8A1 1 0 0 0 2.5 7\""), "{down}");
    }

    #[test]
    fn a_door_to_the_outside_cuts_its_wall() {
        let line = Segment::new(Point::new(0.0, 3.0), Point::new(5.0, 3.0));
        let walls = vec![Wall { line, thickness: 0.2, weight: 1.0, rooms: [Some(1), None] }];
        let symbols = vec![symbol("door", vec![leaf([1.5, 4.0])])];
        let mut layout = Layout { walls, symbols, ..Layout::default() };
        for cuts in [1, 0] {
            let drawn: String = doors(&layout, &SHEET).map(|g| g.to_string()).collect();
            for (part, count) in [("gap", cuts), ("jamb", cuts), ("leaf", 1), ("swing", 1)] {
                assert_eq!(drawn.matches(&format!("class=\"{part}\"")).count(), count, "{part}: {drawn}");
            }
            layout.walls.clear();
        }
    }

    #[test]
    fn a_window_is_two_thin_lines_between_the_faces() {
        let layout = Layout { symbols: vec![symbol("window", vec![])], ..Layout::default() };
        let drawn = windows(&layout, &SHEET).to_string();
        let lines = "M1.5 7.25L2.5 7.25M1.5 7.075L2.5 7.075M1.5 6.925L2.5 6.925M1.5 6.75L2.5 6.75";
        assert!(drawn.contains(lines), "{drawn}");
    }

    #[test]
    fn kinds_are_drawn_once_and_used_often() {
        let symbols = ["toilet", "toilet", "stairs", "first-aid", "<my> own"].map(|k| symbol(k, vec![]));
        let drawn = others(&Layout { symbols: symbols.into(), ..Layout::default() }, &SHEET).to_string();
        assert_eq!((drawn.matches("<symbol ").count(), drawn.matches("<use ").count()), (2, 3), "{drawn}");
        assert_eq!(drawn.matches("class=\"symbol-box\"").count(), 1);
        assert!(drawn.contains("class=\"steps\"") && !drawn.contains("<svg"));
    }

    #[test]
    fn endless_stairs_end() {
        let endless = Symbol { width: 1e9, ..symbol("stairs", vec![]) };
        assert_eq!(steps(&endless, &SHEET).matches('M').count(), 100);
    }
}
