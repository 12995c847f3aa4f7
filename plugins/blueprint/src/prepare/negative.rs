//! Light lines on a dark ground: blueprints in the word's old sense, and screens of CAD programs.

use super::{morphology, tone};
use crate::mask::Mask;
use crate::rows;
use image::{GrayImage, RgbImage};

/// A ground is thicker than this share of the page's smaller side; walls are thinner.
pub const THICK: f32 = 0.03;
/// So much of the page must be dark ground.
const GROUND_SHARE: f32 = 0.35;
/// Dark is below this share of the lightest tone.
const DARK: f32 = 0.5;
/// A page is looked at in about this many samples along its longer side.
const SAMPLES: u32 = 800;

/// The ground's colour, if the page is drawn in light lines on dark ground.
pub fn ground(picture: &RgbImage) -> Option<[u8; 3]> {
    let step = picture.width().max(picture.height()).div_ceil(SAMPLES).max(1);
    let colours = samples(picture, step);
    let tones: Vec<u8> = colours.iter().map(|&c| tone::luma(c)).collect();
    let dark = f32::from(quantile(&tones, 0.99)?) * DARK;
    let set = tones.iter().map(|&t| f32::from(t) < dark).collect();
    let mask = Mask { width: picture.width().div_ceil(step), height: picture.height().div_ceil(step), set };
    let thick = morphology::opened(&mask, reach(mask.width, mask.height));
    let enough = thick.count() as f32 > GROUND_SHARE * mask.set.len() as f32;
    enough.then(|| median(colours.iter().zip(&thick.set).filter(|&(_, &t)| t).map(|(&c, _)| c)))
}

/// Half the thickness of a ground in a picture of this size.
fn reach(width: u32, height: u32) -> u32 {
    (width.min(height) as f32 * THICK / 2.0).ceil() as u32
}

fn samples(picture: &RgbImage, step: u32) -> Vec<[u8; 3]> {
    let places = (0..picture.height()).step_by(step as usize);
    places
        .flat_map(|y| (0..picture.width()).step_by(step as usize).map(move |x| picture.get_pixel(x, y).0))
        .collect()
}

fn quantile(tones: &[u8], share: f32) -> Option<u8> {
    let mut sorted = tones.to_vec();
    sorted.sort_unstable();
    sorted.get(((tones.len() as f32 * share) as usize).min(tones.len().saturating_sub(1))).copied()
}

fn median(colours: impl Iterator<Item = [u8; 3]>) -> [u8; 3] {
    let mut channels = [vec![], vec![], vec![]];
    colours.for_each(|c| channels.iter_mut().zip(c).for_each(|(all, v)| all.push(v)));
    channels.map(|all| quantile(&all, 0.5).unwrap_or(0))
}

/// The page as dark lines on white: the more a pixel differs from the ground in any channel, the darker it
/// becomes, so that red and blue lines on black turn out as dark as white ones.
pub fn inverted(picture: &RgbImage, ground: [u8; 3]) -> GrayImage {
    let mut grey = GrayImage::new(picture.width(), picture.height());
    let width = picture.width() as usize;
    let farthest = ground.iter().map(|&g| g.max(255 - g)).max().unwrap_or(255);
    let scale: Vec<u8> =
        (0..=255u32).map(|d| 255 - (d * 255 / u32::from(farthest.max(1))).min(255) as u8).collect();
    let raw = picture.as_raw();
    rows::for_each(&mut grey, width, |y, row| {
        let from = raw[y * width * 3..(y + 1) * width * 3].chunks_exact(3);
        row.iter_mut().zip(from).for_each(|(to, c)| *to = scale[distance(c, ground) as usize]);
    });
    hollow(&mut grey);
    grey
}

fn distance(colour: &[u8], ground: [u8; 3]) -> u8 {
    colour.iter().zip(ground).map(|(&c, g)| c.abs_diff(g)).max().unwrap_or(0)
}

/// Where the page is white outside of a dark building, inverting makes a dark mass of the outside. Only a rim
/// of it stays, which is the building's outer wall.
fn hollow(grey: &mut GrayImage) {
    let step = grey.width().max(grey.height()).div_ceil(SAMPLES).max(1);
    let (width, height) = (grey.width().div_ceil(step), grey.height().div_ceil(step));
    let cell = |i: u32| grey.get_pixel(i % width * step, i / width * step).0[0] < 128;
    let dark = Mask { width, height, set: (0..width * height).map(cell).collect() };
    let thick = morphology::opened(&dark, reach(width, height));
    // A rim of a fifth of what counts as thick is a wall among the others.
    let inner = morphology::shrunk(&thick, (reach(width, height) * 2 / 5).max(1));
    let row_length = grey.width() as usize;
    rows::for_each(grey, row_length, |y, row| {
        let cells = &inner.set[y / step as usize * width as usize..];
        row.iter_mut().enumerate().filter(|(x, _)| cells[x / step as usize]).for_each(|(_, v)| *v = 255);
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    const BLUE: [u8; 3] = [20, 60, 160];

    /// A room's outline of this colour on a ground of that one.
    fn room(line: [u8; 3], ground: [u8; 3]) -> RgbImage {
        RgbImage::from_fn(200, 150, |x, y| {
            let out = x.min(199 - x).min(y).min(149 - y);
            Rgb(if (30..33).contains(&out) { line } else { ground })
        })
    }

    #[test]
    fn dark_lines_on_paper_are_no_negative() {
        assert_eq!(ground(&room([0; 3], [255; 3])), None);
        assert_eq!(ground(&room([0; 3], [192; 3])), None);
        assert_eq!(ground(&RgbImage::new(0, 0)), None);
    }

    #[test]
    fn thick_dark_walls_are_no_ground() {
        let walls =
            RgbImage::from_fn(200, 200, |x, y| Rgb(if x % 20 < 5 || y < 5 { [20; 3] } else { [250; 3] }));
        assert_eq!(ground(&walls), None);
    }

    #[test]
    fn a_blueprint_is_turned_into_dark_lines_on_white() {
        let page = room([250, 250, 255], BLUE);
        assert_eq!(ground(&page), Some(BLUE));
        let grey = inverted(&page, BLUE);
        assert!(grey.get_pixel(31, 75).0[0] < 40);
        assert_eq!(grey.get_pixel(100, 75).0[0], 255);
    }

    #[test]
    fn coloured_lines_on_black_are_as_dark_as_white_ones() {
        for line in [[255, 0, 0], [0, 0, 255], [255, 255, 255]] {
            let page = room(line, [0; 3]);
            assert_eq!(inverted(&page, [0; 3]).get_pixel(31, 75).0[0], 0, "{line:?}");
        }
    }

    #[test]
    fn of_white_paper_around_a_dark_building_a_rim_stays() {
        let page = RgbImage::from_fn(200, 200, |x, y| {
            Rgb(if x.min(199 - x).min(y).min(199 - y) < 30 { [255; 3] } else { [0; 3] })
        });
        let grey = inverted(&page, ground(&page).unwrap_or_default());
        assert_eq!(grey.get_pixel(5, 100).0[0], 255);
        assert_eq!(grey.get_pixel(29, 100).0[0], 0);
        assert_eq!(grey.get_pixel(100, 100).0[0], 255);
    }
}
