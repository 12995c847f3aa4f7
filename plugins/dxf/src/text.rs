//! Texts as DXF can hold them: nothing in them can end a line, and no reader takes them for codes.

use crate::version::Version;
use std::fmt::Write;

const ELLIPSIS: &str = "...";
const ZERO_WIDTH_NON_JOINER: char = '\u{200C}';

/// The lines of a text, without control characters, blank ones left out.
pub fn lines(text: &str) -> Vec<String> {
    text.split(is_line_break).map(|line| one_line(line).trim().to_owned()).filter(|l| !l.is_empty()).collect()
}

/// The text with a space for each control character and line break.
pub fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || is_line_break(c) { ' ' } else { c }).collect()
}

fn is_line_break(c: char) -> bool {
    matches!(c, '\n' | '\r' | '\u{B}' | '\u{C}' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

/// The text as it is drawn: neighbouring percent signs are parted, since `%%d` would be drawn as a degree sign.
pub fn without_codes(text: &str) -> String {
    let mut parted = String::with_capacity(text.len());
    for c in text.chars() {
        if c == '%' && parted.ends_with('%') {
            parted.push(ZERO_WIDTH_NON_JOINER);
        }
        parted.push(c);
    }
    parted
}

/// One line as it stands in a file: at most `limit` bytes, cut between characters.
pub fn encode(line: &str, version: Version, limit: usize) -> String {
    let mut out = String::new();
    let mut room_for_ellipsis = 0;
    let mut rest = line.chars();
    while let Some(c) = rest.next() {
        encode_char(&mut out, c, rest.as_str(), version);
        if out.len() > limit {
            out.truncate(room_for_ellipsis);
            out.push_str(ELLIPSIS);
            break;
        }
        if out.len() + ELLIPSIS.len() <= limit {
            room_for_ellipsis = out.len();
        }
    }
    out
}

fn encode_char(out: &mut String, c: char, rest: &str, version: Version) {
    match c {
        c if c.is_control() => out.push(' '),
        // A caret begins the code of a control character.
        '^' => out.push_str("^ "),
        '\\' if !version.is_utf8() || begins_code(rest) => escape(out, c),
        c if c.is_ascii() || version.is_utf8() => out.push(c),
        c => escape(out, c),
    }
}

/// Whether a backslash before `rest` would be the start of an escape, such as `\U+0041`.
fn begins_code(rest: &str) -> bool {
    let mut next = rest.chars();
    matches!(next.next(), Some('U' | 'u' | 'M' | 'm')) && next.next() == Some('+')
}

fn escape(out: &mut String, c: char) {
    for unit in c.encode_utf16(&mut [0; 2]) {
        // Writing to a `String` cannot fail.
        let _ = write!(out, "\\U+{unit:04X}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn old(text: &str) -> String {
        encode(text, Version::R2000, 255)
    }

    fn new(text: &str) -> String {
        encode(text, Version::R2018, 255)
    }

    #[test]
    fn letters_beyond_ascii_are_escaped_before_utf8() {
        assert_eq!(old("Küche 厨"), "K\\U+00FCche \\U+53A8");
        assert_eq!(old("🚪"), "\\U+D83D\\U+DEAA");
        assert_eq!(new("Küche 🚪"), "Küche 🚪");
    }

    #[test]
    fn what_looks_like_an_escape_stays_text() {
        assert_eq!(old("\\U+0041"), "\\U+005CU+0041");
        assert_eq!(new("\\U+0041 C:\\x"), "\\U+005CU+0041 C:\\x");
        assert_eq!(new("a^Jb"), "a^ Jb");
    }

    #[test]
    fn nothing_ends_a_line() {
        assert_eq!(new("a\n0\rb\0c\u{85}"), "a 0 b c ");
        assert_eq!(lines("a\r\n\n b\u{2028}\tc"), ["a", "b", "c"]);
        assert_eq!(one_line("a\u{2029}b"), "a b");
    }

    #[test]
    fn percent_codes_are_parted() {
        assert_eq!(without_codes("%%d %%% 5%"), "%\u{200C}%d %\u{200C}%\u{200C}% 5%");
    }

    #[test]
    fn long_texts_are_cut_between_characters() {
        let cut = old(&"é".repeat(100));
        assert!(cut.len() <= 255 && cut.ends_with("\\U+00E9..."), "{cut}");
        assert_eq!(new(&"x".repeat(255)).len(), 255);
        assert_eq!(new(&"x".repeat(256)), "x".repeat(252) + "...");
    }
}
