//! What rooms are called: the texts in them.
//!
//! Texts that stand close and in one direction are a block. Its lines make a name, but for what is a measure; of several
//! blocks the one in the largest letters names the room.

use super::measures;
use planform_sdk::{Point, Polygon, Text};
use std::cmp::Ordering;

/// A text that was read with less confidence is none.
const LEAST_CONFIDENCE: f64 = 0.5;

/// Texts of one block differ in direction by at most this, radians.
const TURN: f64 = 0.2;

/// And in the height of their letters by at most this factor: a plan writes areas smaller than names.
const GROWTH: f64 = 2.0;

/// Two lines of a block are at most this many heights of their letters apart, middle to middle.
const SPACING: f64 = 2.0;

/// Two texts of a line have at most this many heights of their letters between them.
const BLANK: f64 = 1.5;

/// Heights are taken for the same if they differ by less than this factor: letters with and without descenders.
const SAME_HEIGHT: f64 = 1.3;

/// What plans say to those who read them is no room's name.
const REMARKS: [&str; 8] = [
    "you are here",
    "sie sind hier",
    "ihr standort",
    "standort",
    "vous êtes ici",
    "vous etes ici",
    "voi siete qui",
    "usted está aquí",
];

/// What the document says of a room.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Called {
    /// Its name or number.
    pub name: Option<String>,
    /// Its floor area, square metres.
    pub stated_area: Option<f64>,
}

/// What the texts say of the room with this floor. Texts that lie outside of it say nothing, wherever they point.
pub fn of_room(texts: &[Text], floor: &Polygon) -> Called {
    let inside = texts.iter().filter(|t| is_said(t) && floor.contains(middle(t)));
    let centre = centre(floor);
    let mut blocks: Vec<Block> = blocks(inside.collect()).into_iter().map(|b| Block::of(b, centre)).collect();
    blocks.sort_by(Block::rank);
    let name = blocks.iter().find(|b| b.is_name()).map(|b| b.name.clone());
    Called { name, stated_area: blocks.iter().find_map(|b| b.area) }
}

/// Whether a text was read well enough and says anything.
pub fn is_said(text: &Text) -> bool {
    text.confidence >= LEAST_CONFIDENCE && text.content.contains(char::is_alphanumeric)
}

fn middle(text: &Text) -> Point {
    Point::new(text.pose.x, text.pose.y)
}

/// The middle of a floor's box.
fn centre(floor: &Polygon) -> Point {
    planform_sdk::bounds(floor.exterior.iter().copied())
        .map_or(Point::default(), |(low, high)| low.midpoint(high))
}

/// What a block says.
struct Block {
    name: String,
    area: Option<f64>,
    /// Of its largest letters, metres.
    height: f64,
    /// From the room's middle, metres.
    distance: f64,
}

impl Block {
    fn of(texts: Vec<&Text>, centre: Point) -> Self {
        let distance = texts.iter().map(|t| middle(t).distance(centre)).fold(f64::INFINITY, f64::min);
        let mut block = Self { name: String::new(), area: None, height: 0.0, distance };
        for text in in_reading_order(texts) {
            let parted = measures::part(&text.content);
            block.area = block.area.or(parted.area);
            if !parted.words.is_empty() && continues(&block.name, &parted.words) {
                let blank = if block.name.is_empty() { "" } else { " " };
                block.name = [block.name.as_str(), blank, parted.words.as_str()].concat();
                block.height = block.height.max(text.height);
            }
        }
        block
    }

    fn is_name(&self) -> bool {
        !self.name.is_empty() && !REMARKS.contains(&self.name.to_lowercase().as_str())
    }

    /// Those with names first, then the larger ones; of the same size words before bare numbers, then the more central.
    fn rank(&self, other: &Self) -> Ordering {
        let step = |b: &Self| (b.height.max(1e-6).ln() / SAME_HEIGHT.ln()).round() as i64;
        let key = |b: &Self| (b.name.is_empty(), -step(b), !b.name.contains(char::is_alphabetic));
        key(self).cmp(&key(other)).then(self.distance.total_cmp(&other.distance))
    }
}

/// Whether words go on with a name. Numbers do where it has none yet, "Office" "12", if they are not sizes whose unit is
/// missing or was not read: several of them, or one with one decimal, as areas have.
fn continues(name: &str, words: &str) -> bool {
    if name.is_empty() || words.contains(char::is_alphabetic) {
        return true;
    }
    let numbers = words.split_whitespace().count();
    let decimals = words.rsplit_once(['.', ',']).map_or(0, |(_, d)| d.chars().count());
    let is_size = numbers > 1 || decimals == 1;
    !is_size && !name.contains(|c: char| c.is_ascii_digit())
}

/// The texts that stand close, by the order of their first ones.
fn blocks(texts: Vec<&Text>) -> Vec<Vec<&Text>> {
    let mut blocks: Vec<Vec<&Text>> = Vec::new();
    for text in texts {
        let (near, mut apart): (Vec<_>, Vec<_>) =
            blocks.into_iter().partition(|block| block.iter().any(|t| stand_close(t, text)));
        apart.push(near.into_iter().flatten().chain([text]).collect());
        blocks = apart;
    }
    blocks
}

