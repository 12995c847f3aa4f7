//! The published schemas: they are current, and true of what the program reads and writes.
//!
//! When a change is meant to alter them, run with `UPDATE_REFERENCES=1` and look at what `git diff` shows.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod cli_support;

use accuracy_support::layout_of;
use cli_support::Workshop;
use jsonschema::Validator;
use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{
    Annotations, Document, DoorLeaf, GeoAnchor, Layout, OpeningKind, Options, Point, Pose, Provenance, Scale,
    Scene, Segment, Source, StatedOpening, Symbol, Text, schema,
};
use planform_synth::{Building, BuildingParams, ScanParams, Size, corridor_with_rooms, two_rooms};
use serde::{Serialize, Serializer};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// The schemas that are published, and their names.
fn schemas() -> [(&'static str, Value); 3] {
    [("layout", schema::layout()), ("scene", schema::scene()), ("options", schema::options())]
}

fn validator(name: &str) -> Validator {
    let (_, schema) = schemas().into_iter().find(|(n, _)| *n == name).unwrap();
    jsonschema::draft202012::new(&schema).unwrap()
}

/// What is wrong with a value by this schema.
fn faults(schema: &Validator, value: &Value) -> Vec<String> {
    schema.iter_errors(value).map(|e| format!("{}: {e}", e.instance_path())).collect()
}

fn fits(schema: &Validator, value: &Value, what: &str) {
    assert_eq!(faults(schema, value), [""; 0], "{what}");
}

/// A schema as it is published: what it is about comes first, the parts that it refers to last.
struct Ordered<'a>(&'a Value);

const FIRST: [&str; 5] = ["$schema", "$id", "title", "description", "type"];

impl Serialize for Ordered<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Value::Object(members) => {
                let rank = |name: &str| FIRST.iter().position(|f| *f == name).unwrap_or(FIRST.len());
                let mut members: Vec<_> = members.iter().collect();
                members.sort_by_key(|(name, _)| (*name == "$defs", rank(name)));
                serializer.collect_map(members.into_iter().map(|(name, value)| (name, Ordered(value))))
            }
            Value::Array(items) => serializer.collect_seq(items.iter().map(Ordered)),
            plain => plain.serialize(serializer),
        }
    }
}

#[test]
fn they_are_current() {
    for (name, made) in schemas() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas").join(format!("{name}.schema.json"));
        let text = serde_json::to_string_pretty(&Ordered(&made)).unwrap() + "\n";
        if std::env::var_os("UPDATE_REFERENCES").is_some() {
            fs::write(&file, &text).unwrap();
        }
        let kept = fs::read_to_string(&file).unwrap_or_default();
        assert!(
            kept == text,
            "{name}.schema.json is not what the program says; UPDATE_REFERENCES=1 renews it"
        );
        jsonschema::draft202012::meta::validate(&made).unwrap();
        assert!(made["$id"].as_str().unwrap().ends_with(&format!("/schemas/{name}.schema.json")));
        for word in ["[`", "](", "double", "uint32"] {
            assert!(
                !text.contains(word),
                "{name}.schema.json says `{word}`, which means something in Rust only"
            );
        }
    }
}

fn exported(layout: &Layout) -> Value {
    let mut bytes = vec![];
    let document = Document { layout, scene: None };
    planform_json::exporter().write(&document, &Options::default(), &mut bytes).unwrap();
    serde_json::from_slice(&bytes).unwrap()
}

fn annotations() -> Annotations {
    let pose = Pose { x: 1.5, y: -2.0, yaw: 0.3 };
    Annotations {
        texts: vec![Text { content: "Küche".into(), pose, width: 1.2, height: 0.3, confidence: 0.5 }],
        symbols: vec![Symbol {
            kind: "double-door".into(),
            pose,
            width: 1.6,
            height: 0.8,
            score: 1.0,
            leaves: vec![DoorLeaf {
                hinge: Point::new(0.7, -2.0),
                closed: Point::new(1.5, -2.0),
                open: Point::new(0.7, -1.2),
            }],
        }],
        openings: Some(vec![StatedOpening {
            kind: OpeningKind::Passage,
            segment: Segment::new(Point::new(1.5, -2.0), Point::new(4.0, -2.0)),
            depth: Some(0.2),
        }]),
        anchor: Some(GeoAnchor { latitude: 47.4, longitude: 8.5, bearing: -3.0, at: Point::new(0.5, 0.0) }),
        scale: Some(Scale { metres_per_pixel: 0.02, source: "written scale 1:100".into(), confidence: 0.9 }),
        provenance: Provenance { source: "plan.png".into(), adapter: "by-hand".into() },
        warnings: vec!["the scale was guessed".into()],
    }
}

