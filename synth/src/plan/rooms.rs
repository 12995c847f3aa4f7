//! What the rooms are for, and what they are called.

use super::drawing::Drawing;
use super::look::Numbers;
use super::truth::PlanName;
use crate::furniture::extent;
use crate::params::RoomKind;
use crate::rng::Rng;
use planform_sdk::{Room, RoomId};

/// What a room is for: decides what stands in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    Corridor,
    Office,
    Meeting,
    Bedroom,
    Living,
    Kitchen,
    Wet,
    Store,
    Stairs,
    Lift,
    Hall,
}

const OFFICES: [&str; 10] = [
    "Office",
    "Archive",
    "Library",
    "Reception",
    "Print Room",
    "Laboratory",
    "Workshop",
    "Secretary",
    "Accounts",
    "Director",
];
const MEETINGS: [&str; 5] = ["Meeting Room", "Conference", "Training", "Board Room", "Break Room"];
const CORRIDORS: [&str; 4] = ["Corridor", "Hall", "Lobby", "Foyer"];
const STORES: [&str; 5] = ["Store", "Closet", "Server", "Plant", "Utility"];
const WET: [&str; 4] = ["WC", "Toilet", "Bath", "Men"];

/// What each room is for, in the layout's order; the truth's names are made as well.
pub(super) fn plan(drawing: &mut Drawing) -> Vec<Purpose> {
    let dwelling = drawing.site.layout.rooms.len() <= 8;
    let rooms = drawing.site.layout.rooms.clone();
    let mut used = Used::default();
    let purposes: Vec<Purpose> = rooms
        .iter()
        .map(|room| purpose(drawing.site.kind(room), room, dwelling, &mut used, &mut drawing.rng))
        .collect();
    let mut counts = Counts { storey: drawing.rng.int((0, 3)), ..Counts::default() };
    for (room, &purpose) in rooms.iter().zip(&purposes) {
        let name = name(drawing, room.id, purpose, dwelling, &mut counts);
        drawing.names.push(name);
    }
    purposes
}

/// What there is once in a plan.
#[derive(Default)]
struct Used {
    stairs: bool,
    lift: bool,
    kitchen: bool,
    living: bool,
}

impl Used {
    fn first(flag: &mut bool) -> bool {
        !std::mem::replace(flag, true)
    }
}

fn purpose(kind: RoomKind, room: &Room, dwelling: bool, used: &mut Used, rng: &mut Rng) -> Purpose {
    let (long, short) =
        extent(&room.inner.exterior).map_or((0.0, 0.0), |e| (e.size.0.max(e.size.1), e.size.0.min(e.size.1)));
    let area = room.area();
    match kind {
        RoomKind::Corridor => Purpose::Corridor,
        RoomKind::Hall => Purpose::Hall,
        RoomKind::Small
            if area < 7.5 && short > 1.3 && long < 3.4 && !dwelling && Used::first(&mut used.lift) =>
        {
            Purpose::Lift
        }
        RoomKind::Small if rng.chance(0.65) && short > 1.1 => Purpose::Wet,
        RoomKind::Small => Purpose::Store,
        RoomKind::Room
            if short > 2.3
                && area < 28.0
                && rng.chance(if dwelling { 0.2 } else { 0.5 })
                && Used::first(&mut used.stairs) =>
        {
            Purpose::Stairs
        }
        RoomKind::Room if dwelling => dwelling_room(area, used, rng),
        RoomKind::Room if area < 9.0 && rng.chance(0.5) => Purpose::Wet,
        RoomKind::Room if rng.chance(0.12) && Used::first(&mut used.kitchen) => Purpose::Kitchen,
        RoomKind::Room if area > 18.0 && rng.chance(0.3) => Purpose::Meeting,
        RoomKind::Room => Purpose::Office,
    }
}

fn dwelling_room(area: f64, used: &mut Used, rng: &mut Rng) -> Purpose {
    if area < 7.0 {
        Purpose::Wet
    } else if area > 13.0 && Used::first(&mut used.living) {
        Purpose::Living
    } else if rng.chance(0.5) && Used::first(&mut used.kitchen) {
        Purpose::Kitchen
    } else {
        Purpose::Bedroom
    }
}

/// How many rooms have a name or a number so far.
#[derive(Default)]
struct Counts {
    storey: i32,
    rooms: i32,
    offices: i32,
}

fn name(
    drawing: &mut Drawing,
    room: RoomId,
    purpose: Purpose,
    dwelling: bool,
    counts: &mut Counts,
) -> PlanName {
    let rng = &mut drawing.rng;
    let word = match purpose {
        Purpose::Corridor => CORRIDORS[rng.index(4)],
        Purpose::Office => OFFICES[if rng.chance(0.55) { 0 } else { rng.index(10) }],
        Purpose::Meeting => MEETINGS[rng.index(5)],
        Purpose::Bedroom => ["Bedroom", "Bedroom", "Study", "Guest Room", "Nursery"][rng.index(5)],
        Purpose::Living => ["Living Room", "Lounge", "Dining Room"][rng.index(3)],
        Purpose::Kitchen => "Kitchen",
        Purpose::Wet => WET[rng.index(if dwelling { 3 } else { 4 })],
        Purpose::Store => STORES[rng.index(5)],
        Purpose::Stairs => ["Stairs", "Staircase"][rng.index(2)],
        Purpose::Lift => "Lift",
        Purpose::Hall => ["Assembly Hall", "Gym", "Auditorium"][rng.index(3)],
    };
    let mut word = word.to_owned();
    counts.rooms += 1;
    if word == "Office" && drawing.look.numbers == Numbers::None {
        counts.offices += 1;
        word = format!("{word} {}", counts.offices);
    }
    if drawing.look.upper_case {
        word = word.to_uppercase();
    }
    let numbered = drawing.look.numbers != Numbers::None && purpose != Purpose::Lift;
    let number = numbered.then(|| match drawing.look.numbers {
        Numbers::Circled => counts.rooms.to_string(),
        _ if dwelling => format!("{:02}", counts.rooms),
        _ => format!("{}{:02}", counts.storey + 1, counts.rooms),
    });
    let alone = drawing.look.numbers == Numbers::Alone && purpose != Purpose::Lift;
    PlanName { room, name: (!alone).then_some(word), number, area: None }
}
