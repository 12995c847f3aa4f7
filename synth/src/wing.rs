//! A wing that stands at an angle to the main building, joined to it by a wedge-shaped foyer.

use crate::corridors::{self, CorridorPlan};
use crate::lattice::{CELL, Rect};
use crate::params::{BuildingParams, RoomKind};
use crate::rng::Rng;
use crate::shape::{self, Shape};
use planform_sdk::Point;

/// The wing turns about a hinge on the main building's right end, at the foot of its own left end.
struct Joint {
    hinge: Point,
    turn: f64,
}

impl Joint {
    /// The point this far up the main building's end wall.
    fn on_main(&self, r: f64) -> Point {
        Point::new(self.hinge.x, self.hinge.y + r)
    }

    /// The point this far up the wing's end wall.
    fn on_wing(&self, r: f64) -> Point {
        let (sin, cos) = self.turn.sin_cos();
        Point::new(self.hinge.x + r * sin, self.hinge.y + r * cos)
    }
}

/// The shapes of the foyer and of the wing's rooms, to be put after the `count` shapes of the main building.
pub(crate) fn draw(main: Rect, count: usize, params: &BuildingParams, rng: &mut Rng) -> Vec<Shape> {
    let CorridorPlan { draft, left_end, .. } = corridors::draw_wing(params.size, &params.variety, rng);
    let Some(corridor) = left_end else { return Vec::new() };
    let shapes = shape::trace(&draft, params, rng);
    let foot = shapes.iter().flat_map(|s| &s.rings).flatten().map(|p| p.y).fold(f64::MAX, f64::min);
    let rise = f64::from(corridor.y0) * CELL - foot;
    let joint = Joint {
        hinge: Point::new(f64::from(main.x1) / 10.0, f64::from(main.y0) / 10.0 - rise),
        turn: rng.range((15.0, 45.0)).to_radians(),
    };
    let width = f64::from(corridor.height().max(main.height())) * CELL;
    let foyer = foyer(&joint, rise - rng.range((0.8, 2.5)), rise + width + rng.range((0.8, 2.5)));
    let from = Point::new(f64::from(corridor.x0) / 10.0, foot);
    let wing = shapes.into_iter().map(|s| turned(s, &joint, from, count + 1));
    std::iter::once(foyer).chain(wing).collect()
}

fn foyer(joint: &Joint, low: f64, high: f64) -> Shape {
    let ring = vec![joint.on_main(low), joint.on_wing(low), joint.on_wing(high), joint.on_main(high)];
    Shape { rings: vec![ring], kind: RoomKind::Corridor, access: None }
}

fn turned(mut shape: Shape, joint: &Joint, from: Point, offset: usize) -> Shape {
    let (sin, cos) = joint.turn.sin_cos();
    shape.map(false, |p| {
        let (x, y) = (p.x - from.x, p.y - from.y);
        Point::new(joint.hinge.x + cos * x + sin * y, joint.hinge.y - sin * x + cos * y)
    });
    shape.access = shape.access.map(|a| a + offset);
    shape
}
