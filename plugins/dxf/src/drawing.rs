//! Everything that is drawn of a layout.

use crate::entity::Entity;
use crate::{annotations, rooms, walls};
use planform_sdk::{Boundary, Layout, Point, bounds};

/// The entities of a drawing and their bounds.
pub struct Drawing {
    pub entities: Vec<Entity>,
    /// The smallest and the largest coordinates; `None` if nothing is drawn.
    pub bounds: Option<(Point, Point)>,
}

impl Drawing {
    /// The drawing of a layout with this outline of every room.
    pub fn of(layout: &Layout, boundary: Boundary) -> Self {
        let mut entities: Vec<_> =
            layout.rooms.iter().flat_map(|room| rooms::draw(room, boundary.of(room))).collect();
        entities.extend(walls::draw(layout));
        entities.extend(layout.openings.iter().map(annotations::opening));
        entities.extend(layout.frontiers.iter().map(annotations::frontier));
        entities.extend(layout.texts.iter().filter_map(annotations::text));
        entities.extend(layout.symbols.iter().filter_map(annotations::symbol));
        Self { bounds: bounds(entities.iter().flat_map(|e| e.shape.corners())), entities }
    }
}