/// The layout of a house that a robot saw in part, with a text, a symbol and a place on the Earth.
fn seen_in_part() -> Layout {
    let house = Building::generate(5, &BuildingParams::of_size(Size::House));
    let grid = house.scan(&ScanParams { seed: 5, unexplored: 0.5, ..ScanParams::default() }).unwrap().grid;
    let annotations = Annotations { openings: None, ..annotations() };
    reconstruct(&Scene::new(grid, annotations), &Params::default(), &mut ()).unwrap()
}

#[test]
fn layouts_fit_their_schema() {
    let office = Building::generate(4, &BuildingParams::of_size(Size::Office));
    let partial = seen_in_part();
    assert!(!partial.frontiers.is_empty() && !partial.lines.is_empty());
    assert!(partial.anchor.is_some() && partial.texts.len() == 1 && partial.symbols.len() == 1);
    let layout = validator("layout");
    for (what, made) in [
        ("nothing", Layout::default()),
        ("two rooms", two_rooms().layout().clone()),
        ("two rooms as found", layout_of(two_rooms().clean_grid(0.05).unwrap())),
        ("a corridor as found", layout_of(corridor_with_rooms(6).clean_grid(0.05).unwrap())),
        ("an office", office.layout().clone()),
        ("an office as found", layout_of(office.clean_grid(0.05).unwrap())),
        ("a house seen in part", partial),
    ] {
        fits(&layout, &exported(&made), what);
    }
    let w = Workshop::new();
    w.does("convert map.yaml -o plan.layout.json");
    fits(&layout, &serde_json::from_slice(&w.read("plan.layout.json")).unwrap(), "what the program writes");
}

#[test]
fn annotations_fit_their_schema() {
    let w = Workshop::new();
    let (adapter, path) = (planform_slam_grid::adapter(), w.path("map.yaml"));
    let options = Options::parse(&adapter.info().options, []).unwrap();
    let read = adapter.read(&Source::open(path, Source::BYTE_LIMIT).unwrap(), &options).unwrap();
    let grid = two_rooms().clean_grid(0.05).unwrap();
    let scene = validator("scene");
    for (what, annotations) in [
        ("what the adapter says", read.annotations()),
        ("all there is", Scene::new(grid, annotations()).annotations()),
        ("nothing", Annotations::default()),
    ] {
        fits(&scene, &serde_json::to_value(annotations).unwrap(), what);
    }
}

#[test]
fn options_of_every_plugin_fit_their_schema() {
    let plugins: Vec<Value> = serde_json::from_str(&Workshop::empty().does("plugins --json").0).unwrap();
    assert!(plugins.len() >= 5);
    let schema = validator("options");
    for plugin in plugins {
        let (name, options) = (plugin["name"].as_str().unwrap(), &plugin["options"]);
        fits(&schema, options, name);
        jsonschema::draft202012::meta::validate(options).unwrap_or_else(|e| panic!("{name}: {e}"));
        let values = jsonschema::draft202012::new(options).unwrap();
        let properties = options["properties"].as_object().unwrap();
        let defaults =
            properties.iter().filter_map(|(name, p)| Some((name.clone(), p.get("default")?.clone())));
        fits(&values, &Value::Object(defaults.collect()), name);
        assert!(!faults(&values, &json!({"no-such-option": 1})).is_empty(), "{name}");
    }
}

/// One thing changed at a place; none takes it away.
fn changed(value: &Value, place: &str, to: Option<Value>) -> Value {
    let mut value = value.clone();
    let (parent, name) = place.rsplit_once('/').unwrap();
    let parent = value.pointer_mut(parent).unwrap_or_else(|| panic!("there is no {place}"));
    match (parent, to) {
        (Value::Object(members), Some(to)) => drop(members.insert(name.into(), to)),
        (Value::Object(members), None) => drop(members.remove(name).unwrap()),
        (Value::Array(items), Some(to)) => items[name.parse::<usize>().unwrap()] = to,
        (Value::Array(items), None) => drop(items.remove(name.parse().unwrap())),
        _ => panic!("{place} is in nothing"),
    }
    value
}

fn refused(schema: &Validator, value: &Value, changes: &[(&str, Option<Value>)]) {
    fits(schema, value, "before the change");
    for (place, to) in changes {
        assert!(!faults(schema, &changed(value, place, to.clone())).is_empty(), "{place} to {to:?}");
    }
}

