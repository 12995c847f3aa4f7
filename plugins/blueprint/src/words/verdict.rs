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
/// By how much more a text is to be believed that was cut off other things, or reads the unusual way round.
const ODD: f64 = 0.15;
/// Letters that are found where a few lines meet, and are no words by themselves.
const MADE_OF_LINES: &str = "01OoIlLTJCcDUuVvXxYriftjqdn/";
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
}

/// How tall the letters of the sheet are, of all sizes.
pub fn heights(cases: &[Case<'_>]) -> Vec<f64> {
    let sure = |c: &&Case<'_>| c.belief >= SURE && alphanumerics(c.text) >= SURE_LETTERS && !c.cut && c.usual;
    cases.iter().filter(sure).map(|c| c.height).collect()
}

/// Whether the line is text, `heights` being those of the sheet.
pub fn is_text(case: &Case<'_>, heights: &[f64]) -> bool {
    let letters = alphanumerics(case.text);
    let refused = (letters == 1 && !stands_alone(case)) || (letters < SURE_LETTERS && is_hatching(case));
    if refused || !plausible::is_text(case.text, case.belief, case.likeness) {
        return false;
    }
    let odd = if case.cut || !case.usual { ODD } else { 0.0 };
    let short = SHORT.get(letters.saturating_sub(1)).map_or(0.0, |s| s + odd);
    let least = if is_certain_measure(case.text) { MEASURE + odd } else { short };
    let alike = heights.iter().any(|h| (case.height - h).abs() <= SAME_HEIGHT * h);
    let alone = heights.is_empty() || (case.belief >= ALONE && letters >= SURE_LETTERS);
    case.belief >= least.min(0.95) && (alike || alone)
}

fn is_certain_measure(text: &str) -> bool {
    measures::parse(text).is_some_and(|m| m.is_certain())
}

/// Whether one letter is a text by itself.
fn stands_alone(case: &Case<'_>) -> bool {
    !case.cut && case.usual && !case.text.contains(|c| MADE_OF_LINES.contains(c))
}

/// Whether the text may be pieces of hatching, which is always cut off what it fills.
fn is_hatching(case: &Case<'_>) -> bool {
    case.cut && case.text.chars().filter(|c| c.is_alphanumeric()).all(|c| STRAIGHT.contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(text: &str, belief: f64, height: f64) -> Case<'_> {
        Case { text, belief, likeness: 0.7, height, cut: false, usual: true }
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
    fn hatching_is_no_word() {
        assert!(!is_text(&Case { cut: true, ..case("INN", 0.95, 12.0) }, &[12.0]));
        assert!(is_text(&Case { cut: true, ..case("OPS", 0.95, 12.0) }, &[12.0]));
    }
}
