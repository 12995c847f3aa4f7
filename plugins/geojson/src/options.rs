//! What the plugin says of itself.

use planform_sdk::{Boundary, OptionKind, OptionSpec, PluginInfo};

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    PluginInfo {
        name: "geojson".into(),
        description: "GeoJSON: rooms, walls, doors as features, in metres or on the Earth".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["geojson".into(), "json".into()],
        media_types: vec!["application/geo+json".into()],
        options: vec![anchor(), Boundary::option(), lines()],
    }
}

fn anchor() -> OptionSpec {
    let help = "LAT,LON,BEARING: where the map's origin lies (WGS 84, degrees) and where its y axis points \
                (degrees clockwise from north); else the document's own anchor, else metres";
    OptionSpec::new("anchor", help, OptionKind::Text, None)
}

fn lines() -> OptionSpec {
    OptionSpec::flag("lines", "whether the lines along which walls are aligned are written too", false)
}
