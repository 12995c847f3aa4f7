use super::*;
use ::dxf::entities::{self, EntityType};
use ::dxf::tables::Layer as DxfLayer;
use ::dxf::{Block, Drawing as DxfDrawing, LwPolylineVertex, Point as DxfPoint, enums};
use planform_sdk::{Document, Layout, Options, Segment, Text, Wall};

/// A rectangle of 12 m by 8 m on this layer, in units of `1 / per_metre` metres, with its corner at (100, 50) m.
fn house(layer: &str, per_metre: f64) -> String {
    let corners =
        [[100.0, 50.0], [112.0, 50.0], [112.0, 58.0], [100.0, 58.0]].map(|p| p.map(|v| v * per_metre));
    (0..4).map(|i| line(layer, corners[i], corners[(i + 1) % 4])).collect()
}

fn line(layer: &str, a: Point, b: Point) -> String {
    format!("0\nLINE\n8\n{layer}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", a[0], a[1], b[0], b[1])
}

fn document(header: &str, tables: &str, blocks: &str, entities: &str) -> Vec<u8> {
    let section = |name: &str, body: &str| format!("0\nSECTION\n2\n{name}\n{body}0\nENDSEC\n");
    let sections = [("HEADER", header), ("TABLES", tables), ("BLOCKS", blocks), ("ENTITIES", entities)];
    (sections.map(|(name, body)| section(name, body)).concat() + "0\nEOF\n").into_bytes()
}

const METRES: &str = "9\n$INSUNITS\n70\n6\n";

fn read(bytes: &[u8]) -> Page {
    page(bytes, &PageRequest::default()).unwrap()
}

fn complaint(bytes: &[u8], layers: Option<&[&str]>) -> String {
    let layers = layers.map(|l| l.iter().map(|s| s.to_string()).collect());
    page(bytes, &PageRequest { layers, ..PageRequest::default() }).unwrap_err().to_string()
}

/// Whether there is ink at a place in metres.
fn ink(page: &Page, x: f64, y: f64) -> bool {
    let scale = page.metres_per_pixel.unwrap();
    let column = ((x - page.origin[0]) / scale) as i64;
    let row = f64::from(page.picture.height()) - (y - page.origin[1]) / scale;
    (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column + dx, row as i64 + dy))).any(|(x, y)| {
        x >= 0 && y >= 0 && page.picture.get_pixel_checked(x as u32, y as u32).is_some_and(|p| p[0] < 128)
    })
}

#[test]
fn a_house_is_where_it_says_and_as_large() {
    for (header, per_metre) in
        [(METRES, 1.0), ("9\n$INSUNITS\n70\n4\n", 1000.0), ("", 1000.0), ("", 1.0), ("", 100.0)]
    {
        let page = read(&document(header, "", "", &house("A-WALL", per_metre)));
        assert!(ink(&page, 106.0, 50.0) && ink(&page, 100.0, 54.0) && ink(&page, 112.0, 58.0), "{per_metre}");
        assert!(!ink(&page, 106.0, 54.0) && !ink(&page, 99.0, 54.0));
        assert!((page.metres_per_pixel.unwrap() - 0.01).abs() < 1e-9);
        assert_eq!(page.picture.dimensions(), (1240, 840));
        assert!(page.walls_only);
        assert_eq!(page.warnings.is_empty(), !header.is_empty(), "{:?}", page.warnings);
    }
}

#[test]
fn a_unit_that_makes_no_building_is_not_believed() {
    let page = read(&document("9\n$INSUNITS\n70\n1\n", "", "", &house("A-WALL", 1000.0)));
    assert!((page.metres_per_pixel.unwrap() - 0.01).abs() < 0.001 || page.warnings.is_empty());
    let page = read(&document("9\n$INSUNITS\n70\n6\n", "", "", &house("A-WALL", 1000.0)));
    assert!(
        page.warnings[0].starts_with("by the unit that the DXF states its plan would be 12000.00 m long")
    );
    assert!((page.metres_per_pixel.unwrap() - 0.01).abs() < 1e-9);
}

