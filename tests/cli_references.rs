//! The outputs of one small map, compared with those kept in `tests/references`.
//!
//! When a change is meant to alter them, run with `UPDATE_REFERENCES=1` and look at what `git diff` shows.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod cli_support;

use cli_support::Workshop;
use std::fs;
use std::path::Path;

fn compare(extension: &str) {
    let w = Workshop::new();
    let name = format!("two-rooms.{extension}");
    w.does(&format!("convert map.yaml -o {name}"));
    let reference = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/references").join(&name);
    if std::env::var_os("UPDATE_REFERENCES").is_some() {
        fs::create_dir_all(reference.parent().unwrap()).unwrap();
        fs::write(&reference, w.read(&name)).unwrap();
    }
    let kept = fs::read(&reference).unwrap_or_default();
    assert!(kept == w.read(&name), "{name} is not what it was; UPDATE_REFERENCES=1 accepts it");
}

#[test]
fn svg() {
    compare("svg");
}

#[test]
fn dxf() {
    compare("dxf");
}

#[test]
fn geojson() {
    compare("geojson");
}

#[test]
fn json() {
    compare("layout.json");
}
