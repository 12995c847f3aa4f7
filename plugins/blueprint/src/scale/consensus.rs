//! What most of several measurements agree on.

/// Measurements of one quantity agree within this factor of each other: what a written size, rounded to a hand's
/// width, and a line drawn two pixels wide leave.
const TOLERANCE: f64 = 1.04;

/// One measurement of a positive quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement {
    /// What was measured.
    pub value: f64,
    /// How much it counts.
    pub weight: f64,
}

/// The largest group of measurements that agree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Their weighted geometric mean.
    pub value: f64,
    /// How many they are.
    pub count: usize,
    /// Their share of the weight of all.
    pub share: f64,
}

/// The group of measurements within a window of [`TOLERANCE`] either way that weighs most, or none of none.
pub fn agreement(measurements: &[Measurement]) -> Option<Agreement> {
    let mut sorted: Vec<_> =
        measurements.iter().copied().filter(|m| m.value > 0.0 && m.weight > 0.0).collect();
    sorted.sort_by(|a, b| a.value.total_cmp(&b.value));
    let total: f64 = sorted.iter().map(|m| m.weight).sum();
    let window = |first: usize| {
        let limit = sorted[first].value * TOLERANCE * TOLERANCE;
        let beyond = sorted[first..].partition_point(|m| m.value <= limit);
        &sorted[first..first + beyond]
    };
    let weight = |group: &[Measurement]| group.iter().map(|m| m.weight).sum::<f64>();
    let heaviest = |a: &usize, b: &usize| weight(window(*a)).total_cmp(&weight(window(*b))).then(b.cmp(a));
    let best = window((0..sorted.len()).max_by(heaviest)?);
    let mean = best.iter().map(|m| m.value.ln() * m.weight).sum::<f64>() / weight(best);
    Some(Agreement { value: mean.exp(), count: best.len(), share: weight(best) / total })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: &[f64]) -> Option<Agreement> {
        agreement(&values.iter().map(|&value| Measurement { value, weight: 1.0 }).collect::<Vec<_>>())
    }

    #[test]
    fn outliers_do_not_count() {
        let found = of(&[0.02, 0.0201, 5.0, 0.0199, 0.9]).unwrap();
        assert!((found.value - 0.02).abs() < 1e-4 && found.count == 3, "{found:?}");
        assert!((found.share - 0.6).abs() < 1e-9);
    }

    #[test]
    fn nothing_agrees_on_nothing() {
        assert_eq!(of(&[]), None);
        assert_eq!(of(&[f64::NAN, -1.0, 0.0]), None);
    }
}
