//! Thin lines beyond the outer walls: dimension and extension lines, legends, paving. What they enclose is no room,
//! unless it has doors or windows of its own, or outer walls nearly all around, or a name and some.

use super::Read;
use super::components::{self, Components, Neighbours};
use super::distance;
use super::drawing::Drawing;
use super::openings;

/// Lines are beyond where they are farther than this from what the outer walls enclose, metres: a thin line nearer than
/// that may be a wall's outline.
const BEYOND: f64 = 0.4;

/// A part with this share of its rim at the building is a room whose own outer wall was not seen.
const ROOM: f64 = 0.8;

/// With this share it is one if words stand in it; numbers stand along dimension lines as well, and legends stand apart.
const NAMED: f64 = 0.4;

/// Words have at least so many letters.
const LETTERS: usize = 3;

/// The ink beyond what the outer walls enclose, but for that of parts that are the building's. `by_walls` and
/// `by_lines`: what the walls alone, and what all lines enclose.
pub fn ink(drawing: &Drawing, by_walls: &[bool], by_lines: &[bool], read: Read) -> Vec<bool> {
    let outer: Vec<bool> = by_lines.iter().zip(by_walls).map(|(l, w)| *l && !w).collect();
    let parts = components::find(&outer, drawing.width, Neighbours::Four);
    let built = built(drawing, by_walls, &parts, read);
    let reach = BEYOND * drawing.metre;
    let near = distance::within(by_walls, drawing.width, reach);
    let is_beyond = |i: usize| !near[i] && !built[parts.label[i] as usize];
    (0..outer.len()).map(|i| drawing.ink[i] && is_beyond(i)).collect()
}

/// Of every part how often it meets what is open, and what the walls enclose.
pub fn rims(drawing: &Drawing, by_walls: &[bool], parts: &Components) -> Vec<[usize; 2]> {
    let mut rim = vec![[0usize; 2]; parts.all.len()];
    for (i, &label) in parts.label.iter().enumerate().filter(|(_, l)| **l != 0) {
        let beside = Neighbours::Four.of(i, drawing.width, drawing.height);
        beside.filter(|&b| parts.label[b] != label).for_each(|b| {
            rim[label as usize][usize::from(by_walls[b])] += 1;
        });
    }
    rim
}

/// Which of the parts are the building's.
fn built(drawing: &Drawing, by_walls: &[bool], parts: &Components, read: Read) -> Vec<bool> {
    let rim = rims(drawing, by_walls, parts);
    let mut named = vec![false; parts.all.len()];
    let words =
        read.texts.iter().filter(|t| t.content.chars().filter(|c| c.is_alphabetic()).count() >= LETTERS);
    words.filter_map(|t| drawing.at_sheet(t.centre)).for_each(|at| named[parts.label[at] as usize] = true);
    let least = |named: bool| if named { NAMED } else { ROOM };
    let is_room =
        |([open, wall], named): (&[usize; 2], &bool)| *wall as f64 >= least(*named) * (open + wall) as f64;
    let mut built: Vec<bool> = rim.iter().zip(&named).map(is_room).collect();
    let opening = read.symbols.iter().filter(|s| openings::is_opening(s));
    opening.filter_map(|s| drawing.at_sheet(s.centre)).for_each(|at| built[parts.label[at] as usize] = true);
    built[0] = false;
    built
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::found::{SheetSymbol, SheetText};
    use crate::mask::Mask;

    fn door(centre: [f64; 2]) -> SheetSymbol {
        let (kind, leaves) = ("door".to_owned(), Vec::new());
        SheetSymbol { kind, centre, angle: 0.0, width: 9.0, height: 2.0, score: 1.0, leaves }
    }

    fn read(texts: &[SheetText]) -> Read<'_> {
        Read { texts, symbols: &[] }
    }

    /// A building in columns 0 to 39, an annexe of thin lines in columns 50 to 89; a line in each.
    fn beyond(symbols: &[SheetSymbol]) -> [bool; 2] {
        let mut mask = Mask::empty(100, 40);
        (5..90).for_each(|x| mask.set[20 * 100 + x] = true);
        let drawing = Drawing::of_sheet(&mask, 0.1);
        let by_walls: Vec<bool> = (0..4000).map(|i| i % 100 < 40).collect();
        let by_lines: Vec<bool> = (0..4000).map(|i| i % 100 < 40 || (50..90).contains(&(i % 100))).collect();
        let found = ink(&drawing, &by_walls, &by_lines, Read { texts: &[], symbols });
        [found[20 * 100 + 20], found[20 * 100 + 70]]
    }

    #[test]
    fn a_part_between_the_buildings_walls_stays() {
        let mut mask = Mask::empty(100, 40);
        (5..90).for_each(|x| mask.set[20 * 100 + x] = true);
        let drawing = Drawing::of_sheet(&mask, 0.1);
        let court = |i: usize| (30..70).contains(&(i % 100)) && i / 100 < 30;
        let by_walls: Vec<bool> = (0..4000).map(|i| !court(i)).collect();
        assert!(!ink(&drawing, &by_walls, &[true; 4000], read(&[])).contains(&true));
        let by_lines: Vec<bool> = (0..4000).map(|i| !court(i) || i / 100 > 16).collect();
        assert!(ink(&drawing, &by_walls, &by_lines, read(&[]))[20 * 100 + 50]);
        let text = |content: &str| SheetText {
            content: content.into(),
            centre: [45.0, 24.0],
            angle: 0.0,
            width: 20.0,
            height: 4.0,
            confidence: 0.9,
        };
        assert!(ink(&drawing, &by_walls, &by_lines, read(&[text("18'1")]))[20 * 100 + 50]);
        assert!(!ink(&drawing, &by_walls, &by_lines, read(&[text("Library")]))[20 * 100 + 50]);
    }

    #[test]
    fn lines_outside_go_unless_a_door_is_among_them() {
        assert_eq!(beyond(&[]), [false, true]);
        assert_eq!(beyond(&[door([39.0, 20.0])]), [false, true]);
        assert_eq!(beyond(&[door([60.0, 20.0])]), [false, false]);
    }
}
