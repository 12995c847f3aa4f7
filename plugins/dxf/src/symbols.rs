//! The document's symbols: doors with their leaves, windows, stairs, and what is inserted as a block.

use crate::annotations;
use crate::blocks::Block;
use crate::entity::{Entity, Shape, Value};
use crate::layer::Layer;
use planform_sdk::{DoorLeaf, Fitting, Layout, Point, Segment, Symbol};

/// A leaf that turns by less, radians, is not seen to do so; and an arc without a sweep would be a circle.
const LEAST_SWING: f64 = 1e-3;

/// What is drawn of each symbol.
pub fn draw(layout: &Layout) -> Vec<Entity> {
    let numbered = (1..).zip(&layout.symbols);
    numbered.flat_map(|(n, symbol)| one(n, symbol, layout.fitting(symbol))).collect()
}

fn one(number: u32, symbol: &Symbol, fitting: Option<Fitting>) -> Vec<Entity> {
    match (fitting, Block::of_kind(&symbol.kind)) {
        (Some(fitting), _) if symbol.is_door() => door(number, symbol, &fitting),
        (Some(fitting), _) => window(number, symbol, &fitting),
        _ if !(symbol.width > 0.0 && symbol.height > 0.0) => annotations::symbol(number, symbol),
        _ if symbol.kind == "stairs" => stairs(number, symbol),
        (None, Some(block)) => vec![insertion(number, symbol, &block)],
        (None, None) => annotations::symbol(number, symbol),
    }
}

/// What every entity that stands for a symbol says.
pub fn data(number: u32, symbol: &Symbol) -> Vec<(&'static str, Value)> {
    vec![
        ("kind", "symbol".into()),
        ("symbol", number.into()),
        ("content", symbol.kind.as_str().into()),
        ("width", symbol.width.into()),
        ("height", symbol.height.into()),
        ("confidence", symbol.score.into()),
    ]
}

/// What a part of a symbol's drawing says.
fn part(kind: &str, number: u32) -> Vec<(&'static str, Value)> {
    vec![("kind", kind.into()), ("symbol", number.into())]
}

/// Leaf and swing of each leaf. The line from jamb to jamb is that of the opening, if there is one.
fn door(number: u32, symbol: &Symbol, fitting: &Fitting) -> Vec<Entity> {
    let layer = Layer::Door;
    let sill = Entity { layer, shape: Shape::Line(fitting.segment), data: data(number, symbol) };
    let is_shown = fitting.opening.is_some() && !symbol.leaves.is_empty();
    let leaves = symbol.leaves.iter().filter(|l| l.length() > 0.0).flat_map(|l| leaf(number, l));
    (!is_shown).then_some(sill).into_iter().chain(leaves).collect()
}

fn leaf(number: u32, leaf: &DoorLeaf) -> Vec<Entity> {
    let layer = Layer::Door;
    let open = Shape::Line(Segment::new(leaf.hinge, leaf.at(1.0)));
    let swings = leaf.swing().abs() > LEAST_SWING;
    let swing = swings.then(|| Entity { layer, shape: Shape::Swing(*leaf), data: part("swing", number) });
    std::iter::once(Entity { layer, shape: open, data: part("leaf", number) }).chain(swing).collect()
}

/// Two thin lines, closed at their ends, and the jambs; the wall's faces go on along the window.
fn window(number: u32, symbol: &Symbol, fitting: &Fitting) -> Vec<Entity> {
    let layer = Layer::Window;
    let [right, near, far, left] = fitting.lines();
    let pane = vec![near.a, near.b, far.b, far.a];
    let jamb = |from: Point, to: Point| {
        let shape = Shape::Line(Segment::new(from, to));
        Entity { layer, shape, data: part("jamb", number) }
    };
    let jambs = [jamb(right.a, left.a), jamb(right.b, left.b)];
    let pane = Entity { layer, shape: Shape::Ring(pane), data: data(number, symbol) };
    std::iter::once(pane).chain(jambs).collect()
}

/// A flight's outline, and a line for each step.
fn stairs(number: u32, symbol: &Symbol) -> Vec<Entity> {
    let layer = Layer::Stairs;
    let (sin, cos) = symbol.pose.yaw.sin_cos();
    let at = |along: f64, across: f64| {
        let (u, v) = (along * symbol.width, across * symbol.height);
        Point::new(symbol.pose.x + u * cos - v * sin, symbol.pose.y + u * sin + v * cos)
    };
    let outline = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(u, v)| at(u, v));
    let count = symbol.steps();
    let step = |i: u32| {
        let along = f64::from(i) / f64::from(count) - 0.5;
        let shape = Shape::Line(Segment::new(at(along, -0.5), at(along, 0.5)));
        Entity { layer, shape, data: part("step", number) }
    };
    let outline = Entity { layer, shape: Shape::Ring(outline.into()), data: data(number, symbol) };
    std::iter::once(outline).chain((1..count).map(step)).collect()
}

fn insertion(number: u32, symbol: &Symbol, block: &Block) -> Entity {
    let shape = Shape::Insert {
        block: block.name,
        middle: Point::new(symbol.pose.x, symbol.pose.y),
        yaw: symbol.pose.yaw,
        size: [symbol.width, symbol.height],
    };
    Entity { layer: block.layer, shape, data: data(number, symbol) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, OpeningKind, Pose};

    fn symbol(kind: &str) -> Symbol {
        let pose = Pose { x: 2.0, y: 3.0, yaw: 0.0 };
        Symbol { kind: kind.into(), pose, width: 1.0, height: 0.5, score: 0.8, leaves: vec![] }
    }

    fn kinds(layout: &Layout) -> Vec<Value> {
        draw(layout).into_iter().filter_map(|e| e.data.into_iter().next()).map(|(_, kind)| kind).collect()
    }

    #[test]
    fn a_door_is_a_leaf_and_an_arc_and_outside_a_line_as_well() {
        let point = |x, y| Point::new(x, y);
        let leaf = DoorLeaf { hinge: point(1.5, 3.0), closed: point(2.5, 3.0), open: point(1.5, 4.0) };
        let symbols = vec![Symbol { leaves: vec![leaf], ..symbol("door") }];
        let mut layout = Layout { symbols, ..Layout::default() };
        assert_eq!(kinds(&layout), ["symbol", "leaf", "swing"].map(Value::from));
        let segment = Segment::new(point(1.5, 3.0), point(2.5, 3.0));
        layout.openings = vec![Opening { kind: OpeningKind::Door, segment, rooms: [1, 2] }];
        assert_eq!(kinds(&layout), ["leaf", "swing"].map(Value::from));
        layout.symbols[0].leaves[0].open = point(2.5, 3.0);
        assert_eq!(kinds(&layout), ["leaf"].map(Value::from), "no arc without a sweep");
    }

    #[test]
    fn stairs_have_steps_and_windows_jambs() {
        let layout = Layout { symbols: vec![symbol("stairs"), symbol("window")], ..Layout::default() };
        let expected = ["symbol", "step", "step", "step", "symbol", "jamb", "jamb"].map(Value::from);
        assert_eq!(kinds(&layout), expected);
    }

    #[test]
    fn what_has_no_size_or_no_drawing_is_a_word() {
        let flat = Symbol { height: 0.0, ..symbol("toilet") };
        for symbol in [flat, symbol("coffee-machine")] {
            let drawn = draw(&Layout { symbols: vec![symbol], ..Layout::default() });
            assert!(matches!(drawn.as_slice(), [Entity { shape: Shape::Text { .. }, .. }]), "{drawn:?}");
        }
    }
}
