//! Reads a whole CARMEN log.

use super::fields::{Damage, shortened};
use super::geometry::{geometry, no_echo};
use super::lines::{End, Line, Lines};
use super::message::{Message, Mount, Sweep};
use super::odometry::{Around, judge};
use super::parameters::Parameters;
use super::{Log, Pose, Scan};
use planform_sdk::{ErrorKind, Place, PluginError};
use std::f64::consts::{FRAC_PI_2, PI};
use std::io::BufRead;

/// The most readings of a log: 256 MiB of them.
const MOST_READINGS: usize = 1 << 26;
/// The most scans of a log: a day's at ten a second.
const MOST_SCANS: usize = 1 << 20;
/// How many kinds of unknown messages a warning names.
const MOST_NAMES: usize = 5;

/// What the user knows better than the log.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LaserChoice {
    /// Angle from the first beam to the last, radians.
    pub view: Option<f64>,
    /// How far the laser lies ahead of the poses that the log states, metres.
    pub offset: f64,
}

/// What is known of a log while it is read.
#[derive(Default)]
struct Reading {
    sweeps: Vec<Sweep>,
    around: Vec<Around>,
    odometry: Option<Pose>,
    /// Odometry messages since the last sweep.
    count: usize,
    parameters: Parameters,
    filtered: bool,
    readings: usize,
    /// Lines that are messages.
    messages: usize,
    /// Lines that are no message, or none that is known.
    strange: usize,
    /// Lines that are no message.
    noise: usize,
    /// The names of the first unknown messages.
    unknown: Vec<String>,
    damaged: usize,
    first_damage: Option<(usize, Damage)>,
    cut: Option<usize>,
}

/// Reads a log's text.
///
/// # Errors
/// When the text is no log, when none of its sweeps can be read, and when it is larger than a log may be.
pub fn read(text: impl BufRead, choice: LaserChoice) -> Result<Log, PluginError> {
    let mut lines = Lines::new(text);
    let mut reading = Reading::default();
    while let Some(line) = lines.next()? {
        reading.take(line)?;
    }
    let broken = lines.damage().map(|e| unpacking(e, lines.number()));
    reading.check(broken.as_deref())?;
    Ok(reading.finish(broken, choice))
}

/// Whether a text that begins like this is a log: it has a message that only logs have, and hardly a line that is none.
pub fn is_log(head: &[u8]) -> bool {
    let mut reading = Reading::default();
    let whole = head.iter().rposition(|b| *b == b'\n').map_or(head, |end| &head[..end]);
    for bytes in whole.split(|b| *b == b'\n') {
        // Nothing to say here of what is damaged: the first sweep may be longer than the head.
        let _: Result<(), PluginError> = reading.take(Line { bytes, end: End::Text, number: 0 });
    }
    let known = reading.messages > 0 || begins_as_sweep(head);
    known && reading.noise <= reading.messages
}

/// Whether the text begins with a sweep, all of which the head may be too short for.
fn begins_as_sweep(head: &[u8]) -> bool {
    let beginning = String::from_utf8_lossy(&head[..head.len().min(100)]).into_owned();
    let mut fields = beginning.split_ascii_whitespace();
    let named = fields.next().is_some_and(|n| ["FLASER", "RLASER", "ROBOTLASER1"].contains(&n));
    let mut numbers = fields.take(3).map(|f| f.parse::<f64>().is_ok());
    named && numbers.next().is_some_and(|first| first && numbers.all(|n| n))
}

fn unpacking(error: &std::io::Error, line: usize) -> String {
    let what = match error.kind() {
        std::io::ErrorKind::UnexpectedEof => "the packed log is cut off",
        _ => "the packed log is damaged",
    };
    format!("{what} in or after line {line} of its text")
}

impl Reading {
    /// Takes in one line.
    fn take(&mut self, line: Line<'_>) -> Result<(), PluginError> {
        // Old logs have comments in other encodings.
        match Message::of(&String::from_utf8_lossy(line.bytes), line.end == End::Whole) {
            Ok(message) => return self.message(message, line.number),
            Err(_) if line.end == End::Text => self.cut = Some(line.number),
            Err(damage) => {
                self.damaged += 1;
                self.first_damage.get_or_insert((line.number, damage));
            }
        }
        Ok(())
    }

    fn message(&mut self, message: Message<'_>, number: usize) -> Result<(), PluginError> {
        self.messages +=
            usize::from(!matches!(message, Message::Nothing | Message::Noise | Message::Unknown(_)));
        match message {
            Message::Sweep(sweep) => return self.sweep(sweep, number),
            Message::Odometry(pose) => self.odometry(pose),
            Message::Parameter(name, value) => self.parameters.take(name, value),
            Message::Filter => self.filtered = true,
            Message::Unknown(name) => self.unknown(shortened(name)),
            Message::Noise => (self.noise, self.strange) = (self.noise + 1, self.strange + 1),
            Message::Nothing => {}
        }
        Ok(())
    }

    fn unknown(&mut self, name: String) {
        self.strange += 1;
        if self.unknown.len() < MOST_NAMES && !self.unknown.contains(&name) {
            self.unknown.push(name);
        }
    }

    fn odometry(&mut self, pose: Pose) {
        self.odometry = Some(pose);
        self.count += 1;
        if self.count == 1
            && let Some(last) = self.around.last_mut()
        {
            last.after = Some(pose);
        }
    }

    fn sweep(&mut self, sweep: Sweep, number: usize) -> Result<(), PluginError> {
        self.readings += sweep.ranges.len();
        let counts =
            [(self.readings, MOST_READINGS, "readings"), (self.sweeps.len() + 1, MOST_SCANS, "scans")];
        if let Some((_, most, what)) = counts.iter().find(|(count, most, _)| count > most) {
            let message = format!("the log has more than {most} {what}");
            return Err(PluginError::new(ErrorKind::Limit, message)
                .at(Place::Line(number))
                .advise("cut it into parts"));
        }
        self.around.push(Around { before: self.odometry, count: self.count, after: None });
        self.sweeps.push(sweep);
        self.count = 0;
        Ok(())
    }

