//! The boundaries of hatches.

use super::drawing::Entity;
use super::pairs::Pair;
use super::plane::Point;
use super::shapes::{MAX_POINTS, arc_points, bulged};
use std::f64::consts::TAU;

/// A bit of group 92: the boundary is a polyline, not a row of edges.
const POLYLINE: i64 = 2;

/// The boundary of every area of a hatch, without the first point repeated.
pub fn rings(entity: &Entity<'_>) -> Vec<Vec<Point>> {
    let starts: Vec<_> = (0..entity.pairs.len()).filter(|&i| entity.pairs[i].code == 92).collect();
    let ends = starts.iter().skip(1).copied().chain([entity.pairs.len()]);
    starts.iter().zip(ends).map(|(&start, end)| ring(boundary(&entity.pairs[start..end]))).collect()
}

/// What follows the boundary belongs to the pattern, and has the same codes.
fn boundary<'a>(pairs: &'a [Pair<'a>]) -> &'a [Pair<'a>] {
    let end = pairs.iter().position(|p| matches!(p.code, 97 | 75)).unwrap_or(pairs.len());
    &pairs[..end]
}

fn ring(pairs: &[Pair<'_>]) -> Vec<Point> {
    let kind = pairs.first().and_then(Pair::number).unwrap_or(0.0) as i64;
    if kind & POLYLINE != 0 { polyline(pairs) } else { edges(pairs) }
}

fn polyline(pairs: &[Pair<'_>]) -> Vec<Point> {
    let mut points: Vec<Point> = vec![];
    let mut bulge = 0.0;
    let mut x = 0.0;
    for pair in pairs {
        match (pair.code, pair.number()) {
            (10, Some(value)) => x = value,
            (20, Some(y)) if points.len() < MAX_POINTS => match points.last() {
                Some(&last) => points.extend(bulged(last, [x, y], std::mem::take(&mut bulge))),
                None => points.push([x, y]),
            },
            (42, Some(value)) => bulge = value,
            _ => {}
        }
    }
    points
}

fn edges(pairs: &[Pair<'_>]) -> Vec<Point> {
    let starts: Vec<_> = (0..pairs.len()).filter(|&i| pairs[i].code == 72).collect();
    let ends = starts.iter().skip(1).copied().chain([pairs.len()]);
    let points = starts.iter().zip(ends).filter_map(|(&start, end)| edge(&pairs[start..end])).flatten();
    points.take(MAX_POINTS).collect()
}

fn edge(pairs: &[Pair<'_>]) -> Option<Vec<Point>> {
    let edge = Entity { kind: "", pairs, parts: &[] };
    match edge.flags(72) {
        1 => Some(vec![edge.point(10)?, edge.point(11)?]),
        2 => {
            let (from, to) = (edge.number(50)?.to_radians(), edge.number(51)?.to_radians());
            let sweep = if to - from >= TAU { TAU } else { (to - from).rem_euclid(TAU) };
            // Clockwise arcs give their angles clockwise.
            let side = if edge.flags(73) == 0 { -1.0 } else { 1.0 };
            Some(arc_points(edge.point(10)?, edge.number(40)?, side * from, side * sweep))
        }
        4 => super::splines::spline(&edge),
        _ => None,
    }
}
