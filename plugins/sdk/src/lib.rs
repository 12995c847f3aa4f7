//! The contract between planform and its plugins.
//!
//! A document goes through three forms, and this crate defines them and the two traits between them:
//!
//! ```text
//! document --InputAdapter--> Scene --reconstruct--> Layout --Exporter--> file
//! ```
//!
//! * [`Grid`]: an occupancy grid with its place in the map frame;
//! * [`Scene`]: a grid and what else the document showed (texts, symbols, a geographic anchor);
//! * [`Layout`]: rooms, walls, openings, frontiers, in metres in the map frame, x right, y up.
//!
//! The crate has no opinion on formats and no knowledge of the reconstruction.

pub mod abi;
mod adapter;
mod anchor;
mod boundary;
mod error;
mod exporter;
mod fitting;
mod geometry;
mod grid;
mod kept;
mod layout;
mod options;
pub mod parallel;
pub mod runs;
mod scene;
pub mod schema;
mod watch;

pub use adapter::{Confidence, InputAdapter, Probe, Source};
pub use anchor::Bearing;
pub use boundary::Boundary;
pub use error::{ErrorKind, Place, PluginError};
pub use exporter::{Document, Exporter, Output, WriteFn, exporter};
pub use fitting::Fitting;
pub use geometry::{Point, Polygon, Pose, Segment, bounds, ring_signed_area};
pub use grid::{Cell, Grid, GridError, MAX_CELLS, MAX_SIDE};
pub use kept::Kept;
pub use layout::{
    Frontier, FrontierKind, GraphEdge, Layout, Opening, OpeningKind, RepresentativeLine, Room, RoomGraph,
    RoomId, RoomState, Wall,
};
pub use options::{Bounds, OptionKind, OptionSpec, OptionValue, Options, PluginInfo};
pub use scene::{
    Annotations, DOOR_KINDS, DoorLeaf, GeoAnchor, Provenance, Scale, Scene, StatedOpening, Symbol, Text,
};
pub use watch::{Picture, ReadWatcher};
