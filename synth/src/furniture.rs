//! Furniture: cupboards along the walls, tables and chairs as the legs that a laser sees.

use crate::building::Building;
use crate::params::RoomKind;
use crate::rng::Rng;
use planform_sdk::{Point, Polygon, Room};

/// Free space in front of a door, metres from its middle.
const DOOR_CLEARANCE: f64 = 1.2;

/// One solid thing on the floor.
type Solid = Vec<Point>;

/// A box with its middle, its directions and half its sides.
#[derive(Clone, Copy)]
pub(crate) struct Block {
    pub(crate) middle: Point,
    /// Unit vector along the length.
    pub(crate) along: (f64, f64),
    pub(crate) half_length: f64,
    pub(crate) half_depth: f64,
}

impl Block {
    pub(crate) fn at(&self, u: f64, v: f64) -> Point {
        let (x, y) = self.along;
        Point::new(self.middle.x + x * u - y * v, self.middle.y + y * u + x * v)
    }

    pub(crate) fn corners(&self) -> Solid {
        let (l, d) = (self.half_length, self.half_depth);
        vec![self.at(-l, -d), self.at(l, -d), self.at(l, d), self.at(-l, d)]
    }

    /// A square leg in each corner.
    fn legs(&self, side: f64) -> Vec<Solid> {
        let (l, d) = (self.half_length - side / 2.0, self.half_depth - side / 2.0);
        let feet = [(-l, -d), (l, -d), (l, d), (-l, d)];
        feet.map(|(u, v)| Self {
            middle: self.at(u, v),
            half_length: side / 2.0,
            half_depth: side / 2.0,
            ..*self
        })
        .map(|leg| leg.corners())
        .to_vec()
    }

    pub(crate) fn radius(&self) -> f64 {
        self.half_length.hypot(self.half_depth)
    }
}

/// What stands in the building: `density` 0 is nothing, 1 is crowded. `clutter` is the same for solid desks.
pub(crate) fn furnish(building: &Building, density: f64, clutter: f64, seed: u64) -> Vec<Polygon> {
    let mut rng = Rng::new(seed, 101);
    let mut solids = Vec::new();
    for room in &building.layout().rooms {
        let doors: Vec<Point> = building
            .layout()
            .openings
            .iter()
            .filter(|o| o.rooms.contains(&room.id))
            .map(|o| o.segment.midpoint())
            .collect();
        let mut scene = Scene { room, doors, taken: Vec::new(), solids: Vec::new() };
        let kind = building.kind(room.id).unwrap_or(RoomKind::Room);
        scene.furnish(kind, density.clamp(0.0, 1.0), &mut rng);
        if clutter > 0.0 {
            scene.clutter(kind, clutter.min(1.0), &mut rng);
        }
        solids.extend(scene.solids);
    }
    solids.into_iter().map(|s| Polygon::new(s, vec![])).collect()
}

struct Scene<'a> {
    room: &'a Room,
    doors: Vec<Point>,
    taken: Vec<Block>,
    solids: Vec<Solid>,
}

