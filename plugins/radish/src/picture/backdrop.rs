//! Unknown space in a colour of its own.

use super::decode::Picture;
use super::wide;

/// The least share of the picture that a backdrop fills in wide areas: lines that lie close together are none.
const LEAST: f64 = 0.05;

/// How far each channel of a backdrop's pixels may be from its colour.
const NEAR: u8 = 40;

/// The least share of the wide coloured areas that has that colour.
const ALIKE: f64 = 0.9;

/// The pixels, among the coloured ones, of the one colour that fills wide areas; none if there is no such colour.
pub fn find(picture: &Picture, coloured: &[bool], radius: usize) -> Vec<bool> {
    let areas = wide::areas(coloured, picture.width, radius);
    let colours: Vec<[u8; 3]> = picture.colours().zip(&areas).filter(|(_, a)| **a).map(|(c, _)| c).collect();
    let Some(colour) = median(&colours) else { return vec![false; coloured.len()] };
    let is = |c: [u8; 3]| (0..3).all(|i| c[i].abs_diff(colour[i]) < NEAR);
    let alike = colours.iter().filter(|c| is(**c)).count() as f64;
    let wide = colours.len() as f64 >= LEAST * coloured.len() as f64 && alike >= ALIKE * colours.len() as f64;
    picture.colours().zip(coloured).map(|(c, coloured)| wide && *coloured && is(c)).collect()
}

/// The median of each channel.
fn median(colours: &[[u8; 3]]) -> Option<[u8; 3]> {
    let channel = |i: usize| {
        let mut values: Vec<u8> = colours.iter().map(|c| c[i]).collect();
        values.sort_unstable();
        values.get(values.len() / 2).copied()
    };
    Some([channel(0)?, channel(1)?, channel(2)?])
}
