//! Doors, passages, frontiers, texts, and symbols that are but named.

use crate::entity::{Entity, Shape, Value};
use crate::layer::Layer;
use crate::symbols;
use crate::text::one_line;
use planform_sdk::{Frontier, FrontierKind, Layout, Opening, OpeningKind, Point, Pose, Symbol, Text};

/// Height of letters where the document gives none, metres.
const LETTER_HEIGHT: f64 = 0.2;

/// A door or passage: the line between its jambs.
pub fn opening(opening: &Opening) -> Entity {
    let kind = match opening.kind {
        OpeningKind::Door => "door",
        OpeningKind::Passage => "passage",
    };
    let data = vec![
        ("kind", kind.into()),
        ("width", opening.width().into()),
        ("from", opening.rooms[0].into()),
        ("to", opening.rooms[1].into()),
    ];
    Entity { layer: Layer::Door, shape: Shape::Line(opening.segment), data }
}

/// A frontier of a partial room.
pub fn frontier(frontier: &Frontier) -> Entity {
    let leads = match frontier.leads {
        FrontierKind::Room => "room",
        FrontierKind::Space => "space",
    };
    let data = vec![
        ("kind", "frontier".into()),
        ("room", frontier.room.into()),
        ("leads", leads.into()),
        ("area", frontier.area.into()),
    ];
    Entity { layer: Layer::Frontier, shape: Shape::Line(frontier.segment), data }
}

/// The texts of the document that no room's label shows already.
pub fn texts(layout: &Layout) -> impl Iterator<Item = Entity> {
    let said = |t: &&Text| !layout.rooms.iter().any(|room| room.is_called(t));
    layout.texts.iter().filter(said).filter_map(text)
}

/// A text of the document; nothing for a blank one.
fn text(text: &Text) -> Option<Entity> {
    let data = vec![
        ("kind", "text".into()),
        ("content", one_line(&text.content).trim().into()),
        ("width", text.width.into()),
        ("height", text.height.into()),
        ("confidence", text.confidence.into()),
    ];
    note(&text.content, text.pose, text.height, data)
}

/// The name of a symbol of the document, for one that there is no drawing of.
pub fn symbol(number: u32, symbol: &Symbol) -> Vec<Entity> {
    let height = symbol.height.min(LETTER_HEIGHT);
    note(&symbol.kind, symbol.pose, height, symbols::data(number, symbol)).into_iter().collect()
}

fn note(content: &str, pose: Pose, height: f64, data: Vec<(&'static str, Value)>) -> Option<Entity> {
    let line = one_line(content).trim().to_owned();
    let letters = if height > 0.0 { height } else { LETTER_HEIGHT };
    let shape = Shape::Text {
        middle: Point::new(pose.x, pose.y),
        yaw: pose.yaw,
        height: letters,
        content: line.clone(),
    };
    (!line.is_empty()).then_some(Entity { layer: Layer::Annotation, shape, data })
}
