//! How large a drawing is, guessed where nobody says so: only to know what is small and what is not.

use super::components::{self, Neighbours};
use super::drawing::Drawing;
use super::stroke;
use crate::mask::Mask;

/// The radius of the largest disc in a usual room, metres.
const ROOM: f64 = 1.6;

/// The thickest that lines usually are, metres: then they are walls.
const LINE: f64 = 0.3;

/// What covers a smaller share of the sheet is a letter or furniture, no room.
const SHARE: f64 = 0.002;

/// Plans are drawn no finer and no coarser than this, metres per pixel.
const FINEST: f64 = 1e-3;
const COARSEST: f64 = 0.1;

/// Metres per pixel where nothing tells.
const UNKNOWN: f64 = 0.05;

/// Metres per pixel by the faces that ink encloses: half of the building's floor lies in rooms that are larger than usual.
pub fn guess(ink: &Mask) -> f64 {
    let drawing = Drawing::of_sheet(ink, UNKNOWN);
    let by_lines = LINE / stroke::usual(&drawing);
    let by_rooms = rooms(&drawing).map(|m| m.min(by_lines) / drawing.factor as f64);
    by_rooms.unwrap_or(UNKNOWN).clamp(FINEST, COARSEST)
}

/// By the faces of a drawing that do not reach its edge; metres per pixel of it.
fn rooms(drawing: &Drawing) -> Option<f64> {
    let paper: Vec<bool> = drawing.ink.iter().map(|i| !i).collect();
    let clear = drawing.paper();
    let faces = components::find(&paper, drawing.width, Neighbours::Four);
    let mut radius = vec![0u32; faces.all.len()];
    for (&face, &d) in faces.label.iter().zip(&clear) {
        radius[face as usize] = radius[face as usize].max(d);
    }
    let is_inner = |&f: &usize| {
        let extent = &faces.all[f];
        let [right, bottom] = [drawing.width - 1, drawing.height - 1];
        let is_large = extent.area as f64 >= SHARE * paper.len() as f64;
        is_large
            && extent.low[0] > 0
            && extent.low[1] > 0
            && extent.high[0] < right
            && extent.high[1] < bottom
    };
    let mut inner: Vec<usize> = (1..radius.len()).filter(is_inner).collect();
    inner.sort_by_key(|&f| radius[f]);
    let floor: usize = inner.iter().map(|&f| faces.all[f].area).sum();
    let mut below = 0;
    let median = inner.into_iter().find(|&f| {
        below += faces.all[f].area;
        2 * below >= floor
    })?;
    Some(ROOM / f64::from(radius[median]).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rooms_tell_the_scale() {
        let mut ink = Mask::empty(100, 60);
        for y in 5..=45 {
            (10..=90).filter(|x| x % 40 == 10 || y % 40 == 5).for_each(|x| ink.set[y * 100 + x] = true);
        }
        assert!((guess(&ink) - 1.6 / 20.0).abs() < 1e-9);
        assert_eq!(guess(&Mask::empty(5, 5)), 0.05);
        assert_eq!(guess(&Mask::empty(0, 0)), 0.05);
    }
}
