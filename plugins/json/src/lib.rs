//! Writes layouts whole, as JSON.
//!
//! The file is one object, a [`Layout`] with all that is in it, as `schemas/layout.schema.json` describes it and as
//! plugins are given it. Numbers have all their digits: reading the file back gives the same layout to the last bit.
//!
//! ```
//! use planform_sdk::{Document, Layout, Options};
//! let layout = Layout { method: "by hand".into(), ..Layout::default() };
//! let mut file = vec![];
//! planform_json::exporter().write(&Document { layout: &layout, scene: None }, &Options::default(), &mut file)?;
//! assert_eq!(serde_json::from_slice::<Layout>(&file)?, layout);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Each room, wall, opening and so on has a line of its own, so that two files can be compared line by line.
//!
//! There is no member `$schema`: JSON Schema gives it a meaning in schemas only, and the file would depend on an
//! address. Programs that want one may add it, since readers skip members that they do not know.

use planform_sdk::{Document, ErrorKind, Exporter, Layout, Options, PluginError, PluginInfo};
use serde::{Serialize, de::DeserializeOwned};
use std::io::Write;

/// The exporter `json`. A layout with a number that is not finite, which JSON cannot hold, is [`ErrorKind::BadInput`].
pub fn exporter() -> Box<dyn Exporter> {
    let info = PluginInfo {
        name: "json".into(),
        description: "JSON: the whole layout, for programs, by layout.schema.json".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["layout.json".into()],
        media_types: vec!["application/json".into()],
        options: vec![],
    };
    planform_sdk::exporter(info, write)
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [], exporters: [exporter()]);

fn write(document: &Document<'_>, _: &Options, out: &mut dyn Write) -> Result<(), PluginError> {
    // Every member by its name, so that none can be forgotten.
    let Layout {
        rooms,
        walls,
        openings,
        frontiers,
        lines,
        texts,
        symbols,
        anchor,
        scale,
        provenance,
        method,
    } = document.layout;
    let members = [
        list("rooms", rooms)?,
        list("walls", walls)?,
        list("openings", openings)?,
        list("frontiers", frontiers)?,
        list("lines", lines)?,
        list("texts", texts)?,
        list("symbols", symbols)?,
        member("anchor", anchor)?,
        member("scale", scale)?,
        member("provenance", provenance)?,
        member("method", method)?,
    ];
    Ok(write!(out, "{{\n{}\n}}\n", members.join(",\n"))?)
}

fn member<T: Serialize + DeserializeOwned>(name: &str, value: &T) -> Result<String, PluginError> {
    Ok(format!("\"{name}\": {}", exact(name, value)?))
}

/// A member that is an array, each element on its line.
fn list<T: Serialize + DeserializeOwned>(name: &str, items: &[T]) -> Result<String, PluginError> {
    if items.is_empty() {
        return Ok(format!("\"{name}\": []"));
    }
    let item = |(i, item)| exact(&format!("number {i} of the {name}"), item);
    let lines = (1..).zip(items).map(item).collect::<Result<Vec<_>, _>>()?;
    Ok(format!("\"{name}\": [\n{}\n]", lines.join(",\n")))
}

/// The value on one line. What JSON cannot hold turns to null in it, and is found by reading it back.
fn exact<T: Serialize + DeserializeOwned>(what: &str, value: &T) -> Result<String, PluginError> {
    let line = serde_json::to_string(value);
    let whole = line.ok().filter(|line| serde_json::from_str::<T>(line).is_ok());
    whole.ok_or_else(|| {
        let message = format!("the layout cannot be written: {what} has a number that is not finite");
        PluginError::new(ErrorKind::BadInput, message).advise("correct the layout")
    })
}
