//! What the plugin says of itself.

use planform_sdk::{Boundary, Bounds, OptionKind, OptionSpec, OptionValue, PluginInfo};

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
            OptionSpec::flag("grid", "whether the occupancy grid lies underneath as a picture", false),
            OptionSpec::flag("labels", "whether rooms carry their name or number and area", true),
            Boundary::option(),
            scale(),
        ],
    }
}

fn scale() -> OptionSpec {
    let help = "scale of the drawing on paper: 100 means 1:100, one metre as 10 mm";
    let kind = OptionKind::Number(Bounds { max: Some(1e6), ..Bounds::above(0.0) });
    OptionSpec::new("scale", help, kind, Some(OptionValue::Number(100.0)))
}
