//! What the tests share: a robot with a laser in a made-up room, and its log.

use planform_sdk::{Options, PluginError, Scene, Source};
use std::f64::consts::PI;
use std::fmt::Write;
use std::path::PathBuf;

/// The room: x and y from 0 to these, metres.
pub const ROOM: [f64; 2] = [6.0, 4.0];
/// Beams of a scan over half a turn.
pub const BEAMS: usize = 181;

/// A pose: x, y, heading.
pub type At = [f64; 3];

/// Where the robot goes: along the room, turning all the way.
pub fn way() -> Vec<At> {
    (0..40).map(|i| f64::from(i) / 40.0).map(|s| [1.0 + 4.0 * s, 2.0 + (s * 9.0).sin(), s * 13.0]).collect()
}

/// The range from a pose to the room's walls in a direction, metres.
pub fn range([x, y, _]: At, direction: f64) -> f64 {
    let along = |p: f64, side: f64, slope: f64| match slope {
        slope if slope > 1e-12 => (side - p) / slope,
        slope if slope < -1e-12 => -p / slope,
        _ => f64::INFINITY,
    };
    along(x, ROOM[0], direction.cos()).min(along(y, ROOM[1], direction.sin()))
}

/// The ranges of a scan, from the right to the left.
pub fn ranges(at: At) -> Vec<f64> {
    (0..BEAMS).map(|i| range(at, at[2] - PI / 2.0 + i as f64 * PI / 180.0)).collect()
}

pub fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(|v| format!("{v:.3}")).collect::<Vec<_>>().join(" ")
}

/// `FLASER` of these ranges, with the laser's pose and the robot's by odometry.
pub fn flaser(ranges: &[f64], laser: At, robot: At) -> String {
    format!("FLASER {} {} {} {} 1.5 host 1.5\n", ranges.len(), joined(ranges), joined(&laser), joined(&robot))
}

/// The log of the robot on its way, as a filter corrected it.
pub fn log() -> String {
    let mut log = String::from("# CARMEN Logfile\nPARAM robot_frontlaser_offset 0.0 0 host 0\n");
    for at in way() {
        let _ = writeln!(log, "ODOM {} 0 0 0 1.5 host 1.5", joined(&at));
        log += &flaser(&ranges(at), at, at);
        log += "NEFF 12.5\n";
    }
    log
}

pub fn source(name: &str, bytes: &[u8]) -> Source {
    Source { path: PathBuf::from(name), bytes: bytes.to_vec(), byte_limit: Source::BYTE_LIMIT }
}

pub fn read_bytes(bytes: &[u8], set: &[(&str, &str)]) -> Result<Scene, PluginError> {
    let adapter = planform_radish::adapter();
    let options = Options::parse(&adapter.info().options, set.iter().copied())?;
    adapter.read(&source("made up.log", bytes), &options)
}

pub fn read(log: &str) -> Scene {
    read_bytes(log.as_bytes(), &[]).unwrap()
}

/// The sentence with which this is refused.
pub fn refusal(bytes: &[u8]) -> String {
    read_bytes(bytes, &[]).unwrap_err().to_string()
}
