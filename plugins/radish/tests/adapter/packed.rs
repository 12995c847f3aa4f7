//! Logs that are packed.

use crate::support::*;
use bzip2::write::BzEncoder;
use flate2::write::GzEncoder;
use planform_sdk::{ErrorKind, Probe};
use std::io::{Read, Write};

fn gzip(text: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(vec![], flate2::Compression::new(6));
    encoder.write_all(text).unwrap();
    encoder.finish().unwrap()
}

fn bzip2(text: &[u8]) -> Vec<u8> {
    let mut encoder = BzEncoder::new(vec![], bzip2::Compression::new(1));
    encoder.write_all(text).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn packed_logs_are_what_they_hold() {
    let plain = read(&log());
    let halves = log();
    let (first, second) = halves.split_at(halves.len() / 2);
    for packed in [
        gzip(log().as_bytes()),
        bzip2(log().as_bytes()),
        [gzip(first.as_bytes()), gzip(second.as_bytes())].concat(),
        [bzip2(first.as_bytes()), bzip2(second.as_bytes())].concat(),
    ] {
        assert_eq!(read_bytes(&packed, &[]).unwrap(), plain);
    }
}

#[test]
fn packed_logs_are_known_by_what_they_hold() {
    let percent =
        |name: &str, bytes: &[u8]| planform_radish::adapter().probe(&Probe::of(&source(name, bytes))).percent;
    assert_eq!(percent("x.dat", &gzip(log().as_bytes())), 95);
    assert_eq!(percent("x.svgz", &gzip(b"<svg/>")), 0);
    // All of a short bzip2 document is in its head.
    assert_eq!(percent("x.dat", &bzip2(log().lines().next_back().unwrap().as_bytes())), 95);
    assert_eq!(percent("x.log.bz2", &bzip2(&log().repeat(20).into_bytes())), 60);
}

#[test]
fn packed_logs_that_are_cut_off_are_used_up_to_there() {
    let packed = gzip(log().as_bytes());
    let scene = read_bytes(&packed[..packed.len() * 3 / 4], &[]).unwrap();
    let said = &scene.warnings[0];
    assert!(said.starts_with("the packed log is cut off in or after line "), "{said}");
    assert!(said.ends_with("of its text; it is used up to there"), "{said}");
    let said = refusal(&packed[..40]);
    assert!(said.ends_with("of its text, and there is no sweep of a laser before"), "{said}");
    let long: String = (0..200).map(|i| format!("# {i}\n{}", log())).collect();
    let packed = bzip2(long.as_bytes());
    let scene = read_bytes(&packed[..packed.len() * 3 / 4], &[]).unwrap();
    assert!(scene.warnings[0].starts_with("the packed log is cut off"), "{:?}", scene.warnings);
}

#[test]
fn packed_logs_that_are_damaged_are_used_up_to_there() {
    let mut packed = gzip(log().as_bytes());
    let middle = packed.len() * 3 / 4;
    packed[middle..middle + 400].fill(0xa5);
    let said = match read_bytes(&packed, &[]) {
        Ok(scene) => scene.warnings.join("; "),
        Err(e) => e.to_string(),
    };
    assert!(said.contains("the packed log is damaged in or after line "), "{said}");
    assert!(refusal(b"\x1f\x8b no gzip at all").starts_with("the packed log is damaged"));
}

#[test]
fn bombs_are_refused() {
    let mut zeros = vec![];
    let mut encoder = GzEncoder::new(&mut zeros, flate2::Compression::new(9));
    std::io::copy(&mut std::io::repeat(0).take(1 << 28), &mut encoder).unwrap();
    encoder.finish().unwrap();
    let e = read_bytes(&zeros, &[]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::Limit);
    assert!(e.to_string().starts_with("line 1: the line has more than 1048576 bytes"), "{e}");
}
