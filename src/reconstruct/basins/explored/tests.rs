//! Small rasters of rooms seen in part.

use super::super::super::raster::Mask;
use super::*;
use planform_sdk::Point;

const RESOLUTION: f64 = 0.1;
const SIZE: (usize, usize) = (160, 120);

/// What a place shows.
#[derive(Clone, Copy, PartialEq)]
enum Seen {
    Room(u32),
    Wall,
    Unknown,
}

/// What is known of 16 m by 12 m.
fn explored(rooms: usize, seen: impl Fn(f64, f64) -> Seen) -> Knowledge {
    let at = |i: usize| ((i % SIZE.0) as f64 + 0.5, (i / SIZE.0) as f64 + 0.5);
    let cells: Vec<Seen> =
        (0..SIZE.0 * SIZE.1).map(at).map(|(x, y)| seen(x * RESOLUTION, y * RESOLUTION)).collect();
    let label: Vec<u32> = cells.iter().map(|s| if let Seen::Room(l) = s { *l } else { 0 }).collect();
    let free = Mask::new(SIZE.0, SIZE.1, label.iter().map(|&l| l > 0).collect());
    let obstacles = free.with_bits(cells.iter().map(|&s| s == Seen::Wall).collect());
    let input = Labelled {
        resolution: RESOLUTION,
        label: &label,
        rooms,
        free: &free,
        obstacles: &obstacles,
        stated: &[],
    };
    explore(&input, &[0.0, FRAC_PI_2], &Straight::default(), &Explored::default())
}

fn within(x: f64, y: f64, r: [f64; 4]) -> bool {
    x > r[0] && x < r[2] && y > r[1] && y < r[3]
}

/// A rectangle of a room in a wall of 0.2 m.
fn walled(x: f64, y: f64, r: [f64; 4], label: u32) -> Seen {
    match () {
        () if within(x, y, r) => Seen::Room(label),
        () if within(x, y, [r[0] - 0.2, r[1] - 0.2, r[2] + 0.2, r[3] + 0.2]) => Seen::Wall,
        () => Seen::Unknown,
    }
}

fn area(known: &Knowledge, label: u32) -> f64 {
    known.label.iter().filter(|&&l| l == label).count() as f64 * RESOLUTION * RESOLUTION
}

fn label(known: &Knowledge, x: f64, y: f64) -> u32 {
    known.label[(y / RESOLUTION) as usize * SIZE.0 + (x / RESOLUTION) as usize]
}

fn near(a: f64, b: f64, by: f64) {
    assert!((a - b).abs() <= by, "{a} is not {b}");
}

/// Three rooms of 4 m by 5 m side by side; of the middle one only what lies below 3.5 m was seen.
fn row(x: f64, y: f64) -> Seen {
    let rooms = [(1.0, 1), (5.2, 2), (9.4, 3)].map(|(left, l)| walled(x, y, [left, 1.0, left + 4.0, 6.0], l));
    let seen = |s: &Seen| !matches!(s, Seen::Unknown) && (*s != Seen::Room(2) || y < 3.5);
    let hidden = within(x, y, [5.2, 3.5, 9.2, 6.5]);
    let wall = |s: &Seen| *s != Seen::Wall || !hidden;
    rooms.into_iter().find(|s| seen(s) && wall(s)).unwrap_or(Seen::Unknown)
}

#[test]
fn the_shadow_of_a_cupboard_leaves_a_room_complete() {
    let room = |x: f64, y: f64| match () {
        () if within(x, y, [3.0, 5.0, 4.2, 5.2]) => Seen::Wall,
        () if within(x, y, [3.0, 5.2, 4.0 + (y - 5.0), 6.0]) => Seen::Unknown,
        () => walled(x, y, [1.0, 1.0, 7.0, 6.0], 1),
    };
    let known = explored(1, room);
    assert_eq!((known.partial.as_slice(), known.frontiers.len()), ([false].as_slice(), 0));
    assert!(area(&known, 1) < 29.5);
}

