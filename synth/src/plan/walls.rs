//! Walls, in the style of the plan.

use super::drawing::Drawing;
use super::gaps::{Gap, Purpose};
use super::look::WallStyle;
use super::surface::{Pen, Surface, WHITE};
use crate::building::to_geo;
use crate::raster::band;
use geo::{BooleanOps, MultiPolygon, unary_union};
use planform_sdk::{Point, Polygon};

/// Draws the walls without their gaps.
pub(super) fn draw(drawing: &mut Drawing, gaps: &[Gap]) {
    let rings = rings(&body(drawing, gaps));
    let rings: Vec<&[Point]> = rings.iter().map(Vec::as_slice).collect();
    let outline = drawing.pen(drawing.look.outline);
    let layer = &mut drawing.walls;
    match drawing.look.wall {
        WallStyle::Solid(colour) => layer.fill(rings, colour),
        WallStyle::Filled(colour) => {
            layer.fill(rings.iter().copied(), colour);
            layer.rings(rings, outline);
        }
        WallStyle::Lines => {
            drawing.picture.fill(rings.iter().copied(), WHITE);
            layer.rings(rings, outline);
        }
        WallStyle::Hatched => {
            drawing.picture.fill(rings.iter().copied(), WHITE);
            let pitch = drawing.view.mm(drawing.rng.range((0.9, 1.6)));
            let hatching = Pen { width: drawing.view.mm(drawing.look.thin), ..outline };
            hatch(layer, &rings, pitch, hatching);
            layer.rings(rings, outline);
        }
    }
    drawing.picture.put(&drawing.walls);
}

/// All that walls, columns and short walls cover.
fn body(drawing: &Drawing, gaps: &[Gap]) -> MultiPolygon<f64> {
    let site = &drawing.site;
    let outer = site.layout.walls.iter().filter(|w| w.rooms.contains(&None));
    let bands = outer.map(|w| ring(&band(&w.line, w.thickness / 2.0, w.thickness / 2.0)));
    let whole: Vec<_> = bands.chain(site.layout.rooms.iter().map(|r| to_geo(&r.centre))).collect();
    let floors = site.layout.rooms.iter().map(|r| to_geo(&r.inner));
    let missing: Vec<_> = floors.chain(gaps.iter().map(|g| ring(&g.body()))).collect();
    let solids: Vec<_> = site.solids.iter().map(to_geo).collect();
    let walls = unary_union(&whole).difference(&unary_union(&missing));
    if solids.is_empty() { walls } else { walls.union(&unary_union(&solids)) }
}

fn ring(points: &[Point]) -> geo::Polygon<f64> {
    to_geo(&Polygon::new(points.to_vec(), vec![]))
}

fn rings(body: &MultiPolygon<f64>) -> Vec<Vec<Point>> {
    let all = body.iter().flat_map(|p| std::iter::once(p.exterior()).chain(p.interiors()));
    all.map(|r| r.coords().map(|c| Point::new(c.x, c.y)).collect()).collect()
}

/// Lines at 45 degrees within the rings.
fn hatch(layer: &mut Surface, rings: &[&[Point]], pitch: f64, pen: Pen) {
    let slope = std::f64::consts::FRAC_1_SQRT_2;
    let along = |p: &Point| (p.x + p.y) * slope;
    let across = |p: &Point| (p.y - p.x) * slope;
    let points = || rings.iter().copied().flatten();
    let (low, high) = points().map(across).fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
    for i in 1..((high - low) / pitch) as u32 {
        let level = low + f64::from(i) * pitch;
        let mut cuts = Vec::new();
        for ring in rings {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let (va, vb) = (across(a) - level, across(b) - level);
                if (va > 0.0) != (vb > 0.0) {
                    cuts.push(along(a) + (along(b) - along(a)) * va / (va - vb));
                }
            }
        }
        cuts.sort_by(f64::total_cmp);
        for cut in cuts.chunks_exact(2) {
            let at = |u: f64| Point::new((u - level) * slope, (u + level) * slope);
            layer.line(&[at(cut[0]), at(cut[1])], pen);
        }
    }
}

/// Draws the windows: two or three lines, and the jambs.
pub(super) fn windows(drawing: &mut Drawing, gaps: &[Gap]) {
    let (thin, lines) = (drawing.thin(), drawing.look.panes);
    let inset = drawing.rng.range((0.0, 0.3)) * f64::from(drawing.rng.int((0, 1)));
    for gap in gaps.iter().filter(|g| g.purpose == Purpose::Window) {
        let (width, half) = (gap.segment.length(), gap.depth / 2.0);
        drawing.picture.fill([gap.body().as_slice()], WHITE);
        for i in 0..lines {
            let v = half * (1.0 - inset) * (2.0 * f64::from(i) / f64::from(lines - 1) - 1.0);
            drawing.picture.line(&[gap.at(0.0, v), gap.at(width, v)], thin);
        }
        for u in [0.0, width] {
            drawing.picture.line(&[gap.at(u, -half), gap.at(u, half)], thin);
        }
        let opening = super::drawing::block(gap.segment.midpoint(), gap.axes().0, width, gap.depth);
        drawing.tell("window", &opening, vec![]);
    }
}
