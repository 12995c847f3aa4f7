//! Accuracy of a layout against a ground truth.
//!
//! The measures are those of Bormann et al., "Room Segmentation: Survey, Implementation, and Analysis" (2016), and of
//! the paper that planform follows, all counted in pixels of the truth ([`measures`]). A truth is a label image
//! ([`labels`]) or a GeoJSON layout, which is drawn as a fine label image first ([`truth`]).
//!
//! [`evaluate`] compares one prediction with its truth, [`evaluate_rooms`] does so without files, and [`evaluate_set`]
//! all maps of a manifest.

pub mod labels;
pub mod manifest;
pub mod measures;
pub mod raster;
pub mod report;
pub mod rooms;
pub mod truth;

mod budget;
mod components;
mod error;
mod frame;
mod overlap;
mod pair;
mod picture;

pub use error::EvaluateError;
pub use frame::{Frame, Units};
pub use labels::{LabelImage, LabelMode};
pub use manifest::{SetScores, Summary, evaluate_set};
pub use measures::{Clip, Measures, RoomScore, Score};
pub use overlap::{Overlap, PredictedRoom};
pub use pair::{Scores, Settings, evaluate, evaluate_rooms};
pub use rooms::RoomShape;

/// The smallest room, in pixels, unless the user or the manifest says otherwise: 0.25 square metres at 0.05 m, as in
/// Bormann et al.
pub const MIN_PX: u64 = 100;

/// The most rooms of one layout.
pub const MAX_ROOMS: usize = 1 << 16;
