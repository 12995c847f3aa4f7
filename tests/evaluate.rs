//! Files against files: the whole comparison, on pictures of two rooms whose scores can be worked out by hand.
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use image::{GrayImage, ImageBuffer, Luma, Rgba, RgbaImage};
use planform::evaluate::report::{json, pair_table, set_table};
use planform::evaluate::{Clip, EvaluateError, LabelMode, Measures, Settings, Units, evaluate, evaluate_set};
use planform_sdk::{ErrorKind, Pose};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Rooms A (60 x 40) and B (20 x 40), a wall of 5 pixels between, in an image of 100 x 60.
const A: [f64; 4] = [5.0, 10.0, 65.0, 50.0];
const B: [f64; 4] = [70.0, 10.0, 90.0, 50.0];

fn within(x: u32, y: u32, [x0, y0, x1, y1]: [f64; 4]) -> bool {
    let (x, y) = (f64::from(x), f64::from(y));
    x0 <= x && x < x1 && y0 <= y && y < y1
}

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) -> PathBuf {
        fs::write(self.path(name), text).unwrap();
        self.path(name)
    }

    /// A truth with rooms A and B in white, and a speck of 90 pixels.
    fn truth(&self) -> PathBuf {
        let speck = [0.0, 51.0, 10.0, 60.0];
        let white = |x, y| [A, B, speck].iter().any(|&room| within(x, y, room));
        GrayImage::from_fn(100, 60, |x, y| Luma([if white(x, y) { 254 } else { 0 }]))
            .save(self.path("truth.png"))
            .unwrap();
        self.path("truth.png")
    }

    fn layout(&self, name: &str, rooms: &[[f64; 4]]) -> PathBuf {
        let ring = |[x0, y0, x1, y1]: &[f64; 4]| {
            format!("[[[{x0},{y0}],[{x1},{y0}],[{x1},{y1}],[{x0},{y1}],[{x0},{y0}]]]")
        };
        let feature = |room| {
            let geometry = format!(r#"{{"type": "Polygon", "coordinates": {}}}"#, ring(room));
            format!(r#"{{"type": "Feature", "properties": {{"kind": "room"}}, "geometry": {geometry}}}"#)
        };
        let features: Vec<_> = rooms.iter().map(feature).collect();
        self.write(name, &format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, features.join(",")))
    }
}

fn pixels() -> Settings {
    Settings { units: Units::Pixels, truth_units: Units::Pixels, ..Settings::default() }
}

fn clipped(prediction: &Path, truth: &Path, settings: &Settings) -> Measures {
    evaluate(Some(prediction), truth, settings).unwrap().clipped.measures
}

const PERFECT: Measures = Measures {
    a_fc: 1.0,
    a_bc: 1.0,
    precision: 1.0,
    recall: 1.0,
    miou: 1.0,
    m50: 2,
    n_pred: 2,
    n_gt: 2,
    n_phantom: 0,
    spill: 0.0,
};

#[test]
fn the_true_rooms_are_perfect_with_either_clip() {
    let f = Folder::new();
    let scores = evaluate(Some(&f.layout("p.geojson", &[A, B])), &f.truth(), &pixels()).unwrap();
    assert_eq!((scores.clipped.measures, scores.raw.measures), (PERFECT, PERFECT));
    assert_eq!(scores.clipped.rooms[0].room, "at 5,10");
}

#[test]
fn one_room_over_everything() {
    let f = Folder::new();
    let scores =
        evaluate(Some(&f.layout("p.geojson", &[[0.0, 0.0, 100.0, 60.0]])), &f.truth(), &pixels()).unwrap();
    let (known, raw) = (scores.clipped.measures, scores.raw.measures);
    assert_eq!((known.a_fc, known.precision, known.a_bc, known.recall), (0.75, 0.75, 1.0, 1.0));
    assert_eq!((raw.a_fc, raw.precision, raw.miou), (0.4, 0.4, 0.2));
    assert!((known.spill - (1.0 - 3200.0 / 6000.0)).abs() < 1e-15);
}

#[test]
fn a_phantom_room_costs_precision() {
    let f = Folder::new();
    let known = clipped(&f.layout("p.geojson", &[A, B, [0.0, 0.0, 100.0, 8.0]]), &f.truth(), &pixels());
    assert_eq!((known.n_phantom, known.precision, known.a_fc), (1, 2.0 / 3.0, 0.8));
    assert_eq!((known.recall, known.miou), (1.0, 1.0));
}

