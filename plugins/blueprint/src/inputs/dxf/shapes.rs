//! Entities as lines.

use super::drawing::Entity;
use super::plane::{Map, Point, distance};
use super::splines::spline;
use std::f64::consts::TAU;

/// Chords of a full circle.
const CHORDS: f64 = 72.0;
/// The most points of one entity.
pub const MAX_POINTS: usize = 100_000;

/// A line of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    pub points: Vec<Point>,
    /// How wide it is drawn; mostly 0.
    pub width: f64,
    /// Whether its inside is filled.
    pub filled: bool,
}

impl Shape {
    fn line(points: Vec<Point>) -> Self {
        Self { points, width: 0.0, filled: false }
    }

    fn ring(mut points: Vec<Point>, filled: bool) -> Self {
        points.extend(points.first().copied());
        Self { points, width: 0.0, filled }
    }

    /// How thick what a closed line encloses is on the mean, as a bar is: its area over half its outline.
    pub fn thickness(&self) -> Option<f64> {
        let closed = self.points.len() > 3 && self.points.first() == self.points.last();
        let [x0, y0] = *self.points.first()?;
        // From the first point: far from the origin products lose their digits.
        let cross = |a: Point, b: Point| (a[0] - x0) * (b[1] - y0) - (a[1] - y0) * (b[0] - x0);
        let (mut double, mut outline) = (0.0, 0.0);
        for side in self.points.windows(2) {
            double += cross(side[0], side[1]);
            outline += distance(side[0], side[1]);
        }
        (closed && outline > 0.0).then(|| f64::abs(double) / outline)
    }

    /// The shape seen through a map.
    pub fn through(mut self, map: Map) -> Self {
        self.points.iter_mut().for_each(|p| *p = map.at(*p));
        self.width *= map.growth();
        self
    }
}

/// The lines of an entity, in the drawing's units; none of an entity that is no line.
pub fn shapes(entity: &Entity<'_>) -> Vec<Shape> {
    let shapes = match entity.kind {
        // Its ends lie in the world, whatever its plane.
        "LINE" => return two_ends(entity).into_iter().collect(),
        "ARC" => arc(entity).into_iter().collect(),
        "CIRCLE" => circle(entity).into_iter().collect(),
        "ELLIPSE" => return ellipse(entity).into_iter().collect(),
        "SPLINE" => return spline(entity).map(Shape::line).into_iter().collect(),
        "LWPOLYLINE" => light_polyline(entity),
        "POLYLINE" => heavy_polyline(entity),
        "SOLID" | "TRACE" => four_corners(entity, [10, 11, 13, 12], true),
        "3DFACE" => return four_corners(entity, [10, 11, 12, 13], false),
        "MLINE" => return parallel_lines(entity),
        "HATCH" => super::hatch::rings(entity)
            .into_iter()
            .map(|ring| Shape::ring(ring, entity.flags(70) != 0))
            .collect(),
        _ => vec![],
    };
    let map = if entity.is_mirrored() { Map::scale(-1.0, 1.0) } else { Map::SAME };
    shapes.into_iter().map(|s| s.through(map)).collect()
}

fn two_ends(entity: &Entity<'_>) -> Option<Shape> {
    Some(Shape::line(vec![entity.point(10)?, entity.point(11)?]))
}

fn arc(entity: &Entity<'_>) -> Option<Shape> {
    let (from, to) = (entity.number(50)?.to_radians(), entity.number(51)?.to_radians());
    Some(Shape::line(arc_points(entity.point(10)?, entity.number(40)?, from, (to - from).rem_euclid(TAU))))
}

fn circle(entity: &Entity<'_>) -> Option<Shape> {
    Some(Shape::line(arc_points(entity.point(10)?, entity.number(40)?, 0.0, TAU)))
}

/// Points on a circle from this angle on, over `sweep` radians.
pub fn arc_points(centre: Point, radius: f64, from: f64, sweep: f64) -> Vec<Point> {
    let steps = (sweep.abs() / TAU * CHORDS).ceil().clamp(1.0, CHORDS) as usize;
    let at = |i: usize| {
        let (sin, cos) = (from + sweep * i as f64 / steps as f64).sin_cos();
        [centre[0] + radius * cos, centre[1] + radius * sin]
    };
    (0..=steps).map(at).collect()
}

