//! Faces clustered to rooms: DBSCAN (Ester et al. 1996) on the local affinity matrix.

use super::affinity::Rows;
use super::boundary::Run;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// When two faces belong to one room.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Rooms {
    /// DBSCAN's radius epsilon.
    pub epsilon: f64,
    /// DBSCAN's least number of neighbours of a core face, itself included.
    pub min_points: usize,
    /// What distance DBSCAN sees between two faces.
    pub metric: Metric,
}

impl Default for Rooms {
    fn default() -> Self {
        Self { epsilon: 0.85, min_points: 1, metric: Metric::Affinity }
    }
}

/// A distance between faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Metric {
    /// One minus the mean affinity of the two faces for each other.
    Affinity,
    /// The Euclidean distance of the two faces' rows of A, among neighbours.
    Rows,
}

/// The cluster of each face, numbered by their first face; `None` for faces that `member` does not hold for.
pub fn cluster(affinity: &Rows, params: &Rooms, member: impl Fn(usize) -> bool) -> Vec<Option<usize>> {
    let faces = Faces { affinity, params };
    let core: Vec<bool> = (0..affinity.count())
        .map(|f| member(f) && faces.near(f).filter(|&f| member(f)).count() >= params.min_points)
        .collect();
    let mut of = vec![None; affinity.count()];
    let mut count = 0;
    let mut open = Vec::new();
    for start in 0..affinity.count() {
        if of[start].is_some() || !core[start] {
            continue;
        }
        of[start] = Some(count);
        open.push(start);
        while let Some(face) = open.pop() {
            for other in faces.near(face).filter(|&f| member(f)) {
                if of[other].is_none() {
                    of[other] = Some(count);
                    open.extend(Some(other).filter(|&f| core[f]));
                }
            }
        }
        count += 1;
    }
    of
}

struct Faces<'a> {
    affinity: &'a Rows,
    params: &'a Rooms,
}

impl Faces<'_> {
    /// The face itself and all within epsilon of it.
    fn near(&self, face: usize) -> impl Iterator<Item = usize> {
        let within = move |&other: &usize| other == face || self.distance(face, other) <= self.params.epsilon;
        self.affinity.row(face).iter().map(|e| e.0 as usize).filter(within)
    }

    fn distance(&self, a: usize, b: usize) -> f64 {
        match self.params.metric {
            Metric::Affinity => 1.0 - (self.affinity.entry(a, b) + self.affinity.entry(b, a)) / 2.0,
            Metric::Rows => rows_apart(self.affinity.row(a), self.affinity.row(b)),
        }
    }
}

/// Euclidean distance of two sparse rows.
fn rows_apart(a: &[(u32, f64)], b: &[(u32, f64)]) -> f64 {
    let (mut i, mut j, mut sum) = (0, 0, 0.0);
    while i < a.len() || j < b.len() {
        let (ca, cb) = (a.get(i).map_or(u32::MAX, |e| e.0), b.get(j).map_or(u32::MAX, |e| e.0));
        let mut d = 0.0;
        if ca <= cb {
            d += a[i].1;
            i += 1;
        }
        if cb <= ca {
            d -= b[j].1;
            j += 1;
        }
        sum += d * d;
    }
    sum.sqrt()
}

/// Gives the faces of every room that `is_wall` holds for to the neighbouring room with the longest open boundary, or
/// to the outside if there is none. Returns the clusters numbered anew.
pub fn absorb(of: &[Option<usize>], is_wall: &[bool], runs: &[Run]) -> Vec<Option<usize>> {
    let mut open: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    for run in runs {
        let [Some(a), Some(b)] = run.rooms else { continue };
        let length = run.segment.length() * (1.0 - run.weight) + f64::MIN_POSITIVE;
        for (wall, room) in [(a, b), (b, a)] {
            if is_wall[wall] && !is_wall[room] {
                *open.entry((wall, room)).or_default() += length;
            }
        }
    }
    let heir = |wall: usize| {
        let neighbours = open.range((wall, 0)..=(wall, usize::MAX));
        neighbours.max_by(|a, b| a.1.total_cmp(b.1)).map(|(key, _)| key.1)
    };
    renumber(of.iter().map(|room| room.and_then(|r| if is_wall[r] { heir(r) } else { Some(r) })).collect())
}

/// The same clusters, numbered by their first face.
fn renumber(of: Vec<Option<usize>>) -> Vec<Option<usize>> {
    let mut names: BTreeMap<usize, usize> = BTreeMap::new();
    let mut name = |room: usize| {
        let next = names.len();
        *names.entry(room).or_insert(next)
    };
    of.into_iter().map(|room| room.map(&mut name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Point, Segment};

    #[test]
    fn a_wall_goes_to_the_room_it_is_most_open_to() {
        let run = |rooms, weight| Run {
            line: Some(0),
            segment: Segment::new(Point::new(0.0, 0.0), Point::new(1.0, 0.0)),
            weight,
            rooms,
        };
        let runs = [run([Some(0), Some(1)], 0.9), run([Some(1), Some(2)], 0.5), run([Some(3), None], 0.0)];
        let of = [Some(0), Some(1), Some(2), Some(3), None];
        assert_eq!(absorb(&of, &[false, true, false, true], &runs), [Some(0), Some(1), Some(1), None, None]);
    }

    #[test]
    fn open_faces_merge_and_walled_ones_do_not() {
        // Faces 0 and 1 are open to each other, 2 is behind a wall.
        let a = Rows::of(
            3,
            &[(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.49), (1, 1, 0.5), (1, 2, 0.01), (2, 1, 0.02), (2, 2, 0.98)],
        );
        assert_eq!(cluster(&a, &Rooms::default(), |_| true), [Some(0), Some(0), Some(1)]);
        let rows = Rooms { metric: Metric::Rows, ..Rooms::default() };
        assert_eq!(cluster(&a, &rows, |_| true), [Some(0), Some(0), Some(1)]);
        assert_eq!(cluster(&a, &Rooms::default(), |f| f != 1)[1], None);
    }

    #[test]
    fn lonely_faces_are_noise_when_more_points_are_asked() {
        let a = Rows::of(1, &[(0, 0, 1.0)]);
        assert_eq!(cluster(&a, &Rooms { min_points: 2, ..Rooms::default() }, |_| true), [None]);
    }

    #[test]
    fn rows_are_apart_as_vectors() {
        assert!((rows_apart(&[(0, 1.0)], &[(1, 1.0)]) - 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(rows_apart(&[(0, 0.5), (3, 0.5)], &[(0, 0.5), (3, 0.5)]), 0.0);
    }
}
