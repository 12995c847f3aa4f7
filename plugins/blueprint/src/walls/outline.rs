//! How straight walls are. Photographs and textures have dark parts as plans do, but people build in straight lines.

use super::components::Neighbours;
use super::drawing::Drawing;
use super::straight;

/// A stretch of outline is straight if it is so long: pixels, or this share of the drawing's diagonal.
const LEAST: f64 = 15.0;
const SHARE: f64 = 0.03;

/// What lies this near to the sheet's edge may be the edge of the picture, as a share of the longer side.
const MARGIN: f64 = 0.02;

/// The share of the walls' outline that lies in long straight stretches; 0 if there are no walls.
pub fn straightness(drawing: &Drawing, occupied: &[bool]) -> f64 {
    let (width, height) = (drawing.width, drawing.height);
    let margin = (MARGIN * width.max(height) as f64) as usize;
    let is_inner = |i: usize| {
        let (x, y) = (i % width, i / width);
        x >= margin && y >= margin && x + margin < width && y + margin < height
    };
    let is_outline =
        |i: usize| occupied[i] && is_inner(i) && Neighbours::Four.of(i, width, height).any(|n| !occupied[n]);
    let outline: Vec<bool> = (0..occupied.len()).map(is_outline).collect();
    let least = LEAST.max(SHARE * (width as f64).hypot(height as f64));
    let runs = straight::runs(&outline, width);
    let all = outline.iter().filter(|&&o| o).count();
    let long = runs.length.iter().filter(|&&l| f64::from(l) >= least).count();
    long as f64 / all.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mask::Mask;

    fn of(is_wall: impl Fn(usize, usize) -> bool) -> f64 {
        let drawing = Drawing::of_sheet(&Mask::empty(300, 200), 0.05);
        let occupied: Vec<bool> = (0..300 * 200).map(|i| is_wall(i % 300, i / 300)).collect();
        straightness(&drawing, &occupied)
    }

    #[test]
    fn walls_are_straight_and_blots_are_not() {
        assert!(of(|x, y| (50..250).contains(&x) && (50..54).contains(&y)) > 0.9);
        let blot = |x: usize, y: usize| (x / 3 * 7919 + y / 3 * 104_729) % 61 < 20;
        assert!(of(blot) < 0.1);
        assert_eq!(of(|_, _| false), 0.0);
    }
}
