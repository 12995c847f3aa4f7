//! The files of new projects: real files below this folder, in which `{{name}}` stands for the plugin's name and
//! `{{identifier}}` for its name with underscores, as the Rust compiler calls the library. The paths are such that
//! neither cargo nor git takes a template for one of their own files.

use super::{File, Kind, Language};

/// Files of a template: where each goes, and what it holds.
type Template = &'static [(&'static str, &'static str)];

const RUST: Template =
    &[("Cargo.toml", include_str!("rust/Cargo.toml.in")), (".gitignore", include_str!("rust/gitignore"))];

const RUST_INPUT: Template = &[
    ("src/lib.rs", include_str!("rust/input/lib.rs")),
    ("README.md", include_str!("rust/input/README.md")),
    ("sample.{{name}}", include_str!("samples/flat.txt")),
];

const RUST_EXPORTER: Template = &[
    ("src/lib.rs", include_str!("rust/exporter/lib.rs")),
    ("README.md", include_str!("rust/exporter/README.md")),
    ("sample.pbm", include_str!("samples/flat.pbm")),
];

const C: Template = &[
    ("Makefile", include_str!("c/Makefile")),
    (".gitignore", include_str!("c/gitignore")),
    ("planform.h", include_str!("../../../../plugins/sdk/include/planform.h")),
];

const C_INPUT: Template = &[
    ("{{name}}.c", include_str!("c/input/plugin.c")),
    ("README.md", include_str!("c/input/README.md")),
    ("sample.{{name}}", include_str!("samples/flat.txt")),
];

const C_EXPORTER: Template = &[
    ("{{name}}.c", include_str!("c/exporter/plugin.c")),
    ("README.md", include_str!("c/exporter/README.md")),
    ("sample.pbm", include_str!("samples/flat.pbm")),
];

/// The files of a project, but for the crate that those in Rust depend on.
pub fn files(kind: Kind, language: Language, name: &str) -> Vec<File> {
    let (common, own) = match (language, kind) {
        (Language::Rust, Kind::Input) => (RUST, RUST_INPUT),
        (Language::Rust, Kind::Exporter) => (RUST, RUST_EXPORTER),
        (Language::C, Kind::Input) => (C, C_INPUT),
        (Language::C, Kind::Exporter) => (C, C_EXPORTER),
    };
    let filled = |text: &str| text.replace("{{name}}", name).replace("{{identifier}}", &identifier(name));
    common.iter().chain(own).map(|(path, text)| (filled(path), filled(text))).collect()
}

/// The name as the Rust compiler has it.
pub fn identifier(name: &str) -> String {
    name.replace('-', "_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_placeholder_is_left() {
        for (kind, language) in [
            (Kind::Input, Language::Rust),
            (Kind::Input, Language::C),
            (Kind::Exporter, Language::Rust),
            (Kind::Exporter, Language::C),
        ] {
            let files = files(kind, language, "my-plan");
            assert!(files.iter().any(|(_, text)| text.contains("my-plan")), "{kind:?} {language:?}");
            for (path, text) in files {
                assert!(!path.contains("{{") && !text.contains("{{"), "{path}");
            }
        }
    }
}
