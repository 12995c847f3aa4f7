//! The TABLES section: views, linetypes, layers, text styles, applications, block records.

use crate::entity::APPLICATION;
use crate::layer::Layer;
use crate::objects::Skeleton;
use crate::pairs::{Handle, Pairs};
use planform_sdk::Point;

/// Width over height of the window that the view is made for.
const WINDOW_ASPECT: f64 = 1.6;
/// Space around the drawing in the view.
const MARGIN: f64 = 1.1;
/// Height of the view of an empty drawing, and the least of any, metres.
const EMPTY_VIEW: f64 = 10.0;

/// Name, description and dashes (gaps below 0) of the linetypes, metres: a tenth of a metre is a
/// millimetre on paper at 1:100.
const LINETYPES: [(&str, &str, &[f64]); 5] = [
    ("ByBlock", "", &[]),
    ("ByLayer", "", &[]),
    ("Continuous", "Solid line", &[]),
    ("CENTER", "Center ____ _ ____ _ ____", &[0.5, -0.1, 0.1, -0.1]),
    ("DASHED", "Dashed __ __ __ __ __ __", &[0.25, -0.125]),
];

/// The TABLES section. `bounds` are those of the drawing.
pub fn tables(pairs: &mut Pairs, skeleton: &Skeleton, bounds: Option<(Point, Point)>) {
    pairs.section("TABLES", |p| {
        table(p, "VPORT", 1, |p, table| viewport(p, table, bounds));
        table(p, "LTYPE", LINETYPES.len(), linetypes);
        table(p, "LAYER", Layer::ALL.len() + 1, |p, table| layers(p, table, skeleton));
        table(p, "STYLE", 1, |p, table| text_style(p, table, skeleton));
        table(p, "VIEW", 0, |_, _| ());
        table(p, "UCS", 0, |_, _| ());
        table(p, "APPID", 2, |p, table| {
            for name in ["ACAD", APPLICATION] {
                record(p, "APPID", "AcDbRegAppTableRecord", table, name);
            }
        });
        table(p, "DIMSTYLE", 1, |p, table| dimension_style(p, table, skeleton));
        if p.version().has_objects() {
            table(p, "BLOCK_RECORD", 2 + skeleton.symbols.len(), |p, table| {
                block_records(p, table, skeleton)
            });
        }
    });
}

fn table(pairs: &mut Pairs, name: &str, records: usize, content: impl FnOnce(&mut Pairs, Handle)) {
    pairs.word(0, "TABLE");
    pairs.word(2, name);
    let handle = pairs.new_handle();
    if pairs.version().has_objects() {
        pairs.handle(5, handle);
        pairs.handle(330, Handle::NONE);
        pairs.word(100, "AcDbSymbolTable");
    }
    pairs.integer(70, records as i64);
    if name == "DIMSTYLE" {
        pairs.subclass("AcDbDimStyleTable");
    }
    content(pairs, handle);
    pairs.word(0, "ENDTAB");
}

fn record(pairs: &mut Pairs, kind: &str, class: &str, table: Handle, name: &str) {
    let handle = pairs.new_handle();
    known_record(pairs, kind, class, table, name, handle);
    pairs.integer(70, 0);
}

fn known_record(pairs: &mut Pairs, kind: &str, class: &str, table: Handle, name: &str, handle: Handle) {
    pairs.word(0, kind);
    pairs.handle(if kind == "DIMSTYLE" { 105 } else { 5 }, handle);
    pairs.owner(table);
    pairs.subclass("AcDbSymbolTableRecord");
    pairs.subclass(class);
    pairs.word(2, name);
}

/// The active view: the whole drawing from above.
fn viewport(p: &mut Pairs, table: Handle, bounds: Option<(Point, Point)>) {
    let (centre, height) = view(bounds);
    record(p, "VPORT", "AcDbViewportTableRecord", table, "*Active");
    p.point_2d(10, Point::new(0.0, 0.0));
    p.point_2d(11, Point::new(1.0, 1.0));
    p.point_2d(12, centre);
    p.point_2d(13, Point::new(0.0, 0.0));
    p.point_2d(14, Point::new(1.0, 1.0));
    p.point_2d(15, Point::new(1.0, 1.0));
    p.real(16, 0.0);
    p.real(26, 0.0);
    p.real(36, 1.0);
    p.point_3d(17, Point::default());
    p.real(40, height);
    p.real(41, WINDOW_ASPECT);
    p.real(42, 50.0);
    for code in [43, 44, 50, 51] {
        p.real(code, 0.0);
    }
    for (code, value) in [(71, 0), (72, 1000), (73, 1), (74, 3), (75, 0), (76, 0), (77, 0), (78, 0)] {
        p.integer(code, value);
    }
}

