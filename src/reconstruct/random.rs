//! Pseudo-random numbers: the mixing function of SplitMix64 (Steele, Lea, Flood 2014). Where the paper draws at random
//! the seed is a parameter, so that the same map gives the same layout.

/// A pseudo-random number that belongs to a seed and a pair of numbers.
pub fn mix(seed: u64, a: u64, b: u64) -> u64 {
    [a, b].iter().fold(scramble(seed), |state, v| scramble(state ^ v))
}

fn scramble(state: u64) -> u64 {
    let mut z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn neighbouring_pairs_have_unlike_numbers() {
        let numbers: BTreeSet<u64> = (0..100).flat_map(|a| (0..100).map(move |b| mix(1, a, b))).collect();
        assert_eq!(numbers.len(), 10_000);
        let above = numbers.iter().filter(|n| **n > u64::MAX / 2).count();
        assert!((4_800..5_200).contains(&above), "{above}");
        assert_ne!(mix(1, 2, 3), mix(2, 2, 3));
    }
}
