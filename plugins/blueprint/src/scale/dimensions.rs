//! Scale from dimension lines: a line with a length written along it, between two ticks, arrows or extension lines.

use super::consensus::Measurement;
use super::trace::Ray;
use crate::found::SheetText;
use crate::mask::Mask;
use crate::words::measures::Measure;

/// How far from its text's middle a dimension line may lie, in heights of the text.
const REACH: f64 = 2.0;

/// A dimension line is at least this many text heights long.
const SHORTEST: f64 = 1.5;

/// Metres per pixel by every text that is a length and stands on a dimension line. `ink` holds the lines, not the
/// letters.
pub fn measurements(texts: &[(SheetText, Measure)], ink: &Mask) -> Vec<Measurement> {
    texts.iter().flat_map(|(text, measure)| measurement(text, measure, ink)).collect()
}

fn measurement(text: &SheetText, measure: &Measure, ink: &Mask) -> Option<Measurement> {
    let Measure::Length { metres, .. } = *measure else { return None };
    let length = dimension_line(text, ink)?;
    // A pixel more or less counts little on a long line.
    Some(Measurement { value: metres / length, weight: text.confidence.max(0.2) * (length / 50.0).min(4.0) })
}

/// The length, in pixels, of the dimension line that the text stands on.
fn dimension_line(text: &SheetText, ink: &Mask) -> Option<f64> {
    let ray = Ray::new(text.centre, text.angle);
    let height = text.height.max(3.0);
    let steps = (REACH * height).ceil() as i64;
    let offsets = (0..=steps).flat_map(|t| [t as f64, -(t as f64)]);
    let line = |t: f64| {
        let hidden = if t.abs() < 0.6 * height { 0.5 * text.width + height } else { 0.0 };
        let [from, to] = ray.run(ink, t, 2.0, hidden)?;
        between_ticks(&ray, ink, t, [from, to], height)
    };
    offsets.filter_map(line).find(|length| *length >= SHORTEST * height)
}

/// The part of the run between the marks next to the middle: crossings by ticks or extension lines, or its ends.
fn between_ticks(ray: &Ray, ink: &Mask, t: f64, run: [f64; 2], height: f64) -> Option<f64> {
    let marks = crossings(ray, ink, t, run, height);
    let before = marks.iter().rfind(|&&s| s < 0.0).copied().unwrap_or(run[0]);
    let after = marks.iter().find(|&&s| s >= 0.0).copied().unwrap_or(run[1]);
    (after - before > 0.0).then_some(after - before)
}

/// Where the run is crossed, straight or on a slant: the middle of each group of places with ink on both sides.
fn crossings(ray: &Ray, ink: &Mask, t: f64, run: [f64; 2], height: f64) -> Vec<f64> {
    let d = (0.35 * height).max(2.0);
    let crossed = |s: f64| {
        [0.0, 1.0, -1.0]
            .iter()
            .any(|slant| ray.ink(ink, s + slant * d, t + d) && ray.ink(ink, s - slant * d, t - d))
    };
    let mut groups: Vec<[f64; 2]> = Vec::new();
    let mut s = run[0] - 2.0;
    while s <= run[1] + 2.0 {
        if crossed(s) {
            match groups.last_mut() {
                Some(group) if s - group[1] < 1.5 => group[1] = s,
                _ => groups.push([s, s]),
            }
        }
        s += 1.0;
    }
    groups.iter().map(|g| 0.5 * (g[0] + g[1])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(x: f64, y: f64) -> SheetText {
        SheetText {
            content: "5000".into(),
            centre: [x, y],
            angle: 0.0,
            width: 30.0,
            height: 10.0,
            confidence: 0.9,
        }
    }

    fn drawing(lines: &[[usize; 4]]) -> Mask {
        let mut ink = Mask::empty(400, 100);
        for &[x0, y0, x1, y1] in lines {
            for y in y0..=y1 {
                (x0..=x1).for_each(|x| ink.set[y * 400 + x] = true);
            }
        }
        ink
    }

    #[test]
    fn the_nearest_ticks_bound_the_dimension() {
        let chain = drawing(&[[20, 50, 380, 50], [100, 40, 100, 60], [300, 40, 300, 60], [380, 40, 380, 60]]);
        let length = dimension_line(&text(200.0, 40.0), &chain).unwrap();
        assert!((length - 200.0).abs() < 1.5, "{length}");
    }

    #[test]
    fn slanted_ticks_bound_as_well() {
        let mut chain = drawing(&[[20, 50, 380, 50]]);
        for i in 0..13 {
            for x in [94 + i, 294 + i] {
                chain.set[(56 - i) * 400 + x] = true;
            }
        }
        let length = dimension_line(&text(200.0, 42.0), &chain).unwrap();
        assert!((length - 200.0).abs() < 2.5, "{length}");
    }

    #[test]
    fn the_text_may_stand_in_the_line() {
        let line = drawing(&[[100, 50, 180, 50], [220, 50, 300, 50]]);
        let length = dimension_line(&text(200.0, 50.0), &line).unwrap();
        assert!((length - 200.0).abs() < 3.0, "{length}");
    }

    #[test]
    fn no_line_no_measurement() {
        let lengths = [(text(200.0, 40.0), Measure::Length { metres: 5.0, certain: true })];
        assert_eq!(measurements(&lengths, &Mask::empty(400, 100)), []);
    }
}