/// Middle and height of the view that shows all, metres.
fn view(bounds: Option<(Point, Point)>) -> (Point, f64) {
    let Some((lo, hi)) = bounds else { return (Point::default(), EMPTY_VIEW) };
    let height = (hi.y - lo.y).max((hi.x - lo.x) / WINDOW_ASPECT) * MARGIN;
    (lo.midpoint(hi), if height > 0.0 { height } else { EMPTY_VIEW })
}

fn linetypes(p: &mut Pairs, table: Handle) {
    for (name, description, dashes) in LINETYPES {
        record(p, "LTYPE", "AcDbLinetypeTableRecord", table, name);
        p.word(3, description);
        p.integer(72, 65);
        p.integer(73, dashes.len() as i64);
        p.real(40, dashes.iter().map(|d| d.abs()).sum());
        for &dash in dashes {
            p.real(49, dash);
            if p.version().has_objects() {
                p.integer(74, 0);
            }
        }
    }
}

fn layers(p: &mut Pairs, table: Handle, skeleton: &Skeleton) {
    layer(p, table, skeleton, "0", 7, "Continuous", -3);
    for style in Layer::ALL.map(Layer::style) {
        layer(p, table, skeleton, style.name, style.colour, style.linetype, style.lineweight);
    }
}

fn layer(
    p: &mut Pairs,
    table: Handle,
    skeleton: &Skeleton,
    name: &str,
    colour: i64,
    linetype: &str,
    weight: i64,
) {
    record(p, "LAYER", "AcDbLayerTableRecord", table, name);
    p.integer(62, colour);
    p.word(6, linetype);
    if p.version().has_objects() {
        p.integer(370, weight);
        p.handle(390, skeleton.plot_style);
    }
}

fn text_style(p: &mut Pairs, table: Handle, skeleton: &Skeleton) {
    known_record(p, "STYLE", "AcDbTextStyleTableRecord", table, "Standard", skeleton.text_style);
    p.integer(70, 0);
    p.real(40, 0.0);
    p.real(41, 1.0);
    p.real(50, 0.0);
    p.integer(71, 0);
    p.real(42, 0.2);
    // R12 knows no TrueType fonts; later versions need one for letters beyond ASCII.
    p.word(3, if p.version().has_objects() { "arial.ttf" } else { "txt" });
    p.word(4, "");
}

/// Dimensions that a user adds later, with sizes for metres.
fn dimension_style(p: &mut Pairs, table: Handle, skeleton: &Skeleton) {
    record(p, "DIMSTYLE", "AcDbDimStyleTableRecord", table, "Standard");
    for (code, metres) in [(41, 0.2), (42, 0.05), (43, 0.3), (44, 0.1), (140, 0.2), (147, 0.05)] {
        p.real(code, metres);
    }
    if p.version().has_objects() {
        p.handle(340, skeleton.text_style);
    }
}

fn block_records(p: &mut Pairs, table: Handle, skeleton: &Skeleton) {
    for block in [&skeleton.model, &skeleton.paper] {
        known_record(p, "BLOCK_RECORD", "AcDbBlockTableRecord", table, block.block_name, block.record);
        p.handle(340, block.layout);
    }
    for (block, record) in &skeleton.symbols {
        known_record(p, "BLOCK_RECORD", "AcDbBlockTableRecord", table, block.name, *record);
        p.handle(340, Handle::NONE);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_view_shows_all() {
        let (centre, height) = view(Some((Point::new(0.0, 0.0), Point::new(32.0, 10.0))));
        assert_eq!(centre, Point::new(16.0, 5.0));
        assert!(height >= 10.0 && height * WINDOW_ASPECT >= 32.0);
    }

    #[test]
    fn the_view_of_a_point_has_an_extent() {
        let p = Point::new(3.0, 3.0);
        assert_eq!(view(Some((p, p))), (p, EMPTY_VIEW));
        assert_eq!(view(None).1, EMPTY_VIEW);
    }
}
