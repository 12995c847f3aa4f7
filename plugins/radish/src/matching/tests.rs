//! Made-up robots in made-up buildings, whose true poses are known.

use super::{Matched, MatchingParams, corrected, corrected_on};
use crate::log::{Pose, Scan};
use std::f64::consts::{FRAC_PI_2, PI};

/// A wall from (x, y) to (x, y), metres.
type Wall = [f64; 4];

/// Where echoes end, metres.
const MAX_RANGE: f64 = 30.0;

/// The walls of a box.
fn box_walls(left: f64, bottom: f64, right: f64, top: f64) -> Vec<Wall> {
    vec![
        [left, bottom, right, bottom],
        [right, bottom, right, top],
        [right, top, left, top],
        [left, top, left, bottom],
    ]
}

/// A corridor 2 m wide around a block, 30 m by 20 m, with niches and pillars that make its parts differ.
fn ring() -> Vec<Wall> {
    let mut walls = box_walls(0.0, 0.0, 30.0, 20.0);
    walls.extend(box_walls(2.0, 2.0, 28.0, 18.0));
    for (x, y, side) in [
        (5.0, 0.0, 0.4),
        (9.0, 1.7, 0.3),
        (17.0, 0.0, 0.5),
        (23.5, 1.6, 0.4),
        (28.0, 7.0, 0.3),
        (29.6, 12.5, 0.4),
        (21.0, 18.0, 0.5),
        (14.0, 19.5, 0.5),
        (8.0, 18.0, 0.3),
        (1.7, 14.0, 0.3),
        (0.0, 9.0, 0.5),
        (1.6, 4.0, 0.4),
    ] {
        walls.extend(box_walls(x, y, x + side, y + side));
    }
    walls
}

/// The way along the middle of that corridor, more than once around, in steps of 0.25 m.
fn around() -> Vec<Pose> {
    let corners = [(1.0, 1.0), (29.0, 1.0), (29.0, 19.0), (1.0, 19.0), (1.0, 1.0), (29.0, 1.0), (29.0, 10.0)];
    corners.windows(2).flat_map(|leg| straight(leg[0], leg[1])).collect()
}

/// From one place to another; at its end the robot turns left in steps.
fn straight(from: (f64, f64), to: (f64, f64)) -> Vec<Pose> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (length, theta) = (dx.hypot(dy), dy.atan2(dx));
    let steps = (length / 0.25).round() as usize;
    let at = |i: usize| {
        let share = i as f64 / steps as f64;
        Pose { x: from.0 + share * dx, y: from.1 + share * dy, theta }
    };
    let turns = (1..6).map(|i| Pose { x: to.0, y: to.1, theta: theta + FRAC_PI_2 * f64::from(i) / 6.0 });
    (0..steps).map(at).chain(turns).collect()
}

/// Numbers from -1 to 1 that look random.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// What a laser of 181 beams over half a turn measures from here.
fn scan(walls: &[Wall], pose: Pose, noise: &mut Noise) -> Scan {
    let step = PI / 180.0;
    let range = |i: i32| {
        let angle = pose.theta - FRAC_PI_2 + f64::from(i) * step;
        (cast(walls, pose, angle) + 0.01 * noise.next()).min(MAX_RANGE) as f32
    };
    let ranges = (0..181).map(range).collect();
    Scan { ranges, first_angle: -FRAC_PI_2, step, max_range: MAX_RANGE, pose, odometry: None, time: 0.0 }
}

/// Metres to the first wall in this direction.
fn cast(walls: &[Wall], from: Pose, angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let hit = |[x1, y1, x2, y2]: &Wall| {
        let (ex, ey) = (x2 - x1, y2 - y1);
        let (wx, wy) = (x1 - from.x, y1 - from.y);
        let across = cos * ey - sin * ex;
        let (range, along) = ((wx * ey - wy * ex) / across, (wx * sin - wy * cos) / across);
        ((0.0..=1.0).contains(&along) && range > 0.0).then_some(range)
    };
    walls.iter().filter_map(hit).fold(f64::INFINITY, f64::min)
}

/// The scans of a robot that goes this way; its odometry stretches steps, turns a little with each metre, and is noisy.
fn drive(walls: &[Wall], way: &[Pose]) -> Vec<Scan> {
    let mut noise = Noise(7);
    let mut odometry = way[0];
    let mut last = way[0];
    let mut follow = |pose: Pose| {
        let step = last.to(pose);
        let metres = step.x.hypot(step.y);
        odometry = odometry.then(Pose {
            x: step.x * 1.03 + 0.02 * metres * noise.next(),
            y: step.y + 0.02 * metres * noise.next(),
            theta: step.theta + 0.008 * metres + 0.1 * step.theta * noise.next(),
        });
        last = pose;
        Scan { pose: odometry, ..scan(walls, pose, &mut noise) }
    };
    way.iter().map(|pose| follow(*pose)).collect()
}

