//! Irregular buildings: the truth still holds, and every kind of irregularity appears.

use geo::{BooleanOps, Validation};
use planform_sdk::{Cell, OpeningKind, Point, Polygon, Room, RoomId};
use planform_synth::{Building, BuildingParams, Outline, RoomKind, ScanParams, Size, Variety, shrunk};

fn varied(seed: u64) -> Building {
    Building::generate(seed, &BuildingParams::varied(seed))
}

/// An office whose only irregularity is this one.
fn only(seed: u64, variety: Variety) -> Building {
    Building::generate(seed, &BuildingParams { variety, ..BuildingParams::of_size(Size::Office) })
}

/// A school whose only irregularity is this one: it has larger rooms.
fn school(seed: u64, variety: Variety) -> Building {
    Building::generate(seed, &BuildingParams { variety, ..BuildingParams::of_size(Size::School) })
}

fn to_geo(p: &Polygon) -> geo::Polygon<f64> {
    let ring = |r: &[Point]| geo::LineString::from_iter(r.iter().map(|p| (p.x, p.y)));
    geo::Polygon::new(ring(&p.exterior), p.holes.iter().map(|h| ring(h)).collect())
}

#[test]
fn the_seed_decides() {
    assert_eq!(varied(3), varied(3));
    assert_ne!(varied(3), varied(4));
    let scan = |seed| varied(3).scan(&ScanParams { resolution: 0.1, ..ScanParams::varied(seed) }).unwrap();
    assert_eq!(scan(3), scan(3));
    assert_ne!(scan(3).grid, scan(4).grid);
}

#[test]
fn rooms_are_valid_disjoint_and_reached() {
    use geo::Area;
    for building in (0..25).map(varied) {
        let layout = building.layout();
        let centres: Vec<_> = layout.rooms.iter().map(|r| to_geo(&r.centre)).collect();
        for (i, room) in layout.rooms.iter().enumerate() {
            assert!(to_geo(&room.inner).is_valid() && centres[i].is_valid());
            for other in &centres[i + 1..] {
                assert!(centres[i].intersection(other).unsigned_area() < 1e-5);
            }
        }
        let mut reached = vec![1];
        for _ in 0..layout.rooms.len() {
            for [a, b] in layout.openings.iter().map(|o| o.rooms) {
                for (from, to) in [(a, b), (b, a)] {
                    if reached.contains(&from) && !reached.contains(&to) {
                        reached.push(to);
                    }
                }
            }
        }
        assert_eq!(reached.len(), layout.rooms.len());
        assert!(layout.openings.iter().all(|o| o.width() > 0.6), "{:?}", layout.openings);
    }
}

/// The sizes of the connected pieces of the cells, in cells.
fn pieces(width: usize, cells: &[bool]) -> Vec<usize> {
    let mut seen: Vec<bool> = cells.iter().map(|c| !c).collect();
    let mut sizes = Vec::new();
    for start in 0..cells.len() {
        let mut queue = vec![start];
        let mut size = 0;
        while let Some(i) = queue.pop() {
            if std::mem::replace(&mut seen[i], true) {
                continue;
            }
            size += 1;
            let beside = [i.wrapping_sub(1), i + 1, i.wrapping_sub(width), i + width];
            queue.extend(beside.into_iter().filter(|&j| j < cells.len() && !seen[j]));
        }
        sizes.push(size);
    }
    sizes.retain(|&s| s > 0);
    sizes.sort_unstable();
    sizes
}

#[test]
fn no_solid_divides_a_room() {
    for building in (0..8).map(varied) {
        let grid = building.clean_grid(0.05).unwrap();
        let labels = building.labels(0.05, Outline::Inner).unwrap();
        for room in &building.layout().rooms {
            let free = grid.cells().iter().zip(&labels.rooms);
            let free: Vec<bool> = free.map(|(&c, &r)| c == Cell::FREE && r == room.id).collect();
            let sizes = pieces(labels.width as usize, &free);
            let all: usize = sizes.iter().sum();
            let largest = sizes.last().copied().unwrap_or(0);
            // Behind the leaf of a door in a corner a little may be cut off.
            assert!(all - largest <= 1200, "room {}: {sizes:?}", room.id);
        }
    }
}

#[test]
fn the_robot_starts_beside_the_solids() {
    let shafts = Variety { shafts: 1.0, columns: 1.0, ..Variety::default() };
    for seed in 0..12 {
        let building = school(seed, shafts);
        let scan = building.scan(&ScanParams { resolution: 0.1, ..ScanParams::default() }).unwrap();
        let start = Point::new(scan.path[0].x, scan.path[0].y);
        assert!(building.solids().iter().all(|s| !s.contains(start)), "seed {seed}");
        assert!(scan.visited_share() > 0.9, "seed {seed}: {}", scan.visited_share());
    }
}

#[test]
fn solids_stand_in_rooms() {
    for building in (0..12).map(varied) {
        for solid in building.solids() {
            let middle = solid.exterior.iter().fold(Point::default(), |m, p| {
                Point::new(m.x + p.x / solid.exterior.len() as f64, m.y + p.y / solid.exterior.len() as f64)
            });
            assert!(building.layout().rooms.iter().any(|r| r.centre.contains(middle)));
        }
    }
}

