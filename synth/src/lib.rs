//! Synthetic buildings with known truth, for tests, benchmarks and first steps.
//!
//! [`Building::generate`] draws a building from a seed; [`Building::layout`] is its true layout,
//! [`Building::clean_grid`] its exact raster, and [`Building::scan`] the map that a robot with a laser would make of
//! it. The same seed gives the same bytes. [`Sample::draw`] makes a map with its truth of any kind of building, for
//! training. [`Plan::draw`] draws a building as people do: a blueprint or an evacuation plan, with its truth.

mod blocks;
mod building;
mod corridors;
mod doors;
mod draft;
mod drift;
mod drive;
mod fixtures;
mod furniture;
mod house;
mod lattice;
mod obstacles;
mod parallel;
mod params;
mod partition;
mod plan;
mod raster;
mod rng;
mod sample;
mod scan;
mod scan_params;
mod shape;
mod shrink;
mod structure;
mod variety;
mod walls;
mod wing;

pub use building::Building;
pub use fixtures::{SimpleParams, corridor_with_rooms, simple, two_rooms};
pub use parallel::parallel_map;
pub use params::{BuildingParams, RoomKind, Size};
pub use plan::{Plan, PlanLeaf, PlanName, PlanStyle, PlanSymbol, PlanText, PlanTextRole, PlanTruth};
pub use raster::{Labels, Outline};
pub use sample::Sample;
pub use scan::{RoomView, Scan};
pub use scan_params::{Laser, Noise, Output, ScanParams};
pub use shrink::shrunk;
pub use variety::Variety;
