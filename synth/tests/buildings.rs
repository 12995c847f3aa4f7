//! The promises that the truth of every building keeps.

use geo::{BooleanOps, BoundingRect, Intersects, Validation};
use planform_sdk::{Cell, Layout, Opening, OpeningKind, Point, Polygon, RoomId, Wall};
use planform_synth::{Building, BuildingParams, Size};
use std::collections::BTreeSet;

const SIZES: [Size; 3] = [Size::House, Size::Office, Size::School];

fn buildings(seeds: std::ops::Range<u64>) -> impl Iterator<Item = Building> {
    seeds.flat_map(|seed| SIZES.map(|size| Building::generate(seed, &BuildingParams::of_size(size))))
}

fn to_geo(p: &Polygon) -> geo::Polygon<f64> {
    let ring = |r: &[Point]| geo::LineString::from_iter(r.iter().map(|p| (p.x, p.y)));
    geo::Polygon::new(ring(&p.exterior), p.holes.iter().map(|h| ring(h)).collect())
}

fn overlap(a: &geo::Polygon<f64>, b: &geo::Polygon<f64>) -> f64 {
    use geo::Area;
    let apart = |a: &geo::Polygon<f64>, b: &geo::Polygon<f64>| {
        a.bounding_rect().zip(b.bounding_rect()).is_none_or(|(a, b)| !a.intersects(&b))
    };
    if apart(a, b) { 0.0 } else { a.intersection(b).unsigned_area() }
}

#[test]
fn rooms_are_valid_and_disjoint() {
    for building in buildings(0..12) {
        let rooms = &building.layout().rooms;
        let centres: Vec<_> = rooms.iter().map(|r| to_geo(&r.centre)).collect();
        for (i, room) in rooms.iter().enumerate() {
            assert!(to_geo(&room.inner).is_valid() && centres[i].is_valid(), "room {}", room.id);
            let within = overlap(&to_geo(&room.inner), &centres[i]);
            assert!((within - room.area()).abs() < 1e-5, "room {} leaves its walls", room.id);
            for other in &centres[i + 1..] {
                assert!(overlap(&centres[i], other) < 1e-5, "room {} overlaps another", room.id);
            }
        }
    }
}

fn reached(layout: &Layout) -> BTreeSet<RoomId> {
    let mut reached = BTreeSet::from([1]);
    loop {
        let before = reached.len();
        for [a, b] in layout.openings.iter().map(|o| o.rooms) {
            if reached.contains(&a) || reached.contains(&b) {
                reached.extend([a, b]);
            }
        }
        if reached.len() == before {
            return reached;
        }
    }
}

#[test]
fn every_room_can_be_reached() {
    for building in buildings(0..40) {
        assert_eq!(reached(building.layout()).len(), building.layout().rooms.len());
    }
}

fn lies_on(o: &Opening, w: &Wall) -> bool {
    let length = w.line.length();
    [o.segment.a, o.segment.b].iter().all(|p| {
        let (x, y) = (p.x - w.line.a.x, p.y - w.line.a.y);
        let (ux, uy) = ((w.line.b.x - w.line.a.x) / length, (w.line.b.y - w.line.a.y) / length);
        (x * uy - y * ux).abs() < 1e-4 && (0.0..=length).contains(&(x * ux + y * uy))
    })
}

#[test]
fn openings_are_of_real_widths_and_lie_on_their_wall() {
    for building in buildings(0..40) {
        let layout = building.layout();
        for opening in &layout.openings {
            let width = opening.width() + 1e-9;
            let real = match opening.kind {
                OpeningKind::Door => (0.8..1.21).contains(&width) || (1.6..2.01).contains(&width),
                OpeningKind::Passage => (2.2..4.01).contains(&width),
            };
            assert!(real, "{width}");
            assert!(opening.rooms[0] < opening.rooms[1]);
            let joins = |w: &&Wall| w.rooms == opening.rooms.map(Some);
            assert_eq!(layout.walls.iter().filter(joins).filter(|w| lies_on(opening, w)).count(), 1);
        }
    }
}

