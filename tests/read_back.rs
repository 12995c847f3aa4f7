//! What the program writes, read back by independent programs: GDAL, ezdxf, resvg, PyYAML and numpy, networkx,
//! Graphviz; and its drawings by itself.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
mod cli_support;

use accuracy_support::{layout_of, shared, to_geo};
use cli_support::{FREE, UNKNOWN, WALL, Workshop, pgm, text};
use geo::Area;
use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{Document, Grid, Layout, OpeningKind, Options, Point, Room, Source, ring_signed_area};
use planform_synth::{Building, BuildingParams, ScanParams, Size};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, roxmltree};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Floors, by which most readers count and measure.
const INNER: fn(&Room) -> f64 = |room| room.inner.area();
/// Outlines along the centre lines of the walls.
const CENTRE: fn(&Room) -> f64 = |room| room.centre.area();

/// A folder with the map that a robot made of an office, and the layout of that map.
fn office() -> (Workshop, Layout) {
    let building = Building::generate(4, &BuildingParams::of_size(Size::Office));
    let grid = building.scan(&ScanParams::default()).unwrap().grid;
    let w = Workshop::empty();
    w.write("office.pgm", picture(&grid));
    let origin = grid.origin();
    let yaml = format!(
        "image: office.pgm\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\noccupied_thresh: 0.65\n\
         free_thresh: 0.196\n",
        grid.resolution(),
        origin.x,
        origin.y,
        origin.yaw
    );
    w.write("office.yaml", yaml);
    let layout = layout_of(grid);
    assert!(layout.rooms.len() >= 10, "{} rooms", layout.rooms.len());
    (w, layout)
}

fn picture(grid: &Grid) -> Vec<u8> {
    pgm(grid.width(), grid.height(), |x, y| {
        match grid.cell(x.into(), i64::from(grid.height() - 1 - y)).occupancy() {
            None => UNKNOWN,
            Some(percent) if percent >= 65 => WALL,
            Some(_) => FREE,
        }
    })
}

/// Fails unless there are as many areas as rooms, and each is within 0.1 % of its room's.
fn same_areas(found: &[f64], layout: &Layout, area: fn(&Room) -> f64) {
    assert_eq!(found.len(), layout.rooms.len());
    for (found, room) in found.iter().zip(&layout.rooms) {
        let expected = area(room);
        assert!((found / expected - 1.0).abs() < 1e-3, "room {}: {found} for {expected} m2", room.id);
    }
}

/// Runs another program, which must succeed; its standard output.
fn run(program: &str, arguments: &[&str], file: &Path, install: &str) -> String {
    let output = Command::new(program).args(arguments).arg(file).output();
    let output = output.unwrap_or_else(|e| panic!("this test needs `{program}` ({e}): {install}"));
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success() && err.is_empty(), "{program}: {err}");
    out
}

/// The areas of the rooms as GDAL measures them, in the rooms' order. `measure` is an SQL expression.
fn ogr_areas(file: &Path, layer: &str, measure: &str) -> Vec<f64> {
    let sql = format!("SELECT {measure} AS a FROM {layer} WHERE kind = 'room' ORDER BY room");
    let listing =
        run("ogrinfo", &["-q", "-dialect", "SQLITE", "-sql", &sql], file, "apt-get install gdal-bin");
    let values = listing.lines().filter_map(|l| l.trim().strip_prefix("a (Real) = "));
    values.map(|v| v.parse().unwrap()).collect()
}

#[test]
fn gdal_reads_the_geojson() {
    let (w, layout) = office();
    for (boundary, area) in [("inner", INNER), ("centre", CENTRE)] {
        w.does(&format!("convert office.yaml -o {boundary}.geojson --set boundary={boundary}"));
        let file = w.path(&format!("{boundary}.geojson"));
        same_areas(&ogr_areas(&file, boundary, "ST_Area(geometry)"), &layout, area);
        let valid = ogr_areas(&file, boundary, "1.0 * ST_IsValid(geometry)");
        assert_eq!(valid, vec![1.0; layout.rooms.len()], "{boundary}");
    }
}

#[test]
fn gdal_finds_the_anchored_geojson_on_the_earth() {
    let (w, layout) = office();
    w.does("convert office.yaml -o earth.geojson --anchor 48.1374,11.5755,30");
    let file = w.path("earth.geojson");
    // UTM zone 32, whose scale here is 0.99965: areas are 0.07 % too small.
    let utm = "ST_Area(ST_Transform(geometry, 32632)) / (0.99965 * 0.99965)";
    same_areas(&ogr_areas(&file, "earth", utm), &layout, INNER);
    let summary = run("ogrinfo", &["-so", "-al"], &file, "apt-get install gdal-bin");
    assert!(summary.contains("WGS 84") && summary.contains("Extent: (11.57"), "{summary}");
}

