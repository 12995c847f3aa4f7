//! Where plugins from outside are found, and when they are loaded.
#![cfg(target_os = "linux")]

mod cli_support;
mod plugin_support;

use cli_support::{Workshop, text};
use plugin_support::bad_plugin;
use serde_json::{Value, json};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// A plugin that does no harm, by this name, which is also that of its documents.
fn good_plugin(folder: &Path, name: &str) {
    bad_plugin(folder, name, "never", &[]);
}

const READ: &str = "convert doc.x -o out.svg --force";

#[test]
fn folders_are_searched_in_their_order() {
    let w = Workshop::empty();
    for folder in ["given", "listed", "data/planform/plugins"] {
        good_plugin(&w.path(folder), "exit");
    }
    let list = |given: bool, listed: bool| {
        let mut command = w.command("plugins list");
        command.env("XDG_DATA_HOME", w.path("data"));
        if given {
            command.arg("--plugin-dir").arg(w.path("given"));
        }
        if listed {
            command.env("PLANFORM_PLUGIN_PATH", w.path("listed"));
        }
        let output = command.output().unwrap();
        (text(&output.stdout), text(&output.stderr))
    };
    for (given, listed, used, shadowed) in [
        (true, true, "given/exit.so", ["listed/exit.so", "data/planform/plugins/exit.so"].as_slice()),
        (false, true, "listed/exit.so", &["data/planform/plugins/exit.so"]),
        (false, false, "data/planform/plugins/exit.so", &[]),
    ] {
        let (out, err) = list(given, listed);
        let row = out.lines().find(|l| l.starts_with("exit") && l.contains(" read ")).unwrap();
        assert!(row.contains(&w.path(used).display().to_string()), "{out}");
        assert_eq!(err.lines().count(), 2 * shadowed.len(), "{err}");
        for library in shadowed {
            let (library, used) = (w.path(library), w.path(used));
            let note = format!(
                "note: `{}` is not used: its exporter `exit` is shadowed by that of `{}`",
                library.display(),
                used.display()
            );
            assert!(err.contains(&note), "{note}\n{err}");
        }
    }
}

#[test]
fn built_in_plugins_are_not_shadowed() {
    let w = Workshop::new();
    let bad = w.path("bad.c");
    let source = fs::read_to_string(plugin_support::root().join("tests/bad_plugins/bad.c")).unwrap();
    fs::write(&bad, source.replace("#define NAME TEXT(MISDEED)", "#define NAME \"svg\"")).unwrap();
    plugin_support::compile(&bad, &w.path("p/svg.so"), &["-DMISDEED=exit", "-DWHEN=\"write\""]);
    let (out, err) = w.does("plugins list --plugin-dir p");
    assert!(err.contains("its exporter `svg` is shadowed by the built-in one"), "{out}{err}");
    w.does("convert map.yaml -o out.svg --plugin-dir p");
    assert!(text(&w.read("out.svg")).contains("<svg"));
}

#[test]
fn a_run_that_needs_none_loads_none() {
    let w = Workshop::new();
    // Whoever loads it ends.
    bad_plugin(&w.path("p"), "exit", "load", &[]);
    w.does("convert map.yaml -o out.svg -o out.dxf --plugin-dir p --trust-plugins");
    w.does("inspect map.yaml --plugin-dir p --trust-plugins");
    w.does("convert map.yaml -o - --to svg --plugin-dir p --trust-plugins");
    w.does("convert map.yaml -o out.drawing --to svg --from slam-grid --plugin-dir p --trust-plugins");
    let output = w.run("convert map.yaml -o out.exit --plugin-dir p --trust-plugins");
    assert_eq!(output.status.code(), Some(3));
}

#[test]
fn the_working_directory_is_not_searched() {
    let w = Workshop::empty();
    good_plugin(&w.path(""), "exit");
    w.write("doc.x", "exit");
    w.refuses(READ, 1, &["is no kind of document"]);
    for path in [".", "", ":", "./p"] {
        let output = w.command(READ).env("PLANFORM_PLUGIN_PATH", path).output().unwrap();
        cli_support::refused(&output, 1, &["is no kind of document"], path);
        let told = text(&output.stderr).contains("names the folder");
        assert_eq!(told, path.contains('.'), "{}", text(&output.stderr));
    }
    w.does("convert doc.x -o out.svg --plugin-dir .");
    w.refuses("convert doc.x -o new.svg --plugin-dir none", 2, &["--plugin-dir none: is not a folder"]);
}

