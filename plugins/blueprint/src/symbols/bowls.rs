//! Basins and toilets, by the regions that their lines enclose: a bowl is round; a basin's outline runs around it, a
//! toilet's tank lies behind it.

use super::near::Near;
use super::plane::{Plane, Vec2};
use super::regions::{Region, regions};
use super::shapes::{Box2, erase_inside};
use crate::found::SheetSymbol;
use crate::mask::Mask;
use std::f64::consts::{FRAC_PI_2, PI};

/// A region narrower than this is a line's own inside, and none is longer, metres.
const SIDES: [f64; 2] = [0.07, 1.0];
/// The middles of two regions of one thing are no farther apart, metres.
const REACH: f64 = 1.2;
/// How far a round outline may be off an ellipse, as a share of its size.
const ROUND: f64 = 0.11;
/// A toilet's bowl across and along, metres.
const TOILET: [[f64; 2]; 2] = [[0.15, 0.5], [0.18, 0.65]];
/// Narrower than this it is the inside of a seat, and lies further from the tank.
const SEAT: f64 = 0.24;
/// Its tank across and along.
const TANK: [[f64; 2]; 2] = [[0.22, 0.65], [0.07, 0.32]];
/// A basin's bowl: shorter and longer side.
const BOWL: [[f64; 2]; 2] = [[0.13, 0.5], [0.18, 0.65]];
/// The basin itself.
const BASIN: [[f64; 2]; 2] = [[0.24, 0.65], [0.3, 0.85]];
/// Lines are drawn wider by no more than this, metres, to close their gaps.
const WIDER: f64 = 0.026;
/// The share of an outline that must be drawn.
const DRAWN: f64 = 0.82;

/// A box of the plane: left, top, right, bottom.
type Frame = [f64; 4];

/// All basins and toilets, and what draws them. `pixel` is metres per pixel of the ink.
pub fn find(ink: &Mask, pixel: f64, erase: &mut Mask) -> Vec<SheetSymbol> {
    let (mut plane, own) = Plane::close(ink, pixel);
    let mut found: Vec<SheetSymbol> = Vec::new();
    // Lines may have gaps: what is not closed may be so where they are drawn wider.
    for wider in 0..=((WIDER / own) as u32).clamp(1, 2) {
        if wider > 0 {
            plane.mask = widened(&plane.mask);
        }
        search(&plane, own, &mut found);
    }
    for symbol in &mut found {
        *symbol = scaled(symbol.clone(), f64::from(plane.factor));
        erase_inside(ink, &Box2::of(symbol).grown([0.02 / pixel; 2]), erase);
    }
    found
}

/// Adds what is found on a plane, toilets first: a seat in a bowl looks much like a basin.
fn search(plane: &Plane, pixel: f64, found: &mut Vec<SheetSymbol>) {
    let parts = regions(plane, SIDES[0] / pixel, SIDES[1] / pixel);
    let near = Near::of(parts.iter().map(Region::middle), REACH / pixel);
    let search = Search { plane, parts: &parts, near: &near, pixel };
    let toilets = parts.iter().filter_map(|bowl| search.toilet(bowl));
    let basins = parts.iter().filter_map(|bowl| search.basin(bowl));
    for symbol in toilets.chain(basins) {
        if !found.iter().any(|f| Box2::of(f).contains(symbol.centre)) {
            found.push(symbol);
        }
    }
}

/// The mask with all lines wider by a pixel, to the right and down.
fn widened(mask: &Mask) -> Mask {
    let width = mask.width as usize;
    let mut wider = mask.clone();
    for i in (0..mask.set.len()).filter(|&i| mask.set[i]) {
        let right = (i + 1) % width != 0;
        for next in [right.then_some(i + 1), Some(i + width), right.then_some(i + width + 1)] {
            if let Some(set) = next.and_then(|n| wider.set.get_mut(n)) {
                *set = true;
            }
        }
    }
    wider
}

