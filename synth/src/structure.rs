//! What stands fast inside a room without dividing it: pilasters, columns, short walls, partitions, shafts, and the
//! leaves of open doors. The room stays one room, as people see it.

use crate::building::{Building, to_geo};
use crate::furniture::{Block, Extent, extent};
use crate::params::RoomKind;
use crate::raster::band;
use crate::rng::Rng;
use crate::variety::Variety;
use geo::Intersects;
use planform_sdk::{OpeningKind, Point, Polygon, Room};

/// Nothing stands so near before a door, metres.
const BEFORE_DOOR: f64 = 0.9;
/// Nor so near beside one, metres.
const BESIDE_DOOR: f64 = 0.12;
/// Everywhere in a room there is a way this wide past what stands there, metres.
const WAY: f64 = 1.0;
/// What is fixed to a wall goes this deep into it, metres.
const INTO_WALL: f64 = 0.03;

/// Draws what stands in the building.
pub(crate) fn draw(building: &Building, variety: &Variety, rng: &mut Rng) -> Vec<Polygon> {
    let mut solids = Vec::new();
    if *variety == Variety::default() {
        return solids;
    }
    for room in &building.layout().rooms {
        let mut site = Site::new(building, room);
        let kind = building.kind(room.id).unwrap_or(RoomKind::Room);
        site.build(kind, variety, rng);
        site.leaves(building, variety, rng);
        solids.extend(site.solids);
    }
    solids
}

/// A wall's face, its ends counter-clockwise.
#[derive(Clone, Copy)]
struct Side {
    from: Point,
    along: (f64, f64),
    length: f64,
}

impl Side {
    /// The point `u` along the wall and `v` into the room.
    fn at(&self, u: f64, v: f64) -> Point {
        let (x, y) = self.along;
        Point::new(self.from.x + x * u - y * v, self.from.y + y * u + x * v)
    }

    /// A box fixed to the wall, `wide` around `u` and `deep`.
    fn block(&self, u: f64, wide: f64, deep: f64) -> Block {
        let half_depth = (deep + INTO_WALL) / 2.0;
        Block {
            middle: self.at(u, half_depth - INTO_WALL),
            along: self.along,
            half_length: wide / 2.0,
            half_depth,
        }
    }
}

struct Site<'a> {
    room: &'a Room,
    doors: Vec<geo::Polygon<f64>>,
    solids: Vec<Polygon>,
}

impl<'a> Site<'a> {
    fn new(building: &Building, room: &'a Room) -> Self {
        let of_room = building.openings().filter(|(o, _)| o.rooms.contains(&room.id));
        let doors = of_room.map(|(o, depth)| {
            let before = band(&o.segment, depth / 2.0 + BEFORE_DOOR, BESIDE_DOOR);
            to_geo(&Polygon::new(before.to_vec(), vec![]))
        });
        Self { room, doors: doors.collect(), solids: Vec::new() }
    }

    fn build(&mut self, kind: RoomKind, variety: &Variety, rng: &mut Rng) {
        let area = self.room.area();
        let corridor = kind == RoomKind::Corridor;
        let large = area > 35.0;
        if kind == RoomKind::Small {
            return;
        }
        if rng.wants(variety.narrowings) {
            let most = if corridor { (area / 20.0).clamp(3.0, 15.0) } else { 2.0 };
            for _ in 0..rng.int((1, most as i32)) {
                self.narrowing(corridor, rng);
            }
        }
        if large && !corridor && rng.wants(variety.partitions) {
            self.partitions(rng);
        }
        if rng.wants(variety.pilasters) {
            self.pilasters(rng);
        }
        if large && rng.wants(variety.columns) {
            self.columns(rng);
        }
        if large && rng.wants(variety.shafts) {
            for _ in 0..rng.int((1, 3)) {
                self.shaft(rng);
            }
        }
    }

