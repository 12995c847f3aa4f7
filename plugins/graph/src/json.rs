//! Node-link JSON, as networkx reads and writes it.

use crate::graph::{Attributes, Graph, Value};
use serde_json::json;
use std::io::{self, Write};

/// Writes the graph, one node or edge a line.
pub fn write(graph: &Graph, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{{\n\"directed\": false,\n\"multigraph\": false,")?;
    writeln!(out, "\"graph\": {},", json!({"generator": crate::graph::GENERATOR}))?;
    let nodes = graph.nodes.iter().map(|n| object(&[("id", &n.id)], &n.attributes));
    let edges = graph.edges.iter().map(|e| {
        let [source, target] = &e.ends;
        object(&[("source", source), ("target", target)], &e.attributes)
    });
    write_list(out, "nodes", nodes)?;
    writeln!(out, ",")?;
    write_list(out, "edges", edges)?;
    writeln!(out, "\n}}")
}

fn write_list(out: &mut dyn Write, name: &str, items: impl Iterator<Item = String>) -> io::Result<()> {
    let lines: String =
        items.enumerate().map(|(i, line)| format!("{}\n{line}", if i > 0 { "," } else { "" })).collect();
    write!(out, "\"{name}\": [{lines}\n]")
}

/// An object whose first members are these texts.
fn object(first: &[(&str, &String)], attributes: &Attributes) -> String {
    let first = first.iter().map(|(name, text)| format!("{}: {}", json!(name), json!(text)));
    let value = |value: &Value| match value {
        Value::Text(v) => json!(v),
        Value::Number(v) => json!(v),
        Value::Whole(v) => json!(v),
    };
    let rest = attributes.iter().map(|(name, v)| format!("{}: {}", json!(name), value(v)));
    format!("{{{}}}", first.chain(rest).collect::<Vec<_>>().join(", "))
}
