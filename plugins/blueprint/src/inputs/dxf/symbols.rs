//! Blocks that stand for something.

use super::plane::{Map, Point, distance};
use super::shapes::Shape;
use super::unfold::Insertion;
use planform_sdk::DOOR_KINDS;

/// Words in names of blocks, and what these are; the first that fits counts.
const KINDS: [(&str, &[&str]); 15] = [
    (
        "emergency-exit",
        &["EMERGENCY", "FIRE-EXIT", "FIRE_EXIT", "EXITSIGN", "EXIT_SIGN", "EXIT-SIGN", "NOTAUSGANG"],
    ),
    (
        "fire-extinguisher",
        &["EXTINGUISH", "FEUERLÖSCHER", "FEUERLOESCHER", "ESTINTORE", "EXTINCTEUR", "EXTINTOR"],
    ),
    ("fire-hose-reel", &["HOSE", "HYDRANT", "IDRANTE"]),
    ("fire-alarm-call-point", &["CALLPOINT", "CALL-POINT", "CALL_POINT", "PULLSTATION", "PULL-STATION"]),
    ("first-aid", &["FIRSTAID", "FIRST-AID", "FIRST_AID"]),
    ("assembly-point", &["ASSEMBLY", "MUSTER"]),
    (
        "double-door",
        &["DOUBLEDOOR", "DOUBLE-DOOR", "DOUBLE_DOOR", "DOOR-DOUBLE", "DOOR_DOUBLE", "DOORDOUBLE"],
    ),
    ("sliding-door", &["SLIDING", "SCHIEBET", "COULISSANT", "SCORREVOLE", "CORREDERA"]),
    ("window", &["WINDOW", "FENSTER", "FINESTRA", "FENETRE", "FENÊTRE", "VENTANA", "JANELA"]),
    ("door", &["DOOR", "TÜR", "TUER", "PORTA", "PORTE", "PUERTA"]),
    ("stairs", &["STAIR", "TREPPE", "SCALA", "ESCALIER", "ESCALERA"]),
    ("lift", &["ELEVATOR", "AUFZUG", "ASCENS"]),
    ("toilet", &["TOILET", "WATERCLOSET", "INODORO"]),
    ("sink", &["SINK", "WASHBASIN", "LAVABO", "LAVANDINO", "WASCHBECKEN", "LAVATORY"]),
    ("you-are-here", &["YOUAREHERE", "YOU-ARE-HERE", "YOU_ARE_HERE"]),
];
/// Names that are too short to look for inside of others.
const WHOLE: [(&str, &str); 5] =
    [("WC", "toilet"), ("LIFT", "lift"), ("WIN", "window"), ("DR", "door"), ("UP", "stairs")];
/// Names that only sound so.
const NOT: [&str; 5] = ["DOORTAG", "DOOR-TAG", "DOOR_TAG", "WINDOWTAG", "SUPPORT"];

/// Arcs of doors sweep from here to there, radians.
const SWING: std::ops::RangeInclusive<f64> = 0.5..=2.2;

/// A symbol in the drawing's units, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    pub kind: &'static str,
    pub centre: Point,
    /// Counter-clockwise, radians.
    pub angle: f64,
    pub width: f64,
    pub height: f64,
    pub leaves: Vec<Leaf>,
}

/// A door's leaf: hinge, free end closed, free end open.
pub type Leaf = [Point; 3];

/// What a block of this name, in upper case, stands for.
pub fn kind(name: &str) -> Option<&'static str> {
    if NOT.iter().any(|n| name.contains(n)) {
        return None;
    }
    let inside =
        KINDS.iter().find(|(_, words)| words.iter().any(|w| name.contains(w))).map(|(kind, _)| *kind);
    let part = |word: &str| name.split(|c: char| !c.is_alphabetic()).any(|p| p == word);
    inside.or_else(|| WHOLE.iter().find(|(word, _)| part(word)).map(|(_, kind)| *kind))
}

/// The symbol that an insertion is; `None` if it has no lines.
pub fn placed(insertion: &Insertion) -> Option<Placed> {
    let kind = kind(&insertion.name)?;
    let leaves: Vec<_> =
        insertion.shapes.iter().filter_map(|s| leaf(s, &insertion.shapes, insertion.map)).collect();
    let swings = matches!(kind, "door" | "double-door") && (1..=2).contains(&leaves.len());
    if swings { swinging(leaves) } else { boxed(kind, insertion) }
}

/// A door by its leaves: its opening reaches from the hinge to where the leaf closes, or to the other hinge.
pub fn swinging(leaves: Vec<Leaf>) -> Option<Placed> {
    let [from, to] = match leaves.as_slice() {
        [one] => [one[0], one[1]],
        [one, other] => [one[0], other[0]],
        _ => return None,
    };
    let kind = if leaves.len() == 2 { "double-door" } else { "door" };
    let centre = [0, 1].map(|i| (from[i] + to[i]) / 2.0);
    let angle = (to[1] - from[1]).atan2(to[0] - from[0]);
    Some(Placed { kind, centre, angle, width: distance(from, to), height: 0.0, leaves })
}

