//! A picture of what was found, for whoever looks on.

use super::Symbols;
use super::shapes::Box2;
use crate::paint::line;
use crate::sheet::Sheet;
use image::{Rgb, RgbImage};

const TAKEN: Rgb<u8> = Rgb([255, 150, 150]);
const INK: Rgb<u8> = Rgb([90, 90, 90]);
const PAPER: Rgb<u8> = Rgb([255; 3]);
const BOX: Rgb<u8> = Rgb([0, 60, 220]);
const LEAF: Rgb<u8> = Rgb([0, 150, 60]);

/// The sheet's ink, what is taken off it, the boxes of symbols, and open leaves.
pub fn of(sheet: &Sheet, found: &Symbols) -> RgbImage {
    let mut picture = RgbImage::from_fn(sheet.ink.width, sheet.ink.height, |x, y| {
        let i = y as usize * sheet.ink.width as usize + x as usize;
        match (found.erase.set[i], sheet.ink.set[i]) {
            (true, _) => TAKEN,
            (_, true) => INK,
            _ => PAPER,
        }
    });
    for symbol in &found.symbols {
        let corners = Box2::of(symbol).corners();
        (0..4).for_each(|i| line(&mut picture, corners[i], corners[(i + 1) % 4], BOX));
        symbol.leaves.iter().for_each(|l| line(&mut picture, l.hinge, l.open, LEAF));
    }
    picture
}
