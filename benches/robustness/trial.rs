//! One building, one drive through it, and the layout of the map that came of it.

use crate::accuracy_support::shapes;
use planform::evaluate::{Measures, Settings, evaluate_rooms};
use planform::reconstruct::{Params, reconstruct};
use planform_sdk::{Grid, Layout, Provenance, Scene};
use planform_synth::{Building, BuildingParams, Scan, ScanParams, Size};

/// The measures that are shown, as `planform evaluate` calls them.
pub const MEASURES: [&str; 5] = ["A_FC", "A_BC", "P", "R", "mIoU"];

/// A building and how it is mapped.
pub struct Trial {
    seed: u64,
    pub building: BuildingParams,
    pub scan: ScanParams,
}

impl Trial {
    /// The usual map of a house, an office floor or a school floor, in turn.
    pub fn usual(seed: u64) -> Self {
        let size = [Size::House, Size::Office, Size::School][(seed % 3) as usize];
        let scan = ScanParams { seed, ..ScanParams::default() };
        Self { seed, building: BuildingParams::of_size(size), scan }
    }

    /// The building and what the robot brought home.
    pub fn map(&self) -> (Building, Scan) {
        let building = Building::generate(self.seed, &self.building);
        let scan = building.scan(&self.scan).unwrap();
        (building, scan)
    }

    /// How well the layout fits the rooms of which the robot saw something.
    pub fn measures(&self) -> [f64; 5] {
        let (building, scan) = self.map();
        let truth = shapes(&scan.seen_layout(building.layout()));
        let scores = evaluate_rooms(shapes(&layout(scan.grid)), truth, &Settings::default()).unwrap();
        let Measures { a_fc, a_bc, precision, recall, miou, .. } = scores.clipped.measures;
        [a_fc, a_bc, precision, recall, miou]
    }
}

/// The layout with the default parameters; that of a map which shows no walls has no rooms, and scores 0.
pub fn layout(grid: Grid) -> Layout {
    reconstruct(&Scene::of_grid(grid, Provenance::default()), &Params::default(), &mut ()).unwrap_or_default()
}
