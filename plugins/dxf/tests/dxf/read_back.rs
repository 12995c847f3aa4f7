//! Reads what is written with the crate `dxf`, which knows nothing of this one.

use crate::support::{VERSIONS, flat, row, write};
use dxf::Drawing;
use dxf::entities::{Entity, EntityType};
use dxf::enums::{AcadVersion, Units};
use planform_sdk::{ErrorKind, Layout, Point, ring_signed_area};

fn read(layout: &Layout, version: &str) -> Drawing {
    Drawing::load(&mut write(layout, &[("version", version)]).unwrap().as_slice()).unwrap()
}

fn on<'a>(drawing: &'a Drawing, layer: &'a str) -> impl Iterator<Item = &'a Entity> {
    drawing.entities().filter(move |e| e.common.layer == layer)
}

fn area(entity: &Entity) -> f64 {
    let ring: Vec<Point> = match &entity.specific {
        EntityType::LwPolyline(p) if p.is_closed() => {
            p.vertices.iter().map(|v| Point::new(v.x, v.y)).collect()
        }
        EntityType::Polyline(p) if p.is_closed() => {
            p.vertices().map(|v| Point::new(v.location.x, v.location.y)).collect()
        }
        other => panic!("not a closed polyline: {other:?}"),
    };
    ring_signed_area(&ring)
}

#[test]
fn every_version_is_what_it_says() {
    let codes = [AcadVersion::R12, AcadVersion::R2000, AcadVersion::R2013, AcadVersion::R2018];
    for (version, code) in VERSIONS.into_iter().zip(codes) {
        let drawing = read(&flat(), version);
        assert_eq!(drawing.header.version, code);
        let units = if version == "R12" { Units::Unitless } else { Units::Meters };
        assert_eq!(drawing.header.default_drawing_units, units);
    }
    assert_eq!(write(&flat(), &[]).unwrap(), write(&flat(), &[("version", "R2000")]).unwrap());
}

#[test]
fn rooms_keep_their_net_area() {
    let layout = flat();
    let expected: f64 = layout.rooms.iter().map(planform_sdk::Room::area).sum();
    for version in VERSIONS {
        let drawing = read(&layout, version);
        assert_eq!(on(&drawing, "A-AREA").count(), 6);
        // Holes run clockwise, so their areas count below zero.
        let sum: f64 = on(&drawing, "A-AREA").map(area).sum();
        assert!((sum - expected).abs() < 1e-9, "{version}: {sum} {expected}");
    }
}

#[test]
fn walls_have_both_faces_and_no_openings() {
    for version in VERSIONS {
        let drawing = read(&flat(), version);
        assert_eq!(on(&drawing, "A-WALL-CNTR").count(), 14);
        assert_eq!(on(&drawing, "A-WALL").count(), 14 + 4);
        assert_eq!(on(&drawing, "A-DOOR").count(), 4);
        assert!(on(&drawing, "A-WALL").all(|e| area(e) > 0.0), "{version}");
    }
}

#[test]
fn names_come_back_whole() {
    for version in VERSIONS {
        let drawing = read(&flat(), version);
        let texts: Vec<_> = drawing
            .entities()
            .filter_map(|e| match &e.specific {
                EntityType::Text(t) => Some(t.value.as_str()),
                _ => None,
            })
            .collect();
        for text in ["厨房", "غرفة", "Bad", "Room 5", "Flat Nº 7 ≈ 90 m²"] {
            assert!(texts.contains(&text), "{version}: {text} in {texts:?}");
        }
    }
}

#[test]
fn the_same_layout_gives_the_same_bytes() {
    for version in VERSIONS {
        let once = write(&flat(), &[("version", version)]).unwrap();
        assert_eq!(once, write(&flat(), &[("version", version)]).unwrap());
    }
}

#[test]
fn old_versions_are_pure_ascii() {
    assert!(write(&flat(), &[("version", "R12")]).unwrap().is_ascii());
    assert!(write(&flat(), &[("version", "R2000")]).unwrap().is_ascii());
    assert!(!write(&flat(), &[("version", "R2018")]).unwrap().is_ascii());
}

#[test]
fn files_grow_with_the_rooms_and_no_faster() {
    let size = |rooms| write(&row(rooms, Point::default(), |_| None), &[]).unwrap().len();
    let (few, many) = (size(500), size(5000));
    assert!(many < 11 * few, "{few} {many}");
}

#[test]
fn a_number_that_is_none_is_an_error_and_no_file() {
    let mut layout = flat();
    layout.rooms[1].inner.exterior[2].x = f64::NAN;
    let error = write(&layout, &[]).unwrap_err();
    assert_eq!(error.kind, ErrorKind::BadInput);
    assert!(error.to_string().starts_with("room 2 has the number NaN"), "{error}");
}

#[test]
fn options_are_refused_by_name() {
    let error = write(&flat(), &[("version", "R14")]).unwrap_err();
    assert_eq!(error.kind, ErrorKind::BadOption);
}