fn matched(scans: &[Scan]) -> Matched {
    corrected(scans, &MatchingParams::default(), &mut |_| {})
}

/// The greatest distance from the truth, the first poses being laid on each other.
fn worst(found: &[Pose], truth: &[Pose]) -> f64 {
    found.iter().zip(truth).map(|(a, b)| found[0].to(*a).distance(truth[0].to(*b))).fold(0.0, f64::max)
}

#[test]
fn drift_is_taken_away_and_the_loop_closed() {
    let way = around();
    let scans = drive(&ring(), &way);
    let odometry: Vec<Pose> = scans.iter().map(|s| s.pose).collect();
    assert!(worst(&odometry, &way) > 8.0, "{}", worst(&odometry, &way));
    let found = matched(&scans);
    assert!(found.odometry && found.loops > 5 && found.matched < scans.len(), "{found:?}");
    assert!(worst(&found.poses, &way) < 0.25, "{}", worst(&found.poses, &way));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let scans = drive(&ring(), &around());
    let on = |threads| corrected_on(threads, &scans, &MatchingParams::default(), &mut |_| {});
    let one = on(1);
    assert!([2, 3, 8].into_iter().all(|threads| on(threads) == one));
}

#[test]
fn odometry_holds_along_a_corridor_without_features() {
    let walls = [[-500.0, -1.0, 500.0, -1.0], [-500.0, 1.0, 500.0, 1.0]];
    let way: Vec<Pose> = (0..160).map(|i| Pose { x: 0.25 * f64::from(i), ..Pose::IDENTITY }).collect();
    let found = matched(&drive(&walls, &way));
    let end = found.poses[0].to(found.poses[159]);
    // Along, the odometry's 3 percent too much stay; across and in heading the walls take the drift of 6 m away.
    assert!((end.x / way[159].x - 1.03).abs() < 0.02, "{end:?}");
    assert!(end.y.abs() < 0.3 && end.theta.abs() < 0.02, "{end:?}");
    assert_eq!(found.loops, 0);
}

#[test]
fn scans_that_tell_nothing_leave_odometry() {
    let way: Vec<Pose> = (0..40).map(|i| Pose { x: 0.5 * f64::from(i), y: 1.0, theta: 0.3 }).collect();
    let hollow = |ranges: Vec<f32>| -> Vec<Scan> {
        let scan = |pose: &Pose| Scan {
            ranges: ranges.clone(),
            first_angle: -FRAC_PI_2,
            step: 0.1,
            max_range: MAX_RANGE,
            pose: *pose,
            odometry: None,
            time: 0.0,
        };
        way.iter().map(scan).collect()
    };
    let none = [0.0, f32::NAN, f32::INFINITY, -1.0, 30.0];
    for ranges in [vec![], vec![2.0], none.to_vec(), [vec![2.0], none.to_vec()].concat()] {
        let found = matched(&hollow(ranges.clone()));
        assert!(worst(&found.poses, &way) < 1e-6, "{ranges:?}");
        assert_eq!(found.loops, 0);
    }
}

#[test]
fn nothing_and_nonsense_are_no_panic() {
    assert!(matched(&[]).poses.is_empty());
    let walls = ring();
    let mut scans = drive(&walls, &around()[..60]);
    scans[20].pose.x = f64::NAN;
    scans[30].pose = Pose { x: 1e300, y: -1e300, theta: 1e300 };
    scans[40].step = f64::NAN;
    scans[41].first_angle = f64::INFINITY;
    scans[42].ranges = vec![5.0; 100_000];
    let found = matched(&scans);
    assert_eq!(found.poses.len(), 60);
    assert!(found.poses.iter().all(|p| p.x.is_finite() && p.y.is_finite() && p.theta.is_finite()));
    assert_eq!(matched(&scans[..1]).poses, [scans[0].pose]);
}

#[test]
fn a_log_without_odometry_is_matched_all_the_same() {
    let way = &around()[..90];
    let mut scans = drive(&ring(), way);
    scans.iter_mut().for_each(|scan| scan.pose = Pose::IDENTITY);
    let found = matched(&scans);
    assert!(!found.odometry);
    assert!(worst(&found.poses, way) < 0.5, "{}", worst(&found.poses, way));
}

#[test]
fn progress_goes_from_nothing_to_all() {
    let mut told = vec![];
    corrected(&drive(&ring(), &around()[..200]), &MatchingParams::default(), &mut |done| told.push(done));
    assert!(told.windows(2).all(|w| w[0] <= w[1]) && told.last() == Some(&1.0), "{told:?}");
}
