//! Whether what an engine read is words: it finds letters in furniture, too, if that is all it is shown.

use super::engine::OcrWord;
use super::measures;

/// A word below this confidence is one only if the line's shape says so.
const SURE: f64 = 0.6;
/// A word below this confidence is none, whatever the line looks like.
const LEAST: f64 = 0.25;
/// Measures are easily misread, but nothing else looks like them.
const LEAST_MEASURE: f64 = 0.4;
/// By how much more a measure is believed: it is none by chance, nor upside down.
const MEASURE: f64 = 1.2;
/// A short word of less confidence than this, beside one of more than that, is a piece of furniture.
const DOUBTFUL: f64 = 0.5;
const BESIDE_SURE: f64 = 0.85;
/// What the raised 2 is read as.
const RAISED: [char; 10] = ['²', '?', '*', '°', '"', '\'', '’', '”', '>', '“'];
/// Which part of a text is letters and digits, at least.
const LETTERS: f64 = 0.55;
/// One letter alone must be read with this confidence.
const SINGLE: f64 = 0.8;

/// What pieces of a frame around a text are read as.
const FRAME: &str = "[]{}|_~\\";

/// Marks that are written between letters and digits.
const MARKS: &str = ".,'\"’”“‘-–/&()²³:+%=°#*½¼¾⅛";

/// How sure it is, from 0 to 1, that these words, read from a line with this likeness to text, are what is written.
pub fn belief(words: &[OcrWord], likeness: f64, letters: f64) -> f64 {
    let text = joined(words);
    let read = alphanumerics(&text);
    if read == 0 || share(&text) < LETTERS {
        return if measures::parse(&text).is_some() { confidence(words) } else { 0.0 };
    }
    let ratio = read as f64 / letters;
    let fits = if (0.45..=2.6).contains(&ratio) { 1.0 } else { 0.6 };
    let measure = if measures::parse(&text).is_some() { MEASURE } else { 1.0 };
    (confidence(words) * measure).min(1.0)
        * odd(&text)
        * fits
        * if likeness < 0.3 && read > 1 { 0.8 } else { 1.0 }
}

/// Whether a text of this belief is one.
pub fn is_text(text: &str, belief: f64, likeness: f64) -> bool {
    let least = match alphanumerics(text) {
        _ if measures::parse(text).is_some_and(|m| m.is_certain()) => LEAST_MEASURE,
        0 => return false,
        1 => SINGLE,
        2 => SURE,
        _ => SURE - (SURE - LEAST) * likeness.clamp(0.0, 1.0),
    };
    belief >= least
}

/// The words of a line, and what stands before and behind them and was read as marks: a wall's end, a piece of a line.
pub fn parted(words: &[OcrWord]) -> (Vec<OcrWord>, Vec<OcrWord>) {
    let best = words.iter().map(|w| w.confidence).fold(0.0, f64::max);
    let doubtful = |w: &OcrWord| best >= BESIDE_SURE && w.confidence < DOUBTFUL && alphanumerics(&w.text) < 4;
    let stray = |w: &&OcrWord| is_stray(w) || doubtful(w);
    let before = words.iter().take_while(stray).count();
    let behind = words[before..].iter().rev().take_while(stray).count();
    let own = before..words.len() - behind;
    let stray = words[..own.start].iter().chain(&words[own.end..]).cloned().collect();
    (words[own].to_vec(), stray)
}

/// Whether the word is a misreading of something beside the text.
fn is_stray(word: &OcrWord) -> bool {
    let marks_only = alphanumerics(&word.text) == 0;
    let mark = |c: char| "'\"’”°&-–".contains(c);
    (marks_only && !word.text.chars().all(mark)) || word.confidence < LEAST / 2.0
}

/// Puts the unit of an area right whose raised 2 was seen: after a number the last word, whatever it was read as.
pub fn square(words: &mut [OcrWord]) {
    let [.., number, unit] = words else { return };
    let decimal = number.text.chars().all(|c| c.is_ascii_digit() || ".,".contains(c));
    if decimal && number.text.contains(['.', ',']) && unit.text.chars().count() <= 3 {
        unit.text = "m²".into();
        unit.confidence = unit.confidence.max(number.confidence);
    }
}

