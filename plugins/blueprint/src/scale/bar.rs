//! Scale from a scale bar: rising numbers along a bar, from 0, the last one with its unit.

use super::consensus::Measurement;
use super::trace::Ray;
use crate::found::SheetText;
use crate::mask::Mask;

/// The marks of a bar: their numbers, and their places along the reading direction.
struct Marks<'a> {
    first: &'a SheetText,
    /// Distance of the middles of the first and the last number, pixels.
    span: f64,
    metres: f64,
}

/// Metres per pixel by every scale bar. `ink` holds the bars, not the letters.
pub fn measurements(texts: &[SheetText], ink: &Mask) -> Vec<Measurement> {
    let apart = texts.iter().filter_map(|zero| marks_apart(zero, texts));
    let together = texts.iter().filter_map(marks_together);
    let found: Vec<_> = apart.chain(together).filter_map(|marks| measurement(&marks, ink)).collect();
    if found.is_empty() { texts.iter().filter_map(|t| by_last_mark(t, ink)).collect() } else { found }
}

/// The lengths that scale bars usually have, metres.
const USUAL: [f64; 8] = [1.0, 2.0, 3.0, 4.0, 5.0, 10.0, 20.0, 50.0];

/// A bar whose other numbers could not be read: it ends at the number with the unit, is thick, and stands alone.
fn by_last_mark(text: &SheetText, ink: &Mask) -> Option<Measurement> {
    let text = &SheetText { content: digits(&text.content), ..text.clone() };
    let [metres] = numbers(&text.content)[..] else { return None };
    unit(&text.content).filter(|u| *u == 1.0 && USUAL.contains(&metres))?;
    let ray = Ray::new(text.centre, text.angle);
    let at = -unit_shift(text);
    let height = text.height.max(3.0);
    let reach = (2.5 * height).ceil() as i64;
    let inner = Ray { at: ray.point(at - height, 0.0), along: ray.along };
    let bars = (1..=reach).flat_map(|t| [t as f64, -(t as f64)]).filter_map(|t| {
        let [from, to] = inner.run(ink, t, 1.5, 0.0)?;
        let ends_there = (to - height).abs() < 0.7 * height;
        let alone = |t: f64| (from as i64..to as i64).all(|s| !inner.ink(ink, s as f64, t));
        let stands_alone = alone(t + 1.6 * height) || alone(t - 1.6 * height);
        (ends_there && to - from > 4.0 * height && stands_alone).then_some(to - from)
    });
    let lengths: Vec<f64> = bars.collect();
    // Where every other part of the bar is hollow only its outlines are whole.
    let length = lengths.iter().copied().fold(0.0, f64::max);
    let thick = lengths.iter().filter(|l| **l > 0.98 * length).count() >= 2;
    thick.then(|| Measurement { value: metres / length, weight: 1.0 })
}

/// Numbers that are texts of their own: `0`, `5` and `10 m` on one line.
fn marks_apart<'a>(zero: &'a SheetText, texts: &'a [SheetText]) -> Option<Marks<'a>> {
    if !zero.content.trim().starts_with('0') || numbers(&zero.content).first() != Some(&0.0) {
        return None;
    }
    let ray = Ray::new(zero.centre, zero.angle);
    let on_line = texts.iter().filter_map(|t| {
        let [s, across] = ray.local(t.centre);
        let near = s > zero.height && across.abs() < 0.6 * zero.height && s < 60.0 * zero.height;
        let number = numbers(&t.content).last().copied();
        near.then_some((s, number?, unit(&t.content), t))
    });
    let mut on_line: Vec<_> = on_line.collect();
    on_line.sort_by(|a, b| a.0.total_cmp(&b.0));
    let at_last = on_line.iter().position(|(_, _, unit, _)| unit.is_some())?;
    let steady = on_line[..=at_last].windows(2).all(|w| w[1].1 > w[0].1);
    let (s, number, unit, text) = &on_line[at_last];
    // The unit widens the last text to its right, its number stays over the mark.
    let shift = unit_shift(text);
    (steady && *number > 0.0).then_some(Marks { first: zero, span: s - shift, metres: number * (*unit)? })
}

/// By how much the middle of a text lies beside the middle of its leading number.
fn unit_shift(text: &SheetText) -> f64 {
    let all = text.content.trim().chars().count().max(1) as f64;
    let number =
        text.content.trim().chars().take_while(|c| c.is_ascii_digit() || matches!(c, '.' | ',')).count();
    0.5 * text.width * (1.0 - number as f64 / all)
}

