//! How often each tone occurs.

use super::sample::{CLEAR, Code, Tone};
use std::ops::Range;

/// A flat tone varies by at most this much, also where it was compressed.
pub const FLAT: u8 = 3;

/// How many pixels have each tone, and how many are transparent.
#[derive(Debug)]
pub struct Counts([usize; CLEAR as usize + 1]);

/// A flat tone and the share of the places looked at that have it.
#[derive(Debug, Clone, Copy)]
pub struct Common {
    /// The tone; nothing where most is transparent.
    pub tone: Tone,
    /// The share.
    pub share: f64,
}

impl Counts {
    /// Of these pixels.
    pub fn of<'a>(codes: impl IntoIterator<Item = &'a Code>) -> Self {
        let mut counts = [0; CLEAR as usize + 1];
        codes.into_iter().for_each(|&code| counts[usize::from(code)] += 1);
        Self(counts)
    }

    /// All pixels, the transparent ones included.
    pub fn all(&self) -> usize {
        self.0.iter().sum()
    }

    /// The pixels of these tones.
    pub fn sum(&self, tones: Range<Code>) -> usize {
        self.0[usize::from(tones.start)..usize::from(tones.end)].iter().sum()
    }

    /// The pixels of these tones alone.
    pub fn within(&self, tones: Range<Code>) -> Self {
        let mut kept = [0; CLEAR as usize + 1];
        let tones = usize::from(tones.start)..usize::from(tones.end);
        kept[tones.clone()].copy_from_slice(&self.0[tones]);
        Self(kept)
    }

    /// The most common flat tone.
    pub fn common(&self) -> Common {
        let near = |tone| self.sum(flat(tone));
        // Of the tones around which as many lie, the most common one.
        let key = |&tone: &u8| (near(tone), self.0[usize::from(tone)]);
        let best = (0..=u8::MAX).max_by_key(key).unwrap_or(u8::MAX);
        let clear = self.0[usize::from(CLEAR)];
        let (tone, count) = if clear > near(best) { (None, clear) } else { (Some(best), near(best)) };
        Common { tone, share: count as f64 / self.all().max(1) as f64 }
    }
}

/// The tones that are one flat tone with this one.
pub fn flat(tone: u8) -> Range<Code> {
    tone.saturating_sub(FLAT).into()..above(tone, FLAT).start
}

/// The tones that are lighter than this one by more than `by`.
pub fn above(tone: u8, by: u8) -> Range<Code> {
    Code::from(tone.saturating_add(by)) + 1..CLEAR
}