#[test]
fn layers_tell_the_walls() {
    let desk = line("A-FURN", [105.0, 52.0], [107.0, 52.0]);
    let page = read(&document(METRES, "", "", &(house("A-WALL", 1.0) + &desk)));
    assert!(page.walls_only && !ink(&page, 106.0, 52.0));
    let plain = house("0", 1.0) + &desk + &line("X", [105.0, 55.0], [107.0, 55.0]);
    let page = read(&document(METRES, "", "", &plain));
    assert!(!page.walls_only && !ink(&page, 106.0, 52.0) && ink(&page, 106.0, 55.0));
    let layers = Some(vec!["x".to_owned(), "0".to_owned()]);
    let page = super::page(&document(METRES, "", "", &plain), &PageRequest { layers, ..Default::default() })
        .unwrap();
    assert!(page.walls_only && ink(&page, 106.0, 55.0));
    let message = complaint(&document(METRES, "", "", &plain), Some(&["WALLS"]));
    assert_eq!(message, "no visible line of the DXF lies on the layer `WALLS`; lines lie on 0, A-FURN, X");
}

#[test]
fn frozen_and_hidden_things_are_left_out() {
    let layers =
        "0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nOld\n70\n1\n62\n7\n0\nLAYER\n2\nOff\n70\n0\n62\n-7\n0\nENDTAB\n";
    let mut lines = house("0", 1.0)
        + &line("OLD", [101.0, 51.0], [103.0, 51.0])
        + &line("off", [101.0, 53.0], [103.0, 53.0]);
    lines += &line("0", [101.0, 55.0], [103.0, 55.0]).replace("LINE\n", "LINE\n67\n1\n");
    let page = read(&document(METRES, layers, "", &lines));
    assert!(ink(&page, 106.0, 50.0));
    assert!(![51.0, 53.0, 55.0].into_iter().any(|y| ink(&page, 102.0, y)));
}

fn block(name: &str, entities: &str) -> String {
    format!("0\nBLOCK\n8\n0\n2\n{name}\n70\n0\n10\n0\n20\n0\n{entities}0\nENDBLK\n")
}

fn insert(name: &str, layer: &str, at: Point, rest: &str) -> String {
    format!("0\nINSERT\n8\n{layer}\n2\n{name}\n10\n{}\n20\n{}\n{rest}", at[0], at[1])
}

#[test]
fn blocks_are_placed_and_symbols_kept() {
    let door = "0\nARC\n8\n0\n10\n0\n20\n0\n40\n0.9\n50\n0\n51\n90\n".to_owned()
        + &line("0", [0.0, 0.0], [0.0, 0.9]);
    let blocks = block("Door90", &door) + &block("WALLPIECE", &line("0", [0.0, 0.0], [2.0, 0.0]));
    let entities = house("A-WALL", 1.0)
        + &insert("DOOR90", "A-DOOR", [103.0, 50.0], "")
        + &insert("WallPiece", "A-WALL", [105.0, 54.0], "50\n90\n41\n1.5\n");
    let page = read(&document(METRES, "", &blocks, &entities));
    assert!(ink(&page, 105.0, 56.9) && !ink(&page, 105.0, 57.2) && !ink(&page, 103.0, 50.5));
    let [door] = &page.symbols[..] else { panic!("{:?}", page.symbols) };
    assert_eq!((door.kind.as_str(), door.leaves.len()), ("door", 1));
    assert!((door.width - 90.0).abs() < 0.1);
    let to_metres = |[x, y]: Point| {
        [page.origin[0] + x * 0.01, page.origin[1] + (f64::from(page.picture.height()) - y) * 0.01]
    };
    let [x, y] = to_metres(door.centre);
    assert!((x - 103.45).abs() < 0.01 && (y - 50.0).abs() < 0.01, "{x} {y}");
    let [x, y] = to_metres(door.leaves[0].open);
    assert!((x - 103.0).abs() < 0.01 && (y - 50.9).abs() < 0.01, "{x} {y}");
}