fn scaled(symbol: SheetSymbol, by: f64) -> SheetSymbol {
    let centre = symbol.centre.map(|v| v * by);
    SheetSymbol { centre, width: symbol.width * by, height: symbol.height * by, ..symbol }
}

fn within(range: [f64; 2], value: f64) -> bool {
    (range[0]..=range[1]).contains(&value)
}

struct Search<'a> {
    plane: &'a Plane,
    parts: &'a [Region],
    near: &'a Near,
    /// Metres per pixel of the plane.
    pixel: f64,
}

impl Search<'_> {
    /// The regions near one.
    fn around(&self, region: &Region) -> impl Iterator<Item = &Region> {
        self.near.around(region.middle()).into_iter().map(|i| &self.parts[i])
    }

    fn metres(&self, region: &Region) -> [f64; 2] {
        region.size().map(|s| s * self.pixel)
    }

    /// The toilet that has this bowl: round at its front, with a tank behind.
    fn toilet(&self, bowl: &Region) -> Option<SheetSymbol> {
        let [w, h] = self.metres(bowl);
        let off = bowl.off_ellipse();
        let seat = w.min(h) < SEAT;
        if seat && off.iter().any(|&o| o > ROUND) {
            return None;
        }
        // The front looks to the left, right, up or down.
        (0..4).filter(|&front| off[front] < ROUND).find_map(|front| {
            let (across, along) = if front < 2 { (h, w) } else { (w, h) };
            let sized = within(TOILET[0], across) && within(TOILET[1], along) && along > 0.85 * across;
            let tank = self.around(bowl).find(|t| sized && self.is_tank(t, bowl, front))?;
            let angle = [-FRAC_PI_2, FRAC_PI_2, 0.0, PI][front];
            Some(symbol("toilet", around(&[bowl, tank]), angle, 1.0 - off[front]))
        })
    }

    fn is_tank(&self, tank: &Region, bowl: &Region, front: usize) -> bool {
        let axis = front / 2;
        let (size, own) = (self.metres(tank), self.metres(bowl));
        let (across, along) = if axis == 0 { (size[1], size[0]) } else { (size[0], size[1]) };
        // From the bowl's rear end to the tank's front.
        let gap = if front.is_multiple_of(2) {
            f64::from(tank.bounds[axis]) - f64::from(bowl.bounds[axis + 2])
        } else {
            f64::from(bowl.bounds[axis]) - f64::from(tank.bounds[axis + 2])
        };
        let aside = (tank.middle()[1 - axis] - bowl.middle()[1 - axis]).abs() * self.pixel;
        let most = if own[1 - axis] < SEAT { 0.12 } else { 0.06 };
        let behind = within([-0.12, most + 4.0 * self.pixel], gap * self.pixel);
        let sized = within(TANK[0], across) && within(TANK[1], along) && across > 1.15 * along;
        behind
            && sized
            && aside < 0.15 * own[1 - axis]
            && across > 0.6 * own[1 - axis]
            && tank.fullness() > 0.8
    }

    /// The basin around this bowl.
    fn basin(&self, bowl: &Region) -> Option<SheetSymbol> {
        let [w, h] = self.metres(bowl);
        let off = bowl.off_ellipse();
        let round = off.iter().filter(|&&o| o < ROUND).count();
        if !(within(BOWL[0], w.min(h)) && within(BOWL[1], w.max(h)) && round >= 1) {
            return None;
        }
        self.outlines(bowl).into_iter().find_map(|frame| self.basin_in(frame, bowl, round))
    }

    /// Where the outline may lie: around one region that surrounds the bowl, or around all that touch it.
    fn outlines(&self, bowl: &Region) -> Vec<Frame> {
        let near = (0.04 / self.pixel).max(3.0);
        let [left, top, right, bottom] = bowl.bounds.map(f64::from);
        let touching: Vec<&Region> = self
            .around(bowl)
            .filter(|p| {
                let [l, t, r, b] = p.bounds.map(f64::from);
                l < right + near && r > left - near && t < bottom + near && b > top - near
            })
            .collect();
        let holds = |p: &&Region| {
            let [l, t, r, b] = p.bounds.map(f64::from);
            p.bounds != bowl.bounds && l <= left && t <= top && r >= right && b >= bottom
        };
        let mut frames: Vec<Frame> = touching.iter().copied().filter(holds).map(|p| around(&[p])).collect();
        frames.push(around(&touching));
        frames
    }

    fn basin_in(&self, frame: Frame, bowl: &Region, round: usize) -> Option<SheetSymbol> {
        let [l, t, r, b] = frame;
        let (w, h) = ((r - l) * self.pixel, (b - t) * self.pixel);
        let share = bowl.size()[0] * bowl.size()[1] / ((r - l) * (b - t));
        let sized = within(BASIN[0], w.min(h)) && within(BASIN[1], w.max(h)) && within([0.2, 0.8], share);
        let off = [0, 1].map(|i| bowl.middle()[i] - (frame[i] + frame[i + 2]) / 2.0);
        // The tap is behind the bowl, which lies to the front, and in the middle across.
        let [x, y] = [off[0] / (r - l), off[1] / (b - t)].map(f64::abs);
        if !sized || x.min(y) > 0.07 || x.max(y) > 0.2 {
            return None;
        }
        let outline = (0..6).map(|back| (self.drawn(&outline(frame, back)), back));
        let (drawn, back) = outline.max_by(|a, b| a.0.total_cmp(&b.0))?;
        // A circle in the middle of a square is a machine.
        let machine = back == 4 && (w / h).ln().abs() < 0.12 && x.max(y) < 0.04;
        let level = if back < 4 { back / 2 == 1 } else { y >= x };
        let angle = if level { 0.0 } else { FRAC_PI_2 };
        let score = drawn * (0.6 + 0.1 * round as f64);
        // A ring around a bowl is a toilet's, or a table's.
        (drawn >= DRAWN && back < 5 && !machine).then(|| symbol("sink", frame, angle, score))
    }

    /// The share of an outline that is drawn.
    fn drawn(&self, points: &[Vec2]) -> f64 {
        let reach = (0.025 / self.pixel).max(2.0);
        let sides = points.iter().zip(points.iter().cycle().skip(1));
        let (mut all, mut drawn) = (0.0, 0.0);
        for (&a, &b) in sides {
            let length = super::plane::distance(a, b);
            all += length;
            drawn += length * self.plane.covered(a, b, reach);
        }
        if all > 0.0 { drawn / all } else { 0.0 }
    }
}

