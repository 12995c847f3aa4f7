//! Measures as they are written in rooms and on dimension lines: areas, sizes, lengths and scales, metric and in feet and
//! inches, with the slips that reading makes.

use std::fmt;

const METRES_PER_FOOT: f64 = 0.3048;
const METRES_PER_INCH: f64 = 0.0254;

/// What a building may measure; beyond it a number is something else.
const LENGTHS: std::ops::RangeInclusive<f64> = 0.001..=10_000.0;
const AREAS: std::ops::RangeInclusive<f64> = 0.01..=10_000_000.0;
const RATIOS: std::ops::RangeInclusive<f64> = 1.0..=100_000.0;

/// Whole numbers without a unit are millimetres from here on; lesser ones are more often the number of a room.
const BARE_MILLIMETRES: std::ops::RangeInclusive<f64> = 500.0..=99_999.0;
/// Whole numbers without a unit in a size, "350 x 420", are centimetres within these bounds.
const BARE_CENTIMETRES: std::ops::Range<f64> = 100.0..1000.0;
/// Numbers with a fraction and without a unit are metres below this.
const BARE_METRES: f64 = 200.0;

/// A measure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// An area, square metres.
    Area(f64),
    /// A room's two sides, metres.
    Size {
        /// The side that is written first.
        width: f64,
        /// The other.
        depth: f64,
    },
    /// A length.
    Length {
        /// In metres.
        metres: f64,
        /// Whether the unit is written; otherwise it is guessed of the number.
        certain: bool,
    },
    /// How many times larger the building is than the paper: 100 for 1:100.
    Ratio(f64),
}

impl Measure {
    /// Whether nothing else can be meant.
    pub fn is_certain(&self) -> bool {
        !matches!(self, Self::Length { certain: false, .. })
    }

    fn is_sound(&self) -> bool {
        match self {
            Self::Area(area) => AREAS.contains(area),
            Self::Size { width, depth } => LENGTHS.contains(width) && LENGTHS.contains(depth),
            Self::Length { metres, .. } => LENGTHS.contains(metres),
            Self::Ratio(ratio) => RATIOS.contains(ratio),
        }
    }
}

/// As [`parse`] reads it again. A length without a certain unit is written in millimetres.
impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Area(area) => write!(f, "{area} m²"),
            Self::Size { width, depth } => write!(f, "{width} m x {depth} m"),
            Self::Length { metres, certain: true } => write!(f, "{metres} m"),
            Self::Length { metres, certain: false } => write!(f, "{:.0}", metres * 1000.0),
            Self::Ratio(ratio) => write!(f, "1:{ratio}"),
        }
    }
}

/// The first measure that the text tells. Areas, sizes and scales may stand among words ("approx. 1295 sq. feet"); a
/// length must be all there is, as numbers alone mean many things.
pub fn parse(text: &str) -> Option<Measure> {
    let text = normal(text);
    let anywhere =
        |read: fn(&str) -> Option<Measure>| starts(&text).find_map(|s| read(s).filter(Measure::is_sound));
    anywhere(ratio).or_else(|| anywhere(area)).or_else(|| anywhere(size)).or_else(|| length(&text))
}

/// The text with one sign for each meaning.
fn normal(text: &str) -> String {
    let sign = |c: char| match c {
        // A small foot mark is often read as a degree.
        '’' | '‘' | '′' | '`' | '´' | '°' => '\'',
        '”' | '“' | '″' | '„' => '"',
        '×' | '✕' => 'x',
        '²' => '2',
        '–' | '—' | '−' => '-',
        c if c.is_whitespace() => ' ',
        c => c.to_ascii_lowercase(),
    };
    let text: String = text.trim().chars().map(sign).collect();
    text.replace("''", "\"")
}

/// The text from each place on where a number begins.
fn starts(text: &str) -> impl Iterator<Item = &str> {
    let begins = |i: usize| !text[..i].ends_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',');
    let digits = text.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(i, _)| i);
    digits.filter(move |&i| begins(i)).map(|i| &text[i..])
}

