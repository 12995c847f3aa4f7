//! The particle filter.

use crate::{Field, Motion, MotionNoise, Random, Sweep, turn};
use planform_sdk::{Point, Pose};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// What the filter believes of its robot, and how it works.
#[derive(Debug, Clone)]
pub struct Params {
    /// How wrong odometry is.
    pub motion: MotionNoise,
    /// How far an echo lies from the wall that it comes from, standard deviation, metres: noise of the laser and of
    /// the map.
    pub sigma: f64,
    /// The share of echoes that come from what is not on the map.
    pub unexplained: f64,
    /// How many beams of a sweep are used, evenly spaced.
    pub beams: usize,
    /// How many of them count as independent of each other; all of them would make the filter too sure.
    pub independent: f64,
    /// Fewest and most particles while the robot is followed. Between them KLD-sampling chooses.
    pub particles: [usize; 2],
    /// Particles of a start from anywhere, for each square metre of floor.
    pub density: f64,
    /// The most particles of a start from anywhere.
    pub most: usize,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            motion: MotionNoise::default(),
            sigma: 0.1,
            unexplained: 0.25,
            beams: 60,
            independent: 12.0,
            particles: [500, 100_000],
            density: 200.0,
            most: 100_000,
        }
    }
}

/// Sides of the boxes in which KLD-sampling counts: metres, metres, radians.
const BOX: [f64; 3] = [0.5, 0.5, TAU / 36.0];

/// The bound on the error of KLD-sampling, and the quantile of the normal distribution of its certainty (99 %).
const KLD: (f64, f64) = (0.05, 2.326);

/// In so many boxes at most the particles are close enough to each other for the map's details.
const FEW_BOXES: f64 = 50.0;

/// The most that echoes may be farther off.
const COARSEST: f64 = 4.0;

/// A pose that the robot may have.
#[derive(Debug, Clone, Copy)]
struct Particle {
    pose: Pose,
    weight: f64,
}

/// Where a robot may be.
pub struct Filter<'a> {
    field: &'a Field,
    params: Params,
    random: Random,
    particles: Vec<Particle>,
    /// How many boxes the particles were in when they were last drawn.
    boxes: usize,
}

