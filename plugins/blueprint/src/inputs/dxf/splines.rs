//! Splines as points.

use super::drawing::Entity;
use super::plane::Point;
use super::shapes::MAX_POINTS;

/// Points for each span between knots.
const PER_SPAN: usize = 8;
/// The highest degree that is drawn.
const MAX_DEGREE: usize = 10;

/// Points on a spline: on its curve if it has one, else those that it was drawn through.
pub fn spline(entity: &Entity<'_>) -> Option<Vec<Point>> {
    let control = points(entity, 10);
    let knots = numbers(entity, 40);
    let degree = entity.flags(71).clamp(0, MAX_DEGREE as i64) as usize;
    if degree >= 1 && control.len() > degree && knots.len() == control.len() + degree + 1 {
        return Some(curve(degree, &knots, &control));
    }
    let fit = points(entity, 11);
    let points = if fit.len() >= 2 { fit } else { control };
    (points.len() >= 2).then_some(points)
}

/// De Boor's algorithm, without weights: plans have no others.
fn curve(degree: usize, knots: &[f64], control: &[Point]) -> Vec<Point> {
    let mut points = vec![];
    for span in degree..control.len() {
        let (from, to) = (knots[span], knots[span + 1]);
        if to > from && points.len() < MAX_POINTS {
            let steps = (0..=PER_SPAN).map(|i| from + (to - from) * i as f64 / PER_SPAN as f64);
            points.extend(steps.map(|t| on_curve(degree, knots, control, span, t)));
        }
    }
    points
}

fn on_curve(degree: usize, knots: &[f64], control: &[Point], span: usize, t: f64) -> Point {
    let mut points: Vec<Point> = control[span - degree..=span].to_vec();
    for level in 1..=degree {
        for j in (level..=degree).rev() {
            let i = j + span - degree;
            let width = knots[i + degree + 1 - level] - knots[i];
            let part = if width > 0.0 { (t - knots[i]) / width } else { 0.0 };
            points[j] = [0, 1].map(|k| points[j - 1][k] * (1.0 - part) + points[j][k] * part);
        }
    }
    points[degree]
}

fn numbers(entity: &Entity<'_>, code: i32) -> Vec<f64> {
    entity.pairs.iter().filter(|p| p.code == code).filter_map(|p| p.number()).take(2 * MAX_POINTS).collect()
}

fn points(entity: &Entity<'_>, code: i32) -> Vec<Point> {
    numbers(entity, code)
        .into_iter()
        .zip(numbers(entity, code + 10))
        .map(|(x, y)| [x, y])
        .take(MAX_POINTS)
        .collect()
}
