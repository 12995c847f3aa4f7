//! `planform plugins new`: what it makes builds, passes its own tests and planform's checks, and converts, right away
//! and outside of this workspace; what it refuses, it leaves alone.
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod cli_support;

use cli_support::{Workshop, text};
use planform::host::{OutsideSettings, Registry};
use planform_sdk::{
    Document, Layout, Opening, OpeningKind, Options, Point, Polygon, Room, RoomState, Segment,
};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::PathBuf;
use std::process::Command;

/// Where all projects' dependencies are compiled, once. Cargo tells projects in it apart by their names alone, so a
/// name always stands for the same kind.
const BUILD: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/plugins");

/// A new project, built: its folder, and its library in it.
struct Project<'a> {
    workshop: &'a Workshop,
    name: &'a str,
    is_rust: bool,
}

impl<'a> Project<'a> {
    fn new(workshop: &'a Workshop, name: &'a str, kind: &str, lang: &str) -> Self {
        let (told, _) = workshop.does(&format!("plugins new {name} --kind {kind} --lang {lang}"));
        let project = Self { workshop, name, is_rust: lang == "rust" };
        assert!(told.contains(&project.library()), "{told}");
        match lang {
            "rust" => project.runs("cargo build --release"),
            _ => project.runs("make CFLAGS=-Wpedantic"),
        };
        project
    }

    /// The library, from the project's folder.
    fn library(&self) -> String {
        match self.is_rust {
            true => format!("target/release/{DLL_PREFIX}{}{DLL_SUFFIX}", self.name.replace('-', "_")),
            false => format!("{}{DLL_SUFFIX}", self.name),
        }
    }

    /// The folder to look for the library in, from the workshop.
    fn folder(&self) -> String {
        format!("{}/{}", self.name, if self.is_rust { "target/release" } else { "" })
    }

    /// Runs a program in the project, which must not warn of anything; what it prints.
    fn runs(&self, line: &str) -> String {
        let mut words = line.split(' ');
        let mut command = Command::new(words.next().unwrap());
        command.args(words).current_dir(self.workshop.path(self.name));
        command.env_remove("CARGO_TARGET_DIR").env("CARGO_BUILD_BUILD_DIR", BUILD);
        // What this program was built from is there.
        command.env("CARGO_NET_OFFLINE", "true");
        let output = command.output().unwrap_or_else(|e| panic!("{line}: {e}"));
        let (out, err) = (text(&output.stdout), text(&output.stderr));
        assert!(output.status.success() && !err.contains("warning"), "{line}\n{out}{err}");
        out
    }
}

fn an_input_plugin_reads_its_sample(lang: &str) {
    let w = Workshop::empty();
    let project = Project::new(&w, "my-plan", "input", lang);
    let (library, folder) = (project.library(), project.folder());
    w.does(&format!("plugins check my-plan/{library} --sample my-plan/sample.my-plan"));
    let convert = format!("convert my-plan/sample.my-plan --plugin-dir {folder}");
    let (_, summary) = w.does(&format!("{convert} -o flat.svg"));
    assert!(summary.contains("4 rooms") && summary.contains("3 doors"), "{summary}");

    // Half as wide, a quarter of the area.
    w.does(&format!("{convert} -o large.geojson"));
    w.does(&format!("{convert} -o small.geojson --resolution 0.05"));
    let area = |name: &str| -> f64 {
        let collection: serde_json::Value = serde_json::from_slice(&w.read(name)).unwrap();
        let features = collection["features"].as_array().unwrap().iter();
        features.filter_map(|f| f["properties"]["area"].as_f64()).sum()
    };
    assert!((area("large.geojson") / area("small.geojson") - 4.0).abs() < 0.2);
    w.refuses(&format!("{convert} -o flat2.svg --resolution 0"), 2, &["resolution", "at least 0.001"]);

    w.write("bad.my-plan", "###\n#o#\n###\n");
    w.refuses(
        &format!("convert bad.my-plan --plugin-dir {folder} -o bad.svg"),
        1,
        &["bad.my-plan: line 2: column 2 holds `o`", "draw with `#`"],
    );
}

#[test]
fn an_input_plugin_in_rust_reads_its_sample() {
    an_input_plugin_reads_its_sample("rust");
}

#[test]
fn an_input_plugin_in_c_reads_its_sample() {
    an_input_plugin_reads_its_sample("c");
}

fn an_exporter_writes_a_table(lang: &str) {
    let w = Workshop::new();
    let project = Project::new(&w, "my-table", "exporter", lang);
    let (library, folder) = (project.library(), project.folder());
    w.does(&format!("plugins check my-table/{library}"));
    w.does(&format!("convert map.yaml --plugin-dir {folder} -o rooms.my-table"));
    let table = text(&w.read("rooms.my-table"));
    let rows: Vec<_> = table.lines().map(|line| line.split(',').collect::<Vec<_>>()).collect();
    assert_eq!(rows[0], ["id", "name", "area_m2", "centre_x_m", "centre_y_m", "doors"]);
    // The two rooms are side by side in the map's frame, about 21 square metres each, with a door between.
    for (row, (id, x)) in rows[1..].iter().zip([("1", 1.75), ("2", 6.25)]) {
        assert_eq!((row[0], row[1], row[5]), (id, "", "1"), "{table}");
        for (field, truth) in [(2, 21.3), (3, x), (4, 5.0)] {
            assert!((row[field].parse::<f64>().unwrap() - truth).abs() < 0.5, "{table}");
        }
    }
    assert_eq!(rows.len(), 1 + 2);
    w.does(&format!("convert map.yaml --plugin-dir {folder} -o semi.my-table --set separator=semicolon"));
    assert_eq!(text(&w.read("semi.my-table")), table.replace(',', ";"));
    let sample = format!("convert my-table/sample.pbm --resolution 0.1 --plugin-dir {folder}");
    w.does(&format!("{sample} -o sample.my-table"));
    assert_eq!(text(&w.read("sample.my-table")).lines().count(), 1 + 4);
}

