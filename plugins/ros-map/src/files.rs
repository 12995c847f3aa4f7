//! The two files.

use crate::canvas::Canvas;
use crate::frame::Frame;
use crate::openings::Stated;
use planform_sdk::{OpeningKind, PluginError, Point};
use std::io::{self, Write};

/// Places of openings are written to the tenth of a millimetre.
const DIGITS: f64 = 1e4;

/// The YAML file, in the order of keys and with the style of nav2's `map_saver`; numbers with all their digits.
pub fn write_yaml(
    frame: &Frame,
    image: &str,
    openings: &[Stated],
    out: &mut dyn Write,
) -> Result<(), PluginError> {
    write_map(frame, image, out)?;
    write_openings(openings, out)
}

fn write_map(frame: &Frame, image: &str, out: &mut dyn Write) -> io::Result<()> {
    let Frame { resolution, origin, .. } = frame;
    writeln!(out, "image: {}", scalar(image))?;
    writeln!(out, "mode: trinary")?;
    writeln!(out, "resolution: {resolution}")?;
    writeln!(out, "origin: [{}, {}, {}]", origin.x, origin.y, origin.yaw)?;
    writeln!(out, "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196")
}

/// All openings between rooms, under a key that map servers pass over: where one is as wide as its rooms, nothing else
/// tells where one room ends and the next begins.
fn write_openings(openings: &[Stated], out: &mut dyn Write) -> Result<(), PluginError> {
    writeln!(out, "planform:")?;
    if openings.is_empty() {
        writeln!(out, "  openings: []")?;
        return Ok(());
    }
    writeln!(out, "  openings:")?;
    for opening in openings {
        let kind = match opening.kind {
            OpeningKind::Door => "door",
            OpeningKind::Passage => "passage",
        };
        let [from, to] = [place(opening.segment.a)?, place(opening.segment.b)?];
        let depth = rounded(opening.depth);
        writeln!(out, "    - {{kind: {kind}, from: {from}, to: {to}, depth: {depth}}}")?;
    }
    Ok(())
}

fn place(p: Point) -> Result<String, PluginError> {
    let p = p.finite()?;
    Ok(format!("[{}, {}]", rounded(p.x), rounded(p.y)))
}

fn rounded(v: f64) -> f64 {
    // Zero has no sign.
    (v * DIGITS).round() / DIGITS + 0.0
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
    use planform_sdk::{Pose, Segment};

    const FRAME: Frame =
        Frame { width: 2, height: 3, resolution: 0.05, origin: Pose { x: -3.25, y: 1e-7, yaw: 0.0 } };

    #[test]
    fn yaml_has_the_keys_of_map_savers() {
        let mut out = vec![];
        write_yaml(&FRAME, "map.pgm", &[], &mut out).unwrap();
        let expected = "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-3.25, 0.0000001, 0]\n\
            negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nplanform:\n  openings: []\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
    }

    #[test]
    fn openings_have_a_line_each() {
        let segment = Segment::new(Point::new(1.0 / 3.0, -1e-9), Point::new(2.0, -0.5));
        let openings =
            [OpeningKind::Door, OpeningKind::Passage].map(|kind| Stated { kind, segment, depth: 0.2 });
        let mut out = vec![];
        write_openings(&openings, &mut out).unwrap();
        let expected = "planform:\n  openings:\n\
            \x20   - {kind: door, from: [0.3333, 0], to: [2, -0.5], depth: 0.2}\n\
            \x20   - {kind: passage, from: [0.3333, 0], to: [2, -0.5], depth: 0.2}\n";
        assert_eq!(String::from_utf8(out).unwrap(), expected);
        let endless = Segment::new(Point::new(f64::NAN, 0.0), Point::new(2.0, -0.5));
        assert!(write_openings(&[Stated { segment: endless, ..openings[0].clone() }], &mut vec![]).is_err());
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
