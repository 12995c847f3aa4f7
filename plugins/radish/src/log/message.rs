//! One line of a CARMEN log as a message.
//!
//! The format is that of CARMEN's logger, which begins a log with a comment that describes it: a line holds the
//! message's name, its fields, and then the time of the message, the host, and the time of the logger.

use super::Pose;
use super::fields::{Damage, Fields};

/// Messages that are known and say nothing of use here.
const PASSED_OVER: [&str; 19] = [
    "SYNC",
    "TRUEPOS",
    "LASER",
    "LASER3",
    "LASER4",
    "RAWLASER1",
    "RAWLASER2",
    "RAWLASER3",
    "RAWLASER4",
    "RAWLASER5",
    "NMEAGGA",
    "NMEARMC",
    "GPSGGA",
    "GPSRMC",
    "SONAR",
    "MARKER",
    "IMU",
    "SCANMARK",
    "POSITIONLASER",
];

/// The fields after the readings and poses of a message: when, on which host, when by the logger.
const TRAILER: usize = 3;

/// What a line says.
#[derive(Debug, Clone, PartialEq)]
pub enum Message<'a> {
    /// A sweep of a laser.
    Sweep(Sweep),
    /// The robot's pose by odometry.
    Odometry(Pose),
    /// A parameter's name and value.
    Parameter(&'a str, &'a str),
    /// How many particles of a filter are effective: only a program that corrects poses writes it.
    Filter,
    /// A comment, or a message that says nothing of use.
    Nothing,
    /// A message of a kind that is not known.
    Unknown(&'a str),
    /// No message.
    Noise,
}

/// Which laser a sweep is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mount {
    /// One that looks forward: `FLASER`, `ROBOTLASER0` and `ROBOTLASER1`.
    Front,
    /// One that looks back: `RLASER`, `ROBOTLASER2`.
    Rear,
}

/// A sweep as its message states it.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Which laser it is of.
    pub mount: Mount,
    /// What the message states of the laser; the old ones, `FLASER` and `RLASER`, state nothing.
    pub laser: Option<Geometry>,
    /// Metres.
    pub ranges: Vec<f32>,
    /// The laser's pose.
    pub pose: Pose,
    /// The robot's pose by odometry.
    pub robot: Pose,
    /// Seconds, or 0 where the message has none.
    pub time: f64,
}

/// The beams of a laser.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    /// Direction of the first beam from the laser's heading, radians.
    pub first_angle: f64,
    /// Turn from one beam to the next, radians.
    pub step: f64,
    /// Where echoes end, metres.
    pub max_range: f64,
}

impl<'a> Message<'a> {
    /// What this line says. `whole` is whether all of the line is there; if not, it must have its last field.
    ///
    /// # Errors
    /// When a message that is needed is damaged.
    pub fn of(line: &'a str, whole: bool) -> Result<Self, Damage> {
        let mut fields = Fields::of(line);
        let Some(name) = fields.text() else { return Ok(Self::Nothing) };
        match name {
            "FLASER" => sweep(&mut fields, Mount::Front, whole).map(Self::Sweep),
            "RLASER" => sweep(&mut fields, Mount::Rear, whole).map(Self::Sweep),
            "ROBOTLASER0" | "ROBOTLASER1" => robot_laser(&mut fields, Mount::Front, whole).map(Self::Sweep),
            "ROBOTLASER2" => robot_laser(&mut fields, Mount::Rear, whole).map(Self::Sweep),
            "ODOM" => odometry(&mut fields, whole),
            "PARAM" => Ok(parameter(&mut fields)),
            "NEFF" => Ok(Self::Filter),
            _ => Ok(other(name)),
        }
    }
}

fn other(name: &str) -> Message<'_> {
    // Early loggers broke the describing comment into lines that lack the sign of a comment.
    let passed_over = name.starts_with('#') || name == "message_name" || PASSED_OVER.contains(&name);
    let is_name = name.starts_with(|c: char| c.is_ascii_uppercase())
        && name.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit() || b == b'_');
    match (passed_over, is_name) {
        (true, _) => Message::Nothing,
        (_, true) => Message::Unknown(name),
        _ => Message::Noise,
    }
}

/// `FLASER n r.. x y theta odom_x odom_y odom_theta time host logger_time`
fn sweep(fields: &mut Fields<'_>, mount: Mount, whole: bool) -> Result<Sweep, Damage> {
    let ranges = fields.readings("readings")?;
    let (pose, robot) = (fields.pose("laser")?, fields.pose("robot")?);
    let time = trailer(fields, whole)?;
    Ok(Sweep { mount, laser: None, ranges, pose, robot, time })
}

