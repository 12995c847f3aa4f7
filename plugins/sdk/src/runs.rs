//! Runs of equal items, such as the pixels or the labels of a row: maps are mostly made of long ones, and what becomes of
//! an item need be asked once for each.

/// How many items are looked at at once. Without a decision about each, so that the compiler can do it in few steps.
const BLOCK: usize = 16;

/// The runs of equal items, one after the other.
pub fn runs<T: PartialEq>(items: &[T]) -> impl Iterator<Item = &[T]> {
    let mut rest = items;
    std::iter::from_fn(move || {
        let first = rest.first()?;
        let (run, behind) = rest.split_at(leading(rest, |item| item == first));
        rest = behind;
        Some(run)
    })
}

/// For how many of the first items this holds.
pub fn leading<T>(items: &[T], holds: impl Fn(&T) -> bool) -> usize {
    let (blocks, _) = items.as_chunks::<BLOCK>();
    let all = |block: &&[T; BLOCK]| block.iter().fold(true, |all, item| all & holds(item));
    let whole = BLOCK * blocks.iter().take_while(all).count();
    whole + items[whole..].iter().take_while(|item| holds(item)).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn runs_are_those_of_neighbours(lengths in proptest::collection::vec((0..70_usize, 0..3_u8), 0..20)) {
            let items: Vec<u8> = lengths.iter().flat_map(|&(n, item)| std::iter::repeat_n(item, n)).collect();
            let found: Vec<&[u8]> = runs(&items).collect();
            prop_assert_eq!(found, items.chunk_by(|a, b| a == b).collect::<Vec<_>>());
            let plain = items.iter().take_while(|item| **item < 2).count();
            prop_assert_eq!(leading(&items, |item| *item < 2), plain);
        }
    }
}
