//! What `planform evaluate` warns of and refuses.

mod cli_support;

use cli_support::Workshop;

/// A layout of square rooms of 4 m, whose lower left corners lie here, metres.
fn layout(corners: &[f64]) -> String {
    let room = |x: &f64| {
        let (x0, x1) = (*x, x + 4.0);
        let ring = format!("[[{x0},0],[{x1},0],[{x1},4],[{x0},4],[{x0},0]]");
        let geometry = format!(r#"{{"type": "Polygon", "coordinates": [{ring}]}}"#);
        format!(r#"{{"type": "Feature", "properties": {{}}, "geometry": {geometry}}}"#)
    };
    let features: Vec<_> = corners.iter().map(room).collect();
    format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, features.join(","))
}

fn warnings(prediction: &[f64]) -> String {
    let w = Workshop::empty();
    w.write("truth.geojson", layout(&[0.0, 5.0]));
    w.write("rooms.geojson", layout(prediction));
    w.does("evaluate rooms.geojson --truth truth.geojson").1
}

#[test]
fn a_good_prediction_is_no_reason_to_warn() {
    assert_eq!(warnings(&[0.0, 5.0]), "");
}

#[test]
fn a_prediction_without_rooms_is_warned_of() {
    assert!(warnings(&[]).contains("warning: rooms.geojson shows no room"));
}

#[test]
fn a_prediction_that_lies_elsewhere_is_warned_of() {
    let warned = warnings(&[-3.0]);
    assert!(warned.contains("75 % of rooms.geojson") && warned.contains("same map and frame?"), "{warned}");
    assert!(warnings(&[5000.0]).contains("same map and frame?"));
}

#[test]
fn degrees_are_refused() {
    let w = Workshop::new();
    w.does("convert map.yaml -o earth.geojson --anchor 48.1,11.5,0");
    w.does("convert map.yaml -o rooms.geojson");
    w.refuses(
        "evaluate earth.geojson --truth rooms.geojson",
        1,
        &["earth.geojson: is in degrees", "without --anchor"],
    );
}

#[test]
fn other_files_are_answered_with_the_two_kinds_that_are_read() {
    let w = Workshop::new();
    w.does("convert map.yaml -o rooms.svg -o rooms.geojson");
    for (args, file) in [
        ("evaluate rooms.geojson --truth map.yaml", "map.yaml"),
        ("evaluate rooms.svg --truth map.pgm", "rooms.svg"),
        ("evaluate rooms.svg --truth rooms.geojson", "rooms.svg"),
    ] {
        w.refuses(args, 1, &[file, "GeoJSON"]);
    }
}
