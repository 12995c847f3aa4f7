//! Windows by the regions between their lines: long boxes, one or several side by side, that close a gap in a wall. What
//! stands close to the window on one side, a desk or a flight of steps, does no harm.

use super::near::Near;
use super::plane::{Plane, Vec2};
use super::regions::{Region, regions};
use super::shapes::Box2;
use crate::found::SheetSymbol;
use crate::sheet::Sheet;

/// Where pixels are larger than this, metres, the faces of a wall are too close to tell its inside from panes.
const COARSEST: f64 = 0.03;
/// Length of a window, metres.
const LENGTH: [f64; 2] = [0.4, 4.5];
/// From its first line to its last.
const DEPTH: [f64; 2] = [0.05, 0.6];
/// A box fills its bounds but for this.
const FULL: f64 = 0.88;
/// A line of the drawing is no wider, metres.
const STROKE: f64 = 0.05;
/// A window's lines may lie behind the faces of the wall by so much.
const INSET: f64 = 0.14;
/// A wall's filling or hatching is darker than a window by this much of 255.
const LIGHTER: f64 = 12.0;

/// All windows of the plane; `own` is metres per pixel of it.
pub fn find(sheet: &Sheet, plane: &Plane, own: f64) -> Vec<SheetSymbol> {
    if own > COARSEST {
        return Vec::new();
    }
    let mut boxes = regions(plane, 1.0, LENGTH[1] / own);
    boxes.retain(|r| {
        let [w, h] = r.size().map(|s| s * own);
        w.max(h) >= LENGTH[0] && w.min(h) <= DEPTH[1] && w.max(h) > 1.3 * w.min(h) && r.fullness() >= FULL
    });
    let search = Search { sheet, plane, pixel: own };
    let near = Near::of(boxes.iter().map(Region::middle), DEPTH[1] / own);
    let mut taken = vec![false; boxes.len()];
    let mut found = Vec::new();
    for i in 0..boxes.len() {
        if taken[i] {
            continue;
        }
        let stack = stack(&boxes, &near, i, own);
        stack.iter().for_each(|&k| taken[k] = true);
        let panes = Panes::of(&boxes, &stack);
        if search.is_window(&panes) {
            found.push(panes.area(f64::from(plane.factor)).symbol("window", 0.8));
        }
    }
    found
}

/// The boxes of the same length that lie side by side with this one, but for a line between.
fn stack(boxes: &[Region], near: &Near, first: usize, pixel: f64) -> Vec<usize> {
    let mut stack = vec![first];
    let axis = lying(&boxes[first]);
    let slack = (0.04 / pixel).max(2.0);
    let stroke = STROKE / pixel + 2.0;
    let mut k = 0;
    while k < stack.len() {
        let own = &boxes[stack[k]].bounds;
        let joins = |i: usize| {
            let r = &boxes[i];
            let b = &r.bounds;
            let same = |side: usize| f64::from(b[side].abs_diff(own[side])) <= slack;
            let across = 1 - axis;
            let gap = (f64::from(b[across]) - f64::from(own[across + 2]))
                .max(f64::from(own[across]) - f64::from(b[across + 2]));
            let beside = lying(r) == axis && same(axis) && same(axis + 2) && (0.0..=stroke).contains(&gap);
            (beside && !stack.contains(&i)).then_some(i)
        };
        let more: Vec<usize> = near.around(boxes[stack[k]].middle()).into_iter().filter_map(joins).collect();
        stack.extend(more);
        k += 1;
    }
    stack
}

/// 0 if the box is longer than high, or else 1.
fn lying(region: &Region) -> usize {
    let [w, h] = region.size();
    usize::from(h > w)
}

/// The boxes between a window's lines.
struct Panes {
    count: usize,
    /// 0 if they lie level, 1 if upright.
    axis: usize,
    /// Where they begin and end along.
    along: [f64; 2],
    /// And across, their outer lines included.
    across: [f64; 2],
}

impl Panes {
    fn of(boxes: &[Region], stack: &[usize]) -> Self {
        let axis = stack.first().map_or(0, |&i| lying(&boxes[i]));
        let ends = |axis: usize| {
            let least = stack.iter().map(|&i| boxes[i].bounds[axis]).min().unwrap_or(0);
            let most = stack.iter().map(|&i| boxes[i].bounds[axis + 2]).max().unwrap_or(0);
            [f64::from(least), f64::from(most)]
        };
        let [low, high] = ends(1 - axis);
        Self { count: stack.len(), axis, along: ends(axis), across: [low - 1.0, high + 1.0] }
    }

