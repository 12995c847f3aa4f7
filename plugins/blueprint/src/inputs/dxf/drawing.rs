//! A DXF drawing: layers, blocks, and the entities of model space.
//!
//! Read here and not with a crate: those that there are know neither hatches nor frozen layers, and give up on the whole
//! drawing at one value that is wrong, as many a program writes it.

use super::pairs::Pair;
use std::collections::{BTreeMap, BTreeSet};

/// A drawing, borrowed from its pairs. Names are in upper case, since DXF compares them so.
#[derive(Debug, Default)]
pub struct Drawing<'a> {
    /// `$INSUNITS`, if it is there.
    pub units: Option<i32>,
    /// Layers that are frozen or off.
    pub hidden: BTreeSet<String>,
    pub blocks: BTreeMap<String, Block<'a>>,
    pub entities: Vec<Entity<'a>>,
}

#[derive(Debug, Default)]
pub struct Block<'a> {
    /// The point of it that an insertion places.
    pub base: [f64; 2],
    pub entities: Vec<Entity<'a>>,
}

/// One entity: its name, and its pairs.
#[derive(Debug, Clone, Copy)]
pub struct Entity<'a> {
    pub kind: &'a str,
    pub pairs: &'a [Pair<'a>],
    /// The vertices of a polyline and the attributes of an insertion with their pairs, as they follow it.
    pub parts: &'a [Pair<'a>],
}

impl<'a> Drawing<'a> {
    /// The drawing that these pairs hold; what is not understood is passed over.
    pub fn of(pairs: &'a [Pair<'a>]) -> Self {
        let mut drawing = Self::default();
        for section in split(pairs, |p| p.begins("SECTION")) {
            let body = until(section, "ENDSEC");
            match text(body, 2) {
                Some("HEADER") => drawing.units = header_units(body),
                Some("TABLES") => drawing.hidden = hidden_layers(body),
                Some("BLOCKS") => drawing.blocks = blocks(body),
                Some("ENTITIES") => drawing.entities = entities(body),
                _ => {}
            }
        }
        drawing
    }
}

impl<'a> Entity<'a> {
    /// The first number with this code.
    pub fn number(&self, code: i32) -> Option<f64> {
        self.pairs.iter().find(|p| p.code == code)?.number()
    }

    /// The first whole number with this code, 0 if there is none.
    pub fn flags(&self, code: i32) -> i64 {
        self.number(code).unwrap_or(0.0) as i64
    }

    /// The first value with this code.
    pub fn text(&self, code: i32) -> Option<&'a str> {
        text(self.pairs, code)
    }

    /// The point whose x has this code and whose y has one that is greater by ten.
    pub fn point(&self, code: i32) -> Option<[f64; 2]> {
        Some([self.number(code)?, self.number(code + 10)?])
    }

    /// Its layer, in upper case.
    pub fn layer(&self) -> String {
        self.text(8).unwrap_or("0").to_uppercase()
    }

    /// Whether it is drawn in model space, and visible there.
    pub fn is_drawn(&self) -> bool {
        self.flags(67) == 0 && self.flags(60) == 0
    }

    /// Whether its plane is seen from behind, so that x runs to the left.
    pub fn is_mirrored(&self) -> bool {
        self.number(230).is_some_and(|z| z < 0.0)
    }

    /// Its vertices or attributes.
    pub fn parts(&self) -> impl Iterator<Item = Entity<'a>> + use<'a> {
        split(self.parts, |p| p.code == 0).map(Entity::simple)
    }

    fn simple(pairs: &'a [Pair<'a>]) -> Self {
        Self {
            kind: pairs.first().map_or("", |p| p.value),
            pairs: pairs.get(1..).unwrap_or_default(),
            parts: &[],
        }
    }

    /// Whether another entity belongs to this one.
    fn owns(&self, other: &str) -> bool {
        match self.kind {
            "POLYLINE" => other == "VERTEX",
            "INSERT" => other == "ATTRIB",
            _ => false,
        }
    }
}

/// The pieces of `pairs` that begin where `begins` says so; what comes before the first is dropped.
fn split<'a>(
    pairs: &'a [Pair<'a>],
    begins: impl Fn(&Pair<'a>) -> bool + 'a,
) -> impl Iterator<Item = &'a [Pair<'a>]> + 'a {
    let starts: Vec<_> = (0..pairs.len()).filter(|&i| begins(&pairs[i])).collect();
    let ends: Vec<_> = starts.iter().skip(1).copied().chain([pairs.len()]).collect();
    starts.into_iter().zip(ends).map(|(start, end)| &pairs[start..end])
}

fn until<'a>(pairs: &'a [Pair<'a>], end: &str) -> &'a [Pair<'a>] {
    let length = pairs.iter().position(|p| p.begins(end)).unwrap_or(pairs.len());
    &pairs[..length]
}

fn text<'a>(pairs: &[Pair<'a>], code: i32) -> Option<&'a str> {
    pairs.iter().find(|p| p.code == code).map(|p| p.value)
}

fn header_units(pairs: &[Pair<'_>]) -> Option<i32> {
    let at = pairs.iter().position(|p| p.code == 9 && p.value == "$INSUNITS")?;
    pairs.get(at + 1)?.value.parse().ok()
}

/// A layer is off by a colour below zero, and frozen by a flag.
fn hidden_layers(pairs: &[Pair<'_>]) -> BTreeSet<String> {
    let layers = split(pairs, |p| p.code == 0).map(Entity::simple).filter(|e| e.kind == "LAYER");
    let hidden = layers.filter(|l| l.flags(70) & 1 != 0 || l.number(62).is_some_and(|c| c < 0.0));
    hidden.filter_map(|l| l.text(2)).map(str::to_uppercase).collect()
}

fn blocks<'a>(pairs: &'a [Pair<'a>]) -> BTreeMap<String, Block<'a>> {
    let block = |pairs: &'a [Pair<'a>]| {
        let inner = pairs.iter().skip(1).position(|p| p.code == 0).map_or(pairs.len(), |i| i + 1);
        let head = Entity::simple(&pairs[..inner]);
        let base = head.point(10).unwrap_or_default();
        let entities = entities(until(&pairs[inner..], "ENDBLK"));
        Some((head.text(2)?.to_uppercase(), Block { base, entities }))
    };
    split(pairs, |p| p.begins("BLOCK")).filter_map(block).collect()
}

fn entities<'a>(pairs: &'a [Pair<'a>]) -> Vec<Entity<'a>> {
    let mut entities: Vec<Entity<'a>> = vec![];
    // Entities follow each other without a gap, so an owner's parts are one piece of `pairs`.
    let mut end = pairs.iter().position(|p| p.code == 0).unwrap_or(pairs.len());
    for piece in split(pairs, |p| p.code == 0) {
        end += piece.len();
        let entity = Entity::simple(piece);
        match entities.last_mut() {
            Some(owner) if owner.owns(entity.kind) => {
                owner.parts = &pairs[end - piece.len() - owner.parts.len()..end];
            }
            _ => entities.push(entity),
        }
    }
    entities
}
