//! Drawings, read back as XML and rendered.

#![allow(clippy::unwrap_used)]

use planform_sdk::{
    Cell, Document, ErrorKind, Grid, Layout, Options, PluginError, Point, Pose, Provenance, Scene,
    ring_signed_area,
};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{self, roxmltree};
use std::collections::BTreeSet;

fn flat() -> Layout {
    serde_json::from_str(include_str!("flat.json")).unwrap()
}

fn write(layout: &Layout, scene: Option<&Scene>, options: &[(&str, &str)]) -> Result<String, PluginError> {
    let exporter = planform_svg::exporter();
    let options = Options::parse(&exporter.info().options, options.iter().copied())?;
    let mut bytes = Vec::new();
    exporter.write(&Document { layout, scene }, &options, &mut bytes)?;
    Ok(String::from_utf8(bytes).unwrap())
}

fn drawn(options: &[(&str, &str)]) -> String {
    write(&flat(), None, options).unwrap()
}

/// A grid of 0.5 m cells around the flat, turned by `yaw` (radians), one cell unknown.
fn scene(yaw: f64) -> Scene {
    let mut cells = vec![Cell::FREE; 28 * 22];
    cells[0] = Cell::UNKNOWN;
    cells[30] = Cell::OCCUPIED;
    let grid = Grid::new(28, 22, 0.5, Pose { x: -4.0, y: 2.0, yaw }, cells).unwrap();
    Scene::of_grid(grid, Provenance::default())
}

fn layers(xml: &roxmltree::Document<'_>) -> Vec<String> {
    let groups = xml.root_element().children().filter(|n| n.has_tag_name("g"));
    groups.filter_map(|g| g.attribute("id").map(Into::into)).collect()
}

fn rooms<'a>(xml: &'a roxmltree::Document<'a>) -> Vec<roxmltree::Node<'a, 'a>> {
    xml.descendants().filter(|n| n.attribute("class").is_some_and(|c| c.starts_with("room "))).collect()
}

/// The rings of path data that has only M, L and Z.
fn rings(data: &str) -> Vec<Vec<Point>> {
    let ring = |text: &str| text.trim_start_matches('M').split('L').map(point).collect();
    data.split_terminator('Z').map(ring).collect()
}

fn point(text: &str) -> Point {
    let (x, y) = text.split_once(' ').unwrap();
    Point::new(x.parse().unwrap(), y.parse().unwrap())
}

/// Pixels per metre of a rendered drawing.
const PIXELS: f32 = 20.0;

fn render(text: &str) -> Pixmap {
    let tree = usvg::Tree::from_str(text, &usvg::Options::default()).unwrap();
    let xml = roxmltree::Document::parse(text).unwrap();
    let view: Vec<f32> = view(&xml).iter().map(|&v| v as f32).collect();
    let mut pixmap = Pixmap::new((view[2] * PIXELS) as u32, (view[3] * PIXELS) as u32).unwrap();
    let scale = view[2] * PIXELS / tree.size().width();
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    pixmap
}

fn view(xml: &roxmltree::Document<'_>) -> Vec<f64> {
    let text = xml.root_element().attribute("viewBox").unwrap();
    text.split(' ').map(|n| n.parse().unwrap()).collect()
}

fn origin(xml: &roxmltree::Document<'_>) -> Point {
    point(xml.root_element().attribute("data-origin").unwrap())
}

/// The colour at a point of the flat, counted from its lower left corner.
fn colour(text: &str, pixmap: &Pixmap, x: f64, y: f64) -> String {
    let origin = origin(&roxmltree::Document::parse(text).unwrap());
    let p = Point::new(x - 3.5 - origin.x, origin.y - (y + 2.25));
    let c = pixmap.pixel((p.x as f32 * PIXELS) as u32, (p.y as f32 * PIXELS) as u32).unwrap();
    format!("#{:02x}{:02x}{:02x}", c.red(), c.green(), c.blue())
}