    fn at(&self, along: f64, across: f64) -> Vec2 {
        if self.axis == 0 { [along, across] } else { [across, along] }
    }

    fn middle(&self) -> Vec2 {
        [(self.along[0] + self.along[1]) / 2.0, (self.across[0] + self.across[1]) / 2.0]
    }

    fn depth(&self) -> f64 {
        self.across[1] - self.across[0]
    }

    fn area(&self, scale: f64) -> Box2 {
        let [u, v] = self.middle();
        Box2 {
            centre: self.at(u, v).map(|c| c * scale),
            along: self.at(1.0, 0.0),
            half: [(self.along[1] - self.along[0]) / 2.0 * scale, self.depth() / 2.0 * scale],
        }
    }
}

struct Search<'a> {
    sheet: &'a Sheet,
    plane: &'a Plane,
    pixel: f64,
}

impl Search<'_> {
    fn is_window(&self, panes: &Panes) -> bool {
        let (depth, length) = (panes.depth() * self.pixel, (panes.along[1] - panes.along[0]) * self.pixel);
        if !(DEPTH[0]..=DEPTH[1]).contains(&depth) || length < 1.3 * depth || panes.count > 4 {
            return false;
        }
        let ends = [(panes.along[0], -1.0), (panes.along[1], 1.0)];
        let solid = ends.iter().all(|&(end, out)| self.is_solid(panes, end, out));
        let lined = ends.iter().all(|&(end, out)| self.is_lined(panes, end, out));
        (solid || lined) && self.is_free(panes)
    }

    /// Whether the wall beyond an end is inked all through.
    fn is_solid(&self, panes: &Panes, end: f64, out: f64) -> bool {
        let [low, high] = panes.across;
        let inked = |d: f64| {
            let at = end + out * (d / self.pixel + 1.0);
            self.plane.covered(panes.at(at, low + 1.0), panes.at(at, high - 1.0), 0.5) >= 0.85
        };
        [0.05, 0.09, 0.13].iter().filter(|&&d| inked(d)).count() >= 2
    }

    /// Whether the wall's faces go on beyond an end, and its filling ends there, or the window shows by its lines.
    fn is_lined(&self, panes: &Panes, end: f64, out: f64) -> bool {
        let [low, high] = panes.across;
        let from = end + out * (0.04 / self.pixel + 1.0);
        let to = end + out * (0.22 / self.pixel + 1.0);
        let face = |off: f64| self.plane.covered(panes.at(from, off), panes.at(to, off), 0.5) >= 0.9;
        let steps = (INSET / self.pixel) as i32;
        let below = (-2..=steps).any(|k| face(low - f64::from(k)));
        let above = (-2..=steps).any(|k| face(high + f64::from(k)));
        let middle = panes.middle()[0];
        below
            && above
            && (panes.count > 1
                || self.lightness(panes, end + out * 0.13 / self.pixel) + LIGHTER
                    < self.lightness(panes, middle))
    }

    /// Whether on one side at least no such line lies close by, as in shelves and hatching.
    fn is_free(&self, panes: &Panes) -> bool {
        let clear = (0.12 / self.pixel).max(3.5);
        let [from, to] = panes.along;
        let [low, high] = panes.across;
        let free = |off: f64| self.plane.covered(panes.at(from, off), panes.at(to, off), 0.5) < 0.5;
        let side = |edge: f64, out: f64| [0.4, 0.7, 1.0].iter().all(|t| free(edge + out * (t * clear + 1.5)));
        side(low, -1.0) || side(high, 1.0)
    }

    /// The mean grey between the window's outer lines, around one place along them.
    fn lightness(&self, panes: &Panes, along: f64) -> f64 {
        let scale = f64::from(self.plane.factor);
        let grey = |i: i32, k: i32| {
            let across = panes.across[0] + panes.depth() * (0.2 + 0.6 * f64::from(k) / 8.0);
            let place = panes.at(along + f64::from(i) * 0.01 / self.pixel, across);
            let [x, y] = place.map(|v| (v * scale).max(0.0) as u32);
            let p = self.sheet.colour.get_pixel_checked(x, y).map_or([255; 3], |p| p.0);
            p.iter().map(|&c| f64::from(c)).sum::<f64>() / 3.0
        };
        (-6..=6).flat_map(|i| (0..=8).map(move |k| (i, k))).map(|(i, k)| grey(i, k)).sum::<f64>() / 117.0
    }
}
