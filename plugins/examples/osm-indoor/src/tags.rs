//! Keys and values, as OpenStreetMap takes them.

/// The most characters of a value.
const MAX_VALUE: usize = 255;

/// The tags of an object, in the order in which they are written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Tags(pub Vec<(&'static str, String)>);

impl Tags {
    /// These tags and one more. A value of nothing is no tag.
    pub fn with(mut self, key: &'static str, value: &str) -> Self {
        let value = clean(value);
        if !value.is_empty() {
            self.0.push((key, value));
        }
        self
    }

    /// The tag `indoor`, which says what the object is, and the level.
    pub fn indoor(kind: &str, level: &str) -> Self {
        Self::default().with("indoor", kind).with("level", level)
    }

    /// These tags and a `width`, metres, unless it is not a width.
    pub fn with_width(self, metres: f64) -> Self {
        let rounded = (metres * 100.0).round() / 100.0;
        if rounded.is_finite() && rounded > 0.0 { self.with("width", &rounded.to_string()) } else { self }
    }

    /// These tags and the room's name, as `ref` where it is more of a number.
    pub fn with_name(self, name: &str) -> Self {
        let name = clean(name);
        self.with(if is_reference(&name) { "ref" } else { "name" }, &name)
    }
}

/// Words with single blanks between them, cut to the length that OpenStreetMap takes. Control characters count as
/// blanks, and so do the two that XML has no way to write.
fn clean(value: &str) -> String {
    let is_blank = |c: char| c.is_whitespace() || c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}');
    let words: Vec<&str> = value.split(is_blank).filter(|w| !w.is_empty()).collect();
    let cut: String = words.join(" ").chars().take(MAX_VALUE).collect();
    cut.trim_end().into()
}

/// Whether a room's name is more of a number: it has a digit, and no more than two letters in a row, as "101", "B 1.04"
/// and "WC2" have it but "Lab 2" does not.
fn is_reference(name: &str) -> bool {
    let longest = name.split(|c: char| !c.is_alphabetic()).map(|run| run.chars().count()).max();
    name.chars().any(char::is_numeric) && longest.is_none_or(|n| n <= 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_one_line_of_what_xml_can_write() {
        assert_eq!(clean(" a\r\n\tb\u{0}\u{1b}c\u{ffff} "), "a b c");
        assert_eq!(clean("\u{7}"), "");
        assert_eq!(clean(&"é".repeat(300)).chars().count(), 255);
    }

    #[test]
    fn numbers_are_references_and_words_are_names() {
        for (name, key) in [
            ("101", "ref"),
            ("B 1.04", "ref"),
            ("WC2", "ref"),
            ("Lab 2", "name"),
            ("WC", "name"),
            ("会議室", "name"),
        ] {
            assert_eq!(Tags::default().with_name(name).0, [(key, name.to_owned())]);
        }
        assert_eq!(Tags::default().with_name("\n"), Tags::default());
    }

    #[test]
    fn widths_are_centimetres() {
        assert_eq!(Tags::default().with_width(0.904).0[0].1, "0.9");
        for none in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Tags::default().with_width(none), Tags::default());
        }
    }
}
