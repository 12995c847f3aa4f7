//! Everything that is drawn of a layout.

use crate::blocks::Block;
use crate::entity::{Entity, Shape};
use crate::{annotations, rooms, symbols, walls};
use planform_sdk::{Boundary, Layout, Point, bounds};
use std::collections::BTreeSet;

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
        entities.extend(annotations::texts(layout));
        entities.extend(symbols::draw(layout));
        Self { bounds: bounds(entities.iter().flat_map(|e| e.shape.corners())), entities }
    }

    /// The blocks that are inserted somewhere, by their names.
    pub fn blocks(&self) -> Vec<Block> {
        let inserted = self.entities.iter().filter_map(|e| match &e.shape {
            Shape::Insert { block, .. } => Some(*block),
            _ => None,
        });
        let names: BTreeSet<&str> = inserted.collect();
        names.into_iter().filter_map(|name| Block::of_kind(&name.to_lowercase())).collect()
    }
}
