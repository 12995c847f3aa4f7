//! Measures in a plan's texts: areas, sizes and lengths, which are no part of a room's name.

use std::ops::Range;

/// Square metres of a square foot.
const SQUARE_FOOT: f64 = 0.092_903_04;

/// Areas that a room can have, square metres.
const AREAS: Range<f64> = 0.1..1e5;

/// What an area's number is written with, and its square metres. Longer ones first, for they begin like shorter ones.
const AREA_UNITS: [(&str, f64); 17] = [
    ("square metres", 1.0),
    ("square meters", 1.0),
    ("square feet", SQUARE_FOOT),
    ("sq. ft.", SQUARE_FOOT),
    ("sq. ft", SQUARE_FOOT),
    ("sq.ft.", SQUARE_FOOT),
    ("sq.ft", SQUARE_FOOT),
    ("sq ft", SQUARE_FOOT),
    ("sqft", SQUARE_FOOT),
    ("sq m", 1.0),
    ("sqm", 1.0),
    ("ft²", SQUARE_FOOT),
    ("ft2", SQUARE_FOOT),
    ("m²", 1.0),
    ("m2", 1.0),
    ("qm", 1.0),
    ("sf", SQUARE_FOOT),
];

/// What a length's number is written with.
const LENGTH_UNITS: [&str; 10] = ["mm", "cm", "ft", "m", "''", "'", "\"", "′", "″", "’"];

/// What stands between the two lengths of a size.
const TIMES: [char; 3] = ['x', '×', '*'];

/// Words before an area that only say that it is one.
const HEADINGS: [&str; 10] =
    ["area", "fläche", "flaeche", "ngf", "nuf", "ca", "approx", "superficie", "surface", "a"];

/// A text parted into what it calls something, and what it measures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Parted {
    /// The words, one blank between two; empty if there are none.
    pub words: String,
    /// The first area, square metres.
    pub area: Option<f64>,
}

/// Parts a text. Bare numbers are words: rooms are called by them.
pub fn part(text: &str) -> Parted {
    let mut parted = Parted::default();
    let (mut from, mut at) = (0, 0);
    while let Some(start) = next_number(text, at) {
        let Some((length, area)) = measure(&text[start..]) else {
            at = start + number(&text[start..]).len();
            continue;
        };
        parted.add(before(&text[from..start], area.is_some()));
        parted.area = parted.area.or(area.filter(|a| AREAS.contains(a)));
        at = start + length;
        from = at;
    }
    parted.add(if from > 0 { text[from..].trim_start_matches(is_separator) } else { text });
    parted
}

impl Parted {
    fn add(&mut self, words: &str) {
        for word in words.split_whitespace() {
            if !self.words.is_empty() {
                self.words.push(' ');
            }
            self.words.push_str(word);
        }
    }
}

/// The words before a measure, without what leads to it.
fn before(words: &str, area: bool) -> &str {
    let words = words.trim_end_matches(is_separator);
    let last = words.rsplit(char::is_whitespace).next().unwrap_or_default();
    let leads = area && HEADINGS.iter().any(|h| last.trim_end_matches(is_separator).eq_ignore_ascii_case(h));
    if leads { before(&words[..words.len() - last.len()], false) } else { words }
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || "=:-–,;()[]/|~≈.".contains(c)
}

/// Where the next number begins that no letter or number runs into.
fn next_number(text: &str, from: usize) -> Option<usize> {
    let starts = |&(i, c): &(usize, char)| {
        let before = text[..i].chars().next_back();
        i >= from && c.is_ascii_digit() && !before.is_some_and(|b| b.is_alphanumeric() || ".,".contains(b))
    };
    text.char_indices().find(starts).map(|(i, _)| i)
}

/// The number that a text begins with: digits, with points and commas between them.
fn number(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').unwrap_or(text.len());
    text[..end].trim_end_matches(['.', ','])
}

/// The measure that a text begins with: its length in bytes, and the area if it is one.
fn measure(text: &str) -> Option<(usize, Option<f64>)> {
    area(text).map(|(length, area)| (length, Some(area))).or_else(|| size(text).map(|length| (length, None)))
}

