//! Walls as outlines with their openings cut out, and as centre lines.

use crate::entity::{Entity, Shape, Value};
use crate::joints::{End, Joints, butt, ends};
use crate::layer::Layer;
use crate::openings::Openings;
use planform_sdk::{Layout, Point, Wall};

/// All walls of the layout.
pub fn draw(layout: &Layout) -> Vec<Entity> {
    let joints = Joints::new(&layout.walls);
    let outer = layout.further_doors().map(|door| door.segment);
    let openings = Openings::new(layout.openings.iter().map(|o| o.segment).chain(outer));
    let mut entities = vec![];
    for (i, wall) in layout.walls.iter().enumerate() {
        let data = data(i, wall);
        let outlines =
            outlines(wall, &joints, &openings).into_iter().map(|ring| (Layer::Wall, Shape::Ring(ring)));
        let shapes = outlines.chain([(Layer::WallCentre, Shape::Line(wall.line))]);
        entities.extend(shapes.map(|(layer, shape)| Entity { layer, shape, data: data.clone() }));
    }
    entities
}

fn data(index: usize, wall: &Wall) -> Vec<(&'static str, Value)> {
    let mut data = vec![
        ("kind", "wall".into()),
        ("wall", u32::try_from(index + 1).unwrap_or(u32::MAX).into()),
        ("thickness", wall.thickness.into()),
        ("weight", wall.weight.into()),
    ];
    let sides = ["left", "right"].into_iter().zip(wall.rooms);
    data.extend(sides.filter_map(|(side, room)| Some((side, room?.into()))));
    data
}

/// The outline of each piece of the wall between its openings, counter-clockwise. None for a wall without thickness.
fn outlines(wall: &Wall, joints: &Joints, openings: &Openings) -> Vec<Vec<Point>> {
    let Some([start, end]) = ends(wall) else { return vec![] };
    let length = wall.line.length();
    let outline = |[from, to]: [f64; 2]| {
        let longest_cut = (to - from) / 2.0;
        let corners = |end: &End, jamb: f64| {
            if jamb > 0.0 { butt(&moved(end, jamb)) } else { joints.corners(end, longest_cut) }
        };
        // Each end goes from its left to its right as seen into the wall, so the two make one round.
        corners(&start, from).into_iter().chain(corners(&end, length - to)).collect()
    };
    openings.pieces(wall).into_iter().map(outline).collect()
}

/// The end, moved into the wall.
fn moved(end: &End, by: f64) -> End {
    End { at: Point::new(end.at.x + end.into.x * by, end.at.y + end.into.y * by), ..*end }
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Opening, OpeningKind, Segment, ring_signed_area};

    fn wall(a: [f64; 2], b: [f64; 2], thickness: f64) -> Wall {
        Wall { line: Segment::new(a.into(), b.into()), thickness, weight: 0.9, rooms: [Some(1), None] }
    }

    fn rings(layout: &Layout) -> Vec<Vec<Point>> {
        let ring = |e: Entity| match e.shape {
            Shape::Ring(points) => Some(points),
            _ => None,
        };
        draw(layout).into_iter().filter_map(ring).collect()
    }

    #[test]
    fn a_square_of_walls_covers_just_its_band() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let walls = (0..4).map(|i| wall(corners[i], corners[(i + 1) % 4], 0.2)).collect();
        let area: f64 =
            rings(&Layout { walls, ..Layout::default() }).iter().map(|r| ring_signed_area(r)).sum();
        assert!((area - (4.2 * 4.2 - 3.8 * 3.8)).abs() < 1e-9, "{area}");
    }

    #[test]
    fn an_opening_parts_a_wall_in_two() {
        let segment = Segment::new(Point::new(1.0, 0.0), Point::new(2.0, 0.0));
        let openings = vec![Opening { kind: OpeningKind::Door, segment, rooms: [1, 2] }];
        let layout = Layout { walls: vec![wall([0.0, 0.0], [5.0, 0.0], 0.2)], openings, ..Layout::default() };
        let areas: Vec<_> = rings(&layout).iter().map(|r| ring_signed_area(r)).collect();
        assert_eq!(areas.len(), 2);
        assert!((areas[0] - 0.2).abs() < 1e-9 && (areas[1] - 0.6).abs() < 1e-9, "{areas:?}");
    }

    #[test]
    fn a_wall_without_thickness_is_a_centre_line() {
        let layout = Layout { walls: vec![wall([0.0, 0.0], [5.0, 0.0], 0.0)], ..Layout::default() };
        let entities = draw(&layout);
        assert_eq!(entities.len(), 1);
        assert_eq!(entities[0].layer, Layer::WallCentre);
        assert!(entities[0].data.contains(&("left", 1_u32.into())));
    }
}
