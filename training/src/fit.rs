//! Logistic regression with a ridge penalty, by Newton's method (iteratively reweighted least squares).

use crate::samples::Sample;
use planform::reconstruct::basins::evidence::COUNT;
use planform::reconstruct::basins::model::Model;

/// The penalty on the square of each standardised weight, against the sum of losses with a mean weight of 1.
const RIDGE: f64 = 1.0 / 0.3;

const N: usize = COUNT + 1;

/// The model that fits the samples best.
pub fn fit(samples: &[&Sample]) -> Model {
    let total: f64 = samples.iter().map(|s| s.weight).sum();
    let scale = samples.len() as f64 / total.max(f64::MIN_POSITIVE);
    let (mean, deviation) = moments(samples);
    let standard = |s: &Sample| -> [f64; N] {
        std::array::from_fn(|i| if i == COUNT { 1.0 } else { (s.evidence[i] - mean[i]) / deviation[i] })
    };
    let rows: Vec<([f64; N], f64, f64)> =
        samples.iter().map(|s| (standard(s), f64::from(u8::from(s.same)), s.weight * scale)).collect();
    let mut w = [0.0; N];
    for _ in 0..50 {
        let step = newton_step(&rows, &w);
        w.iter_mut().zip(step).for_each(|(w, s)| *w -= s);
        if step.iter().all(|s| s.abs() < 1e-9) {
            break;
        }
    }
    let weights: [f64; COUNT] = std::array::from_fn(|i| w[i] / deviation[i]);
    let bias = w[COUNT] - weights.iter().zip(mean).map(|(w, m)| w * m).sum::<f64>();
    Model { bias, weights }
}

fn moments(samples: &[&Sample]) -> ([f64; COUNT], [f64; COUNT]) {
    let n = samples.len().max(1) as f64;
    let mean: [f64; COUNT] = std::array::from_fn(|i| samples.iter().map(|s| s.evidence[i]).sum::<f64>() / n);
    let variance = |i: usize| samples.iter().map(|s| (s.evidence[i] - mean[i]).powi(2)).sum::<f64>() / n;
    (mean, std::array::from_fn(|i| variance(i).sqrt().max(1e-9)))
}

fn newton_step(rows: &[([f64; N], f64, f64)], w: &[f64; N]) -> [f64; N] {
    let mut gradient = [0.0; N];
    let mut hessian = [[0.0; N]; N];
    for (x, y, weight) in rows {
        let odds: f64 = x.iter().zip(w).map(|(x, w)| x * w).sum();
        let p = 1.0 / (1.0 + (-odds).exp());
        let (error, curve) = (weight * (p - y), weight * p * (1.0 - p));
        for i in 0..N {
            gradient[i] += error * x[i];
            hessian[i].iter_mut().zip(x).for_each(|(h, xj)| *h += curve * x[i] * xj);
        }
    }
    for i in 0..N {
        // The bias is free.
        if i < COUNT {
            gradient[i] += RIDGE * w[i];
            hessian[i][i] += RIDGE;
        }
        hessian[i][i] += 1e-9;
    }
    solve(hessian, gradient)
}

/// Gaussian elimination with pivots.
fn solve(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            let row = a[k];
            a[i].iter_mut().zip(row).skip(k).for_each(|(x, p)| *x -= factor * p);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One room where the first number is above the second, by more than chance.
    fn sample(i: usize) -> Sample {
        let evidence = std::array::from_fn(|k| ((i * (k + 3) * 7919) % 101) as f64 / 101.0);
        Sample { evidence, same: evidence[0] + 0.1 * evidence[5] > evidence[1], weight: 1.0 }
    }

    #[test]
    fn what_decides_gets_the_weight() {
        let samples: Vec<Sample> = (1..600).map(sample).collect();
        let model = fit(&samples.iter().collect::<Vec<_>>());
        let right = samples.iter().filter(|s| (model.log_odds(&s.evidence) > 0.0) == s.same).count();
        assert!(right as f64 > 0.95 * samples.len() as f64, "{right}");
        let others = model.weights[2..].iter().map(|w| w.abs()).fold(0.0, f64::max);
        assert!(model.weights[0] > 3.0 * others && model.weights[1] < -3.0 * others, "{model:?}");
    }

    #[test]
    fn equations_are_solved() {
        let mut a = [[0.0; N]; N];
        (0..N).for_each(|i| (a[i][(i + 1) % N], a[i][i]) = (1.0, 3.0));
        let solution = solve(a, [4.0; N]);
        assert!(solution.iter().all(|x| (x - 1.0).abs() < 1e-12), "{solution:?}");
    }
}
