//! A plan while it is being drawn: its layers, what is taken of the floor, and the truth so far.

use super::letters::{Face, measure, outline};
use super::look::Look;
use super::paper::Paper;
use super::site::Site;
use super::surface::{Colour, Pen, Surface};
use super::truth::{PlanLeaf, PlanName, PlanSymbol, PlanText, PlanTextRole};
use super::view::View;
use crate::furniture::Block;
use crate::rng::Rng;
use planform_sdk::{Point, Room, RoomId};
use tiny_skia::{FillRule, Transform};

/// How far apart points are that are tried along the edges of what shall lie in a room, metres.
const STEP: f64 = 0.25;

pub(super) struct Drawing {
    pub(super) view: View,
    pub(super) look: Look,
    pub(super) paper: Paper,
    pub(super) site: Site,
    pub(super) rng: Rng,
    pub(super) picture: Surface,
    pub(super) walls: Surface,
    pub(super) letters: Surface,
    /// Floor on which nothing more may be drawn.
    pub(super) taken: Vec<Block>,
    /// Floor before doors, on which nothing may stand, though words and signs may be written there.
    pub(super) ways: Vec<Block>,
    pub(super) names: Vec<PlanName>,
    pub(super) texts: Vec<PlanText>,
    pub(super) symbols: Vec<PlanSymbol>,
}

/// One line of text to write.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) text: &'a str,
    pub(super) face: Face,
    /// Height of a capital letter, metres.
    pub(super) capital: f64,
    pub(super) colour: Colour,
    pub(super) role: PlanTextRole,
    pub(super) room: Option<RoomId>,
}

impl Drawing {
    /// `None` if the view has no pixels.
    pub(super) fn new(site: Site, look: Look, paper: Paper, rng: Rng) -> Option<Self> {
        let view = paper.view;
        let layer = || Surface::new(view);
        Some(Self {
            view,
            look,
            paper,
            site,
            rng,
            picture: layer()?,
            walls: layer()?,
            letters: layer()?,
            taken: Vec::new(),
            ways: Vec::new(),
            names: Vec::new(),
            texts: Vec::new(),
            symbols: Vec::new(),
        })
    }

    /// A pen as wide as this, millimetres of paper, in the colour of the lines.
    pub(super) fn pen(&self, millimetres: f64) -> Pen {
        Pen { width: self.view.mm(millimetres), colour: self.look.ink }
    }

    /// The pen of furniture, doors and dimensions.
    pub(super) fn thin(&self) -> Pen {
        self.pen(self.look.thin)
    }

    /// Whether the block lies in the room and on nothing that is taken.
    pub(super) fn is_free(&self, room: &Room, block: &Block) -> bool {
        let corners = block.corners();
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let mut border = edges.flat_map(|(&a, &b)| between(a, b));
        border.all(|p| room.inner.contains(p))
            && !self.site.solids.iter().flat_map(|s| &s.exterior).any(|&p| contains(block, p))
            && self.taken.iter().all(|t| !overlap(t, block))
    }

    /// Whether something may stand there: the block is free, and in nobody's way.
    pub(super) fn may_stand(&self, room: &Room, block: &Block) -> bool {
        self.is_free(room, block) && self.ways.iter().all(|w| !overlap(w, block))
    }

    /// Takes the block's floor, and so much around it, if it is free.
    pub(super) fn take(&mut self, room: &Room, block: Block, around: f64) -> bool {
        let free = self.is_free(room, &block);
        if free {
            let Block { half_length, half_depth, .. } = block;
            let (half_length, half_depth) = (half_length + around, half_depth + around);
            self.taken.push(Block { half_length, half_depth, ..block });
        }
        free
    }

    /// As [`take`](Self::take), for what stands on the floor.
    pub(super) fn put(&mut self, room: &Room, block: Block, around: f64) -> bool {
        self.may_stand(room, &block) && self.take(room, block, around)
    }

