//! Reads what is written with ezdxf, the strictest free reader, and has it audited.

use crate::support::{HARD_NAMES, VERSIONS, flat, hard_names, row, symbols, write};
use planform_sdk::{Layout, Point};
use serde_json::{Value, json};
use std::process::Command;

const INSTALL: &str = "these tests need Python and ezdxf: run `python3 -m pip install ezdxf==1.4.5`";

/// What ezdxf says of the layout in each version.
fn audit(layout: &Layout, versions: &[&str], boundary: &str) -> Vec<Value> {
    let folder = tempfile::tempdir().unwrap();
    let files = versions.iter().map(|version| {
        let path = folder.path().join(format!("{version}.dxf"));
        std::fs::write(&path, write(layout, &[("version", version), ("boundary", boundary)]).unwrap())
            .unwrap();
        path
    });
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/audit.py");
    let run = Command::new("python3").arg(script).args(files).output();
    let run = run.unwrap_or_else(|e| panic!("python3: {e}; {INSTALL}"));
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    serde_json::from_slice(&run.stdout).unwrap()
}

/// The reports, after what must hold for every drawing has been asserted.
fn sound(layout: &Layout, versions: &[&str], boundary: &str) -> Vec<Value> {
    let reports = audit(layout, versions, boundary);
    assert_eq!(reports.len(), versions.len());
    for (report, &version) in reports.iter().zip(versions) {
        assert_eq!(report["version"], version);
        assert_eq!(report["errors"], Value::Array(vec![]), "{version}");
        assert_eq!(report["fixes"], Value::Array(vec![]), "{version}");
        assert_eq!(report["repeated_handles"], 0, "{version}");
        assert_eq!(report["units"], if version == "R12" { 0 } else { 6 });
        assert_rooms(report, layout, boundary);
    }
    reports
}

fn assert_rooms(report: &Value, layout: &Layout, boundary: &str) {
    assert_eq!(report["rooms"].as_object().unwrap().len(), layout.rooms.len());
    for room in &layout.rooms {
        let polygon = if boundary == "centre" { &room.centre } else { &room.inner };
        let read = &report["rooms"][room.id.to_string()];
        for key in ["area", "said"] {
            let area = read[key].as_f64().unwrap();
            assert!((area / polygon.area() - 1.0).abs() < 1e-6, "room {}: {area}", room.id);
        }
    }
}

fn texts(report: &Value) -> Vec<String> {
    serde_json::from_value(report["texts"].clone()).unwrap()
}

#[test]
fn a_flat_is_sound_in_every_version() {
    for boundary in ["inner", "centre"] {
        for report in sound(&flat(), &VERSIONS, boundary) {
            let layers: Vec<String> = serde_json::from_value(report["layers"].clone()).unwrap();
            let all = [
                "A-ANNO-SYMB",
                "A-ANNO-TEXT",
                "A-AREA",
                "A-AREA-IDEN",
                "A-AREA-PRTL",
                "A-DOOR",
                "A-WALL",
                "A-WALL-CNTR",
            ];
            assert_eq!(layers, all);
            let texts = texts(&report);
            for text in ["Küche 🚪", "厨房", "غرفة", "Room 5", "Flat Nº 7 ≈ 90 m²"] {
                assert!(texts.iter().any(|t| t == text), "{text}: {texts:?}");
            }
        }
    }
}

#[test]
fn symbols_of_every_kind_are_sound_in_every_version() {
    let layout = symbols();
    for report in sound(&layout, &VERSIONS, "inner") {
        assert_eq!(report["inserts"], json!(["LIFT", "SINK", "TOILET", "TOILET", "YOU-ARE-HERE"]));
        let arc = &report["arcs"][0];
        let number = |i: usize| arc[i].as_f64().unwrap();
        assert!((number(0) - 7.0).abs() < 1e-9 && number(1).abs() < 1e-9 && (number(2) - 0.9).abs() < 1e-9);
        assert!(
            (number(3) - 270.0).abs() < 1e-9 && number(4).abs() < 1e-9,
            "open below, closed to the right"
        );
        assert_eq!(report["arcs"].as_array().unwrap().len(), 1);
        assert_eq!(texts(&report), ["Room 1", "12.0 m2", "coffee-machine"]);
    }
}

#[test]
fn hard_names_come_back_whole() {
    for report in sound(&hard_names(), &VERSIONS, "inner") {
        let texts = texts(&report);
        for text in [HARD_NAMES[0], HARD_NAMES[1], HARD_NAMES[2], HARD_NAMES[3], HARD_NAMES[4], HARD_NAMES[6]]
        {
            assert!(texts.iter().any(|t| t == text), "{text}: {texts:?}");
        }
        let drawn: Vec<_> = texts.iter().map(|t| t.replace('\u{200C}', "")).collect();
        assert!(drawn.contains(&"20 %%d %%c %%% 5%".to_owned()), "{drawn:?}");
        assert!(drawn.contains(&"Room 8".to_owned()) && drawn.contains(&"Room 10".to_owned()));
        for (i, name) in HARD_NAMES.iter().enumerate().take(6) {
            assert_eq!(report["rooms"][(i + 1).to_string()]["name"], *name);
        }
        assert_eq!(report["rooms"]["8"]["name"], Value::Null);
    }
}

#[test]
fn an_empty_layout_is_an_empty_drawing() {
    for report in sound(&Layout::default(), &VERSIONS, "inner") {
        assert_eq!(report["entities"], 0);
        assert_eq!(report["known_layers"], 12);
    }
}

#[test]
fn five_thousand_rooms_are_sound() {
    let reports = sound(&row(5000, Point::default(), |_| None), &["R2000"], "inner");
    assert_eq!(reports[0]["entities"], 5000 * 5);
}

#[test]
fn rooms_far_from_the_origin_keep_their_digits_and_are_in_view() {
    let from = Point::new(1_000_000.123_456_7, -2_000_000.765_432_1);
    for report in sound(&row(4, from, |_| None), &VERSIONS, "inner") {
        let number = |key: &str, path: &[usize]| {
            path.iter().fold(&report[key], |value, &i| &value[i]).as_f64().unwrap()
        };
        assert_eq!(number("extents", &[1, 0]), from.x + 9.0 + 3.0);
        assert!(number("extents", &[0, 1]) <= from.y);
        let (middle, height) = (number("view", &[0]), number("view", &[2]));
        assert!((middle - from.x - 6.0).abs() < 0.01, "{middle}");
        assert!(height > 2.0 && height * number("view", &[3]) > 12.0, "{height}");
    }
}
