//! What is known of the boundary between two regions, as numbers: whether the passage is narrow for either of them,
//! whether walls stand in line with it, and what shape the two would make together.

use super::passage::Passage;
use super::regions::{Region, Regions};

/// How many numbers there are.
pub const COUNT: usize = 23;

/// The evidence of a boundary, in the order of [`NAMES`].
pub type Evidence = [f64; COUNT];

/// What each number is. "Smaller" and "larger" are the two regions by area; lengths in metres, areas in square
/// metres.
pub const NAMES: [&str; COUNT] = [
    "log of the passages' total width",
    "passage's clearance over the smaller region's largest",
    "passage's clearance over the larger region's largest",
    "wall in line with the passage at the end with less",
    "wall in line with the passage at the end with more",
    "wall's share of that wall and the passage",
    "free space around the end with less",
    "free space around the end with more",
    "wall's share of the whole boundary",
    "boundary's length over the passage's width",
    "passage's width over the smaller region's extent along it",
    "passage's width over the larger region's extent along it",
    "solidity of the two together",
    "solidity of the smaller region",
    "solidity of the larger region",
    "solidity lost",
    "log of the smaller region's elongation",
    "log of the larger region's elongation",
    "passage's half width over the clearance around it",
    "passage's clearance over the clearance around it",
    "depth's share of depth and width",
    "sharpness of the passage's ends",
    "smallness of the smaller region",
];

/// The evidence on the boundary between two regions, if they meet.
pub fn weigh(regions: &mut Regions<'_>, a: u32, b: u32) -> Option<Evidence> {
    let passages = regions.passages(a, b);
    let total: f64 = passages.iter().map(|p| p.gap).sum();
    let widest = widest(passages)?.clone();
    let wall = regions.wall(a, b);
    let resolution = regions.resolution();
    let (a, b) = (regions.get(a)?, regions.get(b)?);
    let (small, large) = if a.area > b.area { (b, a) } else { (a, b) };
    Some(numbers(&widest, total, wall, small, large, resolution))
}

/// The widest passage; of equal ones the first.
pub fn widest(passages: &[Passage]) -> Option<&Passage> {
    passages.iter().rev().max_by(|p, q| p.gap.total_cmp(&q.gap))
}

fn numbers(p: &Passage, total: f64, wall: f64, small: &Region, large: &Region, resolution: f64) -> Evidence {
    let union = small.hull.join(&large.hull).area() * resolution * resolution;
    let together = (small.area + large.area) / union;
    let (own, other) = (small.area / small.hull_area, large.area / large.hull_area);
    let extent = |r: &Region| (p.gap / (r.hull.extent(p.angle) * resolution).max(0.1)).min(1.5);
    let elongation = |r: &Region| log(r.area / (4.0 * r.clearance * r.clearance + 1e-3));
    let beyond = p.wall[0] + p.wall[1];
    [
        log(total),
        p.saddle / small.clearance.max(0.05),
        p.saddle / large.clearance.max(0.05),
        p.wall[0],
        p.wall[1],
        beyond / (beyond + p.gap),
        p.tip[0],
        p.tip[1],
        wall / (wall + total),
        p.length / p.gap.max(0.1),
        extent(small),
        extent(large),
        together,
        own,
        other,
        together - own.min(other),
        elongation(small),
        elongation(large),
        (0.5 * p.gap / p.wide.max(0.05)).min(1.5),
        (p.saddle / p.wide.max(0.05)).min(1.2),
        p.depth / (p.depth + p.gap),
        (0.6 - p.tip[1]).max(0.0),
        (-small.area / 2.0).exp(),
    ]
}

/// Natural logarithm of a number of at least 0.02.
fn log(v: f64) -> f64 {
    v.max(0.02).ln()
}