    /// Writes a line, its ink's middle at the point, reading in the direction `angle`, radians counter-clockwise.
    pub(super) fn write(&mut self, line: Line, middle: Point, angle: f64) {
        let Some(path) = outline(line.text, line.face, line.capital) else { return };
        let ink = path.bounds();
        let (cx, cy) = (ink.x() + ink.width() / 2.0, ink.y() + ink.height() / 2.0);
        let place = Transform::from_translate(-cx, -cy)
            .post_rotate(angle.to_degrees() as f32)
            .post_translate(middle.x as f32, middle.y as f32);
        let Some(path) = path.transform(place) else { return };
        self.letters.fill_path(&path, line.colour, FillRule::Winding);
        self.texts.push(PlanText {
            content: line.text.to_owned(),
            role: line.role,
            room: line.room,
            pose: self.view.pose(middle, angle),
            width: f64::from(ink.width()),
            height: f64::from(ink.height()),
        });
    }

    /// A line in the colour and face of the plan's words.
    pub(super) fn line<'a>(&self, text: &'a str, capital: f64, role: PlanTextRole) -> Line<'a> {
        Line { text, face: self.look.face, capital, colour: self.look.ink, role, room: None }
    }

    /// Width and height of a line's ink.
    pub(super) fn measure(&self, line: &Line) -> (f64, f64) {
        measure(line.text, line.face, line.capital)
    }

    /// Tells of a symbol that fills the block.
    pub(super) fn tell(&mut self, kind: &str, block: &Block, leaves: Vec<PlanLeaf>) {
        let yaw = block.along.1.atan2(block.along.0);
        self.symbols.push(PlanSymbol {
            kind: kind.to_owned(),
            pose: self.view.pose(block.middle, yaw),
            width: 2.0 * block.half_length,
            height: 2.0 * block.half_depth,
            leaves: leaves.into_iter().map(|l| self.leaf(l)).collect(),
        });
    }

    fn leaf(&self, PlanLeaf { hinge, closed, open }: PlanLeaf) -> PlanLeaf {
        let [hinge, closed, open] = [hinge, closed, open].map(|p| self.view.point(p));
        PlanLeaf { hinge, closed, open }
    }
}

/// A block around a point.
pub(super) fn block(middle: Point, along: (f64, f64), length: f64, depth: f64) -> Block {
    Block { middle, along, half_length: length / 2.0, half_depth: depth / 2.0 }
}

fn between(a: Point, b: Point) -> impl Iterator<Item = Point> {
    let steps = (a.distance(b) / STEP).ceil().max(1.0) as i32;
    let at = move |t: f64| Point::new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
    (0..steps).map(move |i| at(f64::from(i) / f64::from(steps)))
}

/// The point in the block's own directions, from its middle.
fn local(block: &Block, p: Point) -> (f64, f64) {
    let (dx, dy, (x, y)) = (p.x - block.middle.x, p.y - block.middle.y, block.along);
    (dx * x + dy * y, dy * x - dx * y)
}

pub(super) fn contains(block: &Block, p: Point) -> bool {
    let (u, v) = local(block, p);
    u.abs() <= block.half_length && v.abs() <= block.half_depth
}

/// Whether two blocks overlap: no side of either separates them.
fn overlap(a: &Block, b: &Block) -> bool {
    !separates(a, b) && !separates(b, a)
}

fn separates(a: &Block, b: &Block) -> bool {
    let corners: Vec<_> = b.corners().into_iter().map(|p| local(a, p)).collect();
    let beyond = |of: fn(&(f64, f64)) -> f64, half: f64| {
        corners.iter().all(|c| of(c) >= half) || corners.iter().all(|c| of(c) <= -half)
    };
    beyond(|c| c.0, a.half_length) || beyond(|c| c.1, a.half_depth)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_blocks_overlap_only_where_they_do() {
        let s = std::f64::consts::FRAC_1_SQRT_2;
        let square = block(Point::new(0.0, 0.0), (1.0, 0.0), 2.0, 2.0);
        let near = block(Point::new(1.75, 1.75), (s, s), 2.0, 2.0);
        let touching = block(Point::new(1.6, 0.0), (s, s), 2.0, 2.0);
        assert!(!overlap(&square, &near) && !overlap(&near, &square));
        assert!(overlap(&square, &touching) && overlap(&touching, &square));
        assert!(contains(&near, Point::new(1.2, 1.2)) && !contains(&near, Point::new(0.9, 0.9)));
    }
}
