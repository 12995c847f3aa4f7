//! Whether the words were read.

use super::{Count, scaled};
use planform_sdk::{Point, Pose, Text};
use planform_synth::PlanTruth;

/// The words of the plan, and how many of them stand in a found text at their place. Case and punctuation do not count;
/// the point in a number does.
pub fn read_right(found: &[Text], truth: &PlanTruth, factor: f64) -> Count {
    let mut found: Vec<Read> = found.iter().map(|t| Read::new(t, factor)).collect();
    let mut count = Count::default();
    for text in &truth.texts {
        let place = Place::new(&text.pose, text.width, text.height);
        for word in words(&text.content) {
            count.all += 1;
            count.right += usize::from(found.iter_mut().any(|f| f.place.meets(&place) && f.take(&word)));
        }
    }
    count
}

struct Read {
    place: Place,
    words: Vec<String>,
}

impl Read {
    fn new(text: &Text, factor: f64) -> Self {
        let Pose { x, y, yaw } = text.pose;
        let Point { x, y } = scaled(x, y, factor);
        let place = Place::new(&Pose { x, y, yaw }, text.width * factor, text.height * factor);
        Self { place, words: words(&text.content) }
    }

    /// Takes the word out of the text: a word counts once.
    fn take(&mut self, word: &str) -> bool {
        let at = self.words.iter().position(|w| w == word);
        at.map(|i| self.words.swap_remove(i)).is_some()
    }
}

/// A turned box.
struct Place {
    middle: Point,
    along: (f64, f64),
    half: (f64, f64),
}

impl Place {
    fn new(pose: &Pose, width: f64, height: f64) -> Self {
        let half = (width / 2.0, height / 2.0);
        Self { middle: Point::new(pose.x, pose.y), along: (pose.yaw.cos(), pose.yaw.sin()), half }
    }

    /// Whether either box contains the other's middle, with half a line to spare.
    fn meets(&self, other: &Self) -> bool {
        self.contains(other.middle) || other.contains(self.middle)
    }

    fn contains(&self, p: Point) -> bool {
        let (dx, dy, (x, y)) = (p.x - self.middle.x, p.y - self.middle.y, self.along);
        let spare = self.half.0.min(self.half.1);
        (dx * x + dy * y).abs() <= self.half.0 + spare && (dy * x - dx * y).abs() <= self.half.1 + spare
    }
}

/// The words of a text without what does not count.
pub fn words(text: &str) -> Vec<String> {
    let plain = |word: &str| {
        let kept = word.chars().map(|c| if c == '²' { '2' } else { c });
        let kept: String = kept.filter(|c| c.is_alphanumeric() || *c == '.').collect();
        kept.trim_matches('.').to_lowercase()
    };
    text.split_whitespace().map(plain).filter(|w| !w.is_empty()).collect()
}
