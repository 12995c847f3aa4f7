//! The file, as JOSM reads it.

use crate::earth::Place;
use crate::placed::{Placed, PlacedMap};
use crate::tags::Tags;
use std::fmt;
use std::io::{self, Write};

/// Writes nodes, then ways, then relations: what is referred to comes first, as many readers want it.
pub fn write(map: &PlacedMap, out: &mut dyn Write) -> io::Result<()> {
    let generator = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(out, "<osm version=\"0.6\" generator=\"{generator}\" upload=\"false\">")?;
    map.nodes.iter().try_for_each(|node| write_node(node, out))?;
    map.ways.iter().try_for_each(|way| write_way(way, out))?;
    map.relations.iter().try_for_each(|relation| write_relation(relation, out))?;
    writeln!(out, "</osm>")
}

fn write_node(node: &Placed<Place>, out: &mut dyn Write) -> io::Result<()> {
    let Place { latitude, longitude } = node.body;
    write!(out, "  <node id=\"{}\" lat=\"{latitude}\" lon=\"{longitude}\"", node.id)?;
    if node.tags.0.is_empty() {
        return writeln!(out, "/>");
    }
    writeln!(out, ">")?;
    write_tags(&node.tags, out)?;
    writeln!(out, "  </node>")
}

fn write_way(way: &Placed<Vec<i64>>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "  <way id=\"{}\">", way.id)?;
    way.body.iter().try_for_each(|node| writeln!(out, "    <nd ref=\"{node}\"/>"))?;
    write_tags(&way.tags, out)?;
    writeln!(out, "  </way>")
}

fn write_relation(relation: &Placed<Vec<i64>>, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "  <relation id=\"{}\">", relation.id)?;
    for (i, way) in relation.body.iter().enumerate() {
        let role = if i == 0 { "outer" } else { "inner" };
        writeln!(out, "    <member type=\"way\" ref=\"{way}\" role=\"{role}\"/>")?;
    }
    write_tags(&relation.tags, out)?;
    writeln!(out, "  </relation>")
}

fn write_tags(tags: &Tags, out: &mut dyn Write) -> io::Result<()> {
    tags.0
        .iter()
        .try_for_each(|(key, value)| writeln!(out, "    <tag k=\"{key}\" v=\"{}\"/>", Escaped(value)))
}

/// A text within the quotes of an attribute. Control characters, which XML cannot have, never get into [`Tags`].
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            _ => write!(f, "{c}"),
        })
    }
}
