//! Whether a log's poses were corrected, and what odometry alone said.
//!
//! Logs tell it in one of three ways. A message has two poses: the laser's, which may be corrected, and the robot's by
//! odometry. Programs that correct poses write the corrected one twice, and then the `ODOM` messages tell: either they are
//! the odometry as it was, or, as GMapping's logs have it, they begin anew at every scan with its corrected pose and go on
//! from there by odometry. What the clocks say is not asked, for in such logs it often means nothing.

use super::message::{Mount, Sweep};
use super::parameters::Parameters;
use super::{Pose, PoseKind};

/// How much the place of the laser on the robot may vary before the laser's poses are corrected ones, metres and
/// radians: ten times what two-digit numbers lose.
const ROUNDING: (f64, f64) = (0.05, 0.05);
/// How far apart two poses may be that are the same, metres and radians: what logs' digits lose.
const EQUAL: f64 = 2e-3;

/// The odometry messages around a sweep.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Around {
    /// The last one before it.
    pub before: Option<Pose>,
    /// How many there are between the sweep before and this one.
    pub count: usize,
    /// The first one between it and the next sweep.
    pub after: Option<Pose>,
}

/// What is known of the scans' poses.
pub struct Judged {
    /// Where the stated poses come from.
    pub kind: PoseKind,
    /// The lasers' poses by odometry alone, one for each scan, where the log has them apart from the stated ones.
    pub odometry: Option<Vec<Pose>>,
}

/// Judges the poses of these sweeps. `filtered` is whether the log holds messages of a filter that corrects poses.
pub fn judge(sweeps: &[Sweep], around: &[Around], parameters: &Parameters, filtered: bool) -> Judged {
    if moves_on_the_robot(sweeps) {
        let odometry = sweeps.iter().map(|s| s.robot.then(mounted(s.mount, parameters))).collect();
        return Judged { kind: PoseKind::Corrected, odometry: Some(odometry) };
    }
    if !filtered {
        return Judged { kind: PoseKind::Odometry, odometry: None };
    }
    let anew = begins_anew(sweeps, around);
    let odometry = if anew { chained(sweeps, around) } else { apart(sweeps, around, parameters) };
    Judged { kind: PoseKind::Corrected, odometry }
}

/// Where a laser sits on the robot.
fn mounted(mount: Mount, parameters: &Parameters) -> Pose {
    match mount {
        Mount::Front => Pose { x: parameters.front_offset.unwrap_or(0.0), ..Pose::IDENTITY },
        Mount::Rear => Pose { x: parameters.rear_offset.unwrap_or(0.0), y: 0.0, theta: std::f64::consts::PI },
    }
}

/// Whether a laser is not always at the same place of the robot, by the two poses of each message: then these are a
/// corrected pose and one by odometry.
fn moves_on_the_robot(sweeps: &[Sweep]) -> bool {
    [Mount::Front, Mount::Rear].into_iter().any(|mount| {
        let mut places = sweeps.iter().filter(|s| s.mount == mount).map(|s| s.robot.to(s.pose));
        let Some(first) = places.next() else { return false };
        places.any(|place| first.distance(place) > ROUNDING.0 || first.turn(place).abs() > ROUNDING.1)
    })
}

fn equal(a: Pose, b: Pose) -> bool {
    a.distance(b) < EQUAL && a.turn(b).abs() < EQUAL
}

/// Whether in most places odometry begins anew after a sweep, with the sweep's pose.
fn begins_anew(sweeps: &[Sweep], around: &[Around]) -> bool {
    let anew = |(sweep, a): &(&Sweep, &Around)| a.after.is_some_and(|after| equal(sweep.pose, after));
    sweeps.iter().zip(around).filter(anew).count() * 2 >= sweeps.len()
}

/// The odometry of a log whose odometry begins anew at every sweep: the pieces in one chain. None if most sweeps have no
/// piece before them, and then nothing is known of how the robot moved by odometry.
fn chained(sweeps: &[Sweep], around: &[Around]) -> Option<Vec<Pose>> {
    // The first message of a piece repeats the pose of the sweep before.
    let end = |a: &Around| a.before.filter(|_| a.count >= 2);
    if around.iter().filter(|a| end(a).is_some()).count() * 2 < sweeps.len() {
        return None;
    }
    let mut last = sweeps.first()?.pose;
    let mut chain = vec![last];
    for (pair, a) in sweeps.windows(2).zip(around.iter().skip(1)) {
        last = last.then(pair[0].pose.to(end(a).unwrap_or(pair[1].pose)));
        chain.push(last);
    }
    Some(chain)
}

