//! How likely two regions are one room: a logistic regression on the evidence of their boundary.

use super::evidence::{COUNT, Evidence};
use super::weights::{BIAS, WEIGHTS};

/// The model's weights.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// The log odds where all evidence is 0.
    pub bias: f64,
    /// What each number adds to the log odds, for each of its units.
    pub weights: [f64; COUNT],
}

impl Model {
    /// The log odds that the two regions are one room.
    pub fn log_odds(&self, evidence: &Evidence) -> f64 {
        self.bias + self.weights.iter().zip(evidence).map(|(w, e)| w * e).sum::<f64>()
    }
}

impl Default for Model {
    fn default() -> Self {
        Self { bias: BIAS, weights: WEIGHTS }
    }
}
