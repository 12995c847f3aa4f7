//! Solves the large, mostly empty systems of equations of pose graphs: variables are eliminated one by one, always one
//! with the fewest neighbours (minimum degree), as a Cholesky factorisation of 3 x 3 blocks does.

use nalgebra::{Matrix3, Vector3};
use std::collections::{BTreeMap, BTreeSet};

/// A symmetric system of equations in blocks of three.
pub struct System {
    /// The blocks on the diagonal.
    pub diagonal: Vec<Matrix3<f64>>,
    /// The right side.
    pub right: Vec<Vector3<f64>>,
    /// For each row the blocks beside the diagonal; each is here twice, the other time transposed.
    rows: Vec<BTreeMap<usize, Matrix3<f64>>>,
}

/// What is left of a variable that was eliminated: its equation with those that come later.
struct Eliminated {
    variable: usize,
    inverse: Matrix3<f64>,
    others: Vec<(usize, Matrix3<f64>)>,
}

impl System {
    /// Of this many variables, with nothing known.
    pub fn new(variables: usize) -> Self {
        Self {
            diagonal: vec![Matrix3::zeros(); variables],
            right: vec![Vector3::zeros(); variables],
            rows: vec![BTreeMap::new(); variables],
        }
    }

    /// Adds a block at this row and column, which differ, and its transpose at the column and row.
    pub fn couple(&mut self, row: usize, column: usize, block: &Matrix3<f64>) {
        *self.rows[row].entry(column).or_insert_with(Matrix3::zeros) += block;
        *self.rows[column].entry(row).or_insert_with(Matrix3::zeros) += block.transpose();
    }

    /// The solution, unless the system has none or many.
    pub fn solve(mut self) -> Option<Vec<Vector3<f64>>> {
        let mut queue: BTreeSet<(usize, usize)> = self.rows.iter().map(BTreeMap::len).zip(0..).collect();
        let mut done = Vec::with_capacity(queue.len());
        while let Some((_, variable)) = queue.pop_first() {
            done.push(self.eliminate(variable, &mut queue)?);
        }
        Some(substitute(&done, self.right))
    }

    fn eliminate(&mut self, variable: usize, queue: &mut BTreeSet<(usize, usize)>) -> Option<Eliminated> {
        let inverse = self.diagonal[variable].cholesky()?.inverse();
        let others: Vec<_> = std::mem::take(&mut self.rows[variable]).into_iter().collect();
        let right = self.right[variable];
        for (a, block_a) in &others {
            queue.remove(&(self.rows[*a].len(), *a));
            self.rows[*a].remove(&variable);
            let share = block_a.transpose() * inverse;
            self.diagonal[*a] -= share * block_a;
            self.right[*a] -= share * right;
            for (b, block_b) in &others {
                if b != a {
                    *self.rows[*a].entry(*b).or_insert_with(Matrix3::zeros) -= share * block_b;
                }
            }
            queue.insert((self.rows[*a].len(), *a));
        }
        Some(Eliminated { variable, inverse, others })
    }
}

/// From the last variable eliminated, which has no others in its equation, back to the first.
fn substitute(done: &[Eliminated], right: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
    let mut solution = right;
    for Eliminated { variable, inverse, others } in done.iter().rev() {
        let known: Vector3<f64> = others.iter().map(|(other, block)| block * solution[*other]).sum();
        solution[*variable] = inverse * (solution[*variable] - known);
    }
    solution
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    /// A ring with two chords, and how strongly each pair is coupled.
    const PAIRS: [(usize, usize); 9] =
        [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 0), (1, 5), (2, 6)];

    #[test]
    fn agrees_with_a_dense_solution() {
        let mut system = System::new(7);
        let mut dense = DMatrix::<f64>::zeros(21, 21);
        for (n, (a, b)) in PAIRS.iter().enumerate() {
            let block = Matrix3::from_fn(|i, j| ((n + 3 * i + 5 * j) as f64).sin());
            system.couple(*a, *b, &block);
            dense.view_mut((3 * a, 3 * b), (3, 3)).copy_from(&block);
            dense.view_mut((3 * b, 3 * a), (3, 3)).copy_from(&block.transpose());
        }
        for i in 0..7 {
            system.diagonal[i] = Matrix3::identity() * 20.0;
            dense.view_mut((3 * i, 3 * i), (3, 3)).copy_from(&system.diagonal[i]);
            system.right[i] = Vector3::new(1.0, -(i as f64), 0.5);
        }
        let right = DMatrix::from_fn(21, 1, |i, _| system.right[i / 3][i % 3]);
        let expected = dense.cholesky().unwrap().solve(&right);
        for (i, block) in system.solve().unwrap().iter().enumerate() {
            assert!((block - expected.view((3 * i, 0), (3, 1))).norm() < 1e-12);
        }
    }

    #[test]
    fn without_a_solution_there_is_none() {
        assert!(System::new(2).solve().is_none());
    }
}
