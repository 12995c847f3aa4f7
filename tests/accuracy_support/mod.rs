//! How much two layouts agree, on exact polygons.
// Every test program has its own copy of this module and uses a part of it.
#![allow(dead_code)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

pub mod states;

use geo::{Area, BooleanOps, BoundingRect, Intersects, LineString};
use planform::evaluate::RoomShape;
use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{Grid, Layout, Point, Polygon, Provenance, Room, Scene};
use planform_synth::parallel_map;

/// The layout of a grid, with default parameters.
pub fn layout_of(grid: Grid) -> Layout {
    reconstruct(&Scene::of_grid(grid, Provenance::default()), &Params::default(), &mut ()).unwrap()
}

/// The same polygon in the types of the crate `geo`.
pub fn to_geo(polygon: &Polygon) -> geo::Polygon<f64> {
    let ring = |r: &[Point]| LineString::from_iter(r.iter().map(|p| (p.x, p.y)));
    geo::Polygon::new(ring(&polygon.exterior), polygon.holes.iter().map(|h| ring(h)).collect())
}

/// The area that two polygons share, square metres.
pub fn shared(a: &geo::Polygon<f64>, b: &geo::Polygon<f64>) -> f64 {
    let boxes = a.bounding_rect().zip(b.bounding_rect());
    if boxes.is_some_and(|(a, b)| a.intersects(&b)) { a.intersection(b).unsigned_area() } else { 0.0 }
}

/// The outlines of all rooms along the centres of their walls.
pub fn centres(layout: &Layout) -> Vec<geo::Polygon<f64>> {
    layout.rooms.iter().map(|r| to_geo(&r.centre)).collect()
}

/// The same outlines for `planform::evaluate`, named by the rooms' ids.
pub fn shapes(layout: &Layout) -> Vec<RoomShape> {
    let shape = |r: &Room| RoomShape { name: r.id.to_string(), parts: vec![r.centre.clone()] };
    layout.rooms.iter().map(shape).collect()
}

/// The share of `these` polygons' area that lies in the one of `those` which it has most in common with. With the
/// found rooms and the true ones that is the paper's forward coverage A_FC, the other way round the backward one A_BC.
pub fn coverage(these: &[geo::Polygon<f64>], those: &[geo::Polygon<f64>]) -> f64 {
    let best = |a| those.iter().map(|b| shared(a, b)).fold(0.0, f64::max);
    let (common, all): (f64, f64) =
        these.iter().fold((0.0, 0.0), |(c, t), p| (c + best(p), t + p.unsigned_area()));
    if all > 0.0 { common / all } else { 0.0 }
}

/// Calls `work` for every seed, on all processors; the results in the seeds' order.
pub fn for_seeds<T: Send>(seeds: impl IntoIterator<Item = u64>, work: impl Fn(u64) -> T + Sync) -> Vec<T> {
    let seeds: Vec<u64> = seeds.into_iter().collect();
    parallel_map(&seeds, |&seed| work(seed))
}
