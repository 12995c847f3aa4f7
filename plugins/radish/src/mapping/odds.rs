//! From votes to occupancy.

use planform_sdk::Cell;

/// What a vote changes in the belief that a cell is occupied, as a probability that it alone would lead to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Odds {
    /// Where a beam ends; above one half.
    pub hit: f64,
    /// Where a beam passes; below one half.
    pub miss: f64,
}

impl Odds {
    /// The cell in which so many beams end and through which so many pass: unknown if none did.
    pub fn cell(&self, ends: u32, passes: u32) -> Cell {
        if ends == 0 && passes == 0 {
            return Cell::UNKNOWN;
        }
        let log_odds = f64::from(ends) * logit(self.hit) + f64::from(passes) * logit(self.miss);
        let occupancy = 1.0 / (1.0 + (-log_odds).exp());
        Cell::percent((occupancy * 100.0).round() as u8)
    }
}

fn logit(p: f64) -> f64 {
    (p / (1.0 - p)).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn votes_move_the_belief_from_one_half() {
        let odds = Odds { hit: 0.7, miss: 0.4 };
        let percent = |ends, passes| odds.cell(ends, passes).occupancy();
        assert_eq!(percent(0, 0), None);
        assert_eq!((percent(1, 0), percent(0, 1)), (Some(70), Some(40)));
        assert_eq!((percent(u32::MAX, 0), percent(0, u32::MAX)), (Some(100), Some(0)));
        assert_eq!(percent(u32::MAX, u32::MAX), Some(100), "an end is worth two passes");
    }
}
