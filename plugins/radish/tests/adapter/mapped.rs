//! The grids that logs make.

use crate::support::*;
use planform_sdk::{Cell, Point, Scene};

/// The occupancy at a point, percent.
fn at(scene: &Scene, x: f64, y: f64) -> Option<u8> {
    let cell = scene.grid.to_cells(Point::new(x, y));
    scene.grid.cell(cell.x.floor() as i64, cell.y.floor() as i64).occupancy()
}

/// Holds a scene to the room.
fn is_the_room(scene: &Scene) {
    for i in 2..59 {
        let x = ROOM[0] * f64::from(i) / 60.0;
        assert_eq!(at(scene, x, 2.0), Some(0), "free at {x}");
        let beyond = [at(scene, x, -0.2), at(scene, x, ROOM[1] + 0.2)];
        assert_eq!(beyond, [None; 2], "beyond the walls at {x}");
    }
    let walls = |y: f64| (10..50).filter(|i| at(scene, f64::from(*i) * 0.1 + 0.025, y) > Some(50)).count();
    assert!(walls(-0.001) + walls(0.001) > 35 && walls(3.999) + walls(4.001) > 35);
}

#[test]
fn the_room_is_where_the_poses_have_it() {
    let scene = read(&log());
    is_the_room(&scene);
    assert_eq!((scene.grid.resolution(), scene.grid.origin().yaw), (0.05, 0.0));
    let origin = scene.grid.origin();
    let cells = [origin.x, origin.y].map(|v| (v / 0.05 - (v / 0.05).round()).abs());
    assert!(cells[0] < 1e-9 && cells[1] < 1e-9, "{origin:?} is a corner of the frame's own cells");
}

#[test]
fn rear_lasers_look_back() {
    let back = |[x, y, theta]: At| [x, y, theta + std::f64::consts::PI];
    let seen = |at: At| ranges(back(at));
    let rear = |log: String| log.replace("FLASER", "RLASER") + "NEFF 1\n";
    // With the robot's heading, and with the laser's.
    is_the_room(&read(&rear(way().iter().map(|at| flaser(&seen(*at), *at, *at)).collect())));
    is_the_room(&read(&rear(way().iter().map(|at| flaser(&seen(*at), back(*at), *at)).collect())));
}

#[test]
fn new_messages_make_the_same_map() {
    let laser =
        format!("ROBOTLASER1 0 {} 3.141593 {} 81.9 0.01 0", -std::f64::consts::FRAC_PI_2, 0.017_453_293);
    let line = |at: &At| {
        let (ranges, at) = (joined(&ranges(*at)), joined(at));
        format!("{laser} {BEAMS} {ranges} 0 {at} {at} 0.1 0 0.5 0.5 1000 1.5 host 1.5\n")
    };
    let new: String = way().iter().map(line).collect();
    is_the_room(&read(&(new + "NEFF 1\n")));
}

#[test]
fn beams_without_an_echo_draw_nothing() {
    let lost = log().lines().fold(String::new(), |log, line| {
        let mut fields: Vec<_> = line.split(' ').collect();
        if fields[0] == "FLASER" {
            (100..130).for_each(|i| fields[i] = "81.91");
        }
        log + &fields.join(" ") + "\n"
    });
    let scene = read(&lost);
    is_the_room(&scene);
    assert_eq!(scene.grid.width(), read(&log()).grid.width());
}

#[test]
fn options_change_what_they_say() {
    let with = |name, value| read_bytes(log().as_bytes(), &[(name, value)]).unwrap();
    let coarse = with("resolution", "0.1");
    is_the_room(&coarse);
    assert!(coarse.grid.width() < 80 && read(&log()).grid.width() > 110);
    // A beam that ends beyond its reach frees the way and draws no obstacle.
    let near = with("max-range", "0.5");
    assert!(near.grid.cells().iter().all(|c| c.occupancy().is_none_or(|o| o < 50)));
    assert_eq!(at(&near, 3.0, 2.0 + (0.5_f64 * 9.0).sin()), Some(0));
    assert_ne!(with("field-of-view", "90").grid, read(&log()).grid);
    assert_ne!(with("laser-offset", "0.3").grid, read(&log()).grid);
    let sure = with("hit-odds", "0.999");
    let occupied = |s: &Scene| s.grid.cells().iter().filter(|c| **c == Cell::OCCUPIED).count();
    assert!(occupied(&sure) > occupied(&read(&log())));
}
