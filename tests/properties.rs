//! What must hold for every map: turning, mirroring, moving or refining it changes little, and every layout is sound.
//!
//! The segments are found in a random order (from a fixed seed), so a map that lies otherwise gives another sample of
//! them. How much that may change is said at each test.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;

use accuracy_support::{coverage, for_seeds, layout_of, shared, to_geo};
use geo::Validation;
use planform_sdk::{Grid, Layout, Point, Polygon, Pose, Room, RoomState, ring_signed_area};
use planform_synth::{
    Building, BuildingParams, Noise, ScanParams, SimpleParams, Size, corridor_with_rooms, simple, two_rooms,
};

/// A map that shows the same building otherwise, and the way back: from its cells to the first map's.
struct Variant {
    name: &'static str,
    grid: Grid,
    back: Box<dyn Fn(Point) -> Point>,
}

/// A grid of this size whose cells are those of `grid` at the place that `from` tells.
fn mapped(grid: &Grid, size: (u32, u32), from: impl Fn(i64, i64) -> (i64, i64)) -> Grid {
    let places = (0..i64::from(size.1)).flat_map(|row| (0..i64::from(size.0)).map(move |c| (c, row)));
    let cells = places.map(|(column, row)| from(column, row)).map(|(c, r)| grid.cell(c, r)).collect();
    Grid::new(size.0, size.1, grid.resolution(), grid.origin(), cells).unwrap()
}

fn quarter_turn(grid: &Grid) -> Grid {
    let last = i64::from(grid.height()) - 1;
    mapped(grid, (grid.height(), grid.width()), |column, row| (row, last - column))
}

fn mirror(grid: &Grid) -> Grid {
    let last = i64::from(grid.width()) - 1;
    mapped(grid, (grid.width(), grid.height()), |column, row| (last - column, row))
}

/// Moved by unknown cells to the left and below, with some to the right and above.
fn pad(grid: &Grid) -> Grid {
    mapped(grid, (grid.width() + 40, grid.height() + 30), |column, row| (column - 17, row - 9))
}

/// Each cell as four of half the size.
fn refine(grid: &Grid) -> Grid {
    let fine = mapped(grid, (2 * grid.width(), 2 * grid.height()), |column, row| (column / 2, row / 2));
    let cells = fine.cells().to_vec();
    Grid::new(fine.width(), fine.height(), grid.resolution() / 2.0, grid.origin(), cells).unwrap()
}

fn moved(grid: &Grid, origin: Pose) -> Grid {
    Grid::new(grid.width(), grid.height(), grid.resolution(), origin, grid.cells().to_vec()).unwrap()
}

fn variants(grid: &Grid) -> Vec<Variant> {
    let (w, h) = (f64::from(grid.width()), f64::from(grid.height()));
    let quarter = quarter_turn(grid);
    let half = quarter_turn(&quarter);
    let variant = |name, grid, back: fn(Point, f64, f64) -> Point| Variant {
        name,
        grid,
        back: Box::new(move |p| back(p, w, h)),
    };
    vec![
        variant("turned by 270 degrees", quarter_turn(&half), |p, w, _| Point::new(w - p.y, p.x)),
        variant("turned by 180 degrees", half, |p, w, h| Point::new(w - p.x, h - p.y)),
        variant("turned by 90 degrees", quarter, |p, _, h| Point::new(p.y, h - p.x)),
        variant("mirrored", mirror(grid), |p, w, _| Point::new(w - p.x, p.y)),
        variant("moved in the grid", pad(grid), |p, _, _| Point::new(p.x - 17.0, p.y - 9.0)),
        variant("refined", refine(grid), |p, _, _| Point::new(p.x / 2.0, p.y / 2.0)),
    ]
}

fn carried(polygon: &Polygon, carry: impl Fn(Point) -> Point) -> geo::Polygon<f64> {
    let ring = |r: &Vec<Point>| r.iter().map(|&p| carry(p)).collect();
    to_geo(&Polygon::new(ring(&polygon.exterior), polygon.holes.iter().map(ring).collect()))
}

/// How a variant's layout differs from the first map's.
struct Change {
    name: String,
    rooms: [usize; 2],
    /// Share of the rooms' area on which both layouts agree, 0 to 1.
    agreement: f64,
    /// Relative change of the sum of the rooms' areas.
    total: f64,
    /// The largest relative change of one room's area, floors and outlines; rooms paired by overlap.
    room: f64,
}

fn changes(name: &str, grid: &Grid) -> Vec<Change> {
    let layout = layout_of(grid.clone());
    sound(&layout, name);
    variants(grid).iter().map(|v| change(name, grid, &layout, v)).collect()
}

