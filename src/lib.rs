//! Turns documents that show a building into its layout: rooms, walls, doors.
//!
//! The steps: an input adapter reads a document into a [`Scene`](planform_sdk::Scene), [`reconstruct::reconstruct`]
//! turns the scene into a [`Layout`](planform_sdk::Layout), an exporter writes the layout.

pub mod cli;
pub mod evaluate;
pub mod host;
pub mod reconstruct;
