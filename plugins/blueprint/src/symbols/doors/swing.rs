//! One leaf and the arc it draws.

use crate::symbols::plane::{Plane, Vec2, direction, distance, dot, moved, unit};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A leaf that swings, in pixels of a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Where it turns.
    pub hinge: Vec2,
    /// Its length.
    pub radius: f64,
    /// The direction in which it is closed, along the wall.
    pub along: Vec2,
    /// The direction in which it stands open as drawn.
    pub into: Vec2,
    /// From 0 to 1.
    pub score: f64,
    /// How much speaks for a jamb at its closed end, 0 to 1; a leaf of two has none.
    pub jamb: f64,
}

impl Swing {
    /// Its free end when closed.
    pub fn closed(&self) -> Vec2 {
        moved(self.hinge, self.along, self.radius)
    }

    /// Its free end as drawn.
    pub fn open(&self) -> Vec2 {
        moved(self.hinge, self.into, self.radius)
    }

    /// The unit vector across the wall, to the side it opens to.
    pub fn across(&self) -> Vec2 {
        let normal = [-self.along[1], self.along[0]];
        if dot(normal, self.into) >= 0.0 { normal } else { [-normal[0], -normal[1]] }
    }

    fn middle(&self) -> Vec2 {
        let both = [self.along[0] + self.into[0], self.along[1] + self.into[1]];
        moved(self.hinge, direction([0.0; 2], both).0, self.radius / 2.0)
    }

    /// Whether both sweep the same floor.
    pub fn is_over(&self, other: &Self) -> bool {
        distance(self.middle(), other.middle()) < 0.55 * self.radius.max(other.radius)
    }

    /// Whether most of the open leaf runs along the arc that another leaf draws.
    pub fn leaf_is_on_arc(&self, other: &Self) -> bool {
        let steps = 10;
        let on_arc = |k: i32| {
            let p = moved(self.hinge, self.into, self.radius * f64::from(k) / f64::from(steps));
            let from = [p[0] - other.hinge[0], p[1] - other.hinge[1]];
            let between = dot(from, other.along).min(dot(from, other.across())) > -ALONG_ARC * other.radius;
            between && (distance(p, other.hinge) - other.radius).abs() <= ALONG_ARC * other.radius
        };
        (0..=steps).filter(|&k| on_arc(k)).count() * 2 > steps as usize
    }
}

/// A line this near to an arc, as a share of its radius, runs along it.
const ALONG_ARC: f64 = 0.1;

/// How much of an arc must be drawn without a gap, and how much if dashes or crossing strokes break it.
const LEAST_WHOLE: f64 = 0.86;
const LEAST_DASHED: f64 = 0.6;
/// A door's arc turns by about a quarter; by less where the leaf is drawn half open.
const SPANS: [f64; 2] = [0.7, 2.0];
/// An arc leaves the straight line between its ends by so much at least, pixels; less may be a corner cut off.
const LEAST_BULGE: f64 = 2.2;
/// Arcs that turn by less, radians, are of leaves drawn half open, and have to be rounder: straight lines are many.
const FULLY_OPEN: f64 = 1.15;
/// The floor that a leaf sweeps is free but for this share.
const MOST_IN_SWEEP: f64 = 0.1;
/// Ends of an arc this near to an upright direction, radians, are meant to be upright.
const UPRIGHT: f64 = 0.14;
/// An arc that turns by a quarter but for this angle, radians, was meant to.
const NEARLY_QUARTER: f64 = 0.5;
/// Less than this is chance.
const LEAST_SCORE: f64 = 0.55;