fn change(name: &str, grid: &Grid, layout: &Layout, variant: &Variant) -> Change {
    let name = format!("{name} {}", variant.name);
    let other = layout_of(variant.grid.clone());
    sound(&other, &name);
    let carry = |p: Point| grid.to_map((variant.back)(variant.grid.to_cells(p)));
    let before: Vec<_> = layout.rooms.iter().map(|r| to_geo(&r.centre)).collect();
    let after: Vec<_> = other.rooms.iter().map(|r| carried(&r.centre, carry)).collect();
    let sum = |l: &Layout| l.rooms.iter().map(Room::area).sum::<f64>();
    let room = before.iter().zip(&layout.rooms).map(|(b, room)| {
        let overlap = |i: &usize| shared(b, &after[*i]);
        let like = (0..after.len()).max_by(|i, j| overlap(i).total_cmp(&overlap(j))).unwrap();
        let like = &other.rooms[like];
        relative(room.area(), like.area()).max(relative(room.centre.area(), like.centre.area()))
    });
    Change {
        name,
        rooms: [layout.rooms.len(), other.rooms.len()],
        agreement: coverage(&before, &after).min(coverage(&after, &before)),
        total: relative(sum(layout), sum(&other)),
        room: room.fold(0.0, f64::max),
    }
}

fn relative(a: f64, b: f64) -> f64 {
    (a - b).abs() / a
}

impl Change {
    fn print(&self) {
        println!(
            "{}: {:?} rooms, agreement {:.3}, total {:.4}, room {:.4}",
            self.name, self.rooms, self.agreement, self.total, self.room
        );
    }
}

/// Checks what is promised of every layout.
fn sound(layout: &Layout, name: &str) {
    assert!(numbers(layout).iter().all(|n| n.is_finite()), "{name}: a number is not finite");
    let ids: Vec<u32> = layout.rooms.iter().map(|r| r.id).collect();
    assert_eq!(ids, (1..=ids.len() as u32).collect::<Vec<_>>(), "{name}");
    for room in &layout.rooms {
        for (which, polygon) in [("inner", &room.inner), ("centre", &room.centre)] {
            sound_polygon(polygon, &format!("{name}: room {} {which}", room.id));
            sound_polygon(
                &rounded(polygon),
                &format!("{name}: room {} {which}, rounded to 0.1 mm,", room.id),
            );
        }
    }
    disjoint(layout, |r| &r.inner, 1e-4, &format!("{name}: floors"));
    disjoint(layout, |r| &r.centre, 1e-4, &format!("{name}: outlines"));
    let known = |id: &u32| ids.contains(id);
    for opening in &layout.openings {
        let [a, b] = opening.rooms;
        assert!(known(&a) && known(&b) && a < b, "{name}: an opening joins {a} and {b}");
        assert!(opening.width() > 0.0, "{name}: an opening of no width");
    }
    for wall in &layout.walls {
        assert!(wall.thickness > 0.0, "{name}: a wall is {} m thick", wall.thickness);
        assert!((0.0..=1.0).contains(&wall.weight), "{name}: a wall weighs {}", wall.weight);
        assert!(wall.rooms.iter().flatten().all(known), "{name}: a wall has rooms {:?}", wall.rooms);
    }
    for frontier in &layout.frontiers {
        let room = layout.rooms.iter().find(|r| r.id == frontier.room);
        assert!(
            room.is_some_and(|r| r.state == RoomState::Partial),
            "{name}: room {} has a frontier, but is not partial",
            frontier.room
        );
        assert!(frontier.area >= 0.0, "{name}: a frontier leads to {} square metres", frontier.area);
    }
}

/// All coordinates and measures.
fn numbers(layout: &Layout) -> Vec<f64> {
    let rings = layout.rooms.iter().flat_map(|r| r.inner.rings().chain(r.centre.rings())).flatten();
    let walls = layout.walls.iter().map(|w| &w.line);
    let openings = layout.openings.iter().map(|o| &o.segment);
    let frontiers = layout.frontiers.iter().map(|f| &f.segment);
    let segments = walls.chain(openings).chain(frontiers).chain(layout.lines.iter().map(|l| &l.segment));
    let points = rings.copied().chain(segments.flat_map(|s| [s.a, s.b]));
    let measures = layout.walls.iter().flat_map(|w| [w.thickness, w.weight]);
    let measures = measures.chain(layout.frontiers.iter().map(|f| f.area));
    points.flat_map(|p| [p.x, p.y]).chain(measures).chain(layout.lines.iter().map(|l| l.support)).collect()
}

/// As files have it.
fn rounded(polygon: &Polygon) -> Polygon {
    let round = |v: f64| (v * 1e4).round() / 1e4;
    let ring = |r: &Vec<Point>| {
        let mut points: Vec<Point> = r.iter().map(|p| Point::new(round(p.x), round(p.y))).collect();
        points.dedup();
        points
    };
    Polygon { exterior: ring(&polygon.exterior), holes: polygon.holes.iter().map(ring).collect() }
}

