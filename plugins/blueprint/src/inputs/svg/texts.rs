//! The words of a drawing: from its `text` elements, whatever fonts there are.

use crate::found::SheetText;
use roxmltree::{Document, Node};
use std::str::FromStr;
use svgtypes::{Length, LengthUnit, Transform as SvgTransform, ViewBox};

/// A letter is about as wide as this, and a capital as high, as parts of the font's size.
const LETTER_WIDTH: f64 = 0.55;
const CAPITAL: f64 = 0.72;
/// The size of letters where nothing is said, units.
const FONT_SIZE: f64 = 16.0;
const UNITS_PER_INCH: f64 = 96.0;
/// Elements whose content is not drawn where it stands.
const APART: [&str; 8] = ["defs", "symbol", "pattern", "marker", "clipPath", "mask", "title", "desc"];

/// An affine map: x' = a x + c y + e, y' = b x + d y + f.
#[derive(Debug, Clone, Copy)]
pub struct Map {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    f: f64,
}

impl Map {
    fn scale(x: f64, y: f64) -> Self {
        Self { a: x, b: 0.0, c: 0.0, d: y, e: 0.0, f: 0.0 }
    }

    fn shift(x: f64, y: f64) -> Self {
        Self { e: x, f: y, ..Self::scale(1.0, 1.0) }
    }

    /// Followed by a scaling.
    pub fn scaled(self, factor: f64) -> Self {
        Self::scale(factor, factor).after(self)
    }

    /// This map after the other one.
    fn after(self, first: Self) -> Self {
        let [x, y, origin] = [(first.a, first.b), (first.c, first.d), (first.e, first.f)];
        let turn = |(x, y): (f64, f64)| (self.a * x + self.c * y, self.b * x + self.d * y);
        let ((a, b), (c, d), (e, f)) = (turn(x), turn(y), turn(origin));
        Self { a, b, c, d, e: e + self.e, f: f + self.f }
    }

    fn at(self, x: f64, y: f64) -> [f64; 2] {
        [self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f]
    }
}

/// What is inherited from the elements around.
#[derive(Clone, Copy)]
struct Style {
    size: f64,
    /// Where the text's position is along it: 0 the start, 1 the end.
    anchor: f64,
    /// Whether it stands on its position, or about it.
    centred: bool,
}

/// Whether the document says in real lengths how large it is.
pub fn paper_size(document: &Document<'_>) -> bool {
    let width = document.root_element().attribute("width").and_then(|w| Length::from_str(w).ok());
    use LengthUnit::{Cm, In, Mm, Pc, Pt};
    width.is_some_and(|w| matches!(w.unit, Mm | Cm | In | Pt | Pc))
}

/// From the coordinates inside of the `svg` element to a page of this size.
pub fn view_transform(document: &Document<'_>, [width, height]: [f64; 2]) -> Map {
    let root = document.root_element();
    let Some(view) = root.attribute("viewBox").and_then(|v| ViewBox::from_str(v).ok()) else {
        return Map::scale(1.0, 1.0);
    };
    let (x, y) = (width / view.w, height / view.h);
    if root.attribute("preserveAspectRatio").is_some_and(|p| p.trim() == "none") {
        return Map::scale(x, y).after(Map::shift(-view.x, -view.y));
    }
    // The view lies in the middle, which nearly all drawings leave as it is.
    let scale = x.min(y);
    let margin = Map::shift((width - view.w * scale) / 2.0, (height - view.h * scale) / 2.0);
    margin.after(Map::scale(scale, scale)).after(Map::shift(-view.x, -view.y))
}

/// The document's texts, one for each piece with a position of its own.
pub fn texts(document: &Document<'_>, to_page: Map) -> Vec<SheetText> {
    let style = Style { size: FONT_SIZE, anchor: 0.0, centred: false };
    let mut texts = vec![];
    let root = document.root_element();
    root.children().for_each(|child| walk(child, to_page, style.of(root), &mut texts));
    texts
}

/// The depth of documents is limited before.
fn walk(node: Node<'_, '_>, map: Map, style: Style, texts: &mut Vec<SheetText>) {
    let name = node.tag_name().name();
    if !node.is_element() || APART.contains(&name) || property(node, "display") == Some("none") {
        return;
    }
    let style = style.of(node);
    let map = map.after(own_transform(node));
    if name == "text" {
        write(node, map, style, texts);
    } else {
        node.children().for_each(|child| walk(child, map, style, texts));
    }
}

