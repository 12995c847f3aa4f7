//! The points that a scan's echoes are, with the directions of the surfaces that they lie on.

use crate::log::{Pose, Scan};

/// A point or a direction in the plane, metres.
pub type Vector = [f64; 2];

/// How far to either side along the sweep the neighbours lie that tell a surface's direction, beams.
const NEIGHBOURS: usize = 2;

/// The widest gap between neighbours on one surface: metres, and its growth with the range, for beams fan out.
const GAP: (f64, f64) = (0.15, 0.06);

/// The farthest that a neighbour may lie off a surface's line, metres.
const FLATNESS: f64 = 0.05;

/// The most points of a scan that are used; of more, each second, third, and so on.
const MOST: usize = 720;

/// The echoes of one scan in the laser's frame.
#[derive(Clone, Debug, Default)]
pub struct Sweep {
    /// Where the echoes are.
    pub points: Vec<Vector>,
    /// The unit normal of the surface at each point, if there is one.
    pub normals: Vec<Option<Vector>>,
}

impl Sweep {
    /// The echoes nearer than `reach` metres.
    pub fn of(scan: &Scan, reach: f64) -> Self {
        let echoes = scan.beams().filter(|(_, range)| scan.is_echo(*range) && f64::from(*range) <= reach);
        let points: Vec<Vector> = echoes
            .map(|(angle, range)| [f64::from(range) * angle.cos(), f64::from(range) * angle.sin()])
            .filter(|p| p[0].is_finite() && p[1].is_finite())
            .collect();
        let every = points.len().div_ceil(MOST).max(1);
        let normals = (0..points.len()).step_by(every).map(|i| normal(&points, i)).collect();
        Self { points: points.into_iter().step_by(every).collect(), normals }
    }
}

/// Whether all of a pose are numbers.
pub fn finite(pose: Pose) -> bool {
    pose.x.is_finite() && pose.y.is_finite() && pose.theta.is_finite()
}

/// The normal of the line through the neighbours of a point, if they lie close together and on a line.
fn normal(points: &[Vector], i: usize) -> Option<Vector> {
    let range = points[i][0].hypot(points[i][1]);
    let widest = GAP.0 + GAP.1 * range;
    let near =
        |a: usize, b: usize| (points[a][0] - points[b][0]).hypot(points[a][1] - points[b][1]) <= widest;
    let back = (1..=NEIGHBOURS.min(i)).take_while(|d| near(i - d, i - d + 1)).count();
    let on = (1..=NEIGHBOURS.min(points.len() - 1 - i)).take_while(|d| near(i + d, i + d - 1)).count();
    if back + on < 2 { None } else { line_normal(&points[i - back..=i + on]) }
}

/// The normal of the line that fits the points best, unless one is too far off it.
fn line_normal(points: &[Vector]) -> Option<Vector> {
    let n = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let moment = |f: &dyn Fn(f64, f64) -> f64| points.iter().map(|p| f(p[0] - x, p[1] - y)).sum::<f64>();
    let (xx, xy, yy) = (moment(&|x, _| x * x), moment(&|x, y| x * y), moment(&|_, y| y * y));
    let along = 0.5 * (2.0 * xy).atan2(xx - yy);
    let normal = [-along.sin(), along.cos()];
    let off = |p: &Vector| ((p[0] - x) * normal[0] + (p[1] - y) * normal[1]).abs();
    points.iter().all(|p| off(p) <= FLATNESS).then_some(normal)
}
