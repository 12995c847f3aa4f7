//! How many pixels an inch of paper has, as pictures say it.

use exif::{In, Reader, Tag, Value};

/// Densities that a scanner or a program can mean, pixels per inch.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 10.0..=10_000.0;
/// What cameras write because they do not know: it is the value that the Exif standard prescribes then.
const UNKNOWN: f64 = 72.0;
/// Pixels that are more oblong than this (fax machines) have no one density.
const SQUARE: f64 = 0.02;
const INCH: f64 = 0.0254;

/// One density of both, pixels per inch, if they make sense.
pub fn of_both(x: f64, y: f64) -> Option<f64> {
    let same = (x - y).abs() <= SQUARE * x.max(y);
    (same && PLAUSIBLE.contains(&x)).then_some(x)
}

/// As [`of_both`], from pixels per metre.
pub fn per_metre(x: f64, y: f64) -> Option<f64> {
    of_both(x * INCH, y * INCH)
}

/// As [`of_both`], from pixels per centimetre.
pub fn per_centimetre(x: f64, y: f64) -> Option<f64> {
    per_metre(x * 100.0, y * 100.0)
}

/// The density of a JPEG file: that of its Exif data, else that of its JFIF header.
pub fn of_jpeg(bytes: &[u8], exif: Option<Vec<u8>>) -> Option<f64> {
    match exif.and_then(of_exif) {
        Some(UNKNOWN) => None,
        Some(density) => Some(density),
        None => of_jfif(bytes),
    }
}

fn of_exif(raw: Vec<u8>) -> Option<f64> {
    let exif = Reader::new().read_raw(raw).ok()?;
    let number = |tag| match &exif.get_field(tag, In::PRIMARY)?.value {
        Value::Rational(values) => values.first().map(exif::Rational::to_f64),
        _ => None,
    };
    let (x, y) = (number(Tag::XResolution)?, number(Tag::YResolution)?);
    let unit = exif.get_field(Tag::ResolutionUnit, In::PRIMARY).and_then(|f| f.value.get_uint(0));
    match unit {
        Some(3) => per_centimetre(x, y),
        _ => of_both(x, y),
    }
}

/// JFIF: the segment APP0 right at the start.
fn of_jfif(bytes: &[u8]) -> Option<f64> {
    let segment = bytes.strip_prefix(b"\xff\xd8\xff\xe0")?;
    let fields = segment.get(2..)?.strip_prefix(b"JFIF\0")?.get(2..7)?;
    let &[unit, x_high, x_low, y_high, y_low] = fields else { return None };
    let (x, y) = (u16::from_be_bytes([x_high, x_low]), u16::from_be_bytes([y_high, y_low]));
    match unit {
        1 => of_both(x.into(), y.into()),
        2 => per_centimetre(x.into(), y.into()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jfif(unit: u8, x: u16, y: u16) -> Vec<u8> {
        let mut bytes = b"\xff\xd8\xff\xe0\x00\x10JFIF\0\x01\x02".to_vec();
        bytes.push(unit);
        bytes.extend(x.to_be_bytes());
        bytes.extend(y.to_be_bytes());
        bytes
    }

    /// Exif data with these two rationals and the unit.
    fn exif(x: u32, y: u32, unit: u16) -> Vec<u8> {
        let mut bytes = b"MM\0\x2a\0\0\0\x08\0\x03".to_vec();
        for (tag, at) in [(0x011a_u16, 50_u32), (0x011b, 58)] {
            bytes.extend(tag.to_be_bytes());
            bytes.extend([0, 5, 0, 0, 0, 1]);
            bytes.extend(at.to_be_bytes());
        }
        bytes.extend([0x01, 0x28, 0, 3, 0, 0, 0, 1]);
        bytes.extend(unit.to_be_bytes());
        bytes.extend([0, 0, 0, 0, 0, 0]);
        for number in [x, 1, y, 1] {
            bytes.extend(number.to_be_bytes());
        }
        bytes
    }

    #[test]
    fn jfif_counts_per_inch_or_centimetre() {
        assert_eq!(of_jpeg(&jfif(1, 300, 300), None), Some(300.0));
        assert_eq!(of_jpeg(&jfif(2, 100, 100), None), Some(254.0));
        for bytes in [jfif(0, 300, 300), jfif(1, 204, 98), jfif(1, 1, 1), jfif(1, 0, 0), vec![]] {
            assert_eq!(of_jpeg(&bytes, None), None);
        }
    }

    #[test]
    fn exif_goes_before_jfif_and_its_72_says_nothing() {
        assert_eq!(of_jpeg(&jfif(1, 96, 96), Some(exif(600, 600, 2))), Some(600.0));
        assert_eq!(of_jpeg(&jfif(1, 96, 96), Some(exif(100, 100, 3))), Some(254.0));
        assert_eq!(of_jpeg(&jfif(1, 72, 72), Some(exif(72, 72, 2))), None);
        assert_eq!(of_jpeg(&jfif(1, 96, 96), Some(b"MM junk".to_vec())), Some(96.0));
    }
}
