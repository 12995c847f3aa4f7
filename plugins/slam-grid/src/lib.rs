//! Input adapter for the occupancy grids that robots save.
//!
//! Two kinds of documents are read:
//!
//! * the YAML file of ROS `map_server` or `nav2_map_server`, with the picture that it names: cells as the robot itself
//!   would load them, in the map's own frame; and the openings between rooms that a map written by planform states;
//! * a bare picture (PNG, PGM and its kin, BMP, TIFF, JPEG): the darker the more occupied, with the grey of unknown
//!   space found from the picture, and the map frame's origin at the picture's lower left corner.

mod bare;
mod document;
mod metadata;
mod mode;
mod options;
mod picture;
mod probe;
mod ros_map;
mod scalar;
mod stated;
mod unknown_grey;

use document::Kind;
use planform_sdk::{Confidence, InputAdapter, Options, PluginError, PluginInfo, Probe, Scene, Source};

/// The adapter `slam-grid`.
///
/// ```
/// let adapter = planform_slam_grid::adapter();
/// assert_eq!(adapter.info().name, "slam-grid");
/// ```
pub fn adapter() -> Box<dyn InputAdapter> {
    Box::new(SlamGrid { info: options::info() })
}

#[cfg(feature = "plugin")]
planform_sdk::export_plugin!(adapters: [adapter()], exporters: []);

struct SlamGrid {
    info: PluginInfo,
}

impl InputAdapter for SlamGrid {
    fn info(&self) -> &PluginInfo {
        &self.info
    }

    fn probe(&self, probe: &Probe<'_>) -> Confidence {
        probe::probe(probe)
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        match document::kind(source)? {
            Kind::Yaml => ros_map::read(source, options),
            Kind::Picture(format) => bare::read(source, format, options),
        }
    }
}
