//! The layers `texts` and `scale`.

use crate::element::{layer, number, with_text};
use crate::rooms::ems;
use crate::sheet::Sheet;
use planform_sdk::{Layout, Point, Text};
use svg::Node;
use svg::node::element::{Element, Group, Rectangle};

/// Height of lettering whose box has no size, metres.
const LETTERING: f64 = 0.2;

/// The layer `texts`: what the document says, where it says it. With `labelled`, what a room's label shows is hidden.
pub fn texts(layout: &Layout, labelled: bool, sheet: &Sheet) -> Group {
    let repeated = |t: &Text| labelled && layout.rooms.iter().any(|room| room.is_called(t));
    let class = |t: &Text| if repeated(t) { "text named" } else { "text" };
    (1..).zip(&layout.texts).map(|(n, t)| text(n, t, class(t), sheet)).fold(layer("texts"), Group::add)
}

fn text(number_of: usize, text: &Text, class: &str, sheet: &Sheet) -> Element {
    let middle = sheet.place(Point::new(text.pose.x, text.pose.y));
    let fitting = text.height.min(text.width / ems(&text.content));
    let size = if fitting > 0.0 { fitting } else { LETTERING };
    let mut element = with_text("text", &text.content);
    // The sheet's y runs down, so that the map's counter-clockwise is negative on it.
    let turn = -text.pose.yaw.to_degrees();
    let (x, y) = (number(middle.x), number(middle.y));
    element.assign("transform", format!("rotate({} {x} {y})", number(turn)));
    element.assign("id", format!("text-{number_of}"));
    element.assign("class", class);
    element.assign("font-size", number(size));
    element.assign("y", number(middle.y + 0.35 * size));
    element.assign("x", x);
    element
}

/// The layer `scale`: a bar of a round length in the lower left corner.
pub fn scale(sheet: &Sheet) -> Group {
    let length = round_length(sheet.width / 3.0);
    let unit = 0.01 * sheet.size();
    let corner = Point::new(3.0 * unit, sheet.height - 3.0 * unit);
    let mut label = with_text("text", &format!("{} m", number(length)));
    label.assign("class", "scale-label");
    label.assign("font-size", number(2.0 * unit));
    label.assign("x", number(corner.x + length + unit));
    label.assign("y", number(corner.y + 1.2 * unit));
    let part = |i: u8| {
        Rectangle::new()
            .set("class", if i.is_multiple_of(2) { "bar dark" } else { "bar light" })
            .set("x", number(corner.x + f64::from(i) * length / 4.0))
            .set("y", number(corner.y))
            .set("width", number(length / 4.0))
            .set("height", number(unit))
    };
    (0..4).map(part).fold(layer("scale"), Group::add).add(label)
}

/// The longest of 1, 2, 5, 10, 20, 50, ... metres and their tenths that is not above `most`.
fn round_length(most: f64) -> f64 {
    let decade = 10_f64.powf(most.log10().floor());
    let fitting = [5.0, 2.0].into_iter().map(|f| f * decade).find(|&l| l <= most);
    fitting.unwrap_or(decade)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose;

    #[test]
    fn bar_has_a_round_length() {
        for (most, length) in
            [(1.0, 1.0), (1.9, 1.0), (2.0, 2.0), (4.99, 2.0), (9.0, 5.0), (70.0, 50.0), (0.3, 0.2)]
        {
            assert!((round_length(most) - length).abs() < 1e-9, "{most}");
        }
    }

    #[test]
    fn text_without_a_box_is_still_set() {
        let sheet = Sheet { origin: Point::default(), width: 1.0, height: 1.0 };
        for (width, height) in [(0.0, 0.0), (1.0, -1.0), (f64::NAN, 0.0)] {
            let t = Text { content: "x".into(), pose: Pose::default(), width, height, confidence: 1.0 };
            assert!(text(1, &t, "text", &sheet).to_string().contains("font-size=\"0.2\""));
        }
    }
}
