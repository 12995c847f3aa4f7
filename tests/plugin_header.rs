//! `planform.h`: it is current, C and C++ take it without a word, and C sees the structs as Rust does.
//!
//! When a change is meant to alter it, run with `UPDATE_REFERENCES=1` and look at what `git diff` shows.

// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

use planform_sdk::abi::*;
use std::fmt::Write;
use std::fs;
use std::mem::offset_of;
use std::path::{Path, PathBuf};
use std::process::Command;

fn sdk(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("plugins/sdk").join(path)
}

#[test]
fn it_is_current() {
    let config = cbindgen::Config::from_file(sdk("cbindgen.toml")).unwrap();
    let builder = cbindgen::Builder::new().with_config(config).with_src(sdk("src/abi/types.rs"));
    let mut made = vec![];
    builder.generate().unwrap().write(&mut made);
    let header = sdk("include/planform.h");
    if std::env::var_os("UPDATE_REFERENCES").is_some() {
        fs::write(&header, &made).unwrap();
    }
    let message =
        "planform.h does not say what plugins/sdk/src/abi/types.rs says; UPDATE_REFERENCES=1 renews it";
    assert!(fs::read(&header).unwrap() == made, "{message}");
}

/// Compiles this source against the header.
fn compile(compiler: &str, arguments: &[&str], source: &Path) {
    let mut command = Command::new(compiler);
    command.args(["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"]).arg(sdk("include"));
    let output = command.args(arguments).arg(source).output().unwrap_or_else(|e| panic!("{compiler}: {e}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{compiler} {arguments:?}\n{errors}");
}

#[test]
fn c_and_cpp_take_it_alone() {
    let folder = tempfile::tempdir().unwrap();
    for (compiler, standards, name) in
        [("cc", ["c99", "c11", "c17"], "alone.c"), ("c++", ["c++11", "c++17", "c++20"], "alone.cpp")]
    {
        let source = folder.path().join(name);
        // Twice, as files that include each other do.
        fs::write(&source, "#include \"planform.h\"\n#include \"planform.h\"\n").unwrap();
        for standard in standards {
            compile(compiler, &["-fsyntax-only", &format!("-std={standard}")], &source);
        }
    }
}

/// A struct as a language sees it: its name, its size, and the name and place of every field.
type Shape = (&'static str, usize, Vec<(&'static str, usize)>);

/// The shapes of these structs as Rust sees them.
macro_rules! shapes {
    ($($name:ident { $($field:ident)* })*) => {{
        // Fails to compile when a field is left out of the list.
        $(let _ = |all: $name| { let $name { $($field: _),* } = all; };)*
        let shapes: Vec<Shape> = vec![$((
            stringify!($name),
            size_of::<$name>(),
            vec![$((stringify!($field), offset_of!($name, $field))),*],
        )),*];
        shapes
    }};
}

fn seen_by_rust() -> Vec<Shape> {
    shapes! {
        PlanformString { data length }
        PlanformHost {
            size abi_major abi_minor version log kind member element length number flag text
        }
        PlanformInfo { size name description version licence extensions media_types options flags }
        PlanformProbe { size context path head head_length reason }
        PlanformSource { size context path bytes length byte_limit sibling }
        PlanformJson { size text value }
        PlanformGrid { size width height resolution origin_x origin_y origin_yaw cells cell_count }
        PlanformText { size content x y yaw width height confidence }
        PlanformDoorLeaf { hinge_x hinge_y closed_x closed_y open_x open_y }
        PlanformSymbol { size kind x y yaw width height score leaves leaf_count }
        PlanformAnchor { size latitude longitude bearing x y }
        PlanformScale { size metres_per_pixel source confidence }
        PlanformOpening { from_x from_y to_x to_y depth kind }
        PlanformStage { size name width height rgb rgb_length }
        PlanformProblem { size status place position message advice }
        PlanformSceneSink { size context grid text symbol anchor warning provenance fail scale flags stage openings }
        PlanformAdapter { size info data probe read }
        PlanformDocument { size layout grid scene }
        PlanformOutput { size context write fail stem extension companion }
        PlanformExporter { size info data write companions }
        PlanformPlugin { size abi_major abi_minor adapters exporters }
    }
}

/// One line for each struct and field.
fn listed(shapes: &[Shape]) -> String {
    let mut lines = String::new();
    for (name, size, fields) in shapes {
        writeln!(lines, "{name} {size}").unwrap();
        fields.iter().for_each(|(field, place)| writeln!(lines, "{name}.{field} {place}").unwrap());
    }
    lines
}

/// A C program that prints the same lines.
fn printing_program(shapes: &[Shape]) -> String {
    let mut program = "#include \"planform.h\"\n#include <stdio.h>\nint main(void) {\n".to_owned();
    for (name, _, fields) in shapes {
        writeln!(program, "  printf(\"{name} %zu\\n\", sizeof({name}));").unwrap();
        for (field, _) in fields {
            writeln!(program, "  printf(\"{name}.{field} %zu\\n\", offsetof({name}, {field}));").unwrap();
        }
    }
    program + "  return 0;\n}\n"
}

#[test]
fn c_sees_the_structs_as_rust_does() {
    let shapes = seen_by_rust();
    let header = fs::read_to_string(sdk("include/planform.h")).unwrap();
    let structs = header.lines().filter(|l| l.starts_with("typedef struct") && l.ends_with('{'));
    assert_eq!(structs.count(), shapes.len(), "a struct of the header is not in the list of this test");
    let folder = tempfile::tempdir().unwrap();
    let (source, program) = (folder.path().join("shapes.c"), folder.path().join("shapes"));
    fs::write(&source, printing_program(&shapes)).unwrap();
    compile("cc", &["-std=c99", "-o", program.to_str().unwrap()], &source);
    let printed = Command::new(&program).output().unwrap();
    assert_eq!(String::from_utf8(printed.stdout).unwrap(), listed(&shapes));
}
