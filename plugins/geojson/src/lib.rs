//! Writes layouts as GeoJSON (RFC 7946).
//!
//! The file is one `FeatureCollection`. The property `kind` of a feature says what it is:
//!
//! | `kind` | geometry | further properties |
//! | --- | --- | --- |
//! | `room` | Polygon | `room` (its number), `name`, `state` (`complete`, `partial`), `area` (floor, m²) |
//! | `wall` | LineString | `thickness` (m), `weight` (0 to 1), `left` and `right` (room numbers, null is outside) |
//! | `door`, `passage` | LineString | `width` (m), `rooms` (two numbers) |
//! | `frontier` | LineString | `room`, `leads` (`room`: to the rest of its room, `space`: to new space), `area` (behind it, m²; 0 is no estimate) |
//! | `line` | LineString | `support` (m); only with the option `lines` |
//! | `text` | Point | `text`, `yaw` (degrees), `width`, `height` (m), `confidence` |
//! | `symbol` | Point | `symbol`, `yaw` (degrees), `width`, `height` (m), `score`; of doors `opening` (the id of the opening that it is; null for a door to the outside) |
//! | `leaf` | LineString: from the hinge to the free end, open, and on its way to where it closes | `symbol` (the id of its door), `width` (m), `swing` (degrees from closed to open, counter-clockwise) |
//!
//! Every feature has an `id` such as `room-1`, unique in the file. `area`, `width` and the other measures are those of
//! the layout in metres, whatever the coordinates are. `yaw` is always counter-clockwise from the map's x axis.
//!
//! # Coordinates
//!
//! Without an anchor they are metres in the map frame, rounded to 0.1 mm. RFC 7946 knows WGS 84 only, so such a file
//! carries the `crs` member of the older GeoJSON 2008, with a WKT of a local system as its name. That is the one form
//! GDAL 3.6 takes for what it is: `ogrinfo` then shows `ENGCRS["map frame", ...]` in metres, while for no `crs`, for
//! `null` and for `urn:ogc:def:crs:EPSG::5800` (a local system that PROJ's database lacks) it shows WGS 84.
//!
//! With an anchor they are WGS 84 longitude and latitude in degrees, rounded to 9 decimals (0.1 mm), and there is no
//! `crs`. The map plane is laid on the ellipsoid by the azimuthal equidistant projection about the anchor, with exact
//! geodesics: distances and directions from the anchor are true, and others off by less than 1 mm in a kilometre.
//!
//! A feature that crosses the antimeridian is kept in one piece, with longitudes that run on beyond 180. (RFC 7946,
//! 3.1.9, would rather have it cut in two; readers that join the pieces of a room again are rare.) All other features
//! keep to -180..180.

mod features;
mod frame;
mod options;

use frame::Frame;
use geojson::Feature;
use planform_sdk::{Document, Exporter, GeoAnchor, Layout, Options, PluginError};
use serde_json::{Value, json};
use std::io::{self, Write};

/// The exporter `geojson`.
pub fn exporter() -> Box<dyn Exporter> {
    planform_sdk::exporter(options::info(), write)
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

fn write(document: &Document<'_>, options: &Options, out: &mut dyn Write) -> Result<(), PluginError> {
    let anchor = GeoAnchor::chosen(options, document.layout.anchor)?;
    let frame = anchor.map_or(Frame::Map, Frame::Earth);
    let features = features::all(document.layout, &frame, options)?;
    Ok(write_collection(&members(document.layout, &frame), &features, out)?)
}

/// The members of the collection in front of its features.
fn members(layout: &Layout, frame: &Frame) -> Vec<(&'static str, Value)> {
    let mut members = vec![("type", json!("FeatureCollection"))];
    // In front of the features, so that a reader knows the system before it meets the first coordinate.
    members.extend(frame.crs().map(|crs| ("crs", crs)));
    members.push(("generator", json!(concat!("planform ", env!("CARGO_PKG_VERSION")))));
    members.push(("method", json!(layout.method)));
    members.push((
        "provenance",
        json!({"source": layout.provenance.source, "adapter": layout.provenance.adapter}),
    ));
    members.extend(layout.scale.as_ref().map(|scale| ("scale", json!(scale))));
    members.extend(frame.anchor().map(|anchor| ("anchor", anchor)));
    members
}

/// One feature a line, so that two files can be compared line by line.
fn write_collection(members: &[(&str, Value)], features: &[Feature], out: &mut dyn Write) -> io::Result<()> {
    out.write_all(b"{\n")?;
    for (name, value) in members {
        writeln!(out, "{}: {value},", json!(name))?;
    }
    out.write_all(b"\"features\": [")?;
    for (i, feature) in features.iter().enumerate() {
        out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
        serde_json::to_writer(&mut *out, feature)?;
    }
    out.write_all(b"\n]\n}\n")
}
