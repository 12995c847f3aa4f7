//! What a robot's map has to do with the building.

use planform_sdk::{Cell, RoomState};
use planform_synth::{
    Building, BuildingParams, Noise, Output, ScanParams, Size, corridor_with_rooms, two_rooms,
};

fn office(seed: u64) -> Building {
    Building::generate(seed, &BuildingParams::of_size(Size::Office))
}

#[test]
fn a_perfect_robot_agrees_with_the_clean_grid() {
    let building = office(2);
    let clean = building.clean_grid(0.05).unwrap();
    let scan = building.scan(&ScanParams { noise: Noise::none(), ..ScanParams::default() }).unwrap();
    assert_eq!((clean.width(), clean.origin()), (scan.grid.width(), scan.grid.origin()));
    let pairs = || clean.cells().iter().zip(scan.grid.cells());
    let floor = pairs().filter(|(c, _)| **c == Cell::FREE).count();
    let both = pairs().filter(|(c, s)| **c == Cell::FREE && **s == Cell::FREE).count();
    assert!(both as f64 > 0.95 * floor as f64, "{both} of {floor}");
    let wrong = pairs().filter(|(c, s)| **c != Cell::FREE && **s == Cell::FREE).count();
    assert!((wrong as f64) < 0.01 * floor as f64, "{wrong} of {floor}");
    assert!(scan.rooms.iter().all(|r| r.entered && r.state() == Some(RoomState::Complete)));
}

#[test]
fn the_seed_decides() {
    let scan = |building: u64, seed| {
        let params =
            ScanParams { seed, furniture: 0.5, glass: 0.3, resolution: 0.1, ..ScanParams::default() };
        office(building).scan(&params).unwrap()
    };
    assert_eq!(scan(1, 1), scan(1, 1));
    assert_ne!(scan(1, 1).grid, scan(1, 2).grid);
    assert_ne!(scan(1, 1).grid, scan(2, 1).grid);
}

#[test]
fn what_is_unexplored_stays_unseen() {
    let building = corridor_with_rooms(10);
    let params = ScanParams { unexplored: 0.4, closed_doors: 1.0, ..ScanParams::default() };
    let scan = building.scan(&params).unwrap();
    let unseen = scan.rooms.iter().filter(|r| r.state().is_none()).count();
    assert_eq!(unseen, 4);
    assert!((scan.visited_share() - 7.0 / 11.0).abs() < 1e-9);
    let seen = scan.seen_layout(building.layout());
    assert_eq!((seen.rooms.len(), seen.openings.len()), (7, 6));
    assert!(seen.walls.len() < building.layout().walls.len());
}

#[test]
fn a_robot_that_stops_early_sees_rooms_in_part() {
    let building = corridor_with_rooms(10);
    let params = ScanParams { unexplored: 0.65, closed_doors: 0.0, ..ScanParams::default() };
    let scan = building.scan(&params).unwrap();
    assert_eq!(scan.rooms.iter().filter(|r| r.entered).count(), 4);
    let partial = scan.rooms.iter().filter(|r| r.state() == Some(RoomState::Partial)).count();
    let unseen = scan.rooms.iter().filter(|r| r.state().is_none()).count();
    assert!(partial >= 1 && unseen >= 3, "{:?}", scan.rooms);
}

#[test]
fn a_robot_that_explores_nothing_still_sees_its_own_room() {
    let params =
        ScanParams { unexplored: 1.0, closed_doors: 1.0, noise: Noise::none(), ..ScanParams::default() };
    let scan = two_rooms().scan(&params).unwrap();
    assert_eq!(scan.rooms.iter().map(|r| r.entered).collect::<Vec<_>>(), [true, false]);
    assert!(scan.rooms[0].seen > 0.95 && scan.rooms[1].seen == 0.0);
}

#[test]
fn furniture_and_noise_leave_their_marks() {
    let building = office(3);
    let occupied = |params: &ScanParams| {
        let grid = building.scan(params).unwrap().grid;
        grid.cells().iter().filter(|&&c| c == Cell::OCCUPIED).count()
    };
    let plain = occupied(&ScanParams { noise: Noise::none(), ..ScanParams::default() });
    let noisy = occupied(&ScanParams { noise: Noise::heavy(), ..ScanParams::default() });
    let furnished = occupied(&ScanParams { noise: Noise::none(), furniture: 0.8, ..ScanParams::default() });
    assert!(noisy as f64 > 1.05 * plain as f64, "{plain} {noisy}");
    assert!(furnished as f64 > 1.05 * plain as f64, "{plain} {furnished}");
}

#[test]
fn an_error_that_grows_bends_the_map() {
    let building = office(3);
    let grid = |growth_yaw| {
        let noise = Noise { growth_yaw, ..Noise::none() };
        building.scan(&ScanParams { noise, ..ScanParams::default() }).unwrap().grid
    };
    let (straight, bent) = (grid(0.0), grid(0.02));
    let pairs = || straight.cells().iter().zip(bent.cells());
    let walls = pairs().filter(|(s, _)| **s == Cell::OCCUPIED).count();
    let kept = pairs().filter(|(s, b)| **s == Cell::OCCUPIED && **b == Cell::OCCUPIED).count();
    assert!((kept as f64) < 0.6 * walls as f64, "{kept} of {walls}");
}

#[test]
fn glass_lets_rays_out() {
    let building = two_rooms();
    let clean = building.clean_grid(0.05).unwrap();
    let outside = |glass| {
        let params = ScanParams { noise: Noise::none(), glass, ..ScanParams::default() };
        let grid = building.scan(&params).unwrap().grid;
        let free_outside = |(c, s): &(&Cell, &Cell)| c.is_unknown() && **s == Cell::FREE;
        clean.cells().iter().zip(grid.cells()).filter(free_outside).count()
    };
    assert_eq!(outside(0.0), 0);
    assert!(outside(1.0) > 1000);
}

#[test]
fn probabilities_have_values_in_between() {
    let params = ScanParams { output: Output::Probabilities, ..ScanParams::default() };
    let grid = two_rooms().scan(&params).unwrap().grid;
    assert!(grid.cells().iter().any(|c| c.occupancy().is_some_and(|p| (10..90).contains(&p))));
}

#[test]
fn strange_parameters_are_survived() {
    let mut params =
        ScanParams { furniture: f64::NAN, unexplored: 7.0, glass: -1.0, ..ScanParams::default() };
    params.laser.rays = 0;
    params.laser.max_range = f64::NAN;
    params.laser.stride = -3.0;
    params.noise.range = f64::INFINITY;
    params.noise.drift_length = 0.0;
    params.noise.drift_yaw = f64::NAN;
    params.noise.growth_yaw = f64::NAN;
    params.noise.growth_position = f64::INFINITY;
    assert!(two_rooms().scan(&params).is_ok());
    params.resolution = -1.0;
    assert!(two_rooms().scan(&params).is_err());
}
