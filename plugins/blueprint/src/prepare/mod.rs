//! From a page to a sheet: evenly lit, upright, paper told from ink, the drawing told from what stands around
//! it.

mod aside;
mod clusters;
mod colour;
pub mod faint;
mod ink;
mod light;
mod morphology;
mod negative;
mod palette;
mod skew;
mod tone;
mod turn;

use crate::mask::Mask;
use crate::page::Page;
use crate::sheet::Sheet;
use crate::stages::Stages;
use image::{GrayImage, Luma, Rgb, RgbImage};

/// Makes a page ready for reading, and tells of every step: `light`, `colour`, `deskew`, `ink` and `aside`.
pub fn sheet(page: &Page, stages: &mut dyn Stages) -> Sheet {
    let (colour, grey) = lit(page, stages);
    stages.stage("colour", &mut || shown(&grey));
    let (colour, grey, turned) = upright(page, colour, grey);
    stages.stage("deskew", &mut || shown(&grey));
    let ink = ink::ink(&grey);
    stages.stage("ink", &mut || drawn(&ink, &Mask::empty(ink.width, ink.height)));
    let (ink, aside) = if page.walls_only { aside::nothing(ink) } else { aside::parted(ink) };
    stages.stage("aside", &mut || drawn(&ink, &aside));
    Sheet { colour, grey, ink, aside, turned, page_size: [page.picture.width(), page.picture.height()] }
}

/// The page under even light, and what is drawn on it in dark on light.
fn lit(page: &Page, stages: &mut dyn Stages) -> (RgbImage, GrayImage) {
    let mut colour = page.picture.clone();
    let width = colour.width() as usize;
    if let Some(ground) = negative::ground(&colour) {
        let mut positive = shown(&negative::inverted(&colour, ground));
        light::flatten::<3>(&mut positive, width);
        stages.stage("light", &mut || positive.clone());
        return (colour, colour::without_colours(&positive));
    }
    light::flatten::<3>(&mut colour, width);
    stages.stage("light", &mut || colour.clone());
    let grey = colour::without_colours(&colour);
    (colour, grey)
}

/// Both pictures turned so that the drawing's strokes are upright, and by which angle.
fn upright(page: &Page, colour: RgbImage, grey: GrayImage) -> (RgbImage, GrayImage, f64) {
    let angle = if page.walls_only { 0.0 } else { -skew::skew(&grey) };
    if angle == 0.0 {
        return (colour, grey, 0.0);
    }
    // One after the other, so that no more than one of them is held twice.
    let grey = turn::turned(&grey, angle);
    let colour = turn::turned(&colour, angle);
    (colour, grey, angle)
}

fn shown(grey: &GrayImage) -> RgbImage {
    RgbImage::from_fn(grey.width(), grey.height(), |x, y| {
        let Luma([v]) = *grey.get_pixel(x, y);
        Rgb([v; 3])
    })
}

/// Ink in black, what was set aside in a light red.
fn drawn(ink: &Mask, aside: &Mask) -> RgbImage {
    RgbImage::from_fn(ink.width, ink.height, |x, y| {
        let (x, y) = (i64::from(x), i64::from(y));
        Rgb(match () {
            () if ink.get(x, y) => [0; 3],
            () if aside.get(x, y) => [240, 120, 110],
            () => [255; 3],
        })
    })
}
