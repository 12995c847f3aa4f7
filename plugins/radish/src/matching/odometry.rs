//! What the wheels say of the way from scan to scan.

use super::sweep::finite;
use crate::log::{Pose, Scan};

/// Odometry that moves farther than this between two matched scans was set anew, metres.
pub const LEAP: f64 = 5.0;

/// How much the ranges of a robot that stands still differ at most, metres.
const STILL: f32 = 0.1;

/// The poses by odometry, or none where the log has no odometry: then the poses never change, or stay while scans change.
pub fn of(scans: &[Scan]) -> Option<Vec<Pose>> {
    let mut poses: Vec<Pose> = Vec::with_capacity(scans.len());
    for scan in scans {
        let pose = scan.odometry.unwrap_or(scan.pose);
        let last = poses.last().copied().unwrap_or(Pose::IDENTITY);
        poses.push(if finite(pose) { pose } else { last });
    }
    let moves = poses.windows(2).any(|p| p[0] != p[1]) || poses.len() < 2;
    let silent = scans.windows(2).zip(poses.windows(2)).filter(|(s, p)| p[0] == p[1] && differ(&s[0], &s[1]));
    (moves && 2 * silent.count() < scans.len().max(1)).then_some(poses)
}

/// Whether most beams of two scans differ.
fn differ(a: &Scan, b: &Scan) -> bool {
    let far = a.ranges.iter().zip(&b.ranges).filter(|(a, b)| (**a - **b).abs() > STILL).count();
    2 * far > a.ranges.len().min(b.ranges.len())
}

/// Whether odometry can be believed for a step.
pub fn is_step(step: Pose) -> bool {
    finite(step) && step.x.hypot(step.y) < LEAP
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(range: f32, x: f64) -> Scan {
        let pose = Pose { x, ..Pose::IDENTITY };
        let ranges = vec![range; 10];
        Scan { ranges, first_angle: 0.0, step: 0.1, max_range: 30.0, pose, odometry: None, time: 0.0 }
    }

    #[test]
    fn standing_still_is_not_silence() {
        let still: Vec<_> = (0..10).map(|i| scan(2.0, f64::from(i / 9))).collect();
        assert!(of(&still).is_some());
        let silent: Vec<_> = (0..10).map(|i| scan(2.0 + i as f32, 1.0)).collect();
        assert!(of(&silent).is_none());
        let never: Vec<_> = (0..10).map(|_| scan(2.0, 1.0)).collect();
        assert!(of(&never).is_none());
        let driven: Vec<_> = (0..10).map(|i| scan(2.0 + i as f32, f64::from(i))).collect();
        assert_eq!(of(&driven).unwrap()[9].x, 9.0);
        assert!(of(&[]).is_some() && of(&never[..1]).is_some());
    }

    #[test]
    fn poses_that_are_no_numbers_are_passed_over() {
        let poses = of(&[scan(2.0, 1.0), scan(2.0, f64::NAN), scan(2.0, 1.5)]).unwrap();
        assert_eq!(poses[1].x, 1.0);
        assert!(
            !is_step(Pose { x: 1e300, ..Pose::IDENTITY }) && !is_step(Pose { x: f64::NAN, ..Pose::IDENTITY })
        );
    }
}