    /// Fails when there is nothing to make a map of.
    fn check(&self, broken: Option<&str>) -> Result<(), PluginError> {
        let bad = |message: String| Err(PluginError::new(ErrorKind::BadInput, message));
        if self.readings > 0 {
            return Ok(());
        }
        if let Some((line, damage)) = &self.first_damage {
            let message = format!("no sweep of a laser can be used; the first damage is that {damage}");
            return Err(PluginError::new(ErrorKind::BadInput, message)
                .at(Place::Line(*line))
                .advise("the log may be damaged"));
        }
        match (broken, self.cut, self.messages) {
            (Some(broken), ..) => bad(format!("{broken}, and there is no sweep of a laser before")),
            (None, Some(_), _) => bad("the log is cut off within its first sweep".into()),
            (None, None, 0) => {
                bad("no line is a message of a CARMEN log; such logs have lines that begin with FLASER"
                    .into())
            }
            _ => bad("the log has no sweep of a laser: neither FLASER, RLASER nor ROBOTLASER1".into()),
        }
    }

    fn finish(mut self, broken: Option<String>, choice: LaserChoice) -> Log {
        turn_rear(&mut self.sweeps);
        let judged = judge(&self.sweeps, &self.around, &self.parameters, self.filtered);
        let warnings = self.warnings(broken);
        let end = no_echo(self.sweeps.iter().map(|s| s.ranges.as_slice())).unwrap_or(f64::INFINITY);
        let odometry: Vec<Option<Pose>> = match judged.odometry {
            Some(poses) => poses.into_iter().map(Some).collect(),
            None => vec![None; self.sweeps.len()],
        };
        let parameters = self.parameters;
        let scan = |(sweep, odometry)| scan(sweep, odometry, &parameters, end, choice);
        let scans = self.sweeps.into_iter().zip(odometry).map(scan).collect();
        Log { scans, poses: judged.kind, warnings }
    }

    fn warnings(&self, broken: Option<String>) -> Vec<String> {
        let cut = self.cut.filter(|_| broken.is_none());
        let cut = cut.map(|line| format!("the log is cut off in line {line}; it is used up to there"));
        let broken = broken.map(|b| format!("{b}; it is used up to there"));
        [broken, cut, self.damage_warning(), self.unknown_warning(), self.number_warning()]
            .into_iter()
            .flatten()
            .collect()
    }

    fn damage_warning(&self) -> Option<String> {
        let (line, damage) = self.first_damage.as_ref()?;
        let (are, lines) = if self.damaged == 1 { ("is", "line") } else { ("are", "lines") };
        Some(format!("{} {lines} {are} damaged and left out, first line {line}: {damage}", self.damaged))
    }

    fn unknown_warning(&self) -> Option<String> {
        let names = self.unknown.join(", ");
        let named = if names.is_empty() { String::new() } else { format!(" ({names})") };
        let count = self.strange;
        (count > 0).then(|| format!("{count} lines are left out that are no messages known here{named}"))
    }

    fn number_warning(&self) -> Option<String> {
        let odd = |r: &&f32| !r.is_finite() || **r < 0.0;
        let count = self.sweeps.iter().flat_map(|s| &s.ranges).filter(odd).count();
        (count > 0).then(|| {
            format!("{count} of {} readings are not finite or negative and count as no echo", self.readings)
        })
    }
}

/// Old messages of a rear laser state the robot's heading or the laser's own, as the logger had it. The first one tells,
/// for there corrected headings have not moved far from the robot's odometry.
fn turn_rear(sweeps: &mut [Sweep]) {
    let is_rear = |s: &&mut Sweep| s.mount == Mount::Rear && s.laser.is_none();
    let mut rear = sweeps.iter_mut().filter(is_rear).peekable();
    let forward = rear.peek().is_some_and(|s| s.robot.turn(s.pose).abs() < FRAC_PI_2);
    rear.filter(|_| forward).for_each(|s| s.pose.theta += PI);
}

/// The sweep with its beams; `end` is where the log's readings begin to mean no echo, metres.
fn scan(
    sweep: Sweep,
    odometry: Option<Pose>,
    parameters: &Parameters,
    end: f64,
    choice: LaserChoice,
) -> Scan {
    let geometry = geometry(&sweep, parameters, choice.view);
    let ahead = Pose { x: choice.offset, ..Pose::IDENTITY };
    Scan {
        first_angle: geometry.first_angle,
        step: geometry.step,
        max_range: geometry.max_range.min(end),
        pose: sweep.pose.then(ahead),
        odometry: odometry.map(|o| o.then(ahead)),
        time: sweep.time,
        ranges: sweep.ranges,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scans_and_readings_are_bounded() {
        let sweep = |ranges| Sweep {
            mount: Mount::Front,
            laser: None,
            ranges,
            pose: Pose::IDENTITY,
            robot: Pose::IDENTITY,
            time: 0.0,
        };
        let refused = |reading: &mut Reading| reading.sweep(sweep(vec![1.0]), 7).unwrap_err().to_string();
        let mut full = Reading { readings: MOST_READINGS, ..Reading::default() };
        assert_eq!(refused(&mut full), "line 7: the log has more than 67108864 readings; cut it into parts");
        let mut many = Reading { sweeps: vec![sweep(vec![]); MOST_SCANS], ..Reading::default() };
        assert_eq!(refused(&mut many), "line 7: the log has more than 1048576 scans; cut it into parts");
    }
}
