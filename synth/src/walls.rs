//! Gives walls their thickness, and rooms the outline along their walls' inner faces.

use crate::partition::{Edge, Partition, Run, edge, is_straight};
use planform_sdk::Point;
use std::collections::BTreeMap;

/// Inner runs shorter than this take the thickness of the wall that they continue, metres.
const SHORT: f64 = 0.8;

/// A thickness for every run; `choose` gives that of a run on its own, metres.
pub(crate) fn thicknesses(partition: &Partition, choose: impl FnMut(&Run) -> f64) -> Vec<f64> {
    let own: Vec<f64> = partition.runs.iter().map(choose).collect();
    let settled = |i: usize| {
        let run = &partition.runs[i];
        // An outer wall keeps its own: a thin inner wall may go on where the building steps back.
        if run.right.is_none() || partition.length(run) >= SHORT {
            own[i]
        } else {
            continued(partition, run, &own).unwrap_or(own[i])
        }
    };
    (0..own.len()).map(settled).collect()
}

/// The thickness of a long run that goes on straight from this one.
fn continued(partition: &Partition, run: &Run, own: &[f64]) -> Option<f64> {
    let [a, b] = run.ends();
    let goes_on = |other: &Run| {
        let [c, d] = other.ends();
        [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)].into_iter().any(|(p, q, r, s)| {
            q == r && s != p && is_straight(partition.points[p], partition.points[q], partition.points[s])
        })
    };
    let long = partition.runs.iter().zip(own).filter(|(r, _)| partition.length(r) >= SHORT && goes_on(r));
    long.map(|(r, &t)| (partition.length(r), t)).max_by(|x, y| x.0.total_cmp(&y.0)).map(|(_, t)| t)
}

/// Half the thickness of every edge.
pub(crate) fn half_thickness(partition: &Partition, thickness: &[f64]) -> BTreeMap<Edge, f64> {
    let runs = partition.runs.iter().zip(thickness);
    runs.flat_map(|(run, &t)| run.edges().map(move |e| (e, t / 2.0))).collect()
}

/// The ring moved inwards, each edge by half its wall's thickness. Where the thickness changes along a straight
/// wall, the ring has a step.
pub(crate) fn inner_ring(points: &[Point], ring: &[usize], half: &BTreeMap<Edge, f64>) -> Vec<Point> {
    let n = ring.len();
    let mut out = Vec::with_capacity(n);
    for i in 0..n {
        let [a, b, c] = [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]];
        let depth = |u, v| half.get(&edge(u, v)).copied().unwrap_or(0.0);
        let (before, after) = (depth(a, b), depth(b, c));
        let [a, b, c] = [a, b, c].map(|i| points[i]);
        if !is_straight(a, b, c) {
            out.push(mitre(a, b, c, before, after));
        } else if before != after {
            out.extend([beside(a, b, b, before), beside(b, c, b, after)]);
        }
    }
    out
}

/// The point `depth` to the left of `p` as seen along `a` to `b`.
fn beside(a: Point, b: Point, p: Point, depth: f64) -> Point {
    let length = a.distance(b);
    Point::new(p.x - (b.y - a.y) / length * depth, p.y + (b.x - a.x) / length * depth)
}

/// Where the lines `before` to the left of a-b and `after` to the left of b-c meet.
fn mitre(a: Point, b: Point, c: Point, before: f64, after: f64) -> Point {
    let (la, lb) = (a.distance(b), b.distance(c));
    let (u, v) = (((b.x - a.x) / la, (b.y - a.y) / la), ((c.x - b.x) / lb, (c.y - b.y) / lb));
    let cross = u.0 * v.1 - u.1 * v.0;
    // The point b + s u + t v with distance `before` from the first line and `after` from the second.
    let (s, t) = (-after / cross, before / cross);
    Point::new(b.x + s * u.0 + t * v.0, b.y + s * u.1 + t * v.1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::RoomKind;
    use crate::shape::Shape;

    fn square() -> Partition {
        let ring = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
        Partition::new(&[Shape { rings: vec![ring], kind: RoomKind::Room, access: None }]).unwrap()
    }

    #[test]
    fn inner_ring_leaves_half_of_each_wall() {
        let partition = square();
        let thickness: Vec<f64> = (1..=4).map(|i| f64::from(i) * 0.2).collect();
        let half = half_thickness(&partition, &thickness);
        let ring = inner_ring(&partition.points, &partition.rooms[0][0], &half);
        let bottom_left = ring.iter().fold((9.0f64, 9.0f64), |m, p| (m.0.min(p.x), m.1.min(p.y)));
        let sum: f64 = half.values().sum();
        assert!((sum - 1.0).abs() < 1e-9);
        assert_eq!(ring.len(), 4);
        let area = planform_sdk::ring_signed_area(&ring);
        let sides = [half[&edge(0, 1)] + half[&edge(2, 3)], half[&edge(1, 2)] + half[&edge(0, 3)]];
        assert!((area - (4.0 - sides[0]) * (4.0 - sides[1])).abs() < 1e-9, "{area}");
        assert!((bottom_left.1 - half[&edge(0, 1)]).abs() < 1e-9);
    }

    #[test]
    fn a_change_of_thickness_makes_a_step() {
        let points: Vec<Point> =
            [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
        let half =
            BTreeMap::from([((0, 1), 0.1), ((1, 2), 0.2), ((2, 3), 0.1), ((3, 4), 0.1), ((0, 4), 0.1)]);
        let ring = inner_ring(&points, &[0, 1, 2, 3, 4], &half);
        assert_eq!(ring.len(), 6);
        assert!(ring.contains(&Point::new(2.0, 0.1)) && ring.contains(&Point::new(2.0, 0.2)));
    }
}
