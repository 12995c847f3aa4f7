//! Texts of a drawing: TEXT, ATTRIB and MTEXT, without their codes.

use super::drawing::Entity;
use super::plane::{Map, Point};

/// A letter is about as wide as this for a height of 1.
const LETTER_WIDTH: f64 = 0.85;
/// From line to line, for a height of 1.
const LINE: f64 = 1.6;
/// The height of letters where nothing is said.
const HEIGHT: f64 = 1.0;

/// A line of text; lengths in the drawing's units, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct Words {
    pub content: String,
    pub centre: Point,
    /// Counter-clockwise, radians.
    pub angle: f64,
    pub width: f64,
    pub height: f64,
}

/// The lines of a text entity, seen through a map; none of another one.
pub fn words(entity: &Entity<'_>, map: Map) -> Vec<Words> {
    match entity.kind {
        "TEXT" | "ATTRIB" => single(entity, map).into_iter().collect(),
        "MTEXT" => several(entity, map),
        _ => vec![],
    }
}

fn single(entity: &Entity<'_>, map: Map) -> Option<Words> {
    let content = plain(entity.text(1)?);
    let height = entity.number(40).filter(|h| *h > 0.0).unwrap_or(HEIGHT);
    let width = width(&content, height) * entity.number(41).filter(|f| *f > 0.0).unwrap_or(1.0);
    // ATTRIB has its vertical alignment elsewhere.
    let (across, up) = (entity.flags(72), entity.flags(if entity.kind == "TEXT" { 73 } else { 74 }));
    let second = (across != 0 || up != 0).then(|| entity.point(11)).flatten();
    let at = second.or_else(|| entity.point(10))?;
    let right = match across {
        1 | 4 => 0.0,
        2 => -0.5,
        // Fitted between two points, of which the second one was taken.
        3 | 5 => -0.5,
        _ => 0.5,
    };
    let above = match (across, up) {
        (4, _) | (_, 2) => 0.0,
        (_, 3) => -0.5,
        _ => 0.5,
    };
    let angle = entity.number(50).unwrap_or(0.0).to_radians();
    placed(content, at, angle, [right * width, above * height], [width, height], map)
}

fn several(entity: &Entity<'_>, map: Map) -> Vec<Words> {
    // Long texts are cut into pieces of 250 letters, of which the last has code 1.
    let text: String = entity.pairs.iter().filter(|p| matches!(p.code, 1 | 3)).map(|p| p.value).collect();
    let height = entity.number(40).filter(|h| *h > 0.0).unwrap_or(HEIGHT);
    let turned = entity.point(11).map(|[x, y]| y.atan2(x));
    let angle = turned.unwrap_or_else(|| entity.number(50).unwrap_or(0.0).to_radians());
    let Some(at) = entity.point(10) else { return vec![] };
    let lines = unformatted(&text);
    let whole = height + LINE * height * lines.len().saturating_sub(1) as f64;
    // One to nine, from the upper left to the lower right: what lies at the point.
    let anchor = entity.flags(71).clamp(1, 9) - 1;
    let top = match anchor / 3 {
        0 => 0.0,
        1 => whole / 2.0,
        _ => whole,
    };
    let line = |(i, content): (usize, &String)| {
        let width = width(content, height);
        let right = (1 - anchor % 3) as f64 * width / 2.0;
        let above = top - height / 2.0 - LINE * height * i as f64;
        placed(content.clone(), at, angle, [right, above], [width, height], map)
    };
    lines.iter().enumerate().filter_map(line).collect()
}

/// Words of this size whose middle lies `offset` from a point, along and across their direction.
fn placed(content: String, at: Point, angle: f64, offset: Point, size: [f64; 2], map: Map) -> Option<Words> {
    let centre = map.after(Map::shift(at)).after(Map::turn(angle)).at(offset);
    let [dx, dy] = map.after(Map::turn(angle)).turned([1.0, 0.0]);
    let [width, height] = size.map(|side| side * map.growth());
    let sound = centre.iter().chain([&width, &height]).all(|v| v.is_finite());
    (sound && !content.is_empty()).then(|| Words { content, centre, angle: dy.atan2(dx), width, height })
}

fn width(content: &str, height: f64) -> f64 {
    content.chars().count() as f64 * height * LETTER_WIDTH
}

