//! Small plans made here, and what is found in them.

use super::*;
use crate::found::SheetLeaf;
use crate::stages::Unwatched;
use image::{GrayImage, RgbImage};

/// A sheet of 20 x 14 m, a pixel is 0.05 m.
const WIDTH: u32 = 400;
const HEIGHT: u32 = 280;

struct Plan(Mask);

impl Plan {
    /// Two rooms with walls this thick, a door of 0.9 m between them.
    fn of_two_rooms(thick: u32) -> Self {
        let mut plan = Self(Mask::empty(WIDTH, HEIGHT));
        plan.bar([60, 60], [340, 60 + thick]);
        plan.bar([60, 220], [340, 220 + thick]);
        plan.bar([60, 60], [60 + thick, 220]);
        plan.bar([340, 60], [340 + thick, 220 + thick]);
        plan.bar([200, 60], [200 + thick, 131]);
        plan.bar([200, 149], [200 + thick, 220]);
        plan
    }

    fn bar(&mut self, low: [u32; 2], high: [u32; 2]) {
        for y in low[1]..high[1] {
            (low[0]..high[0]).for_each(|x| self.0.set[(y * WIDTH + x) as usize] = true);
        }
    }

    /// The outline of a rectangle, one pixel thin.
    fn frame(&mut self, low: [u32; 2], high: [u32; 2]) {
        self.bar(low, [high[0], low[1] + 1]);
        self.bar([low[0], high[1] - 1], high);
        self.bar(low, [low[0] + 1, high[1]]);
        self.bar([high[0] - 1, low[1]], high);
    }

    fn walls(&self, symbols: &[SheetSymbol]) -> Walls {
        let sheet = Sheet {
            colour: RgbImage::new(WIDTH, HEIGHT),
            grey: GrayImage::new(WIDTH, HEIGHT),
            ink: self.0.clone(),
            aside: Mask::empty(WIDTH, HEIGHT),
            turned: 0.0,
            page_size: [WIDTH, HEIGHT],
        };
        find(&self.0, &sheet, Read { texts: &[], symbols }, Some(0.05), &mut Unwatched)
    }
}

#[test]
fn thick_walls_stay_and_their_door_is_open() {
    let walls = Plan::of_two_rooms(4).walls(&[]);
    assert!(walls.occupied.get(202, 100) && walls.occupied.get(62, 150));
    assert!(!walls.occupied.get(202, 140));
    assert!(walls.inside.get(100, 150) && walls.inside.get(300, 150) && !walls.inside.get(30, 150));
    assert_eq!(walls.thickness.round(), 3.0);
}

#[test]
fn thin_walls_stay_if_that_is_all_there_is() {
    let walls = Plan::of_two_rooms(1).walls(&[]);
    assert!(walls.occupied.get(200, 100) && walls.occupied.get(200, 180) && walls.occupied.get(60, 150));
    assert!(walls.inside.get(100, 150));
}

#[test]
fn a_desk_at_the_wall_is_none() {
    let mut plan = Plan::of_two_rooms(4);
    plan.frame([64, 100], [80, 132]);
    let walls = plan.walls(&[]);
    assert!(!walls.occupied.get(79, 110) && !walls.occupied.get(70, 100));
    assert!(walls.occupied.get(62, 110));
}

#[test]
fn a_glass_wall_drawn_thin_is_one() {
    let mut plan = Plan::of_two_rooms(4);
    plan.bar([130, 64], [131, 220]);
    assert!(plan.walls(&[]).occupied.get(130, 150));
}

#[test]
fn two_thin_lines_become_solid() {
    let mut plan = Plan(Mask::empty(WIDTH, HEIGHT));
    plan.frame([60, 60], [340, 220]);
    plan.frame([65, 65], [335, 215]);
    let walls = plan.walls(&[]);
    assert!(walls.occupied.get(62, 150) && walls.occupied.get(200, 62));
    assert!(!walls.occupied.get(200, 150) && walls.inside.get(200, 150));
}

#[test]
fn known_doors_are_open_and_known_windows_closed() {
    let mut plan = Plan::of_two_rooms(4);
    plan.bar([200, 131], [204, 149]);
    (60..64).for_each(|y| (100..120).for_each(|x| plan.0.set[y * WIDTH as usize + x] = false));
    let leaf = SheetLeaf { hinge: [202.0, 131.0], closed: [202.0, 149.0], open: [184.0, 131.0] };
    let symbol = |kind: &str, centre, angle, leaves| SheetSymbol {
        kind: kind.to_owned(),
        centre,
        angle,
        width: 20.0,
        height: 4.0,
        score: 1.0,
        leaves,
    };
    let door = symbol("door", [202.0, 140.0], std::f64::consts::FRAC_PI_2, vec![leaf]);
    let window = symbol("window", [110.0, 62.0], 0.0, Vec::new());
    let walls = plan.walls(&[door, window]);
    assert!(!walls.occupied.get(202, 140) && walls.occupied.get(110, 62));
}

#[test]
fn an_empty_sheet_has_no_walls() {
    let walls = Plan(Mask::empty(WIDTH, HEIGHT)).walls(&[]);
    assert_eq!((walls.occupied.count(), walls.inside.count(), walls.confidence), (0, 0, 0.0));
}

#[test]
fn a_sheet_of_ink_is_survived() {
    let mut plan = Plan(Mask::empty(WIDTH, HEIGHT));
    plan.bar([0, 0], [WIDTH, HEIGHT]);
    assert_eq!(plan.walls(&[]).confidence, 0.0);
}

#[test]
fn cells_keep_the_frame_and_thin_walls() {
    let walls = Plan::of_two_rooms(1).walls(&[]);
    let cells = cells(&walls, 0.02);
    assert_eq!((cells.pixels, cells.columns, cells.rows), (3, 134, 94));
    assert!((cells.resolution - 0.06).abs() < 1e-12);
    let at = |x: u32, y: u32| cells.cells[((HEIGHT - 1 - y) / 3 * cells.columns + x / 3) as usize];
    assert_eq!(at(200, 100), planform_sdk::Cell::OCCUPIED);
    assert_eq!(at(100, 150), planform_sdk::Cell::FREE);
    assert_eq!(at(10, 10), planform_sdk::Cell::UNKNOWN);
}
