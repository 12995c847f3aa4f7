//! Writes the rooms and doors of layouts as graphs for planning: JSON, GraphML or DOT.
//!
//! # The graph
//!
//! It is undirected and has at most one edge between two nodes. The attribute `kind` of a node says what it is:
//!
//! | node | `kind` | further attributes |
//! | --- | --- | --- |
//! | `room-1` | `room` | `room` (its number), `name` if known, `state` (`complete`, `partial`), `area` (floor, m²), `x`, `y` (a roomy point of its floor), `centroid_x`, `centroid_y` |
//! | `door-1` | `door`, `passage` | `x`, `y`, `heading` (through it, from the room with the smaller number, or from the room to the outside; radians), `width` (m), `from`, `to` (the ids of what it joins) |
//! | `outside` | `outside` | only if a door leads there |
//!
//! An edge joins a room with each of its doors, two doors of one room with each other, and a door with the outside. Its
//! `distance` is how far one walks between the two on the room's floor, metres: the shortest way around corners, and
//! from a door's middle straight onto the floor. `room` is the number of that room; edges to the outside have none, and
//! the distance 0. So the shortest way between two nodes by `distance` is a way through the building.
//!
//! Coordinates are metres in the map frame, angles counter-clockwise from its x axis.
//!
//! # Formats
//!
//! The extension chooses: `.graph.json` is the node-link JSON of networkx, whose `node_link_graph` reads it, `.graphml`
//! is GraphML, `.dot` and `.gv` are DOT. The option `format` chooses for other names and for standard output.

mod dot;
mod graph;
mod graphml;
mod json;
mod place;
mod walking;

use graph::Graph;
use planform_sdk::{Document, Exporter, OptionSpec, Options, Output, PluginError, PluginInfo};
use std::io::{self, Write};

/// The exporter `graph`.
pub fn exporter() -> Box<dyn Exporter> {
    Box::new(GraphExporter(info()))
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

struct GraphExporter(PluginInfo);

fn info() -> PluginInfo {
    let text = |words: &[&str]| words.iter().map(|w| (*w).to_owned()).collect();
    PluginInfo {
        name: "graph".into(),
        description: "graph: rooms and doors with walking distances, as JSON, GraphML or DOT".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: text(&["graph.json", "graphml", "dot", "gv"]),
        media_types: text(&["application/json", "application/graphml+xml", "text/vnd.graphviz"]),
        options: vec![OptionSpec::choice(
            "format",
            "the format; auto is that of the file's extension, and JSON for other names",
            &["auto", "json", "graphml", "dot"],
            "auto",
        )],
    }
}

type Writer = fn(&Graph, &mut dyn Write) -> io::Result<()>;

/// Who writes this format; `auto` is that of the extension.
fn writer(format: &str, extension: &str) -> Writer {
    match (format, extension.to_lowercase().as_str()) {
        ("graphml", _) | ("auto", "graphml") => graphml::write,
        ("dot", _) | ("auto", "dot" | "gv") => dot::write,
        _ => json::write,
    }
}

impl Exporter for GraphExporter {
    fn info(&self) -> &PluginInfo {
        &self.0
    }

    fn write(
        &self,
        document: &Document<'_>,
        options: &Options,
        out: &mut dyn Write,
    ) -> Result<(), PluginError> {
        self.write_files(
            document,
            options,
            Output { stem: "", extension: "", file: out, companions: &mut [] },
        )
    }

    fn write_files(
        &self,
        document: &Document<'_>,
        options: &Options,
        output: Output<'_>,
    ) -> Result<(), PluginError> {
        let graph = Graph::of(document.layout)?;
        let write = writer(options.text("format").unwrap_or("auto"), output.extension);
        Ok(write(&graph, output.file)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Layout;

    fn written(format: &str, extension: &str) -> String {
        let (exporter, layout, mut file) = (exporter(), Layout::default(), vec![]);
        let options = Options::parse(&exporter.info().options, [("format", format)]).unwrap();
        let output = Output { stem: "a", extension, file: &mut file, companions: &mut [] };
        let document = Document { layout: &layout, scene: None };
        exporter.write_files(&document, &options, output).unwrap();
        String::from_utf8(file).unwrap()
    }

    #[test]
    fn the_extension_chooses_unless_the_option_does() {
        for (format, extension, begin) in [
            ("auto", "graph.json", "{"),
            ("auto", "GraphML", "<?xml"),
            ("auto", "gv", "graph "),
            ("auto", "", "{"),
            ("dot", "graphml", "graph "),
            ("json", "dot", "{"),
        ] {
            let text = written(format, extension);
            assert!(text.starts_with(begin), "{format} {extension}: {text}");
        }
    }
}
