//! A graph of poses and of steps measured between them, and the poses that fit the steps best: Levenberg-Marquardt, with
//! steps that close loops scaled down where they contradict the rest (dynamic covariance scaling: Agarwal et al., "Robust
//! map optimization using dynamic covariance scaling", ICRA 2013).

use super::eliminate::System;
use super::sweep::finite;
use crate::log::Pose;
use nalgebra::{Matrix3, Vector3};

/// The most rounds.
const ROUNDS: usize = 30;

/// Rounds that better the sum of squares by less than this share end the work.
const ENOUGH: f64 = 1e-4;

/// The damping at first, as a share of the diagonal.
const DAMPING: f64 = 1e-6;

/// A damping at which no step is left.
const STUCK: f64 = 1e6;

/// Loops begin to count less from this squared error on, in units of their variance.
const PHI: f64 = 10.0;

/// Loops with a squared error of this much are wrong.
const WRONG: f64 = 100.0;

/// How many times as much error is believed at first, then and in the end.
const GRADES: [f64; 4] = [1e6, 1e3, 30.0, 1.0];

/// A step measured between two poses.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The pose that the step begins at.
    pub from: usize,
    /// The pose that it leads to.
    pub to: usize,
    /// The second pose as seen from the first.
    pub step: Pose,
    /// The inverse of its covariance, in the frame of the second pose: 1/m^2, 1/rad^2.
    pub information: Matrix3<f64>,
    /// Whether it closes a loop, and may be wrong.
    pub closes: bool,
}

/// Poses and the steps between them. The first pose stays where it is.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// The poses.
    pub poses: Vec<Pose>,
    /// The steps; their ends are poses.
    pub edges: Vec<Edge>,
}

impl Edge {
    /// The error: the pose that the step leads to, as seen from where it should.
    fn error(&self, poses: &[Pose]) -> Vector3<f64> {
        let found = poses[self.from].to(poses[self.to]);
        let off = self.step.to(found);
        Vector3::new(off.x, off.y, self.step.turn(found))
    }

    /// The squared error in units of its variance.
    pub fn chi2(&self, poses: &[Pose]) -> f64 {
        let error = self.error(poses);
        error.dot(&(self.information * error))
    }

    /// How much of its information counts, when loops are doubted from the squared error `phi` on.
    fn trust(&self, chi2: f64, phi: f64) -> f64 {
        if self.closes { (2.0 * phi / (phi + chi2)).min(1.0).powi(2) } else { 1.0 }
    }

    /// What the error costs, so that its slope agrees with the trust.
    fn cost(&self, chi2: f64, phi: f64) -> f64 {
        let trust = self.trust(chi2, phi);
        trust * chi2 + phi * (1.0 - trust.sqrt()).powi(2)
    }

    /// The slopes of the error with the steps of both poses in their own frames.
    fn slopes(&self, poses: &[Pose]) -> (Matrix3<f64>, Matrix3<f64>) {
        let found = poses[self.from].to(poses[self.to]);
        let back = turned(-self.step.theta);
        let mut swing = Matrix3::identity();
        (swing[(0, 2)], swing[(1, 2)]) = (-found.y, found.x);
        (-(back * swing), back * turned(found.theta))
    }
}

/// A turn of the plane that leaves headings alone.
fn turned(angle: f64) -> Matrix3<f64> {
    let (sin, cos) = angle.sin_cos();
    Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0)
}

impl Graph {
    /// Moves the poses to where they fit the steps best. With new loops the poses may be far from there, so that right
    /// loops look wrong: doubt comes by and by.
    pub fn optimise(&mut self, new_loops: bool) {
        let first = if new_loops { 0 } else { GRADES.len() - 1 };
        for grade in &GRADES[first..] {
            self.settle(PHI * grade);
        }
    }

    /// Forgets the loops that contradict the rest.
    pub fn drop_wrong_loops(&mut self) {
        let poses = &self.poses;
        self.edges.retain(|edge| !edge.closes || edge.chi2(poses) < WRONG);
    }

