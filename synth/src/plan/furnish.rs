//! Furniture, drawn in thin lines.

use super::drawing::{Drawing, block};
use super::fixtures::{counter, round_table};
use super::places::{against_wall, anywhere};
use super::rooms::Purpose;
use super::surface::{Colour, WHITE, arc};
use crate::furniture::Block;
use planform_sdk::Room;
use std::f64::consts::{PI, TAU};

/// How a chair is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Chair {
    Box,
    Round,
    Backed,
}

struct Furnisher<'a> {
    drawing: &'a mut Drawing,
    chair: Chair,
    /// Floor of furniture, if it is coloured.
    fill: Option<Colour>,
}

pub(super) fn draw(drawing: &mut Drawing, purposes: &[Purpose]) {
    let density = drawing.look.furniture;
    let rooms = drawing.site.layout.rooms.clone();
    let chair = [Chair::Box, Chair::Round, Chair::Backed][drawing.rng.index(3)];
    let fill = [None, Some(WHITE), Some([238, 232, 220])][drawing.rng.index(3)];
    for (room, &purpose) in rooms.iter().zip(purposes) {
        if drawing.rng.chance(density) {
            Furnisher { drawing, chair, fill }.furnish(room, purpose);
        }
    }
}

impl Furnisher<'_> {
    fn furnish(&mut self, room: &Room, purpose: Purpose) {
        match purpose {
            Purpose::Office => self.office(room),
            Purpose::Meeting => self.meeting(room),
            Purpose::Bedroom => self.bedroom(room),
            Purpose::Living => self.living(room),
            Purpose::Kitchen => {
                counter(self.drawing, room);
                self.round_table(room);
            }
            Purpose::Store => self.cupboards(room, 3),
            Purpose::Hall => self.meeting(room),
            Purpose::Corridor | Purpose::Wet | Purpose::Stairs | Purpose::Lift => {}
        }
    }

    fn outline(&mut self, ring: &[planform_sdk::Point]) {
        let thin = self.drawing.thin();
        self.drawing.picture.shape(ring, self.fill, thin);
    }

    fn office(&mut self, room: &Room) {
        let count = (room.area() / 5.0).clamp(1.0, 9.0) as u32;
        for _ in 0..count {
            let (wide, deep) = (self.drawing.rng.range((1.3, 1.8)), self.drawing.rng.range((0.7, 0.85)));
            let place = if self.drawing.rng.chance(0.6) {
                against_wall(self.drawing, room, (wide, deep + 0.75), 0.02, Drawing::put)
            } else {
                anywhere(self.drawing, room, (wide, deep + 0.75), 0.05, Drawing::put)
            };
            let Some(place) = place else { continue };
            let desk = block(place.at(0.0, -place.half_depth + deep / 2.0), place.along, wide, deep);
            self.outline(&desk.corners());
            if self.drawing.rng.chance(0.5) {
                let screen = block(desk.at(0.0, -deep * 0.25), place.along, 0.5, 0.12);
                self.outline(&screen.corners());
            }
            self.chair(&block(place.at(0.0, place.half_depth - 0.3), place.along, 0.5, 0.5));
        }
        self.cupboards(room, 2);
    }

    /// Someone sits there and looks to the lower side of the block.
    fn chair(&mut self, place: &Block) {
        let (l, d) = (place.half_length, place.half_depth);
        match self.chair {
            Chair::Box => self.outline(&place.corners()),
            Chair::Round => self.outline(&arc(|u, v| place.at(l * 0.9 * u, d * 0.9 * v), 0.0, TAU)),
            Chair::Backed => {
                let seat = Block { half_length: l * 0.8, half_depth: d * 0.8, ..*place };
                self.outline(&seat.corners());
                let thin = self.drawing.thin();
                let back = arc(|u, v| place.at(l * u, d * 0.4 + d * 0.6 * v), 0.0, PI);
                self.drawing.picture.line(&back, thin);
            }
        }
    }

    /// A long table with chairs on both sides.
    fn meeting(&mut self, room: &Room) {
        let (long, deep) = (self.drawing.rng.range((1.8, 4.0)), self.drawing.rng.range((0.9, 1.3)));
        let place = anywhere(self.drawing, room, (long, deep + 1.3), 0.1, Drawing::put);
        let Some(place) = place else { return self.round_table(room) };
        let table = block(place.middle, place.along, long, deep);
        self.outline(&table.corners());
        for i in 0..(long / 0.7) as i32 {
            let u = -long / 2.0 + 0.4 + 0.7 * f64::from(i);
            let (x, y) = place.along;
            let v = deep / 2.0 + 0.32;
            self.chair(&block(place.at(u, v), (x, y), 0.45, 0.45));
            self.chair(&block(place.at(u, -v), (-x, -y), 0.45, 0.45));
        }
    }

    fn round_table(&mut self, room: &Room) {
        let radius = self.drawing.rng.range((0.4, 0.6));
        let Some(place) = round_table(self.drawing, room, radius) else { return };
        let count = 2 + self.drawing.rng.index(3);
        for i in 0..count {
            let angle = TAU * i as f64 / count as f64;
            let (sin, cos) = angle.sin_cos();
            let middle = place.at((radius + 0.27) * sin, (radius + 0.27) * cos);
            let (x, y) = place.along;
            self.chair(&block(middle, (x * cos + y * sin, y * cos - x * sin), 0.42, 0.42));
        }
    }

    fn bedroom(&mut self, room: &Room) {
        let double = self.drawing.rng.chance(0.6);
        let wide = if double { self.drawing.rng.range((1.5, 1.8)) } else { 0.95 };
        if let Some(place) = against_wall(self.drawing, room, (wide, 2.05), 0.05, Drawing::put) {
            self.outline(&place.corners());
            let pillows = if double { vec![-wide / 4.0, wide / 4.0] } else { vec![0.0] };
            for u in pillows {
                let pillow = block(place.at(u, -place.half_depth + 0.28), place.along, 0.6, 0.35);
                self.outline(&pillow.corners());
            }
            let thin = self.drawing.thin();
            let (l, v) = (place.half_length, -place.half_depth + 0.6);
            self.drawing.picture.line(&[place.at(-l, v), place.at(l, v)], thin);
        }
        self.cupboards(room, 2);
    }

    fn living(&mut self, room: &Room) {
        if let Some(place) = against_wall(self.drawing, room, (2.0, 1.7), 0.05, Drawing::put) {
            let v = -place.half_depth + 0.43;
            let sofa = block(place.at(0.0, v), place.along, 2.0, 0.86);
            self.outline(&sofa.corners());
            for i in 0..3 {
                let seat = block(sofa.at(-0.54 + 0.54 * f64::from(i), 0.1), place.along, 0.54, 0.6);
                self.outline(&seat.corners());
            }
            self.outline(&block(place.at(0.0, place.half_depth - 0.3), place.along, 1.0, 0.5).corners());
        }
        self.round_table(room);
        self.cupboards(room, 1);
    }

    fn cupboards(&mut self, room: &Room, most: usize) {
        for _ in 0..self.drawing.rng.index(most + 1) {
            let (wide, deep) = (self.drawing.rng.range((0.8, 1.8)), self.drawing.rng.range((0.35, 0.6)));
            if let Some(place) = against_wall(self.drawing, room, (wide, deep), 0.02, Drawing::put) {
                self.outline(&place.corners());
            }
        }
    }
}
