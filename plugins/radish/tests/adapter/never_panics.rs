//! Whatever the bytes are, reading and probing end, and end well.

use crate::support::*;
use planform_sdk::Probe;
use proptest::prelude::*;

fn digest(bytes: &[u8]) {
    let confidence = planform_radish::adapter().probe(&Probe::of(&source("x.log", bytes)));
    assert!(confidence.percent <= 100);
    match read_bytes(bytes, &[("poses", "log")]) {
        Ok(scene) => assert!(!scene.grid.cells().is_empty()),
        Err(e) => assert!(!e.to_string().is_empty()),
    }
}

fn short_log() -> String {
    log().lines().take(9).map(|line| format!("{line}\n")).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        digest(&bytes);
        digest(&[b"\x1f\x8b\x08", &bytes[..]].concat());
        digest(&[b"BZh9", &bytes[..]].concat());
    }

    #[test]
    fn random_fields(name in "(FLASER|RLASER|ROBOTLASER1|ROBOTLASER2|ODOM|PARAM)", fields in "( (-?[0-9]{1,3}|nan|inf|1e300|x|-0.5)){0,40}") {
        digest(format!("{name}{fields}\n").as_bytes());
    }

    #[test]
    fn truncated_logs(share in 0.0..1.0) {
        let log = short_log();
        digest(&log.as_bytes()[..(log.len() as f64 * share) as usize]);
    }

    #[test]
    fn flipped_bits(flips in prop::collection::vec((any::<prop::sample::Index>(), 0..8_u32), 1..6)) {
        let mut log = short_log().into_bytes();
        for (at, bit) in flips {
            let at = at.index(log.len());
            log[at] ^= 1_u8 << bit;
        }
        digest(&log);
    }
}
