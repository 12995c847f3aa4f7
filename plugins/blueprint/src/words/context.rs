//! What stands near a line: words that are sure tell which way round short ones beside them read, and that a digit which a
//! few strokes might make as well is one.

use super::components::Bounds;
use super::crop::Reading;
use super::plausible::{alphanumerics, joined};
use super::read::Answer;

/// A line read with this belief, of so many letters, tells about others.
const SURE: f64 = 0.8;
const SURE_LETTERS: usize = 3;
/// Lines of one label are at most so far apart, in heights of the taller one's letters.
const NEAR: f64 = 1.8;
/// Letters of one label differ in height by at most this part.
const SAME_HEIGHT: f64 = 0.35;

/// By how much the unusual way round has to read better.
const BETTER: f64 = 0.1;
/// The same where there are few letters, which often look like others upside down.
const BETTER_SHORT: f64 = 0.25;
const SHORT: f64 = 3.0;
/// The same of the other way round than the words beside it.
const BETTER_THAN_BESIDE: f64 = 0.4;
/// A number that is read upside down as letters is believed this much more than these.
const NUMBER: f64 = 0.2;

/// The most digits of a room's number; so sure it has to be to be told from letters upside down, alone.
const MOST_DIGITS: usize = 3;
const SURE_NUMBER: f64 = 0.8;

/// A line's place.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Its box.
    pub bounds: Bounds,
    /// Height of its tall letters, pixels.
    pub height: f64,
}

/// A line that was surely read.
#[derive(Debug, Clone, Copy)]
pub struct Sure {
    place: Place,
    reading: Reading,
}

impl Sure {
    /// The line of these answers, if it is one.
    pub fn of(place: Place, answers: &[Answer]) -> Option<Self> {
        let best = answers.iter().max_by(|a, b| a.belief.total_cmp(&b.belief))?;
        let letters = joined(&best.words).chars().filter(|c| c.is_alphabetic()).count();
        let sure = best.belief >= SURE && letters >= SURE_LETTERS;
        sure.then_some(Self { place, reading: best.reading })
    }
}

/// The way in which sure words read that stand in one label with the line, the nearest ones'.
pub fn beside(place: Place, sure: &[Sure]) -> Option<Reading> {
    let near = sure.iter().filter_map(|s| Some((apart(place, s.place)?, s.reading)));
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, reading)| reading)
}

/// How far apart two lines of one label are, in heights; nothing if they are of different ones, or the same.
fn apart(a: Place, b: Place) -> Option<f64> {
    let height = a.height.max(b.height);
    let gap = |a0: i32, a1: i32, b0: i32, b1: i32| f64::from((b0 - a1).max(a0 - b1).max(0));
    let (p, q) = (a.bounds, b.bounds);
    let far = gap(p.x0, p.x1, q.x0, q.x1).max(gap(p.y0, p.y1, q.y0, q.y1));
    let alike = (a.height - b.height).abs() <= SAME_HEIGHT * height;
    (p != q && alike && far <= NEAR * height).then_some(far / height)
}

/// Which of the ways round it reads, `letters` of them, next to words that read this way.
pub fn choose(mut answers: Vec<Answer>, letters: f64, beside: Option<Reading>) -> Option<Answer> {
    let Some(second) = (answers.len() > 1).then(|| answers.pop()).flatten() else { return answers.pop() };
    let first = answers.pop()?;
    if beside == Some(second.reading) {
        return Some(if first.belief > second.belief + BETTER_THAN_BESIDE { first } else { second });
    }
    let upside_down = may_be_number(&first) && is_number(&second) && second.belief >= SURE_NUMBER;
    if upside_down && beside.is_none() {
        return Some(second);
    }
    let number = if is_number(&first) { NUMBER } else { 0.0 };
    let better = match beside {
        Some(usual) if usual == first.reading => BETTER_THAN_BESIDE,
        _ if letters <= SHORT || is_number(&second) => BETTER_SHORT,
        _ => BETTER,
    };
    Some(if second.belief > first.belief + better + number { second } else { first })
}

/// Whether it may be a number upside down: few letters, not all of them digits.
pub fn may_be_number(answer: &Answer) -> bool {
    (2..=MOST_DIGITS).contains(&alphanumerics(&joined(&answer.words))) && !is_number(answer)
}

/// Whether nothing but digits was read.
fn is_number(answer: &Answer) -> bool {
    let text = joined(&answer.words);
    alphanumerics(&text) > 0 && text.chars().all(|c| !c.is_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::engine::OcrWord;

    fn answer(text: &str, reading: Reading, belief: f64) -> Answer {
        let words = vec![OcrWord { text: text.into(), bounds: [0; 4], confidence: belief }];
        Answer { words, reading, belief, width: 100 }
    }

    fn place(y0: i32) -> Place {
        Place { bounds: Bounds { x0: 0, y0, x1: 60, y1: y0 + 20 }, height: 20.0 }
    }

    fn chosen(first: (&str, f64), second: (&str, f64), beside: Option<Reading>) -> Reading {
        let answers =
            vec![answer(first.0, Reading::Right, first.1), answer(second.0, Reading::Left, second.1)];
        choose(answers, 3.0, beside).unwrap().reading
    }

    #[test]
    fn numbers_are_read_as_the_words_beside_them() {
        assert_eq!(chosen(("209", 0.6), ("602", 0.9), None), Reading::Right);
        assert_eq!(chosen(("209", 0.6), ("602", 0.7), Some(Reading::Left)), Reading::Left);
        assert_eq!(chosen(("209", 0.6), ("602", 0.95), Some(Reading::Right)), Reading::Right);
        assert_eq!(chosen(("SOT", 0.95), ("105", 0.9), None), Reading::Left);
        assert_eq!(chosen(("SOT", 0.95), ("105", 0.9), Some(Reading::Right)), Reading::Right);
        assert_eq!(chosen(("DOOA", 0.1), ("HALL", 0.75), None), Reading::Left);
    }

    #[test]
    fn only_what_is_near_is_beside() {
        let sure = Sure::of(place(0), &[answer("OFFICE", Reading::Left, 0.95)]);
        let sure: Vec<_> = sure.into_iter().collect();
        assert_eq!(beside(place(30), &sure), Some(Reading::Left));
        assert_eq!(beside(place(90), &sure), None);
        assert!(Sure::of(place(0), &[answer("209", Reading::Right, 0.95)]).is_none());
    }
}