/// All numbers in one text: `0 1 2 3 4 5 m`.
fn marks_together(text: &SheetText) -> Option<Marks<'_>> {
    let values = numbers(&text.content);
    let rising = values.len() >= 2 && values[0] == 0.0 && values.windows(2).all(|w| w[1] > w[0]);
    let metres = values.last()? * unit(&text.content)?;
    rising.then_some(Marks { first: text, span: 0.85 * text.width, metres })
}

/// The bar is the line beside the numbers that is about as long as they are apart.
fn measurement(marks: &Marks<'_>, ink: &Mask) -> Option<Measurement> {
    let text = marks.first;
    let together = numbers(&text.content).len() > 1;
    let middle = if together { 0.0 } else { 0.5 * marks.span };
    let start = Ray::new(text.centre, text.angle);
    let ray = Ray { at: start.point(middle, 0.0), along: start.along };
    let reach = (3.0 * text.height).ceil() as i64;
    let offsets = (1..=reach).flat_map(|t| [t as f64, -(t as f64)]);
    let tolerance = if together { 0.3 } else { 0.12 };
    let fits = |length: &f64| (length / marks.span - 1.0).abs() < tolerance;
    let lengths = offsets.filter_map(|t| ray.run(ink, t, 1.5, 0.0)).map(|[a, b]| b - a).filter(fits);
    let bar = lengths.min_by(|a, b| (a - marks.span).abs().total_cmp(&(b - marks.span).abs()));
    let length = bar.or_else(|| (!together).then_some(marks.span))?;
    let weight = if bar.is_some() { 2.0 } else { 0.5 };
    Some(Measurement { value: marks.metres / length, weight })
}

/// The text with the letters before its unit read as the digits that they look like: `Sm` is 5 m.
fn digits(text: &str) -> String {
    let text = text.trim();
    let (number, unit) = text.split_at(text.len() - text.chars().last().map_or(0, char::len_utf8));
    let digit = |c| match c {
        'S' => '5',
        'I' | 'l' => '1',
        'O' => '0',
        other => other,
    };
    number.chars().map(digit).chain(unit.chars()).collect()
}

fn numbers(text: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',');
    let parts = text.split(|c| !is_part(c)).map(|p| p.trim_matches(['.', ',']).replace(',', "."));
    parts.filter_map(|p| p.parse().ok()).collect()
}

/// Metres of the unit that ends the text.
fn unit(text: &str) -> Option<f64> {
    let word = text.trim().trim_end_matches('.').rsplit(|c: char| !c.is_alphabetic()).next()?.to_lowercase();
    match word.as_str() {
        "m" | "meter" | "metre" | "meters" | "metres" | "metri" | "mètres" => Some(1.0),
        "cm" => Some(0.01),
        "mm" => Some(0.001),
        "ft" | "feet" => Some(0.3048),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(content: &str, x: f64, width: f64) -> SheetText {
        SheetText {
            content: content.into(),
            centre: [x, 20.0],
            angle: 0.0,
            width,
            height: 10.0,
            confidence: 0.9,
        }
    }

    fn bar(from: usize, to: usize) -> Mask {
        let mut ink = Mask::empty(300, 60);
        (35..40).for_each(|y| (from..to).for_each(|x| ink.set[y * 300 + x] = true));
        ink
    }

    #[test]
    fn numbers_apart_stand_over_their_marks() {
        let texts = [text("0", 50.0, 6.0), text("5", 150.0, 6.0), text("10 m", 261.0, 28.0)];
        let found = measurements(&texts, &bar(50, 250));
        assert!(found.len() == 1 && (found[0].value - 0.05).abs() < 0.001, "{found:?}");
    }

    #[test]
    fn numbers_read_as_one_text_lie_along_the_bar() {
        let texts = [text("0 1 2 3 4 5 m", 155.0, 225.0)];
        let found = measurements(&texts, &bar(50, 250));
        assert!(found.len() == 1 && (found[0].value - 0.025).abs() < 0.001, "{found:?}");
    }

    #[test]
    fn the_last_number_alone_ends_the_bar() {
        let found = measurements(&[text("10 m", 261.0, 28.0)], &bar(50, 250));
        assert!(found.len() == 1 && (found[0].value - 0.05).abs() < 0.001, "{found:?}");
        let misread = measurements(&[text("IO m", 261.0, 28.0)], &bar(50, 250));
        assert_eq!(misread, found);
        assert_eq!(measurements(&[text("10 m", 200.0, 28.0)], &bar(50, 250)), []);
    }

    #[test]
    fn room_numbers_are_no_bar() {
        let texts = [text("01", 50.0, 6.0), text("02", 150.0, 6.0), text("Room", 250.0, 30.0)];
        assert_eq!(measurements(&texts, &bar(50, 250)), []);
    }
}
