//! Elements, and the numbers and texts in them.

use svg::node::Text;
use svg::node::element::{Element, Group, Title};

/// A number for an attribute: four decimals (0.1 mm for metres) without needless zeros.
pub fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// The text without the characters that XML 1.0 forbids, which no escape can bring in.
pub fn legal(text: &str) -> String {
    text.chars().filter(|&c| is_legal(c)).collect()
}

fn is_legal(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..)
}

/// An element of nothing but a text, with no white space around it: `<text>` would show it.
pub fn with_text(name: &str, text: &str) -> Element {
    let mut element = Element::new(name);
    svg::Node::append(&mut element, Text::new(legal(text)));
    element
}

/// What a pointer resting on the element's parent shows.
pub fn title(text: &str) -> Title {
    Title::new(legal(text))
}

/// A layer, as Inkscape lists it; elsewhere a group with an id.
pub fn layer(id: &str) -> Group {
    Group::new().set("id", id).set("inkscape:groupmode", "layer").set("inkscape:label", id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases =
            [(1.0, "1"), (0.12345, "0.1235"), (-0.00001, "0"), (100.0, "100"), (-2.50, "-2.5"), (0.0, "0")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn forbidden_characters_go_and_all_others_stay() {
        assert_eq!(legal("a\u{0}b\u{1b}c\u{fffe}d\u{ffff}e\u{8}"), "abcde");
        assert_eq!(legal("Küche\t会議室\n🚪\u{fffd}"), "Küche\t会議室\n🚪\u{fffd}");
    }

    #[test]
    fn text_is_escaped_and_tight() {
        assert_eq!(with_text("text", "a<b & \"c\"").to_string(), "<text>a&lt;b &amp; \"c\"</text>");
    }
}
