//! What a document itself shows of rooms: doors, where something is written, and where one room ends and the next
//! begins. Maps as robots make them show nothing of it.

use super::doors::{self, Door};
use super::{measures, names};
use planform_sdk::{Point, Scene, Segment, StatedOpening, Text};

/// What is known of a scene's rooms, metres from the grid's corner.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// The doors.
    pub doors: Vec<Door>,
    /// The middles of texts that may be rooms' names or numbers.
    pub labels: Vec<Point>,
    /// All openings between rooms, if the document states them.
    pub openings: Option<Vec<StatedOpening>>,
}

impl Shown {
    /// What a scene shows.
    pub fn of_scene(scene: &Scene) -> Self {
        let labels = scene
            .texts
            .iter()
            .filter(|t| is_label(t))
            .map(|t| from_corner(scene, Point::new(t.pose.x, t.pose.y)))
            .collect();
        Self { doors: doors::of_scene(scene), labels, openings: openings(scene) }
    }

    /// The ends of the stated openings: they stand in walls.
    pub fn jambs(&self) -> Vec<Point> {
        self.openings.iter().flatten().flat_map(|o| [o.segment.a, o.segment.b]).collect()
    }
}

fn openings(scene: &Scene) -> Option<Vec<StatedOpening>> {
    let place = |p: Point| from_corner(scene, p);
    let moved = |o: &StatedOpening| {
        let segment = Segment::new(place(o.segment.a), place(o.segment.b));
        StatedOpening { segment, ..*o }
    };
    Some(scene.openings.as_ref()?.iter().map(moved).collect())
}

fn is_label(text: &Text) -> bool {
    names::is_said(text) && measures::part(&text.content).words.contains(char::is_alphanumeric)
}

/// Where a point of the map frame lies, metres from the grid's corner.
pub fn from_corner(scene: &Scene, point: Point) -> Point {
    let (cells, resolution) = (scene.grid.to_cells(point), scene.grid.resolution());
    Point::new(cells.x * resolution, cells.y * resolution)
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::Pose;

    fn text(content: &str, confidence: f64) -> Text {
        let pose = Pose { x: 1.0, y: 2.0, yaw: 0.0 };
        Text { content: content.into(), pose, width: 1.0, height: 0.2, confidence }
    }

    #[test]
    fn names_and_numbers_are_labels_and_measures_are_none() {
        for (content, is) in
            [("Kitchen", true), ("209", true), ("24.5 m²", false), ("5.2 x 3.1 m", false), ("-", false)]
        {
            assert_eq!(is_label(&text(content, 0.9)), is, "{content}");
        }
        assert!(!is_label(&text("Kitchen", 0.3)));
    }
}
