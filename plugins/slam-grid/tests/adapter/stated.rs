//! The openings that a map written by planform states.

use crate::support::*;
use planform_sdk::{OpeningKind, Point, Scene, Segment, StatedOpening};

/// The map of [`YAML`] and these lines of openings.
fn with(openings: &str) -> Scene {
    read_yaml(&format!("{YAML}planform:\n  openings: {openings}\n")).unwrap()
}

fn door(from: [f64; 2], to: [f64; 2], depth: Option<f64>) -> StatedOpening {
    let segment = Segment::new(Point::from(from), Point::from(to));
    StatedOpening { kind: OpeningKind::Door, segment, depth }
}

#[test]
fn openings_are_read_where_they_are_stated() {
    let scene = with(
        "\n  - {kind: door, from: [-1.5, 2], to: [-1.4, 2.05], depth: 0.2}\n  - kind: passage\n    from: [-1.5, 2.0]\n    to: [-1.5, 2.1]",
    );
    let passage = StatedOpening { kind: OpeningKind::Passage, ..door([-1.5, 2.0], [-1.5, 2.1], None) };
    assert_eq!(scene.openings, Some(vec![door([-1.5, 2.0], [-1.4, 2.05], Some(0.2)), passage]));
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
}

#[test]
fn none_at_all_is_not_the_same_as_none_stated() {
    assert_eq!(with("[]").openings, Some(vec![]));
    for yaml in [YAML.into(), format!("{YAML}planform:\n"), format!("{YAML}planform: {{drawn: 2}}\n")] {
        let scene = read_yaml(&yaml).unwrap();
        assert_eq!((scene.openings, scene.warnings.len()), (None, 0), "{yaml}");
    }
}

#[test]
fn what_is_wrong_is_told_and_the_map_is_read() {
    let at = "from: [-1.5, 2], to: [-1.4, 2]";
    for (openings, words) in [
        ("7".to_owned(), "openings"),
        ("[7]".into(), "line 8"),
        ("[{kind: door}]".into(), "missing field `from`"),
        (format!("[{{kind: gate, {at}}}]"), "line 8: "),
        ("[{kind: door, from: [-1.5], to: [-1.4, 2]}]".into(), "a place is not two finite numbers [x, y]"),
        ("[{kind: door, from: [.nan, 2], to: [-1.4, 2]}]".into(), "two finite numbers"),
        (format!("[{{kind: door, {at}, depth: -1}}]"), "`depth` is no number of metres from 0 to 10"),
        (format!("[{{kind: door, {at}, depth: .inf}}]"), "`depth`"),
        (
            format!("[{}]", format!("{{kind: door, {at}}}, ").repeat(5001)),
            "5001 of them, and the most are 5000",
        ),
    ] {
        let scene = with(&openings);
        assert_eq!(scene.openings, None);
        assert_eq!(cells(&scene), [100, -1, 0, -1]);
        let [warning] = &scene.warnings[..] else { panic!("{:?}", scene.warnings) };
        assert!(warning.contains("the openings under `planform` are not used: "), "{warning}");
        assert!(warning.contains(words) && !warning.contains('\n'), "{warning}");
    }
}

#[test]
fn openings_beyond_the_map_are_left_out() {
    let scene =
        with("[{kind: door, from: [1e9, 2], to: [-1.4, 2]}, {kind: door, from: [-1.5, 2], to: [-1.4, 2]}]");
    assert_eq!(scene.openings, Some(vec![door([-1.5, 2.0], [-1.4, 2.0], None)]));
    let told = ["of 2 openings under `planform`, 1 lie outside of the map and are not used"];
    assert_eq!(scene.warnings, told);
}

#[test]
fn openings_go_with_a_resolution_that_was_set() {
    let yaml = format!(
        "{YAML}planform: {{openings: [{{kind: door, from: [-1.5, 2], to: [-1.4, 2.1], depth: 0.1}}]}}\n"
    );
    let pgm = encode(&picture(2, &[254, 205, 0, 100]), image::ImageFormat::Pnm);
    let folder = folder(&[("map.yaml", yaml.as_bytes()), ("map.pgm", &pgm)]);
    let scene = read_in(folder.path(), "map.yaml", &[("resolution", "0.1")]).unwrap();
    let found = scene.openings.unwrap()[0];
    assert!(found.segment.b.distance(Point::new(-1.3, 2.2)) < 1e-9, "{found:?}");
    assert!((found.depth.unwrap() - 0.2).abs() < 1e-9);
}