/// "1:100", `1/8" = 1'-0"`, "1 cm = 1 m".
fn ratio(text: &str) -> Option<Measure> {
    if let Some(rest) = text.strip_prefix("1:").or_else(|| text.strip_prefix("1 :")) {
        return number(rest.trim_start()).map(|(n, _)| Measure::Ratio(n.value));
    }
    let (paper, rest) = fraction_of_inch(text).or_else(|| quantity(text).and_then(certain))?;
    let rest = rest.trim_start().strip_prefix('=')?;
    let (world, _) = quantity(rest.trim_start()).and_then(certain)?;
    Some(Measure::Ratio(world / paper))
}

/// `1/8"`, in metres.
fn fraction_of_inch(text: &str) -> Option<(f64, &str)> {
    let (value, rest) = fraction(text)?;
    let rest = inch_mark(rest)?;
    Some((value * METRES_PER_INCH, rest))
}

/// "1/8"
fn fraction(text: &str) -> Option<(f64, &str)> {
    let (above, rest) = number(text)?;
    let (below, rest) = number(rest.strip_prefix('/')?)?;
    (below.value > 0.0).then_some((above.value / below.value, rest))
}

fn certain((quantity, rest): (Quantity, &str)) -> Option<(f64, &str)> {
    Some((quantity.metres?, rest))
}

/// A number of square metres or square feet.
fn area(text: &str) -> Option<Measure> {
    let (number, rest) = number(text)?;
    let rest = rest.trim_start_matches([' ', '-']);
    if square_metres(rest) {
        return Some(Measure::Area(number.value));
    }
    let area = number.thousands * METRES_PER_FOOT * METRES_PER_FOOT;
    square_feet(rest).then_some(Measure::Area(area))
}

/// "m2", and what reading makes of the raised 2.
fn square_metres(text: &str) -> bool {
    const SIGNS: [char; 8] = ['2', '?', '*', '"', '\'', '7', 'z', '>'];
    let raised = text.strip_prefix('m').and_then(|t| t.trim_start_matches('^').strip_prefix(SIGNS));
    raised.is_some_and(ends_here) || begins_with(text, &["qm", "sqm", "sq m", "sq.m", "sq. m", "square m"])
}

fn square_feet(text: &str) -> bool {
    begins_with(text, &["sq ft", "sqft", "sq.ft", "sq. ft", "sq. f", "sq f", "square f", "ft2", "sf"])
}

fn begins_with(text: &str, units: &[&str]) -> bool {
    units.iter().any(|u| text.starts_with(u))
}

fn ends_here(rest: &str) -> bool {
    !rest.starts_with(|c: char| c.is_alphanumeric())
}

/// Two lengths with an x between them.
fn size(text: &str) -> Option<Measure> {
    let (first, rest) = quantity(text)?;
    let rest = rest.trim_start();
    let rest = rest.strip_prefix("by ").or_else(|| rest.strip_prefix(['x', '*']))?;
    let (second, rest) = quantity(rest.trim_start())?;
    if !ends_here(rest) {
        return None;
    }
    let factor = second.factor.or(first.factor);
    let bare = |q: &Quantity| if q.whole { bare_whole(q.number) } else { bare_fraction(q.number) };
    let metres = |q: &Quantity| q.metres.or_else(|| factor.map(|f| q.number * f)).or_else(|| bare(q));
    Some(Measure::Size { width: metres(&first)?, depth: metres(&second)? })
}

fn bare_fraction(number: f64) -> Option<f64> {
    (number < BARE_METRES).then_some(number)
}

fn bare_whole(number: f64) -> Option<f64> {
    if BARE_CENTIMETRES.contains(&number) {
        return Some(number / 100.0);
    }
    BARE_MILLIMETRES.contains(&number).then_some(number / 1000.0)
}

/// A length and nothing else.
fn length(text: &str) -> Option<Measure> {
    let (quantity, rest) = quantity(text)?;
    if !rest.trim_matches([' ', '.']).is_empty() {
        return None;
    }
    let certain = quantity.metres.is_some();
    let millimetres = || BARE_MILLIMETRES.contains(&quantity.number).then_some(quantity.number / 1000.0);
    let bare = || if quantity.whole { millimetres() } else { bare_fraction(quantity.number) };
    let metres = quantity.metres.or_else(bare)?;
    Some(Measure::Length { metres, certain }).filter(Measure::is_sound)
}

