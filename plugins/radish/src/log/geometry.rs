//! Where the beams of a sweep point, and where echoes end.

use super::message::{Geometry, Mount, Sweep};
use super::parameters::Parameters;
use std::f64::consts::{PI, TAU};

/// Where the echoes of the laser end that most logs were made with, the SICK LMS 200, metres.
const USUAL_MAX_RANGE: f64 = 80.0;
/// How near the log's longest reading another must be to mean the same: no echo. Part of the longest reading.
const SAME: f64 = 0.005;
/// How much farther than those of no echo the nearest readings must be, and how many times fewer: part of the longest
/// reading, and times.
const GAP: (f64, usize) = (0.1, 10);
/// How many readings of no echo there must be.
const FEWEST: usize = 8;

/// The beams of a sweep: as the user gives the field of view (radians), else as the message states them, else as the
/// log's parameters do, else as lasers with so many readings have them.
pub fn geometry(sweep: &Sweep, parameters: &Parameters, view: Option<f64>) -> Geometry {
    let beams = sweep.ranges.len();
    let max_range = max_range(sweep, parameters);
    let stated = || sweep.laser.filter(sound).map(|laser| (laser.first_angle, laser.step));
    let front = || of_parameters(beams, parameters).filter(|_| sweep.mount == Mount::Front);
    let given = view.map(|view| spread(beams, view));
    let (first_angle, step) = given.or_else(stated).or_else(front).unwrap_or_else(|| usual(beams));
    Geometry { first_angle, step, max_range }
}

fn max_range(sweep: &Sweep, parameters: &Parameters) -> f64 {
    let stated = sweep.laser.map(|laser| laser.max_range).filter(|m| m.is_finite() && *m > 0.0);
    let front = parameters.front_max_range.filter(|_| sweep.mount == Mount::Front);
    stated.or(front).unwrap_or(USUAL_MAX_RANGE)
}

/// Some logs hold zeros where the logger did not know the laser.
fn sound(laser: &Geometry) -> bool {
    laser.step.abs() > 1e-6 && laser.step.abs() < 1.0 && laser.first_angle.abs() <= TAU
}

/// So many beams over this field of view, from its one end to the other.
fn spread(beams: usize, view: f64) -> (f64, f64) {
    (-view / 2.0, view / beams.saturating_sub(1).max(1) as f64)
}

/// The beams by the log's parameters, if these fit the number of readings.
fn of_parameters(beams: usize, parameters: &Parameters) -> Option<(f64, f64)> {
    let (view, step) = (parameters.front_view?, parameters.front_step?);
    // The last beam is left out of some logs.
    let fits = |steps: usize| (steps as f64 * step - view).abs() < step / 2.0;
    (fits(beams.saturating_sub(1)) || fits(beams)).then_some((-view / 2.0, step))
}

/// The beams of the lasers that are known by their number of readings, as CARMEN takes them; else half a turn.
fn usual(beams: usize) -> (f64, f64) {
    match beams {
        180 | 181 => (-PI / 2.0, PI / 180.0),
        360 | 361 => (-PI / 2.0, PI / 360.0),
        400 | 401 => (-50_f64.to_radians(), PI / 720.0),
        _ => spread(beams, PI),
    }
}

/// Where echoes end by the readings themselves, metres: lasers write a number of their own for no echo, such as 81.91 m
/// or 32.767 m, so that many readings are at the very end and almost none just before.
///
/// None if there are no such readings.
pub fn no_echo<'a>(sweeps: impl Iterator<Item = &'a [f32]> + Clone) -> Option<f64> {
    let readings = || sweeps.clone().flatten().filter(|r| r.is_finite());
    let longest = f64::from(readings().copied().fold(0.0, f32::max));
    let same = longest * (1.0 - SAME);
    let within = |from: f64, to: f64| readings().filter(|r| (from..to).contains(&f64::from(**r))).count();
    let (at, before) = (within(same, f64::INFINITY), within(longest * (1.0 - GAP.0), same));
    (at >= FEWEST && at > before * GAP.1).then_some(same)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Pose;

    fn sweep(mount: Mount, beams: usize, laser: Option<Geometry>) -> Sweep {
        let pose = Pose::IDENTITY;
        Sweep { mount, laser, ranges: vec![1.0; beams], pose, robot: pose, time: 0.0 }
    }

    fn degrees(sweep: &Sweep, parameters: &Parameters, view: Option<f64>) -> (f64, f64) {
        let geometry = geometry(sweep, parameters, view);
        (geometry.first_angle.to_degrees(), geometry.step.to_degrees())
    }

    #[test]
    fn numbers_of_readings_tell_the_laser() {
        for (beams, first, step) in
            [(180, -90.0, 1.0), (181, -90.0, 1.0), (360, -90.0, 0.5), (361, -90.0, 0.5), (401, -50.0, 0.25)]
        {
            let found = degrees(&sweep(Mount::Front, beams, None), &Parameters::default(), None);
            assert!((found.0 - first).abs() < 1e-9 && (found.1 - step).abs() < 1e-9, "{beams}: {found:?}");
        }
        let found = degrees(&sweep(Mount::Front, 91, None), &Parameters::default(), None);
        assert!((found.0 + 90.0).abs() < 1e-9 && (found.1 - 2.0).abs() < 1e-9);
        assert!(degrees(&sweep(Mount::Front, 1, None), &Parameters::default(), None).1.is_finite());
    }

    #[test]
    fn the_user_knows_better_than_the_message_and_that_better_than_parameters() {
        let parameters = Parameters {
            front_view: Some(1.0),
            front_step: Some(0.25),
            front_max_range: Some(30.0),
            ..Parameters::default()
        };
        let laser = Geometry { first_angle: -0.3, step: 0.1, max_range: 8.0 };
        let all = |mount, laser, view| {
            let g = geometry(&sweep(mount, 5, laser), &parameters, view);
            (g.first_angle, g.step, g.max_range)
        };
        assert_eq!(all(Mount::Front, Some(laser), Some(4.0)), (-2.0, 1.0, 8.0));
        assert_eq!(all(Mount::Front, Some(laser), None), (-0.3, 0.1, 8.0));
        assert_eq!(all(Mount::Front, None, None), (-0.5, 0.25, 30.0));
        assert_eq!(all(Mount::Rear, None, None), (-PI / 2.0, PI / 4.0, USUAL_MAX_RANGE));
        let zeros = Geometry { first_angle: 0.0, step: 0.0, max_range: 0.0 };
        assert_eq!(all(Mount::Front, Some(zeros), None), (-0.5, 0.25, 30.0));
    }

    #[test]
    fn readings_at_the_very_end_are_no_echoes() {
        let mut readings: Vec<f32> = (0..400).map(|i| 1.0 + i as f32 * 0.05).collect();
        assert_eq!(no_echo([&readings[..]].into_iter()), None, "a room's longest readings");
        readings.extend([81.91; 20]);
        readings.extend([81.83, f32::NAN]);
        let found = no_echo([&readings[..]].into_iter()).unwrap();
        assert!((found - 81.91 * 0.995).abs() < 1e-4);
        assert_eq!(no_echo(std::iter::empty()), None);
    }
}