#[test]
fn what_everybody_can_write_is_not_loaded() {
    let w = Workshop::empty();
    good_plugin(&w.path("p"), "exit");
    w.write("doc.x", "exit");
    let read = format!("{READ} --plugin-dir p");
    for (path, mode, what) in [("p/exit.so", 0o666, "the file `"), ("p", 0o777, "the folder `")] {
        let before = fs::metadata(w.path(path)).unwrap().permissions();
        fs::set_permissions(w.path(path), fs::Permissions::from_mode(mode)).unwrap();
        let words = [what, "can be written by everybody", "`chmod o-w` mends that"];
        w.refuses(&read, 1, &words);
        w.refuses(&format!("{read} --trust-plugins"), 1, &words);
        w.refuses("plugins check p/exit.so", 1, &words);
        fs::set_permissions(w.path(path), before).unwrap();
    }
    w.does(&read);
}

#[test]
fn a_library_that_cannot_be_used_does_not_stop_the_others() {
    let w = Workshop::empty();
    good_plugin(&w.path("p"), "exit");
    bad_plugin(&w.path("p"), "segfault", "load", &[]);
    w.write("doc.x", "exit");
    let (_, err) = w.does("convert doc.x -o out.svg --plugin-dir p");
    assert!(err.contains("warning: `p/segfault.so` is not used: it crashed"), "{err}");
    let (_, err) = w.does("convert doc.x -o out.svg --plugin-dir p --quiet --force");
    assert_eq!(err, "");
}

#[test]
fn trusted_or_not_the_result_is_the_same() {
    let w = Workshop::new();
    good_plugin(&w.path("p"), "exit");
    w.write("doc.x", "exit");
    let convert = |args: &str| {
        w.does(&format!("convert doc.x -o out.svg -o out.exit --force --plugin-dir p {args}"));
        (w.read("out.svg"), w.read("out.exit"))
    };
    assert_eq!(convert(""), convert("--trust-plugins"));
    assert_eq!(convert("").1, b"done\n");
    let (out, _) = w.does("inspect doc.x --plugin-dir p");
    assert!(out.contains("exit is 90 % sure") && out.contains("100 x 100 cells"), "{out}");
}

#[test]
fn a_plugin_can_show_the_stages_of_its_work() {
    let w = Workshop::new();
    bad_plugin(&w.path("p"), "stages", "read", &[]);
    w.write("doc.x", "stages");
    let plain = "convert doc.x -o out.svg --force --plugin-dir p";
    for args in [plain.to_owned(), format!("{plain} --trust-plugins")] {
        let folder = if args == plain { "isolated" } else { "trusted" };
        let (_, err) = w.does(&format!("{args} --verbose --debug-dir {folder}"));
        let lines: Vec<_> = err.lines().map(|l| l.split("  ").find(|w| !w.is_empty()).unwrap()).collect();
        assert_eq!(lines[..3], ["light", "no-way--31m", "reading"], "{err}");
        let mut files: Vec<_> = fs::read_dir(w.path(folder))
            .unwrap()
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .collect();
        files.sort();
        assert_eq!(files[..2], ["01-light.png", "02-no-way--31m.png"]);
        assert!(files[2].starts_with("03-") && files.len() > 5, "{files:?}");
        let picture = image::open(w.path(folder).join("01-light.png")).unwrap().to_rgb8();
        assert_eq!(picture.as_raw()[..], [255, 0, 0, 0, 0, 255]);
        // Without a folder there are no pictures, but names.
        assert!(w.does(&format!("{args} --verbose")).1.contains("light"));
        assert!(!w.does(&args).1.contains("light"));
    }
    w.refuses(&format!("{plain} --debug-dir isolated").replace(" --force", ""), 1, &["out.svg", "--force"]);
    fs::remove_file(w.path("out.svg")).unwrap();
    let again = format!("{plain} --debug-dir isolated").replace(" --force", "");
    w.refuses(&again, 1, &["01-light.png", "--force"]);
}