    fn settle(&mut self, phi: f64) {
        let (mut damping, mut cost) = (DAMPING, self.cost(&self.poses, phi));
        for _ in 0..ROUNDS {
            let Some(moved) = self.moved(damping, phi) else { break };
            let next = self.cost(&moved, phi);
            let gain = cost - next;
            if gain > 0.0 {
                (self.poses, cost, damping) = (moved, next, damping / 10.0);
            } else {
                damping *= 100.0;
            }
            if damping > STUCK || (0.0..ENOUGH * cost).contains(&gain) {
                break;
            }
        }
    }

    fn cost(&self, poses: &[Pose], phi: f64) -> f64 {
        self.edges.iter().map(|e| e.cost(e.chi2(poses), phi)).sum()
    }

    /// The poses after one step.
    fn moved(&self, damping: f64, phi: f64) -> Option<Vec<Pose>> {
        let mut system = System::new(self.poses.len());
        for edge in &self.edges {
            add(&mut system, edge, &self.poses, phi);
        }
        for block in &mut system.diagonal {
            let share = block.diagonal() * damping;
            *block += Matrix3::from_diagonal(&share) + Matrix3::identity() * 1e-9;
        }
        *system.diagonal.first_mut()? += Matrix3::identity() * 1e12;
        let steps = system.solve()?;
        let step = |(pose, s): (&Pose, &Vector3<f64>)| pose.then(Pose { x: s.x, y: s.y, theta: s.z });
        let poses: Vec<_> = self.poses.iter().zip(&steps).map(step).collect();
        poses.iter().all(|p| finite(*p)).then_some(poses)
    }
}

fn add(system: &mut System, edge: &Edge, poses: &[Pose], phi: f64) {
    let (from, to) = edge.slopes(poses);
    let error = edge.error(poses);
    let information = edge.information * edge.trust(edge.chi2(poses), phi);
    system.diagonal[edge.from] += from.transpose() * information * from;
    system.diagonal[edge.to] += to.transpose() * information * to;
    system.right[edge.from] -= from.transpose() * information * error;
    system.right[edge.to] -= to.transpose() * information * error;
    system.couple(edge.from, edge.to, &(from.transpose() * information * to));
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// A square walked in steps of 1 m whose turns err by this much each.
    fn square(side: usize, drift: f64) -> Graph {
        let mut graph = Graph { poses: vec![Pose::IDENTITY], edges: vec![] };
        for i in 0..4 * side {
            let theta = drift + if (i + 1) % side == 0 { FRAC_PI_2 } else { 0.0 };
            let step = Pose { x: 1.0, y: 0.0, theta };
            graph.poses.push(graph.poses[i].then(step));
            let information = Matrix3::from_diagonal(&Vector3::new(400.0, 400.0, 2500.0));
            graph.edges.push(Edge { from: i, to: i + 1, step, information, closes: false });
        }
        graph
    }

    fn loop_edge(from: usize, to: usize, step: Pose) -> Edge {
        Edge { from, to, step, information: Matrix3::identity() * 1e4, closes: true }
    }

    #[test]
    fn a_closed_loop_takes_the_drift_away() {
        let mut graph = square(20, 0.004);
        assert!(graph.poses[80].distance(Pose::IDENTITY) > 2.0);
        graph.edges.push(loop_edge(0, 80, Pose { theta: 4.0 * FRAC_PI_2, ..Pose::IDENTITY }));
        graph.optimise(true);
        assert!(graph.poses[80].distance(Pose::IDENTITY) < 0.02);
        let corner = Pose { x: 20.0, y: 20.0, theta: 0.0 };
        assert!(graph.poses[40].distance(corner) < 0.35, "{:?}", graph.poses[40]);
    }

    #[test]
    fn a_wrong_loop_is_overruled() {
        let mut graph = square(20, 0.0);
        let before = graph.poses.clone();
        for i in 0..10 {
            let step = graph.poses[i].to(graph.poses[80 - i]);
            graph.edges.push(loop_edge(i, 80 - i, step));
        }
        graph.edges.push(loop_edge(10, 50, Pose::IDENTITY));
        graph.optimise(true);
        assert!(graph.poses.iter().zip(&before).all(|(a, b)| a.distance(*b) < 0.1));
    }

    #[test]
    fn nothing_to_fit_is_no_panic() {
        Graph::default().optimise(true);
        let mut lone = Graph { poses: vec![Pose::IDENTITY; 3], edges: vec![] };
        lone.optimise(true);
        assert_eq!(lone.poses, [Pose::IDENTITY; 3]);
    }
}
