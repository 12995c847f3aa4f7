//! Doors that are drawn with lines and arcs on a layer of their own, and not inserted as blocks.

use super::plane::{Map, Point, distance};
use super::shapes::Shape;
use super::symbols::{self, Leaf, Placed, leaf, swinging};
use planform_sdk::DOOR_KINDS;
use rstar::primitives::GeomWithData;
use rstar::{AABB, RTree};

/// Leaves of one door meet to this part of their length where they close.
const MEET: f64 = 0.15;

/// What was marked as a door's line lies this near to the door that its leaves show, in parts of its width.
const SAME: f64 = 0.5;

/// Whether doors are drawn on the layer of this name, in upper case.
pub fn is_layer(name: &str) -> bool {
    symbols::kind(name).is_some_and(|kind| DOOR_KINDS.contains(&kind))
}

/// The doors that leaves and their arcs show; and those of `sills`, lines that are said to be doors from jamb to jamb,
/// that none of the leaves belongs to.
pub fn doors(shapes: &[Shape], sills: &[[Point; 2]]) -> Vec<Placed> {
    let mut doors: Vec<Placed> = paired(leaves(shapes)).into_iter().filter_map(swinging).collect();
    let known = RTree::bulk_load(doors.iter().map(|d| d.centre).collect());
    let is_new = |sill: &Placed| {
        let reach = sill.width * SAME;
        let [x, y] = sill.centre;
        let near = AABB::from_corners([x - reach, y - reach], [x + reach, y + reach]);
        known.locate_in_envelope(&near).next().is_none()
    };
    doors.extend(sills.iter().filter_map(sill).filter(is_new));
    doors
}

/// A leaf for each arc that sweeps as doors do. Lines are looked for about the arcs alone: a floor has thousands.
fn leaves(shapes: &[Shape]) -> Vec<Leaf> {
    let ends = |shape: &Shape| [shape.points.first().copied(), shape.points.last().copied()];
    let entries = shapes
        .iter()
        .enumerate()
        .flat_map(|(i, s)| ends(s).into_iter().flatten().map(move |end| GeomWithData::new(end, i)));
    let tree = RTree::bulk_load(entries.collect());
    let about = |arc: &Shape| -> Vec<Shape> {
        let near = ends(arc).into_iter().flatten().flat_map(|[x, y]| {
            let reach = MEET * symbols::circle(&arc.points).map_or(0.0, |(_, radius)| radius);
            tree.locate_in_envelope(&AABB::from_corners([x - reach, y - reach], [x + reach, y + reach]))
        });
        near.map(|entry| shapes[entry.data].clone()).filter(|s| s != arc).collect()
    };
    shapes.iter().filter_map(|arc| leaf(arc, &about(arc), Map::SAME)).collect()
}

/// Leaves that close against each other together, the others alone.
fn paired(leaves: Vec<Leaf>) -> Vec<Vec<Leaf>> {
    let closed =
        RTree::bulk_load(leaves.iter().enumerate().map(|(i, leaf)| GeomWithData::new(leaf[1], i)).collect());
    let mut taken = vec![false; leaves.len()];
    let mut doors = vec![];
    for (i, leaf) in leaves.iter().enumerate() {
        if std::mem::replace(&mut taken[i], true) {
            continue;
        }
        let reach = MEET * distance(leaf[0], leaf[1]);
        let near = closed.locate_within_distance(leaf[1], reach.powi(2)).map(|entry| entry.data);
        let other = near.filter(|&o| !taken[o] && are_opposite(leaf, &leaves[o])).min();
        doors.push([Some(i), other].into_iter().flatten().map(|i| leaves[i]).collect());
        other.iter().for_each(|&o| taken[o] = true);
    }
    doors
}

/// Whether the hinges lie at the two ends of one opening.
fn are_opposite(one: &Leaf, other: &Leaf) -> bool {
    let lengths = distance(one[0], one[1]) + distance(other[0], other[1]);
    distance(one[0], other[0]) > (1.0 - MEET) * lengths
}

fn sill(&[a, b]: &[Point; 2]) -> Option<Placed> {
    let centre = [0, 1].map(|i| (a[i] + b[i]) / 2.0);
    let (width, angle) = (distance(a, b), (b[1] - a[1]).atan2(b[0] - a[0]));
    (width > 0.0).then(|| Placed { kind: "door", centre, angle, width, height: 0.0, leaves: vec![] })
}

#[cfg(test)]
mod tests {
    use super::super::shapes::arc_points;
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    fn shape(points: Vec<Point>) -> Shape {
        Shape { points, width: 0.0, filled: false }
    }

    /// An open leaf, hinged here, that closes to the right (or left) and opens upwards.
    fn drawn(hinge: Point, width: f64, right: bool) -> [Shape; 2] {
        let from = if right { 0.0 } else { FRAC_PI_2 };
        [shape(vec![hinge, [hinge[0], hinge[1] + width]]), shape(arc_points(hinge, width, from, FRAC_PI_2))]
    }

    #[test]
    fn layers_of_doors_are_known() {
        for name in ["A-DOOR", "TÜREN", "01_PORTE", "A-DOOR-FULL"] {
            assert!(is_layer(name), "{name}");
        }
        for name in ["A-WALL", "OUTDATED", "A-GLAZ", "WINDOWS", "0"] {
            assert!(!is_layer(name), "{name}");
        }
    }

    #[test]
    fn a_leaf_and_its_arc_are_a_door_and_two_that_meet_a_double_one() {
        let shapes =
            [drawn([0.0, 0.0], 0.9, true), drawn([5.0, 0.0], 0.8, true), drawn([6.6, 0.0], 0.8, false)];
        let doors = doors(&shapes.concat(), &[]);
        let found: Vec<_> = doors.iter().map(|d| (d.kind, d.centre[0], d.width)).collect();
        let close = |(kind, x, width): (&str, f64, f64), to: (&str, f64, f64)| {
            kind == to.0 && (x - to.1).abs() < 1e-9 && (width - to.2).abs() < 1e-9
        };
        assert!(found.len() == 2 && close(found[0], ("door", 0.45, 0.9)), "{found:?}");
        assert!(close(found[1], ("double-door", 5.8, 1.6)), "{found:?}");
    }

    #[test]
    fn a_marked_line_is_a_door_unless_a_leaf_shows_it() {
        let shapes = drawn([0.0, 0.0], 0.9, true);
        let doors = doors(&shapes, &[[[0.0, 0.0], [0.9, 0.0]], [[3.0, 1.0], [3.0, 2.0]]]);
        let widths: Vec<_> = doors.iter().map(|d| (d.width, d.leaves.len())).collect();
        assert_eq!(doors.len(), 2, "{widths:?}");
        assert_eq!((doors[1].centre, doors[1].width), ([3.0, 1.5], 1.0));
        assert!((doors[1].angle.abs() - FRAC_PI_2).abs() < 1e-9 && doors[1].angle < PI);
    }

    #[test]
    fn other_lines_are_no_doors() {
        let round = shape(arc_points([0.0; 2], 1.0, 0.0, TAU));
        let line = shape(vec![[0.0, 0.0], [4.0, 0.0]]);
        assert_eq!(doors(&[round, line], &[[[1.0, 1.0], [1.0, 1.0]]]), vec![]);
    }
}