/// What a plugin's script in Python says of these files.
fn told(script: &str, files: &[PathBuf]) -> Value {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("plugins").join(script);
    let output = Command::new("python3").arg(script).args(files).output();
    let output =
        output.unwrap_or_else(|e| panic!("this test needs `python3` ({e}): apt-get install python3"));
    // Without the packages that it needs the script says how to get them.
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn ezdxf_reads_every_version_of_the_dxf() {
    let (w, layout) = office();
    let versions = ["R12", "R2000", "R2013", "R2018"];
    let files = versions.map(|version| {
        w.does(&format!("convert office.yaml -o {version}.dxf --set dxf.version={version}"));
        w.path(&format!("{version}.dxf"))
    });
    let reports = told("dxf/tests/audit.py", &files);
    let reports = reports.as_array().unwrap();
    assert_eq!(reports.len(), versions.len());
    for (version, report) in versions.iter().zip(reports) {
        assert_eq!(report["version"], *version);
        assert_eq!(report["errors"], Value::Array(vec![]), "{version}");
        assert_eq!(report["fixes"], Value::Array(vec![]), "{version}");
        let area = |r: &Room| report["rooms"][r.id.to_string()]["area"].as_f64().unwrap();
        assert_eq!(report["rooms"].as_object().unwrap().len(), layout.rooms.len(), "{version}");
        same_areas(&layout.rooms.iter().map(area).collect::<Vec<_>>(), &layout, INNER);
    }
}

/// The layout of the drawing of a layout.
fn drawn_and_read(layout: &Layout) -> Layout {
    let (exporter, adapter) = (planform_dxf::exporter(), planform_blueprint::adapter());
    let mut bytes = vec![];
    let options = Options::parse(&exporter.info().options, []).unwrap();
    exporter.write(&Document { layout, scene: None }, &options, &mut bytes).unwrap();
    let source = Source { path: "office.dxf".into(), bytes, byte_limit: Source::BYTE_LIMIT };
    let options = Options::parse(&adapter.info().options, []).unwrap();
    let scene = adapter.read(&source, &options).unwrap();
    assert_eq!(scene.warnings, Vec::<String>::new());
    reconstruct(&scene, &Params::default(), &mut ()).unwrap()
}

#[test]
fn planform_reads_its_own_dxf() {
    let (_, mut layout) = office();
    layout.rooms[0].name = Some("Kitchen".into());
    let back = drawn_and_read(&layout);
    let overlap = |a: &Room, b: &Room| {
        let (a, b) = (to_geo(&a.inner), to_geo(&b.inner));
        let common = shared(&a, &b);
        common / (a.unsigned_area() + b.unsigned_area() - common)
    };
    for room in &layout.rooms {
        let (again, kept) =
            back.rooms.iter().map(|r| (r, overlap(room, r))).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        assert!(kept > 0.75, "room {}: {kept}", room.id);
        // The numbers of the drawing are no names.
        assert_eq!(again.name, room.name);
    }
    let doors = |l: &Layout| l.openings.iter().filter(|o| o.kind == OpeningKind::Door).count();
    assert_eq!(back.rooms.len(), layout.rooms.len());
    assert!(doors(&back) * 10 >= doors(&layout) * 9, "{} of {} doors", doors(&back), doors(&layout));
}

#[test]
fn a_map_server_reads_the_ros_map() {
    let (w, _) = office();
    w.does("convert office.yaml -o out.yaml");
    let report = told("ros-map/tests/read.py", &[w.path("out.yaml"), w.path("office.yaml")]);
    assert_eq!((&report["keys"]["image"], &report["keys"]["mode"]), (&"out.pgm".into(), &"trinary".into()));
    assert_eq!(report["greys"], serde_json::json!([0, 205, 254]));
    assert_eq!(report["same_frame"], true, "{report}");
    // The robot's map has furniture and noise in it, and the layout's has none.
    assert!(report["free"].as_f64().unwrap() > 0.85, "{report}");
    assert!(report["walls_on_walls"].as_f64().unwrap() > 0.9, "{report}");
}

#[test]
fn networkx_reads_the_graph() {
    let (w, layout) = office();
    w.does("convert office.yaml -o office.graph.json -o office.graphml");
    let [json, graphml] =
        ["graph.json", "graphml"].map(|e| told("graph/tests/read.py", &[w.path(&format!("office.{e}"))]));
    assert_eq!(json, graphml);
    assert_eq!((&json["directed"], &json["multigraph"]), (&false.into(), &false.into()));
    let nodes = json["nodes"].as_object().unwrap();
    assert_eq!(nodes.len(), layout.rooms.len() + layout.openings.len());
    for room in &layout.rooms {
        let node = &nodes[&format!("room-{}", room.id)];
        let area = node["area"].as_f64().unwrap();
        assert!((area - room.area()).abs() < 1e-3, "{node}");
        let point = Point::new(node["x"].as_f64().unwrap(), node["y"].as_f64().unwrap());
        assert!(room.inner.contains(point), "{node}");
    }
    no_way_is_shorter_than_a_bird_flies(&json);
}

fn no_way_is_shorter_than_a_bird_flies(report: &Value) {
    let place = |id: &str| {
        let node = &report["nodes"][id];
        Some(Point::new(node["x"].as_f64()?, node["y"].as_f64()?))
    };
    for (from, others) in report["distances"].as_object().unwrap() {
        for (to, distance) in others.as_object().unwrap() {
            let Some((a, b)) = place(from).zip(place(to)) else { continue };
            assert!(distance.as_f64().unwrap() > a.distance(b) - 0.01, "{from} {to}: {distance}");
        }
    }
}

#[test]
fn graphviz_reads_the_graph() {
    let (w, layout) = office();
    w.does("convert office.yaml -o office.dot -o office.graph.json");
    let drawn = run("dot", &["-Tjson0"], &w.path("office.dot"), "apt-get install graphviz");
    let drawn: Value = serde_json::from_str(&drawn).unwrap();
    let counted = |list: &str| drawn[list].as_array().unwrap().len();
    assert_eq!(counted("objects"), layout.rooms.len() + layout.openings.len());
    let graph: Value = serde_json::from_slice(&w.read("office.graph.json")).unwrap();
    assert_eq!(counted("edges"), graph["edges"].as_array().unwrap().len());
    let is_room = |o: &&Value| o["kind"] == "room";
    assert_eq!(drawn["objects"].as_array().unwrap().iter().filter(is_room).count(), layout.rooms.len());
}

/// The rings of path data that has only M, L and Z.
fn rings(data: &str) -> Vec<Vec<Point>> {
    let point = |text: &str| {
        let (x, y) = text.split_once(' ').unwrap();
        Point::new(x.parse().unwrap(), y.parse().unwrap())
    };
    let ring = |text: &str| text.trim_start_matches('M').split('L').map(point).collect();
    data.split_terminator('Z').map(ring).collect()
}

/// Pixels per metre of a rendered drawing.
const PIXELS: f64 = 20.0;

fn rendered(drawing: &str, width: f64) -> Pixmap {
    let tree = usvg::Tree::from_str(drawing, &usvg::Options::default()).unwrap();
    let scale = (width * PIXELS) as f32 / tree.size().width();
    let side = |length: f32| (length * scale).ceil() as u32;
    let mut pixmap = Pixmap::new(side(tree.size().width()), side(tree.size().height())).unwrap();
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    pixmap
}

#[test]
fn resvg_draws_the_svg() {
    let (w, layout) = office();
    w.does("convert office.yaml -o office.svg --set labels=false");
    let drawing = text(&w.read("office.svg"));
    let xml = roxmltree::Document::parse(&drawing).unwrap();
    let is_room = |n: &roxmltree::Node| n.attribute("class").is_some_and(|c| c.starts_with("room "));
    let paths: Vec<_> = xml.descendants().filter(is_room).map(|n| n.attribute("d").unwrap()).collect();
    // y runs down: exteriors are clockwise.
    let area = |data: &&str| rings(data).iter().map(|r| -ring_signed_area(r)).sum();
    same_areas(&paths.iter().map(area).collect::<Vec<_>>(), &layout, INNER);

    let numbers = |name| -> Vec<f64> {
        let value = xml.root_element().attribute(name).unwrap();
        value.split(' ').map(|n| n.parse().unwrap()).collect()
    };
    let (view, origin) = (numbers("viewBox"), numbers("data-origin"));
    let pixmap = rendered(&drawing, view[2]);
    let colour = |p: Point| {
        let (x, y) = ((p.x - origin[0]) * PIXELS, (origin[1] - p.y) * PIXELS);
        let c = pixmap.pixel(x as u32, y as u32).unwrap();
        [c.red(), c.green(), c.blue()]
    };
    let dark = layout.walls.iter().filter(|w| w.weight > 0.95 && w.thickness > 0.15);
    let dark: Vec<_> = dark.map(|w| colour(w.line.midpoint())).collect();
    assert!(dark.iter().filter(|c| c.iter().all(|&v| v < 0x80)).count() * 10 >= dark.len() * 8, "{dark:?}");
    let in_room = layout.rooms.iter().map(|r| (r.id, spot(r)));
    for (id, c) in in_room.filter_map(|(id, p)| Some((id, colour(p?)))) {
        assert!(c != [255; 3] && c.iter().all(|&v| v > 0xa0), "room {id} is {c:?}");
    }
}

/// A point of the room with a metre of floor around it, if there is one.
fn spot(room: &Room) -> Option<Point> {
    let around = |p: Point| {
        (0..16).all(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 16.0).sin_cos();
            [0.3, 0.6, 1.0].iter().all(|r| room.inner.contains(Point::new(p.x + r * cos, p.y + r * sin)))
        })
    };
    let ring = &room.inner.exterior;
    let pairs = ring.iter().flat_map(|&a| ring.iter().map(move |&b| a.midpoint(b)));
    pairs.into_iter().find(|&p| room.inner.contains(p) && around(p))
}
