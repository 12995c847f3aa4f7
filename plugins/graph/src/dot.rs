//! DOT, the language of Graphviz.

use crate::graph::{Attributes, Graph, Node, Value};
use std::io::{self, Write};

/// Writes the graph. Beside its attributes a node has a `label`, and where it has a place also `pos`, in metres, with
/// which
/// `neato -n` draws it as the map lies.
pub fn write(graph: &Graph, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "graph layout {{\n// {}", crate::graph::GENERATOR)?;
    for node in &graph.nodes {
        let drawing = [Some(("label", quoted(&label(node)))), pos(node).map(|p| ("pos", quoted(&p)))];
        writeln!(out, "{} [{}];", quoted(&node.id), list(drawing.into_iter().flatten(), &node.attributes))?;
    }
    for edge in &graph.edges {
        let [a, b] = edge.ends.each_ref().map(|id| quoted(id));
        writeln!(out, "{a} -- {b} [{}];", list([].into_iter(), &edge.attributes))?;
    }
    writeln!(out, "}}")
}

fn attribute<'a>(node: &'a Node, name: &str) -> Option<&'a Value> {
    node.attributes.iter().find(|(n, _)| *n == name).map(|(_, value)| value)
}

/// What a room is called, or the node's id. Graphviz takes a backslash in a label for the begin of a code.
fn label(node: &Node) -> String {
    match attribute(node, "name") {
        Some(Value::Text(name)) => name.replace('\\', "\\\\"),
        _ => node.id.clone(),
    }
}

fn pos(node: &Node) -> Option<String> {
    let number = |name| match attribute(node, name) {
        Some(Value::Number(v)) => Some(*v),
        _ => None,
    };
    Some(format!("{},{}!", number("x")?, number("y")?))
}

fn list<'a>(first: impl Iterator<Item = (&'a str, String)>, attributes: &'a Attributes) -> String {
    let value = |value: &Value| match value {
        Value::Text(v) => quoted(v),
        Value::Number(v) => v.to_string(),
        Value::Whole(v) => v.to_string(),
    };
    let rest = attributes.iter().map(|(name, v)| (*name, value(v)));
    first.chain(rest).map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(", ")
}

/// The text in quotes, in which DOT knows no other code than that of the quote itself. A text cannot hold a zero byte,
/// and a backslash at its end would hide the quote.
fn quoted(text: &str) -> String {
    let text = text.replace('\0', "\u{fffd}").replace('"', "\\\"");
    let odd = text.chars().rev().take_while(|c| *c == '\\').count() % 2 == 1;
    format!("\"{text}{}\"", if odd { "\\" } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_quoted() {
        for (text, expected) in [
            ("Küche", "\"Küche\""),
            ("a \"b\"", "\"a \\\"b\\\"\""),
            ("c\\", "\"c\\\\\""),
            ("c\\\\", "\"c\\\\\""),
            ("\0", "\"\u{fffd}\""),
        ] {
            assert_eq!(quoted(text), expected);
        }
    }

    #[test]
    fn a_room_is_labelled_with_its_name() {
        let attributes =
            vec![("name", Value::Text("A\\B".into())), ("x", Value::Number(1.5)), ("y", Value::Number(-2.0))];
        let node = Node { id: "room-1".into(), attributes };
        assert_eq!((label(&node), pos(&node)), ("A\\\\B".into(), Some("1.5,-2!".into())));
    }
}