/// One `text` element: its own words, and each `tspan` with a position of its own.
fn write(node: Node<'_, '_>, map: Map, style: Style, texts: &mut Vec<SheetText>) {
    let placed =
        |n: &Node<'_, '_>| n.tag_name().name() == "tspan" && (n.has_attribute("x") || n.has_attribute("y"));
    let start = [position(node, "x").unwrap_or(0.0), position(node, "y").unwrap_or(0.0)];
    texts.extend(text(&words(node, &placed), start, map, style));
    for span in node.descendants().filter(|n| *n != node && placed(n)) {
        let at = [position(span, "x").unwrap_or(start[0]), position(span, "y").unwrap_or(start[1])];
        texts.extend(text(&words(span, &placed), at, map, style.of(span)));
    }
}

/// The words in a node, but for those in placed parts of it.
fn words(node: Node<'_, '_>, placed: &impl Fn(&Node<'_, '_>) -> bool) -> String {
    let mut words = String::new();
    for child in node.children() {
        match child.text() {
            Some(text) if child.is_text() => words.push_str(text),
            _ if placed(&child) => {}
            _ => words.push_str(&self::words(child, placed)),
        }
    }
    words
}

fn text(words: &str, [x, y]: [f64; 2], map: Map, style: Style) -> Option<SheetText> {
    let content = words.split_whitespace().collect::<Vec<_>>().join(" ");
    let width = style.size * LETTER_WIDTH * content.chars().count() as f64;
    let up = if style.centred { 0.0 } else { style.size * CAPITAL / 2.0 };
    let centre = map.at(x + width * (0.5 - style.anchor), y - up);
    let (along, across) = (map.a.hypot(map.b), map.c.hypot(map.d));
    let sound = centre.iter().chain([&along, &across]).all(|v| v.is_finite());
    (sound && !content.is_empty()).then(|| SheetText {
        content,
        centre,
        angle: map.b.atan2(map.a),
        width: width * along,
        height: style.size * CAPITAL * across,
        confidence: 1.0,
    })
}

impl Style {
    fn of(mut self, node: Node<'_, '_>) -> Self {
        if let Some(size) = property(node, "font-size").and_then(|s| length(s, self.size)) {
            self.size = size;
        }
        match property(node, "text-anchor") {
            Some("start") => self.anchor = 0.0,
            Some("middle") => self.anchor = 0.5,
            Some("end") => self.anchor = 1.0,
            _ => {}
        }
        match property(node, "dominant-baseline") {
            Some("middle" | "central") => self.centred = true,
            Some(_) => self.centred = false,
            None => {}
        }
        self
    }
}

/// A property of the element: of its style, else of its attributes.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let styled = node.attribute("style").and_then(|style| {
        let pairs = style.split(';').filter_map(|pair| pair.split_once(':'));
        pairs.filter(|(key, _)| key.trim() == name).map(|(_, value)| value.trim()).next_back()
    });
    styled.or_else(|| node.attribute(name).map(str::trim))
}

/// A length in units; `em` and percent are of `whole`.
fn length(text: &str, whole: f64) -> Option<f64> {
    let length = Length::from_str(text).ok()?;
    let unit = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em => whole,
        LengthUnit::Ex => whole / 2.0,
        LengthUnit::Percent => whole / 100.0,
        LengthUnit::In => UNITS_PER_INCH,
        LengthUnit::Cm => UNITS_PER_INCH / 2.54,
        LengthUnit::Mm => UNITS_PER_INCH / 25.4,
        LengthUnit::Pt => UNITS_PER_INCH / 72.0,
        LengthUnit::Pc => UNITS_PER_INCH / 6.0,
    };
    Some(length.number * unit)
}

/// The first number of a list of positions.
fn position(node: Node<'_, '_>, name: &str) -> Option<f64> {
    length(node.attribute(name)?.split([' ', ',']).find(|s| !s.is_empty())?, 0.0)
}

fn own_transform(node: Node<'_, '_>) -> Map {
    let transform =
        node.attribute("transform").and_then(|t| SvgTransform::from_str(t).ok()).unwrap_or_default();
    let SvgTransform { a, b, c, d, e, f } = transform;
    Map { a, b, c, d, e, f }
}