#[test]
fn metres_run_up_from_the_origin() {
    let f = Folder::new();
    let in_metres = |[x0, y0, x1, y1]: [f64; 4]| {
        [x0 * 0.5 - 3.0, (60.0 - y1) * 0.5 + 7.0, x1 * 0.5 - 3.0, (60.0 - y0) * 0.5 + 7.0]
    };
    let layout = f.layout("p.geojson", &[in_metres(A), in_metres(B)]);
    let origin = Some(Pose { x: -3.0, y: 7.0, yaw: 0.0 });
    let settings = Settings { resolution: Some(0.5), origin, ..Settings::default() };
    assert_eq!(clipped(&layout, &f.truth(), &settings), PERFECT);
    let truth = f.layout("truth.geojson", &[A, B]);
    let mixed = Settings { truth_units: Units::Pixels, map_height: Some(60), ..settings.clone() };
    assert_eq!(clipped(&layout, &truth, &mixed), PERFECT);
    let e = evaluate(Some(&layout), &truth, &Settings { map_height: None, ..mixed }).unwrap_err();
    assert_eq!(e.error.kind, ErrorKind::BadOption);
}

#[test]
fn a_truth_layout_scores_as_its_picture() {
    let f = Folder::new();
    let truth = f.layout("truth.geojson", &[A, B]);
    let found = f.layout("p.geojson", &[[5.0, 10.0, 35.0, 50.0], [35.0, 10.0, 65.0, 50.0], B]);
    let (polygons, picture) = (clipped(&found, &truth, &pixels()), clipped(&found, &f.truth(), &pixels()));
    assert_eq!(polygons, picture);
    assert_eq!((polygons.recall, polygons.a_bc, polygons.miou), (0.75, 0.625, 0.75));
}

#[test]
fn label_images_of_16_bits_and_with_transparency() {
    let f = Folder::new();
    let number = |x, y| if within(x, y, A) { 1u16 } else { 300 * u16::from(within(x, y, B)) };
    ImageBuffer::from_fn(100, 60, |x, y| Luma([number(x, y)])).save(f.path("sixteen.png")).unwrap();
    // Outside the rooms a red that is wholly transparent.
    let colour = |x, y| match (within(x, y, A), within(x, y, B)) {
        (true, _) => Rgba([200, 30, 30, 255]),
        (_, true) => Rgba([30, 30, 200, 255]),
        _ => Rgba([255, 0, 0, 0]),
    };
    RgbaImage::from_fn(100, 60, colour).save(f.path("alpha.png")).unwrap();
    assert_eq!(clipped(&f.path("sixteen.png"), &f.truth(), &pixels()), PERFECT);
    assert_eq!(clipped(&f.path("alpha.png"), &f.path("sixteen.png"), &pixels()), PERFECT);
    let white = Settings { truth_mode: Some(LabelMode::White), ..pixels() };
    assert_eq!(clipped(&f.path("alpha.png"), &f.path("sixteen.png"), &white).n_gt, 0);
}

#[test]
fn the_smallest_room_is_an_option() {
    let f = Folder::new();
    let (truth, found) = (f.truth(), f.layout("p.geojson", &[A, B]));
    let with = |min_px| clipped(&found, &truth, &Settings { min_px: Some(min_px), ..pixels() });
    assert_eq!((with(89).n_gt, with(90).n_gt), (3, 2));
    assert_eq!((with(799).n_pred, with(800).n_pred, with(800).n_gt), (2, 1, 1));
}

const MANIFEST: &str = r#"{"maps": [
    {"name": "found", "gt": "truth.png", "gt_mode": "white", "map": "map.png"},
    {"name": "missed", "gt": "truth.png", "resolution": null},
    {"name": "blank", "map": "blank.png"}
]}"#;

