//! What the plugin says of itself.

use planform_sdk::{Boundary, GeoAnchor, OptionSpec, PluginInfo};

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    PluginInfo {
        name: "geojson".into(),
        description: "GeoJSON: rooms, walls, doors as features, in metres or on the Earth".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["geojson".into(), "json".into()],
        media_types: vec!["application/geo+json".into()],
        options: vec![GeoAnchor::option("metres"), Boundary::option(), lines()],
    }
}

fn lines() -> OptionSpec {
    OptionSpec::flag("lines", "whether the lines along which walls are aligned are written too", false)
}
