//! Which lines are text, judged by what was read in all of them: words that are sure tell how tall the letters of the
//! sheet are, and what is short or unsure has to be as tall.

use super::measures;
use super::plausible::{self, alphanumerics};

/// Words so sure, of so many letters, tell how tall letters are.
const SURE: f64 = 0.78;
const SURE_LETTERS: usize = 4;
/// A line this sure, of so many letters, needs no other like it.
const ALONE: f64 = 0.85;
/// Heights within this part of each other are the same.
const SAME_HEIGHT: f64 = 0.25;
/// The least belief in short texts: of one letter, of two, of three and four.
const SHORT: [f64; 4] = [0.85, 0.64, 0.55, 0.48];
/// The same in measures.
const MEASURE: f64 = 0.4;
/// By how much less a text has to be believed that belongs to a label of sure words.
const BESIDE: f64 = 0.15;
/// So many other numbers beside one, of one height and on one level, make a row, as under a scale bar.
const ROW: usize = 2;
/// Levels within this part of a height are the same.
const LEVEL: f64 = 0.3;
/// A digit in a row, or beside words, is believed from here on.
const DIGIT: f64 = 0.8;
/// By how much more a text is to be believed that was cut off other things, or reads the unusual way round.
const ODD: f64 = 0.15;
/// Letters that are found where a few lines meet, and are no words by themselves.
const MADE_OF_LINES: &str = "01OoIlLTJCcDUuVvXxYriftjqdn/";
/// Letters that rings and arcs make, of fixtures and doors.
const ROUND: &str = "OoCcDQ";
/// Letters that are found in hatching.
const STRAIGHT: &str = "AEFHIKLMNTVWXYZilvwxyz1247/\\";

/// What is known of a line that was read.
pub struct Case<'a> {
    /// What it says.
    pub text: &'a str,
    /// From 0 to 1.
    pub belief: f64,
    /// How much it looks like text.
    pub likeness: f64,
    /// How tall its letters are, pixels.
    pub height: f64,
    /// Whether most of it was cut off larger things.
    pub cut: bool,
    /// Whether it reads the usual way round.
    pub usual: bool,
    /// How far down the middle of its box lies, pixels.
    pub level: f64,
    /// Whether it belongs to a label of words that are sure.
    pub beside: bool,
    /// Whether it stands in a row of numbers.
    pub in_row: bool,
}

/// Marks what stands in a row of numbers.
pub fn find_rows(cases: &mut [Case<'_>]) {
    let number = |c: &Case<'_>| c.belief >= DIGIT && !c.cut && c.usual && begins_with_digit(c.text);
    let numbers: Vec<_> = cases.iter().filter(|c| number(c)).map(|c| (c.level, c.height)).collect();
    for case in cases.iter_mut().filter(|c| number(c)) {
        let beside = |(level, height): &&(f64, f64)| {
            (level - case.level).abs() <= LEVEL * case.height
                && (height - case.height).abs() <= SAME_HEIGHT * case.height
        };
        // It is beside itself.
        case.in_row = numbers.iter().filter(beside).count() > ROW;
    }
}

fn begins_with_digit(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit())
}

/// How tall the letters of the sheet are, of all sizes.
pub fn heights(cases: &[Case<'_>]) -> Vec<f64> {
    let sure = |c: &&Case<'_>| c.belief >= SURE && alphanumerics(c.text) >= SURE_LETTERS && !c.cut && c.usual;
    cases.iter().filter(sure).map(|c| c.height).collect()
}

/// Whether the line is text, `heights` being those of the sheet.
pub fn is_text(case: &Case<'_>, heights: &[f64]) -> bool {
    let letters = alphanumerics(case.text);
    let drawn = is_hatching(case) || case.text.chars().all(|c| ROUND.contains(c));
    let refused = (letters == 1 && !stands_alone(case)) || (letters < SURE_LETTERS && drawn);
    let belief = if case.beside { case.belief + BESIDE } else { case.belief };
    if refused || !plausible::is_text(case.text, belief, case.likeness) {
        return false;
    }
    let odd = if case.cut || !(case.usual || case.beside) { ODD } else { 0.0 };
    let odd = if case.beside { odd - BESIDE } else { odd };
    let short = SHORT.get(letters.saturating_sub(1)).map_or(0.0, |s| s + odd);
    let least = if is_certain_measure(case.text) { MEASURE + odd } else { short };
    let alike = case.in_row || heights.iter().any(|h| (case.height - h).abs() <= SAME_HEIGHT * h);
    let alone = heights.is_empty() || (case.belief >= ALONE && letters >= SURE_LETTERS);
    case.belief >= least.min(0.95) && (alike || alone)
}

fn is_certain_measure(text: &str) -> bool {
    measures::parse(text).is_some_and(|m| m.is_certain())
}

/// Whether one letter is a text by itself.
fn stands_alone(case: &Case<'_>) -> bool {
    let digit = (case.beside || case.in_row) && case.belief >= DIGIT && begins_with_digit(case.text);
    !case.cut && (digit || (case.usual && !case.text.contains(|c| MADE_OF_LINES.contains(c))))
}

/// Whether the text may be pieces of hatching, which is always cut off what it fills.
fn is_hatching(case: &Case<'_>) -> bool {
    case.cut && case.text.chars().filter(|c| c.is_alphanumeric()).all(|c| STRAIGHT.contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(text: &str, belief: f64, height: f64) -> Case<'_> {
        Case {
            text,
            belief,
            likeness: 0.7,
            height,
            cut: false,
            usual: true,
            level: 9.0,
            beside: false,
            in_row: false,
        }
    }

    #[test]
    fn short_texts_are_as_tall_as_sure_ones() {
        let heights = heights(&[case("KITCHEN", 0.95, 12.0), case("doad", 0.5, 40.0)]);
        assert_eq!(heights, [12.0]);
        assert!(is_text(&case("WC", 0.9, 11.0), &heights));
        assert!(!is_text(&case("Qs", 0.9, 40.0), &heights));
        assert!(is_text(&case("SECOND FLOOR", 0.9, 40.0), &heights));
    }

    #[test]
    fn a_letter_alone_is_none_that_lines_make() {
        assert!(is_text(&case("7", 0.95, 12.0), &[12.0]));
        assert!(!is_text(&case("L", 0.95, 12.0), &[12.0]));
        assert!(!is_text(&Case { cut: true, ..case("7", 0.95, 12.0) }, &[12.0]));
    }

    #[test]
    fn a_digit_beside_words_or_in_a_row_is_one() {
        assert!(!is_text(&case("1", 0.95, 12.0), &[12.0]));
        assert!(is_text(&Case { beside: true, ..case("1", 0.95, 12.0) }, &[12.0]));
        let mut row = [case("0", 0.9, 12.0), case("1", 0.95, 12.0), case("2 m", 0.9, 13.0)];
        find_rows(&mut row);
        assert!(row.iter().all(|c| c.in_row && is_text(c, &[12.0])));
        row[2].level = 40.0;
        find_rows(&mut row);
        assert!(row.iter().all(|c| !c.in_row));
    }

    #[test]
    fn rings_and_hatching_are_no_words() {
        assert!(!is_text(&case("OO", 0.95, 12.0), &[12.0]));
        assert!(!is_text(&Case { cut: true, ..case("INN", 0.95, 12.0) }, &[12.0]));
        assert!(is_text(&Case { cut: true, ..case("OPS", 0.95, 12.0) }, &[12.0]));
    }
}