#[test]
fn broken_layouts_are_refused() {
    let layout = exported(&seen_in_part());
    let members =
        ["rooms", "walls", "openings", "frontiers", "lines", "texts", "symbols", "anchor", "method"];
    let missing = members.map(|name| (format!("/{name}"), None));
    refused(
        &validator("layout"),
        &layout,
        &missing.each_ref().map(|(place, to)| (place.as_str(), to.clone())),
    );
    refused(
        &validator("layout"),
        &layout,
        &[
            ("/provenance/source", None),
            ("/rooms", Some(json!({}))),
            ("/rooms/0", Some(json!(1))),
            ("/rooms/0/id", None),
            ("/rooms/0/id", Some(json!("1"))),
            ("/rooms/0/id", Some(json!(0))),
            ("/rooms/0/id", Some(json!(1.5))),
            ("/rooms/0/id", Some(json!(4_294_967_296u64))),
            ("/rooms/0/name", None),
            ("/rooms/0/name", Some(json!(7))),
            ("/rooms/0/state", Some(json!("unknown"))),
            ("/rooms/0/inner/exterior", None),
            ("/rooms/0/inner/exterior", Some(json!([[0, 0], [1, 1]]))),
            ("/rooms/0/inner/exterior/0", Some(json!([0, 0, 0]))),
            ("/rooms/0/inner/exterior/0", Some(json!([0]))),
            ("/rooms/0/inner/exterior/0/1", Some(json!("0"))),
            ("/rooms/0/inner/exterior/0/1", Some(json!(null))),
            ("/rooms/0/centre/holes", Some(json!([[[0, 0]]]))),
            ("/walls/0/line", Some(json!([[0, 0]]))),
            ("/walls/0/thickness", Some(json!(-0.1))),
            ("/walls/0/weight", Some(json!(1.1))),
            ("/walls/0/rooms", Some(json!([1]))),
            ("/walls/0/rooms/0", Some(json!(-1))),
            ("/walls/0/rooms/1", Some(json!(0))),
            ("/openings/0/kind", Some(json!("window"))),
            ("/openings/0/rooms", Some(json!([1, null]))),
            ("/openings/0/rooms", Some(json!([1, 2, 3]))),
            ("/openings/0/rooms/0", Some(json!(0))),
            ("/frontiers/0/room", None),
            ("/frontiers/0/room", Some(json!(0))),
            ("/lines/0/support", Some(json!("long"))),
            ("/texts/0/pose/yaw", None),
            ("/symbols/0/score", None),
            ("/anchor/at", None),
            ("/anchor/latitude", Some(json!("north"))),
        ],
    );
}

#[test]
fn members_of_later_versions_are_let_through() {
    let layout = exported(&seen_in_part());
    for place in ["/storey", "/rooms/0/storey", "/provenance/storey"] {
        fits(&validator("layout"), &changed(&layout, place, Some(json!(1))), place);
    }
    let scene = serde_json::to_value(annotations()).unwrap();
    fits(&validator("scene"), &changed(&scene, "/storey", Some(json!(1))), "scene");
}

#[test]
fn broken_annotations_are_refused() {
    let scene = serde_json::to_value(annotations()).unwrap();
    refused(
        &validator("scene"),
        &scene,
        &[
            ("/texts", None),
            ("/symbols", None),
            ("/anchor", None),
            ("/provenance", None),
            ("/warnings", None),
            ("/warnings/0", Some(json!(1))),
            ("/texts/0/content", None),
            ("/texts/0/width", Some(json!("1 m"))),
            ("/symbols/0/kind", Some(json!(1))),
            ("/anchor/bearing", None),
        ],
    );
}

#[test]
fn options_that_planform_cannot_read_are_refused() {
    let options = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Options",
        "type": "object",
        "properties": {
            "scale": {"type": "number", "exclusiveMinimum": 0, "minimum": 1, "exclusiveMaximum": 9, "maximum": 8},
            "count": {"type": "integer", "default": 1, "description": "How many"},
            "paper": {"type": "string", "enum": ["A4", "A3"], "default": "A4"},
            "grid": {"type": "boolean", "default": true},
        },
        "additionalProperties": false,
    });
    let schema = validator("options");
    let changes = [
        ("/type", None),
        ("/type", Some(json!("array"))),
        ("/required", Some(json!(["scale"]))),
        ("/additionalProperties", Some(json!(true))),
        ("/properties", Some(json!([]))),
        ("/properties/scale/type", Some(json!("object"))),
        ("/properties/scale/minimum", Some(json!("0"))),
        ("/properties/scale/minimum", Some(json!(null))),
        ("/properties/scale/multipleOf", Some(json!(2))),
        ("/properties/count/default", Some(json!([]))),
        ("/properties/count/default", Some(json!(null))),
        ("/properties/paper/enum", Some(json!([1]))),
        ("/properties/paper/description", Some(json!(null))),
    ];
    refused(&schema, &options, &changes);
    schema::read_options(&options.to_string()).unwrap();
    for (place, to) in changes {
        let broken = changed(&options, place, to).to_string();
        assert!(schema::read_options(&broken).is_err(), "planform reads {broken}");
    }
}
