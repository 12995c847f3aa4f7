//! The commands of `docs/plugins.md` do what the page says, as they stand, in their order, in an empty folder.
#![cfg(target_os = "linux")]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use planform_sdk::{Layout, schema};
use serde_json::Value;
use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

const PAGE: &str = include_str!("../docs/plugins.md");

/// Where all projects' dependencies are compiled, once. Cargo tells projects in it apart by their names alone, so a
/// name always stands for the same kind.
const BUILD: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/plugins");

/// The blocks of the page that are marked as being in this language.
fn blocks(language: &str) -> Vec<&'static str> {
    let rests = PAGE.split(&format!("```{language}\n")).skip(1).collect::<Vec<_>>();
    rests.into_iter().map(|rest| rest.split_once("```").expect("the block has an end").0).collect()
}

#[test]
fn the_json_of_the_page_is_understood() {
    let blocks = blocks("json");
    let find = |word: &str| *blocks.iter().find(|block| block.contains(word)).unwrap();
    assert_eq!(schema::read_options(find("properties")).unwrap().len(), 3);
    let layout: Value = serde_json::from_str(find("openings")).unwrap();
    let read: Layout = serde_json::from_value(layout.clone()).unwrap();
    // None of its names is unknown, and none is missing.
    let written = serde_json::to_value(&read).unwrap();
    assert_eq!(with_floats(written), with_floats(layout));
}

/// The same with every number as a float, so that 4 and 4.0 are equal.
fn with_floats(value: Value) -> Value {
    match value {
        Value::Number(n) => n.as_f64().into(),
        Value::Array(elements) => elements.into_iter().map(with_floats).collect(),
        Value::Object(members) => members.into_iter().map(|(k, v)| (k, with_floats(v))).collect(),
        other => other,
    }
}

/// The folder that a tool keeps its things in, wherever the home folder will be.
fn kept(variable: &str, usual: &str) -> PathBuf {
    env::var_os(variable).map_or_else(|| env::home_dir().unwrap().join(usual), PathBuf::from)
}

#[test]
fn the_commands_of_the_page_work() {
    let folder = tempfile::tempdir().unwrap();
    let (home, work) = (folder.path().join("home"), folder.path().join("work"));
    std::fs::create_dir(&home).unwrap();
    std::fs::create_dir(&work).unwrap();
    let program = Path::new(env!("CARGO_BIN_EXE_planform")).parent().unwrap().to_owned();
    let path =
        env::join_paths(std::iter::once(program).chain(env::split_paths(&env::var_os("PATH").unwrap())));

    let commands = blocks("sh").concat();
    assert!(commands.lines().count() > 20, "{commands}");
    // Each command is printed before it is run, together with what it prints, so that the last one is the culprit.
    let script = format!("exec 2>&1\nset -x\n{commands}");
    let mut sh = Command::new("sh");
    sh.args(["-eu", "-c", &script]).current_dir(&work).env("PATH", path.unwrap());
    sh.env("CARGO_HOME", kept("CARGO_HOME", ".cargo")).env("RUSTUP_HOME", kept("RUSTUP_HOME", ".rustup"));
    sh.env("HOME", &home).env("XDG_DATA_HOME", home.join(".local/share"));
    sh.env_remove("PLANFORM_PLUGIN_PATH").env_remove("CARGO_TARGET_DIR").env("CARGO_BUILD_BUILD_DIR", BUILD);
    // What this program was built from is there.
    sh.env("CARGO_NET_OFFLINE", "true");
    let output = sh.output().unwrap();
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{told}");
    assert!(told.contains("4 rooms") && told.contains("3 doors") && !told.contains("warning"), "{told}");

    let written = |name: &str| std::fs::read_to_string(work.join(name)).unwrap();
    assert!(written("my-plan/flat.svg").contains("<svg") && written("my-plan/flat.dxf").contains("A-WALL"));
    assert_eq!(written("my-table/rooms.my-table").lines().count(), 1 + 4);
    assert!(written("my-table/german.my-table").starts_with("id;name;area_m2"));
    assert_eq!(written("my-table/flat.my-table").lines().count(), 1 + 4);
}
