//! All that a drawing shows, with what its insertions repeat.

use super::drawing::{Drawing, Entity};
use super::own;
use super::plane::{Map, Point};
use super::shapes::{Shape, shapes};
use super::words::{Words, words};
use planform_sdk::{ErrorKind, PluginError};

/// How deep blocks may lie in each other.
const MAX_DEPTH: usize = 16;
/// The most entities, points and insertions of a drawing, repeated ones counted each time.
const MAX_WORK: usize = 4_000_000;

/// What a drawing shows; lengths in its units, y up.
#[derive(Debug, Default)]
pub struct Shown {
    /// Lines, each with the name of its layer in upper case.
    pub lines: Vec<(String, Shape)>,
    pub words: Vec<Words>,
    pub insertions: Vec<Insertion>,
    /// Lines that the drawing marks as doors, from jamb to jamb.
    pub sills: Vec<[Point; 2]>,
    work: usize,
}

/// A block that was placed.
#[derive(Debug, Clone)]
pub struct Insertion {
    /// In upper case.
    pub name: String,
    /// From the block's coordinates to the drawing's.
    pub map: Map,
    /// The block's lines, in its own coordinates.
    pub shapes: Vec<Shape>,
}

/// Where entities are drawn: through which map, inside of which layer, how deep.
#[derive(Clone, Copy)]
struct Place<'p> {
    map: Map,
    layer: &'p str,
    depth: usize,
}

impl Shown {
    /// Goes through the drawing. `is_symbol` tells blocks by name that are kept as insertions, and not drawn.
    pub fn of(drawing: &Drawing<'_>, is_symbol: &dyn Fn(&str) -> bool) -> Result<Self, PluginError> {
        let mut shown = Self::default();
        let place = Place { map: Map::SAME, layer: "0", depth: 0 };
        shown.entities(drawing, &drawing.entities, place, is_symbol)?;
        Ok(shown)
    }

    fn entities(
        &mut self,
        drawing: &Drawing<'_>,
        entities: &[Entity<'_>],
        place: Place<'_>,
        is_symbol: &dyn Fn(&str) -> bool,
    ) -> Result<(), PluginError> {
        for entity in entities.iter().filter(|e| e.is_drawn()) {
            self.count(1)?;
            // What lies on layer 0 of a block takes the layer on which the block is placed.
            let own = entity.layer();
            let layer = if own == "0" { place.layer } else { own.as_str() };
            if drawing.hidden.contains(&own) || drawing.hidden.contains(layer) {
                continue;
            }
            let place = Place { layer, ..place };
            if entity.kind == "INSERT" {
                self.insertion(drawing, entity, place, is_symbol)?;
            } else {
                self.entity(entity, place)?;
            }
        }
        Ok(())
    }

    fn entity(&mut self, entity: &Entity<'_>, place: Place<'_>) -> Result<(), PluginError> {
        for shape in shapes(entity) {
            self.count(shape.points.len())?;
            let shape = shape.through(place.map);
            let sound = shape.points.iter().flatten().all(|v| v.is_finite());
            if shape.points.len() >= 2 && sound {
                if let ([a, b], true) = (shape.points.as_slice(), own::is_door(entity)) {
                    self.sills.push([*a, *b]);
                }
                self.lines.push((place.layer.to_owned(), shape));
            }
        }
        if !own::is_number(entity) {
            self.words.extend(words(entity, place.map));
        }
        Ok(())
    }

    fn insertion(
        &mut self,
        drawing: &Drawing<'_>,
        entity: &Entity<'_>,
        place: Place<'_>,
        is_symbol: &dyn Fn(&str) -> bool,
    ) -> Result<(), PluginError> {
        let attributes = entity.parts().filter(|a| a.flags(70) & 1 == 0);
        attributes.for_each(|a| self.words.extend(words(&a, place.map)));
        let name = entity.text(2).unwrap_or_default().to_uppercase();
        let Some(block) = drawing.blocks.get(&name) else { return Ok(()) };
        if place.depth >= MAX_DEPTH {
            return Ok(());
        }
        let symbol = is_symbol(&name);
        for map in maps(entity, block.base) {
            self.count(1)?;
            let inner = Place { map: place.map.after(map), depth: place.depth + 1, ..place };
            if symbol {
                self.symbol(drawing, &name, &block.entities, inner)?;
            } else {
                self.entities(drawing, &block.entities, inner, is_symbol)?;
            }
        }
        Ok(())
    }

    /// Keeps the lines of a block apart; the words in it are words of the drawing.
    fn symbol(
        &mut self,
        drawing: &Drawing<'_>,
        name: &str,
        entities: &[Entity<'_>],
        place: Place<'_>,
    ) -> Result<(), PluginError> {
        let mut inside = Self { work: self.work, ..Self::default() };
        inside.entities(drawing, entities, Place { map: Map::SAME, ..place }, &|_| false)?;
        self.work = inside.work;
        let shapes = inside.lines.into_iter().map(|(_, shape)| shape).collect();
        self.insertions.push(Insertion { name: name.to_owned(), map: place.map, shapes });
        Ok(())
    }

    fn count(&mut self, work: usize) -> Result<(), PluginError> {
        self.work += work;
        if self.work <= MAX_WORK {
            return Ok(());
        }
        let message = format!("the DXF has more than {MAX_WORK} points, once all its blocks are placed");
        Err(PluginError::new(ErrorKind::Limit, message).advise("save the plan of one storey alone"))
    }
}

/// The maps of an insertion: one, or those of rows and columns.
fn maps(entity: &Entity<'_>, [x, y]: Point) -> impl Iterator<Item = Map> {
    let factor = |code| entity.number(code).filter(|f| *f != 0.0).unwrap_or(1.0);
    let count = |code| entity.flags(code).clamp(1, i64::from(i16::MAX));
    let (columns, rows) = (count(70), count(71));
    let step = [44, 45].map(|code| entity.number(code).unwrap_or(0.0));
    let mirror = if entity.is_mirrored() { Map::scale(-1.0, 1.0) } else { Map::SAME };
    let at = entity.point(10).unwrap_or_default();
    let turn = Map::turn(entity.number(50).unwrap_or(0.0).to_radians());
    let outer = mirror.after(Map::shift(at)).after(turn);
    let inner = Map::scale(factor(41), factor(42)).after(Map::shift([-x, -y]));
    let cells =
        (0..rows).flat_map(move |r| (0..columns).map(move |c| [c as f64 * step[0], r as f64 * step[1]]));
    cells.map(move |cell| outer.after(Map::shift(cell)).after(inner))
}