/// `ROBOTLASER1 type start_angle field_of_view resolution max_range accuracy remission_mode n r.. m remission..
/// laser_pose robot_pose tv rv forward_distance side_distance turn_axis time host logger_time`
fn robot_laser(fields: &mut Fields<'_>, mount: Mount, whole: bool) -> Result<Sweep, Damage> {
    fields.number("the laser's type")?;
    let first_angle = fields.finite("the start angle")?;
    fields.number("the field of view")?;
    let step = fields.finite("the angular resolution")?;
    let max_range = fields.number("the maximum range")?;
    fields.number("the accuracy")?;
    fields.number("the remission mode")?;
    let ranges = fields.readings("readings")?;
    fields.readings("remissions")?;
    let (pose, robot) = (fields.pose("laser")?, fields.pose("robot")?);
    // Two velocities and two distances; the turning axis came later.
    fields.skip_to_last(TRAILER);
    let time = trailer(fields, whole)?;
    Ok(Sweep { mount, laser: Some(Geometry { first_angle, step, max_range }), ranges, pose, robot, time })
}

/// `ODOM x y theta tv rv accel time host logger_time`
fn odometry(fields: &mut Fields<'_>, whole: bool) -> Result<Message<'static>, Damage> {
    let pose = fields.pose("robot")?;
    trailer(fields, whole)?;
    Ok(Message::Odometry(pose))
}

/// The time of the message, 0 where there is none.
fn trailer(fields: &mut Fields<'_>, whole: bool) -> Result<f64, Damage> {
    if !whole && fields.left() < TRAILER {
        return Err("it is cut off".into());
    }
    Ok(fields.text().and_then(|t| t.parse().ok()).filter(|t: &f64| t.is_finite()).unwrap_or(0.0))
}

fn parameter<'a>(fields: &mut Fields<'a>) -> Message<'a> {
    match (fields.text(), fields.text()) {
        (Some(name), Some(value)) => Message::Parameter(name, value),
        _ => Message::Nothing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pose(x: f64, y: f64, theta: f64) -> Pose {
        Pose { x, y, theta }
    }

    fn read(line: &str) -> Sweep {
        match Message::of(line, true) {
            Ok(Message::Sweep(sweep)) => sweep,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn old_messages_state_the_lasers_pose_and_then_the_robots() {
        let sweep = read("RLASER 3 1.5 2 81.91 1 2 3 4 5 6 12.5 host 0.1");
        assert_eq!((sweep.mount, sweep.laser, sweep.time), (Mount::Rear, None, 12.5));
        assert_eq!(sweep.ranges, [1.5, 2.0, 81.91]);
        assert_eq!((sweep.pose, sweep.robot), (pose(1.0, 2.0, 3.0), pose(4.0, 5.0, 6.0)));
    }

    #[test]
    fn new_messages_state_the_laser_as_well() {
        let laser = Geometry { first_angle: -1.5, step: 0.5, max_range: 50.0 };
        for moving in ["0.1 0 0.5 0.5", "0.1 0 0.5 0.5 1e6"] {
            let line = format!("ROBOTLASER1 0 -1.5 3 0.5 50 0.01 1 2 1 2 2 7 8 1 2 3 4 5 6 {moving} 9.5 h 1");
            let sweep = read(&line);
            assert_eq!((sweep.mount, sweep.laser, sweep.time), (Mount::Front, Some(laser), 9.5));
            assert_eq!((sweep.ranges, sweep.pose.x, sweep.robot.x), (vec![1.0, 2.0], 1.0, 4.0));
        }
    }

    #[test]
    fn a_line_that_is_cut_off_must_have_its_last_field() {
        let line = "FLASER 1 1.5 1 2 3 4 5 6 7 host 8";
        for cut in 7..line.len() - 1 {
            assert!(Message::of(&line[..cut], false).is_err(), "{}", &line[..cut]);
        }
        assert!(Message::of(line, false).is_ok());
    }

    #[test]
    fn other_lines_are_told_apart() {
        for (line, expected) in [
            ("", Message::Nothing),
            ("# FLASER", Message::Nothing),
            ("SYNC x", Message::Nothing),
            ("NEFF 12.5", Message::Filter),
            ("PARAM robot_front_laser_max 50 0 h 0", Message::Parameter("robot_front_laser_max", "50")),
            ("PARAM x", Message::Nothing),
            ("WIFI 1 2", Message::Unknown("WIFI")),
            ("hello", Message::Noise),
            ("12 13", Message::Noise),
            ("ODOM 1 2 3 0 0 0 7 h 8", Message::Odometry(pose(1.0, 2.0, 3.0))),
        ] {
            assert_eq!(Message::of(line, true), Ok(expected), "{line}");
        }
    }
}
