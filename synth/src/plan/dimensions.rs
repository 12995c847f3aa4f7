//! Dimension lines outside of the building.

use super::drawing::Drawing;
use super::labels::feet;
use super::look::{Ends, Units};
use super::surface::circle;
use super::truth::PlanTextRole;
use planform_sdk::Point;
use std::f64::consts::FRAC_PI_2;

/// Marks nearer than this are one, metres.
const APART: f64 = 0.4;
/// Corners this near to the building's box count to its side, metres.
const NEAR: f64 = 0.6;

/// A side of the building: lengths along it are measured by `along`, distances from the building by `out`.
#[derive(Clone, Copy)]
struct Side {
    origin: Point,
    along: (f64, f64),
    out: (f64, f64),
    /// Reading direction of its words.
    angle: f64,
}

impl Side {
    fn at(&self, u: f64, v: f64) -> Point {
        let (((ax, ay), (ox, oy)), p) = ((self.along, self.out), self.origin);
        Point::new(p.x + ax * u + ox * v, p.y + ay * u + oy * v)
    }

    /// Lengths along the side and away from it.
    fn local(&self, p: Point) -> (f64, f64) {
        let (dx, dy) = (p.x - self.origin.x, p.y - self.origin.y);
        (dx * self.along.0 + dy * self.along.1, dx * self.out.0 + dy * self.out.1)
    }
}

/// A chain from wall to wall and the whole length, along one horizontal and one upright side.
pub(super) fn draw(drawing: &mut Drawing) {
    let Some((units, ends)) = drawing.look.dimensions else { return };
    let (low, high) = drawing.site.bounds();
    let down = drawing.rng.chance(0.3);
    let bottom = Side { origin: low, along: (1.0, 0.0), out: (0.0, -1.0), angle: 0.0 };
    let top = Side { origin: Point::new(low.x, high.y), out: (0.0, 1.0), ..bottom };
    let left = Side { origin: low, along: (0.0, 1.0), out: (-1.0, 0.0), angle: FRAC_PI_2 };
    let turned = if down { -FRAC_PI_2 } else { FRAC_PI_2 };
    let right = Side { origin: Point::new(high.x, low.y), out: (1.0, 0.0), angle: turned, ..left };
    let level = if drawing.rng.chance(0.5) { bottom } else { top };
    let upright = if drawing.rng.chance(0.5) { left } else { right };
    for (side, length) in [(level, high.x - low.x), (upright, high.y - low.y)] {
        chain(drawing, &side, length, units, ends);
    }
}

fn chain(drawing: &mut Drawing, side: &Side, length: f64, units: Units, ends: Ends) {
    let (inner, outer) = (drawing.view.mm(8.0), drawing.view.mm(14.5));
    let marks = marks(drawing, side);
    if marks.len() > 2 {
        dimension(drawing, side, &marks, inner, (units, ends));
        dimension(drawing, side, &[0.0, length], outer, (units, ends));
    } else {
        dimension(drawing, side, &[0.0, length], inner, (units, ends));
    }
}

/// Where walls meet this side.
fn marks(drawing: &Drawing, side: &Side) -> Vec<f64> {
    let corners = drawing.site.layout.rooms.iter().flat_map(|r| &r.centre.exterior);
    let near = corners.map(|&p| side.local(p)).filter(|(_, v)| *v > -NEAR);
    let mut marks: Vec<f64> = near.map(|(u, _)| u).collect();
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|a, b| (*a - *b).abs() < APART);
    marks
}

fn dimension(drawing: &mut Drawing, side: &Side, marks: &[f64], out: f64, (units, ends): (Units, Ends)) {
    let (Some(&first), Some(&last)) = (marks.first(), marks.last()) else { return };
    let thin = drawing.thin();
    let mm = drawing.view.mm(1.0);
    drawing.picture.line(&[side.at(first - mm, out), side.at(last + mm, out)], thin);
    for &u in marks {
        drawing.picture.line(&[side.at(u, 2.5 * mm), side.at(u, out + 1.5 * mm)], thin);
    }
    for pair in marks.windows(2) {
        end(drawing, side, pair[0], out, ends, 1.0);
        end(drawing, side, pair[1], out, ends, -1.0);
        text(drawing, side, (pair[0], pair[1]), out, units);
    }
}

/// The end of a dimension line at `u`; the line goes on to the side of `inward`.
fn end(drawing: &mut Drawing, side: &Side, u: f64, out: f64, ends: Ends, inward: f64) {
    let (mm, colour) = (drawing.view.mm(1.0), drawing.look.ink);
    match ends {
        Ends::Ticks => {
            let bold = drawing.pen(drawing.look.thin * 2.0);
            drawing
                .picture
                .line(&[side.at(u - 0.8 * mm, out - 0.8 * mm), side.at(u + 0.8 * mm, out + 0.8 * mm)], bold);
        }
        Ends::Arrows => {
            let back = u + inward * 2.4 * mm;
            let head = [side.at(u, out), side.at(back, out + 0.45 * mm), side.at(back, out - 0.45 * mm)];
            drawing.picture.fill([head.as_slice()], colour);
        }
        Ends::Dots => drawing.picture.fill([circle(side.at(u, out), 0.55 * mm).as_slice()], colour),
    }
}

/// The length, on the upper side of the line as it is read; left out where it has no space.
fn text(drawing: &mut Drawing, side: &Side, (from, to): (f64, f64), out: f64, units: Units) {
    let capital = drawing.view.mm(drawing.look.capital * 0.92);
    let words = written(to - from, units);
    let line = drawing.line(&words, capital, PlanTextRole::Dimension);
    let wide = drawing.measure(&line).0;
    if wide + capital > to - from {
        return;
    }
    let (sin, cos) = side.angle.sin_cos();
    // Up, as one reads, is this far away from the building.
    let above = -sin * side.out.0 + cos * side.out.1;
    let middle = side.at((from + to) / 2.0, out + above * capital * 1.05);
    drawing.write(line, middle, side.angle);
}

fn written(length: f64, units: Units) -> String {
    match units {
        Units::Millimetres => format!("{:.0}", (length * 200.0).round() * 5.0),
        Units::Metres => format!("{length:.2}"),
        Units::Feet => feet(length),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_written_as_people_write_them() {
        assert_eq!(written(4.2512, Units::Millimetres), "4250");
        assert_eq!(written(4.2512, Units::Metres), "4.25");
        assert_eq!(written(4.115, Units::Feet), "13'6");
        assert_eq!(written(3.353, Units::Feet), "11'");
    }
}