fn ellipse(entity: &Entity<'_>) -> Option<Shape> {
    let (major, ratio) = (entity.point(11)?, entity.number(40)?);
    let (from, to) = (entity.number(41).unwrap_or(0.0), entity.number(42).unwrap_or(TAU));
    let sweep = if (to - from).abs() >= TAU - 1e-9 { TAU } else { (to - from).rem_euclid(TAU) };
    let side = if entity.is_mirrored() { -ratio } else { ratio };
    let [e, f] = entity.point(10)?;
    let map = Map { a: major[0], b: major[1], c: -major[1] * side, d: major[0] * side, e, f };
    Some(Shape::line(arc_points([0.0; 2], 1.0, from, sweep)).through(map))
}

/// Corners with their bulges: tangents of a quarter of the arc to the next corner.
fn joined(corners: &[(Point, f64)], closed: bool) -> Vec<Point> {
    let Some(first) = corners.first() else { return vec![] };
    let mut points = vec![first.0];
    let next = corners.iter().skip(1).chain(closed.then_some(first));
    for ((from, bulge), (to, _)) in corners.iter().zip(next) {
        points.extend(bulged(*from, *to, *bulge));
    }
    points
}

/// The points after `from` on the way to `to`.
pub fn bulged(from: Point, to: Point, bulge: f64) -> Vec<Point> {
    let chord = distance(from, to);
    if bulge.abs() < 1e-6 || chord == 0.0 || !bulge.is_finite() {
        return vec![to];
    }
    let sweep = 4.0 * bulge.atan();
    // From the chord's middle to the circle's centre, to the left of the way.
    let offset = chord / 2.0 * (1.0 - bulge * bulge) / (2.0 * bulge);
    let [ux, uy] = [(to[0] - from[0]) / chord, (to[1] - from[1]) / chord];
    let centre = [(from[0] + to[0]) / 2.0 - uy * offset, (from[1] + to[1]) / 2.0 + ux * offset];
    let start = (from[1] - centre[1]).atan2(from[0] - centre[0]);
    arc_points(centre, distance(centre, from), start, sweep).split_off(1)
}

fn light_polyline(entity: &Entity<'_>) -> Vec<Shape> {
    let mut corners: Vec<(Point, f64)> = vec![];
    for pair in entity.pairs {
        let Some(value) = pair.number() else { continue };
        if pair.code == 10 && corners.len() < MAX_POINTS {
            corners.push(([value, 0.0], 0.0));
        }
        let Some(last) = corners.last_mut() else { continue };
        match pair.code {
            20 => last.0[1] = value,
            42 => last.1 = value,
            _ => {}
        }
    }
    let points = joined(&corners, entity.flags(70) & 1 != 0);
    vec![Shape { points, width: entity.number(43).unwrap_or(0.0).max(0.0), filled: false }]
}

fn heavy_polyline(entity: &Entity<'_>) -> Vec<Shape> {
    // Meshes have their corners in another order.
    if entity.flags(70) & (16 | 64) != 0 {
        return vec![];
    }
    // Corners of the frame that a curve was fitted to are not on it.
    let vertices = entity.parts().filter(|v| v.flags(70) & 16 == 0).take(MAX_POINTS);
    let corner = |v: Entity<'_>| Some((v.point(10)?, v.number(42).unwrap_or(0.0)));
    let corners: Vec<_> = vertices.filter_map(corner).collect();
    let points = joined(&corners, entity.flags(70) & 1 != 0);
    vec![Shape { points, width: entity.number(40).unwrap_or(0.0).max(0.0), filled: false }]
}

fn four_corners(entity: &Entity<'_>, order: [i32; 4], filled: bool) -> Vec<Shape> {
    let corners: Vec<_> = order.into_iter().filter_map(|code| entity.point(code)).collect();
    if corners.len() < 3 { vec![] } else { vec![Shape::ring(corners, filled)] }
}

