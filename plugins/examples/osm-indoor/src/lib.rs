//! Writes layouts as OpenStreetMap data, by Simple Indoor Tagging
//! (<https://wiki.openstreetmap.org/wiki/Simple_Indoor_Tagging>).
//!
//! | in the layout | in the file |
//! | --- | --- |
//! | room | closed way `indoor=room`, or `indoor=corridor` by its shape (`corridor.rs`); with holes a multipolygon |
//! | wall | way `indoor=wall` along its centre line, `width` is its thickness |
//! | door | node `indoor=door` `door=yes` in the outlines of both rooms and in the wall, `width` |
//! | passage | the same with `door=no`, the tagging's word for a hole in the wall |
//!
//! Everything has a `level`. A room's name becomes its `name`, or its `ref` if it is more of a number, as "B 1.04". A
//! room that was not seen whole has a `note` that says so.
//!
//! # Nodes
//!
//! Points are rounded to millimetres of the map frame, and equal points are one node. Every line is led through every
//! node that lies on it, so that rooms and walls which touch share nodes, corner or not, and so that a door, being a
//! node of both rooms, is what a router needs to find its way from one to the other. That is why outlines run along the
//! centre lines of the walls unless the user wants them along their inner faces, which never touch. Walls and doors are
//! put onto those outlines (`fit.rs`).
//!
//! # Identifiers
//!
//! They are negative, as of all objects that OpenStreetMap does not have yet. JOSM takes such an object for a new one
//! without the attribute `action`, which is for changes to old ones, so there is none. `upload="false"` makes JOSM ask
//! before it uploads: whoever imports a building should have looked at it.
//!
//! An identifier is a hash of what the object is: of a node's place, of a room's corners, and of the level. So an
//! object that did not change keeps its identifier when the rest of the layout did, and two files can be compared line
//! by line (`identity.rs`).
//!
//! # Coordinates
//!
//! WGS 84 with 9 decimals, 0.1 mm. OpenStreetMap itself keeps 7, a centimetre, and rounds what is uploaded.

mod corridor;
mod earth;
mod features;
mod fit;
mod grain;
mod identity;
mod map;
mod options;
mod placed;
mod tags;
mod thread;
mod xml;

use earth::Earth;
use placed::PlacedMap;
use planform_sdk::{Document, ErrorKind, Exporter, GeoAnchor, Options, PluginError};
use std::io::Write;

planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

/// The exporter `osm-indoor`.
pub fn exporter() -> Box<dyn Exporter> {
    planform_sdk::exporter(options::info(), write)
}

fn write(document: &Document<'_>, options: &Options, out: &mut dyn Write) -> Result<(), PluginError> {
    let anchor = GeoAnchor::chosen(options, document.layout.anchor)?.ok_or_else(no_anchor)?;
    let level = options::level(options)?;
    let map = features::of_layout(document.layout, options, level)?;
    Ok(xml::write(&PlacedMap::new(map, &Earth::new(anchor), level)?, out)?)
}

fn no_anchor() -> PluginError {
    let message = "OpenStreetMap data lies on the Earth, and the layout does not say where";
    PluginError::new(ErrorKind::BadOption, message)
        .advise("give --anchor LAT,LON,BEARING, such as --anchor 47.3769,8.5417,12.5")
}
