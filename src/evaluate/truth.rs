//! A truth given as a layout, drawn as a label image.
//!
//! Both layouts are drawn with pixels of at most 2 cm, so that the measures and their rules are the same as for a
//! truth image, and the work stays bounded whatever the polygons are like. Where true rooms overlap, the first one in
//! the file owns the pixels.

use super::budget::Budget;
use super::error::limit;
use super::labels::LabelImage;
use super::pair::Settings;
use super::raster::{Size, scan};
use super::rooms::RoomShape;
use planform_sdk::{PluginError, Point, Polygon};

/// The largest pixel, metres.
const FINEST: f64 = 0.02;
/// The most pixels: 160 m square at 2 cm. A larger building has larger pixels.
const MAX_PIXELS: f64 = (1u64 << 26) as f64;

/// A truth and its prediction, drawn.
pub(super) struct Drawing {
    pub(super) truth: LabelImage,
    /// The predicted rooms in pixels of the truth.
    pub(super) predicted: Vec<RoomShape>,
    /// The smallest room in these pixels.
    pub(super) min_px: f64,
    /// Metres per pixel.
    pub(super) resolution: f64,
}

/// Draws rooms that are given in pixels of the map.
pub(super) fn draw(
    truth: &[RoomShape],
    predicted: &[RoomShape],
    settings: &Settings,
) -> Result<Drawing, PluginError> {
    let resolution = settings.frame().resolution;
    let window = Window::around(truth, predicted, resolution)?;
    let min_px = settings.min_px() as f64 * window.scale * window.scale;
    Ok(Drawing {
        truth: without_small(paint(&window.see(truth), window.size())?, min_px),
        predicted: window.see(predicted),
        min_px,
        resolution: resolution / window.scale,
    })
}

/// The part of the plane that is drawn, in pixels of the map.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Window {
    low: Point,
    high: Point,
    /// Pixels drawn for each pixel of the map, along one axis.
    scale: f64,
}

impl Window {
    /// All true rooms, and of the predicted ones what lies no farther from them than they are wide and high.
    fn around(truth: &[RoomShape], predicted: &[RoomShape], resolution: f64) -> Result<Self, PluginError> {
        let Some((low, high)) = bounds(truth) else {
            return Ok(Self { low: Point::default(), high: Point::default(), scale: 1.0 });
        };
        let (width, height) = (high.x - low.x, high.y - low.y);
        let (far_low, far_high) =
            (Point::new(low.x - width, low.y - height), Point::new(high.x + width, high.y + height));
        let (seen_low, seen_high) = bounds(predicted).unwrap_or((low, high));
        let low = smallest(low, largest(seen_low, far_low));
        let high = largest(high, smallest(seen_high, far_high));
        let window = Self {
            low: Point::new(low.x.floor(), low.y.floor()),
            high: Point::new(high.x.ceil(), high.y.ceil()),
            scale: (resolution / FINEST).ceil().max(1.0),
        };
        window.within_limits(resolution)
    }

    fn within_limits(self, resolution: f64) -> Result<Self, PluginError> {
        let (width, height) = (self.high.x - self.low.x, self.high.y - self.low.y);
        let scale = self.scale.min((MAX_PIXELS / (width * height).max(1.0)).sqrt());
        if scale * 10.0 * FINEST < resolution.min(5.0 * FINEST) || width.max(height) * scale > MAX_PIXELS {
            let message = format!(
                "spans {:.0} x {:.0} m, too much to compare",
                width * resolution,
                height * resolution
            );
            return Err(limit(message).advise("check the units of the truth and the resolution"));
        }
        Ok(Self { scale, ..self })
    }

    fn size(&self) -> Size {
        let pixels = |length: f64| (length * self.scale).ceil() as usize;
        Size { width: pixels(self.high.x - self.low.x), height: pixels(self.high.y - self.low.y) }
    }

    fn see(&self, rooms: &[RoomShape]) -> Vec<RoomShape> {
        let point = |p: &Point| Point::new((p.x - self.low.x) * self.scale, (p.y - self.low.y) * self.scale);
        let ring = |ring: &Vec<Point>| ring.iter().map(point).collect();
        let polygon =
            |p: &Polygon| Polygon { exterior: ring(&p.exterior), holes: p.holes.iter().map(ring).collect() };
        let room =
            |r: &RoomShape| RoomShape { name: r.name.clone(), parts: r.parts.iter().map(polygon).collect() };
        rooms.iter().map(room).collect()
    }
}