/// The door whose arc runs through this circle (at this point of it, if it is known), if it is one.
pub fn of_arc(
    plane: &Plane,
    centre: Vec2,
    radius: f64,
    through: Option<Vec2>,
    radii: [f64; 2],
) -> Option<Swing> {
    let (centre, radius) = refined(plane, centre, radius, through);
    if !(radii[0]..=radii[1]).contains(&radius) {
        return None;
    }
    let ring = Ring::of(plane, centre, radius);
    let (from, span) = ring.run(through.map(|p| angle(centre, p)), 0.12)?;
    let bulge = radius * (1.0 - (span / 2.0).cos());
    let least = if span < FULLY_OPEN { 2.0 * LEAST_BULGE } else { LEAST_BULGE };
    let is_arc = (SPANS[0]..=SPANS[1]).contains(&span) && bulge >= least;
    if !is_arc || ring.drawn(from + 0.1 * span, 0.8 * span) < LEAST_WHOLE {
        return None;
    }
    let arc = ring.drawn(from + 0.1 * span, 0.8 * span);
    let all = ends(from, span).map(|ends| candidate(plane, centre, radius, ends, arc));
    all.into_iter().filter(|s| s.score >= LEAST_SCORE).max_by(|a, b| a.score.total_cmp(&b.score))
}

/// Where the leaf may be closed and where open. An arc that stops short of the wall, or runs into it, was meant to turn by
/// a quarter from either end.
fn ends(from: f64, span: f64) -> [[f64; 2]; 6] {
    let (a, b) = (upright(from), upright(from + span));
    let quarter = (span - FRAC_PI_2).abs() < NEARLY_QUARTER;
    let (c, d) = if quarter { (b - FRAC_PI_2, a + FRAC_PI_2) } else { (a, b) };
    [[a, b], [b, a], [a, d], [d, a], [c, b], [b, c]]
}

/// The door whose open leaf is this line, if it is one. Its arc may be dashed; the leaf begins at the wall's face, and its
/// hinge may lie in the wall.
pub fn of_leaf(plane: &Plane, hinge: Vec2, open: Vec2, radii: [f64; 2]) -> Option<Swing> {
    let (into, length) = direction(hinge, open);
    let mut best: Option<Swing> = None;
    for back in [0.0, 1.0, 2.5, 4.0] {
        let (hinge, radius) = (moved(hinge, into, -back), length + back);
        if !(radii[0]..=radii[1]).contains(&radius) {
            continue;
        }
        let ring = Ring::of(plane, hinge, radius);
        let start = angle(hinge, open);
        for side in [-1.0, 1.0] {
            let from = if side > 0.0 { start } else { start - FRAC_PI_2 };
            let arc = ring.drawn(from, FRAC_PI_2);
            if arc < LEAST_DASHED || ring.drawn(from + FRAC_PI_2, TAU - FRAC_PI_2) > 0.45 {
                continue;
            }
            let found =
                candidate(plane, hinge, radius, [upright(start + side * FRAC_PI_2), upright(start)], arc);
            if found.score >= LEAST_SCORE && best.is_none_or(|b| found.score > b.score) {
                best = Some(found);
            }
        }
    }
    best
}

fn angle(from: Vec2, to: Vec2) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// The angle, or the upright one that it is meant to be.
fn upright(angle: f64) -> f64 {
    let nearest = (angle / FRAC_PI_2).round() * FRAC_PI_2;
    if (angle - nearest).abs() < UPRIGHT { nearest } else { angle }
}

