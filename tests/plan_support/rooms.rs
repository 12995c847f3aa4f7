//! Whether the rooms and their names were found.

use super::words::words;
use super::{Count, scaled};
use planform::evaluate::{Clip, RoomShape, Settings, evaluate_rooms};
use planform_sdk::{Layout, Point, Polygon, Room, RoomId};
use planform_synth::{PlanName, PlanTextRole, PlanTruth};

/// The rooms of a plan.
#[derive(Debug, Clone, Copy, Default)]
pub struct Rooms {
    pub names: Count,
    pub a_fc: f64,
    pub a_bc: f64,
}

impl Rooms {
    /// Compares what was found, its coordinates times the factor, with the truth.
    pub fn compare(found: &Layout, truth: &PlanTruth, factor: f64) -> Self {
        let found: Vec<Room> = found.rooms.iter().map(|r| room(r, factor)).collect();
        let named = |n: &&PlanName| n.name.is_some() || n.number.is_some();
        let names: Vec<&PlanName> = truth.names.iter().filter(named).collect();
        let right = names.iter().filter(|n| is_named(&found, truth, n)).count();
        let names = Count { right, all: names.len() };
        let scores = evaluate_rooms(shapes(&found), shapes(&truth.layout.rooms), &Settings::default());
        let scores = scores.map(|s| s.get(Clip::Known).measures).unwrap_or_default();
        Self { names, a_fc: scores.a_fc, a_bc: scores.a_bc }
    }
}

fn room(room: &Room, factor: f64) -> Room {
    let ring = |r: &Vec<Point>| r.iter().map(|p| scaled(p.x, p.y, factor)).collect();
    let polygon =
        |p: &Polygon| Polygon { exterior: ring(&p.exterior), holes: p.holes.iter().map(ring).collect() };
    Room { inner: polygon(&room.inner), centre: polygon(&room.centre), ..room.clone() }
}

fn shapes(rooms: &[Room]) -> Vec<RoomShape> {
    rooms.iter().map(|r| RoomShape { name: r.id.to_string(), parts: vec![r.centre.clone()] }).collect()
}

/// Whether the found room in which the label stands has its name, its number, or both.
fn is_named(found: &[Room], truth: &PlanTruth, name: &PlanName) -> bool {
    let Some(label) = label(truth, name.room) else { return false };
    let Some(room) = found.iter().find(|r| r.centre.contains(label)) else { return false };
    let read = words(room.name.as_deref().unwrap_or_default());
    let (called, number) = (of(&name.name), of(&name.number));
    let joined = |first: &[String], second: &[String]| [first, second].concat();
    !read.is_empty()
        && [called.clone(), number.clone(), joined(&called, &number), joined(&number, &called)]
            .contains(&read)
}

fn of(text: &Option<String>) -> Vec<String> {
    words(text.as_deref().unwrap_or_default())
}

/// Where the first line of a room's label stands.
fn label(truth: &PlanTruth, room: RoomId) -> Option<Point> {
    let is_label = |role| matches!(role, PlanTextRole::Name | PlanTextRole::Number);
    let text = truth.texts.iter().find(|t| t.room == Some(room) && is_label(t.role))?;
    Some(Point::new(text.pose.x, text.pose.y))
}