#[test]
fn what_a_plan_shows_is_told_and_kept() {
    let w = Workshop::new();
    bad_plugin(&w.path("p"), "plan", "read", &[]);
    w.write("doc.x", "plan");
    for trust in ["", "--trust-plugins"] {
        let (out, _) = w.does(&format!("inspect doc.x --plugin-dir p {trust}"));
        for line in [
            "  symbols     2 door, 1 sink\n",
            "  scale       0.02 m per pixel by written scale 1:100, 90 % sure\n",
        ] {
            assert!(out.contains(line), "{line} is not in\n{out}");
        }
        assert!(!out.contains("texts"), "{out}");
        let (json, _) = w.does(&format!("inspect doc.x --plugin-dir p {trust} --json"));
        let report: Value = serde_json::from_str(&json).unwrap();
        assert_eq!(report["symbols"], json!({"door": 2, "sink": 1}));
        assert_eq!(report["scale"]["metres_per_pixel"], 0.02);
        let (_, err) = w.does(&format!("convert doc.x -o a.layout.json --force --plugin-dir p {trust}"));
        assert!(err.contains(", 3 symbols, scale by written scale 1:100 -> "), "{err}");
        let layout: Value = serde_json::from_slice(&w.read("a.layout.json")).unwrap();
        assert_eq!(layout["scale"], report["scale"]);
        let leaf = json!({"hinge": [1.0, 1.5], "closed": [1.9, 1.5], "open": [1.0, 2.4]});
        assert_eq!(layout["symbols"][2]["leaves"], json!([leaf]));
        assert_eq!(layout["symbols"][1]["leaves"], json!([]));
        w.does(&format!("convert doc.x -o b.layout.json --force --plugin-dir p {trust} --method paper"));
        let paper: Value = serde_json::from_slice(&w.read("b.layout.json")).unwrap();
        assert_eq!((&paper["scale"], &paper["symbols"]), (&layout["scale"], &layout["symbols"]));
    }
    let (out, err) = (w.does("inspect map.yaml").0, w.does("convert map.yaml -o c.svg").1);
    for word in ["scale", "symbol", "text"] {
        assert!(!out.contains(word) && !err.contains(word), "{out}{err}");
    }
}

#[test]
fn stages_without_end_or_pictures_without_sense_are_refused() {
    let w = Workshop::new();
    for (misdeed, words) in [("flood", "more than 100 stages"), ("torn", "2 x 1 pixels has 5 bytes")] {
        bad_plugin(&w.path("p"), misdeed, "read", &[]);
        w.write("doc.x", misdeed);
        for trust in ["", "--trust-plugins"] {
            let args = format!("convert doc.x -o out.svg --plugin-dir p --debug-dir d {trust} --force");
            let output = w.run(&args);
            cli_support::refused(&output, 1, &[words], &args);
            assert!(!w.path("out.svg").exists());
        }
    }
}

#[test]
fn a_plugin_can_talk_to_the_user() {
    let w = Workshop::new();
    bad_plugin(&w.path("p"), "talk", "read", &[]);
    bad_plugin(&w.path("q"), "talk", "write", &[]);
    w.write("doc.x", "talk");
    for args in [
        "convert doc.x -o out.svg --force --plugin-dir p",
        "convert map.yaml -o out.talk --force --plugin-dir q",
    ] {
        for args in [args.to_owned(), format!("{args} --trust-plugins")] {
            let (_, err) = w.does(&args);
            assert!(err.contains("warning: plugin talk: the plan is old\\nand \\u{1b}[31mred"), "{err}");
            assert!(!err.contains("three floors"), "{err}");
            assert!(w.does(&format!("{args} --verbose")).1.contains("plugin talk: it has three floors"));
            assert_eq!(w.does(&format!("{args} --quiet")).1, "");
        }
    }
}

#[test]
fn plugins_are_named_where_formats_are() {
    let w = Workshop::new();
    good_plugin(&w.path("p"), "exit");
    w.does("convert map.yaml -o out.bin --to exit --plugin-dir p");
    w.does("convert map.yaml -o second.bin --to exit --from slam-grid --plugin-dir p");
    assert_eq!(w.read("out.bin"), b"done\n");
    w.refuses("convert map.yaml -o third.bin --to exist --plugin-dir p", 2, &["`exist`", "svg, dxf", "exit"]);
    w.refuses(
        "convert map.yaml -o a.svg --from exist --plugin-dir p",
        2,
        &["`exist`", "slam-grid, blueprint, radish, exit"],
    );
    assert!(w.does("plugins info exit --plugin-dir p").0.contains("from         p/exit.so"));
    w.refuses("plugins info exist --plugin-dir p", 2, &["there is no plugin `exist`", "exit"]);
}