/// With a straight back on the left, right, upper or lower side the half ellipse in a frame; the box itself; the whole
/// ellipse.
fn outline([l, t, r, b]: Frame, back: usize) -> Vec<Vec2> {
    let ([cx, cy], [w, h]) = ([(l + r) / 2.0, (t + b) / 2.0], [r - l, b - t]);
    let arc = (0..=16).map(|i| (PI * f64::from(i) / 16.0).sin_cos());
    match back {
        0 => arc.map(|(s, c)| [l + w * s, cy - h / 2.0 * c]).collect(),
        1 => arc.map(|(s, c)| [r - w * s, cy - h / 2.0 * c]).collect(),
        2 => arc.map(|(s, c)| [cx - w / 2.0 * c, t + h * s]).collect(),
        3 => arc.map(|(s, c)| [cx - w / 2.0 * c, b - h * s]).collect(),
        4 => vec![[l, t], [r, t], [r, b], [l, b]],
        _ => (0..32)
            .map(|i| (PI * f64::from(i) / 16.0).sin_cos())
            .map(|(s, c)| [cx + w / 2.0 * c, cy + h / 2.0 * s])
            .collect(),
    }
}

/// The frame that holds all of these, on the lines around them.
fn around(regions: &[&Region]) -> Frame {
    let mut frame = [f64::MAX, f64::MAX, 0.0, 0.0];
    for region in regions {
        let [l, t, r, b] = region.bounds.map(f64::from);
        frame = [frame[0].min(l), frame[1].min(t), frame[2].max(r), frame[3].max(b)];
    }
    [frame[0] - 0.5, frame[1] - 0.5, frame[2] + 0.5, frame[3] + 0.5]
}