#[test]
fn a_gap_in_a_wall_leaves_a_room_complete() {
    let room = |x: f64, y: f64| match walled(x, y, [1.0, 1.0, 7.0, 6.0], 1) {
        Seen::Wall if (2.0..2.6).contains(&x) => Seen::Unknown,
        seen => seen,
    };
    assert_eq!(explored(1, room).partial, [false]);
}

#[test]
fn a_room_in_a_row_is_completed_to_the_back_wall_of_the_row() {
    let known = explored(3, row);
    assert_eq!(known.partial, [false, true, false]);
    near(area(&known, 2), 20.0, 0.6);
    assert_eq!((label(&known, 7.2, 5.8), label(&known, 7.2, 6.3)), (2, 0));
    assert_eq!([area(&known, 1), area(&known, 3)].map(f64::round), [20.0, 20.0]);
    assert_eq!((known.frontiers.len(), known.frontiers[0].room), (1, 1));
    assert_eq!(known.frontiers[0].leads, FrontierKind::Room);
    near(known.frontiers[0].area, 10.0, 0.6);
    // Cells beside a wall's end are no frontier.
    near(known.frontiers[0].segment.length(), 3.8, 0.2);
    near(known.frontiers[0].segment.midpoint().distance(Point::new(7.2, 3.5)), 0.0, 0.1);
}

#[test]
fn a_room_without_neighbours_ends_where_it_was_seen() {
    let known = explored(3, |x, y| if x > 5.0 && x < 9.4 { row(x, y) } else { Seen::Unknown });
    assert_eq!(known.partial, [false, true, false]);
    near(area(&known, 2), 10.0, 0.1);
    assert_eq!(known.frontiers.len(), 1);
    assert_eq!((known.frontiers[0].leads, known.frontiers[0].area), (FrontierKind::Space, 0.0));
}

#[test]
fn new_space_that_is_bounded_has_an_area() {
    // The wall beyond is too far away to be the room's own.
    let beyond = |x: f64, y: f64| within(x, y, [0.0, 10.5, 16.0, 10.7]);
    let known = explored(3, |x, y| match () {
        () if x > 5.0 && x < 9.4 && y < 5.0 => row(x, y),
        () if beyond(x, y) => Seen::Wall,
        () => Seen::Unknown,
    });
    assert_eq!(known.frontiers[0].leads, FrontierKind::Space);
    near(known.frontiers[0].area, 28.0, 2.0);
}

/// A corridor, and what was seen of a room through a door in its wall.
fn glimpse(x: f64, y: f64) -> Seen {
    let fan = y < 6.0 && (x - 6.5).abs() < 0.45 + 0.4 * (y - 3.0);
    match () {
        () if within(x, y, [6.0, 3.0, 7.0, 3.25]) => Seen::Room(1),
        () if within(x, y, [4.0, 3.2, 10.0, 6.0]) && fan => Seen::Room(1),
        () => walled(x, y, [1.0, 1.0, 13.0, 3.0], 1),
    }
}

#[test]
fn what_is_seen_through_a_door_is_another_room() {
    let known = explored(1, glimpse);
    assert_eq!(known.partial, [false, true]);
    assert_eq!((label(&known, 2.0, 2.0), label(&known, 6.5, 5.0)), (1, 2));
    near(area(&known, 1), 24.0, 0.5);
    assert!(known.frontiers.iter().all(|f| f.room == 1) && !known.frontiers.is_empty());
}

#[test]
fn a_wall_that_few_rays_met_is_no_frontier() {
    // The upper wall was seen for some metres, from there on at every second metre.
    let corridor = |x: f64, y: f64| match walled(x, y, [1.0, 1.0, 15.0, 3.0], 1) {
        Seen::Wall if y > 3.0 && x > 5.0 && x.fract() > 0.1 => Seen::Unknown,
        seen => seen,
    };
    assert_eq!(explored(1, corridor).partial, [false]);
}

#[test]
fn rasters_without_rooms_are_no_trouble() {
    assert!(explored(0, |_, _| Seen::Unknown).partial.is_empty());
    assert!(explored(0, |_, _| Seen::Wall).frontiers.is_empty());
}