#[test]
fn a_missing_prediction_scores_0_and_a_map_without_truth_is_skipped() {
    let f = Folder::new();
    f.truth();
    f.layout("found.geojson", &[A, B]);
    let set = evaluate_set(&f.write("manifest.json", MANIFEST), f.0.path(), &pixels()).unwrap();
    assert_eq!(set.maps[0].1.clipped.measures, PERFECT);
    assert_eq!(set.maps[1].1.clipped.measures, Measures { n_gt: 2, ..Measures::default() });
    assert_eq!((set.summary.clipped.mean.a_fc, set.summary.raw.std.recall), (0.5, 0.5));
    let table = set_table(&set, Clip::Known);
    assert!(table.contains("missed (no prediction)") && table.contains("having no truth: blank"), "{table}");
    assert!(table.contains("mean of 2"), "{table}");
}

#[test]
fn reports_show_every_room() {
    let f = Folder::new();
    let scores = evaluate(Some(&f.layout("p.geojson", &[A])), &f.truth(), &pixels()).unwrap();
    let table = pair_table("p", &scores, Clip::Known);
    assert!(table.contains("at 5,10       6.00   100.0  100.0  feature 1"), "{table}");
    assert!(table.contains("at 70,10      2.00     0.0    0.0  -"), "{table}");
    let value: serde_json::Value = serde_json::from_str(&json(&scores).unwrap()).unwrap();
    assert_eq!((&value["raw"]["R"], &value["clipped"]["M50"]), (&0.5.into(), &1.into()));
    assert_eq!(value["clipped"]["rooms"][1]["prediction"], serde_json::Value::Null);
}

fn fails(result: Result<impl std::fmt::Debug, EvaluateError>, file: &str, words: &str) {
    let e = result.unwrap_err();
    assert!(e.file.ends_with(file), "{e}");
    assert!(e.to_string().contains(words), "{e}");
}

#[test]
fn errors_name_the_file_and_the_fault() {
    let f = Folder::new();
    let (truth, found) = (f.truth(), f.layout("p.geojson", &[A]));
    let pair = |p: &Path, t: &Path| evaluate(Some(p), t, &pixels());
    fails(pair(&f.path("gone.geojson"), &truth), "gone.geojson", "");
    fails(pair(&f.write("bad.geojson", "{\n  oops"), &truth), "bad.geojson", "line 2 column");
    fails(pair(&found, &f.write("no.png", "text")), "no.png", "neither a picture");
    fails(pair(&found, &f.write("huge.pgm", "P5 99999 99999 255\n")), "huge.pgm", "99999 x 99999");
    fails(
        pair(&f.layout("far.geojson", &[[0.0, 0.0, 1e300, 1.0]]), &truth),
        "far.geojson",
        "pixels from the map",
    );
    GrayImage::new(9, 9).save(f.path("small.png")).unwrap();
    fails(pair(&f.path("small.png"), &truth), "small.png", "9 x 9 pixels, but its truth has 100 x 60");
    fails(pair(&truth, &found), "truth.png", "is not named *.geojson");
    let set = |text| evaluate_set(&f.write("m.json", text), f.0.path(), &pixels());
    fails(set("{\"maps\": [{}]}"), "m.json", "line 1 column");
    fails(set(r#"{"maps": [{"name": "a"}]}"#), "m.json", "no map with a truth");
    fails(set(r#"{"maps": [{"name": "a"}, {"name": "a"}]}"#), "m.json", "two maps named `a`");
    fails(set(r#"{"maps": [{"name": "a", "gt": "gone.png"}]}"#), "gone.png", "");
}

#[test]
fn a_million_corners_far_outside_are_no_trouble() {
    let f = Folder::new();
    let corner = |i: u32| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 1e6).sin_cos();
        let radius = if i.is_multiple_of(2) { 1e6 } else { 9e5 };
        format!("[{:.3},{:.3}]", 50.0 + radius * cos, 30.0 + radius * sin)
    };
    let ring: Vec<_> = (0..1_000_000).chain([0]).map(corner).collect();
    let geometry = format!(r#"{{"type": "Polygon", "coordinates": [[{}]]}}"#, ring.join(","));
    let feature = format!(r#"{{"type": "Feature", "properties": null, "geometry": {geometry}}}"#);
    let star =
        f.write("star.geojson", &format!(r#"{{"type": "FeatureCollection", "features": [{feature}]}}"#));
    let known = clipped(&star, &f.truth(), &pixels());
    assert_eq!((known.recall, known.precision), (1.0, 0.75));
}
