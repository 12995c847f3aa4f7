//! Logs that are damaged, and what is said of them.

use crate::support::*;
use planform_sdk::ErrorKind;

/// The first warning, of a log that is used all the same.
fn warned(log: &str) -> String {
    let scene = read(log);
    assert!(scene.grid.cells().iter().any(|c| c.occupancy() == Some(0)));
    scene.warnings[0].clone()
}

#[test]
fn what_is_no_log_says_so() {
    assert_eq!(refusal(b""), "the file is empty; give a CARMEN log");
    for no_log in [&b"hello\nworld\n"[..], &[0, 1, 2, 255, 10, 254, 0, 7], b"\n\n\n", b"FLASERS 1 2\n"] {
        let said = refusal(no_log);
        assert!(said.starts_with("no line is a message of a CARMEN log"), "{said}");
    }
    let said = refusal(b"PARAM robot_width 0.5 0 h 0\nODOM 0 0 0 0 0 0 0 h 0\n");
    assert!(said.starts_with("the log has no sweep of a laser"), "{said}");
}

#[test]
fn a_log_of_nothing_but_damage_names_the_first() {
    let bad = |line: &str| refusal(format!("# log\n{line}\n").as_bytes());
    for (line, expected) in [
        (
            "FLASER 3 1 2",
            "line 2: no sweep of a laser can be used; the first damage is that it claims 3 readings and has fewer; the log may be damaged",
        ),
        ("FLASER 1e12 1", "it claims 1000000000000 readings, of which it can have 0 to 20000"),
        ("FLASER 1 1.5 nan nan nan 0 0 0 0 h 0", "the laser's x is NaN"),
        ("FLASER 1 1.5 1e300 0 0 0 0 0 0 h 0", "the laser is more than 1000 km"),
        ("FLASER 1 1.5 0 0 0 0 0", "it ends before the robot's heading"),
        ("FLASER 1 x 0 0 0 0 0 0 0 h 0", "`x` is no number for readings"),
        ("ROBOTLASER1 0 -1.5 3 0.5 50", "it ends before the accuracy"),
    ] {
        let said = bad(line);
        assert!(said.contains(expected), "{line}: {said}");
    }
}

#[test]
fn readings_that_are_no_numbers_are_no_echoes() {
    let at = way()[0];
    let ridden = flaser(&vec![f64::NAN; BEAMS], at, at);
    let said = refusal(format!("NEFF 1\n{ridden}").as_bytes());
    assert!(said.starts_with("no reading of the log is an echo, so there is nothing to draw"), "{said}");
    let mixed = log() + &ridden + &flaser(&[f64::INFINITY, -1.0, 2.0], at, at);
    let said = warned(&mixed);
    assert_eq!(said, "183 of 7424 readings are not finite or negative and count as no echo");
    assert_eq!(read(&mixed).grid.width(), read(&log()).grid.width());
}

#[test]
fn damaged_lines_are_left_out() {
    let at = way()[0];
    let harmed = log() + &flaser(&[1.0, 2.0], [f64::NAN; 3], at) + "FLASER 7 1\n" + &log();
    let said = warned(&harmed);
    assert_eq!(said, "2 lines are damaged and left out, first line 123: the laser's x is NaN");
    assert_eq!(read(&harmed).grid.width(), read(&log()).grid.width());
}

#[test]
fn lines_that_mean_nothing_are_counted() {
    let strange = format!("WIFI 1 2\n{}GYRO 3\nsomething else\nSYNC x\n", log());
    assert_eq!(warned(&strange), "3 lines are left out that are no messages known here (WIFI, GYRO)");
}

#[test]
fn a_log_that_is_cut_off_is_used_up_to_there() {
    let whole = log();
    let last = whole.rfind("FLASER").unwrap();
    let before = read(&whole[..last]).grid;
    for cut in [last + 3, last + 20, last + 600, whole.rfind("host").unwrap() + 2] {
        let scene = read(&whole[..cut]);
        assert!(scene.grid == before, "cut at {cut}");
        let said = scene.warnings[0].as_str();
        let expected = [
            "the log is cut off in line 121; it is used up to there",
            "1 lines are left out that are no messages known here (FLA)",
        ];
        assert!(expected.contains(&said), "cut at {cut}: {said}");
    }
    let said = refusal(b"FLASER 181 1.5 1.5");
    assert_eq!(said, "the log is cut off within its first sweep");
}

#[test]
fn maps_are_bounded() {
    let at = way()[0];
    let far = log() + &flaser(&ranges(at), [9e5, 0.0, 0.0], at);
    let e = read_bytes(far.as_bytes(), &[]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Limit);
    assert!(e.message.starts_with("the scans reach over 90000"), "{e}");
    let advice = e.advice.unwrap();
    assert!(advice.ends_with("m from the middle one, is that of scan 41"), "{advice}");
    let e = read_bytes(log().as_bytes(), &[("resolution", "1e-5")]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Limit);
    let e = read_bytes(log().as_bytes(), &[("resolution", "2000")]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::BadOption, "{e}");
}

#[test]
fn lines_are_bounded() {
    let e = read_bytes(&vec![b'1'; 3 << 20], &[]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Limit);
    assert!(e.to_string().starts_with("line 1: the line has more than 1048576 bytes"), "{e}");
}