fn bounds(rooms: &[RoomShape]) -> Option<(Point, Point)> {
    planform_sdk::bounds(rooms.iter().flat_map(|r| &r.parts).flat_map(|p| p.exterior.iter().copied()))
}

fn smallest(a: Point, b: Point) -> Point {
    Point::new(a.x.min(b.x), a.y.min(b.y))
}

fn largest(a: Point, b: Point) -> Point {
    Point::new(a.x.max(b.x), a.y.max(b.y))
}

fn paint(rooms: &[RoomShape], size: Size) -> Result<LabelImage, PluginError> {
    let mut labels = vec![0; size.width * size.height];
    let mut budget = Budget::new(Budget::STEPS);
    for (room, label) in rooms.iter().zip(1..) {
        scan(&room.parts, size, &mut budget, |row, columns| {
            let start = row * size.width;
            let pixels = &mut labels[start + columns.start..start + columns.end];
            pixels.iter_mut().filter(|pixel| **pixel == 0).for_each(|pixel| *pixel = label);
        })?;
    }
    let names = rooms.iter().map(|r| r.name.clone()).collect();
    Ok(LabelImage { width: size.width, height: size.height, labels, names })
}

fn without_small(image: LabelImage, min_px: f64) -> LabelImage {
    let keep: Vec<_> = image.areas().into_iter().map(|pixels| pixels as f64 > min_px).collect();
    let mut numbers = vec![0];
    let mut last = 0;
    for &keep in &keep {
        last += u32::from(keep);
        numbers.push(if keep { last } else { 0 });
    }
    let labels = image.labels.into_iter().map(|label| numbers[label as usize]).collect();
    let names = image.names.into_iter().zip(keep).filter_map(|(name, keep)| keep.then_some(name)).collect();
    LabelImage { labels, names, ..image }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn room(x0: f64, y0: f64, x1: f64, y1: f64) -> RoomShape {
        let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Point::from).to_vec();
        RoomShape { name: format!("{x0}"), parts: vec![Polygon::new(ring, vec![])] }
    }

    fn drawn(truth: &[RoomShape], predicted: &[RoomShape], min_px: u64) -> Drawing {
        draw(truth, predicted, &Settings { min_px: Some(min_px), ..Settings::default() }).unwrap()
    }

    #[test]
    fn pixels_are_at_most_2_cm() {
        let d = drawn(&[room(-10.0, -10.0, 10.0, 0.0)], &[], 100);
        assert_eq!((d.truth.width, d.truth.height, d.min_px), (60, 30, 900.0));
        assert!(d.resolution <= 0.02);
    }

    #[test]
    fn the_first_of_overlapping_rooms_owns_the_pixels() {
        let d = drawn(&[room(0.0, 0.0, 4.0, 4.0), room(2.0, 0.0, 6.0, 4.0)], &[], 0);
        assert_eq!(d.truth.areas(), [16 * 9, 8 * 9]);
    }

    #[test]
    fn small_rooms_are_dropped() {
        let d = drawn(&[room(0.0, 0.0, 2.0, 2.0), room(5.0, 0.0, 9.0, 1.25)], &[], 4);
        assert_eq!((d.truth.names, d.truth.labels.iter().max()), (vec!["5".to_string()], Some(&1)));
    }

    #[test]
    fn predictions_are_seen_as_far_as_the_truth_is_wide() {
        let d = drawn(&[room(0.0, 0.0, 10.0, 10.0)], &[room(-3.0, 0.0, 1e9, 10.0)], 0);
        assert_eq!((d.truth.width, d.truth.height), (23 * 3, 10 * 3));
        assert_eq!(d.predicted[0].parts[0].exterior[0], Point::new(0.0, 0.0));
    }

    #[test]
    fn large_buildings_have_larger_pixels_and_monsters_are_refused() {
        let d = drawn(&[room(0.0, 0.0, 6000.0, 4000.0)], &[], 100);
        assert!(d.truth.labels.len() <= MAX_PIXELS as usize + 20_000 && d.resolution > 0.02);
        for monster in [room(0.0, 0.0, 1e9, 1e9), room(0.0, 0.0, 1e12, 1e-9), room(-1e12, 0.0, 1e12, 1.0)] {
            assert!(draw(&[monster], &[], &Settings::default()).is_err());
        }
    }

    #[test]
    fn no_room_is_an_empty_image() {
        let d = drawn(&[], &[room(0.0, 0.0, 1.0, 1.0)], 0);
        assert_eq!((d.truth.width, d.truth.names.len()), (0, 0));
    }
}