/// Whether two texts are of one block: lines over each other, or words of a line.
fn stand_close(a: &Text, b: &Text) -> bool {
    let (low, high) = (a.height.min(b.height), a.height.max(b.height));
    let turned = (a.pose.yaw - b.pose.yaw).cos() >= TURN.cos();
    let [along, across] = offset(a, b);
    let gap = along.abs() - (a.width + b.width) / 2.0;
    let beneath = gap < 0.0 && across.abs() <= SPACING * high;
    let beside = across.abs() <= low / 2.0 && gap <= BLANK * high;
    turned && high <= GROWTH * low && (beneath || beside)
}

/// From one text's middle to another's, along the first one's reading direction and upwards across it.
fn offset(from: &Text, to: &Text) -> [f64; 2] {
    let (x, y) = (to.pose.x - from.pose.x, to.pose.y - from.pose.y);
    let (sin, cos) = from.pose.yaw.sin_cos();
    [x * cos + y * sin, y * cos - x * sin]
}

/// Lines from the top, and each line from its beginning.
fn in_reading_order(mut texts: Vec<&Text>) -> Vec<&Text> {
    let Some(&first) = texts.first() else { return texts };
    texts.sort_by(|a, b| offset(first, b)[1].total_cmp(&offset(first, a)[1]));
    let mut lines: Vec<Vec<&Text>> = Vec::new();
    for text in texts {
        match lines.last_mut() {
            Some(line) if offset(line[0], text)[1].abs() <= line[0].height.min(text.height) / 2.0 => {
                line.push(text)
            }
            _ => lines.push(vec![text]),
        }
    }
    lines
        .iter_mut()
        .for_each(|line| line.sort_by(|a, b| offset(first, a)[0].total_cmp(&offset(first, b)[0])));
    lines.concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose;
    use std::f64::consts::FRAC_PI_2;

    fn text(content: &str, x: f64, y: f64, height: f64) -> Text {
        let width = 0.6 * height * content.chars().count() as f64;
        Text { content: content.into(), pose: Pose { x, y, yaw: 0.0 }, width, height, confidence: 0.9 }
    }

    fn named(texts: &[Text]) -> Called {
        let room = [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]].map(Point::from).to_vec();
        of_room(texts, &Polygon::new(room, vec![]))
    }

    fn name(texts: &[Text]) -> String {
        named(texts).name.unwrap_or_default()
    }

    #[test]
    fn lines_of_a_block_are_joined_from_the_top() {
        let texts =
            [text("Room", 3.0, 2.0, 0.2), text("Meeting", 3.0, 2.3, 0.2), text("12.5 m²", 3.0, 1.7, 0.15)];
        assert_eq!(named(&texts), Called { name: Some("Meeting Room".into()), stated_area: Some(12.5) });
    }

    #[test]
    fn words_of_a_line_are_joined_in_its_direction() {
        assert_eq!(name(&[text("3", 3.6, 2.0, 0.2), text("OFFICE", 3.0, 2.01, 0.2)]), "OFFICE 3");
        let mut upwards = [text("B", 3.0, 2.3, 0.2), text("A", 3.0, 2.0, 0.2)];
        upwards.iter_mut().for_each(|t| t.pose.yaw = FRAC_PI_2);
        assert_eq!(name(&upwards), "A B");
    }

    #[test]
    fn the_largest_block_names_the_room_then_words_then_the_middle() {
        assert_eq!(name(&[text("desk", 3.0, 2.0, 0.1), text("210", 1.0, 3.5, 0.3)]), "210");
        assert_eq!(name(&[text("3450", 3.0, 2.0, 0.2), text("Kitchen", 1.0, 3.5, 0.2)]), "Kitchen");
        assert_eq!(name(&[text("left", 1.0, 3.5, 0.2), text("middle", 3.0, 2.0, 0.2)]), "middle");
    }

    #[test]
    fn a_name_has_one_number_and_no_size() {
        for (number, all) in
            [("12", "Office 12"), ("2.14", "Office 2.14"), ("45.4", "Office"), ("2.31 2.21", "Office")]
        {
            assert_eq!(name(&[text("Office", 3.0, 2.3, 0.2), text(number, 3.0, 2.0, 0.2)]), all);
        }
        let three = [text("Office", 3.0, 2.3, 0.2), text("05", 3.0, 2.0, 0.2), text("8", 3.0, 1.7, 0.2)];
        assert_eq!(name(&three), "Office 05");
    }

    #[test]
    fn scraps_and_what_lies_outside_are_no_names() {
        let faint = Text { confidence: 0.2, ..text("Hall", 3.0, 2.0, 0.2) };
        assert_eq!(named(&[faint, text(".", 3.0, 2.0, 0.2), text("Lift", 7.0, 2.0, 0.2)]), Called::default());
        assert_eq!(named(&[text("4.2 x 3.1 m", 3.0, 2.0, 0.2)]).name, None);
    }

    #[test]
    fn a_remark_is_no_name() {
        assert_eq!(name(&[text("You are here", 3.0, 3.5, 0.2), text("104", 3.0, 2.0, 0.2)]), "104");
        assert_eq!(named(&[text("SIE SIND HIER", 3.0, 3.5, 0.2)]).name, None);
    }

    #[test]
    fn an_area_that_stands_alone_is_stated() {
        let called = named(&[text("Lab", 3.0, 3.0, 0.2), text("24 m²", 3.0, 0.5, 0.2)]);
        assert_eq!(called, Called { name: Some("Lab".into()), stated_area: Some(24.0) });
    }

    #[test]
    fn sizes_that_are_no_numbers_are_survived() {
        let odd = Text { width: f64::NAN, height: f64::NAN, ..text("x", 3.0, 2.0, 0.2) };
        assert_eq!(name(&[odd.clone(), odd]), "x");
    }
}
