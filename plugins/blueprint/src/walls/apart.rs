//! What is drawn apart from the building: the frame of a legend, a table, a detail. None of it has a door.

use super::components::{self, Neighbours};
use super::drawing::Drawing;
use super::openings;
use crate::found::SheetSymbol;

/// With so many doors in the building, a building beside it has one as well.
const DOORS: usize = 2;

/// What is at least this share of the largest part is building, with doors or without,
const SHARE: f64 = 0.4;

/// unless the largest part has so many doors that a building of that size would have this many.
const EXPECTED: f64 = 1.5;

/// Takes the parts without doors that are apart from the building, and smaller, off what is occupied and inside.
pub fn remove(drawing: &Drawing, symbols: &[SheetSymbol], occupied: &mut [bool], inside: &mut [bool]) {
    let built: Vec<bool> = occupied.iter().zip(&*inside).map(|(o, i)| *o || *i).collect();
    let parts = components::find(&built, drawing.width, Neighbours::Eight);
    let mut doors = vec![0usize; parts.all.len()];
    for door in symbols.iter().filter(|s| openings::is_door(s)) {
        for part in near(drawing, door, &parts.label) {
            doors[part as usize] += 1;
        }
    }
    let largest = (0..parts.all.len()).max_by_key(|&p| parts.all[p].area).unwrap_or(0);
    let share = |part: usize| parts.all[part].area as f64 / parts.all[largest].area.max(1) as f64;
    let expects = |part: usize| share(part) * doors[largest] as f64 >= EXPECTED;
    let is_apart = |part: usize| doors[part] == 0 && (share(part) < SHARE || expects(part));
    if doors.iter().skip(1).sum::<usize>() < DOORS {
        return;
    }
    for (i, &part) in parts.label.iter().enumerate().filter(|(_, p)| **p != 0) {
        if is_apart(part as usize) {
            (occupied[i], inside[i]) = (false, false);
        }
    }
}

/// The parts at a door's middle and its jambs.
fn near(drawing: &Drawing, door: &SheetSymbol, label: &[u32]) -> Vec<u32> {
    let (sin, cos) = door.angle.sin_cos();
    let at = |along: f64| {
        let p = [door.centre[0] + along * cos, door.centre[1] + along * sin];
        drawing.at_sheet(p).map(|i| label[i]).filter(|&part| part != 0)
    };
    let mut parts: Vec<u32> = [-0.6, -0.5, 0.0, 0.5, 0.6].iter().filter_map(|s| at(s * door.width)).collect();
    parts.sort_unstable();
    parts.dedup();
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    #[test]
    fn a_frame_without_doors_beside_a_building_with_them_is_none() {
        let drawing = Drawing::of_sheet(&Mask::empty(100, 40), 0.1);
        let both = |x: usize| (5..60).contains(&x) || (70..85).contains(&x);
        let mut inside: Vec<bool> =
            (0..4000).map(|i| both(i % 100) && (5..35).contains(&(i / 100))).collect();
        let mut occupied = vec![false; 4000];
        let door = |x: f64| SheetSymbol {
            kind: "door".into(),
            centre: [x, 20.0],
            angle: 0.0,
            width: 9.0,
            height: 2.0,
            score: 1.0,
            leaves: vec![],
        };
        let before = inside.clone();
        remove(&drawing, &[door(20.0)], &mut occupied, &mut inside);
        assert_eq!(inside, before);
        remove(&drawing, &[door(20.0), door(40.0)], &mut occupied, &mut inside);
        assert!(inside[20 * 100 + 20] && !inside[20 * 100 + 75]);
    }
}
