//! How sure the adapter is of a document.

use crate::document::{format_name, is_text, picture_format};
use planform_sdk::{Confidence, Probe};

/// A map server's YAML is surely ours; a picture may be a plan as well; any other YAML is most likely not ours.
pub fn probe(probe: &Probe<'_>) -> Confidence {
    if let Some(name) = picture_format(probe.head).and_then(format_name) {
        return Confidence::because(60, format!("a {name} picture by its first bytes"));
    }
    if probe.head.is_empty() || !is_text(probe.head) {
        return Confidence::no();
    }
    let text = String::from_utf8_lossy(probe.head);
    if has_key(&text, "image") && has_key(&text, "resolution") {
        return Confidence::because(95, "a map server's YAML by its keys `image` and `resolution`");
    }
    if matches!(probe.extension().as_str(), "yaml" | "yml") {
        return Confidence::because(5, "a YAML by its name, but without the keys `image` and `resolution`");
    }
    Confidence::no()
}

/// Whether a mapping in this text has the key: at the start of a line or after `{` or `,`, and before a colon.
fn has_key(text: &str, key: &str) -> bool {
    text.match_indices(key).any(|(at, _)| {
        let before = text[..at].trim_end_matches([' ', '\t', '"', '\'', '\u{feff}']);
        let after = text[at + key.len()..].trim_start_matches([' ', '\t', '"', '\'']);
        (before.is_empty() || before.ends_with(['\n', '\r', '{', ','])) && after.starts_with(':')
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn percent(path: &str, head: &[u8]) -> u8 {
        probe(&Probe { path: Path::new(path), head }).percent
    }

    #[test]
    fn map_yaml_is_sure_in_any_shape() {
        for text in [
            "image: a.pgm\nresolution: 0.05\n",
            "\u{feff}# caf\u{e9}\r\nresolution : 0.05\r\n\"image\": a.pgm",
            "{image: a.pgm, resolution: 1}",
        ] {
            assert_eq!(percent("", text.as_bytes()), 95, "{text}");
        }
        assert_eq!(percent("", b"# caf\xe9 in Latin-1\nimage: a\nresolution: 1"), 95);
    }

    #[test]
    fn other_text_is_not_ours() {
        assert_eq!(percent("x.yaml", b"name: x\nmy_image: y\nresolution: 1"), 5);
        for text in
            ["", "hello", "the image: and the resolution: of it", "BMW makes cars, not maps", "P2P nets"]
        {
            assert_eq!(percent("x.txt", text.as_bytes()), 0, "{text}");
        }
    }

    #[test]
    fn pictures_are_known_by_their_first_bytes() {
        let p = Probe { path: Path::new(""), head: b"\x89PNG\r\n\x1a\n" };
        assert_eq!(probe(&p), Confidence::because(60, "a PNG picture by its first bytes"));
        assert_eq!(percent("x", b"P5\n# c\n1 1 255\n\0"), 60);
        assert_eq!(percent("x.png", b"\0\x01\x02 no picture"), 0);
        assert_eq!(percent("x.gif", b"GIF89a\x01\0\x01\0"), 0);
    }
}