#[test]
fn every_room_is_there_with_its_area() {
    for boundary in ["inner", "centre"] {
        let (layout, text) = (flat(), drawn(&[("boundary", boundary)]));
        let xml = roxmltree::Document::parse(&text).unwrap();
        let rooms = rooms(&xml);
        assert_eq!(rooms.len(), layout.rooms.len());
        for (room, node) in layout.rooms.iter().zip(rooms) {
            assert_eq!(node.attribute("id").unwrap(), format!("room-{}", room.id));
            assert_eq!(node.attribute("data-name").unwrap(), room.name.as_deref().unwrap_or_default());
            let rings = rings(node.attribute("d").unwrap());
            // Mirrored, exteriors are clockwise and holes are not.
            let area: f64 = rings.iter().map(|r| -ring_signed_area(r)).sum();
            let outline = if boundary == "inner" { &room.inner } else { &room.centre };
            assert!((area / outline.area() - 1.0).abs() < 1e-3, "{}: {area}", room.id);
        }
    }
}

#[test]
fn ids_are_unique() {
    let text = write(&flat(), Some(&scene(0.0)), &[("grid", "true")]).unwrap();
    let xml = roxmltree::Document::parse(&text).unwrap();
    let ids: Vec<&str> = xml.descendants().filter_map(|n| n.attribute("id")).collect();
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    let layout = flat();
    let things = layout.rooms.len() * 2
        + layout.walls.len()
        + layout.openings.len()
        + layout.frontiers.len()
        + layout.texts.len()
        + layout.symbols.len();
    // The fire extinguisher's drawing has one as well.
    assert_eq!(ids.len(), things + layers(&xml).len() + 1);
}

#[test]
fn layers_are_inkscapes() {
    let text = write(&flat(), Some(&scene(0.0)), &[("grid", "true")]).unwrap();
    let xml = roxmltree::Document::parse(&text).unwrap();
    let expected = [
        "paper",
        "grid",
        "rooms",
        "walls",
        "windows",
        "doors",
        "frontiers",
        "symbols",
        "texts",
        "labels",
        "scale",
    ];
    assert_eq!(layers(&xml), expected);
    let inkscape = "http://www.inkscape.org/namespaces/inkscape";
    for layer in xml.root_element().children().filter(|n| n.has_tag_name("g")) {
        assert_eq!(layer.attribute((inkscape, "groupmode")), Some("layer"));
        assert_eq!(layer.attribute((inkscape, "label")), layer.attribute("id"));
    }
    let text = drawn(&[("labels", "false")]);
    assert!(!layers(&roxmltree::Document::parse(&text).unwrap()).contains(&"labels".into()));
}

#[test]
fn paper_size_is_to_scale() {
    for (scale, millimetres) in [("100", 10.0), ("50", 20.0)] {
        let text = drawn(&[("scale", scale)]);
        let xml = roxmltree::Document::parse(&text).unwrap();
        let width = xml.root_element().attribute("width").unwrap().strip_suffix("mm").unwrap();
        assert_eq!(width.parse::<f64>().unwrap(), view(&xml)[2] * millimetres);
    }
}

#[test]
fn map_coordinates_come_back() {
    let text = drawn(&[]);
    let xml = roxmltree::Document::parse(&text).unwrap();
    let origin = origin(&xml);
    let corner = rings(rooms(&xml)[0].attribute("d").unwrap())[0][0];
    let back = Point::new(origin.x + corner.x, origin.y - corner.y);
    assert!(back.distance(flat().rooms[0].inner.exterior[0]) < 1e-4, "{back:?}");
}

