//! The formats that a batch writes.

use crate::cli::Failure;
use crate::host::Registry;
use std::path::Path;

/// A format, and what the names of its files end with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Format {
    /// The exporter's name.
    pub exporter: String,
    /// Without its dot.
    pub extension: String,
}

/// The formats of these names: each is that of an exporter, or an extension.
pub fn named(names: &[String], registry: &Registry) -> Result<Vec<Format>, Failure> {
    let mut formats: Vec<Format> = vec![];
    for name in names {
        let format = format(name, registry)?;
        if formats.iter().any(|f| f.extension == format.extension) {
            return Err(Failure::Usage(format!("--to {name}: is given twice")));
        }
        formats.push(format);
    }
    Ok(formats)
}

fn format(name: &str, registry: &Registry) -> Result<Format, Failure> {
    let extension = name.trim_start_matches('.').to_lowercase();
    let by_extension = || registry.exporter_for(Path::new(&format!("x.{extension}")));
    if let Some(exporter) = registry.builtin_exporter(name) {
        return Ok(usual(exporter.info()));
    }
    if let Some(exporter) = by_extension() {
        return Ok(Format { exporter: exporter.info().name.clone(), extension });
    }
    let named = registry.exporter(name).map(|e| usual(e.info()));
    named.ok_or_else(|| {
        let names: Vec<_> = registry.exporters().map(|(e, _)| e.info().name.as_str()).collect();
        let (names, refused) = (names.join(", "), registry.refused());
        Failure::Usage(format!("--to: there is no format `{name}`; there are {names}{refused}"))
    })
}

/// The format with its first extension.
fn usual(exporter: &planform_sdk::PluginInfo) -> Format {
    let extension = exporter.extensions.first().unwrap_or(&exporter.name);
    Format { exporter: exporter.name.clone(), extension: extension.clone() }
}

/// The format of a file that is named, by its extension.
pub fn of_path(path: &Path, registry: &Registry) -> Result<String, Failure> {
    let exporter = registry.exporter_for(path);
    exporter.map(|e| e.info().name.clone()).ok_or_else(|| {
        let advice = "give it one of the extensions that `planform plugins` lists";
        Failure::over(path, format!("the name does not tell which format to write; {advice}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_go_by_name_or_extension() {
        let registry = Registry::builtin();
        let of = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(ToString::to_string).collect();
            named(&names, &registry)
                .map(|f| f.into_iter().map(|f| (f.exporter, f.extension)).collect::<Vec<_>>())
        };
        let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        let expected = [pair("json", "layout.json"), pair("graph", "dot"), pair("dxf", "dxf")];
        assert_eq!(of(&["json", "dot", ".DXF"]).unwrap(), expected);
        assert!(of(&["svg", "svg"]).is_err() && of(&["docx"]).is_err());
    }
}
