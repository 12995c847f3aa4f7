//! The lines along which the walls of a layout are aligned.

use super::super::Params;
use super::super::collinear::{self, Collinear, Linkage};
use super::super::directions;
use super::super::finish::Frame;
use super::super::lines::{self, Line};
use super::super::straight::StraightWall;
use planform_sdk::{RepresentativeLine, Segment, bounds};

/// Walls this near to one line lie along it, metres: as far as the outlines' alignment may leave them.
const ALONG: f64 = 0.15;

/// How far a line runs on beyond the outermost walls, metres.
const BEYOND: f64 = 0.5;

/// One line for all walls of a direction that lie along it.
pub fn lines(walls: &[StraightWall], params: &Params, frame: &Frame<'_>) -> Vec<RepresentativeLine> {
    let segments: Vec<Segment> = walls.iter().map(|w| w.line).collect();
    let Some((low, high)) = bounds(segments.iter().flat_map(|s| [s.a, s.b])) else { return Vec::new() };
    let around = |p: planform_sdk::Point, by: f64| planform_sdk::Point::new(p.x + by, p.y + by);
    let (low, high) = (around(low, -BEYOND), around(high, BEYOND));
    let directions = directions::cluster(&segments, &params.directions);
    let near = Collinear { distance: ALONG, linkage: Linkage::Complete };
    let found = lines::represent(&collinear::cluster(&directions, &near), &params.lines);
    let line = |l: &Line| {
        let segment = frame.segment(l.within(low, high)?);
        Some(RepresentativeLine { segment, support: l.support })
    };
    found.iter().filter_map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Cell, Grid, Point, Pose};

    #[test]
    fn walls_along_one_line_share_it() {
        let wall = |a: [f64; 2], b: [f64; 2]| StraightWall {
            line: Segment::new(a.into(), b.into()),
            thickness: 0.2,
            weight: 1.0,
            rooms: [Some(0), None],
        };
        let walls = [
            wall([0.0, 0.0], [4.0, 0.0]),
            wall([5.0, 0.05], [9.0, 0.05]),
            wall([0.0, 3.0], [9.0, 3.0]),
            wall([0.0, 0.0], [0.0, 3.0]),
        ];
        let grid = Grid::new(1, 1, 0.5, Pose::default(), vec![Cell::FREE]).unwrap();
        let found = lines(&walls, &Params::default(), &Frame(&grid));
        let supports: Vec<f64> = found.iter().map(|l| l.support).collect();
        assert_eq!(supports, [8.0, 9.0, 3.0]);
        let ends = found[0].segment;
        assert!(ends.a.distance(Point::new(-0.5, 0.025)) < 0.03 && ends.length() > 9.9, "{ends:?}");
    }
}
