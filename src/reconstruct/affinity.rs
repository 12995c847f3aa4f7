//! How much two neighbouring faces belong together: L, D and A of the paper's section III.

use super::arrangement::{Arrangement, Edge};
use super::lines::Line;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How fast affinity falls with the wall between two faces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Affinity {
    /// The regularisation factor sigma of L = exp(-weight / sigma).
    pub sigma: f64,
}

impl Default for Affinity {
    fn default() -> Self {
        Self { sigma: 0.1 }
    }
}

/// The weight of each edge: the share of it that wall segments of its line cover, 0 to 1. The rectangle's border has
/// weight 0.
pub fn weights(arrangement: &Arrangement, edges: &[Edge], lines: &[Line]) -> Vec<f64> {
    edges.iter().map(|e| weight(arrangement, e, lines)).collect()
}

fn weight(arrangement: &Arrangement, edge: &Edge, lines: &[Line]) -> f64 {
    let Some(line) = edge.line.and_then(|l| lines.get(l)) else { return 0.0 };
    let [a, b] = edge.ends.map(|v| line.along(arrangement.vertices[v]));
    let length = (a - b).abs();
    if length == 0.0 { 0.0 } else { (line.coverage(a, b) / length).min(1.0) }
}

/// The local affinity matrix: for each face the faces that it shares an edge with, itself among them, and how much it
/// belongs together with each.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// Where each row begins among the entries; at the end, how many there are.
    begin: Vec<u32>,
    entries: Vec<(u32, f64)>,
}

impl Rows {
    /// How many rows there are.
    pub fn count(&self) -> usize {
        self.begin.len() - 1
    }

    /// The entries of a row by rising column.
    pub fn row(&self, row: usize) -> &[(u32, f64)] {
        &self.entries[self.begin[row] as usize..self.begin[row + 1] as usize]
    }

    /// The entry of this row and column.
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        let row = self.row(row);
        row.binary_search_by_key(&(column as u32), |e| e.0).map_or(0.0, |i| row[i].1)
    }

    /// Rows from their entries in any order, `(row, column, value)`.
    pub fn of(count: usize, entries: &[(u32, u32, f64)]) -> Self {
        let mut begin = vec![0u32; count + 1];
        entries.iter().for_each(|e| begin[e.0 as usize + 1] += 1);
        for i in 0..count {
            begin[i + 1] += begin[i];
        }
        let mut at = begin.clone();
        let mut placed = vec![(0, 0.0); entries.len()];
        for &(row, column, value) in entries {
            placed[at[row as usize] as usize] = (column, value);
            at[row as usize] += 1;
        }
        let mut rows = Self { begin, entries: placed };
        (0..count).for_each(|row| rows.row_mut(row).sort_by_key(|e| e.0));
        rows
    }

    fn row_mut(&mut self, row: usize) -> &mut [(u32, f64)] {
        &mut self.entries[self.begin[row] as usize..self.begin[row + 1] as usize]
    }
}

/// The local affinity matrix A = D^-1 L by rows: (column, value) by rising column, without the zeros of faces that
/// are not neighbours. Only edges between two faces that `member` holds for are seen.
pub fn local_affinity(
    count: usize,
    edges: &[Edge],
    weights: &[f64],
    params: &Affinity,
    member: impl Fn(usize) -> bool,
) -> Rows {
    let mut entries: Vec<(u32, u32, f64)> = (0..count as u32).map(|f| (f, f, 1.0)).collect();
    for (edge, weight) in edges.iter().zip(weights) {
        if let Some(right) = edge.right
            && member(edge.left)
            && member(right)
        {
            let likeness = (-weight / params.sigma).exp();
            let (left, right) = (edge.left as u32, right as u32);
            entries.extend([(left, right, likeness), (right, left, likeness)]);
        }
    }
    let mut rows = Rows::of(count, &entries);
    (0..count).for_each(|row| normalise(rows.row_mut(row)));
    rows
}

fn normalise(row: &mut [(u32, f64)]) {
    let sum: f64 = row.iter().map(|e| e.1).sum();
    row.iter_mut().for_each(|e| e.1 /= sum);
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Point;
    use std::f64::consts::PI;

    #[test]
    fn a_wall_separates_and_a_gap_joins() {
        let line = Line { angle: PI / 2.0, offset: -5.0, covered: vec![(0.0, 7.5)], support: 7.5 };
        let a = Arrangement::of_lines(
            Point::new(0.0, 0.0),
            Point::new(10.0, 10.0),
            std::slice::from_ref(&line),
            usize::MAX,
        )
        .unwrap();
        let edges = a.edges();
        let weights = weights(&a, &edges, &[line]);
        let between = edges.iter().position(|e| e.right.is_some()).unwrap();
        assert!((weights[between] - 0.75).abs() < 1e-9);
        let rows = local_affinity(2, &edges, &weights, &Affinity::default(), |_| true);
        let likeness = (-7.5f64).exp();
        assert!((rows.entry(0, 1) - likeness / (1.0 + likeness)).abs() < 1e-12);
        assert!((rows.row(0).iter().map(|e| e.1).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
