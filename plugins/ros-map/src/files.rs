//! The two files.

use crate::canvas::Canvas;
use crate::frame::Frame;
use std::io::{self, Write};

/// The YAML file, in the order of keys and with the style of nav2's `map_saver`; numbers with all their digits.
pub fn write_yaml(frame: &Frame, image: &str, out: &mut dyn Write) -> io::Result<()> {
    let Frame { resolution, origin, .. } = frame;
    writeln!(out, "image: {}", scalar(image))?;
    writeln!(out, "mode: trinary")?;
    writeln!(out, "resolution: {resolution}")?;
    writeln!(out, "origin: [{}, {}, {}]", origin.x, origin.y, origin.yaw)?;
    writeln!(out, "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196")
}

/// A text as YAML: plain where nothing in it could mean anything else, or in quotes.
fn scalar(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-');
    if text.starts_with(|c: char| c.is_ascii_alphanumeric()) && text.chars().all(plain) {
        return text.into();
    }
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}') => {
                quoted.push_str(&format!("\\u{:04x}", u32::from(c)));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// The picture, top row first.
pub fn write_pgm(canvas: &Canvas, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "P5\n{} {}\n255\n", canvas.width(), canvas.rows().len())?;
    for row in canvas.rows().rev() {
        let greys: Vec<u8> = row.iter().map(|p| *p as u8).collect();
        out.write_all(&greys)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::Paint;
    use planform_sdk::{Point, Pose};

    const FRAME: Frame =
        Frame { width: 2, height: 3, resolution: 0.05, origin: Pose { x: -3.25, y: 1e-7, yaw: 0.0 } };

    #[test]
    fn yaml_has_the_keys_of_map_savers() {
        let mut out = vec![];
        write_yaml(&FRAME, "map.pgm", &mut out).unwrap();
        let expected = "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-3.25, 0.0000001, 0]\n\
            negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }

    #[test]
    fn odd_names_are_quoted() {
        for (name, expected) in [
            ("ground_floor-1.pgm", "ground_floor-1.pgm"),
            ("my map.pgm", "\"my map.pgm\""),
            ("-a: \"b\" #\\.pgm", "\"-a: \\\"b\\\" #\\\\.pgm\""),
            ("Gebäude\n.pgm", "\"Gebäude\\u000a.pgm\""),
        ] {
            assert_eq!(scalar(name), expected);
        }
    }

    #[test]
    fn the_top_row_comes_first() {
        let mut canvas = Canvas::new(&FRAME);
        let bottom = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(Point::from).to_vec();
        canvas.fill(&[bottom], Paint::Occupied, &[Paint::Unknown]);
        let mut out = vec![];
        write_pgm(&canvas, &mut out).unwrap();
        assert_eq!(out, b"P5\n2 3\n255\n\xcd\xcd\xcd\xcd\x00\x00");
    }
}
