//! The pose at which a sweep's echoes lie on the surfaces of a submap, to a fraction of a cell: least squares of the
//! distances from points to lines (Censi, "An ICP variant using a point-to-line metric", ICRA 2008), held by what was
//! expected where the surfaces leave a direction open.

use super::submap::{Submap, Turn};
use super::sweep::{Sweep, Vector};
use crate::log::Pose;
use nalgebra::{Matrix3, Vector3};

/// The most steps.
const STEPS: usize = 20;

/// Steps smaller than this end the work: metres and radians.
const DONE: f64 = 1e-5;

/// Standard deviation of an echo's distance from its surface, metres.
const DEVIATION: f64 = 0.05;

/// Beams of one scan err together: their number counts only in this part.
const INDEPENDENT: f64 = 0.1;

/// How much a point counts that is on no surface, as it holds in both directions.
const LONE: f64 = 0.2;

/// Points farther from their surface than this do not count, metres: at the start and at the end of the steps.
const FARTHEST: (f64, f64) = (0.3, 0.12);

/// A pose that fits.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// Where the sweep was taken, in the submap's frame.
    pub pose: Pose,
    /// How sure that is, the inverse of the covariance of (x, y, heading) in the laser's frame: 1/m^2, 1/rad^2.
    pub information: Matrix3<f64>,
    /// The share of the points that lie on a surface.
    pub inliers: f64,
}

/// Refines a pose; `expected` and `prior` are the pose from elsewhere and the inverse of its covariance in the laser's
/// frame.
pub fn align(submap: &Submap, sweep: &Sweep, start: Pose, expected: Pose, prior: &Matrix3<f64>) -> Fit {
    let mut pose = start;
    for i in 0..STEPS {
        let share = (i as f64 / 8.0).min(1.0);
        let farthest = FARTHEST.0 + share * (FARTHEST.1 - FARTHEST.0);
        let equations = Equations::of(submap, sweep, pose, farthest).held(pose, expected, prior);
        let Some(step) = equations.solve() else { break };
        pose = pose.then(step);
        if share >= 1.0 && step.x.abs().max(step.y.abs()).max(step.theta.abs()) < DONE {
            break;
        }
    }
    let seen = Equations::of(submap, sweep, pose, FARTHEST.1);
    let inliers = seen.count / (sweep.points.len().max(1) as f64);
    Fit { pose, information: seen.matrix + prior, inliers }
}

/// The normal equations of a step in the laser's frame.
struct Equations {
    matrix: Matrix3<f64>,
    right: Vector3<f64>,
    count: f64,
}

impl Equations {
    fn of(submap: &Submap, sweep: &Sweep, pose: Pose, farthest: f64) -> Self {
        let turn = Turn::of(pose);
        let mut equations = Self { matrix: Matrix3::zeros(), right: Vector3::zeros(), count: 0.0 };
        for point in &sweep.points {
            let place = turn.place(*point);
            let Some((nearest, normal)) = submap.nearest(place) else { continue };
            let off = [place[0] - nearest[0], place[1] - nearest[1]];
            match normal {
                Some(normal) => equations.add(turn, *point, off, normal, (1.0, 1.0), farthest),
                None => {
                    for axis in [[1.0, 0.0], [0.0, 1.0]] {
                        equations.add(turn, *point, off, axis, (LONE, 0.5), farthest);
                    }
                }
            }
        }
        equations
    }

    /// One distance along a normal, with Tukey's weight and what it counts besides: as information, and as a point.
    fn add(
        &mut self,
        turn: Turn,
        point: Vector,
        off: Vector,
        normal: Vector,
        (weight, count): (f64, f64),
        farthest: f64,
    ) {
        let residual = off[0] * normal[0] + off[1] * normal[1];
        let share = residual / farthest;
        if share.abs() >= 1.0 {
            return;
        }
        let (ahead, left) = (turn.direct([1.0, 0.0]), turn.direct([0.0, 1.0]));
        let swung = turn.direct([-point[1], point[0]]);
        let along = |v: Vector| v[0] * normal[0] + v[1] * normal[1];
        let slope = Vector3::new(along(ahead), along(left), along(swung));
        let tukey = (1.0 - share * share).powi(2);
        let weight = weight * tukey * INDEPENDENT / (DEVIATION * DEVIATION);
        self.matrix += weight * slope * slope.transpose();
        self.right -= weight * residual * slope;
        self.count += count;
    }

    /// With what is expected.
    fn held(self, pose: Pose, expected: Pose, prior: &Matrix3<f64>) -> Self {
        let to = pose.to(expected);
        let off = Vector3::new(to.x, to.y, pose.turn(expected));
        Self { matrix: self.matrix + prior, right: self.right + prior * off, count: self.count }
    }

    fn solve(self) -> Option<Pose> {
        let step = self.matrix.cholesky()?.solve(&self.right);
        step.iter().all(|v| v.is_finite()).then(|| Pose { x: step.x, y: step.y, theta: step.z })
    }
}