/// The text with the raised 2 of "m²" put right, which is read as whatever looks like it, without the marks that pieces
/// of a frame are read as, and with the blanks that belong into a measure.
pub fn mended(text: &str) -> String {
    let text = text.trim_matches(|c: char| FRAME.contains(c)).trim();
    // No word, but the last number of a scale bar.
    if matches!(text, "Sm" | "sm") {
        return "5 m".into();
    }
    numbered(&spaced(&with_squares(text)))
}

/// Numbers whose noughts and ones were taken for letters: "O1", "2l4".
fn numbered(text: &str) -> String {
    let likeness = |c: char| match c {
        'O' | 'o' => Some('0'),
        'l' | 'I' => Some('1'),
        c => c.is_ascii_digit().then_some(c),
    };
    let word = |word: &str| match word.chars().map(likeness).collect::<Option<String>>() {
        Some(number) if word.contains(|c: char| c.is_ascii_digit()) => number,
        _ => word.to_owned(),
    };
    text.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// Measures with the blanks that are easily overlooked: "5 m", "13'6 x 11'".
fn spaced(text: &str) -> String {
    let word = |word: &str| match (parts_of_size(word), number_and_unit(word)) {
        (Some((width, depth)), _) => format!("{width} x {depth}"),
        (_, Some((number, unit))) => format!("{number} {unit}"),
        _ => word.to_owned(),
    };
    text.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// The sides of a size in feet.
fn parts_of_size(word: &str) -> Option<(&str, &str)> {
    let (width, depth) = word.split_once(['x', 'X', '×'])?;
    let feet = |side: &str| side.starts_with(|c: char| c.is_ascii_digit()) && side.contains(['\'', '’', '°']);
    (feet(width) && depth.starts_with(|c: char| c.is_ascii_digit())).then_some((width, depth))
}

fn number_and_unit(word: &str) -> Option<(&str, &str)> {
    let at = word.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').filter(|&i| i > 0)?;
    let (number, unit) = word.split_at(at);
    matches!(unit, "m" | "m²" | "m2" | "sqm" | "qm" | "cm" | "mm").then_some((number, unit))
}

fn with_squares(text: &str) -> String {
    let words = text.split(' ').collect::<Vec<_>>();
    let after_number = |i: usize| i > 0 && words[i - 1].ends_with(|c: char| c.is_ascii_digit());
    let mend = |(i, word): (usize, &&str)| match word.strip_suffix(RAISED).and_then(|w| w.strip_suffix('m')) {
        Some(number)
            if number.ends_with(|c: char| c.is_ascii_digit()) || (number.is_empty() && after_number(i)) =>
        {
            format!("{number}m²")
        }
        _ => (*word).to_owned(),
    };
    words.iter().enumerate().map(mend).collect::<Vec<_>>().join(" ")
}

/// The words in one line.
pub fn joined(words: &[OcrWord]) -> String {
    words.iter().map(|w| w.text.as_str()).collect::<Vec<_>>().join(" ")
}

/// The words' mean confidence, long words counting more.
pub fn confidence(words: &[OcrWord]) -> f64 {
    let weight = |w: &OcrWord| w.text.chars().count() as f64;
    let total: f64 = words.iter().map(weight).sum();
    words.iter().map(|w| w.confidence * weight(w)).sum::<f64>() / total.max(1.0)
}

/// Letters and digits of a text.
pub fn alphanumerics(text: &str) -> usize {
    text.chars().filter(|c| c.is_alphanumeric()).count()
}

fn share(text: &str) -> f64 {
    let weight = |c: char| if c.is_alphanumeric() || MARKS.contains(c) { 0.5 } else { 1.0 };
    let others: f64 = text.chars().filter(|c| !c.is_alphanumeric() && !c.is_whitespace()).map(weight).sum();
    let own = alphanumerics(text) as f64;
    own / (own + others)
}

/// Less than 1 for what no word looks like: capitals after small letters, one letter again and again.
fn odd(text: &str) -> f64 {
    let letters: Vec<char> = text.chars().filter(|c| c.is_alphanumeric()).collect();
    let wrong_case = |w: &[char]| w[0].is_lowercase() && w[1].is_uppercase();
    let jumps = text.split_whitespace().map(|w| w.chars().collect::<Vec<_>>());
    let jumps = jumps.map(|w| w.windows(2).filter(|p| wrong_case(p)).count()).sum::<usize>();
    let case = if jumps > 1 {
        0.5
    } else if jumps == 1 {
        0.8
    } else {
        1.0
    };
    let first = letters.first().map(|c| c.to_ascii_lowercase());
    let same = letters.len() > 2 && letters.iter().all(|c| Some(c.to_ascii_lowercase()) == first);
    let same = same && first.is_some_and(|c| !c.is_ascii_digit());
    if same { case * 0.4 } else { case }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(text: &str, confidence: f64) -> OcrWord {
        OcrWord { text: text.into(), bounds: [0; 4], confidence }
    }

    fn accepted(text: &str, confidence: f64, likeness: f64) -> bool {
        let words: Vec<_> = text.split(' ').map(|t| word(t, confidence)).collect();
        let letters = text.chars().filter(|c| !c.is_whitespace()).count() as f64;
        is_text(text, belief(&words, likeness, letters), likeness)
    }

    #[test]
    fn words_are_believed_and_furniture_is_not() {
        assert!(accepted("OFFICE 7", 0.9, 0.8));
        assert!(accepted("Kitchen", 0.5, 0.9));
        assert!(accepted("23.4 m²", 0.5, 0.3));
        assert!(!accepted(";:~", 0.9, 0.9));
        assert!(!accepted("oOoO", 0.5, 0.9));
        assert!(!accepted("= | -", 0.8, 0.5));
        assert!(!accepted("7", 0.6, 0.3));
    }

    #[test]
    fn square_metres_are_mended() {
        assert_eq!(mended("49.2 m’ Corridor"), "49.2 m² Corridor");
        assert_eq!(mended("Store 19,3m?"), "Store 19,3 m²");
        assert_eq!(mended("Am? 13m2 m"), "Am? 13 m2 m");
    }

    #[test]
    fn a_raised_2_is_that_of_an_area() {
        let mut words = [word("49.2", 0.9), word("m*", 0.1)];
        square(&mut words);
        assert_eq!(joined(&parted(&words).0), "49.2 m²");
        let mut words = [word("Office", 0.9), word("1*", 0.1)];
        square(&mut words);
        assert_eq!(joined(&words), "Office 1*");
    }

    #[test]
    fn blanks_of_measures_are_put_in_and_frames_are_taken_off() {
        assert_eq!(mended("15'4x8'5"), "15'4 x 8'5");
        assert_eq!(mended("10m"), "10 m");
        assert_eq!(mended("[303 |"), "303");
        assert_eq!(mended("Sm"), "5 m");
        assert_eq!(mended("4x"), "4x");
    }

    #[test]
    fn letters_in_numbers_are_digits() {
        assert_eq!(mended("KITCHEN O1"), "KITCHEN 01");
        assert_eq!(mended("2l4"), "214");
        assert_eq!(mended("Ill B1o Oil"), "Ill B1o Oil");
    }

    #[test]
    fn what_stands_beside_words_is_parted_from_them() {
        let words = [word("(D0", 0.3), word("OFFICE", 0.95), word("|", 0.9), word("7", 0.9), word("=", 0.8)];
        let (own, stray) = parted(&words);
        assert_eq!((joined(&own).as_str(), stray.len()), ("OFFICE | 7", 2));
    }

    #[test]
    fn a_text_of_marks_alone_is_stray() {
        assert!(is_stray(&word("|", 0.9)));
        assert!(!is_stray(&word("&", 0.9)));
    }
}
