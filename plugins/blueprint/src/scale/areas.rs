//! Scale from what is written in rooms: areas such as 23.4 m², sizes such as 5.16 x 3.48 m.

use super::consensus::Measurement;
use crate::found::{SheetSymbol, SheetText};
use crate::mask::Mask;
use crate::words::measures::Measure;

/// A room's sides agree with a written size when their ratio does, to this factor: rooms have niches and shafts.
const SAME_SHAPE: f64 = 1.15;

/// The floor around a text, up to the walls and the doors.
struct Floor {
    /// Its area, pixels.
    area: f64,
    /// The sides of its upright box, pixels.
    sides: [f64; 2],
}

/// Metres per pixel by every text that is an area or a size and stands in a room. `occupied` holds the walls, `inside`
/// what is not outside of the building.
pub fn measurements(
    texts: &[(SheetText, Measure)],
    occupied: &Mask,
    inside: &Mask,
    symbols: &[SheetSymbol],
) -> Vec<Measurement> {
    if !texts.iter().any(|(_, m)| matches!(m, Measure::Area(_) | Measure::Size { .. })) {
        return Vec::new();
    }
    let mut free = inside.clone().without(occupied);
    symbols.iter().filter(|s| s.kind.contains("door")).for_each(|door| close(door, &mut free));
    let measured = texts.iter().filter_map(|(text, measure)| {
        let needed = matches!(measure, Measure::Area(_) | Measure::Size { .. });
        let floor = needed.then(|| floor(text.centre, &mut free)).flatten()?;
        Some(Measurement { value: metres_per_pixel(measure, &floor)?, weight: text.confidence.max(0.2) })
    });
    measured.collect()
}

fn metres_per_pixel(measure: &Measure, floor: &Floor) -> Option<f64> {
    match *measure {
        Measure::Area(area) => Some((area / floor.area).sqrt()),
        Measure::Size { width: a, depth: b } => {
            let [w, h] = floor.sides;
            let (written, drawn) = (a.max(b) / a.min(b), w.max(h) / w.min(h));
            let same = written / drawn < SAME_SHAPE && drawn / written < SAME_SHAPE;
            same.then(|| (a * b / (w * h)).sqrt())
        }
        _ => None,
    }
}

/// Draws a closed door, thick enough for no step on a diagonal to slip through.
fn close(door: &SheetSymbol, free: &mut Mask) {
    let (c, s) = (door.angle.cos(), door.angle.sin());
    let steps = door.width.min(f64::from(free.width.max(free.height))).ceil() as i64;
    for i in -1..=2 * steps + 1 {
        let along = 0.5 * (i as f64 - steps as f64);
        let [x, y] = [door.centre[0] + along * c, door.centre[1] + along * s];
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            clear(free, x.floor() as i64 + dx, y.floor() as i64 + dy);
        }
    }
}

fn clear(mask: &mut Mask, x: i64, y: i64) {
    if mask.get(x, y) {
        mask.set[y as usize * mask.width as usize + x as usize] = false;
    }
}

/// The floor around this point, which is taken out of `free`: two texts in one room are measured once, by the first.
fn floor(at: [f64; 2], free: &mut Mask) -> Option<Floor> {
    let (x, y) = (at[0].floor() as i64, at[1].floor() as i64);
    if !free.get(x, y) {
        return None;
    }
    clear(free, x, y);
    let mut stack = vec![(x, y)];
    let (mut area, mut low, mut high) = (0_u64, (x, y), (x, y));
    while let Some((x, y)) = stack.pop() {
        area += 1;
        low = (low.0.min(x), low.1.min(y));
        high = (high.0.max(x), high.1.max(y));
        for (nx, ny) in [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)] {
            if free.get(nx, ny) {
                clear(free, nx, ny);
                stack.push((nx, ny));
            }
        }
    }
    let sides = [(high.0 - low.0 + 1) as f64, (high.1 - low.1 + 1) as f64];
    Some(Floor { area: area as f64, sides })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(x: f64) -> SheetText {
        SheetText {
            content: String::new(),
            centre: [x, 50.0],
            angle: 0.0,
            width: 9.0,
            height: 3.0,
            confidence: 1.0,
        }
    }

    /// Two rooms of 99 x 100 pixels and a door between them.
    fn rooms() -> (Mask, Mask, SheetSymbol) {
        let mut occupied = Mask::empty(200, 100);
        (0..100).filter(|y| !(40..60).contains(y)).for_each(|y| {
            occupied.set[y * 200 + 99] = true;
            occupied.set[y * 200 + 100] = true;
        });
        let mut inside = Mask::empty(200, 100);
        inside.set.fill(true);
        let door = SheetSymbol {
            kind: "door".into(),
            centre: [100.0, 50.0],
            angle: std::f64::consts::FRAC_PI_2,
            width: 20.0,
            height: 2.0,
            score: 1.0,
            leaves: vec![],
        };
        (occupied, inside, door)
    }

    #[test]
    fn an_area_is_that_of_the_room_up_to_its_door() {
        let (occupied, inside, door) = rooms();
        let texts =
            [(text(50.0), Measure::Area(9.9)), (text(150.0), Measure::Size { width: 3.3, depth: 3.3 })];
        let found = measurements(&texts, &occupied, &inside, &[door]);
        assert!((found[0].value - (9.9 / 9900.0_f64).sqrt()).abs() < 1e-3, "{found:?}");
        assert!((found[1].value - 0.0333).abs() < 1e-3, "{found:?}");
    }

    #[test]
    fn a_size_of_another_shape_is_of_something_else() {
        let (occupied, inside, door) = rooms();
        let texts = [(text(50.0), Measure::Size { width: 2.0, depth: 5.0 })];
        assert_eq!(measurements(&texts, &occupied, &inside, &[door]), []);
    }
}
