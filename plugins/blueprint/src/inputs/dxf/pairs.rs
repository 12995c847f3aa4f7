//! DXF as pairs of lines: a group code, and a value.

use encoding_rs::{Encoding, WINDOWS_1252};
use planform_sdk::{ErrorKind, Place, PluginError};

/// A group code and its value, blanks around it removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair<'a> {
    pub code: i32,
    pub value: &'a str,
}

impl Pair<'_> {
    /// Whether this begins the thing of this name: a section, a table, an entity.
    pub fn begins(&self, name: &str) -> bool {
        self.code == 0 && self.value == name
    }

    /// The value as a number, if it is one.
    pub fn number(&self) -> Option<f64> {
        self.value.parse().ok().filter(|v: &f64| v.is_finite())
    }
}

/// The text of the file. Since R2007 it is UTF-8, before that in the code page that the header names; but many a program
/// writes UTF-8 always.
pub fn decode(bytes: &[u8]) -> String {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => unescape(text),
        Err(_) => unescape(&encoding(bytes).decode_without_bom_handling(bytes).0),
    }
}

/// Letters that the code page lacks are written as `\U+00E4`.
fn unescape(text: &str) -> String {
    let mut pieces = text.split("\\U+");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let hex = piece.get(..4).and_then(|hex| u32::from_str_radix(hex, 16).ok());
        match hex.and_then(char::from_u32).filter(|c| !c.is_control()) {
            Some(letter) => out.extend([letter.encode_utf8(&mut [0; 4]) as &str, &piece[4..]]),
            None => out.extend(["\\U+", piece]),
        }
    }
    out
}

/// All pairs of a text, up to the end of the file. Comments are left out.
pub fn pairs(text: &str) -> Result<Vec<Pair<'_>>, PluginError> {
    let mut pairs = vec![];
    let mut lines = text.lines().enumerate();
    while let Some((number, code)) = lines.next() {
        let code = code.trim();
        let Some((_, value)) = lines.next() else {
            if code.is_empty() {
                break;
            }
            return Err(broken("a value is missing", number));
        };
        let code = code.parse().map_err(|_| broken("a group code is no number", number))?;
        let pair = Pair { code, value: value.trim() };
        if pair.begins("EOF") {
            break;
        }
        if code != 999 {
            pairs.push(pair);
        }
    }
    Ok(pairs)
}

fn broken(what: &str, line: usize) -> PluginError {
    PluginError::new(ErrorKind::BadInput, format!("the DXF is damaged: {what}"))
        .at(Place::Line(line + 1))
        .advise("save it again, as DXF of R12 to 2018 in text form")
}

/// The encoding of the code page in the header, as in `ANSI_1252`.
fn encoding(bytes: &[u8]) -> &'static Encoding {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(1 << 14)]);
    let page = head.split_once("$DWGCODEPAGE").and_then(|(_, rest)| rest.lines().nth(2));
    let label = match page.map(|p| p.trim().to_uppercase()).as_deref() {
        Some("ANSI_932" | "DOS932") => "shift_jis".to_owned(),
        Some("ANSI_936" | "GB2312") => "gbk".to_owned(),
        Some("ANSI_949" | "KSC5601" | "JOHAB") => "euc-kr".to_owned(),
        Some("ANSI_950" | "BIG5") => "big5".to_owned(),
        Some(name) => name.replace("ANSI_", "windows-"),
        None => return WINDOWS_1252,
    };
    Encoding::for_label(label.as_bytes()).unwrap_or(WINDOWS_1252)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_two_lines_each() {
        let all = pairs("  0\r\nLINE\r\n999\r\nwhy\r\n 10\r\n 1.5 \r\n  0\r\nEOF\r\njunk").unwrap();
        assert_eq!(all, [Pair { code: 0, value: "LINE" }, Pair { code: 10, value: "1.5" }]);
        assert_eq!(all[1].number(), Some(1.5));
    }

    #[test]
    fn damage_has_its_line() {
        let message = pairs("0\nLINE\nx\n1\n").unwrap_err().to_string();
        assert!(message.starts_with("line 3: the DXF is damaged: a group code is no number"), "{message}");
        assert!(
            pairs("0\nLINE\n8\n").unwrap_err().to_string().starts_with("line 3: the DXF is damaged: a value")
        );
    }

    #[test]
    fn code_pages_are_obeyed() {
        let header = |page: &str, letter: u8| {
            let mut bytes = format!("9\n$DWGCODEPAGE\n3\n{page}\n1\n").into_bytes();
            bytes.push(letter);
            decode(&bytes)
        };
        assert!(header("ANSI_1252", 0xfc).ends_with('ü'));
        assert!(header("ANSI_1251", 0xc6).ends_with('Ж'));
        assert!(decode("Küche".as_bytes()).ends_with("Küche"));
        assert_eq!(decode(br"K\U+00FCche \U+000A \U+x"), r"Küche \U+000A \U+x");
    }
}
