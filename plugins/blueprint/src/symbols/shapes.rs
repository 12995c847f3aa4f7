//! Boxes at any angle on the sheet.

use super::plane::{Vec2, dot, moved};
use crate::found::SheetSymbol;
use crate::mask::Mask;

/// A box, in pixels of the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Box2 {
    /// Its middle.
    pub centre: Vec2,
    /// The unit vector along it.
    pub along: Vec2,
    /// Half of its length along, and across.
    pub half: Vec2,
}

impl Box2 {
    /// The box of a symbol.
    pub fn of(symbol: &SheetSymbol) -> Self {
        let along = super::plane::unit(symbol.angle);
        Self { centre: symbol.centre, along, half: [symbol.width / 2.0, symbol.height / 2.0] }
    }

    /// Larger by so much on each side along, and across.
    pub fn grown(&self, by: Vec2) -> Self {
        Self { half: [self.half[0] + by[0], self.half[1] + by[1]].map(|h| h.max(0.0)), ..*self }
    }

    /// Whether the point lies in the box.
    pub fn contains(&self, p: Vec2) -> bool {
        let d = [p[0] - self.centre[0], p[1] - self.centre[1]];
        dot(d, self.along).abs() <= self.half[0]
            && dot(d, [-self.along[1], self.along[0]]).abs() <= self.half[1]
    }

    /// Its corners, one after the other.
    pub fn corners(&self) -> [Vec2; 4] {
        let across = [-self.along[1], self.along[0]];
        let at = |a: f64, b: f64| {
            moved(moved(self.centre, self.along, a * self.half[0]), across, b * self.half[1])
        };
        [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)]
    }

    /// A symbol that fills the box.
    pub fn symbol(&self, kind: &str, score: f64) -> SheetSymbol {
        SheetSymbol {
            kind: kind.into(),
            centre: self.centre,
            angle: self.along[1].atan2(self.along[0]),
            width: 2.0 * self.half[0],
            height: 2.0 * self.half[1],
            score,
            leaves: Vec::new(),
        }
    }
}

/// Adds all ink in the box.
pub fn erase_inside(ink: &Mask, area: &Box2, erase: &mut Mask) {
    inside(ink, area).for_each(|i| erase.set[i] = true);
}

/// How many pixels are set in the box.
pub fn count_inside(mask: &Mask, area: &Box2) -> usize {
    inside(mask, area).count()
}

/// The indices of all pixels that are set in the box.
fn inside(mask: &Mask, area: &Box2) -> impl Iterator<Item = usize> {
    let reach = area.half[0].hypot(area.half[1]).ceil() + 1.0;
    let range = |at: f64, end: u32| {
        let clamp = |v: f64| v.clamp(0.0, f64::from(end)) as u32;
        clamp(at - reach)..clamp(at + reach)
    };
    let (columns, rows) = (range(area.centre[0], mask.width), range(area.centre[1], mask.height));
    let places = rows.flat_map(move |y| columns.clone().map(move |x| (x, y)));
    let index = |x: u32, y: u32| y as usize * mask.width as usize + x as usize;
    places
        .filter(|&(x, y)| area.contains([f64::from(x) + 0.5, f64::from(y) + 0.5]))
        .map(move |(x, y)| index(x, y))
        .filter(|&i| mask.set[i])
}