/// The circle moved and resized by little steps to where most of the arc is drawn.
fn refined(plane: &Plane, centre: Vec2, radius: f64, through: Option<Vec2>) -> (Vec2, f64) {
    let Some(through) = through else { return (centre, radius) };
    let middle = angle(centre, through);
    let drawn = |c: Vec2, r: f64| {
        let n = (radius * 1.7).ceil() as i32;
        let at = |i: i32| {
            let out = unit(middle + 0.85 * f64::from(i) / f64::from(n));
            [0.0, 1.0, -1.0].map(|d| plane.at(moved(c, out, r + d)))
        };
        // The stroke's middle counts for more than its sides.
        (-n..=n)
            .map(at)
            .map(|[on, out, back]| 2 * u32::from(on) + u32::from(out) + u32::from(back))
            .sum::<u32>()
    };
    let mut best = (centre, radius, drawn(centre, radius));
    for step in [2.0, 1.0, 0.5] {
        for _ in 0..3 {
            let (c, r, before) = best;
            // An arc hardly tells a circle from a larger one further away: these two moves go together.
            let away = unit(middle).map(|v| -v);
            let moves = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [away[0], away[1], 1.0]];
            for ([dx, dy, dr], d) in moves.into_iter().flat_map(|m| [(m, step), (m, -step)]) {
                let (c, r) = ([c[0] + dx * d, c[1] + dy * d], r + dr * d);
                let count = drawn(c, r);
                if count > best.2 {
                    best = (c, r, count);
                }
            }
            if best.2 == before {
                break;
            }
        }
    }
    (best.0, best.1)
}

/// What is drawn around a circle.
struct Ring {
    /// For every step: ink on the circle, and none close by on either side.
    drawn: Vec<bool>,
    /// The same, but on one side there may be: a wall, or the arc of the other leaf.
    touched: Vec<bool>,
}

impl Ring {
    fn of(plane: &Plane, centre: Vec2, radius: f64) -> Self {
        let steps = (TAU * radius).ceil() as usize;
        // A stroke of a few pixels may be there; beyond, on one side at least, is paper.
        let clear = 3.0 + 0.06 * radius;
        let sides = |i: usize| {
            let out = unit(TAU * i as f64 / steps as f64);
            let at = |d: f64| plane.at(moved(centre, out, radius + d));
            let inked = u32::from(at(clear)) + u32::from(at(-clear));
            (at(0.0) || at(-1.0) || at(1.0)).then_some(inked)
        };
        let sides: Vec<Option<u32>> = (0..steps).map(sides).collect();
        let upto = |most: u32| sides.iter().map(|s| s.is_some_and(|n| n <= most)).collect();
        Self { drawn: upto(0), touched: upto(1) }
    }

    fn index(&self, angle: f64) -> usize {
        let n = self.drawn.len();
        ((angle.rem_euclid(TAU) / TAU * n as f64) as usize).min(n - 1)
    }

    /// The share of a part that is drawn.
    fn drawn(&self, from: f64, span: f64) -> f64 {
        let n = self.drawn.len();
        let steps = ((span / TAU * n as f64).round() as usize).max(1);
        let start = self.index(from);
        (0..steps).filter(|k| self.drawn[(start + k) % n]).count() as f64 / steps as f64
    }

    /// Where the run around this angle begins, and how far it turns; gaps up to `gap` radians are bridged.
    fn run(&self, around: Option<f64>, gap: f64) -> Option<(f64, f64)> {
        let n = self.drawn.len();
        let gap = (gap / TAU * n as f64).ceil() as usize + 1;
        let start = self.index(around?);
        let start = (0..gap).map(|k| (start + k) % n).find(|&k| self.drawn[k])?;
        let reach = |step: usize| {
            let mut last = 0;
            let mut k = 1;
            while k < n && k - last <= gap {
                if self.drawn[(start + k * step) % n] {
                    last = k;
                }
                k += 1;
            }
            let most = last + n / 18;
            (last + 1..=most).find(|k| !self.touched[(start + k * step) % n]).map_or(most, |k| k - 1)
        };
        let (ahead, back) = (reach(1), reach(n - 1));
        let to_angle = |k: usize| TAU * k as f64 / n as f64;
        Some((to_angle(start) - to_angle(back), to_angle(ahead + back)))
    }
}

