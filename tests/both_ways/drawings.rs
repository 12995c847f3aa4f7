//! What exporters are given: layouts of several buildings, with and without the scene they were found in.

use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{
    Annotations, Document, DoorLeaf, GeoAnchor, Grid, Layout, Point, Pose, Provenance, Scale, Scene, Symbol,
    Text,
};
use planform_synth::{Building, BuildingParams, ScanParams, Size, corridor_with_rooms, two_rooms};

pub struct Drawing {
    pub name: &'static str,
    layout: Layout,
    scene: Option<Scene>,
}

impl Drawing {
    pub fn document(&self) -> Document<'_> {
        Document { layout: &self.layout, scene: self.scene.as_ref() }
    }
}

fn annotations() -> Annotations {
    let pose = Pose { x: 1.0 / 3.0, y: -0.0, yaw: 0.3 };
    Annotations {
        texts: vec![Text {
            content: "Küche \0 <&> %%d \u{1f6aa}".into(),
            pose,
            width: 1.2,
            height: 0.3,
            confidence: 0.5,
        }],
        symbols: vec![Symbol {
            kind: "door".into(),
            pose,
            width: 0.9,
            height: 0.9,
            score: 1.0,
            leaves: vec![DoorLeaf {
                hinge: Point::new(1.0 / 3.0, -0.0),
                closed: Point::new(1.2, 5e-324),
                open: Point::new(0.3, 0.9),
            }],
        }],
        openings: None,
        anchor: Some(GeoAnchor {
            latitude: 47.4,
            longitude: 8.5,
            bearing: -3.0,
            at: Point::new(0.1 + 0.2, 5e-324),
        }),
        scale: Some(Scale {
            metres_per_pixel: 0.1 + 0.2,
            source: "Maß \0 1:100".into(),
            confidence: 1.0 / 3.0,
        }),
        provenance: Provenance { source: "Erdgeschoß & Hof.png".into(), adapter: "by-hand".into() },
        warnings: vec!["the scale was guessed".into()],
    }
}

/// A house that a robot saw in part.
fn seen_in_part() -> Drawing {
    let house = Building::generate(5, &BuildingParams::of_size(Size::House));
    let grid = house.scan(&ScanParams { seed: 5, unexplored: 0.5, ..ScanParams::default() }).unwrap().grid;
    let scene = Scene::new(grid, annotations());
    let mut layout = reconstruct(&scene, &Params::default(), &mut ()).unwrap();
    layout.rooms[0].name = Some("Büro \"Süd\"\r\n\0".into());
    Drawing { name: "a house seen in part", layout, scene: Some(scene) }
}

/// The grid elsewhere in the map frame.
fn turned(grid: Grid) -> Grid {
    let origin = Pose { x: 0.1 + 0.2, y: -7.0, yaw: 0.3 };
    Grid::new(grid.width(), grid.height(), grid.resolution(), origin, grid.cells().to_vec()).unwrap()
}

/// Rooms with a coordinate that no drawing can hold.
fn absurd() -> Layout {
    let mut layout = two_rooms().layout().clone();
    layout.rooms[0].inner.exterior[0] = Point::new(f64::MAX, -f64::MAX);
    layout
}

pub fn all() -> Vec<Drawing> {
    let corridor = corridor_with_rooms(6);
    let scene = Scene::of_grid(turned(corridor.clean_grid(0.05).unwrap()), Provenance::default());
    let office = Building::generate(4, &BuildingParams::of_size(Size::Office));
    let bare = |name, layout| Drawing { name, layout, scene: None };
    vec![
        bare("nothing", Layout::default()),
        bare("two rooms", two_rooms().layout().clone()),
        Drawing { name: "a corridor", layout: corridor.layout().clone(), scene: Some(scene) },
        bare("an office", office.layout().clone()),
        bare("an absurd coordinate", absurd()),
        seen_in_part(),
    ]
}