fn sound_polygon(polygon: &Polygon, name: &str) {
    let errors = to_geo(polygon).validation_errors();
    assert!(errors.is_empty(), "{name} is not valid: {errors:?} {polygon:?}");
    assert!(ring_signed_area(&polygon.exterior) > 0.0, "{name} runs clockwise");
    assert!(polygon.holes.iter().all(|h| ring_signed_area(h) < 0.0), "{name}: a hole runs counter-clockwise");
}

fn disjoint(layout: &Layout, of: impl Fn(&Room) -> &Polygon, most: f64, name: &str) {
    let polygons: Vec<_> = layout.rooms.iter().map(|r| to_geo(of(r))).collect();
    for (i, a) in polygons.iter().enumerate() {
        for (j, b) in polygons.iter().enumerate().take(i) {
            let common = shared(a, b);
            assert!(common < most, "{name} of rooms {} and {} share {common} m2", j + 1, i + 1);
        }
    }
}

fn drawn(size: Size, seed: u64) -> Building {
    Building::generate(seed, &BuildingParams::of_size(size))
}

fn scanned(building: &Building, seed: u64) -> Grid {
    building.scan(&ScanParams { seed, ..ScanParams::default() }).unwrap().grid
}

/// Of rooms and doors only, axis-parallel: nothing is left to chance. A cell is 1.3 % of a room's width.
#[test]
fn plain_buildings_keep_their_rooms_and_areas() {
    let buildings = [two_rooms(), simple(4, 3, &SimpleParams::default()), corridor_with_rooms(9)];
    let names = ["two rooms", "twelve rooms", "a corridor"];
    for (building, name) in buildings.iter().zip(names) {
        for c in changes(name, &building.clean_grid(0.05).unwrap()) {
            c.print();
            assert_eq!(c.rooms[0], building.layout().rooms.len(), "{}", c.name);
            assert_eq!(c.rooms[0], c.rooms[1], "{}", c.name);
            assert!(c.room < 0.02 && c.total < 0.01 && c.agreement > 0.99, "{}", c.name);
        }
    }
}

/// Buildings at odd angles with small rooms, exact and as a robot maps them: now and then another sample of segments
/// makes or loses a line and with it splits or merges rooms, but most of the area stays in the same rooms.
#[test]
fn other_buildings_keep_most_of_their_rooms() {
    let found = for_seeds(1..=12, |seed| {
        let building = drawn(if seed % 2 == 0 { Size::House } else { Size::Office }, seed);
        let grid = if seed <= 6 { building.clean_grid(0.05).unwrap() } else { scanned(&building, seed) };
        changes(&format!("building {seed}"), &grid)
    });
    let all: Vec<Change> = found.into_iter().flatten().collect();
    all.iter().for_each(Change::print);
    for c in &all {
        assert!(c.rooms[0].abs_diff(c.rooms[1]) * 3 <= c.rooms[0], "{}: {:?} rooms", c.name, c.rooms);
        assert!(c.total < 0.03, "{}: the total changes by {}", c.name, c.total);
        assert!(c.agreement > 0.85, "{}: agreement {}", c.name, c.agreement);
    }
    let mean = all.iter().map(|c| c.agreement).sum::<f64>() / all.len() as f64;
    assert!(mean > 0.96, "mean agreement {mean}");
}

/// The core works in the grid's frame, so where the grid lies changes nothing but the last digits.
#[test]
fn origin_and_yaw_only_move_the_layout() {
    for grid in [two_rooms().clean_grid(0.05).unwrap(), scanned(&drawn(Size::House, 5), 5)] {
        let layout = layout_of(grid.clone());
        for origin in [Pose { x: 123.4, y: -56.7, yaw: 0.8 }, Pose { x: -1e5, y: 3e5, yaw: -2.5 }] {
            let other = layout_of(moved(&grid, origin));
            sound(&other, "moved");
            assert_eq!(layout.rooms.len(), other.rooms.len());
            for (a, b) in layout.rooms.iter().zip(&other.rooms) {
                assert!((a.area() - b.area()).abs() < 1e-6, "{} and {}", a.area(), b.area());
                assert!((a.centre.area() - b.centre.area()).abs() < 1e-6);
            }
            assert_eq!(layout.walls.len(), other.walls.len());
            assert_eq!(layout.graph(), other.graph());
        }
    }
}

/// Crowded rooms, windows, closed doors, bent walls, far from the origin.
#[test]
fn poor_maps_have_sound_layouts() {
    for_seeds(1..=100, |seed| {
        let building = drawn(if seed % 3 == 0 { Size::Office } else { Size::House }, seed);
        let params = ScanParams {
            seed,
            noise: Noise::heavy(),
            furniture: 0.5,
            unexplored: 0.3,
            glass: 0.3,
            ..ScanParams::default()
        };
        let scan = building.scan(&params).unwrap();
        // Furniture may enclose the robot where it starts; then there is no room to find.
        if scan.visited_share() < 0.2 {
            return;
        }
        let layout = layout_of(moved(&scan.grid, Pose { x: 1e5, y: -3e5, yaw: 0.3 }));
        sound(&layout, &format!("poor map {seed}"));
    });
}
