//! A built-in plugin as a library, loaded both ways.

use planform::host::isolated::Limits;
use planform::host::{Contents, load};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// The plugins of one library: trusted, and in a process of their own.
pub struct Ways([(&'static str, Contents); 2]);

impl Ways {
    /// Those of the library of this package, which is compiled first.
    pub fn of(package: &str) -> Self {
        let library = compiled(package);
        let limits = Limits {
            program: Some(env!("CARGO_BIN_EXE_planform").into()),
            time: Duration::from_secs(Limits::TIME),
            memory: Limits::MEMORY,
            echo: false,
        };
        let loaded =
            |isolation| load(&library, isolation).unwrap_or_else(|e| panic!("{}: {e}", library.display()));
        Self([("trusted", loaded(None)), ("isolated", loaded(Some(&limits)))])
    }

    /// Both, each with its name.
    pub fn all(&self) -> impl Iterator<Item = (&'static str, &Contents)> {
        self.0.iter().map(|(way, contents)| (*way, contents))
    }
}

/// Compiles the package as a library of plugins, in the folder that this test was compiled in: quick when nothing
/// changed, and most of what it needs is there. Where the library lies.
fn compiled(package: &str) -> PathBuf {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap();
    let arguments = ["rustc", "--package", package, "--features", "plugin", "--crate-type", "cdylib"];
    let mut command = Command::new(cargo);
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments).arg("--target-dir").arg(target);
    let output = command.args(["--quiet", "--message-format=json"]).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{package} does not compile as a library\n{errors}");
    let messages = output.stdout.split(|b| *b == b'\n').filter(|line| !line.is_empty());
    let messages = messages.map(|line| serde_json::from_slice::<Value>(line).unwrap());
    let files = messages.filter_map(|m| m["filenames"].as_array().cloned()).flatten();
    let libraries = files.filter_map(|f| f.as_str().map(PathBuf::from));
    let of_package = package.replace('-', "_");
    let wanted = |path: &PathBuf| {
        path.file_stem().is_some_and(|stem| stem.to_string_lossy().ends_with(&of_package))
            && path.extension().is_some_and(|e| e == std::env::consts::DLL_EXTENSION)
    };
    libraries.into_iter().find(wanted).unwrap_or_else(|| panic!("no library of {package}"))
}
