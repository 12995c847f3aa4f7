//! What the robustness benchmark counts and writes.
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod accuracy_support;
#[path = "../benches/robustness/page.rs"]
mod page;

use accuracy_support::states::Tally;
use accuracy_support::{for_seeds, layout_of, shapes};
use planform::evaluate::{Settings, evaluate_rooms};
use planform_sdk::{Layout, RoomState};
use planform_synth::{Building, BuildingParams, RoomView, ScanParams, Size, two_rooms};

/// What was seen of the two rooms.
fn views(seen: [f64; 2]) -> Vec<RoomView> {
    seen.into_iter().zip(1..).map(|(seen, room)| RoomView { room, entered: true, seen }).collect()
}

/// The two rooms with these states.
fn found(states: [RoomState; 2]) -> Layout {
    let mut layout = two_rooms().layout().clone();
    layout.rooms.iter_mut().zip(states).for_each(|(room, state)| room.state = state);
    layout
}

fn tally(states: [RoomState; 2], seen: [f64; 2]) -> Tally {
    Tally::of(&found(states), two_rooms().layout(), &views(seen))
}

const COMPLETE: RoomState = RoomState::Complete;
const PARTIAL: RoomState = RoomState::Partial;

#[test]
fn a_state_is_right_when_the_layout_says_what_was_seen() {
    assert_eq!(tally([COMPLETE, PARTIAL], [1.0, 0.94]).right(), 1.0);
    assert_eq!(tally([PARTIAL, COMPLETE], [1.0, 0.94]).right(), 0.0);
    let half = tally([COMPLETE, COMPLETE], [0.95, 0.5]);
    assert_eq!((half.complete_right(), half.partial_right(), half.right()), (1.0, 0.0, 0.5));
}

#[test]
fn rooms_that_nothing_was_seen_of_do_not_count() {
    let one = tally([COMPLETE, PARTIAL], [1.0, 0.01]);
    assert_eq!((one.complete, one.partial, one.right()), (1, 0, 1.0));
    assert!(one.iou().is_nan());
}

#[test]
fn a_room_that_was_not_found_is_wrong() {
    let mut layout = found([COMPLETE, PARTIAL]);
    layout.rooms.pop();
    let tally = Tally::of(&layout, two_rooms().layout(), &views([1.0, 0.5]));
    assert_eq!((tally.missed, tally.right(), tally.iou(), tally.seen()), (1, 0.5, 0.0, 0.5));
}

#[test]
fn a_partial_room_is_compared_with_its_whole_shape() {
    let mut layout = found([COMPLETE, PARTIAL]);
    // Room 2 lies between x = 4 and x = 8; a layout that closes it at 6 has half of it.
    for p in &mut layout.rooms[1].centre.exterior {
        p.x = p.x.min(6.0);
    }
    let tally = Tally::of(&layout, two_rooms().layout(), &views([1.0, 0.4]));
    assert!((tally.iou() - 0.5).abs() < 0.01, "{}", tally.iou());
}

#[test]
fn tallies_add_up() {
    let tallies = [tally([COMPLETE, PARTIAL], [1.0, 0.2]), tally([COMPLETE, COMPLETE], [1.0, 0.6])];
    let sum: Tally = tallies.iter().sum();
    assert_eq!((sum.complete, sum.partial, sum.right(), sum.seen()), (2, 2, 0.75, 0.4));
}

/// Shares of the rooms that the robot has entered when it stops.
const ENTERED: [f64; 4] = [0.3, 0.5, 0.7, 0.9];

/// A building that was entered in part, all doors open.
fn explored(job: u64) -> Tally {
    let (seed, entered) = (job / ENTERED.len() as u64 + 1, ENTERED[job as usize % ENTERED.len()]);
    let size = [Size::House, Size::Office, Size::School][(seed % 3) as usize];
    let building = Building::generate(seed, &BuildingParams::of_size(size));
    let params = ScanParams { seed, unexplored: 1.0 - entered, closed_doors: 0.0, ..ScanParams::default() };
    let scan = building.scan(&params).unwrap();
    Tally::of(&layout_of(scan.grid), building.layout(), &scan.rooms)
}

#[test]
fn partial_rooms_are_told_and_completed() {
    let tallies = for_seeds(0..6 * ENTERED.len() as u64, explored);
    let all: Tally = tallies.iter().sum();
    println!("right {:.3}, IoU of partial rooms {:.3}: {all:?}", all.right(), all.iou());
    assert!(all.right() >= 0.9, "{all:?}");
    assert!(all.complete_right() >= 0.9 && all.partial_right() >= 0.65, "{all:?}");
    assert!(all.iou() >= 0.6, "{all:?}");
}

#[test]
fn rooms_are_compared_without_files() {
    let truth = two_rooms();
    let mut merged = shapes(truth.layout());
    let second = merged.pop().unwrap();
    merged[0].parts.extend(second.parts);
    let scores = evaluate_rooms(merged, shapes(truth.layout()), &Settings::default()).unwrap();
    let m = scores.clipped.measures;
    assert!((m.precision - 0.5).abs() < 0.01 && (m.recall - 1.0).abs() < 1e-9, "{m:?}");
    let useless = Settings { resolution: Some(0.0), ..Settings::default() };
    assert!(evaluate_rooms(vec![], vec![], &useless).is_err());
}

#[test]
fn only_what_is_between_the_markers_changes() {
    let page = "a\n<!-- x:begin -->\nold\n<!-- x:end -->\nb\n";
    let new = page::between(page, "x", "new\n").unwrap();
    assert_eq!(new, "a\n<!-- x:begin -->\n\nnew\n\n<!-- x:end -->\nb\n");
    assert_eq!(page::between(&new, "x", "new\n").unwrap(), new);
    assert!(page::between(page, "y", "new").unwrap_err().contains("<!-- y:begin -->"));
    assert!(page::between("<!-- x:end --><!-- x:begin -->", "x", "new").is_err());
}

#[test]
fn tables_have_a_cell_for_each_column() {
    let text = page::table(&["a".into(), "b".into()], &[vec!["1".into(), page::percent(0.5)]]);
    assert_eq!(text, "| a | b |\n| ---: | ---: |\n| 1 | 50.0 |\n");
    assert_eq!(page::percent(f64::NAN), "-");
}
