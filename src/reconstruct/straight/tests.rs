//! Small made-up rasters, buildings with known truth, and rasters of chance.

use super::*;
use geo::{Area, BooleanOps, Validation};
use planform_sdk::{Cell, Grid, OpeningKind, Point, Pose};
use planform_synth::{Building, BuildingParams, Outline, Size};
use proptest::prelude::*;

/// What a place shows.
#[derive(Clone, Copy, PartialEq)]
enum Seen {
    Room(u32),
    Wall,
    Unknown,
}

/// A raster with its masks.
struct Raster {
    resolution: f64,
    label: Vec<u32>,
    rooms: usize,
    free: Mask,
    obstacles: Mask,
}

impl Raster {
    /// What `seen` tells at each cell's centre, metres.
    fn new([width, height]: [f64; 2], resolution: f64, seen: impl Fn(f64, f64) -> Seen) -> Self {
        let (w, h) = ((width / resolution).round() as usize, (height / resolution).round() as usize);
        let at = |i: usize| ((i % w) as f64 + 0.5, (i / w) as f64 + 0.5);
        let cells: Vec<Seen> =
            (0..w * h).map(at).map(|(x, y)| seen(x * resolution, y * resolution)).collect();
        Self::of_cells(w, h, resolution, &cells)
    }

    fn of_cells(w: usize, h: usize, resolution: f64, cells: &[Seen]) -> Self {
        let label = |s: &Seen| if let Seen::Room(l) = s { *l } else { 0 };
        let label: Vec<u32> = cells.iter().map(label).collect();
        Self {
            resolution,
            rooms: label.iter().max().map_or(0, |&l| l as usize),
            free: Mask::new(w, h, label.iter().map(|&l| l > 0).collect()),
            obstacles: Mask::new(w, h, cells.iter().map(|&s| s == Seen::Wall).collect()),
            label,
        }
    }

    fn plan_with(&self, params: &Straight) -> Plan {
        let input = Labelled {
            resolution: self.resolution,
            label: &self.label,
            rooms: self.rooms,
            free: &self.free,
            obstacles: &self.obstacles,
            stated: &[],
        };
        plan(&input, &directions(&input, params), params)
    }

    fn plan(&self) -> Plan {
        self.plan_with(&Straight { unseen_thickness: 0.2, ..Straight::default() })
    }
}

/// A rectangle: left, low, right, high.
fn within(x: f64, y: f64, r: [f64; 4]) -> bool {
    x > r[0] && x < r[2] && y > r[1] && y < r[3]
}

/// Two rooms of 4 m by 3 m in walls of 0.2 m with a door of 0.9 m between.
fn two_rooms(x: f64, y: f64) -> Seen {
    match () {
        () if within(x, y, [1.0, 1.0, 5.1, 4.0]) && x < 5.0 => Seen::Room(1),
        () if within(x, y, [5.2, 1.0, 9.2, 4.0]) => Seen::Room(2),
        () if within(x, y, [5.0, 2.0, 5.2, 2.9]) => Seen::Room(if x < 5.1 { 1 } else { 2 }),
        () if within(x, y, [0.8, 0.8, 9.4, 4.2]) => Seen::Wall,
        () => Seen::Unknown,
    }
}

fn floor(plan: &Plan, room: usize) -> &Polygon {
    &plan.rooms[room].as_ref().unwrap().floor
}

fn centre(plan: &Plan, room: usize) -> &Polygon {
    &plan.rooms[room].as_ref().unwrap().centre
}

fn near(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by, "{a} is not {b}");
}

fn to_geo(p: &Polygon) -> geo::Polygon {
    let ring = |r: &[Point]| r.iter().map(|p| (p.x, p.y)).collect::<geo::LineString>();
    geo::Polygon::new(ring(&p.exterior), p.holes.iter().map(|h| ring(h)).collect())
}

/// Every polygon is valid, no two of a kind overlap, and the centre outline contains the floor.
fn sound(plan: &Plan) {
    let rooms: Vec<&RoomPlan> = plan.rooms.iter().flatten().collect();
    for of in [|r: &RoomPlan| to_geo(&r.floor), |r: &RoomPlan| to_geo(&r.centre)] {
        let polygons: Vec<geo::Polygon> = rooms.iter().map(|r| of(r)).collect();
        for (i, p) in polygons.iter().enumerate() {
            assert!(p.is_valid(), "{p:?}");
            for q in &polygons[..i] {
                let shared = p.intersection(q).unsigned_area();
                assert!(
                    shared < 1e-3 * p.unsigned_area().min(q.unsigned_area()) + 1e-3,
                    "{shared}: {p:?} {q:?}"
                );
            }
        }
    }
    for room in rooms {
        let outside = to_geo(&room.floor).difference(&to_geo(&room.centre)).unsigned_area();
        assert!(outside < 1e-3 * room.floor.area() + 2e-3, "{outside}: {room:?}");
    }
}

