//! YAML files that cannot be read, and what is said of them.

use crate::support::*;
use planform_sdk::{ErrorKind, Place, PluginError};

fn refused(yaml: &str) -> PluginError {
    read_yaml(yaml).map(|s| panic!("read as {:?}\n{yaml}", cells(&s))).unwrap_err()
}

fn replaced(from: &str, to: &str) -> PluginError {
    assert!(YAML.contains(from), "{from}");
    refused(&YAML.replace(from, to))
}

#[test]
fn missing_keys_are_named() {
    for key in ["image", "resolution", "origin"] {
        let yaml: String = YAML.lines().filter(|l| !l.starts_with(key)).map(|l| format!("{l}\n")).collect();
        let e = refused(&yaml).to_string();
        assert!(e.starts_with(&format!("the YAML file has no `{key}`; add it: ")), "{e}");
        let e = refused(&format!("{yaml}{key}:\n")).to_string();
        assert!(e.starts_with(&format!("the YAML file has no `{key}`; add it: ")), "{e}");
    }
}

#[test]
fn bad_resolution_is_told_with_its_line() {
    for value in ["0", "-0.05", "nan", ".inf", "five", "[1]", "1e-400"] {
        let e = replaced("0.05", value);
        assert_eq!(e.place, Some(Place::Line(2)), "{value}: {e}");
    }
    let e = replaced("0.05", "0.0").to_string();
    assert_eq!(e, "line 2: `resolution` cannot be `0.0`; give metres per pixel, a number above 0");
}

#[test]
fn bad_origin_is_told() {
    for value in
        ["[nan, 2.0, 0.5]", "[1, -nan, 0]", "[1, 2]", "[1, 2, 3, 4]", "[]", "7", "[1, 2, .inf]", "[a, b, c]"]
    {
        let e = replaced("[-1.5, 2.0, 0.5]", value);
        assert_eq!(e.place, Some(Place::Line(3)), "{value}: {e}");
    }
    let e = replaced("[-1.5, 2.0, 0.5]", "[1, 2]").to_string();
    assert_eq!(e, "line 3: `origin` must have three numbers [x, y, yaw], not 2");
}

#[test]
fn bad_thresholds_are_told() {
    for (from, to) in [
        ("0.65", "1.1"),
        ("0.65", "-0.1"),
        ("0.65", "0.196"),
        ("0.196", "0.7"),
        ("0.196", "nan"),
        ("0.196", "x"),
    ] {
        let e = replaced(from, to);
        assert!(matches!(e.place, Some(Place::Line(5 | 6))), "{to}: {e}");
    }
    let e = replaced("0.196", "0.7").to_string();
    assert_eq!(e, "line 6: `free_thresh` 0.7 is not below `occupied_thresh` 0.65; are the two swapped?");
}

#[test]
fn unknown_mode_is_answered_with_the_three() {
    let e = refused(&format!("{YAML}mode: binary\n")).to_string();
    assert_eq!(e, "line 7: `mode` cannot be `binary`; give trinary, scale or raw");
    let e = replaced("negate: 0", "negate: maybe").to_string();
    assert!(e.starts_with("line 4: `negate` cannot be `maybe`; give 0"), "{e}");
}

#[test]
fn pictures_that_cannot_be_had_are_named() {
    for (image, named) in [
        ("gone.pgm", "gone.pgm"),
        (".", "is a folder, not a file"),
        ("map.yaml", "map.yaml"),
        ("''", "`image` is empty"),
    ] {
        let e = replaced("map.pgm", image).to_string();
        assert!(e.contains(named), "{image}: {e}");
    }
    let folder = folder(&[("map.yaml", YAML.as_bytes()), ("map.pgm", b"")]);
    let e = read_in(folder.path(), "map.yaml", &[]).unwrap_err().to_string();
    assert!(e.starts_with("map.pgm: ") && e.contains("empty"), "{e}");
    std::fs::write(folder.path().join("map.pgm"), b"P5\n4 4\n255\nfew").unwrap();
    let e = read_in(folder.path(), "map.yaml", &[]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::BadInput, "{e}");
    assert!(e.to_string().starts_with("map.pgm: the picture cannot be decoded"), "{e}");
}

#[test]
fn other_yaml_is_told_apart() {
    for yaml in
        ["name: x\n", "- 1\n- 2\n", "just words\n", "", "# nothing\n", "{", "a: b: c\n", "image: [a, b]\n"]
    {
        let e = if yaml.is_empty() { read_bytes("m.yaml", b"", &[]).unwrap_err() } else { refused(yaml) };
        assert_eq!(e.kind, ErrorKind::BadInput, "{yaml}: {e}");
        assert!(!e.to_string().contains('\n'), "{yaml}: {e}");
    }
    let e = refused(&format!("{YAML}---\n{YAML}"));
    assert_eq!(e.kind, ErrorKind::BadInput, "{e}");
}

#[test]
fn bombs_are_defused() {
    let mut bomb = String::from("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
    for i in 1..12 {
        let aliases = vec![format!("*a{}", i - 1); 9].join(", ");
        bomb += &format!("a{i}: &a{i} [{aliases}]\n");
    }
    refused(&format!("{bomb}origin: *a11\n"));
    refused(&format!("image: {}\n", "[".repeat(100_000)));
    refused(&format!("image: {}\n", "{a: ".repeat(100_000)));
    let e = refused(&format!("{YAML}#{}\n", "x".repeat(1 << 20)));
    assert_eq!(e.kind, ErrorKind::Limit, "{e}");
}
