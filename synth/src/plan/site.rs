//! The building on its sheet.

use crate::building::Building;
use crate::params::{BuildingParams, RoomKind, Size};
use crate::raster::band;
use crate::rng::Rng;
use crate::variety::Variety;
use planform_sdk::{Layout, Point, Polygon, Room, RoomId, bounds};
use std::f64::consts::FRAC_PI_2;

/// A building, moved to its place on the sheet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Site {
    pub(super) layout: Layout,
    kinds: Vec<RoomKind>,
    /// The thickness of the wall around each opening.
    pub(super) depths: Vec<f64>,
    pub(super) solids: Vec<Polygon>,
}

/// The building of a plan. Where nothing else tells the scale, doors are 0.9 m wide.
pub(super) fn building(seed: u64, tells_scale: bool, rng: &mut Rng) -> Building {
    let size = if rng.chance(0.35) { Size::House } else { Size::Office };
    let door = if tells_scale { rng.range((0.78, 1.0)) } else { 0.89 };
    let inner = rng.range((0.1, 0.18));
    let params = BuildingParams {
        single_door: (door, door + if tells_scale { 0.12 } else { 0.02 }),
        double_door: (1.5, 2.0),
        inner_wall: (inner, inner + rng.range((0.0, 0.12))),
        outer_wall: (0.24, 0.45),
        wings: 0.12,
        chamfers: 0.03,
        bays: 0.03,
        yaw: Some(FRAC_PI_2 * f64::from(rng.int((0, 3)))),
        variety: variety(rng),
        ..BuildingParams::of_size(size)
    };
    Building::generate(seed, &params)
}

/// Half of the plans have something out of the ordinary.
fn variety(rng: &mut Rng) -> Variety {
    if rng.chance(0.5) {
        return Variety::default();
    }
    Variety {
        blocks: 0.2,
        alcoves: rng.range((0.0, 0.2)),
        l_shapes: rng.range((0.0, 0.3)),
        pilasters: rng.range((0.0, 0.25)),
        columns: rng.range((0.0, 0.6)),
        ..Variety::default()
    }
}

impl Site {
    pub(super) fn new(building: &Building) -> Self {
        let kinds = building.layout().rooms.iter().map(|r| building.kind(r.id).unwrap_or(RoomKind::Room));
        Self {
            layout: building.layout().clone(),
            kinds: kinds.collect(),
            depths: building.openings().map(|(_, depth)| depth).collect(),
            solids: building.solids().to_vec(),
        }
    }

    /// The box around the outer faces of the walls.
    pub(super) fn bounds(&self) -> (Point, Point) {
        let walls = self.layout.walls.iter();
        bounds(walls.flat_map(|w| band(&w.line, w.thickness / 2.0, w.thickness / 2.0))).unwrap_or_default()
    }

    pub(super) fn kind(&self, room: &Room) -> RoomKind {
        self.kinds.get(room.id as usize - 1).copied().unwrap_or(RoomKind::Room)
    }

    pub(super) fn room(&self, id: RoomId) -> Option<&Room> {
        self.layout.rooms.iter().find(|r| r.id == id)
    }

    /// The building with every point where `to` takes it.
    pub(super) fn moved(mut self, to: impl Fn(Point) -> Point) -> Self {
        move_layout(&mut self.layout, &to);
        self.solids.iter_mut().for_each(|s| move_polygon(s, &to));
        self
    }
}

/// Takes every point of rooms, walls and openings to another place.
pub(super) fn move_layout(layout: &mut Layout, to: &impl Fn(Point) -> Point) {
    for room in &mut layout.rooms {
        move_polygon(&mut room.inner, to);
        move_polygon(&mut room.centre, to);
    }
    let lines = layout.walls.iter_mut().map(|w| &mut w.line);
    for line in lines.chain(layout.openings.iter_mut().map(|o| &mut o.segment)) {
        (line.a, line.b) = (to(line.a), to(line.b));
    }
}

fn move_polygon(polygon: &mut Polygon, to: &impl Fn(Point) -> Point) {
    polygon.exterior.iter_mut().chain(polygon.holes.iter_mut().flatten()).for_each(|p| *p = to(*p));
}
