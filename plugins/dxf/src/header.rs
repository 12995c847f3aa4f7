//! The HEADER section, and the CLASSES of the objects used.

use crate::pairs::{Handle, Pairs};
use planform_sdk::Point;

/// `$INSUNITS`: metres.
const METRES: i64 = 6;
/// An empty drawing has these extents by convention: nothing lies between them.
const NOWHERE: (Point, Point) = (Point::new(1e20, 1e20), Point::new(-1e20, -1e20));

/// The bounds as `$EXTMIN` and `$EXTMAX` hold them.
pub fn extents(bounds: Option<(Point, Point)>) -> (Point, Point) {
    bounds.unwrap_or(NOWHERE)
}

/// The HEADER section. `seed` is the first handle that is free.
pub fn header(pairs: &mut Pairs, bounds: Option<(Point, Point)>, seed: Handle) {
    let version = pairs.version();
    let (lo, hi) = extents(bounds);
    let (limit_lo, limit_hi) = bounds.unwrap_or((Point::new(0.0, 0.0), Point::new(10.0, 10.0)));
    pairs.section("HEADER", |p| {
        variable(p, "$ACADVER").word(1, version.code());
        variable(p, "$DWGCODEPAGE").word(3, "ANSI_1252");
        variable(p, "$INSBASE").point_3d(10, Point::default());
        variable(p, "$EXTMIN").point_3d(10, lo);
        variable(p, "$EXTMAX").point_3d(10, hi);
        variable(p, "$LIMMIN").point_2d(10, limit_lo);
        variable(p, "$LIMMAX").point_2d(10, limit_hi);
        // The linetypes' dashes are given in metres already.
        variable(p, "$LTSCALE").real(40, 1.0);
        variable(p, "$TEXTSIZE").real(40, 0.2);
        variable(p, "$TEXTSTYLE").word(7, "Standard");
        variable(p, "$CLAYER").word(8, "0");
        variable(p, "$LUNITS").integer(70, 2);
        variable(p, "$LUPREC").integer(70, 3);
        if version.has_objects() {
            variable(p, "$MEASUREMENT").integer(70, 1);
            variable(p, "$INSUNITS").integer(70, METRES);
        } else {
            variable(p, "$HANDLING").integer(70, 1);
        }
        variable(p, "$HANDSEED").handle(5, seed);
    });
}

fn variable<'a>(pairs: &'a mut Pairs, name: &str) -> &'a mut Pairs {
    pairs.word(9, name);
    pairs
}

/// The CLASSES section.
pub fn classes(pairs: &mut Pairs) {
    pairs.section("CLASSES", |p| {
        class(p, "ACDBDICTIONARYWDFLT", "AcDbDictionaryWithDefault");
        class(p, "ACDBPLACEHOLDER", "AcDbPlaceHolder");
        class(p, "LAYOUT", "AcDbLayout");
    });
}

fn class(pairs: &mut Pairs, record: &str, class: &str) {
    pairs.word(0, "CLASS");
    pairs.word(1, record);
    pairs.word(2, class);
    pairs.word(3, "ObjectDBX Classes");
    pairs.integer(90, 0);
    if pairs.version().is_utf8() {
        pairs.integer(91, 1);
    }
    pairs.integer(280, 0);
    pairs.integer(281, 0);
}