fn symbol(kind: &str, [l, t, r, b]: Frame, angle: f64, score: f64) -> SheetSymbol {
    let area = Box2 {
        centre: [(l + r) / 2.0, (t + b) / 2.0],
        along: [1.0, 0.0],
        half: [(r - l) / 2.0, (b - t) / 2.0],
    };
    let level = angle.sin().abs() < 0.5;
    let half = if level { area.half } else { [area.half[1], area.half[0]] };
    SheetSymbol { angle, ..Box2 { half, ..area }.symbol(kind, score.clamp(0.0, 1.0)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const METRES: f64 = 0.0125;

    fn ink(inked: impl Fn(f64, f64) -> bool) -> Mask {
        let place = |i: u32| (f64::from(i % 120) + 0.5, f64::from(i / 120) + 0.5);
        let set = (0..120 * 100).map(|i| inked(place(i).0, place(i).1)).collect();
        Mask { width: 120, height: 100, set }
    }

    /// Whether a point is on an ellipse drawn in a line of two pixels.
    fn oval(x: f64, y: f64, [cx, cy]: Vec2, [a, b]: Vec2) -> bool {
        let inside = |by: f64| ((x - cx) / (a + by)).hypot((y - cy) / (b + by)) < 1.0;
        inside(1.0) && !inside(-1.0)
    }

    fn frame(x: f64, y: f64, [l, t, r, b]: Frame) -> bool {
        let inside = |by: f64| x > l - by && x < r + by && y > t - by && y < b + by;
        inside(1.0) && !inside(-1.0)
    }

    fn kinds(ink: &Mask) -> Vec<String> {
        let mut erase = Mask::empty(ink.width, ink.height);
        find(ink, METRES, &mut erase).into_iter().map(|s| s.kind).collect()
    }

    #[test]
    fn a_basin_at_a_wall_is_found_and_the_wall_stays() {
        let basin =
            |x: f64, y: f64| frame(x, y, [40.0, 30.0, 80.0, 65.0]) || oval(x, y, [60.0, 49.0], [14.0, 10.0]);
        let drawn = ink(|x, y| y < 30.0 && y > 15.0 || basin(x, y));
        let mut erase = Mask::empty(120, 100);
        let found = find(&drawn, METRES, &mut erase);
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].kind, "sink");
        assert!(super::super::plane::distance(found[0].centre, [60.0, 47.5]) < 2.0, "{found:?}");
        assert!(erase.get(60, 39) && !erase.get(60, 20));
    }

    #[test]
    fn a_toilet_is_found_by_its_tank_even_if_its_lines_have_gaps() {
        let toilet =
            |x: f64, y: f64| frame(x, y, [46.0, 20.0, 74.0, 34.0]) || oval(x, y, [60.0, 55.0], [13.0, 20.0]);
        assert_eq!(kinds(&ink(toilet)), ["toilet"]);
        assert_eq!(
            kinds(&ink(|x, y| toilet(x, y) && !(70.0..71.0).contains(&y) && x as u32 != 66)),
            ["toilet"]
        );
    }

    #[test]
    fn a_table_a_machine_and_a_number_in_a_circle_are_neither() {
        assert!(kinds(&ink(|x, y| oval(x, y, [60.0, 50.0], [18.0, 18.0]))).is_empty());
        let machine =
            |x: f64, y: f64| frame(x, y, [36.0, 26.0, 84.0, 74.0]) || oval(x, y, [60.0, 50.0], [18.0, 18.0]);
        assert!(kinds(&ink(machine)).is_empty());
        let number =
            |x: f64, y: f64| oval(x, y, [60.0, 50.0], [26.0, 26.0]) || oval(x, y, [60.0, 50.0], [12.0, 16.0]);
        assert!(kinds(&ink(number)).is_empty());
    }
}
