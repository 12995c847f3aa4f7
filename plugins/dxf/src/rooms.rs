//! Rooms as closed polylines, and their labels.

use crate::entity::{Entity, LETTER_WIDTH, Shape, Value};
use crate::layer::Layer;
use crate::pole::pole;
use crate::text::lines;
use planform_sdk::{Point, Polygon, Room, RoomState};

/// Height of a label's letters where there is space enough, metres.
const LARGEST_LETTER: f64 = 0.25;
/// Height below which a label is no longer made smaller, metres.
const SMALLEST_LETTER: f64 = 0.02;
/// From one line of a label to the next, for a letter height of 1.
const LINE_SPACING: f64 = 1.6;

/// The room's rings and its label. `polygon` is the one of the room's polygons that is drawn.
pub fn draw(room: &Room, polygon: &Polygon) -> Vec<Entity> {
    let mut entities: Vec<_> = polygon
        .rings()
        .enumerate()
        .map(|(i, points)| Entity {
            layer: Layer::Area,
            shape: Shape::Ring(points.to_vec()),
            data: ring_data(room, polygon, if i == 0 { "outer" } else { "hole" }),
        })
        .collect();
    entities.extend(label(room, polygon));
    entities
}

fn ring_data(room: &Room, polygon: &Polygon, role: &str) -> Vec<(&'static str, Value)> {
    let state = match room.state {
        RoomState::Complete => "complete",
        RoomState::Partial => "partial",
    };
    let mut data = vec![
        ("kind", "room".into()),
        ("room", room.id.into()),
        ("ring", role.into()),
        ("state", state.into()),
        ("area", polygon.area().into()),
    ];
    data.extend(room.name.as_deref().filter(|n| !n.trim().is_empty()).map(|n| ("name", n.into())));
    data
}

fn label(room: &Room, polygon: &Polygon) -> Vec<Entity> {
    let Some((middle, radius)) = pole(polygon) else { return vec![] };
    let lines = label_lines(room, polygon.area());
    let height = letter_height(&lines, radius);
    let top = middle.y + height * LINE_SPACING * (lines.len() - 1) as f64 / 2.0;
    let line_of = |(i, content)| {
        let middle = Point::new(middle.x, top - height * LINE_SPACING * i as f64);
        let shape = Shape::Text { middle, yaw: 0.0, height, content };
        Entity {
            layer: Layer::AreaLabel,
            shape,
            data: vec![("kind", "label".into()), ("room", room.id.into())],
        }
    };
    lines.into_iter().enumerate().map(line_of).collect()
}

fn label_lines(room: &Room, area: f64) -> Vec<String> {
    let mut lines = room.name.as_deref().map(lines).unwrap_or_default();
    if lines.is_empty() {
        lines.push(format!("Room {}", room.id));
    }
    let note = if room.state == RoomState::Partial { " (partial)" } else { "" };
    // Not a superscript: many readers leave the escapes of old versions as they are.
    lines.push(format!("{area:.1} m2{note}"));
    lines
}

/// The height at which the lines fit into a circle of this radius.
fn letter_height(lines: &[String], radius: f64) -> f64 {
    let longest = lines.iter().map(|l| l.chars().count()).max().unwrap_or(1).max(1);
    let diagonal = (LETTER_WIDTH * longest as f64).hypot(LINE_SPACING * lines.len() as f64);
    (2.0 * radius / diagonal).clamp(SMALLEST_LETTER, LARGEST_LETTER)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, side: f64) -> Vec<Point> {
        [[x, y], [x + side, y], [x + side, y + side], [x, y + side]].map(Point::from).to_vec()
    }

    fn room(name: Option<&str>) -> Room {
        let inner = Polygon::new(square(0.0, 0.0, 4.0), vec![square(1.5, 1.5, 1.0)]);
        let name = name.map(Into::into);
        Room { id: 3, name, stated_area: None, state: RoomState::Partial, centre: inner.clone(), inner }
    }

    fn texts(entities: &[Entity]) -> Vec<&str> {
        entities
            .iter()
            .filter_map(|e| match &e.shape {
                Shape::Text { content, .. } => Some(content.as_str()),
                _ => None,
            })
            .collect()
    }

    #[test]
    fn each_ring_says_its_role_and_the_net_area() {
        let room = room(Some("Küche"));
        let rings: Vec<_> = draw(&room, &room.inner).into_iter().filter(|e| e.layer == Layer::Area).collect();
        assert_eq!(rings.len(), 2);
        for (ring, role) in rings.iter().zip(["outer", "hole"]) {
            assert!(ring.data.contains(&("ring", role.into())) && ring.data.contains(&("area", 15.0.into())));
            assert!(ring.data.contains(&("name", "Küche".into())));
        }
    }

    #[test]
    fn labels_lie_inside_and_have_a_line_for_each_line() {
        let room = room(Some("Küche\nund Bad"));
        let entities = draw(&room, &room.inner);
        assert_eq!(texts(&entities), ["Küche", "und Bad", "15.0 m2 (partial)"]);
        for entity in &entities {
            if let Shape::Text { middle, .. } = &entity.shape {
                assert!(room.inner.contains(*middle));
            }
        }
    }

    #[test]
    fn rooms_without_a_name_are_numbered() {
        for name in [None, Some(""), Some(" \n")] {
            let room = room(name);
            let entities = draw(&room, &room.inner);
            assert_eq!(texts(&entities)[0], "Room 3");
            assert!(entities[0].data.iter().all(|(key, _)| *key != "name"));
        }
    }
}
