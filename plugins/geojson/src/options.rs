//! What the plugin says of itself.

use planform_sdk::{OptionKind, OptionSpec, OptionValue, PluginInfo};

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    PluginInfo {
        name: "geojson".into(),
        description: "GeoJSON: rooms, walls, doors as features, in metres or on the Earth".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["geojson".into(), "json".into()],
        media_types: vec!["application/geo+json".into()],
        options: vec![anchor(), boundary(), lines()],
    }
}

fn anchor() -> OptionSpec {
    OptionSpec {
        name: "anchor".into(),
        help: "LAT,LON,BEARING: where the map's origin lies (WGS 84, degrees) and where its y axis points \
               (degrees clockwise from north); else the document's own anchor, else metres"
            .into(),
        kind: OptionKind::Text,
        default: None,
    }
}

fn boundary() -> OptionSpec {
    OptionSpec {
        name: "boundary".into(),
        help: "outline of a room: along its walls' inner faces or along their centre lines".into(),
        kind: OptionKind::Choice(vec!["inner".into(), "centre".into()]),
        default: Some(OptionValue::Text("inner".into())),
    }
}

fn lines() -> OptionSpec {
    OptionSpec {
        name: "lines".into(),
        help: "whether the lines along which walls are aligned are written too".into(),
        kind: OptionKind::Flag,
        default: Some(OptionValue::Flag(false)),
    }
}