/// The odometry of a log whose odometry is as it was: the last message before each sweep. None if it is nowhere apart
/// from the sweeps' poses.
fn apart(sweeps: &[Sweep], around: &[Around], parameters: &Parameters) -> Option<Vec<Pose>> {
    let of = |(s, a): (&Sweep, &Around)| Some(a.before?.then(mounted(s.mount, parameters)));
    let odometry: Vec<_> = sweeps.iter().zip(around).map(of).collect::<Option<_>>()?;
    sweeps.iter().zip(&odometry).any(|(s, o)| s.pose.distance(*o) > ROUNDING.0).then_some(odometry)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pose(x: f64, y: f64, theta: f64) -> Pose {
        Pose { x, y, theta }
    }

    fn sweep(pose: Pose, robot: Pose) -> Sweep {
        Sweep { mount: Mount::Front, laser: None, ranges: vec![1.0], pose, robot, time: 0.0 }
    }

    /// A robot that drives ahead and says that it turns.
    fn driven() -> Vec<Pose> {
        (0..6).map(|i| pose(f64::from(i), 0.0, 0.2 * f64::from(i))).collect()
    }

    fn close(a: &[Pose], b: &[Pose]) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.distance(*b) < 1e-9 && a.turn(*b).abs() < 1e-9)
    }

    #[test]
    fn a_laser_that_stays_on_the_robot_is_where_odometry_says() {
        let ahead = pose(0.3, 0.0, 0.0);
        let sweeps: Vec<_> = driven().iter().map(|p| sweep(p.then(ahead), *p)).collect();
        let judged = judge(&sweeps, &[Around::default(); 6], &Parameters::default(), false);
        assert!(judged.kind == PoseKind::Odometry && judged.odometry.is_none());
    }

    #[test]
    fn a_laser_that_moves_on_the_robot_was_corrected() {
        let sweeps: Vec<_> = driven().iter().map(|p| sweep(pose(p.x, 0.1 * p.x, 0.0), *p)).collect();
        let parameters = Parameters { front_offset: Some(0.5), ..Parameters::default() };
        let judged = judge(&sweeps, &[Around::default(); 6], &parameters, false);
        let expected: Vec<_> = driven().iter().map(|p| p.then(pose(0.5, 0.0, 0.0))).collect();
        assert!(judged.kind == PoseKind::Corrected && close(&judged.odometry.unwrap(), &expected));
    }

    #[test]
    fn odometry_in_pieces_is_chained() {
        let raw = driven();
        let corrected: Vec<_> = (0..6).map(|i| pose(f64::from(i), 0.0, 0.0)).collect();
        let sweeps: Vec<_> = corrected.iter().map(|p| sweep(*p, *p)).collect();
        let piece = |i: usize| Around {
            before: (i > 0).then(|| corrected[i - 1].then(raw[i - 1].to(raw[i]))),
            count: if i > 0 { 5 } else { 0 },
            after: Some(corrected[i]),
        };
        let around: Vec<_> = (0..6).map(piece).collect();
        let judged = judge(&sweeps, &around, &Parameters::default(), true);
        assert!(judged.kind == PoseKind::Corrected && close(&judged.odometry.unwrap(), &raw));
        let repeated: Vec<_> = around.iter().map(|a| Around { count: 1, ..*a }).collect();
        assert!(judge(&sweeps, &repeated, &Parameters::default(), true).odometry.is_none());
    }

    #[test]
    fn odometry_that_was_left_alone_is_taken_as_it_is() {
        let raw = driven();
        let sweeps: Vec<_> = (0..6).map(|i| pose(f64::from(i), 3.0, 0.0)).map(|p| sweep(p, p)).collect();
        let left = |p: &Pose| Around { before: Some(*p), count: 3, after: Some(*p) };
        let around: Vec<_> = raw.iter().map(left).collect();
        let judged = judge(&sweeps, &around, &Parameters::default(), true);
        assert!(close(&judged.odometry.unwrap(), &raw));
        assert!(judge(&sweeps, &[Around::default(); 6], &Parameters::default(), true).odometry.is_none());
    }
}
