//! What a document itself shows of rooms: doors, and where something is written. Robots' maps show neither.

use super::doors::{self, Door};
use super::{measures, names};
use planform_sdk::{Point, Scene, Text};

/// What is known of a scene's rooms, metres from the grid's corner.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// The doors.
    pub doors: Vec<Door>,
    /// The middles of texts that may be rooms' names or numbers.
    pub labels: Vec<Point>,
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
        Self { doors: doors::of_scene(scene), labels }
    }
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