#[test]
fn two_rooms_and_a_door() {
    let plan = Raster::new([10.2, 5.0], 0.05, two_rooms).plan();
    sound(&plan);
    for room in 0..2 {
        assert_eq!((floor(&plan, room).exterior.len(), centre(&plan, room).exterior.len()), (4, 4));
        near(floor(&plan, room).area(), 12.0, 0.01);
        near(centre(&plan, room).area(), 4.2 * 3.2, 0.01);
    }
    assert_eq!((plan.openings.len(), plan.openings[0].kind), (1, OpeningKind::Door));
    near(plan.openings[0].segment.length(), 0.9, 0.03);
    near(plan.openings[0].segment.midpoint().distance(Point::new(5.1, 2.45)), 0.0, 0.03);
    assert_eq!(plan.walls.len(), 8, "{:?}", plan.walls);
    assert!(plan.walls.iter().all(|w| (w.thickness - 0.2).abs() < 0.03 && w.weight > 0.9));
    assert!(plan.frontiers.is_empty());
}

#[test]
fn walls_meet_at_their_corners() {
    let plan = Raster::new([10.2, 5.0], 0.05, two_rooms).plan();
    let corner = |p: Point| {
        let ends = plan.walls.iter().flat_map(|w| [w.line.a, w.line.b]);
        ends.filter(|e| e.distance(p) < 1e-6).count()
    };
    for wall in plan.walls.iter().filter(|w| w.rooms[1].is_none()) {
        assert!(corner(wall.line.a) >= 2 && corner(wall.line.b) >= 2, "{wall:?}");
    }
}

#[test]
fn a_turned_building_is_as_straight() {
    let (sin, cos) = 0.3f64.sin_cos();
    let turned = |x: f64, y: f64| two_rooms((x - 1.0) * cos + y * sin, y * cos - (x - 1.0) * sin + 0.5);
    let plan = Raster::new([11.0, 7.0], 0.05, turned).plan();
    sound(&plan);
    for room in 0..2 {
        assert_eq!((floor(&plan, room).exterior.len(), centre(&plan, room).exterior.len()), (4, 4));
        near(floor(&plan, room).area(), 12.0, 0.2);
    }
    near(plan.openings[0].segment.length(), 0.9, 0.06);
    assert_eq!((plan.openings.len(), plan.walls.len()), (1, 8));
}

/// A room in walls of 0.2 m with this ground plan.
fn one_room(is: impl Fn(f64, f64) -> bool + Copy) -> Raster {
    let wall = move |x: f64, y: f64| {
        (-2..=2).any(|i| (-2..=2).any(|j| is(x + f64::from(i) * 0.1, y + f64::from(j) * 0.1)))
    };
    Raster::new([8.0, 8.0], 0.05, move |x, y| match () {
        () if is(x, y) => Seen::Room(1),
        () if wall(x, y) => Seen::Wall,
        () => Seen::Unknown,
    })
}

#[test]
fn an_l_has_six_corners() {
    let plan = one_room(|x, y| within(x, y, [1.0, 1.0, 7.0, 7.0]) && (x < 4.0 || y < 4.0)).plan();
    sound(&plan);
    assert_eq!((floor(&plan, 0).exterior.len(), centre(&plan, 0).exterior.len()), (6, 6));
    near(floor(&plan, 0).area(), 27.0, 0.02);
    assert_eq!(plan.walls.len(), 6);
}

#[test]
fn a_large_hole_stays_and_a_pillar_goes() {
    let court = |x, y| within(x, y, [3.0, 3.0, 5.0, 5.0]);
    let pillar = |x, y| within(x, y, [1.5, 1.5, 1.9, 1.9]);
    let plan = one_room(|x, y| within(x, y, [1.0, 1.0, 7.0, 7.0]) && !court(x, y) && !pillar(x, y)).plan();
    sound(&plan);
    assert_eq!((floor(&plan, 0).exterior.len(), floor(&plan, 0).holes.len()), (4, 1));
    assert_eq!(floor(&plan, 0).holes[0].len(), 4);
    near(floor(&plan, 0).area(), 32.0, 0.02);
}