#[test]
fn rendering_shows_rooms_walls_and_doors() {
    let text = drawn(&[]);
    let pixmap = render(&text);
    let at = |x, y| colour(&text, &pixmap, x, y);
    let soft = |c: &str| c != "#ffffff" && c[1..3] > *"c0" && c[3..5] > *"c0" && c[5..] > *"c0";
    for (x, y) in [(0.5, 0.5), (4.5, 0.5), (8.5, 0.5), (0.5, 4.0), (0.5, 9.5), (6.7, 9.5)] {
        assert!(soft(&at(x, y)), "room at {x}, {y}: {}", at(x, y));
    }
    assert_ne!(at(0.5, 0.5), at(0.5, 4.0), "neighbours differ");
    assert_eq!(at(3.0, 7.5), "#ffffff", "a hole is empty");
    assert_eq!(at(9.5, 8.0), "#ffffff", "the yard is outside");
    assert_eq!(at(0.7, 3.03), "#222222", "a wall");
    assert_eq!(at(6.0, 6.0), "#222222", "a wall in full length");
    assert_eq!(at(1.9, 3.06), "#ffffff", "a door cuts its wall");
    assert_eq!(at(8.0, 1.5), "#adadad", "a weak wall");
    assert_eq!(at(-0.06, -0.06), "#222222", "an outer corner is closed");
}

#[test]
fn empty_layout_is_a_drawing() {
    let text = write(&Layout::default(), None, &[]).unwrap();
    assert!(rooms(&roxmltree::Document::parse(&text).unwrap()).is_empty());
    assert!(render(&text).width() > 0);
}

#[test]
fn hostile_names_do_no_harm() {
    let mut layout = flat();
    let name = "</path>\"'&amp;\u{0}\u{1b}]]><script>\u{ffff}";
    layout.rooms[0].name = Some(name.into());
    layout.texts[0].content = name.into();
    layout.symbols[0].kind = name.into();
    layout.provenance.source = name.into();
    layout.method = name.into();
    let text = write(&layout, None, &[]).unwrap();
    let xml = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(rooms(&xml)[0].attribute("data-name").unwrap(), "</path>\"'&amp;]]><script>");
    assert!(!xml.descendants().any(|n| n.has_tag_name("script")));
}

#[test]
fn labels_lie_inside_their_rooms() {
    let text = drawn(&[]);
    let xml = roxmltree::Document::parse(&text).unwrap();
    let origin = origin(&xml);
    let labels: Vec<_> = xml.descendants().filter(|n| n.attribute("class") == Some("name")).collect();
    assert_eq!(labels.len(), flat().rooms.len());
    for (room, label) in flat().rooms.iter().zip(labels) {
        let value = |name| label.attribute(name).unwrap().parse::<f64>().unwrap();
        let p = Point::new(origin.x + value("x"), origin.y - value("y"));
        assert!(room.inner.contains(p), "room {}", room.id);
        assert!(value("font-size") > 0.15, "room {}", room.id);
    }
}

#[test]
fn grid_needs_a_scene() {
    let e = write(&flat(), None, &[("grid", "true")]).unwrap_err();
    assert_eq!(e.kind, ErrorKind::BadOption);
}

#[test]
fn turned_grid_is_a_turned_picture_on_the_sheet() {
    let scene = scene(0.5);
    let text = write(&flat(), Some(&scene), &[("grid", "true")]).unwrap();
    let xml = roxmltree::Document::parse(&text).unwrap();
    let image = xml.descendants().find(|n| n.has_tag_name("image")).unwrap();
    assert!(
        image
            .attribute(("http://www.w3.org/1999/xlink", "href"))
            .unwrap()
            .starts_with("data:image/png;base64,")
    );
    let (origin, view) = (origin(&xml), view(&xml));
    for (column, row) in [(0.0, 0.0), (28.0, 0.0), (28.0, 22.0), (0.0, 22.0)] {
        let p = scene.grid.to_map(Point::new(column, row));
        let (x, y) = (p.x - origin.x, origin.y - p.y);
        assert!(x >= 0.0 && y >= 0.0 && x <= view[2] && y <= view[3], "({x}, {y})");
    }
}

#[test]
fn not_finite_is_refused() {
    let mut layout = flat();
    layout.texts[0].pose.yaw = f64::NAN;
    assert_eq!(write(&layout, None, &[]).unwrap_err().kind, ErrorKind::BadInput);
}

#[test]
fn same_layout_same_bytes() {
    assert_eq!(drawn(&[]), drawn(&[]));
}
