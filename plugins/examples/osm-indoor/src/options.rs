//! What the plugin says of itself, and the options that need a closer look.

use planform_sdk::{
    Boundary, ErrorKind, GeoAnchor, OptionKind, OptionSpec, OptionValue, Options, PluginError, PluginInfo,
};

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    PluginInfo {
        name: "osm-indoor".into(),
        description: "OpenStreetMap data: rooms, walls and doors by Simple Indoor Tagging".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: vec!["osm".into()],
        media_types: vec!["application/vnd.openstreetmap.data+xml".into()],
        options: vec![GeoAnchor::option("an error"), boundary(), level_option()],
    }
}

/// The usual option, but by default along the centre lines, where neighbours share nodes.
fn boundary() -> OptionSpec {
    OptionSpec { default: Some(OptionValue::Text("centre".into())), ..Boundary::option() }
}

fn level_option() -> OptionSpec {
    let help =
        "value of the tag `level`: the floor's number, 0 for the ground floor, or several, such as 0;1";
    OptionSpec::new("level", help, OptionKind::Text, Some(OptionValue::Text("0".into())))
}

/// The level that was chosen: numbers, with semicolons between them.
pub fn level(options: &Options) -> Result<&str, PluginError> {
    let level = options.text("level").unwrap_or("0");
    if level.split(';').all(is_number) {
        return Ok(level);
    }
    let message = format!("option `level` cannot be `{level}`");
    Err(PluginError::new(ErrorKind::BadOption, message).advise("give a number, such as 0, -1 or 0.5, or 0;1"))
}

/// Whether this is a plain decimal number: Rust would read `inf` and `1e3` as well.
fn is_number(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_digit() || matches!(c, '-' | '.')) && text.parse::<f64>().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_numbers() {
        for (given, good) in [
            ("0", true),
            ("-1", true),
            ("0.5;1", true),
            ("", false),
            ("EG", false),
            ("0;", false),
            ("inf", false),
        ] {
            let options = Options::parse(&info().options, [("level", given)]).unwrap();
            assert_eq!(level(&options).is_ok(), good, "{given}");
        }
    }
}