fn area(text: &str) -> Option<(usize, f64)> {
    let number = number(text);
    let at = number.len() + blanks(&text[number.len()..]);
    let (unit, factor) = AREA_UNITS.into_iter().find(|(unit, _)| has_unit(&text[at..], unit))?;
    // Square feet are whole numbers, in which a comma parts thousands.
    let decimal = if factor < 1.0 { number.replace(',', "") } else { number.replace(',', ".") };
    Some((at + unit.len(), decimal.parse::<f64>().ok()? * factor))
}

/// A length with its unit, or two with a sign between them.
fn size(text: &str) -> Option<usize> {
    let (first, unit) = length(text)?;
    let sign = first + blanks(&text[first..]);
    let second = text[sign..].strip_prefix(TIMES).or_else(|| text[sign..].strip_prefix('X'));
    let second = second.map(|rest| text.len() - rest.len() + blanks(rest));
    let both = second.and_then(|at| length(&text[at..]).map(|(length, _)| at + length));
    both.or(unit.then_some(first))
}

/// A number and its unit, if it has one; feet may be followed by inches.
fn length(text: &str) -> Option<(usize, bool)> {
    let number = number(text);
    if number.is_empty() {
        return None;
    }
    let at = number.len() + blanks(&text[number.len()..]);
    let unit = LENGTH_UNITS.into_iter().find(|unit| has_unit(&text[at..], unit));
    let Some(unit) = unit else { return Some((number.len(), false)) };
    let end = at + unit.len();
    let feet = ["ft", "'", "′", "’"].contains(&unit);
    Some((end + if feet { inches(&text[end..]) } else { 0 }, true))
}

/// How long the inches are that follow feet: `-6"`, ` 6`.
fn inches(text: &str) -> usize {
    let at = text.len() - text.trim_start_matches([' ', '-']).len();
    let number = number(&text[at..]);
    let end = at + number.len();
    let unit = ["''", "\"", "″", "”"].into_iter().find(|unit| text[end..].starts_with(unit));
    match unit {
        _ if number.is_empty() => 0,
        Some(unit) => end + unit.len(),
        // Without a unit they stand close to the feet.
        None => {
            if at == 0 {
                end
            } else {
                0
            }
        }
    }
}

fn blanks(text: &str) -> usize {
    text.len() - text.trim_start_matches(' ').len()
}

/// Whether a text begins with a unit that no letter or number runs into.
fn has_unit(text: &str, unit: &str) -> bool {
    let begins = text.get(..unit.len()).is_some_and(|t| t.eq_ignore_ascii_case(unit));
    let ends = || {
        let after = text[unit.len()..].chars().next();
        !unit.ends_with(char::is_alphanumeric) || !after.is_some_and(char::is_alphanumeric)
    };
    begins && ends()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_are_read_and_left_out() {
        for (text, words, area) in [
            ("23.4 m²", "", 23.4),
            ("OFFICE 1 22,4m2", "OFFICE 1", 22.4),
            ("Küche: A = 12.5 m²", "Küche", 12.5),
            ("Büro (18 qm)", "Büro", 18.0),
            ("HALL 1,200 SQ. FT.", "HALL", 1200.0 * SQUARE_FOOT),
            ("150 sqft Den", "Den", 150.0 * SQUARE_FOOT),
        ] {
            let found = part(text);
            assert_eq!(found.words, words, "{text}");
            assert!((found.area.unwrap() - area).abs() < 1e-9, "{text}: {found:?}");
        }
    }

    #[test]
    fn lengths_and_sizes_are_left_out() {
        for (text, words) in [
            ("13'6 x 11'", ""),
            ("13'6\" x 11'", ""),
            ("BEDROOM 10'2\" x 11'1\"", "BEDROOM"),
            ("13'-6\"", ""),
            ("3.45 x 2.80", ""),
            ("4.76 x 3.79m", ""),
            ("2,10 m", ""),
            ("120cm", ""),
        ] {
            let found = part(text);
            assert_eq!((found.words.as_str(), found.area), (words, None), "{text}");
        }
    }

    #[test]
    fn names_and_numbers_are_words() {
        for text in ["210", "3.014", "OFFICE 3", "Room 2m0", "A-12.3", "WC", "2 men", "", "Ωμέγα 4", "m² 3."]
        {
            assert_eq!(part(text), Parted { words: text.into(), area: None });
        }
    }

    #[test]
    fn impossible_areas_are_none() {
        assert_eq!(part("0 m²"), Parted::default());
        assert_eq!(part("9999999999 m²"), Parted::default());
        assert_eq!(part("1.2.3 m²").area, None);
    }
}
