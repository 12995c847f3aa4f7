//! How straight walls are. Photographs and textures have dark parts as plans do, but people build in straight lines.

use super::components::Neighbours;
use super::drawing::Drawing;
use super::straight;
use super::tracks::TURNS;

/// A stretch of outline is straight if it is so long: pixels, or this share of the drawing's diagonal.
const LEAST: f64 = 15.0;
const SHARE: f64 = 0.03;

/// What lies this near to the sheet's edge may be the edge of the picture, as a share of the longer side.
const MARGIN: f64 = 0.02;

/// Lines between two of the directions that are walked look bent; these are half way, radians.
const BETWEEN: f64 = std::f64::consts::PI / TURNS as f64 / 2.0;

/// The share of the walls' outline that lies in long straight stretches; 0 if there are no walls.
pub fn straightness(drawing: &Drawing, occupied: &[bool]) -> f64 {
    let outline = outline(drawing, occupied);
    let least = LEAST.max(SHARE * (drawing.width as f64).hypot(drawing.height as f64));
    let upright = share(&outline, drawing.width, least);
    let (turned, width) = turned(&outline, drawing.width, drawing.height);
    upright.max(share(&turned, width, least))
}

fn outline(drawing: &Drawing, occupied: &[bool]) -> Vec<bool> {
    let (width, height) = (drawing.width, drawing.height);
    let margin = (MARGIN * width.max(height) as f64) as usize;
    let is_inner = |i: usize| {
        let (x, y) = (i % width, i / width);
        x >= margin && y >= margin && x + margin < width && y + margin < height
    };
    let is_outline =
        |i: usize| occupied[i] && is_inner(i) && Neighbours::Four.of(i, width, height).any(|n| !occupied[n]);
    (0..occupied.len()).map(is_outline).collect()
}

/// The share of what is set that lies in straight stretches of at least this length, pixels.
fn share(set: &[bool], width: usize, least: f64) -> f64 {
    let runs = straight::runs(set, width);
    let all = set.iter().filter(|&&s| s).count();
    let long = runs.length.iter().filter(|&&l| f64::from(l) >= least).count();
    long as f64 / all.max(1) as f64
}

/// A picture turned by half of the angle between two directions, and its width.
fn turned(set: &[bool], width: usize, height: usize) -> (Vec<bool>, usize) {
    let (sin, cos) = BETWEEN.sin_cos();
    let (w, h) = (width as f64, height as f64);
    let columns = (w * cos + h * sin).ceil() as usize + 1;
    let rows = (w * sin + h * cos).ceil() as usize + 1;
    // The picture's upper left corner comes to lie below the new one's, so that all of it has its place.
    let from = |i: usize| {
        let (x, y) = ((i % columns) as f64, (i / columns) as f64 - w * sin);
        ((x * cos - y * sin).round(), (x * sin + y * cos).round())
    };
    let is_set = |i: usize| {
        let (x, y) = from(i);
        x >= 0.0 && y >= 0.0 && x < w && y < h && set[y as usize * width + x as usize]
    };
    ((0..columns * rows).map(is_set).collect(), columns)
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
    fn walls_are_straight_at_any_angle() {
        for degrees in 0..30 {
            let (sin, cos) = (f64::from(degrees) * std::f64::consts::PI / 180.0).sin_cos();
            let wall = of(|x, y| {
                let (x, y) = (x as f64 - 150.0, y as f64 - 100.0);
                (x * cos + y * sin).abs() < 90.0 && (y * cos - x * sin).abs() < 3.0
            });
            assert!(wall > 0.6, "{degrees} degrees: {wall}");
        }
    }

    #[test]
    fn walls_are_straight_and_blots_are_not() {
        assert!(of(|x, y| (50..250).contains(&x) && (50..54).contains(&y)) > 0.9);
        let blot = |x: usize, y: usize| (x % 20).abs_diff(10).pow(2) + (y % 20).abs_diff(10).pow(2) < 49;
        assert!(of(blot) < 0.1);
        assert_eq!(of(|_, _| false), 0.0);
    }
}