/// The leaf whose swing a shape is: an arc about the hinge. Its leaf is drawn open, as a line from the hinge to one end.
pub fn leaf(arc: &Shape, shapes: &[Shape], map: Map) -> Option<Leaf> {
    let (hinge, radius) = circle(&arc.points)?;
    let ends = [*arc.points.first()?, *arc.points.last()?];
    let near = |a: Point, b: Point| distance(a, b) < 0.15 * radius;
    let drawn = |end: Point| {
        let joins = |pair: &[Point]| {
            near(pair[0], hinge) && near(pair[1], end) || near(pair[1], hinge) && near(pair[0], end)
        };
        shapes.iter().filter(|s| !std::ptr::eq(*s, arc)).any(|s| s.points.windows(2).any(joins))
    };
    let [closed, open] = if drawn(ends[0]) { [ends[1], ends[0]] } else { ends };
    Some([hinge, closed, open].map(|p| map.at(p)))
}

/// Centre and radius of the circle that all points lie on, if they sweep as a door does.
pub fn circle(points: &[Point]) -> Option<(Point, f64)> {
    if points.len() < 6 {
        return None;
    }
    let [a, b, c] = [points[0], points[points.len() / 2], points[points.len() - 1]];
    let double = 2.0 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]));
    let square = |p: Point| p[0] * p[0] + p[1] * p[1];
    let x = (square(a) * (b[1] - c[1]) + square(b) * (c[1] - a[1]) + square(c) * (a[1] - b[1])) / double;
    let y = (square(a) * (c[0] - b[0]) + square(b) * (a[0] - c[0]) + square(c) * (b[0] - a[0])) / double;
    let radius = distance([x, y], a);
    let round = points.iter().all(|&p| (distance(p, [x, y]) - radius).abs() < 0.01 * radius);
    let angle = |p: Point| (p[1] - y).atan2(p[0] - x);
    let half = (angle(b) - angle(a)).rem_euclid(std::f64::consts::TAU);
    let sweep = 2.0 * half.min(std::f64::consts::TAU - half);
    (round && radius > 0.0 && SWING.contains(&sweep)).then_some(([x, y], radius))
}

/// A symbol as large as its block, along the block's own x axis.
fn boxed(kind: &'static str, insertion: &Insertion) -> Option<Placed> {
    let points = || insertion.shapes.iter().flat_map(|s| &s.points);
    let low = [0, 1].map(|i| points().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|i| points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
    let along = insertion.map.turned([high[0] - low[0], 0.0]);
    let across = insertion.map.turned([0.0, high[1] - low[1]]);
    let centre = insertion.map.at([0, 1].map(|i| (low[i] + high[i]) / 2.0));
    let (width, height) = (along[0].hypot(along[1]), across[0].hypot(across[1]));
    let sound = centre.iter().chain([&width, &height]).all(|v| v.is_finite()) && width.max(height) > 0.0;
    // Openings lie along the wall, which is their longer side.
    let turned = (kind == "window" || DOOR_KINDS.contains(&kind)) && height > width;
    let (direction, width, height) = if turned { (across, height, width) } else { (along, width, height) };
    let angle = direction[1].atan2(direction[0]);
    sound.then_some(Placed { kind, centre, angle, width, height, leaves: vec![] })
}

#[cfg(test)]
mod tests {
    use super::super::shapes::arc_points;
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn names_say_what_blocks_are() {
        for (name, expected) in [
            ("DOOR_90", Some("door")),
            ("M_DOUBLE-DOOR", Some("double-door")),
            ("A-WINDOW-12", Some("window")),
            ("WC", Some("toilet")),
            ("WC-01", Some("toilet")),
            ("STAIRS$0", Some("stairs")),
            ("SUPPORT", None),
            ("DOORTAG", None),
            ("CHAIR", None),
        ] {
            assert_eq!(kind(name), expected, "{name}");
        }
    }

    #[test]
    fn a_door_is_known_by_its_swing() {
        let arc = Shape { points: arc_points([0.0; 2], 0.9, 0.0, FRAC_PI_2), width: 0.0, filled: false };
        let leaf = Shape { points: vec![[0.0, 0.0], [0.0, 0.9]], width: 0.0, filled: false };
        let map = Map::shift([5.0, 1.0]).after(Map::turn(FRAC_PI_2));
        let insertion = Insertion { name: "DOOR".into(), map, shapes: vec![leaf, arc] };
        let door = placed(&insertion).unwrap();
        assert_eq!(door.kind, "door");
        let close = |a: Point, b: Point| distance(a, b) < 1e-9;
        assert!(close(door.centre, [5.0, 1.45]) && (door.width - 0.9).abs() < 1e-9, "{door:?}");
        assert!(close(door.leaves[0][0], [5.0, 1.0]) && close(door.leaves[0][2], [4.1, 1.0]), "{door:?}");
        assert!((door.angle - FRAC_PI_2).abs() < 1e-9);
    }

    #[test]
    fn others_are_as_large_as_their_blocks() {
        let frame = Shape { points: vec![[0.0, 0.0], [0.2, 1.5]], width: 0.0, filled: false };
        let insertion = Insertion { name: "WINDOW".into(), map: Map::scale(2.0, 2.0), shapes: vec![frame] };
        let window = placed(&insertion).unwrap();
        assert_eq!((window.centre, window.width, window.height), ([0.2, 1.5], 3.0, 0.4));
        assert!((window.angle - FRAC_PI_2).abs() < 1e-9);
        assert!(placed(&Insertion { name: "WINDOW".into(), map: Map::SAME, shapes: vec![] }).is_none());
    }
}
