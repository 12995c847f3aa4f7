//! GraphML, <http://graphml.graphdrawing.org>.

use crate::graph::{Attributes, Graph, Value};
use std::collections::BTreeMap;
use std::io::{self, Write};

const HEAD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns"
    xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:schemaLocation="http://graphml.graphdrawing.org/xmlns http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd">"#;

/// The attributes of nodes or of edges, and the type of each.
type Keys = BTreeMap<&'static str, &'static str>;

/// Writes the graph, one node or edge a line. The keys of nodes begin with `n_`, those of edges with `e_`.
pub fn write(graph: &Graph, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{HEAD}\n<!-- {} -->", crate::graph::GENERATOR)?;
    write_keys(out, "node", "n", &keys(graph.nodes.iter().map(|n| &n.attributes)))?;
    write_keys(out, "edge", "e", &keys(graph.edges.iter().map(|e| &e.attributes)))?;
    writeln!(out, "<graph edgedefault=\"undirected\">")?;
    for node in &graph.nodes {
        writeln!(out, "<node id=\"{}\">{}</node>", escaped(&node.id), data("n", &node.attributes))?;
    }
    for edge in &graph.edges {
        let [source, target] = edge.ends.each_ref().map(|id| escaped(id));
        let data = data("e", &edge.attributes);
        writeln!(out, "<edge source=\"{source}\" target=\"{target}\">{data}</edge>")?;
    }
    writeln!(out, "</graph>\n</graphml>")
}

fn keys<'a>(all: impl Iterator<Item = &'a Attributes>) -> Keys {
    let kind = |value: &Value| match value {
        Value::Text(_) => "string",
        Value::Number(_) => "double",
        Value::Whole(_) => "long",
    };
    all.flatten().map(|(name, value)| (*name, kind(value))).collect()
}

fn write_keys(out: &mut dyn Write, of: &str, prefix: &str, keys: &Keys) -> io::Result<()> {
    keys.iter().try_for_each(|(name, kind)| {
        writeln!(out, "<key id=\"{prefix}_{name}\" for=\"{of}\" attr.name=\"{name}\" attr.type=\"{kind}\"/>")
    })
}

fn data(prefix: &str, attributes: &Attributes) -> String {
    let one = |(name, value): &(&str, Value)| {
        let value = match value {
            Value::Text(v) => escaped(v),
            Value::Number(v) => v.to_string(),
            Value::Whole(v) => v.to_string(),
        };
        format!("<data key=\"{prefix}_{name}\">{value}</data>")
    };
    attributes.iter().map(one).collect()
}

/// The text as XML. What XML 1.0 cannot hold is replaced; line breaks and tabs are kept from being normalised.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\n' | '\r' | '\t' => out.push_str(&format!("&#{};", u32::from(c))),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_escaped() {
        assert_eq!(
            escaped("a <b> & \"c\"\n\0\u{1f6aa}"),
            "a &lt;b&gt; &amp; &quot;c&quot;&#10;\u{fffd}\u{1f6aa}"
        );
    }
}
