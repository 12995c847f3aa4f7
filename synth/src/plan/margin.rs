//! What surrounds the building: frame, title block, north arrow, scale bar.

use super::drawing::{Drawing, Line};
use super::letters::Face;
use super::paper::Area;
use super::surface::{Pen, WHITE, circle, rectangle};
use super::truth::PlanTextRole;
use planform_sdk::Point;

const PROJECTS: [&str; 6] =
    ["Miller House", "North Building", "City Office", "Harbour Centre", "Park School", "Clinic West"];
const STOREYS: [&str; 4] = ["Ground Floor", "First Floor", "Second Floor", "Floor Plan"];

pub(super) fn draw(drawing: &mut Drawing) {
    if let Some(frame) = drawing.paper.frame {
        let bold = drawing.pen(drawing.look.outline * 1.6);
        drawing.picture.rings([frame.ring().as_slice()], bold);
    }
    if let Some(title) = drawing.paper.title {
        title_block(drawing, &title);
    }
    let edge = drawing.paper.frame.map_or(drawing.view.mm(3.0), |f| f.low.x);
    let mm = drawing.view.mm(1.0);
    let at = |x: f64| Point::new(edge + x * mm, edge + 9.0 * mm);
    if drawing.look.north {
        north(drawing, at(12.0));
    }
    if drawing.look.scale_bar {
        scale_bar(drawing, at(24.0));
    }
}

/// Two columns of three cells.
fn title_block(drawing: &mut Drawing, area: &Area) {
    let (rng, denominator) = (&mut drawing.rng, drawing.view.denominator);
    let scale =
        [format!("Scale 1:{denominator}"), format!("1:{denominator}"), format!("SCALE 1:{denominator}")];
    let year = 1998 + rng.index(27);
    let cells = [
        PROJECTS[rng.index(6)].to_owned(),
        STOREYS[rng.index(4)].to_owned(),
        scale[rng.index(3)].clone(),
        format!("Drawn by {}", ["K. Berg", "A. Smith", "L. Rossi"][rng.index(3)]),
        format!("Date {:02}.{:02}.{year}", 1 + rng.index(28), 1 + rng.index(12)),
        format!("Sheet A-{}", 101 + rng.index(40)),
    ];
    let line = drawing.pen(drawing.look.outline);
    drawing.picture.shape(&area.ring(), Some(WHITE), line);
    let (wide, high) = ((area.high.x - area.low.x) / 2.0, (area.high.y - area.low.y) / 3.0);
    for (i, text) in cells.iter().enumerate() {
        let (column, row) = ((i % 2) as f64, (i / 2) as f64);
        let low = Point::new(area.low.x + column * wide, area.high.y - (row + 1.0) * high);
        let cell = rectangle(low, Point::new(low.x + wide, low.y + high));
        drawing.picture.rings([cell.as_slice()], line);
        let face = if i == 0 { Face::Bold } else { drawing.look.face };
        let capital = drawing.view.mm(drawing.look.capital.clamp(2.2, 3.4));
        write_left(
            drawing,
            Line { face, ..aside(drawing, text, capital) },
            low.x + drawing.view.mm(2.5),
            low.y + high / 2.0,
        );
    }
}

pub(super) fn aside<'a>(drawing: &Drawing, text: &'a str, capital: f64) -> Line<'a> {
    drawing.line(text, capital, PlanTextRole::Aside)
}

/// Writes from `x` on, the ink's middle at the height `y`.
pub(super) fn write_left(drawing: &mut Drawing, line: Line, x: f64, y: f64) {
    let wide = drawing.measure(&line).0;
    drawing.write(line, Point::new(x + wide / 2.0, y), 0.0);
}

/// A circle with a half-filled arrow and an N over it.
fn north(drawing: &mut Drawing, middle: Point) {
    let (thin, radius, ink) = (drawing.thin(), drawing.view.mm(5.0), drawing.look.ink);
    drawing.picture.rings([circle(middle, radius).as_slice()], thin);
    let at = |u: f64, v: f64| Point::new(middle.x + radius * u, middle.y + radius * v);
    let half = [at(0.0, 1.0), at(0.0, -0.6), at(-0.55, -0.8)];
    let other = [at(0.0, 1.0), at(0.0, -0.6), at(0.55, -0.8)];
    drawing.picture.fill([half.as_slice()], ink);
    drawing.picture.rings([other.as_slice()], thin);
    let capital = drawing.view.mm(drawing.look.capital.max(2.2));
    let line = aside(drawing, "N", capital);
    drawing.write(line, Point::new(middle.x, middle.y + radius + capital), 0.0);
}

/// A bar of black and white metres, or a line with marks, its numbers above it.
fn scale_bar(drawing: &mut Drawing, from: Point) {
    let metres = match drawing.view.denominator {
        d if d < 60.0 => 2,
        d if d < 90.0 => 4,
        d if d < 160.0 => 5,
        _ => 10,
    };
    let (step, filled) = (if metres == 10 { 2 } else { 1 }, drawing.rng.chance(0.6));
    let (high, ink) = (drawing.view.mm(1.6), drawing.look.ink);
    let pen = Pen { width: drawing.view.mm(0.25), colour: ink };
    let at = |u: f64, v: f64| Point::new(from.x + u, from.y + v);
    for i in (0..metres).step_by(step as usize) {
        let (u, w) = (f64::from(i), f64::from(i + step));
        if filled {
            let fill = if (i / step) % 2 == 0 { ink } else { WHITE };
            drawing.picture.shape(&rectangle(at(u, 0.0), at(w, high)), Some(fill), pen);
        } else {
            drawing.picture.line(&[at(u, high), at(u, 0.0), at(w, 0.0), at(w, high)], pen);
        }
    }
    let capital = drawing.view.mm(drawing.look.capital);
    let every = drawing.rng.chance(0.5);
    for i in (0..=metres).step_by(step as usize) {
        if every || i == 0 || i == metres {
            let text = if i == metres { format!("{i} m") } else { i.to_string() };
            let line = aside(drawing, &text, capital);
            drawing.write(line, at(f64::from(i), high + capital), 0.0);
        }
    }
}