#[test]
fn a_round_room_stays_round_within_the_tolerance() {
    let plan = one_room(|x, y| (x - 4.0).hypot(y - 4.0) < 3.0).plan();
    sound(&plan);
    let ring = &floor(&plan, 0).exterior;
    assert!((8..=24).contains(&ring.len()), "{}", ring.len());
    for p in ring {
        near(p.distance(Point::new(4.0, 4.0)), 3.0, 0.25);
    }
    near(floor(&plan, 0).area(), 9.0 * std::f64::consts::PI, 1.0);
}

#[test]
fn a_dent_in_a_wall_is_bridged() {
    let cupboard = |x, y| within(x, y, [3.0, 0.0, 3.7, 1.4]);
    let plan = one_room(|x, y| within(x, y, [1.0, 1.0, 7.0, 7.0]) && !cupboard(x, y)).plan();
    assert_eq!(floor(&plan, 0).exterior.len(), 4);
    near(floor(&plan, 0).area(), 36.0, 0.02);
    let wide = Straight { dent_width: 0.5, ..Straight::default() };
    let plan = one_room(|x, y| within(x, y, [1.0, 1.0, 7.0, 7.0]) && !cupboard(x, y)).plan_with(&wide);
    assert_eq!(floor(&plan, 0).exterior.len(), 8);
}

#[test]
fn an_open_side_is_a_frontier() {
    let room = |x: f64, y: f64| match two_rooms(x, y) {
        Seen::Wall if x > 9.2 && within(x, y, [9.0, 1.0, 10.0, 4.0]) => Seen::Unknown,
        seen => seen,
    };
    let plan = Raster::new([10.2, 5.0], 0.05, room).plan();
    assert_eq!(plan.frontiers.len(), 1, "{:?}", plan.frontiers);
    assert_eq!(plan.frontiers[0].room, 1);
    near(plan.frontiers[0].segment.length(), 3.0, 0.2);
    assert_eq!(plan.walls.len(), 7);
}

#[test]
fn rooms_that_adjoin_without_a_wall_share_a_line() {
    // The labels meet along a slanted line.
    let open = |x: f64, y: f64| match () {
        () if within(x, y, [1.0, 1.0, 9.0, 4.0]) => Seen::Room(if x < 5.0 + 0.1 * (y - 2.5) { 1 } else { 2 }),
        () if within(x, y, [0.8, 0.8, 9.2, 4.2]) => Seen::Wall,
        () => Seen::Unknown,
    };
    let plan = Raster::new([10.0, 5.0], 0.05, open).plan();
    sound(&plan);
    near(floor(&plan, 0).area() + floor(&plan, 1).area(), 24.0, 0.02);
    assert_eq!([0, 1].map(|r| floor(&plan, r).exterior.len()), [4, 4]);
    assert_eq!((plan.openings.len(), plan.openings[0].kind), (1, OpeningKind::Passage));
    assert!(plan.walls.iter().all(|w| w.rooms[1].is_none()), "{:?}", plan.walls);
}

#[test]
fn walls_along_a_corridor_are_collinear_if_alignment_is_wanted() {
    let row = |x: f64, y: f64| match () {
        () if within(x, y, [1.0, 1.0, 4.0, 4.0]) => Seen::Room(1),
        () if within(x, y, [4.2, 1.1, 7.0, 4.0]) => Seen::Room(2),
        () if within(x, y, [0.8, 0.8, 7.2, 4.2]) => Seen::Wall,
        () => Seen::Unknown,
    };
    let raster = Raster::new([8.0, 5.0], 0.05, row);
    let lows =
        |plan: &Plan| [0, 1].map(|r| floor(plan, r).exterior.iter().map(|p| p.y).fold(f64::MAX, f64::min));
    let [a, b] = lows(&raster.plan_with(&Straight { alignment: 0.6, ..Straight::default() }));
    near(a, b, 1e-6);
    let [a, b] = lows(&raster.plan_with(&Straight { alignment: 0.0, ..Straight::default() }));
    near(b - a, 0.1, 1e-6);
}

/// The share that two polygons have in common of what they cover.
fn iou(a: &Polygon, b: &Polygon) -> f64 {
    let (a, b) = (to_geo(a), to_geo(b));
    let shared = a.intersection(&b).unsigned_area();
    shared / (a.unsigned_area() + b.unsigned_area() - shared)
}

