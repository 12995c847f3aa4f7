//! Letters that follow each other become lines of text.

use super::glyphs::Letter;
use crate::found::SheetText;
use hayro::kurbo::Vec2;

/// All lengths in em of the line's letters.
///
/// A gap wider than this parts two words, and one wider than that two texts.
const WORD_GAP: f64 = 0.18;
const TEXT_GAP: f64 = 1.2;
/// A letter may overlap the one before it (kerning) by this much.
const OVERLAP: f64 = 0.5;
/// How far letters of one line may lie beside its baseline.
const BASELINE: f64 = 0.25;
/// How much the sizes of letters of one line may differ, as a part.
const SIZES: f64 = 0.25;
/// How far the directions of letters of one line may differ, radians.
const DIRECTIONS: f64 = 0.05;
/// Confidence in texts that are drawn, and in those that some program recognised in a scan.
const DRAWN: f64 = 1.0;
const RECOGNISED: f64 = 0.8;

/// A line that letters are added to.
struct Line<'a> {
    first: &'a Letter,
    last: &'a Letter,
    content: String,
    /// Along the first letter's up, in its em.
    reach: [f64; 2],
    readable: bool,
}

/// The lines of these letters, in the order of the document. Lengths are multiplied by `per_unit`. Lines in which a letter
/// cannot be told are left out.
pub fn lines(letters: &[Letter], per_unit: f64) -> Vec<SheetText> {
    let mut lines: Vec<Line<'_>> = vec![];
    for letter in letters {
        match lines.last_mut().and_then(|line| line.gap(letter).map(|gap| (line, gap))) {
            Some((line, gap)) => line.add(letter, gap),
            None => lines.push(Line::new(letter)),
        }
    }
    lines.iter().filter_map(|line| line.text(per_unit)).collect()
}

impl<'a> Line<'a> {
    fn new(letter: &'a Letter) -> Self {
        let content = letter.content.clone();
        let readable = content.is_some();
        Self {
            first: letter,
            last: letter,
            content: content.unwrap_or_default(),
            reach: letter.reach,
            readable,
        }
    }

    /// How far behind this line's end the letter begins, in em, if it continues the line.
    fn gap(&self, letter: &Letter) -> Option<f64> {
        let em = self.last.up.hypot();
        let along = direction(self.last)?;
        let step = letter.from - self.last.to;
        let [ahead, beside] = [step.dot(along) / em, step.cross(along).abs() / em];
        let same_size = (letter.up.hypot() / em - 1.0).abs() <= SIZES;
        let same_direction =
            along.cross(direction(letter)?).abs() <= DIRECTIONS && along.dot(direction(letter)?) > 0.0;
        let near = (-OVERLAP..=TEXT_GAP).contains(&ahead) && beside <= BASELINE;
        let like = same_size && same_direction && self.last.visible == letter.visible;
        (near && like).then_some(ahead)
    }

    fn add(&mut self, letter: &'a Letter, gap: f64) {
        if gap > WORD_GAP {
            self.content.push(' ');
        }
        match &letter.content {
            Some(content) => self.content.push_str(content),
            None => self.readable = false,
        }
        self.reach = [self.reach[0].min(letter.reach[0]), self.reach[1].max(letter.reach[1])];
        self.last = letter;
    }

    fn text(&self, per_unit: f64) -> Option<SheetText> {
        let words: Vec<_> = self.content.split_whitespace().collect();
        let along = self.last.to - self.first.from;
        let direction = if along.hypot() > 0.0 { along } else { direction(self.first)? };
        let [low, high] = self.reach.map(|r| self.first.up * r);
        let centre = (self.first.from + along / 2.0 + (low + high) / 2.0).to_vec2() * per_unit;
        (self.readable && !words.is_empty()).then(|| SheetText {
            content: words.join(" "),
            centre: [centre.x, centre.y],
            angle: direction.y.atan2(direction.x),
            width: along.hypot() * per_unit,
            height: (high - low).hypot() * per_unit,
            confidence: if self.first.visible { DRAWN } else { RECOGNISED },
        })
    }
}

/// The reading direction: along the advance, or where there is none square to up.
fn direction(letter: &Letter) -> Option<Vec2> {
    let along = letter.to - letter.from;
    let along = if along.hypot() > 0.0 { along } else { Vec2::new(-letter.up.y, letter.up.x) };
    let length = along.hypot();
    (length > 0.0 && length.is_finite()).then(|| along / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use hayro::kurbo::Point;

    /// Letters half an em wide, of size 10, at these places, read to the right.
    fn letters(places: &[(char, f64, f64)]) -> Vec<Letter> {
        let letter = |&(c, x, y): &(char, f64, f64)| Letter {
            content: (c != '?').then(|| c.to_string()),
            from: Point::new(x, y),
            to: Point::new(x + 5.0, y),
            up: Vec2::new(0.0, -10.0),
            reach: [0.0, 0.7],
            visible: true,
        };
        places.iter().map(letter).collect()
    }

    fn contents(places: &[(char, f64, f64)]) -> Vec<String> {
        lines(&letters(places), 2.0).into_iter().map(|t| t.content).collect()
    }

    #[test]
    fn gaps_part_words_and_texts() {
        assert_eq!(contents(&[('a', 0.0, 0.0), ('b', 5.5, 0.0), ('c', 14.0, 0.0)]), ["ab c"]);
        assert_eq!(contents(&[('a', 0.0, 0.0), (' ', 5.0, 0.0), ('c', 10.0, 0.0)]), ["a c"]);
        assert_eq!(contents(&[('a', 0.0, 0.0), ('b', 30.0, 0.0)]), ["a", "b"]);
        assert_eq!(contents(&[('a', 0.0, 0.0), ('b', 5.0, 12.0)]), ["a", "b"]);
    }

    #[test]
    fn lines_that_cannot_be_read_whole_are_left_out() {
        assert_eq!(contents(&[('a', 0.0, 0.0), ('?', 5.0, 0.0), ('b', 50.0, 0.0)]), ["b"]);
        assert_eq!(contents(&[(' ', 0.0, 0.0)]), [""; 0]);
    }

    #[test]
    fn boxes_are_in_pixels() {
        let line = &lines(&letters(&[('a', 10.0, 20.0), ('b', 15.0, 20.0)]), 2.0)[0];
        assert_eq!((line.centre, line.angle), ([30.0, 33.0], 0.0));
        assert_eq!((line.width, line.height), (20.0, 14.0));
    }
}
