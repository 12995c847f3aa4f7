//! What the plugin says of itself.

use planform_sdk::{
    Boundary, ErrorKind, OptionKind, OptionSpec, OptionValue, Options, PluginError, PluginInfo,
};

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
    let help = "scale of the drawing on paper: 1:100, or 100, draws one metre as 10 mm";
    OptionSpec::new("scale", help, OptionKind::Text, Some(OptionValue::Text("1:100".into())))
}

/// How many times larger the building is than the drawing.
///
/// # Errors
/// When the option `scale` is no such number above 0 and up to a million.
pub fn ratio(options: &Options) -> Result<f64, PluginError> {
    let text = options.text("scale").unwrap_or("100");
    let ratio = text.trim().strip_prefix("1:").unwrap_or(text).trim().parse();
    ratio.ok().filter(|r| *r > 0.0 && *r <= 1e6).ok_or_else(|| {
        PluginError::new(ErrorKind::BadOption, format!("option `scale` cannot be `{text}`"))
            .advise("give a scale such as 1:100")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(scale: &str) -> Option<f64> {
        ratio(&Options::parse(&info().options, [("scale", scale)]).unwrap()).ok()
    }

    #[test]
    fn scales_are_ratios() {
        assert_eq!((of("1:50"), of("50"), of(" 1: 2.5 ")), (Some(50.0), Some(50.0), Some(2.5)));
        for wrong in ["", "0", "-1", "1:0", "nan", "1:1e9", "2:1"] {
            assert_eq!(of(wrong), None, "{wrong}");
        }
    }
}