#[test]
fn an_exporter_in_rust_writes_a_table() {
    an_exporter_writes_a_table("rust");
}

#[test]
fn an_exporter_in_c_writes_a_table() {
    an_exporter_writes_a_table("c");
}

#[test]
fn projects_in_rust_pass_their_own_tests() {
    let w = Workshop::empty();
    for (name, kind) in [("my-plan", "input"), ("my-table", "exporter")] {
        let out = Project::new(&w, name, kind, "rust").runs("cargo test --quiet");
        assert!(out.contains("test result: ok"), "{out}");
    }
}

/// A layout whose rooms have every kind of name, and floors with and without a hole, one of them far away.
fn layout() -> Layout {
    let square = |x: f64, y: f64, side: f64| {
        [[x, y], [x + side, y], [x + side, y + side], [x, y + side]].map(Point::from).to_vec()
    };
    let names = ["", "Küche", "a,b", "a;b", "a\tb", "the \"red\" room", "two\nlines", "c\rd", "\"", "zero\0"];
    let rooms = names.iter().zip(1..).map(|(name, id)| {
        let x = 1234.567 * f64::from(id) - 3.0;
        let holes = if id % 2 == 0 { vec![] } else { vec![square(x + 0.1, 0.2, 0.7)] };
        let floor = Polygon::new(square(x, -0.001, 1.5 + f64::from(id) / 3.0), holes);
        let name = Some((*name).to_owned()).filter(|n| !n.is_empty());
        Room { id, name, stated_area: None, state: RoomState::Complete, inner: floor.clone(), centre: floor }
    });
    let opening = |kind, rooms| Opening { kind, segment: Segment::default(), rooms };
    let (door, passage) = (OpeningKind::Door, OpeningKind::Passage);
    let openings = vec![opening(door, [1, 2]), opening(door, [2, 3]), opening(passage, [2, 4])];
    Layout { rooms: rooms.collect(), openings, ..Layout::default() }
}

#[test]
fn exporters_in_both_languages_write_the_same() {
    let w = Workshop::empty();
    let folder = |name, lang| w.path(&Project::new(&w, name, "exporter", lang).folder());
    let folders: Vec<PathBuf> = vec![folder("rust-table", "rust"), folder("c-table", "c")];
    let registry = Registry::builtin().with_outside(OutsideSettings { folders, isolation: None });
    let layout = layout();
    let written = |name, separator| {
        let exporter = registry.exporter(name).unwrap();
        let options = Options::parse(&exporter.info().options, [("separator", separator)]).unwrap();
        let mut out = vec![];
        exporter.write(&Document { layout: &layout, scene: None }, &options, &mut out).unwrap();
        text(&out)
    };
    for separator in ["comma", "semicolon", "tab"] {
        assert_eq!(written("rust-table", separator), written("c-table", separator));
    }
    let table = written("c-table", "comma");
    for row in [
        "\n2,Küche,4.69,2467.22,1.08,2\n",
        "\n3,\"a,b\",",
        "\n6,\"the \"\"red\"\" room\",",
        "\n7,\"two\nlines\",",
    ] {
        assert!(table.contains(row), "{row:?} is not in\n{table}");
    }
}

#[test]
fn bad_names_are_refused() {
    let w = Workshop::empty();
    let long = "a".repeat(65);
    for (name, words) in [
        ("My_Plan", "lower-case letters"),
        ("2d-plan", "a letter comes first"),
        ("../plan", "lower-case letters"),
        (long.as_str(), "1 to 64"),
        ("fn", "keeps this word"),
        ("slam-grid", "built-in plugin slam-grid"),
        ("dxf", "built-in plugin dxf"),
        ("png", "built-in plugin slam-grid"),
    ] {
        w.refuses(&format!("plugins new {name} --kind input --lang rust"), 2, &[name, words]);
    }
    w.refuses("plugins new my-plan --kind input --lang cobol", 2, &["cobol"]);
}

#[test]
fn folders_that_hold_something_are_left_alone() {
    let w = Workshop::empty();
    w.does("plugins new my-plan --kind input --lang c --dir made");
    w.refuses("plugins new my-plan --kind input --lang rust --dir made", 1, &["made", "not empty", "--dir"]);
    w.write("my-plan", "a file");
    w.refuses("plugins new my-plan --kind input --lang c", 1, &["my-plan", "not a folder"]);
    assert!(w.path("made/my-plan.c").is_file() && !w.path("made/Cargo.toml").exists());
}
