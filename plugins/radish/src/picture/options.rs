//! The options that pictures have.

use super::{Lines, PictureParams};
use planform_sdk::{Bounds, OptionKind, OptionSpec, Options};

/// Metres per pixel unless the user says otherwise.
const RESOLUTION: f64 = 0.05;

/// The options of pictures; `resolution` is one that logs have as well.
pub fn specs() -> Vec<OptionSpec> {
    let grey = |name: &str, help: &str| {
        let bounds = Bounds { min: Some(0.0), max: Some(255.0), whole: true, ..Bounds::default() };
        OptionSpec::new(name, help, OptionKind::Number(bounds), None)
    };
    vec![
        grey("free-grey", "Pictures: the grey of free space, 0 to 255, instead of that found"),
        grey("unknown-grey", "Pictures: the grey of unknown space, 0 to 255, instead of that found"),
        grey("wall-grey", "Pictures: the grey of walls, 0 to 255, instead of that found"),
        OptionSpec::choice(
            "trajectory",
            "Pictures: whether thin coloured lines are taken off the map, or kept with the grey that they have",
            &["remove", "keep"],
            "remove",
        ),
    ]
}

impl PictureParams {
    /// Reads the options.
    pub fn of(options: &Options) -> Self {
        // Checked against their bounds before, they fit.
        let grey = |name| options.number(name).map(|grey| grey as u8);
        Self {
            resolution: options.number("resolution").unwrap_or(RESOLUTION),
            free: grey("free-grey"),
            unknown: grey("unknown-grey"),
            wall: grey("wall-grey"),
            lines: if options.text("trajectory") == Some("keep") { Lines::Keep } else { Lines::Remove },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greys_and_lines_are_the_users() {
        let given = [("free-grey", "200"), ("unknown-grey", "0"), ("trajectory", "keep")];
        let params = PictureParams::of(&Options::parse(&specs(), given).unwrap());
        assert_eq!((params.free, params.unknown, params.wall), (Some(200), Some(0), None));
        assert_eq!((params.lines, params.resolution), (Lines::Keep, RESOLUTION));
        assert!(Options::parse(&specs(), [("wall-grey", "256")]).is_err());
    }
}