impl Scene<'_> {
    fn furnish(&mut self, kind: RoomKind, density: f64, rng: &mut Rng) {
        match kind {
            RoomKind::Corridor => self.cupboards(density * 0.12, rng),
            RoomKind::Small => self.cupboards(density * 0.3, rng),
            RoomKind::Hall => {
                self.cupboards(density * 0.25, rng);
                self.columns(density, rng);
            }
            RoomKind::Room => {
                self.cupboards(density * 0.6, rng);
                self.tables(density, rng);
            }
        }
    }

    /// Desks that a laser does not see through: side by side in islands, and along the walls.
    fn clutter(&mut self, kind: RoomKind, clutter: f64, rng: &mut Rng) {
        if kind == RoomKind::Corridor {
            return self.cupboards(clutter * 0.2, rng);
        }
        self.cupboards(clutter * rng.range((0.2, 0.9)), rng);
        let Some(Extent { corner: origin, along, size }) = extent(&self.room.inner.exterior) else { return };
        for _ in 0..(clutter * size.0 * size.1 / 9.0) as u32 {
            let (u, v) = (rng.range((0.6, size.0)), rng.range((0.6, size.1)));
            let middle =
                Point::new(origin.x + along.0 * u - along.1 * v, origin.y + along.1 * u + along.0 * v);
            let (half_length, half_depth) = (rng.range((0.2, 1.3)), rng.range((0.2, 0.8)));
            let along = if rng.chance(0.4) { (-along.1, along.0) } else { along };
            let block = Block { middle, along, half_length, half_depth };
            if self.take(block, rng.range((-0.6, 0.5))) {
                self.solids.push(block.corners());
            }
        }
    }

    /// Takes the place of a block if it is free, in the room and not in the way of a door.
    fn take(&mut self, block: Block, gap: f64) -> bool {
        let inside = block.corners().into_iter().all(|p| self.room.inner.contains(p));
        let clear = self.doors.iter().all(|d| d.distance(block.middle) > DOOR_CLEARANCE + block.radius());
        let free =
            self.taken.iter().all(|t| t.middle.distance(block.middle) > t.radius() + block.radius() + gap);
        let taken = inside && clear && free;
        if taken {
            self.taken.push(block);
        }
        taken
    }

    /// Cupboards and shelves along this share of the walls.
    fn cupboards(&mut self, share: f64, rng: &mut Rng) {
        let ring = &self.room.inner.exterior;
        for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let length = a.distance(b);
            let along = ((b.x - a.x) / length, (b.y - a.y) / length);
            let mut at = rng.range((0.05, 0.6));
            while at < length - 0.8 {
                let (wide, deep) = (rng.range((0.6, 1.9)), rng.range((0.3, 0.6)));
                if rng.chance(share) {
                    let (u, v) = (at + wide / 2.0, deep / 2.0 + 0.02);
                    let middle = Point::new(a.x + along.0 * u - along.1 * v, a.y + along.1 * u + along.0 * v);
                    let block = Block { middle, along, half_length: wide / 2.0, half_depth: deep / 2.0 };
                    if self.take(block, -0.6 * block.radius()) {
                        self.solids.push(block.corners());
                    }
                }
                at += wide + rng.range((0.0, 0.4));
            }
        }
    }

    /// Rows of tables, each with chairs, parallel to the room's longest wall.
    fn tables(&mut self, density: f64, rng: &mut Rng) {
        let Some(Extent { corner: origin, along, size }) = extent(&self.room.inner.exterior) else { return };
        let (pitch_u, pitch_v) = (rng.range((1.9, 3.0)), rng.range((1.7, 2.6)));
        let (half_length, half_depth) = (rng.range((0.55, 0.85)), rng.range((0.3, 0.45)));
        let keep = (density * rng.range((0.5, 1.3))).min(1.0);
        for i in 0..(size.0 / pitch_u) as u32 {
            for j in 0..(size.1 / pitch_v) as u32 {
                let (u, v) = ((f64::from(i) + 0.6) * pitch_u, (f64::from(j) + 0.6) * pitch_v);
                let middle = Point::new(
                    origin.x + along.0 * u - along.1 * v + rng.gauss() * 0.06,
                    origin.y + along.1 * u + along.0 * v + rng.gauss() * 0.06,
                );
                let table = Block { middle, along, half_length, half_depth };
                if rng.chance(keep) && self.take(table, 0.1) {
                    self.table(&table, density, rng);
                }
            }
        }
    }

    fn table(&mut self, table: &Block, density: f64, rng: &mut Rng) {
        if rng.chance(0.12) {
            self.solids.push(table.corners());
            return;
        }
        self.solids.extend(table.legs(0.05));
        for side in [-1.0, 1.0] {
            if rng.chance(density) {
                let u = rng.range((-0.3, 0.3));
                let middle = table.at(u, side * (table.half_depth + 0.25));
                let chair = Block { middle, half_length: 0.21, half_depth: 0.21, ..*table };
                if chair.corners().into_iter().all(|p| self.room.inner.contains(p)) {
                    self.solids.extend(chair.legs(0.03));
                }
            }
        }
    }

    /// A few columns or pieces of equipment in a hall.
    fn columns(&mut self, density: f64, rng: &mut Rng) {
        let Some(Extent { corner: origin, along, size }) = extent(&self.room.inner.exterior) else { return };
        for _ in 0..(density * size.0 * size.1 / 30.0) as u32 {
            let (u, v) = (rng.range((1.0, size.0)), rng.range((1.0, size.1)));
            let middle =
                Point::new(origin.x + along.0 * u - along.1 * v, origin.y + along.1 * u + along.0 * v);
            let half = rng.range((0.1, 0.5));
            let block = Block { middle, along, half_length: half, half_depth: half * rng.range((0.6, 1.0)) };
            if self.take(block, 1.0) {
                self.solids.push(block.corners());
            }
        }
    }
}

/// A box: a corner, the direction of its length, and its size, metres.
pub(crate) struct Extent {
    pub(crate) corner: Point,
    pub(crate) along: (f64, f64),
    pub(crate) size: (f64, f64),
}

/// The box around a ring along its longest side.
pub(crate) fn extent(ring: &[Point]) -> Option<Extent> {
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    let (a, b) = sides.max_by(|x, y| x.0.distance(*x.1).total_cmp(&y.0.distance(*y.1)))?;
    let length = a.distance(*b);
    let along = ((b.x - a.x) / length, (b.y - a.y) / length);
    let u = |p: &Point| p.x * along.0 + p.y * along.1;
    let v = |p: &Point| p.y * along.0 - p.x * along.1;
    let low = |f: &dyn Fn(&Point) -> f64| ring.iter().map(f).fold(f64::MAX, f64::min);
    let high = |f: &dyn Fn(&Point) -> f64| ring.iter().map(f).fold(f64::MIN, f64::max);
    let (u0, v0) = (low(&u), low(&v));
    let corner = Point::new(along.0 * u0 - along.1 * v0, along.1 * u0 + along.0 * v0);
    Some(Extent { corner, along, size: (high(&u) - u0, high(&v) - v0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::corridor_with_rooms;

    #[test]
    fn density_fills_the_rooms_but_not_the_doorways() {
        let building = corridor_with_rooms(6);
        assert!(furnish(&building, 0.0, 0.0, 1).is_empty());
        let (some, many) = (furnish(&building, 0.3, 0.0, 1), furnish(&building, 1.0, 0.0, 1));
        assert!(some.len() * 2 < many.len(), "{} {}", some.len(), many.len());
        let doors: Vec<Point> = building.layout().openings.iter().map(|o| o.segment.midpoint()).collect();
        let nearest = |p: &Point| doors.iter().map(|d| d.distance(*p)).fold(f64::MAX, f64::min);
        assert!(many.iter().flat_map(|s| &s.exterior).all(|p| nearest(p) > 0.8));
    }
}
