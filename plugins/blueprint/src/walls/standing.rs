//! What stands alone in a room though it is drawn as thick as walls are: screens between desks, chairs, machines. Walls
//! join other walls, by themselves or by a door; a column is a block, and a shaft encloses something.

use super::components::{self, Components, Extent, Neighbours};
use super::distance;
use super::drawing::Drawing;

/// Pieces this near to each other are one, metres: symbols and words were erased between them.
const NEAR: f64 = 0.15;

/// Nothing larger is furniture, metres: a group of desks.
const LARGEST: f64 = 5.0;

/// What fills this share of its box is a column, or a bar that may go on in line with a wall.
const BLOCK: f64 = 0.5;

/// What encloses so much floor, square metres, is a shaft.
const SHAFT: f64 = 1.0;

/// Takes what stands alone off what is occupied. `inside`: the building; `openings`: its doors and windows.
pub fn remove(drawing: &Drawing, inside: &[bool], openings: &[bool], occupied: &mut [bool]) {
    let parts = together(drawing, openings, occupied);
    let outside = outside(drawing, inside, occupied);
    let mut walls = vec![Extent::NOTHING; parts.all.len()];
    let mut alone = vec![true; parts.all.len()];
    for (i, &part) in parts.label.iter().enumerate() {
        if occupied[i] {
            walls[part as usize].add(i % drawing.width, i / drawing.width);
        }
        alone[part as usize] &= !outside[i] && !openings[i];
    }
    let is_furniture = |part: usize| {
        let extent = &parts.all[part];
        alone[part]
            && !is_large(drawing, extent)
            && !is_block(&walls[part])
            && enclosed(drawing, &parts.label, part as u32, extent) < SHAFT * drawing.metre.powi(2)
    };
    let gone: Vec<bool> = (0..parts.all.len()).map(|p| p != 0 && is_furniture(p)).collect();
    parts.label.iter().zip(occupied).for_each(|(&part, o)| *o &= !gone[part as usize]);
}

/// Walls with their openings, over small gaps.
fn together(drawing: &Drawing, openings: &[bool], occupied: &[bool]) -> Components {
    let reach = (NEAR / 2.0 * drawing.metre).max(1.0);
    let mut near = distance::within(occupied, drawing.width, reach);
    near.iter_mut().zip(openings).for_each(|(n, o)| *n |= o);
    components::find(&near, drawing.width, Neighbours::Eight)
}

/// What is neither building nor wall, from the sheet's edge on.
fn outside(drawing: &Drawing, inside: &[bool], occupied: &[bool]) -> Vec<bool> {
    let neither: Vec<bool> = inside.iter().zip(occupied).map(|(i, o)| !i && !o).collect();
    let parts = components::find(&neither, drawing.width, Neighbours::Four);
    let ends =
        |e: &Extent| e.low.contains(&0) || e.high[0] + 1 == drawing.width || e.high[1] + 1 == drawing.height;
    parts.label.iter().map(|&part| part != 0 && ends(&parts.all[part as usize])).collect()
}

fn size(extent: &Extent) -> [usize; 2] {
    [0, 1].map(|i| (extent.high[i] + 1).saturating_sub(extent.low[i]))
}

fn is_large(drawing: &Drawing, extent: &Extent) -> bool {
    size(extent).iter().any(|&s| s as f64 > LARGEST * drawing.metre)
}

/// Whether walls fill their box.
fn is_block(walls: &Extent) -> bool {
    let [w, h] = size(walls);
    walls.area as f64 >= BLOCK * (w * h) as f64
}

/// How many pixels a part encloses.
fn enclosed(drawing: &Drawing, label: &[u32], part: u32, extent: &Extent) -> f64 {
    let [w, h] = size(extent).map(|s| s + 2);
    let is_open = |i: usize| {
        let (x, y) = (extent.low[0] + i % w, extent.low[1] + i / w);
        let beside = x == 0 || y == 0 || x > drawing.width || y > drawing.height;
        beside || label[(y - 1) * drawing.width + x - 1] != part
    };
    let open: Vec<bool> = (0..w * h).map(is_open).collect();
    let around = |e: &&Extent| e.low == [0, 0];
    let floor = components::find(&open, w, Neighbours::Four);
    floor.all.iter().skip(1).filter(|e| !around(e)).map(|e| e.area as f64).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// What is left of a thing drawn of bars `[x0, y0, x1, y1]`, decimetres, in a hall of 12 m, with such openings.
    fn left(bars: &[[usize; 4]], openings: &[[usize; 4]]) -> bool {
        let frame = [[10, 10, 130, 12], [10, 128, 130, 130], [10, 10, 12, 130], [128, 10, 130, 130]];
        let set = |bars: &[[usize; 4]]| {
            let at = |i: usize| [i % 140, i / 140];
            let is = |[x, y]: [usize; 2]| bars.iter().any(|b| b[0] <= x && x < b[2] && b[1] <= y && y < b[3]);
            (0..140 * 140).map(|i| is(at(i))).collect::<Vec<bool>>()
        };
        let drawing = Drawing::of_sheet(&Mask::empty(140, 140), 0.1);
        let mut occupied = set(&[&frame[..], bars].concat());
        remove(&drawing, &set(&[[12, 12, 128, 128]]), &set(openings), &mut occupied);
        assert!(occupied[11 * 140 + 70], "the hall's own wall");
        occupied[bars[0][1] * 140 + bars[0][0]]
    }

    #[test]
    fn a_screen_between_desks_goes_and_one_at_a_wall_stays() {
        assert!(!left(&[[40, 40, 70, 42], [54, 30, 56, 52]], &[]));
        assert!(left(&[[40, 40, 130, 42], [54, 30, 56, 52]], &[]));
    }

    #[test]
    fn a_column_a_shaft_and_a_bar_stay() {
        assert!(left(&[[40, 40, 46, 46]], &[]));
        assert!(left(&[[40, 40, 60, 42], [40, 58, 60, 60], [40, 40, 42, 60], [58, 40, 60, 60]], &[]));
        assert!(left(&[[40, 40, 80, 42]], &[]));
    }

    #[test]
    fn a_corner_of_walls_with_a_door_stays() {
        assert!(left(&[[40, 40, 70, 42], [40, 40, 42, 60]], &[[70, 40, 80, 42]]));
        assert!(!left(&[[40, 40, 70, 42], [40, 40, 42, 60]], &[]));
    }
}
