//! Input adapter for the laser logs of robots, as the Robotics Data Set Repository (Radish) keeps them.
//!
//! A log in CARMEN's text format is read, plain or packed with gzip or bzip2, and its laser scans are drawn to an
//! occupancy grid, each from its pose. The map frame is the frame of the poses.

mod adapter;
pub mod log;
pub mod mapping;
pub mod matching;
mod options;
mod paint;
pub mod picture;
mod poses;
mod probe;
pub mod unpack;

pub use adapter::adapter;

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [adapter()], exporters: []);
