//! A whole DXF file: its sections in their order.

use crate::drawing::Drawing;
use crate::header::{classes, header};
use crate::objects::{Skeleton, blocks, objects};
use crate::pairs::Pairs;
use crate::tables::tables;
use crate::version::Version;

/// The bytes of the file.
pub fn file(drawing: &Drawing, version: Version) -> Vec<u8> {
    let mut body = Pairs::new(version);
    write_body(&mut body, drawing);
    // The header names the first free handle, so it is written when the others are given out.
    let mut head = Pairs::new(version);
    header(&mut head, drawing.bounds, body.next_handle());
    let mut bytes = head.into_bytes();
    bytes.append(&mut body.into_bytes());
    bytes
}

fn write_body(pairs: &mut Pairs, drawing: &Drawing) {
    let skeleton = Skeleton::new(pairs, drawing.blocks());
    let modern = pairs.version().has_objects();
    if modern {
        classes(pairs);
    }
    tables(pairs, &skeleton, drawing.bounds);
    blocks(pairs, &skeleton);
    pairs.section("ENTITIES", |p| drawing.entities.iter().for_each(|e| e.write(p, skeleton.model.record)));
    if modern {
        objects(pairs, &skeleton, drawing.bounds);
    }
    pairs.word(0, "EOF");
}
