//! Which poses scans are drawn from.

use crate::support::*;
use planform_sdk::ErrorKind;

/// What odometry says of the way: it turns too far.
fn drifted() -> Vec<At> {
    way().iter().enumerate().map(|(i, [x, y, theta])| [*x, *y, theta + 0.01 * i as f64]).collect()
}

/// The log with corrected poses and with odometry.
fn both() -> String {
    way().iter().zip(drifted()).map(|(at, robot)| flaser(&ranges(*at), *at, robot)).collect()
}

/// The log with odometry alone, the laser lying a little ahead.
fn raw() -> String {
    way().iter().zip(drifted()).map(|(at, robot)| flaser(&ranges(*at), robot, robot)).collect()
}

fn note(log: &str, poses: &str) -> Option<String> {
    read_bytes(log.as_bytes(), &[("poses", poses)]).unwrap().warnings.pop()
}

#[test]
fn logs_say_that_they_were_not_corrected() {
    assert_eq!([note(&both(), "auto"), note(&both(), "log"), note(&log(), "auto")], [None, None, None]);
    let odometry = Some("the poses are odometry alone, and walls may be bent or double".to_owned());
    for (log, poses) in [(both(), "odometry"), (raw(), "log"), (raw(), "odometry")] {
        assert_eq!(note(&log, poses), odometry);
    }
}

#[test]
fn a_log_has_both_poses_or_one() {
    let grid = |log: &str, poses| read_bytes(log.as_bytes(), &[("poses", poses)]).unwrap().grid;
    assert!(grid(&both(), "log") == grid(&log(), "log"));
    assert!(grid(&both(), "odometry") == grid(&raw(), "log"));
    assert!(grid(&both(), "odometry") != grid(&both(), "log"));
    let e = read_bytes(log().as_bytes(), &[("poses", "odometry")]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::BadOption);
    assert!(e.to_string().starts_with("the log has corrected poses only, and no odometry"), "{e}");
}
