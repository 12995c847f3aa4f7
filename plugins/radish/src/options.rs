//! What the adapter says of itself, and its options.

use crate::log::LaserChoice;
use crate::mapping::{MappingParams, Odds};
use crate::picture;
use planform_sdk::{Bounds, OptionKind, OptionSpec, OptionValue, Options, PluginInfo};

/// The adapter's name.
pub const NAME: &str = "radish";
/// Width of a cell unless the user says otherwise, metres: what robots' maps have by default.
const RESOLUTION: f64 = 0.05;
/// How far beams reach unless the user says otherwise, metres.
const REACH: f64 = 80.0;
/// What votes are worth unless the user says otherwise: two beams that pass make a cell free as the reconstruction
/// judges it, so that a stray one does not; and one that ends weighs two that pass, for beams along a wall graze it.
const ODDS: Odds = Odds { hit: 0.9, miss: 0.25 };

/// Which poses the scans are drawn from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poses {
    /// The log's own if they were corrected, and matched ones if they are odometry.
    Auto,
    /// The log's own.
    Log,
    /// Those of odometry alone.
    Odometry,
    /// Those of odometry, corrected by matching scans.
    Matched,
}

/// What the user asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// Which poses.
    pub poses: Poses,
    /// What the log does not say of the laser.
    pub laser: LaserChoice,
    /// How scans are drawn.
    pub mapping: MappingParams,
}

impl Request {
    /// Reads the options.
    pub fn of(options: &Options) -> Self {
        let number = |name, default| options.number(name).unwrap_or(default);
        let poses = match options.text("poses") {
            Some("log") => Poses::Log,
            Some("odometry") => Poses::Odometry,
            Some("matched") => Poses::Matched,
            _ => Poses::Auto,
        };
        Self {
            poses,
            laser: LaserChoice {
                view: options.number("field-of-view").map(f64::to_radians),
                offset: number("laser-offset", 0.0),
            },
            mapping: MappingParams {
                resolution: number("resolution", RESOLUTION),
                reach: number("max-range", REACH),
                odds: Odds { hit: number("hit-odds", ODDS.hit), miss: number("miss-odds", ODDS.miss) },
            },
        }
    }
}

/// Name, extensions, options.
pub fn info() -> PluginInfo {
    let words = |list: &[&str]| list.iter().map(|&w| w.to_owned()).collect();
    PluginInfo {
        name: NAME.into(),
        description: "Radish: CARMEN laser logs, plain, gzip or bzip2, and map pictures with a robot's way drawn on them".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        licence: env!("CARGO_PKG_LICENSE").into(),
        extensions: words(&["log", "clf", "gfs", "log.gz", "log.bz2"]),
        media_types: words(&["text/plain", "application/gzip", "application/x-bzip2", "image/gif"]),
        options: specs(),
    }
}

fn specs() -> Vec<OptionSpec> {
    let mut specs = logs();
    specs.extend(picture::specs());
    specs
}

/// The options of logs.
fn logs() -> Vec<OptionSpec> {
    vec![
        number("resolution", "Width of a cell, metres", above(0.0), Some(RESOLUTION)),
        OptionSpec::choice(
            "poses",
            "The poses that scans are drawn from: the log's, those of odometry alone, or these corrected by matching scans; auto takes the log's if they were corrected, else matches",
            &["auto", "log", "odometry", "matched"],
            "auto",
        ),
        number(
            "max-range",
            "Metres that beams reach; one that ends farther away frees the way up to there and draws no obstacle",
            above(0.0),
            Some(REACH),
        ),
        number(
            "field-of-view",
            "Degrees from a scan's first beam to its last, instead of what the log says",
            Bounds { max: Some(360.0), ..above(0.0) },
            None,
        ),
        number(
            "laser-offset",
            "Metres that the laser lies ahead of the poses in the log, should these be the robot's",
            Bounds { min: Some(-100.0), max: Some(100.0), ..Bounds::default() },
            Some(0.0),
        ),
        number(
            "hit-odds",
            "Probability of an obstacle where one beam ends",
            Bounds { below: Some(1.0), ..above(0.5) },
            Some(ODDS.hit),
        ),
        number(
            "miss-odds",
            "Probability of an obstacle where one beam passes",
            Bounds { below: Some(0.5), ..above(0.0) },
            Some(ODDS.miss),
        ),
    ]
}

fn above(above: f64) -> Bounds {
    Bounds::above(above)
}

fn number(name: &str, help: &str, bounds: Bounds, default: Option<f64>) -> OptionSpec {
    OptionSpec::new(name, help, OptionKind::Number(bounds), default.map(OptionValue::Number))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(given: &[(&str, &str)]) -> Request {
        Request::of(&Options::parse(&specs(), given.iter().copied()).unwrap())
    }

    #[test]
    fn options_are_in_the_users_units() {
        let all = request(&[("field-of-view", "180"), ("poses", "odometry"), ("resolution", "0.1")]);
        assert_eq!((all.laser.view, all.poses), (Some(std::f64::consts::PI), Poses::Odometry));
        assert_eq!((all.mapping.resolution, all.mapping.reach), (0.1, REACH));
        assert_eq!((request(&[]).poses, request(&[]).mapping.odds), (Poses::Auto, ODDS));
    }
}
