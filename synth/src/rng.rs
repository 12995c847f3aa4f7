//! Random numbers that stay the same on every platform and with every version of `rand`.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// ChaCha8 with this crate's own mapping to ranges, since `rand` may change its own between versions.
pub(crate) struct Rng(ChaCha8Rng);

impl Rng {
    /// Each `stream` of a seed is independent of the others, so that a change in one step leaves the rest alone.
    pub(crate) fn new(seed: u64, stream: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(stream);
        Self(rng)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [lo, hi).
    pub(crate) fn range(&mut self, (lo, hi): (f64, f64)) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Uniform among lo..=hi; `lo` when the range is empty.
    pub(crate) fn int(&mut self, (lo, hi): (i32, i32)) -> i32 {
        let count = f64::from(hi.saturating_sub(lo).max(0)) + 1.0;
        lo + (self.unit() * count) as i32
    }

    /// Uniform among 0..len; 0 when `len` is 0.
    pub(crate) fn index(&mut self, len: usize) -> usize {
        (self.unit() * len as f64) as usize
    }

    /// True with this probability.
    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// As [`chance`](Self::chance), but what cannot happen draws no number, so that those after it stay the same.
    pub(crate) fn wants(&mut self, probability: f64) -> bool {
        probability > 0.0 && self.chance(probability)
    }

    /// Mean 0, standard deviation 1: a sum of uniform numbers, which needs no platform's logarithm.
    pub(crate) fn gauss(&mut self) -> f64 {
        let sum: f64 = (0..6).map(|_| self.unit()).sum();
        (sum - 3.0) * std::f64::consts::SQRT_2
    }

    /// Puts the items in random order.
    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.index(i + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_has_unit_spread() {
        let mut rng = Rng::new(1, 0);
        let values: Vec<f64> = (0..20_000).map(|_| rng.gauss()).collect();
        let mean = values.iter().sum::<f64>() / 20_000.0;
        let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / 20_000.0;
        assert!(mean.abs() < 0.03 && (variance - 1.0).abs() < 0.05, "{mean} {variance}");
    }

    #[test]
    fn streams_differ_and_repeat() {
        let draw = |seed, stream| Rng::new(seed, stream).unit();
        assert_eq!(draw(7, 1), draw(7, 1));
        assert_ne!(draw(7, 1), draw(7, 2));
        assert_ne!(draw(7, 1), draw(8, 1));
    }

    #[test]
    fn int_stays_in_its_range() {
        let mut rng = Rng::new(3, 0);
        let drawn: Vec<i32> = (0..200).map(|_| rng.int((2, 4))).collect();
        assert!([2, 3, 4].iter().all(|v| drawn.contains(v)));
        assert!(drawn.iter().all(|v| (2..=4).contains(v)));
        assert_eq!(rng.int((5, 1)), 5);
    }
}
