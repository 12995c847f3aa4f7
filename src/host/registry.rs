//! The one list of built-in plugins.

use planform_sdk::{Exporter, InputAdapter};
use std::path::Path;

/// The input adapters and exporters that a run can choose from, in the order in which ties are decided.
pub struct Registry {
    adapters: Vec<Box<dyn InputAdapter>>,
    exporters: Vec<Box<dyn Exporter>>,
}

impl Registry {
    /// The plugins linked into the program.
    pub fn builtin() -> Self {
        Self::new(
            vec![planform_slam_grid::adapter()],
            vec![planform_svg::exporter(), planform_dxf::exporter(), planform_geojson::exporter()],
        )
    }

    /// A registry of these plugins.
    pub fn new(adapters: Vec<Box<dyn InputAdapter>>, exporters: Vec<Box<dyn Exporter>>) -> Self {
        Self { adapters, exporters }
    }

    /// All input adapters.
    pub fn adapters(&self) -> impl Iterator<Item = &dyn InputAdapter> {
        self.adapters.iter().map(AsRef::as_ref)
    }

    /// All exporters.
    pub fn exporters(&self) -> impl Iterator<Item = &dyn Exporter> {
        self.exporters.iter().map(AsRef::as_ref)
    }

    /// The input adapter of this name.
    pub fn adapter(&self, name: &str) -> Option<&dyn InputAdapter> {
        self.adapters().find(|a| a.info().name == name)
    }

    /// The exporter of this name.
    pub fn exporter(&self, name: &str) -> Option<&dyn Exporter> {
        self.exporters().find(|e| e.info().name == name)
    }

    /// The exporter that writes files with this path's extension, in whatever case.
    pub fn exporter_for(&self, path: &Path) -> Option<&dyn Exporter> {
        let extension = path.extension()?.to_str()?.to_lowercase();
        self.exporters().find(|e| e.info().extensions.contains(&extension))
    }
}