/// A length as written.
struct Quantity {
    /// If it has a unit.
    metres: Option<f64>,
    /// The number that was written, of feet if it has feet and inches.
    number: f64,
    /// Whether the number has no fraction.
    whole: bool,
    /// Metres in its unit, if that may hold for another number as well: "5.16 x 3.48m".
    factor: Option<f64>,
}

fn quantity(text: &str) -> Option<(Quantity, &str)> {
    let (n, rest) = number(text)?;
    let (value, whole) = (n.value, n.whole);
    if let Some(after) = foot_mark(rest) {
        let (inches, rest) = inches(after);
        let metres = value * METRES_PER_FOOT + inches * METRES_PER_INCH;
        return Some((Quantity { metres: Some(metres), number: value, whole, factor: None }, rest));
    }
    let (factor, rest) = unit(rest).map_or((None, rest), |(f, r)| (Some(f), r));
    Some((Quantity { metres: factor.map(|f| value * f), number: value, whole, factor }, rest))
}

/// Metres in a unit.
fn unit(text: &str) -> Option<(f64, &str)> {
    if let Some(rest) = inch_mark(text) {
        return Some((METRES_PER_INCH, rest));
    }
    let text = text.trim_start();
    let units = [("mm", 0.001), ("cm", 0.01), ("metres", 1.0), ("meters", 1.0), ("m", 1.0)];
    let named =
        |(name, factor): (&str, f64)| Some((factor, text.strip_prefix(name).filter(|r| ends_here(r))?));
    units.into_iter().find_map(named)
}

fn foot_mark(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let word = || text.strip_prefix("feet").or_else(|| text.strip_prefix("ft"));
    text.strip_prefix('\'').or_else(|| word().filter(|r| ends_here(r)).map(|r| r.trim_start_matches('.')))
}

fn inch_mark(text: &str) -> Option<&str> {
    let text = text.trim_start();
    let word = || text.strip_prefix("inches").or_else(|| text.strip_prefix("in")).filter(|r| ends_here(r));
    text.strip_prefix('"').or_else(word)
}

/// The inches after feet: `-6"`, ` 1"`, `6 1/2"`, `6`; none at all are 0.
fn inches(text: &str) -> (f64, &str) {
    let start = text.trim_start_matches([' ', '-']);
    let whole = match fraction(start) {
        Some((part, rest)) => Some((part, rest)),
        None => number(start).map(|(n, rest)| with_fraction(n.value, rest)),
    };
    match whole {
        Some((value, rest)) if value < 12.0 => (value, inch_mark(rest).unwrap_or(rest)),
        _ => (0.0, text),
    }
}

/// The number with the fraction that may follow it: "6 1/2", "6½".
fn with_fraction(whole: f64, text: &str) -> (f64, &str) {
    for (sign, value) in [('½', 0.5), ('¼', 0.25), ('¾', 0.75)] {
        if let Some(rest) = text.trim_start().strip_prefix(sign) {
            return (whole + value, rest);
        }
    }
    let part = text.strip_prefix([' ', '-']).and_then(fraction);
    part.map_or((whole, text), |(part, rest)| (whole + part, rest))
}

/// A number as written.
struct Number {
    value: f64,
    /// Whether it has no fraction.
    whole: bool,
    /// Its value if a comma before three digits does not begin a fraction but separates thousands.
    thousands: f64,
}

