//! Gates and glass fronts drawn so faintly that they pass for paper. Where such lines close a hall that has walls nearly
//! all around, they are walls.

use super::beyond;
use super::components::{self, Neighbours};
use super::distance;
use super::drawing::Drawing;
use super::inside;

/// Walls make up this share of the hall's rim,
const WALLS: f64 = 0.7;

/// and it is at least so large, square metres.
const LEAST: f64 = 6.0;

/// Walls and lines lie on the rim, so far aside at most, metres.
const ASIDE: f64 = 0.3;

/// The faint lines that are gates. `wall`: what is wall for sure; `faint`: all faint lines.
pub fn find(drawing: &Drawing, wall: &[bool], faint: &[bool]) -> Vec<bool> {
    if !faint.contains(&true) {
        return vec![false; faint.len()];
    }
    let by_walls = inside::find(drawing, wall);
    let either: Vec<bool> = wall.iter().zip(faint).map(|(w, f)| w | f).collect();
    let with_gates = inside::find(drawing, &either);
    let gained: Vec<bool> = with_gates.iter().zip(&by_walls).map(|(g, w)| *g && !w).collect();
    let parts = components::find(&gained, drawing.width, Neighbours::Four);
    let reach = ASIDE * drawing.metre;
    let near_walls = distance::within(wall, drawing.width, reach);
    let rims = beyond::rims(drawing, &near_walls, &parts);
    let is_hall = |part: usize| {
        let [open, walls] = rims[part].map(|count| count as f64);
        part != 0
            && walls >= WALLS * (open + walls)
            && parts.all[part].area as f64 >= LEAST * drawing.metre.powi(2)
    };
    let halls: Vec<bool> = (0..parts.all.len()).map(is_hall).collect();
    let floor: Vec<bool> = parts.label.iter().map(|&part| halls[part as usize]).collect();
    let rim = distance::within(&floor, drawing.width, reach);
    faint.iter().zip(&rim).map(|(f, r)| *f && *r).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    /// Two rooms of 8 x 8 m with walls of 0.2 m, of which the right one is open below over `gap` decimetres; a faint
    /// line runs along its lower side. How many of the line's pixels are a gate.
    fn gate(gap: usize) -> usize {
        let drawing = Drawing::of_sheet(&Mask::empty(220, 140), 0.1);
        let (mut wall, mut faint) = (vec![false; 220 * 140], vec![false; 220 * 140]);
        for (x, y) in (20..184).flat_map(|x| (20..104).map(move |y| (x, y))) {
            let upright = [20, 102, 182].iter().any(|&left| (left..left + 2).contains(&x));
            let is_gap = y > 101 && (104 + 78 - gap..182).contains(&x);
            wall[y * 220 + x] = !is_gap && (upright || !(22..=101).contains(&y));
            faint[y * 220 + x] = is_gap && y == 102;
        }
        find(&drawing, &wall, &faint).iter().filter(|&&g| g).count()
    }

    #[test]
    fn a_faint_line_that_closes_a_hall_is_a_gate() {
        assert_eq!(gate(60), 60);
        assert_eq!(gate(0), 0);
    }
}
