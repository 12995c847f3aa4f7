//! What the plugin says of itself.

use planform_sdk::{OptionKind, OptionSpec, OptionValue, PluginInfo};

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    PluginInfo {
        name: "svg".into(),
        description: "SVG drawing with layers, to scale, for browsers and Inkscape".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["svg".into()],
        media_types: vec!["image/svg+xml".into()],
        options: vec![
            flag("grid", "whether the occupancy grid lies underneath as a picture", false),
            flag("labels", "whether rooms carry their name or number and area", true),
            boundary(),
            scale(),
        ],
    }
}

fn flag(name: &str, help: &str, default: bool) -> OptionSpec {
    let default = Some(OptionValue::Flag(default));
    OptionSpec { name: name.into(), help: help.into(), kind: OptionKind::Flag, default }
}

fn boundary() -> OptionSpec {
    OptionSpec {
        name: "boundary".into(),
        help: "outline of a room: along its walls' inner faces or along their centre lines".into(),
        kind: OptionKind::Choice(vec!["inner".into(), "centre".into()]),
        default: Some(OptionValue::Text("inner".into())),
    }
}

fn scale() -> OptionSpec {
    OptionSpec {
        name: "scale".into(),
        help: "scale of the drawing on paper: 100 means 1:100, one metre as 10 mm".into(),
        kind: OptionKind::Number { above: Some(0.0), max: Some(1e6) },
        default: Some(OptionValue::Number(100.0)),
    }
}
