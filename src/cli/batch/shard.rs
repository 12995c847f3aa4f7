//! One share of a batch, for several machines that work on it together.

use super::digest::Digest;
use std::str::FromStr;

/// The share `index` of `of`, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    of: u64,
}

/// The most shares.
const MOST: u64 = 1_000_000;

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("write I/N, such as 1/8 for the first of eight shares; N is at most {MOST}");
        let (index, of) = text.split_once('/').ok_or_else(wrong)?;
        let shard = Self { index: index.parse().map_err(|_| wrong())?, of: of.parse().map_err(|_| wrong())? };
        let makes_sense = (1..=MOST).contains(&shard.of) && (1..=shard.of).contains(&shard.index);
        makes_sense.then_some(shard).ok_or_else(wrong)
    }
}

impl Shard {
    /// Whether the document of this name belongs to the share. It does so whatever other documents there are, so that a
    /// share that is resumed after documents were added is still the same.
    pub fn takes(self, name: &str) -> bool {
        Digest::of(name.as_bytes()).number() % self.of == self.index - 1
    }

    /// `2-of-8`: the name of the folder for what the share notes.
    pub fn folder(self) -> String {
        format!("{}-of-{}", self.index, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_document_is_in_exactly_one_share() {
        let shards: Vec<Shard> = (1..=4).map(|i| format!("{i}/4").parse().unwrap()).collect();
        let names: Vec<_> = (0..400).map(|n| format!("plans/{n}.png")).collect();
        for name in &names {
            assert_eq!(shards.iter().filter(|s| s.takes(name)).count(), 1, "{name}");
        }
        let sizes = shards.iter().map(|s| names.iter().filter(|n| s.takes(n)).count());
        assert!(sizes.clone().all(|n| (60..140).contains(&n)), "{:?}", sizes.collect::<Vec<_>>());
    }

    #[test]
    fn shares_that_make_no_sense_are_refused() {
        for bad in ["", "1", "0/4", "5/4", "1/0", "a/b", "-1/4", "1/4/2", "1/1000001"] {
            assert!(bad.parse::<Shard>().is_err(), "{bad}");
        }
        assert_eq!("2/8".parse::<Shard>().unwrap().folder(), "2-of-8");
    }
}
