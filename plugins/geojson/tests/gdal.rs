//! GDAL, which most GIS programs read with, must see what was written.

#![allow(clippy::unwrap_used)]

use planform_sdk::{Document, Layout, Options};
use std::path::Path;
use std::process::Command;

/// The flat written with these options, in a folder that is removed with the handle.
fn written(options: &[(&str, &str)]) -> (Layout, tempfile::TempDir) {
    let layout: Layout = serde_json::from_str(include_str!("../../svg/tests/flat.json")).unwrap();
    let exporter = planform_geojson::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let mut file = std::fs::File::create(folder.path().join("flat.geojson")).unwrap();
    exporter.write(&Document { layout: &layout, scene: None }, &options, &mut file).unwrap();
    (layout, folder)
}

fn ogrinfo(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new("ogrinfo")
        .args(arguments)
        .arg(folder.join("flat.geojson"))
        .output()
        .expect("these tests need `ogrinfo`: apt-get install gdal-bin");
    assert!(output.status.success());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    String::from_utf8(output.stdout).unwrap()
}

/// The values of a field in `ogrinfo`'s listing of features.
fn values(listing: &str, field: &str) -> Vec<String> {
    let lines = listing.lines().filter_map(|l| l.trim_start().strip_prefix(field));
    lines.filter_map(|l| l.split_once(" = ")).map(|(_, v)| v.to_owned()).collect()
}

fn numbers(listing: &str, field: &str) -> Vec<f64> {
    values(listing, field).iter().map(|v| v.parse().unwrap()).collect()
}

#[test]
fn features_are_counted_alike() {
    let (layout, folder) = written(&[("lines", "true")]);
    for (kind, expected) in [
        ("room", layout.rooms.len()),
        ("wall", layout.walls.len()),
        ("frontier", layout.frontiers.len()),
        ("line", layout.lines.len()),
        ("text", layout.texts.len()),
        ("symbol", layout.symbols.len()),
    ] {
        let sql = format!("SELECT COUNT(*) AS n FROM flat WHERE kind = '{kind}'");
        assert_eq!(
            numbers(&ogrinfo(folder.path(), &["-q", "-sql", &sql]), "n "),
            [expected as f64],
            "{kind}"
        );
    }
    let sql = "SELECT COUNT(*) AS n FROM flat WHERE kind IN ('door', 'passage')";
    let listing = ogrinfo(folder.path(), &["-q", "-sql", sql]);
    assert_eq!(numbers(&listing, "n "), [layout.openings.len() as f64]);
}

#[test]
fn areas_are_measured_alike() {
    let (layout, folder) = written(&[]);
    let sql = "SELECT OGR_GEOM_AREA AS a, id, room FROM flat WHERE kind = 'room'";
    let listing = ogrinfo(folder.path(), &["-q", "-sql", sql]);
    assert_eq!(values(&listing, "id "), ["room-1", "room-2", "room-3", "room-4", "room-5", "room-6"]);
    let areas = numbers(&listing, "a ");
    assert_eq!(areas.len(), layout.rooms.len());
    for (room, area) in layout.rooms.iter().zip(areas) {
        assert!((area / room.area() - 1.0).abs() < 1e-3, "room {}: {area}", room.id);
    }
}

#[test]
fn metres_are_a_local_system() {
    let (_, folder) = written(&[]);
    let summary = ogrinfo(folder.path(), &["-so", "-al"]);
    assert!(
        summary.contains(r#"ENGCRS["map frame""#) || summary.contains(r#"LOCAL_CS["map frame""#),
        "{summary}"
    );
    assert!(!summary.contains("WGS 84"), "{summary}");
    assert!(summary.contains("Extent: (-3.5"), "{summary}");
}

#[test]
fn anchored_is_wgs_84() {
    let (layout, folder) = written(&[("anchor", "47.3769,8.5417,12.5")]);
    let summary = ogrinfo(folder.path(), &["-so", "-al"]);
    assert!(summary.contains("WGS 84") && summary.contains("Extent: (8.5416"), "{summary}");
    assert!(summary.contains(&format!("Feature Count: {}", features(&layout))), "{summary}");
}

fn features(l: &Layout) -> usize {
    l.rooms.len() + l.walls.len() + l.openings.len() + l.frontiers.len() + l.texts.len() + l.symbols.len()
}
