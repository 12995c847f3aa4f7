//! Rooms as they are painted on the lattice, before they have walls.

use crate::lattice::{Lattice, Rect};
use crate::params::RoomKind;

/// No room is narrower anywhere, nor has a shorter side, in cells.
const LEAST_WIDTH: i32 = 12;

/// One painted room. Its label is its index plus one.
pub(crate) struct DraftRoom {
    pub(crate) kind: RoomKind,
    /// The room through which alone it shall be reached.
    pub(crate) access: Option<usize>,
    /// A rectangle that holds all of it.
    pub(crate) frame: Rect,
}

/// The painted rooms.
pub(crate) struct Draft {
    pub(crate) lattice: Lattice,
    pub(crate) rooms: Vec<DraftRoom>,
}

impl Draft {
    pub(crate) fn new(width: i32, height: i32) -> Self {
        Self { lattice: Lattice::new(width, height), rooms: Vec::new() }
    }

    fn next_label(&self) -> u16 {
        self.rooms.len() as u16 + 1
    }

    fn push(&mut self, frame: Rect, kind: RoomKind, access: Option<usize>) -> usize {
        self.rooms.push(DraftRoom { kind, access, frame });
        self.rooms.len() - 1
    }

    /// Paints what is empty of the rectangle, unless that makes no sound room.
    pub(crate) fn add(&mut self, rect: Rect, kind: RoomKind) -> Option<usize> {
        let label = self.next_label();
        self.lattice.repaint(rect, 0, label);
        if !self.lattice.is_sound(rect, label, LEAST_WIDTH) {
            self.lattice.repaint(rect, label, 0);
            return None;
        }
        Some(self.push(rect, kind, None))
    }

    /// Paints the rectangles as one corridor, whatever its shape.
    pub(crate) fn add_corridor(&mut self, rects: &[Rect]) -> usize {
        let label = self.next_label();
        for &rect in rects {
            self.lattice.repaint(rect, 0, label);
        }
        self.push(bounding(rects), RoomKind::Corridor, None)
    }

    /// Gives what is empty of the rectangle to a corridor.
    pub(crate) fn widen(&mut self, corridor: usize, rect: Rect) {
        self.lattice.repaint(rect, 0, corridor as u16 + 1);
        if let Some(room) = self.rooms.get_mut(corridor) {
            room.frame = bounding(&[room.frame, rect]);
        }
    }

    /// Gives a part of one room to another, if both stay sound.
    pub(crate) fn annex(&mut self, to: usize, from: usize, rect: Rect) -> bool {
        let frames = [to, from].map(|i| self.rooms.get(i).map(|r| r.frame));
        let [Some(a), Some(b)] = frames else { return false };
        let (new, old) = (to as u16 + 1, from as u16 + 1);
        self.lattice.repaint(rect, old, new);
        let frame = bounding(&[a, rect]);
        let sound =
            self.lattice.is_sound(frame, new, LEAST_WIDTH) && self.lattice.is_sound(b, old, LEAST_WIDTH);
        if sound {
            self.rooms[to].frame = frame;
        } else {
            self.lattice.repaint(rect, new, old);
        }
        sound
    }

    /// Makes a rectangle of the room `parent` a room of its own, if both stay sound.
    pub(crate) fn carve(
        &mut self,
        parent: usize,
        rect: Rect,
        kind: RoomKind,
        access: Option<usize>,
    ) -> Option<usize> {
        let (label, old) = (self.next_label(), parent as u16 + 1);
        let frame = self.rooms.get(parent)?.frame;
        self.lattice.repaint(rect, old, label);
        let sound =
            self.lattice.is_sound(rect, label, LEAST_WIDTH) && self.lattice.is_sound(frame, old, LEAST_WIDTH);
        if !sound {
            self.lattice.repaint(rect, label, old);
            return None;
        }
        Some(self.push(rect, kind, access))
    }
}

fn bounding(rects: &[Rect]) -> Rect {
    let join = |a: Rect, b: &Rect| Rect::new(a.x0.min(b.x0), a.y0.min(b.y0), a.x1.max(b.x1), a.y1.max(b.y1));
    rects.iter().fold(Rect::new(i32::MAX, i32::MAX, i32::MIN, i32::MIN), join)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_room_takes_only_what_is_empty() {
        let mut draft = Draft::new(100, 100);
        draft.add(Rect::new(0, 0, 30, 30), RoomKind::Room).unwrap();
        let second = draft.add(Rect::new(15, 0, 50, 30), RoomKind::Room).unwrap();
        let rings = draft.lattice.trace(draft.rooms[second].frame, 2);
        assert_eq!(rings, [vec![(30, 0), (50, 0), (50, 30), (30, 30)]]);
        assert!(draft.add(Rect::new(0, 0, 30, 35), RoomKind::Room).is_none(), "half a metre is no room");
        assert!(draft.lattice.is_empty(Rect::new(0, 30, 30, 35)));
    }

    #[test]
    fn a_carved_room_leaves_a_sound_parent() {
        let mut draft = Draft::new(100, 100);
        let parent = draft.add(Rect::new(0, 0, 60, 60), RoomKind::Room).unwrap();
        assert!(draft.carve(parent, Rect::new(0, 40, 20, 60), RoomKind::Small, Some(parent)).is_some());
        assert!(draft.carve(parent, Rect::new(20, 0, 55, 60), RoomKind::Room, None).is_none());
    }
}