impl<'a> Filter<'a> {
    /// A robot about this pose: standard deviations of metres and of radians.
    pub fn at(field: &'a Field, params: Params, pose: Pose, [far, turned]: [f64; 2], seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut near = || Pose {
            x: pose.x + random.normal(far),
            y: pose.y + random.normal(far),
            yaw: pose.yaw + random.normal(turned),
        };
        let particles = (0..params.particles[0]).map(|_| Particle { pose: near(), weight: 1.0 }).collect();
        Self { field, params, random, particles, boxes: 1 }
    }

    /// A robot anywhere on the floor.
    pub fn anywhere(field: &'a Field, params: Params, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let floor = field.floor_cells();
        let area = floor as f64 * field.grid().resolution().powi(2);
        let count = ((area * params.density) as usize).clamp(params.particles[0], params.most);
        let mut place = || {
            let (number, shares) = (random.below(floor), [random.share(), random.share()]);
            let Point { x, y } = field.on_floor(number, shares)?;
            Some(Particle { pose: Pose { x, y, yaw: TAU * random.share() }, weight: 1.0 })
        };
        let particles: Vec<_> = (0..count).filter_map(|_| place()).collect();
        let boxes = particles.len();
        Self { field, params, random, particles, boxes }
    }

    /// How many particles there are.
    pub fn count(&self) -> usize {
        self.particles.len()
    }

    /// Takes in a motion and the sweep after it.
    pub fn step(&mut self, motion: &Motion, sweep: &Sweep) {
        for particle in &mut self.particles {
            particle.pose = motion.sample(&self.params.motion, &mut self.random).lead(particle.pose);
        }
        self.weigh(sweep);
        if self.effective() < 0.5 * self.particles.len() as f64 {
            self.resample();
        }
    }

    /// Weighs every particle by how well the sweep fits the map there (table 6.3, with the beams as one measurement of
    /// fewer independent ones).
    fn weigh(&mut self, sweep: &Sweep) {
        let echoes = self.echoes(sweep);
        if echoes.is_empty() {
            return;
        }
        let strength = self.params.independent.min(echoes.len() as f64) / echoes.len() as f64;
        let logs: Vec<f64> = self.particles.iter().map(|p| self.fit(p.pose, &echoes) * strength).collect();
        let best = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        self.particles.iter_mut().zip(logs).for_each(|(p, log)| p.weight *= (log - best).exp());
        let sum: f64 = self.particles.iter().map(|p| p.weight).sum();
        let even = 1.0 / self.particles.len() as f64;
        for particle in &mut self.particles {
            particle.weight = if sum > 0.0 { particle.weight / sum } else { even };
        }
    }

    /// The ends of some beams with an echo, as seen from the laser.
    fn echoes(&self, sweep: &Sweep) -> Vec<Point> {
        let every = sweep.ranges.len().div_ceil(self.params.beams.max(1)).max(1);
        let chosen = sweep.ranges.iter().enumerate().skip(every / 2).step_by(every);
        let echoes = chosen.filter(|(_, r)| **r > 0.0 && f64::from(**r) < sweep.max_range);
        let end = |(i, range): (usize, &f32)| {
            let (sin, cos) = (sweep.first_angle + i as f64 * sweep.step).sin_cos();
            Point::new(f64::from(*range) * cos, f64::from(*range) * sin)
        };
        echoes.map(end).collect()
    }

    /// The logarithm of the likelihood of these echoes at a pose.
    fn fit(&self, pose: Pose, echoes: &[Point]) -> f64 {
        let (sin, cos) = pose.yaw.sin_cos();
        let (sigma, random) = (self.params.sigma * self.coarseness(), self.params.unexplained);
        let one = |p: &Point| {
            let end = Point::new(pose.x + cos * p.x - sin * p.y, pose.y + sin * p.x + cos * p.y);
            let off = f64::from(self.field.distance(end)) / sigma;
            ((1.0 - random) * (-0.5 * off * off).exp() + random * 0.1).ln()
        };
        echoes.iter().map(one).sum()
    }

    /// How much farther off than usual an echo may be: particles that fill a whole building are too far apart for one
    /// to be right to a hand's breadth, and the nearest to the truth must not lose to one that fits elsewhere by
    /// chance.
    fn coarseness(&self) -> f64 {
        (self.boxes as f64 / FEW_BOXES).cbrt().clamp(1.0, COARSEST)
    }

    /// How many particles of equal weight would say as much.
    fn effective(&self) -> f64 {
        let sum: f64 = self.particles.iter().map(|p| p.weight).sum();
        let squares: f64 = self.particles.iter().map(|p| p.weight * p.weight).sum();
        if squares > 0.0 { sum * sum / squares } else { 0.0 }
    }

    /// Draws particles by their weights, as many as the places that they fill ask for (Fox, "KLD-sampling", 2001).
    fn resample(&mut self) {
        let sums: Vec<f64> = self
            .particles
            .iter()
            .scan(0.0, |sum, p| {
                *sum += p.weight;
                Some(*sum)
            })
            .collect();
        let Some(&total) = sums.last() else { return };
        let [least, most] = self.params.particles;
        let (mut drawn, mut boxes, mut needed) = (vec![], BTreeSet::new(), least);
        while drawn.len() < needed.min(most) {
            let at = self.random.share() * total;
            let pose = self.particles[sums.partition_point(|s| *s <= at).min(sums.len() - 1)].pose;
            if boxes.insert(box_of(pose)) {
                needed = needed.max(kld(boxes.len()));
            }
            drawn.push(Particle { pose, weight: 1.0 });
        }
        self.boxes = boxes.len();
        let weight = 1.0 / drawn.len() as f64;
        drawn.iter_mut().for_each(|p| p.weight = weight);
        self.particles = drawn;
    }

    /// Where the robot most likely is: the mean of the particles about the box that weighs most.
    pub fn estimate(&self) -> Option<Pose> {
        let mut boxes: BTreeMap<_, f64> = BTreeMap::new();
        self.particles.iter().for_each(|p| *boxes.entry(box_of(p.pose)).or_default() += p.weight);
        let (heaviest, _) = boxes.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let centre = self.mean(|pose| box_of(pose) == heaviest)?;
        // The box may cut a cluster in two.
        self.mean(|p| (p.x - centre.x).hypot(p.y - centre.y) < 0.5 && turn(p.yaw, centre.yaw).abs() < 0.35)
    }

    fn mean(&self, counts: impl Fn(Pose) -> bool) -> Option<Pose> {
        let (mut sum, mut x, mut y, mut sin, mut cos) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for Particle { pose, weight } in self.particles.iter().filter(|p| counts(p.pose)) {
            sum += weight;
            x += weight * pose.x;
            y += weight * pose.y;
            sin += weight * pose.yaw.sin();
            cos += weight * pose.yaw.cos();
        }
        (sum > 0.0).then(|| Pose { x: x / sum, y: y / sum, yaw: sin.atan2(cos) })
    }
}

fn box_of(pose: Pose) -> [i64; 3] {
    let [x, y, yaw] = BOX;
    [(pose.x / x).floor(), (pose.y / y).floor(), (pose.yaw.rem_euclid(TAU) / yaw).floor()].map(|v| v as i64)
}

/// How many particles as many boxes ask for (table 8.4).
fn kld(boxes: usize) -> usize {
    if boxes < 2 {
        return 0;
    }
    let (epsilon, quantile) = KLD;
    let k = (boxes - 1) as f64;
    let a = 2.0 / (9.0 * k);
    (k / (2.0 * epsilon) * (1.0 - a + a.sqrt() * quantile).powi(3)).ceil() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_places_ask_for_more_particles() {
        let counts = [0, 1, 2, 10, 1000].map(kld);
        assert!(counts.is_sorted() && counts[1] == 0 && counts[4] > 10_000, "{counts:?}");
    }
}