/// The raster of a building's true rooms, and the truth moved into its frame.
fn of_building(building: &Building) -> (Raster, Vec<Polygon>, Vec<Segment>) {
    let grid: Grid = building.clean_grid(0.05).unwrap();
    let inner = building.labels(0.05, Outline::Inner).unwrap().rooms;
    let whole = building.labels(0.05, Outline::Centre).unwrap().rooms;
    let seen = |i: usize| match grid.cells()[i] {
        Cell::OCCUPIED => Seen::Wall,
        Cell::FREE if inner[i] > 0 => Seen::Room(inner[i]),
        Cell::FREE => Seen::Room(whole[i]),
        _ => Seen::Unknown,
    };
    let cells: Vec<Seen> = (0..inner.len()).map(seen).collect();
    let raster = Raster::of_cells(grid.width() as usize, grid.height() as usize, 0.05, &cells);
    let Pose { x, y, .. } = grid.origin();
    let moved = |p: &Point| Point::new(p.x - x, p.y - y);
    let ring = |r: &[Point]| r.iter().map(moved).collect::<Vec<_>>();
    let floors = building.layout().rooms.iter();
    let floors = floors
        .map(|r| Polygon::new(ring(&r.inner.exterior), r.inner.holes.iter().map(|h| ring(h)).collect()));
    let walls = building.layout().walls.iter().map(|w| Segment::new(moved(&w.line.a), moved(&w.line.b)));
    (raster, floors.collect(), walls.collect())
}

#[test]
fn true_labels_of_made_up_buildings_give_their_true_floors_and_walls() {
    for (seed, size) in [(1, Size::House), (2, Size::House), (3, Size::House), (5, Size::School)] {
        let building = Building::generate(seed, &BuildingParams::of_size(size));
        let (raster, floors, walls) = of_building(&building);
        let plan = raster.plan();
        sound(&plan);
        let shares: Vec<f64> = floors.iter().enumerate().map(|(i, f)| iou(f, floor(&plan, i))).collect();
        let mean = shares.iter().sum::<f64>() / shares.len() as f64;
        assert!(mean >= 0.985, "seed {seed}: {shares:?}");
        assert_eq!(plan.openings.len(), building.layout().openings.len());
        let long = plan.walls.iter().filter(|w| w.line.length() > 0.5);
        let away = |p: Point| walls.iter().map(|w| from_segment(p, w)).fold(f64::MAX, f64::min);
        let mut offsets: Vec<f64> = long.map(|w| away(w.line.midpoint())).collect();
        offsets.sort_by(f64::total_cmp);
        let most = offsets[offsets.len() * 9 / 10];
        assert!(most < 0.05, "seed {seed}: {offsets:?}");
    }
}

fn from_segment(p: Point, s: &Segment) -> f64 {
    let t = (p.x - s.a.x) * (s.b.x - s.a.x) + (p.y - s.a.y) * (s.b.y - s.a.y);
    let t = (t / s.length().powi(2)).clamp(0.0, 1.0);
    p.distance(Point::new(s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)))
}

fn chance(w: usize, h: usize, scale: usize, kinds: &[u8]) -> Vec<Seen> {
    let kind = |i: usize| match kinds[(i / w / scale) * w.div_ceil(scale) + i % w / scale] {
        0 => Seen::Wall,
        1 => Seen::Unknown,
        k => Seen::Room(u32::from(k) - 1),
    };
    (0..w * h).map(kind).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_raster_of_chance_breaks_anything(
        scale in 1usize..12,
        (w, h) in (1usize..40, 1usize..40),
        kinds in proptest::collection::vec(0u8..6, 1600),
        resolution in prop::sample::select(vec![0.03, 0.05, 0.1, 0.5]),
        alignment in prop::sample::select(vec![0.0, 0.5, 1.0]),
    ) {
        let raster = Raster::of_cells(w, h, resolution, &chance(w, h, scale, &kinds));
        let params = Straight { alignment, ..Straight::default() };
        let plan = raster.plan_with(&params);
        sound(&plan);
        prop_assert_eq!(&plan, &raster.plan_with(&params));
        for wall in &plan.walls {
            prop_assert!(wall.thickness <= params.max_wall + 1e-9 && wall.line.length() > 0.0, "{wall:?}");
        }
    }
}