/// The number at the beginning, its fraction after a point or a comma.
fn number(text: &str) -> Option<(Number, &str)> {
    let digits = |t: &str| t.len() - t.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let before = digits(text);
    if before == 0 {
        return None;
    }
    let after = text[before..].strip_prefix(['.', ',']).map_or(0, digits);
    let end = if after > 0 { before + 1 + after } else { before };
    let value = text[..end].replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite())?;
    let separated = after == 3 && text[before..].starts_with(',');
    let thousands = if separated { text[..end].replace(',', "").parse().ok()? } else { value };
    Some((Number { value, whole: after == 0, thousands }, &text[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 0.006
    }

    #[test]
    fn areas() {
        for (text, expected) in [
            ("23.4 m²", 23.4),
            ("23,4 m2", 23.4),
            ("19.2m2", 19.2),
            ("6 m?", 6.0),
            ("13m*", 13.0),
            ("VARDAGSRUM 41m²", 41.0),
            ("8,50 qm", 8.5),
            ("250 sq ft", 23.226),
            ("7,936 SQFT", 737.279),
            ("Approx. 1295 sq. feet (120.31 sq. metres)", 120.309),
        ] {
            let Some(Measure::Area(area)) = parse(text) else { panic!("{text}: {:?}", parse(text)) };
            assert!(near(area, expected), "{text}: {area}");
        }
    }

    #[test]
    fn sizes() {
        for (text, expected) in [
            ("13'6 x 11'", (4.1148, 3.3528)),
            ("5.16m x 3.48m", (5.16, 3.48)),
            ("5.16 x 3.48m", (5.16, 3.48)),
            ("18'11\" x 11'5\"", (5.766, 3.480)),
            ("Bedroom 16’11” × 11’5”", (5.156, 3.480)),
            ("3.55 x 2.66", (3.55, 2.66)),
            ("3,55 x 2,66 8'4 x 8'2", (3.55, 2.66)),
            ("8'8\" x 18'1\" 2.64 x 5.51m", (2.6416, 5.5118)),
            ("350 x 420", (3.5, 4.2)),
            ("12' x 4'", (3.6576, 1.2192)),
            ("12'6 1/2\" x 4'", (3.8227, 1.2192)),
        ] {
            let Some(Measure::Size { width, depth }) = parse(text) else {
                panic!("{text}: {:?}", parse(text))
            };
            assert!(near(width, expected.0) && near(depth, expected.1), "{text}: {width} x {depth}");
        }
    }

    #[test]
    fn lengths() {
        for (text, expected, sure) in [
            ("3500", 3.5, false),
            ("3.50", 3.5, false),
            ("3,50 m", 3.5, true),
            ("350 cm", 3.5, true),
            ("12'-6\"", 3.81, true),
            ("124' 1\"", 37.821, true),
            ("64'", 19.507, true),
            ("11°10", 3.607, true),
            ("3' 5\"", 1.041, true),
            ("0.885", 0.885, false),
        ] {
            let Some(Measure::Length { metres, certain }) = parse(text) else {
                panic!("{text}: {:?}", parse(text))
            };
            assert!(near(metres, expected) && certain == sure, "{text}: {metres}");
        }
    }

    #[test]
    fn scales() {
        for (text, expected) in [
            ("1:100", 100.0),
            ("M 1:50", 50.0),
            ("Maßstab 1 : 200", 200.0),
            ("SCALE: 1/16\"=1'0\"", 192.0),
            ("1/8\" = 1'-0\"", 96.0),
            ("1\" = 20'", 240.0),
            ("1 cm = 1 m", 100.0),
        ] {
            let Some(Measure::Ratio(ratio)) = parse(text) else { panic!("{text}: {:?}", parse(text)) };
            assert!(near(ratio, expected), "{text}: {ratio}");
        }
    }

    #[test]
    fn other_texts_are_no_measures() {
        for text in
            ["", "OFFICE 7", "204", "OFFICE 12 m", "1", "m2", "2 x", "BH =700", "1:", "0:100", "A4", "x x"]
        {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    fn any_measure() -> impl Strategy<Value = Measure> {
        prop_oneof![
            (0.01..1e6_f64).prop_map(Measure::Area),
            (0.01..1e3_f64, 0.01..1e3_f64).prop_map(|(width, depth)| Measure::Size { width, depth }),
            (0.01..9e3_f64).prop_map(|metres| Measure::Length { metres, certain: true }),
            (500..99_999_u32)
                .prop_map(|mm| Measure::Length { metres: f64::from(mm) / 1000.0, certain: false }),
            (1.0..1e4_f64).prop_map(Measure::Ratio),
        ]
    }

    proptest! {
        #[test]
        fn no_text_is_too_odd(text in "\\PC*") {
            parse(&text);
        }

        #[test]
        fn no_measure_is_too_odd(text in "[0-9.,:/x'\"mft =²-]{0,24}") {
            prop_assert!(parse(&text).is_none_or(|m| m.is_sound()));
        }

        #[test]
        fn what_is_written_is_read(measure in any_measure()) {
            prop_assert_eq!(parse(&measure.to_string()), Some(measure));
        }
    }
}