/// A text's codes as letters: `%%d` is a degree sign.
fn plain(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (letters, length) = code(rest).unwrap_or_else(|| (c.to_string(), c.len_utf8()));
        out.push_str(&letters);
        rest = &rest[length..];
    }
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The letters that a code at the start stands for, and its length.
fn code(text: &str) -> Option<(String, usize)> {
    let after = text.strip_prefix("%%")?;
    if let Some(number) = after.get(..3).and_then(|n| n.parse::<u8>().ok()) {
        return Some((char::from(number).to_string(), 5));
    }
    let letters = match after.chars().next()?.to_ascii_lowercase() {
        'd' => "°",
        'p' => "±",
        'c' => "ø",
        '%' => "%",
        'u' | 'o' | 'k' => "",
        _ => return None,
    };
    Some((letters.to_owned(), 3))
}

/// The lines of a formatted text: `{\fArial|b0;Room}\P12` is `Room` and `12`.
fn unformatted(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut letters = text.chars();
    while let Some(c) = letters.next() {
        let line = lines.len() - 1;
        match c {
            '{' | '}' => {}
            '\\' => match letters.next() {
                Some('P' | 'X' | 'N') => lines.push(String::new()),
                Some('~') => lines[line].push(' '),
                Some(escaped @ ('\\' | '{' | '}')) => lines[line].push(escaped),
                Some('S') => {
                    let pair: String = letters.by_ref().take_while(|&c| c != ';').collect();
                    lines[line].push_str(&stacked(&pair));
                }
                Some('L' | 'l' | 'O' | 'o' | 'K' | 'k') | None => {}
                // A font, a colour, a height: up to a semicolon.
                Some(_) => letters.by_ref().take_while(|&c| c != ';').for_each(drop),
            },
            '\t' => lines[line].push(' '),
            c => lines[line].push(c),
        }
    }
    lines
        .iter()
        .map(|line| plain(&line.replace("^I", " ").replace("^J", " ")))
        .filter(|l| !l.is_empty())
        .collect()
}

/// One above the other, as in `1^2`: a fraction, or with nothing below an exponent.
fn stacked(pair: &str) -> String {
    match pair.split_once(['^', '#', '/']).map(|(above, below)| (above.trim(), below.trim())) {
        Some(("2", "")) => "²".to_owned(),
        Some((above, "")) => above.to_owned(),
        Some((above, below)) => format!("{above}/{below}"),
        None => pair.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::pairs::pairs;
    use super::*;

    fn of(kind: &str, fields: &[(i32, &str)]) -> Vec<Words> {
        let text: String = fields.iter().map(|(code, value)| format!("{code}\n{value}\n")).collect();
        let pairs = pairs(&text).unwrap();
        words(&Entity { kind, pairs: &pairs, parts: &[] }, Map::SAME)
    }

    #[test]
    fn codes_are_letters() {
        assert_eq!(plain("%%uArea%%u 12 m%%178 90%%d 100%%% %%c5"), "Area 12 m² 90° 100% ø5");
        assert_eq!(plain("50%"), "50%");
        assert_eq!(
            unformatted(r"{\fArial|b0|i0;\H2.5x;Room}\P12\~m\S2^ ; \\ \{a\} \S1^2;"),
            ["Room", r"12 m² \ {a} 1/2"]
        );
        assert_eq!(unformatted(r"\C1"), [""; 0]);
    }

    #[test]
    fn texts_stand_where_they_are_aligned() {
        let left = of("TEXT", &[(10, "1"), (20, "2"), (40, "2"), (1, "ab")]);
        assert_eq!((left[0].centre, left[0].height), ([1.0 + left[0].width / 2.0, 3.0], 2.0));
        let middle = of(
            "TEXT",
            &[(10, "1"), (20, "2"), (11, "5"), (21, "6"), (40, "2"), (72, "1"), (73, "2"), (1, "ab")],
        );
        assert_eq!(middle[0].centre, [5.0, 6.0]);
        let turned = of("TEXT", &[(10, "0"), (20, "0"), (40, "2"), (50, "90"), (1, "ab")]);
        assert!((turned[0].centre[1] - turned[0].width / 2.0).abs() < 1e-9 && turned[0].centre[0] < 0.0);
    }

    #[test]
    fn lines_of_formatted_texts_stand_below_each_other() {
        let lines = of("MTEXT", &[(10, "0"), (20, "0"), (40, "1"), (71, "5"), (3, "Ro"), (1, "om\\P12")]);
        let contents: Vec<_> = lines.iter().map(|l| l.content.as_str()).collect();
        assert_eq!(contents, ["Room", "12"]);
        assert!(
            (lines[0].centre[1] - 0.8).abs() < 1e-9 && (lines[1].centre[1] + 0.8).abs() < 1e-9,
            "{lines:?}"
        );
    }
}