    fn sides(&self) -> Vec<Side> {
        let rings = self.room.inner.rings();
        let sides = rings.flat_map(|ring| {
            ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| {
                let length = a.distance(b).max(1e-9);
                Side { from: a, along: ((b.x - a.x) / length, (b.y - a.y) / length), length }
            })
        });
        sides.filter(|s| s.length > 1.2).collect()
    }

    /// From a point of a wall across the room to the next wall, metres.
    fn across(&self, side: &Side, u: f64) -> f64 {
        let (from, to) = (side.at(u, 0.02), side.at(u, 60.0));
        let mut nearest = 60.0f64;
        for ring in self.room.inner.rings() {
            for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                if let Some(t) = crossing(from, to, a, b) {
                    nearest = nearest.min(t * 59.98 + 0.02);
                }
            }
        }
        nearest
    }

    /// Takes a box if it meets no door and no other box; `clear` is what has to stay free of boxes and walls.
    fn take(&mut self, block: &Block, clear: &Block) -> bool {
        let (body, around) = (block.corners(), to_geo(&Polygon::new(clear.corners(), vec![])));
        let room = to_geo(&self.room.inner);
        let in_room = geo::Contains::contains(&room, &around);
        let polygon = Polygon::new(body, vec![]);
        let shape = to_geo(&polygon);
        let free = self.doors.iter().all(|d| !d.intersects(&shape))
            && self.solids.iter().all(|s| !to_geo(s).intersects(&around));
        if in_room && free {
            self.solids.push(polygon);
        }
        in_room && free
    }

    /// Takes a box at a wall that leaves a way before it.
    fn take_at_wall(&mut self, side: &Side, u: f64, wide: f64, deep: f64) -> bool {
        let half_depth = (deep + WAY) / 2.0;
        let middle = side.at(u, half_depth + 0.01);
        let clear = Block { middle, along: side.along, half_length: wide / 2.0, half_depth };
        self.take(&side.block(u, wide, deep), &clear)
    }

    /// Equal pilasters at equal distances along some of the walls.
    fn pilasters(&mut self, rng: &mut Rng) {
        let (pitch, wide, deep) = (rng.range((1.5, 6.5)), rng.range((0.2, 0.9)), rng.range((0.08, 0.5)));
        for side in self.sides() {
            if side.length < 2.0 || rng.chance(0.5) {
                continue;
            }
            let mut u = rng.range((0.4, pitch));
            while u < side.length - wide {
                self.take_at_wall(&side, u, wide, deep);
                u += pitch;
            }
        }
    }

    /// A short wall from one side, or from both sides with the way between them.
    fn narrowing(&mut self, corridor: bool, rng: &mut Rng) {
        let sides = self.sides();
        let Some(side) = sides.get(rng.index(sides.len())) else { return };
        let u = rng.range((0.3, side.length - 0.3));
        let width = self.across(side, u);
        let way = width * if corridor { rng.range((0.6, 0.92)) } else { rng.range((0.55, 0.9)) };
        let thick = if rng.chance(0.7) { rng.range((0.1, 0.4)) } else { rng.range((0.4, 2.0)) };
        if !(1.2..=9.0).contains(&way) || width > 14.0 {
            return;
        }
        let both = rng.chance(0.6);
        let share = if both { rng.range((0.3, 0.7)) } else { 1.0 };
        let (near, far) = ((width - way) * share, (width - way) * (1.0 - share));
        self.take_at_wall(side, u, thick, near);
        if both {
            let (x, y) = side.along;
            let opposite = Side { from: side.at(u, width), along: (-x, -y), length: 0.0 };
            self.take_at_wall(&opposite, 0.0, thick, far);
        }
    }

    /// Thin walls at right angles to one of the longer walls: the bays between them are open to the room.
    fn partitions(&mut self, rng: &mut Rng) {
        let sides = self.sides();
        let long: Vec<&Side> = sides.iter().filter(|s| s.length > 5.0).collect();
        let Some(side) = long.get(rng.index(long.len())) else { return };
        let width = self.across(side, side.length / 2.0);
        let (pitch, thick) = (rng.range((1.8, 3.6)), rng.range((0.06, 0.2)));
        let deep = rng.range((1.0, 2.8)).min(width * 0.45);
        let mut u = pitch * rng.range((0.6, 1.1));
        while u < side.length - 1.0 {
            self.take_at_wall(side, u, thick, deep);
            u += pitch;
        }
    }

    /// Columns on a grid.
    fn columns(&mut self, rng: &mut Rng) {
        let Some(Extent { corner, along, size }) = extent(&self.room.inner.exterior) else { return };
        let (pitch_u, pitch_v) = (rng.range((2.5, 7.0)), rng.range((2.5, 7.0)));
        let half = rng.range((0.1, 0.45));
        let first = (rng.range((0.3, 1.0)), rng.range((0.3, 1.0)));
        for i in 0..(size.0 / pitch_u) as u32 + 1 {
            for j in 0..(size.1 / pitch_v) as u32 + 1 {
                let (u, v) = ((f64::from(i) + first.0) * pitch_u, (f64::from(j) + first.1) * pitch_v);
                let middle =
                    Point::new(corner.x + along.0 * u - along.1 * v, corner.y + along.1 * u + along.0 * v);
                self.take_free(Block { middle, along, half_length: half, half_depth: half }, 0.6);
            }
        }
    }

    /// A closed box somewhere in the middle.
    fn shaft(&mut self, rng: &mut Rng) {
        let Some(Extent { corner, along, size }) = extent(&self.room.inner.exterior) else { return };
        let (u, v) = (rng.range((0.0, size.0)), rng.range((0.0, size.1)));
        let middle = Point::new(corner.x + along.0 * u - along.1 * v, corner.y + along.1 * u + along.0 * v);
        let (half_length, half_depth) = (rng.range((0.3, 2.5)), rng.range((0.3, 1.5)));
        self.take_free(Block { middle, along, half_length, half_depth }, 1.2);
    }

    /// Takes a box that stands alone with a way around it.
    fn take_free(&mut self, block: Block, way: f64) {
        let (half_length, half_depth) = (block.half_length + way, block.half_depth + way);
        self.take(&block, &Block { half_length, half_depth, ..block });
    }

    /// Leaves of open doors, seen from the room with the smaller number so that each is drawn once.
    fn leaves(&mut self, building: &Building, variety: &Variety, rng: &mut Rng) {
        let single = |o: &planform_sdk::Opening| o.kind == OpeningKind::Door && o.width() < 1.4;
        for (opening, depth) in building.openings().filter(|(o, _)| o.rooms[0] == self.room.id && single(o)) {
            if !rng.wants(variety.leaves) {
                continue;
            }
            let into_left = rng.chance(0.5);
            let angle: f64 = rng.range((70.0f64, 110.0)).to_radians();
            let (a, width) = (opening.segment.a, opening.width());
            let (x, y) = ((opening.segment.b.x - a.x) / width, (opening.segment.b.y - a.y) / width);
            let turn = if into_left { angle } else { -angle };
            let lift = if into_left { depth / 2.0 } else { -depth / 2.0 };
            let hinge = Point::new(a.x - y * lift, a.y + x * lift);
            let (sin, cos) = turn.sin_cos();
            let along = (x * cos - y * sin, x * sin + y * cos);
            let half = width / 2.0;
            let middle = Point::new(hinge.x + along.0 * half, hinge.y + along.1 * half);
            let leaf = Block { middle, along, half_length: half, half_depth: 0.035 };
            self.solids.push(Polygon::new(leaf.corners(), vec![]));
        }
    }
}

/// Where from `p` (0) to `q` (1) the segment a-b is met.
fn crossing(p: Point, q: Point, a: Point, b: Point) -> Option<f64> {
    let (dx, dy, ex, ey) = (q.x - p.x, q.y - p.y, b.x - a.x, b.y - a.y);
    let cross = dx * ey - dy * ex;
    if cross.abs() < 1e-12 {
        return None;
    }
    let (ax, ay) = (a.x - p.x, a.y - p.y);
    let (t, u) = ((ax * ey - ay * ex) / cross, (ax * dy - ay * dx) / cross);
    ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u)).then_some(t)
}
