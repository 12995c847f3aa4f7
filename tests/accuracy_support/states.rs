//! Whether rooms are known to be complete or partial, while a building is explored.

use super::shapes;
use planform::evaluate::{Settings, evaluate_rooms};
use planform_sdk::{Layout, RoomState};
use planform_synth::RoomView;
use std::iter::Sum;

/// A room of which at least this share of the floor was seen is complete.
pub const WHOLE: f64 = 0.95;

/// What was right, counted over true rooms of which something was seen.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    /// Complete rooms, and how many of these the layout calls so.
    pub complete: usize,
    pub right_complete: usize,
    /// Partial rooms, and how many of these the layout calls so.
    pub partial: usize,
    pub right_partial: usize,
    /// Rooms that no room of the layout matches, which are wrong.
    pub missed: usize,
    /// Sum of the partial rooms' intersection over union with their matches in the layout.
    iou_of_partial: f64,
    /// Sum of the shares of the partial rooms that were seen.
    seen_of_partial: f64,
}

impl Tally {
    /// Compares a layout with the whole building. A true room's counterpart is the room matched with it one to one, as
    /// for mIoU; a room without one counts as wrong, and with an intersection over union of 0.
    pub fn of(found: &Layout, building: &Layout, views: &[RoomView]) -> Self {
        let mut truth = building.clone();
        truth.rooms.retain(|r| views.iter().any(|v| v.room == r.id && v.state().is_some()));
        let scores = evaluate_rooms(shapes(found), shapes(&truth), &Settings::default()).unwrap();
        let state = |name: &str| found.rooms.iter().find(|r| r.id.to_string() == name).map(|r| r.state);
        let mut tally = Self::default();
        for room in scores.raw.rooms {
            let view = views.iter().find(|v| v.room.to_string() == room.room).unwrap();
            tally.add(view.seen, room.prediction.as_deref().and_then(state), room.iou);
        }
        tally
    }

    fn add(&mut self, seen: f64, found: Option<RoomState>, iou: f64) {
        self.missed += usize::from(found.is_none());
        if seen >= WHOLE {
            self.complete += 1;
            self.right_complete += usize::from(found == Some(RoomState::Complete));
        } else {
            self.partial += 1;
            self.right_partial += usize::from(found == Some(RoomState::Partial));
            self.iou_of_partial += iou;
            self.seen_of_partial += seen;
        }
    }

    /// Share of the rooms whose state is right.
    pub fn right(&self) -> f64 {
        (self.right_complete + self.right_partial) as f64 / (self.complete + self.partial) as f64
    }

    pub fn complete_right(&self) -> f64 {
        self.right_complete as f64 / self.complete as f64
    }

    pub fn partial_right(&self) -> f64 {
        self.right_partial as f64 / self.partial as f64
    }

    /// Mean intersection over union of partial rooms with their whole true shape.
    pub fn iou(&self) -> f64 {
        self.iou_of_partial / self.partial as f64
    }

    /// Mean share of partial rooms that was seen.
    pub fn seen(&self) -> f64 {
        self.seen_of_partial / self.partial as f64
    }
}

impl<'a> Sum<&'a Tally> for Tally {
    fn sum<I: Iterator<Item = &'a Tally>>(tallies: I) -> Self {
        tallies.fold(Self::default(), |a, b| Self {
            complete: a.complete + b.complete,
            right_complete: a.right_complete + b.right_complete,
            partial: a.partial + b.partial,
            right_partial: a.right_partial + b.right_partial,
            missed: a.missed + b.missed,
            iou_of_partial: a.iou_of_partial + b.iou_of_partial,
            seen_of_partial: a.seen_of_partial + b.seen_of_partial,
        })
    }
}