#[test]
fn every_kind_of_solid_appears_alone() {
    let none = Variety::default();
    let kinds = [
        Variety { pilasters: 1.0, ..none },
        Variety { columns: 1.0, ..none },
        Variety { narrowings: 1.0, ..none },
        Variety { partitions: 1.0, ..none },
        Variety { shafts: 1.0, ..none },
        Variety { leaves: 1.0, ..none },
    ];
    for variety in kinds {
        let count: usize = (0..6).map(|seed| school(seed, variety).solids().len()).sum();
        assert!(count > 5, "{variety:?}: {count}");
        assert_eq!(school(1, variety).layout(), school(1, none).layout(), "solids leave the layout alone");
    }
    assert!((0..6).all(|seed| school(seed, none).solids().is_empty()));
}

fn of_kind(building: &Building, kind: RoomKind) -> impl Iterator<Item = &Room> {
    building.layout().rooms.iter().filter(move |r| building.kind(r.id) == Some(kind))
}

#[test]
fn blocks_lie_in_a_ring_of_corridor() {
    for seed in 0..6 {
        let building = only(seed, Variety { blocks: 1.0, ..Variety::default() });
        assert_eq!(of_kind(&building, RoomKind::Corridor).count(), 1);
        assert!(of_kind(&building, RoomKind::Corridor).all(|r| !r.inner.holes.is_empty()));
    }
}

#[test]
fn alcoves_give_corridors_more_corners() {
    let corners = |alcoves| -> usize {
        let buildings = (0..6).map(|seed| only(seed, Variety { alcoves, ..Variety::default() }));
        let count =
            |b: Building| of_kind(&b, RoomKind::Corridor).map(|r| r.inner.exterior.len()).sum::<usize>();
        buildings.map(count).sum()
    };
    assert!(corners(0.5) > corners(0.0) + 30, "{} {}", corners(0.5), corners(0.0));
}

#[test]
fn rooms_reach_behind_their_neighbours() {
    let reflex = |r: &Room| {
        let centre = &r.centre.exterior;
        let turn = |i: usize| {
            let at = |d: usize| centre[(i + d) % centre.len()];
            let (a, b, c) = (at(0), at(1), at(2));
            (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) < -0.1
        };
        (0..centre.len()).any(turn)
    };
    let count = |l_shapes| -> usize {
        let buildings = (0..10).map(|seed| only(seed, Variety { l_shapes, ..Variety::default() }));
        buildings.map(|b| of_kind(&b, RoomKind::Room).filter(|r| reflex(r)).count()).sum()
    };
    assert!(count(1.0) > count(0.0) + 5, "{} {}", count(1.0), count(0.0));
}

fn passages(building: &Building) -> impl Iterator<Item = (f64, [RoomId; 2])> {
    let openings = building.layout().openings.iter();
    openings.filter(|o| o.kind == OpeningKind::Passage).map(|o| (o.width(), o.rooms))
}

#[test]
fn open_fronts_are_passages() {
    let count = |open_fronts| -> usize {
        let buildings = (0..6).map(|seed| only(seed, Variety { open_fronts, ..Variety::default() }));
        buildings.map(|b| passages(&b).count()).sum()
    };
    assert!(count(0.5) > 2 * count(0.0) + 10, "{} {}", count(0.5), count(0.0));
}

#[test]
fn at_an_open_end_nothing_is_left_of_the_wall() {
    let open = (0..10).any(|seed| {
        let building = only(seed, Variety { open_ends: 1.0, ..Variety::default() });
        let layout = building.layout();
        passages(&building).any(|(width, rooms)| {
            let corridor = layout
                .rooms
                .iter()
                .find(|r| rooms.contains(&r.id) && building.kind(r.id) == Some(RoomKind::Corridor));
            let sides =
                corridor.map(|r| r.inner.exterior.iter().zip(r.inner.exterior.iter().cycle().skip(1)));
            sides.is_some_and(|mut s| s.any(|(a, b)| (a.distance(*b) - width).abs() < 0.02))
        })
    });
    assert!(open);
}

#[test]
fn clutter_stands_in_the_way() {
    let building = only(2, Variety::default());
    let furniture =
        |clutter| building.scan(&ScanParams { clutter, ..ScanParams::default() }).unwrap().furniture;
    assert!(furniture(0.0).is_empty() && furniture(1.0).len() > 20);
}

#[test]
fn labels_shrink_with_their_grid() {
    let building = varied(5);
    let grid = shrunk(&building.clean_grid(0.05).unwrap(), 4).unwrap();
    let labels = building.labels(0.05, Outline::Inner).unwrap().shrunk(4);
    assert_eq!((labels.width, labels.height), (grid.width(), grid.height()));
    let free = grid.cells().iter().zip(&labels.rooms).filter(|(c, _)| **c == Cell::FREE);
    let (all, named) = free.fold((0, 0), |(all, named), (_, &r)| (all + 1, named + usize::from(r != 0)));
    assert!(named as f64 > 0.97 * f64::from(all), "{named} of {all}");
}
