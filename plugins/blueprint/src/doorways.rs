//! Doors as they stand in their walls, and what their width says of the scale.

use crate::found::SheetSymbol;
use std::f64::consts::FRAC_PI_2;

/// Walls run along the sheet or across it; a door found within this angle of that is one of theirs, radians: its leaf and
/// its arc are short, and tell its direction less exactly.
const NEAR: f64 = 0.32;

/// The usual clear opening of a door with a single leaf, metres.
pub const USUAL_WIDTH: f64 = 0.9;

/// How wide the single doors of a sheet are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Widths {
    /// The median, pixels; more than 0.
    pub median: f64,
    /// How many there are.
    pub count: usize,
}

impl Widths {
    /// Of the single doors among the symbols; `None` if there are none.
    pub fn of_single(symbols: &[SheetSymbol]) -> Option<Self> {
        let single = symbols.iter().filter(|s| s.kind == "door" && s.width > 0.0);
        let mut widths: Vec<f64> = single.map(|s| s.width).collect();
        widths.sort_by(f64::total_cmp);
        widths.get(widths.len() / 2).map(|&median| Self { median, count: widths.len() })
    }

    /// The scale at which the median door is as wide as doors usually are.
    pub fn metres_per_pixel(&self) -> f64 {
        USUAL_WIDTH / self.median
    }
}

/// Turns a door into the direction of the sheet's nearest axis, if that is near, about its hinge.
pub fn straighten(door: &mut SheetSymbol) {
    let axis = (door.angle / FRAC_PI_2).round() * FRAC_PI_2;
    let turn = axis - door.angle;
    if door.leaves.is_empty() || turn == 0.0 || turn.abs() > NEAR {
        return;
    }
    let about = if let [leaf] = door.leaves[..] { leaf.hinge } else { door.centre };
    let (sin, cos) = turn.sin_cos();
    let turned = |[x, y]: [f64; 2]| {
        let (dx, dy) = (x - about[0], y - about[1]);
        [about[0] + cos * dx - sin * dy, about[1] + sin * dx + cos * dy]
    };
    door.angle = axis;
    door.centre = turned(door.centre);
    for leaf in &mut door.leaves {
        [leaf.hinge, leaf.closed, leaf.open] = [leaf.hinge, leaf.closed, leaf.open].map(turned);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::found::SheetLeaf;

    fn door(angle: f64) -> SheetSymbol {
        let at = |r: f64| [10.0 + r * angle.cos(), 20.0 + r * angle.sin()];
        let leaf = SheetLeaf { hinge: [10.0, 20.0], closed: at(30.0), open: [10.0, -10.0] };
        let (kind, leaves) = ("door".into(), vec![leaf]);
        SheetSymbol { kind, centre: at(15.0), angle, width: 30.0, height: 4.0, score: 1.0, leaves }
    }

    #[test]
    fn a_door_turns_about_its_hinge_into_the_wall() {
        let mut found = door(0.2);
        straighten(&mut found);
        assert_eq!((found.angle, found.leaves[0].hinge), (0.0, [10.0, 20.0]));
        assert!((found.centre[0] - 25.0).abs() < 1e-9 && (found.leaves[0].closed[1] - 20.0).abs() < 1e-9);
    }

    #[test]
    fn the_median_of_single_doors_tells_the_scale() {
        let of = |kind: &str, width| SheetSymbol { kind: kind.into(), width, ..door(0.0) };
        let doors = [of("door", 45.0), of("double-door", 90.0), of("door", 44.0), of("door", 90.0)];
        let widths = Widths::of_single(&doors).unwrap();
        assert_eq!(widths, Widths { median: 45.0, count: 3 });
        assert!((widths.metres_per_pixel() - 0.02).abs() < 1e-12);
        assert_eq!(Widths::of_single(&[of("double-door", 90.0), of("door", 0.0)]), None);
    }

    #[test]
    fn a_door_in_a_slanting_wall_stays() {
        let mut found = door(0.7);
        straighten(&mut found);
        assert_eq!(found, door(0.7));
    }
}
