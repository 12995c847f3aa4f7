//! Outputs that cannot or must not be written: refused before the work, nothing left behind.

mod cli_support;

use cli_support::{Workshop, refused, text};
use std::fs;

#[test]
fn existing_file() {
    let w = Workshop::new();
    w.write("a.svg", "mine");
    w.refuses("convert map.yaml -o b.svg -o a.svg", 1, &["a.svg: ", "--force"]);
    assert_eq!(w.read("a.svg"), b"mine");
}

#[test]
fn refused_before_the_work() {
    let w = Workshop::empty();
    w.write("a.svg", "mine");
    w.refuses("convert gone.yaml -o a.svg", 1, &["a.svg: "]);
}

#[test]
fn folder() {
    let w = Workshop::new();
    fs::create_dir(w.path("rooms.svg")).unwrap();
    w.refuses("convert map.yaml -o rooms.svg --force", 1, &["rooms.svg: is a folder"]);
    w.refuses("convert map.yaml -o .", 1, &[".: is a folder"]);
}

#[cfg(unix)]
#[test]
fn link_to_nothing() {
    let w = Workshop::new();
    std::os::unix::fs::symlink("gone.svg", w.path("a.svg")).unwrap();
    w.refuses("convert map.yaml -o a.svg", 1, &["a.svg: is a link to a file that is not there"]);
    w.refuses("convert map.yaml -o a.svg --force", 1, &["a.svg: is a link to a file that is not there"]);
}

#[test]
fn name_that_is_too_long() {
    let name = "a".repeat(300);
    Workshop::new().refuses(&format!("convert map.yaml -o {name}.svg"), 1, &["file name as long as this"]);
}

#[test]
fn missing_folder() {
    Workshop::new().refuses("convert map.yaml -o out/a.svg", 1, &["out/a.svg: ", "`out`", "create it"]);
}

#[test]
fn folder_that_is_a_file() {
    Workshop::new().refuses("convert map.yaml -o map.pgm/a.svg", 1, &["map.pgm/a.svg: ", "not a folder"]);
}

#[test]
fn read_only_file() {
    let w = Workshop::new();
    w.write("a.svg", "mine");
    let mut permissions = fs::metadata(w.path("a.svg")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(w.path("a.svg"), permissions).unwrap();
    w.refuses("convert map.yaml -o a.svg --force", 1, &["a.svg: is read-only"]);
    assert_eq!(w.read("a.svg"), b"mine");
}

#[cfg(unix)]
#[test]
fn read_only_folder() {
    use std::os::unix::fs::PermissionsExt;
    let w = Workshop::new();
    let folder = w.path("out");
    fs::create_dir(&folder).unwrap();
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o555)).unwrap();
    let root_writes_anywhere = fs::write(folder.join("probe"), "").is_ok();
    if !root_writes_anywhere {
        w.refuses("convert map.yaml -o out/a.svg", 1, &["out/a.svg: ", "`out` takes no file"]);
    }
}

#[test]
fn the_input_itself() {
    let w = Workshop::new();
    let map = w.read("map.yaml");
    w.refuses("convert map.yaml -o ./map.yaml --force", 2, &["map.yaml: ", "input"]);
    assert_eq!(w.read("map.yaml"), map);
}

#[test]
fn the_same_file_twice() {
    let w = Workshop::new();
    w.refuses("convert map.yaml -o a.svg -o ./a.svg", 2, &["a.svg: ", "twice"]);
    w.refuses("convert map.yaml -o - -o - --to svg", 2, &["standard output: ", "twice"]);
}

#[test]
fn unknown_format() {
    let w = Workshop::new();
    w.refuses("convert map.yaml -o a.docx", 2, &["a.docx: ", "--to", "geojson"]);
    w.refuses("convert map.yaml -o -", 2, &["standard output: ", "--to"]);
    w.refuses("convert map.yaml -o a.txt --to docx", 2, &["docx"]);
    w.refuses("convert map.yaml -o a.svg --to dxf", 2, &["--to dxf"]);
}

#[test]
fn no_output() {
    Workshop::new().refuses("convert map.yaml", 2, &["required"]);
}

#[cfg(target_os = "linux")]
#[test]
fn full_disk() {
    let w = Workshop::new();
    w.refuses("convert map.yaml -o /dev/full --to svg", 1, &["/dev/full: the disk is full"]);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_planform"))
        .args(["convert", "map.yaml", "-o", "-", "--to", "svg"])
        .current_dir(w.path(""))
        .stdout(full)
        .stderr(std::process::Stdio::piped())
        .output()
        .unwrap();
    refused(&output, 1, &["standard output: the disk is full"], "convert -o - > /dev/full");
}

/// A limit on the size of files stands in for a disk that fills up while a file is written.
#[cfg(unix)]
#[test]
fn disk_that_fills_up() {
    let w = Workshop::new();
    let before = w.files();
    let planform = env!("CARGO_BIN_EXE_planform");
    let script =
        format!("trap '' XFSZ; ulimit -f 0; exec '{planform}' convert map.yaml -o a.geojson -o a.svg");
    let output =
        std::process::Command::new("sh").args(["-c", &script]).current_dir(w.path("")).output().unwrap();
    refused(&output, 1, &["a.geojson: ", "as large as this"], "with no room for files");
    assert_eq!(w.files(), before);
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let w = Workshop::new();
    let planform = env!("CARGO_BIN_EXE_planform");
    let script = format!("{{ '{planform}' convert map.yaml -o - --to svg -q; echo $? >&2; }} | true");
    let output =
        std::process::Command::new("sh").args(["-c", &script]).current_dir(w.path("")).output().unwrap();
    assert_eq!(text(&output.stderr), "0\n");
}
