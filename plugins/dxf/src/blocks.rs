//! What fixtures and signs look like: line drawings in a box of side 1 about the origin, x right, y up.

use crate::entity::{Entity, Shape};
use crate::layer::Layer;
use planform_sdk::{Point, Segment};
use std::f64::consts::TAU;

/// Corners of what is drawn round: any CAD program can stretch them, which it may not do with circles.
const ROUND: usize = 24;

/// The drawing of a kind of symbol, inserted wherever the document shows one.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    pub name: &'static str,
    pub layer: Layer,
    shapes: Vec<Shape>,
}

impl Block {
    /// The block for a kind of symbol; none for those that are drawn each on its own, and for unknown ones.
    pub fn of_kind(kind: &str) -> Option<Self> {
        let (name, layer, shapes) = match kind {
            "lift" => ("LIFT", Layer::Lift, lift()),
            "toilet" => ("TOILET", Layer::Fixture, toilet()),
            "sink" => ("SINK", Layer::Fixture, sink()),
            "emergency-exit" => ("EMERGENCY-EXIT", Layer::Symbol, emergency_exit()),
            "first-aid" => ("FIRST-AID", Layer::Symbol, first_aid()),
            "fire-extinguisher" => ("FIRE-EXTINGUISHER", Layer::Symbol, fire_extinguisher()),
            "fire-hose-reel" => ("FIRE-HOSE-REEL", Layer::Symbol, fire_hose_reel()),
            "fire-alarm-call-point" => ("FIRE-ALARM-CALL-POINT", Layer::Symbol, call_point()),
            "assembly-point" => ("ASSEMBLY-POINT", Layer::Symbol, assembly_point()),
            "you-are-here" => ("YOU-ARE-HERE", Layer::Symbol, you_are_here()),
            _ => return None,
        };
        Some(Self { name, layer, shapes })
    }

    /// What is drawn in it.
    pub fn entities(&self) -> impl Iterator<Item = Entity> {
        let entity = |shape: &Shape| Entity { layer: self.layer, shape: shape.clone(), data: vec![] };
        self.shapes.iter().map(entity)
    }
}

fn ring(points: &[[f64; 2]]) -> Shape {
    Shape::Ring(points.iter().copied().map(Point::from).collect())
}

fn line(a: [f64; 2], b: [f64; 2]) -> Shape {
    Shape::Line(Segment::new(a.into(), b.into()))
}

/// A rectangle from its lower left to its upper right corner.
fn rectangle([left, bottom]: [f64; 2], [right, top]: [f64; 2]) -> Shape {
    ring(&[[left, bottom], [right, bottom], [right, top], [left, top]])
}

fn frame() -> Shape {
    rectangle([-0.5, -0.5], [0.5, 0.5])
}

fn oval([x, y]: [f64; 2], [half_width, half_height]: [f64; 2]) -> Shape {
    let corner = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / ROUND as f64).sin_cos();
        Point::new(x + half_width * cos, y + half_height * sin)
    };
    Shape::Ring((0..ROUND).map(corner).collect())
}

fn circle(centre: [f64; 2], radius: f64) -> Shape {
    oval(centre, [radius; 2])
}

fn lift() -> Vec<Shape> {
    vec![frame(), line([-0.5, -0.5], [0.5, 0.5]), line([-0.5, 0.5], [0.5, -0.5])]
}

/// The cistern at the top, and the bowl.
fn toilet() -> Vec<Shape> {
    vec![rectangle([-0.5, 0.28], [0.5, 0.5]), oval([0.0, -0.11], [0.36, 0.39])]
}

/// A basin in its slab, its drain, and the tap at the top.
fn sink() -> Vec<Shape> {
    vec![frame(), oval([0.0, -0.06], [0.38, 0.34]), circle([0.0, 0.0], 0.04), line([0.0, 0.45], [0.0, 0.2])]
}

/// An arrow to the right, as in ISO 7010 E005.
fn emergency_exit() -> Vec<Shape> {
    let arrow =
        [[0.4, 0.0], [0.02, 0.36], [0.02, 0.13], [-0.4, 0.13], [-0.4, -0.13], [0.02, -0.13], [0.02, -0.36]];
    vec![frame(), ring(&arrow)]
}

/// A cross, as in ISO 7010 E003.
fn first_aid() -> Vec<Shape> {
    let (far, near) = (0.36, 0.12);
    let quarter = [[far, near], [near, near], [near, far]];
    let turned = [
        |[x, y]: [f64; 2]| [x, y],
        |[x, y]: [f64; 2]| [-y, x],
        |[x, y]: [f64; 2]| [-x, -y],
        |[x, y]: [f64; 2]| [y, -x],
    ];
    let corners: Vec<[f64; 2]> = turned.iter().flat_map(|turn| quarter.map(turn)).collect();
    vec![frame(), ring(&corners)]
}

/// A cylinder, its neck and its hose, as in ISO 7010 F001.
fn fire_extinguisher() -> Vec<Shape> {
    let body = [[-0.2, -0.42], [0.2, -0.42], [0.2, 0.1], [0.1, 0.2], [-0.1, 0.2], [-0.2, 0.1]];
    let hose = [[-0.05, 0.32], [-0.28, 0.26], [-0.34, 0.0]];
    let neck = rectangle([-0.05, 0.2], [0.05, 0.38]);
    vec![frame(), ring(&body), neck, line(hose[0], hose[1]), line(hose[1], hose[2])]
}

/// A reel and its hose, as in ISO 7010 F002.
fn fire_hose_reel() -> Vec<Shape> {
    let middle = [-0.05, 0.05];
    vec![
        frame(),
        circle(middle, 0.32),
        circle(middle, 0.1),
        line([-0.37, 0.05], [-0.37, -0.4]),
        line([-0.37, -0.4], [0.2, -0.4]),
    ]
}

/// A button in its casing, as in ISO 7010 F005.
fn call_point() -> Vec<Shape> {
    vec![frame(), rectangle([-0.3, -0.3], [0.3, 0.3]), circle([0.0, 0.0], 0.15)]
}

/// Four arrows to the middle, as in ISO 7010 E007.
fn assembly_point() -> Vec<Shape> {
    let heads = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
        .map(|[x, y]| ring(&[[0.14 * x, 0.14 * y], [0.42 * x, 0.2 * y], [0.2 * x, 0.42 * y]]));
    [frame(), circle([0.0, 0.0], 0.1)].into_iter().chain(heads).collect()
}

fn you_are_here() -> Vec<Shape> {
    vec![circle([0.0, 0.0], 0.5), circle([0.0, 0.0], 0.28)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [&str; 10] = [
        "lift",
        "toilet",
        "sink",
        "emergency-exit",
        "first-aid",
        "fire-extinguisher",
        "fire-hose-reel",
        "fire-alarm-call-point",
        "assembly-point",
        "you-are-here",
    ];

    #[test]
    fn drawings_fill_their_box() {
        for kind in KINDS {
            let block = Block::of_kind(kind).unwrap();
            assert_eq!(block.name.to_lowercase(), kind);
            let corners = block.entities().flat_map(|e| e.shape.corners());
            let (low, high) = planform_sdk::bounds(corners).unwrap();
            let sides = [low.x, low.y, -high.x, -high.y];
            assert!(sides.iter().all(|s| (s + 0.5).abs() < 1e-9), "{kind}: {low:?} {high:?}");
        }
        assert_eq!(Block::of_kind("door"), None);
    }
}
