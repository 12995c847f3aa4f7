//! What was taken for walls, for whoever wants to see it.

use super::drawing::Drawing;
use crate::mask::Mask;
use image::{Rgb, RgbImage};

/// What every pixel of a drawing was taken for.
pub struct Kinds {
    /// Thick ink.
    pub solid: Vec<bool>,
    /// Bands, and what lies between parallel lines.
    pub band: Vec<bool>,
    /// All walls.
    pub occupied: Vec<bool>,
}

/// The sheet, pale, and on it solid walls black, bands red, thin lines that are walls blue; grey outside.
pub fn of(sheet: &RgbImage, drawing: &Drawing, kinds: &Kinds, inside: &Mask) -> RgbImage {
    RgbImage::from_fn(inside.width, inside.height, |x, y| {
        let (column, row) = (x as usize / drawing.factor, y as usize / drawing.factor);
        let at = row * drawing.width + column;
        let pale = sheet.get_pixel_checked(x, y).map_or([255; 3], |p| p.0.map(|v| 170 + v / 3));
        Rgb(match (kinds.occupied[at], kinds.solid[at], kinds.band[at]) {
            (true, true, _) => [0, 0, 0],
            (true, _, true) => [220, 50, 50],
            (true, ..) => [0, 0, 255],
            _ if inside.get(i64::from(x), i64::from(y)) => pale,
            _ => pale.map(|v| v / 4 * 3),
        })
    })
}
