//! The one list of built-in plugins, and behind it those from outside.

use super::outside::{Loaded, Outside, OutsideSettings, Refusal, Taken};
use planform_sdk::{Exporter, InputAdapter};
use std::path::Path;

/// The input adapters and exporters that a run can choose from, in the order in which ties are decided.
///
/// The built-in ones come first, and those from outside are loaded only when none of these will do: what a run does
/// with a document that planform knows does not depend on what is installed beside it.
pub struct Registry {
    adapters: Vec<Box<dyn InputAdapter>>,
    exporters: Vec<Box<dyn Exporter>>,
    outside: Outside,
}

/// Where a plugin comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin<'a> {
    /// Linked into the program.
    BuiltIn,
    /// In this library.
    Library(&'a Path),
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
        Self { adapters, exporters, outside: Outside::new(None) }
    }

    /// The same with those from outside that these settings lead to.
    pub fn with_outside(self, settings: OutsideSettings) -> Self {
        let taken = Taken {
            adapters: self.builtin_adapters().map(|a| a.info().name.clone()).collect(),
            exporters: self.builtin_exporters().map(|e| e.info().name.clone()).collect(),
        };
        Self { outside: Outside::new(Some((settings, taken))), ..self }
    }

    /// The built-in input adapters.
    pub fn builtin_adapters(&self) -> impl Iterator<Item = &dyn InputAdapter> {
        self.adapters.iter().map(AsRef::as_ref)
    }

    /// The built-in exporters.
    pub fn builtin_exporters(&self) -> impl Iterator<Item = &dyn Exporter> {
        self.exporters.iter().map(AsRef::as_ref)
    }

    /// All input adapters with their origins. Loads those from outside.
    pub fn adapters(&self) -> impl Iterator<Item = (&dyn InputAdapter, Origin<'_>)> {
        let outside = self.outside.loaded().adapters.iter();
        let outside = outside.map(|o| (o as &dyn InputAdapter, Origin::Library(&o.library)));
        self.builtin_adapters().map(|a| (a, Origin::BuiltIn)).chain(outside)
    }

    /// All exporters with their origins. Loads those from outside.
    pub fn exporters(&self) -> impl Iterator<Item = (&dyn Exporter, Origin<'_>)> {
        let outside = self.outside.loaded().exporters.iter();
        let outside = outside.map(|o| (o as &dyn Exporter, Origin::Library(&o.library)));
        self.builtin_exporters().map(|e| (e, Origin::BuiltIn)).chain(outside)
    }

    /// What was found outside and is not used, as far as anything was loaded.
    pub fn refusals(&self) -> &[Refusal] {
        self.outside.refusals()
    }

    /// The plugins from outside, with what was found and is not used. Loads them.
    pub fn outside(&self) -> &Loaded {
        self.outside.loaded()
    }

    /// The input adapter of this name.
    pub fn adapter(&self, name: &str) -> Option<&dyn InputAdapter> {
        let builtin = self.builtin_adapters().find(|a| a.info().name == name);
        builtin.or_else(|| self.adapters().map(|(a, _)| a).find(|a| a.info().name == name))
    }

    /// The exporter of this name.
    pub fn exporter(&self, name: &str) -> Option<&dyn Exporter> {
        let builtin = self.builtin_exporters().find(|e| e.info().name == name);
        builtin.or_else(|| self.exporters().map(|(e, _)| e).find(|e| e.info().name == name))
    }

    /// The exporter that writes files with this path's extension, in whatever case.
    pub fn exporter_for(&self, path: &Path) -> Option<&dyn Exporter> {
        let extension = path.extension()?.to_str()?.to_lowercase();
        let writes = |e: &&dyn Exporter| e.info().extensions.contains(&extension);
        self.builtin_exporters().find(writes).or_else(|| self.exporters().map(|(e, _)| e).find(writes))
    }
}
