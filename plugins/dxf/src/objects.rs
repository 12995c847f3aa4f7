//! The BLOCKS and OBJECTS sections: model and paper space, and the dictionaries that every drawing has.

use crate::blocks::Block;
use crate::header::extents;
use crate::pairs::{Handle, Pairs};
use planform_sdk::Point;

/// The handles of all that is named from elsewhere in the file.
pub struct Skeleton {
    pub model: Space,
    pub paper: Space,
    /// The drawings of symbols, each with its block record.
    pub symbols: Vec<(Block, Handle)>,
    pub text_style: Handle,
    pub plot_style: Handle,
    root: Handle,
    groups: Handle,
    layouts: Handle,
    multiline_styles: Handle,
    multiline_style: Handle,
    plot_styles: Handle,
}

/// Model or paper space: a block record and its layout.
pub struct Space {
    pub block_name: &'static str,
    pub layout_name: &'static str,
    pub record: Handle,
    pub layout: Handle,
}

impl Skeleton {
    pub fn new(pairs: &mut Pairs, symbols: Vec<Block>) -> Self {
        let mut space = |block_name, layout_name| Space {
            block_name,
            layout_name,
            record: pairs.new_handle(),
            layout: pairs.new_handle(),
        };
        Self {
            model: space("*Model_Space", "Model"),
            paper: space("*Paper_Space", "Layout1"),
            symbols: symbols.into_iter().map(|block| (block, pairs.new_handle())).collect(),
            text_style: pairs.new_handle(),
            plot_style: pairs.new_handle(),
            root: pairs.new_handle(),
            groups: pairs.new_handle(),
            layouts: pairs.new_handle(),
            multiline_styles: pairs.new_handle(),
            multiline_style: pairs.new_handle(),
            plot_styles: pairs.new_handle(),
        }
    }
}

/// The BLOCKS section.
pub fn blocks(pairs: &mut Pairs, skeleton: &Skeleton) {
    pairs.section("BLOCKS", |p| {
        if p.version().has_objects() {
            for space in [&skeleton.model, &skeleton.paper] {
                block(p, space.block_name, space.record, |_| ());
            }
        }
        for (drawing, record) in &skeleton.symbols {
            block(p, drawing.name, *record, |p| drawing.entities().for_each(|e| e.write(p, *record)));
        }
    });
}

fn block(p: &mut Pairs, name: &str, record: Handle, content: impl FnOnce(&mut Pairs)) {
    block_part(p, "BLOCK", "AcDbBlockBegin", record);
    p.word(2, name);
    p.integer(70, 0);
    p.point_3d(10, Point::default());
    p.word(3, name);
    p.word(1, "");
    content(p);
    block_part(p, "ENDBLK", "AcDbBlockEnd", record);
}

fn block_part(p: &mut Pairs, kind: &str, class: &str, owner: Handle) {
    p.word(0, kind);
    let handle = p.new_handle();
    p.handle(5, handle);
    p.owner(owner);
    p.subclass("AcDbEntity");
    p.word(8, "0");
    p.subclass(class);
}

/// The OBJECTS section. The first object is the root of all others.
pub fn objects(pairs: &mut Pairs, s: &Skeleton, bounds: Option<(Point, Point)>) {
    pairs.section("OBJECTS", |p| {
        let root = [
            ("ACAD_GROUP", s.groups),
            ("ACAD_LAYOUT", s.layouts),
            ("ACAD_MLINESTYLE", s.multiline_styles),
            ("ACAD_PLOTSTYLENAME", s.plot_styles),
        ];
        dictionary(p, s.root, Handle::NONE, &root);
        dictionary(p, s.groups, s.root, &[]);
        let layouts = [&s.model, &s.paper].map(|space| (space.layout_name, space.layout));
        dictionary(p, s.layouts, s.root, &layouts);
        dictionary(p, s.multiline_styles, s.root, &[("Standard", s.multiline_style)]);
        multiline_style(p, s);
        plot_styles(p, s);
        layout(p, s, &s.model, 0, bounds);
        layout(p, s, &s.paper, 1, None);
    });
}

fn object(p: &mut Pairs, kind: &str, handle: Handle, owner: Handle) {
    p.word(0, kind);
    p.handle(5, handle);
    p.handle(330, owner);
}

fn dictionary(p: &mut Pairs, handle: Handle, owner: Handle, entries: &[(&str, Handle)]) {
    object(p, "DICTIONARY", handle, owner);
    dictionary_entries(p, entries);
}

fn dictionary_entries(p: &mut Pairs, entries: &[(&str, Handle)]) {
    p.word(100, "AcDbDictionary");
    p.integer(281, 1);
    for (name, entry) in entries {
        p.word(3, name);
        p.handle(350, *entry);
    }
}

fn plot_styles(p: &mut Pairs, s: &Skeleton) {
    object(p, "ACDBDICTIONARYWDFLT", s.plot_styles, s.root);
    dictionary_entries(p, &[("Normal", s.plot_style)]);
    p.word(100, "AcDbDictionaryWithDefault");
    p.handle(340, s.plot_style);
    object(p, "ACDBPLACEHOLDER", s.plot_style, s.plot_styles);
}

fn multiline_style(p: &mut Pairs, s: &Skeleton) {
    object(p, "MLINESTYLE", s.multiline_style, s.multiline_styles);
    p.word(100, "AcDbMlineStyle");
    p.word(2, "Standard");
    p.integer(70, 0);
    p.word(3, "");
    p.integer(62, 256);
    p.real(51, 90.0);
    p.real(52, 90.0);
    p.integer(71, 2);
    for offset in [0.5, -0.5] {
        p.real(49, offset);
        p.integer(62, 256);
        p.word(6, "BYLAYER");
    }
}

fn layout(p: &mut Pairs, s: &Skeleton, space: &Space, tab: i64, bounds: Option<(Point, Point)>) {
    object(p, "LAYOUT", space.layout, s.layouts);
    plot_settings(p, tab == 0);
    let (lo, hi) = extents(bounds);
    p.word(100, "AcDbLayout");
    p.word(1, space.layout_name);
    p.integer(70, 1);
    p.integer(71, tab);
    p.point_2d(10, Point::default());
    p.point_2d(11, Point::new(420.0, 297.0));
    p.point_3d(12, Point::default());
    p.point_3d(14, lo);
    p.point_3d(15, hi);
    p.real(146, 0.0);
    p.point_3d(13, Point::default());
    p.point_3d(16, Point::new(1.0, 0.0));
    p.point_3d(17, Point::new(0.0, 1.0));
    p.integer(76, 0);
    p.handle(330, space.record);
}

/// A3 paper, fitted.
fn plot_settings(p: &mut Pairs, model: bool) {
    p.word(100, "AcDbPlotSettings");
    p.word(1, "");
    p.word(2, "none_device");
    p.word(4, "ISO_A3_(420.00_x_297.00_MM)");
    p.word(6, "");
    for (code, value) in [(40, 7.5), (41, 20.0), (42, 7.5), (43, 20.0), (44, 420.0), (45, 297.0)] {
        p.real(code, value);
    }
    for code in [46, 47, 48, 49, 140, 141] {
        p.real(code, 0.0);
    }
    p.real(142, 1.0);
    p.real(143, 1.0);
    p.integer(70, if model { 1024 } else { 0 });
    p.integer(72, 1);
    p.integer(73, 0);
    p.integer(74, 5);
    p.word(7, "");
    p.integer(75, 0);
    p.real(147, 1.0);
    p.real(148, 0.0);
    p.real(149, 0.0);
}
