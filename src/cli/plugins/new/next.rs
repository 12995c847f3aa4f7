//! What to do with a new project.

use super::templates::identifier;
use super::{Kind, Language, NewArgs};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::Path;

/// The commands that build, check and try it, with a word on each.
pub fn steps(args: &NewArgs, folder: &Path) -> String {
    let name = &args.name;
    let (does, check, convert) = match args.kind {
        Kind::Input => ("reads", format!(" --sample sample.{name}"), format!("sample.{name} -o sample.svg")),
        Kind::Exporter => ("writes", String::new(), format!("sample.pbm --resolution 0.1 -o rooms.{name}")),
    };
    let (build, libraries, library) = match args.lang {
        Language::Rust => ("cargo build --release", "target/release", rust_library(name)),
        Language::C => ("make", ".", format!("{name}{DLL_SUFFIX}")),
    };
    let folder = quoted(folder);
    format!(
        "{folder} is a plugin that {does} *.{name}. To build it, check it and try it:\n\n  \
         cd {folder}\n  {build}\n  planform plugins check {library}{check}\n  \
         planform convert {convert} --plugin-dir {libraries}\n\n\
         Its README.md says where all of it is.\n"
    )
}

fn rust_library(name: &str) -> String {
    format!("target/release/{DLL_PREFIX}{}{DLL_SUFFIX}", identifier(name))
}

/// The path as a shell takes it.
fn quoted(path: &Path) -> String {
    let path = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || "-_./+:".contains(c);
    if path.chars().all(plain) { path } else { format!("'{}'", path.replace('\'', r"'\''")) }
}