#[test]
fn clean_grid_shows_the_floor_free_and_the_walls_occupied() {
    for building in buildings(0..3) {
        let grid = building.clean_grid(0.05).unwrap();
        let at = |p: Point| {
            let p = grid.to_cells(p);
            grid.cell(p.x.floor() as i64, p.y.floor() as i64)
        };
        let middle = |column: i64, row: i64| grid.to_map(Point::new(column as f64 + 0.5, row as f64 + 0.5));
        for row in 0..i64::from(grid.height()) {
            for column in (row % 7..i64::from(grid.width())).step_by(7) {
                let p = middle(column, row);
                let floor = building.layout().rooms.iter().any(|r| r.inner.contains(p));
                assert!(!floor || grid.cell(column, row) == Cell::FREE, "{p:?}");
            }
        }
        for wall in &building.layout().walls {
            let p = wall.line.midpoint();
            let open =
                building.openings().any(|(o, _)| o.segment.midpoint().distance(p) < o.width() / 2.0 + 0.1);
            assert!(open || at(p) == Cell::OCCUPIED, "{wall:?}");
        }
        assert!(building.openings().all(|(o, _)| at(o.segment.midpoint()) == Cell::FREE));
    }
}

#[test]
fn sizes_and_walls_are_as_promised() {
    for (size, rooms) in [(Size::House, 5..=8), (Size::Office, 10..=20), (Size::School, 20..=60)] {
        for seed in 0..30 {
            let building = Building::generate(seed, &BuildingParams::of_size(size));
            let layout = building.layout();
            assert!(rooms.contains(&layout.rooms.len()));
            for wall in &layout.walls {
                let outer = wall.rooms.contains(&None);
                let range = if outer { 0.2..0.45 } else { 0.1..0.45 };
                assert!(range.contains(&wall.thickness), "{wall:?}");
                assert_eq!(wall.weight, 1.0);
            }
        }
    }
}

#[test]
fn some_rooms_are_reached_only_through_another() {
    let en_suite = (0..20).any(|seed| {
        let building = Building::generate(seed, &BuildingParams::of_size(Size::School));
        let corridor = |id| building.kind(id) == Some(planform_synth::RoomKind::Corridor);
        building.layout().rooms.iter().any(|room| {
            let mut ways = building.layout().openings.iter().filter(|o| o.rooms.contains(&room.id));
            !corridor(room.id) && ways.all(|o| !o.rooms.iter().any(|&id| corridor(id)))
        })
    });
    assert!(en_suite);
}

#[test]
fn the_seed_decides() {
    let make = |seed| Building::generate(seed, &BuildingParams::default());
    assert_eq!(make(4), make(4));
    assert_ne!(make(4), make(5));
}

#[test]
fn the_yaw_can_be_fixed() {
    let params =
        BuildingParams { yaw: Some(0.0), chamfers: 0.0, bays: 0.0, wings: 0.0, ..Default::default() };
    let building = Building::generate(2, &params);
    let straight = |w: &Wall| (w.line.a.x - w.line.b.x).abs().min((w.line.a.y - w.line.b.y).abs()) < 1e-9;
    assert!(building.layout().walls.iter().all(straight));
}

#[test]
fn the_yaw_turns_the_same_building() {
    let areas = |yaw| {
        let params = BuildingParams { yaw: Some(yaw), ..BuildingParams::default() };
        let building = Building::generate(2, &params);
        building.layout().rooms.iter().map(|r| r.inner.area()).collect::<Vec<_>>()
    };
    let straight = areas(0.0);
    for degrees in [7.5f64, 45.0, 90.0] {
        let turned = areas(degrees.to_radians());
        assert_eq!(turned.len(), straight.len());
        assert!(turned.iter().zip(&straight).all(|(a, b)| (a - b).abs() < 1e-3), "{turned:?} {straight:?}");
    }
}

#[test]
fn schools_are_as_long_as_promised() {
    let params = BuildingParams { yaw: Some(0.0), ..BuildingParams::of_size(Size::School) };
    for seed in 0..30 {
        let building = Building::generate(seed, &params);
        let centres = building.layout().rooms.iter().flat_map(|r| &r.centre.exterior);
        let (lo, hi) = centres.fold((Point::new(1e9, 1e9), Point::new(-1e9, -1e9)), |(lo, hi), p| {
            (Point::new(lo.x.min(p.x), lo.y.min(p.y)), Point::new(hi.x.max(p.x), hi.y.max(p.y)))
        });
        let length = (hi.x - lo.x).max(hi.y - lo.y);
        assert!((40.0..90.01).contains(&length), "seed {seed}: {length}");
    }
}
