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
mod grey;
mod metadata;
mod mode;
mod options;
mod picture;
mod probe;
mod ros_map;
mod scalar;
mod stated;
mod unknown_grey;
mod wide;

use document::Kind;
use planform_sdk::{
    Confidence, InputAdapter, Kept, Options, PluginError, PluginInfo, Probe, ReadWatcher, Scene, Source,
};

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

    fn siblings(&self, source: &Source) -> Vec<String> {
        let is_map = matches!(document::kind(source), Ok(Kind::Yaml));
        is_map.then(|| metadata::image_of(&source.bytes)).flatten().into_iter().collect()
    }

    fn read(&self, source: &Source, options: &Options) -> Result<Scene, PluginError> {
        self.read_looked_at(source, Kept::default(), options, &mut ())
    }

    fn read_looked_at(
        &self,
        source: &Source,
        kept: Kept,
        options: &Options,
        _: &mut dyn ReadWatcher,
    ) -> Result<Scene, PluginError> {
        match document::kind(source)? {
            Kind::Yaml => ros_map::read(source, options),
            Kind::Picture(format) => bare::read(source, format, kept, options),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_has_its_picture_beside_it() {
        let siblings = |name: &str, text: &str| {
            adapter().siblings(&Source { path: name.into(), bytes: text.into(), byte_limit: 1 << 20 })
        };
        assert_eq!(siblings("m.yaml", "image: a b.pgm\nresolution: 0.05\n"), ["a b.pgm"]);
        assert_eq!(siblings("m.yaml", "image: a.pgm\nresolution: none\n"), ["a.pgm"]);
        for (name, text) in [
            ("m.yaml", "resolution: 0.05\n"),
            ("m.yaml", "image: ''\n"),
            ("m.yaml", "image: [a\n"),
            ("m.png", "image: a.pgm\n"),
            ("m.pgm", "P2 1 1 255 0"),
            ("m.yaml", ""),
        ] {
            assert_eq!(siblings(name, text), Vec::<String>::new(), "{text}");
        }
    }
}
