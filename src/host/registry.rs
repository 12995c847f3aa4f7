//! The one list of built-in plugins, and behind it those from outside.

use super::outside::{Loaded, Outside, OutsideSettings, Refusal, Taken};
use planform_sdk::{Exporter, InputAdapter};
use std::cmp::Reverse;
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
            vec![planform_slam_grid::adapter(), planform_blueprint::adapter(), planform_radish::adapter()],
            vec![
                planform_svg::exporter(),
                planform_dxf::exporter(),
                planform_geojson::exporter(),
                planform_json::exporter(),
                planform_ros_map::exporter(),
                planform_graph::exporter(),
            ],
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

    /// The built-in exporter of this name.
    pub fn builtin_exporter(&self, name: &str) -> Option<&dyn Exporter> {
        self.builtin_exporters().find(|e| e.info().name == name)
    }

    /// The built-in exporter that writes files with this path's extension, as [`exporter_for`](Self::exporter_for).
    pub fn builtin_exporter_for(&self, path: &Path) -> Option<&dyn Exporter> {
        longest(self.builtin_exporters(), &file_name(path)?)
    }

    /// The exporter of this name.
    pub fn exporter(&self, name: &str) -> Option<&dyn Exporter> {
        self.builtin_exporter(name)
            .or_else(|| self.exporters().map(|(e, _)| e).find(|e| e.info().name == name))
    }

    /// The exporter that writes files with this path's extension, in whatever case: that with the longest extension, as
    /// `plan.layout.json` is not just any `.json`. Those from outside are asked only if no built-in one will do.
    pub fn exporter_for(&self, path: &Path) -> Option<&dyn Exporter> {
        let outside = || longest(self.exporters().map(|(e, _)| e), &file_name(path)?);
        self.builtin_exporter_for(path).or_else(outside)
    }
}

/// The path's last part in lower case.
fn file_name(path: &Path) -> Option<String> {
    Some(path.file_name()?.to_string_lossy().to_lowercase())
}

/// The exporter with the longest extension that this file name has, the first of several.
fn longest<'a>(
    exporters: impl Iterator<Item = &'a dyn Exporter>,
    file_name: &str,
) -> Option<&'a dyn Exporter> {
    let matching = exporters.filter_map(|e| Some((extension_length(e, file_name)?, e)));
    matching.min_by_key(|(length, _)| Reverse(*length)).map(|(_, exporter)| exporter)
}

/// The length of the exporter's longest extension that this file name has, after something and a dot.
fn extension_length(exporter: &dyn Exporter, file_name: &str) -> Option<usize> {
    let stem = |extension: &str| file_name.strip_suffix(extension)?.strip_suffix('.');
    let has = |extension: &&String| stem(extension).is_some_and(|stem| !stem.is_empty());
    exporter.info().extensions.iter().filter(has).map(String::len).max()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::PluginInfo;

    fn exporter(name: &str, extensions: &[&str]) -> Box<dyn Exporter> {
        let info = PluginInfo {
            name: name.into(),
            description: String::new(),
            version: String::new(),
            licence: String::new(),
            extensions: extensions.iter().map(|e| (*e).to_owned()).collect(),
            media_types: vec![],
            options: vec![],
        };
        planform_sdk::exporter(info, |_, _, _| Ok(()))
    }

    #[test]
    fn the_longest_extension_tells_the_exporter() {
        let exporters = vec![
            exporter("any", &["json", "b.json"]),
            exporter("late", &["a.b.json", "json"]),
            exporter("longest", &["x.a.b.json"]),
        ];
        let registry = Registry::new(vec![], exporters);
        let name = |path: &str| registry.exporter_for(Path::new(path)).map(|e| e.info().name.as_str());
        for (path, expected) in [
            ("plan.json", Some("any")),
            ("plan.B.JSON", Some("any")),
            ("folder.a.b.json/plan.json", Some("any")),
            ("plan.a.b.json", Some("late")),
            ("Straße.A.b.Json", Some("late")),
            ("1.x.a.b.json", Some("longest")),
            ("x.a.b.json", Some("late")),
            (".json", None),
            ("json", None),
            ("planjson", None),
            ("plan.json.gz", None),
            ("..", None),
        ] {
            assert_eq!(name(path), expected, "{path}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn names_need_not_be_utf8() {
        use std::os::unix::ffi::OsStrExt;
        let registry = Registry::builtin();
        let path = Path::new(std::ffi::OsStr::from_bytes(b"caf\xe9.svg"));
        assert_eq!(registry.exporter_for(path).unwrap().info().name, "svg");
    }

    #[test]
    fn json_is_geojson_unless_it_is_a_layout() {
        let registry = Registry::builtin();
        let name = |path: &str| registry.exporter_for(Path::new(path)).unwrap().info().name.as_str();
        assert_eq!(["a.json", "a.layout.json", "layout.json"].map(name), ["geojson", "json", "geojson"]);
    }
}