#[test]
fn words_are_texts_in_pixels() {
    let text = "0\nTEXT\n8\nT\n10\n104\n20\n53\n40\n0.3\n50\n90\n1\nB\\U+00FCro %%c\n\
                0\nMTEXT\n8\nT\n10\n106\n20\n54\n40\n0.2\n71\n5\n1\n{\\fArial;Room}\\P12\n";
    let page = read(&document(METRES, "", "", &(house("A-WALL", 1.0) + text)));
    let contents: Vec<_> = page.texts.iter().map(|t| t.content.as_str()).collect();
    assert_eq!(contents, ["Büro ø", "Room", "12"]);
    assert!((page.texts[0].angle + std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    assert!((page.texts[0].height - 30.0).abs() < 1e-6 && !page.drawn);
    assert!((page.texts[1].centre[0] - 620.0).abs() < 1.0, "{:?}", page.texts[1]);
}

#[test]
fn one_stray_line_does_not_shrink_the_house() {
    let stray = line("A-WALL", [90_000.0, 90_000.0], [90_010.0, 90_000.0]);
    let walls: String = (0..5).map(|_| house("A-WALL", 1.0)).collect();
    let page = read(&document(METRES, "", "", &(walls + &stray)));
    assert_eq!(page.picture.dimensions(), (1240, 840));
}

#[test]
fn recursion_and_repetition_are_bounded() {
    let own = block("SELF", &insert("SELF", "0", [1.0, 0.0], ""));
    let page =
        read(&document(METRES, "", &own, &(house("A-WALL", 1.0) + &insert("SELF", "0", [0.0; 2], ""))));
    assert!(page.walls_only);
    let array = "70\n1000\n71\n1000\n44\n1\n45\n1\n";
    let nested = block("A", &line("0", [0.0; 2], [1.0; 2])) + &block("B", &insert("A", "0", [0.0; 2], array));
    let bomb = document(METRES, "", &nested, &insert("B", "0", [0.0; 2], array));
    assert!(complaint(&bomb, None).starts_with("the DXF has more than 4000000 points"));
}

#[test]
fn unusable_documents_have_their_sentences() {
    let none = document(METRES, "", "", "0\nTEXT\n8\n0\n10\n1\n20\n1\n40\n1\n1\na\n");
    assert!(
        complaint(&none, None).starts_with("the DXF has no lines in model space that walls could be made of")
    );
    assert!(complaint(&none, Some(&["A"])).starts_with("the DXF has no lines"));
    let binary = b"AutoCAD Binary DXF\r\n\x1a\0\0\0";
    assert_eq!(
        complaint(binary, None),
        "it is a binary DXF, which is not read; save it as DXF in text form (ASCII)"
    );
    assert!(complaint(b"0\nSECTION\nx\ny\n", None).starts_with("line 3: the DXF is damaged"));
}

/// What another writer makes, in all versions that it knows.
#[test]
fn other_writers_are_read() {
    use enums::AcadVersion as Version;
    for version in
        [Version::R12, Version::R14, Version::R2000, Version::R2007, Version::R2010, Version::R2018]
    {
        let mut drawing = DxfDrawing::new();
        drawing.header.version = version;
        drawing.header.default_drawing_units = enums::Units::Meters;
        drawing.add_layer(DxfLayer { name: "Wände".into(), ..Default::default() });
        let corners = [[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [0.0, 10.0]];
        let vertices: Vec<_> = corners.map(|[x, y]| LwPolylineVertex { x, y, ..Default::default() }).to_vec();
        let mut walls: Vec<EntityType> = (0..4)
            .map(|i| {
                let at = |[x, y]: Point| DxfPoint::new(x, y, 0.0);
                EntityType::Line(entities::Line::new(at(corners[i]), at(corners[(i + 1) % 4])))
            })
            .collect();
        if version > Version::R12 {
            let mut ring = entities::LwPolyline { vertices, ..Default::default() };
            ring.set_is_closed(true);
            walls.push(EntityType::LwPolyline(ring));
        }
        for wall in walls {
            let mut entity = entities::Entity::new(wall);
            entity.common.layer = "Wände".into();
            drawing.add_entity(entity);
        }
        drawing.add_block(Block { name: "WC".into(), ..Default::default() });
        let mut bytes = vec![];
        drawing.save(&mut bytes).unwrap();
        let page = read(&bytes);
        assert!(page.walls_only && ink(&page, 10.0, 0.0) && ink(&page, 20.0, 5.0), "{version:?}");
        assert_eq!(page.picture.dimensions(), (2040, 1040));
    }
}

#[test]
fn the_exporters_drawings_come_back() {
    let corners = [[2.0, 3.0], [22.0, 3.0], [22.0, 13.0], [2.0, 13.0]].map(planform_sdk::Point::from);
    let wall = |i: usize| Wall {
        line: Segment::new(corners[i], corners[(i + 1) % 4]),
        thickness: 0.2,
        weight: 1.0,
        rooms: [None, None],
    };
    let pose = planform_sdk::Pose { x: 12.0, y: 8.0, yaw: 0.5 };
    let text = Text { content: "Büro 1".into(), pose, width: 2.0, height: 0.3, confidence: 1.0 };
    let layout = Layout { walls: (0..4).map(wall).collect(), texts: vec![text], ..Layout::default() };
    let exporter = planform_dxf::exporter();
    for version in ["R12", "R2000", "R2013", "R2018"] {
        let options = Options::parse(&exporter.info().options, [("version", version)]).unwrap();
        let mut bytes = vec![];
        exporter.write(&Document { layout: &layout, scene: None }, &options, &mut bytes).unwrap();
        let page = read(&bytes);
        assert!(page.walls_only && ink(&page, 12.0, 2.9) && ink(&page, 12.0, 3.1), "{version}");
        // The outline of a wall is filled, that of the building is not.
        assert!(ink(&page, 12.0, 3.0) && !ink(&page, 12.0, 8.0), "{version}");
        let [text] = &page.texts[..] else { panic!("{version} {:?}", page.texts) };
        assert_eq!(text.content, "Büro 1");
        let middle =
            [12.0 - page.origin[0], 8.0 - page.origin[1]].map(|v| v / page.metres_per_pixel.unwrap());
        assert!((text.centre[0] - middle[0]).abs() < 1.0, "{version} {text:?}");
        assert!((f64::from(page.picture.height()) - text.centre[1] - middle[1]).abs() < 1.0);
        assert!((text.angle + 0.5).abs() < 1e-6);
    }
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(64))]
    #[test]
    fn damage_never_panics(at in proptest::collection::vec((0..4000_usize, 0..=255_u8), 1..8), cut in 0..4000_usize) {
        let door = "0\nARC\n8\n0\n10\n0\n20\n0\n40\n0.9\n50\n0\n51\n90\n";
        let hatch = "0\nHATCH\n70\n1\n91\n1\n92\n2\n72\n0\n73\n1\n93\n3\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n3\n97\n0\n";
        let spline = "0\nSPLINE\n71\n1\n40\n0\n40\n0\n40\n1\n40\n1\n10\n0\n20\n0\n10\n1\n20\n1\n";
        let mtext = "0\nMTEXT\n10\n1\n20\n1\n40\n1\n1\n\\fa;b\\P%%179\n";
        let entities = house("0", 1.0) + hatch + spline + mtext + &insert("DOOR", "0", [101.0, 52.0], "70\n2\n44\n2\n");
        let mut bytes = document(METRES, "", &block("DOOR", door), &entities);
        let length = bytes.len();
        at.into_iter().for_each(|(i, b)| bytes[i % length] = b);
        bytes.truncate(cut.max(length / 2));
        if let Err(e) = page(&bytes, &PageRequest::default()) {
            proptest::prop_assert!(!e.message.contains("its reader cannot handle"), "{}", e);
        }
    }
}