/// The door that closes at the first of the two angles and stands open at the second one, with its score.
fn candidate(plane: &Plane, hinge: Vec2, radius: f64, [closed, open]: [f64; 2], arc: f64) -> Swing {
    let (along, into) = (unit(closed), unit(open));
    let mut swing = Swing { hinge, radius, along, into, score: 0.0, jamb: 0.0 };
    let across = swing.across();
    let [back, down] = [[-along[0], -along[1]], [-across[0], -across[1]]];
    let hold = goes_on(plane, hinge, back, radius).max(goes_on(plane, hinge, down, radius));
    swing.jamb =
        goes_on(plane, swing.closed(), along, radius).max(goes_on(plane, swing.closed(), down, radius));
    let leaf = leaf(plane, &swing);
    let free = 1.0 - goes_on(plane, swing.open(), into, radius);
    let opening = 1.0 - in_the_way(plane, &swing);
    let span = (closed - open).abs();
    // How near to a right angle the leaf stands open; leaves drawn half open must be drawn themselves.
    let right = 1.0 - ((span - FRAC_PI_2).abs() / FRAC_PI_2).min(1.0);
    let leaf = if right > 0.8 { 0.35 + 0.65 * leaf } else { leaf };
    if in_sweep(plane, &swing, span) > MOST_IN_SWEEP {
        return swing;
    }
    swing.score =
        hold * (0.45 + 0.55 * swing.jamb) * leaf * arc * (0.4 + 0.6 * free) * opening * (0.2 + 0.8 * right);
    swing.score = swing.score.clamp(0.0, 1.0).powf(0.5);
    swing
}

/// How much a wall goes on from a point in a direction, from 0 to 1.
fn goes_on(plane: &Plane, from: Vec2, along: Vec2, radius: f64) -> f64 {
    let reach = (0.08 * radius).max(1.5);
    let (start, end) = (moved(from, along, 0.06 * radius), moved(from, along, 0.26 * radius));
    (plane.covered(start, end, reach) * 1.25).min(1.0)
}

/// How much of the open leaf is drawn: a line, or either side of a narrow box.
fn leaf(plane: &Plane, swing: &Swing) -> f64 {
    let r = swing.radius;
    let beside = |by: f64| {
        let shift = |p: Vec2| moved(p, swing.along, by);
        let (from, to) = (moved(swing.hinge, swing.into, 0.12 * r), moved(swing.hinge, swing.into, 0.94 * r));
        plane.covered(shift(from), shift(to), 1.0)
    };
    [-1.5, 0.0, 1.5, 3.0].map(beside).into_iter().fold(0.0, f64::max)
}

/// The share of the swept floor that is inked, well inside of leaf, wall and arc.
fn in_sweep(plane: &Plane, swing: &Swing, span: f64) -> f64 {
    let (across, r) = (swing.across(), swing.radius);
    let steps = (r * 0.7).ceil() as u32;
    let at = |i: u32, from: f64, to: f64| from + (to - from) * f64::from(i) / f64::from(steps);
    let place = |i: u32, k: u32| {
        let (angle, out) = (at(i, 0.2, 0.8) * span, at(k, 0.3, 0.85) * r);
        let side = moved(swing.hinge, swing.along, out * angle.cos());
        moved(side, across, out * angle.sin())
    };
    let places = (0..=steps).flat_map(|i| (0..=steps).map(move |k| (i, k)));
    let inked = places.filter(|&(i, k)| plane.at(place(i, k))).count();
    inked as f64 / f64::from((steps + 1) * (steps + 1))
}

/// How much thick ink stands in the opening; thin lines may, as thresholds.
fn in_the_way(plane: &Plane, swing: &Swing) -> f64 {
    let across = swing.across();
    let thick = (0.08 * swing.radius).max(2.0);
    let at = |t: f64| moved(swing.hinge, swing.along, t * swing.radius);
    let steps = (swing.radius * 0.6).ceil() as u32;
    let blocked = |i: u32| {
        let p = at(0.2 + 0.6 * f64::from(i) / f64::from(steps));
        let inked = (-4..=4).filter(|&k| plane.at(moved(p, across, f64::from(k) / 4.0 * thick))).count();
        inked >= 7
    };
    f64::from((0..=steps).filter(|&i| blocked(i)).count() as u32) / f64::from(steps + 1)
}
