//! Libraries of plugins, compiled for tests.
// Every test program has its own copy of this module and uses a part of it.
#![allow(dead_code)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use std::env::consts::DLL_EXTENSION;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Compiles a C file to a library, with these further arguments.
pub fn compile(source: &Path, library: &Path, arguments: &[&str]) {
    fs::create_dir_all(library.parent().unwrap()).unwrap();
    let mut cc = Command::new("cc");
    cc.args(["-std=gnu99", "-O1", "-w", "-shared", "-fPIC", "-I"]).arg(root().join("plugins/sdk/include"));
    let output = cc.args(arguments).arg(source).arg("-o").arg(library).output().expect("`cc` compiles C");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Puts a plugin that misbehaves in this way into a folder; the misdeed is its name, too.
pub fn bad_plugin(folder: &Path, misdeed: &str, when: &str, arguments: &[&str]) -> PathBuf {
    let library = folder.join(format!("{misdeed}.{DLL_EXTENSION}"));
    let (misdeed, when) = (format!("-DMISDEED={misdeed}"), format!("-DWHEN=\"{when}\""));
    let arguments: Vec<_> =
        [misdeed.as_str(), when.as_str()].into_iter().chain(arguments.iter().copied()).collect();
    compile(&root().join("tests/bad_plugins/bad.c"), &library, &arguments);
    library
}

/// Builds a package of the workspace that is a library of plugins.
pub fn build(package: &str) -> PathBuf {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.current_dir(root()).args(["build", "--quiet", "--package", package, "--message-format=json"]);
    let output = cargo.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    library_of(&String::from_utf8_lossy(&output.stdout), package)
}

/// The library that cargo says it made for a package.
pub fn library_of(messages: &str, package: &str) -> PathBuf {
    let target = package.replace('-', "_");
    let made = messages.lines().filter_map(|line| serde_json::from_str::<serde_json::Value>(line).ok());
    let made = made.filter(|m| m["reason"] == "compiler-artifact" && m["target"]["name"] == target.as_str());
    let files: Vec<_> = made.flat_map(|m| m["filenames"].as_array().cloned().unwrap_or_default()).collect();
    let mut files = files.iter().filter_map(|f| f.as_str()).map(PathBuf::from);
    files.find(|f| f.extension().is_some_and(|e| e == DLL_EXTENSION)).unwrap()
}

/// The processes whose command line holds this text.
#[cfg(target_os = "linux")]
pub fn processes_with(text: &str) -> Vec<u32> {
    let ids = fs::read_dir("/proc").unwrap().filter_map(|e| e.unwrap().file_name().to_str()?.parse().ok());
    ids.filter(|id| {
        let line = fs::read(format!("/proc/{id}/cmdline")).unwrap_or_default();
        String::from_utf8_lossy(&line).contains(text)
    })
    .collect()
}
