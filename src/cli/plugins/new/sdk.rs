//! The copy of planform-sdk that projects in Rust carry.

use super::File;
use toml::Table;

const MANIFEST: &str = include_str!("../../../../plugins/sdk/Cargo.toml");

/// Each of these files of the repository with its text.
macro_rules! embedded {
    ($($path:literal)*) => { &[$(($path, include_str!(concat!("../../../../", $path)))),*] };
}

const SOURCES: &[(&str, &str)] = embedded![
    "plugins/sdk/src/abi/grid.rs"
    "plugins/sdk/src/abi/guard.rs"
    "plugins/sdk/src/abi/host/adapter.rs"
    "plugins/sdk/src/abi/host/exporter.rs"
    "plugins/sdk/src/abi/host/fault.rs"
    "plugins/sdk/src/abi/host/info.rs"
    "plugins/sdk/src/abi/host/json.rs"
    "plugins/sdk/src/abi/host/mod.rs"
    "plugins/sdk/src/abi/host/scene.rs"
    "plugins/sdk/src/abi/host/value.rs"
    "plugins/sdk/src/abi/mod.rs"
    "plugins/sdk/src/abi/plugin/adapter.rs"
    "plugins/sdk/src/abi/plugin/exporter.rs"
    "plugins/sdk/src/abi/plugin/info.rs"
    "plugins/sdk/src/abi/plugin/mod.rs"
    "plugins/sdk/src/abi/plugin/problem.rs"
    "plugins/sdk/src/abi/plugin/received.rs"
    "plugins/sdk/src/abi/string.rs"
    "plugins/sdk/src/abi/table.rs"
    "plugins/sdk/src/abi/types.rs"
    "plugins/sdk/src/adapter.rs"
    "plugins/sdk/src/anchor.rs"
    "plugins/sdk/src/boundary.rs"
    "plugins/sdk/src/error.rs"
    "plugins/sdk/src/exporter.rs"
    "plugins/sdk/src/fitting.rs"
    "plugins/sdk/src/geometry.rs"
    "plugins/sdk/src/grid.rs"
    "plugins/sdk/src/kept.rs"
    "plugins/sdk/src/layout.rs"
    "plugins/sdk/src/lib.rs"
    "plugins/sdk/src/options.rs"
    "plugins/sdk/src/parallel.rs"
    "plugins/sdk/src/runs.rs"
    "plugins/sdk/src/scene.rs"
    "plugins/sdk/src/schema.rs"
    "plugins/sdk/src/watch.rs"
];

const LICENCES: &[(&str, &str)] = embedded!["LICENSE-APACHE" "LICENSE-MIT"];

/// The crate's files with their paths in the project.
pub fn files() -> Result<Vec<File>, toml::de::Error> {
    let file = |(path, text): &(&str, &str)| {
        let path = path.strip_prefix("plugins/sdk/").unwrap_or(path);
        (format!("vendor/planform-sdk/{path}"), text.to_string())
    };
    let manifest = ("vendor/planform-sdk/Cargo.toml".into(), manifest()?);
    Ok(SOURCES.iter().chain(LICENCES).map(file).chain([manifest]).collect())
}

/// The crate's manifest without its tests, which are not copied.
fn manifest() -> Result<String, toml::de::Error> {
    let mut table: Table = MANIFEST.parse()?;
    table.remove("dev-dependencies");
    table.remove("test");
    Ok(format!("# A copy of planform-sdk, as of planform {}.\n{table}", env!("CARGO_PKG_VERSION")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;

    fn sources(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in folder.read_dir().unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                sources(&path, found);
            } else {
                let root = Path::new(env!("CARGO_MANIFEST_DIR"));
                found.insert(path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/"));
            }
        }
    }

    #[test]
    fn every_source_is_copied() {
        let mut found = BTreeSet::new();
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("plugins/sdk/src"), &mut found);
        assert_eq!(SOURCES.iter().map(|(path, _)| path.to_string()).collect::<BTreeSet<_>>(), found);
    }

    #[test]
    fn the_manifest_names_nothing_that_is_not_copied() {
        let manifest: Table = manifest().unwrap().parse().unwrap();
        assert!(manifest.contains_key("dependencies") && manifest.contains_key("package"));
        assert!(!manifest.contains_key("test") && !manifest.contains_key("dev-dependencies"));
    }
}
