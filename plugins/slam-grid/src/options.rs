//! What the adapter says of itself, and its options.

use planform_sdk::{
    Bounds, ErrorKind, OptionKind, OptionSpec, OptionValue, Options, PluginError, PluginInfo,
};

/// The adapter's name.
pub const NAME: &str = "slam-grid";
/// Metres per pixel of a bare picture unless the user says otherwise: what robots' maps have by default.
pub const BARE_RESOLUTION: f64 = 0.05;

/// Which greys of a bare picture mean unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unknown {
    /// Those found in the picture.
    Auto,
    /// None.
    None,
    /// This one.
    Grey(u8),
}

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    let words = |list: &[&str]| list.iter().map(|&w| w.to_owned()).collect::<Vec<_>>();
    PluginInfo {
        name: NAME.into(),
        description: "Robot maps: ROS map_server YAML files, or bare PGM, PNG, BMP, TIFF, JPEG pictures"
            .into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: words(&[
            "yaml", "yml", "pgm", "png", "pnm", "pbm", "ppm", "pam", "bmp", "tif", "tiff", "jpg", "jpeg",
        ]),
        media_types: words(&[
            "application/yaml",
            "image/x-portable-graymap",
            "image/png",
            "image/bmp",
            "image/tiff",
            "image/jpeg",
        ]),
        options: specs(),
    }
}

fn specs() -> Vec<OptionSpec> {
    let spec = |name: &str, help: &str, kind, default| OptionSpec {
        name: name.into(),
        help: help.into(),
        kind,
        default,
    };
    vec![
        spec(
            "resolution",
            "Metres per pixel; 0.05 for a bare picture, and what it says for a YAML file",
            OptionKind::Number(Bounds::above(0.0)),
            None,
        ),
        spec(
            "negate",
            "Bare pictures: walls are light and free space is dark",
            OptionKind::Flag,
            Some(OptionValue::Flag(false)),
        ),
        spec(
            "unknown",
            "Bare pictures: the grey of unknown space, 0 to 255 as in the picture; auto finds it, none is none",
            OptionKind::Text,
            Some(OptionValue::Text("auto".into())),
        ),
    ]
}

/// Reads the option `unknown`.
pub fn unknown(options: &Options) -> Result<Unknown, PluginError> {
    match options.text("unknown").map(str::trim) {
        None | Some("auto") => Ok(Unknown::Auto),
        Some("none") => Ok(Unknown::None),
        Some(grey) => grey.parse().map(Unknown::Grey).map_err(|_| {
            PluginError::new(ErrorKind::BadOption, format!("option `unknown` cannot be `{grey}`"))
                .advise("give auto, none or a grey from 0 to 255")
        }),
    }
}