/// Lines beside each other: at each corner a direction across, and how far out along it each line lies.
fn parallel_lines(entity: &Entity<'_>) -> Vec<Shape> {
    struct Corner {
        at: Point,
        across: Point,
        offsets: Vec<f64>,
    }
    let mut corners: Vec<Corner> = vec![];
    let mut is_offset = false;
    for pair in entity.pairs {
        let Some(value) = pair.number() else { continue };
        if pair.code == 11 && corners.len() < MAX_POINTS {
            corners.push(Corner { at: [value, 0.0], across: [0.0; 2], offsets: vec![] });
        }
        let Some(last) = corners.last_mut() else { continue };
        match pair.code {
            21 => last.at[1] = value,
            13 => last.across[0] = value,
            23 => last.across[1] = value,
            74 => is_offset = value > 0.0,
            41 if std::mem::take(&mut is_offset) => last.offsets.push(value),
            _ => {}
        }
    }
    let lines = corners.iter().map(|c| c.offsets.len()).min().unwrap_or_default().min(16);
    let closed = entity.flags(71) & 2 != 0;
    let line = |i: usize| {
        let at = |c: &Corner| [0, 1].map(|k| c.at[k] + c.across[k] * c.offsets[i]);
        let points: Vec<_> = corners.iter().map(at).collect();
        if closed { Shape::ring(points, false) } else { Shape::line(points) }
    };
    (0..lines).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::super::drawing::Drawing;
    use super::super::pairs::pairs;
    use super::*;

    fn of(entity: &str) -> Vec<Shape> {
        let text = format!("0\nSECTION\n2\nENTITIES\n{}\n0\nENDSEC\n", entity.replace(' ', "\n"));
        let pairs = pairs(&text).unwrap();
        Drawing::of(&pairs).entities.iter().flat_map(shapes).collect()
    }

    fn bounds(shapes: &[Shape]) -> [f64; 4] {
        let points = || shapes.iter().flat_map(|s| &s.points);
        let low = |i: usize| points().map(|p| p[i]).fold(f64::INFINITY, f64::min);
        let high = |i: usize| points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max);
        [low(0), low(1), high(0), high(1)].map(|v| (v * 1e6).round() / 1e6)
    }

    #[test]
    fn a_bulge_of_one_is_half_a_circle_to_the_right_of_the_way() {
        let shapes = of("0 LWPOLYLINE 70 0 10 0 20 0 42 1 10 2 20 0");
        assert_eq!(bounds(&shapes), [0.0, -1.0, 2.0, 0.0]);
        let heavy = of("0 POLYLINE 70 1 0 VERTEX 10 0 20 0 42 -1 0 VERTEX 10 2 20 0 0 SEQEND");
        assert_eq!(bounds(&heavy), [0.0, 0.0, 2.0, 1.0]);
        assert_eq!(heavy[0].points.first(), heavy[0].points.last());
    }

    #[test]
    fn arcs_run_counter_clockwise_and_mirrored_ones_to_the_left() {
        assert_eq!(bounds(&of("0 ARC 10 5 20 0 40 1 50 270 51 90")), [5.0, -1.0, 6.0, 1.0]);
        assert_eq!(bounds(&of("0 ARC 10 5 20 0 40 1 50 270 51 90 230 -1")), [-6.0, -1.0, -5.0, 1.0]);
        assert_eq!(bounds(&of("0 CIRCLE 10 0 20 0 40 2")), [-2.0, -2.0, 2.0, 2.0]);
        assert_eq!(
            bounds(&of("0 ELLIPSE 10 1 20 0 11 0 21 2 40 0.5 41 0 42 6.283185307179586")),
            [0.0, -2.0, 2.0, 2.0]
        );
    }

    #[test]
    fn other_lines_have_their_corners() {
        assert_eq!(of("0 SOLID 10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1")[0].points[2], [1.0, 1.0]);
        let mline = "0 MLINE 71 1 11 0 21 0 13 0 23 1 74 1 41 0.1 75 0 74 2 41 -0.1 41 0 75 0 11 4 21 0 13 0 23 1 74 1 41 0.1 \
                     74 1 41 -0.1";
        assert_eq!(bounds(&of(mline)), [0.0, -0.1, 4.0, 0.1]);
        assert_eq!(of(mline).len(), 2);
        assert!(of("0 LINE 10 0 20 0 11 nan 21 0").is_empty());
        assert!(of("0 POLYLINE 70 64 0 VERTEX 10 0 20 0").is_empty());
    }

    #[test]
    fn hatches_have_rings() {
        let ring = "0 HATCH 2 SOLID 70 1 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 4 20 0 10 4 20 3 97 0 75 0 98 1 10 9 20 9";
        assert_eq!((bounds(&of(ring)), of(ring)[0].filled), ([0.0, 0.0, 4.0, 3.0], true));
        let edges =
            "0 HATCH 70 0 91 1 92 1 93 2 72 1 10 0 20 0 11 2 21 0 72 2 10 1 20 0 40 1 50 0 51 180 73 1 97 0";
        assert_eq!(bounds(&of(edges)), [0.0, 0.0, 2.0, 1.0]);
    }

    #[test]
    fn splines_stay_in_their_frame() {
        let cubic =
            "0 SPLINE 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 0 20 4 10 4 20 4 10 4 20 0";
        assert_eq!(bounds(&of(cubic)), [0.0, 0.0, 4.0, 3.0]);
        assert_eq!(bounds(&of("0 SPLINE 71 3 11 0 21 0 11 1 21 1")), [0.0, 0.0, 1.0, 1.0]);
    }
}
