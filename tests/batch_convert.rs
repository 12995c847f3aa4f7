//! `planform batch`: many documents by one command, each for itself.
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod batch_support;
mod cli_support;

use batch_support::PLAN;
use cli_support::{Workshop, pgm, refused, text, two_rooms};
use std::fs;

const RUN: &str = "batch in -o out --to svg,dxf --set metres-per-pixel=0.01";

#[test]
fn good_documents_are_converted_and_bad_ones_reported() {
    let w = Workshop::empty();
    w.put_documents(4);
    let output = w.run(RUN);
    refused(&output, 1, &["4 of 15 files failed", "out/planform-batch/report.html says why"], RUN);
    let tree = w.tree("out");
    let names: Vec<_> = tree.keys().map(String::as_str).collect();
    assert_eq!(
        names,
        [
            "logs/turning.log.dxf",
            "logs/turning.log.svg",
            "maps/0/0.yaml.dxf",
            "maps/0/0.yaml.svg",
            "maps/0/3.yaml.dxf",
            "maps/0/3.yaml.svg",
            "maps/1/1.yaml.dxf",
            "maps/1/1.yaml.svg",
            "maps/2/2.yaml.dxf",
            "maps/2/2.yaml.svg",
            "plan.svg.dxf",
            "plan.svg.svg",
        ]
    );
    let err = text(&output.stderr);
    for sentence in [
        "failed: in/broken/empty.png: is empty; was it saved to the end?",
        "failed: in/broken/garbage.pdf: ",
        "failed: in/broken/short.pgm: ",
        "failed: in/broken/alone.yaml: the map's picture in/broken/map.pgm: there is no such file",
        "skipped: in/maps/0/0.pgm: belongs to maps/0/0.yaml",
        "skipped: in/notes.txt: is no document that planform knows",
        "in/maps/0/0.yaml: 2 rooms, ",
        "15 files: 6 converted, 5 skipped, 4 failed; the report is out/planform-batch/report.html",
    ] {
        assert!(err.contains(sentence), "`{sentence}` is not in\n{err}");
    }
    assert!(!w.path("out/planform-batch/staging").exists());
    // What the batch writes is what `convert` writes.
    w.does("convert in/maps/0/0.yaml -o one.svg");
    assert_eq!(tree["maps/0/0.yaml.svg"], w.read("one.svg"));
}

#[test]
fn the_reports_hold_every_document() {
    let w = Workshop::empty();
    w.put_documents(2);
    w.run(RUN);
    let rows = w.report("out/planform-batch");
    assert_eq!(rows.len(), 11);
    let map = &rows["maps/0/0.yaml"];
    assert_eq!(
        (&map["state"], &map["adapter"], &map["rooms"]),
        (&"converted".into(), &"slam-grid".into(), &2.into())
    );
    assert!(
        (map["area"].as_f64().unwrap() - 42.0).abs() < 2.0 && map["seconds"].as_f64().unwrap() > 0.0,
        "{map}"
    );
    let svg = map["outputs"].as_array().unwrap().iter().find(|o| o["path"] == "maps/0/0.yaml.svg").unwrap();
    assert_eq!(svg["bytes"], w.read("out/maps/0/0.yaml.svg").len());
    assert_eq!(
        (&rows["broken/empty.png"]["state"], &rows["notes.txt"]["state"]),
        (&"failed".into(), &"skipped".into())
    );
    let table = text(&w.read("out/planform-batch/report.csv"));
    assert_eq!(table.lines().count(), 12);
    assert!(table.contains("maps/0/0.yaml,in/maps/0/0.yaml,converted,,slam-grid,2,0,"), "{table}");
    let page = text(&w.read("out/planform-batch/report.html"));
    assert!(page.contains("maps/0/0.yaml") && page.contains("\"before\":\"iVBOR"), "{}", &page[..2000]);
}

#[test]
fn programs_are_told_in_events() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put("in/b.png", "");
    let output = w.run("batch in -o out --to svg --json");
    let events: Vec<serde_json::Value> =
        text(&output.stdout).lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let of = |event: &str| events.iter().filter(|e| e["event"] == event).collect::<Vec<_>>();
    assert_eq!((of("start")[0]["documents"].as_u64(), of("begin").len(), of("done").len()), (Some(2), 2, 3));
    let converted = of("done").into_iter().find(|e| e["name"] == "a.yaml").unwrap();
    assert_eq!(converted["outputs"][0]["path"], "a.yaml.svg");
    assert_eq!(of("summary")[0]["totals"]["failed"], 1);
    assert_eq!(text(&output.stderr).lines().count(), 1, "{}", text(&output.stderr));
}

/// `script` gives the program a terminal.
#[cfg(target_os = "linux")]
#[test]
fn on_a_terminal_there_is_a_bar() {
    let w = Workshop::empty();
    w.put_documents(6);
    let program = env!("CARGO_BIN_EXE_planform");
    let command = format!("stty columns 150; exec {program} batch in -o out --to svg -j 1");
    let output = std::process::Command::new("script")
        .args(["-q", "-e", "-c", &command, "/dev/null"])
        .current_dir(w.path(""))
        .output()
        .expect("`script` is on every Linux system");
    let told = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{told}");
    for words in ["/13  ", "/s  ", " left  ", "1 failed  ", "maps/0/0.yaml"] {
        assert!(told.contains(words), "`{words}` is not in\n{told}");
    }
    assert!(told.contains("19 files: 8 converted, 7 skipped, 4 failed"), "{told}");
}

#[test]
fn a_dry_run_writes_nothing() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    let (out, _) = w.does("batch in -o out --to ros-map --dry-run");
    assert!(out.contains("convert in/a.yaml -> out/a.yaml.yaml, out/a.yaml.pgm\n"), "{out}");
    assert!(out.contains("skip    in/a.pgm (belongs to a.yaml)\n"), "{out}");
    assert!(!w.path("out").exists());
    w.does("batch in -o out --to ros-map -q");
    let (out, _) = w.does("batch in -o out --to ros-map --dry-run --resume");
    assert!(out.contains("keep    in/a.yaml") && out.contains("(it is converted)"), "{out}");
    w.refuses("batch in -o out --to ros-map --dry-run", 1, &["is the journal of a former run", "--resume"]);
}

#[test]
fn manifests_say_what_becomes_of_each_document() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put("in/plan.svg", PLAN);
    w.put("in/gone.csv", "input\nnowhere.png\n");
    w.put(
        "in/list.csv",
        "input,options,outputs\na.yaml,,x/one.svg;one.dxf\nplan.svg,metres-per-pixel=0.01,\n",
    );
    w.does("batch --manifest in/list.csv -o out --to geojson");
    assert_eq!(w.tree("out").into_keys().collect::<Vec<_>>(), ["one.dxf", "plan.svg.geojson", "x/one.svg"]);
    w.put(
        "in/list.jsonl",
        "{\"input\": \"a.yaml\", \"outputs\": [\"a.svg\"], \"options\": {\"svg.scale\": 50}}\n",
    );
    w.does("batch --manifest in/list.jsonl -o lines");
    assert_eq!(w.tree("lines").into_keys().collect::<Vec<_>>(), ["a.svg"]);
    let output = w.run("batch --manifest in/gone.csv -o gone --to svg");
    refused(&output, 1, &["1 of 1 files failed"], "gone");
    assert!(text(&output.stderr).contains("failed: in/nowhere.png: there is no such file"));
    w.refuses(
        "batch --manifest in/gone.csv -o none",
        2,
        &["the list names no outputs for it", "--to FORMAT"],
    );
    w.put("in/odd.csv", "input,output\na.yaml,x.svg\n");
    w.refuses(
        "batch --manifest in/odd.csv -o odd --to svg",
        1,
        &["in/odd.csv: line 1: there is no column `output`"],
    );
}

#[test]
fn shares_together_are_the_whole() {
    let w = Workshop::empty();
    (0..8).for_each(|n| w.put_map(&format!("{n}"), n));
    w.does("batch in -o whole --to svg -q");
    (1..=3).for_each(|i| drop(w.does(&format!("batch in -o shares --to svg -q --shard {i}/3"))));
    assert_eq!(w.tree("shares"), w.tree("whole"));
    assert!(w.path("shares/planform-batch/2-of-3/report.html").exists());
    w.refuses("batch in -o shares --to svg --shard 4/3", 2, &["write I/N"]);
}

#[test]
fn nothing_is_overwritten_unasked() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put_map("b", 1);
    w.put("out/a.yaml.svg", "mine");
    let output = w.run("batch in -o out --to svg");
    refused(&output, 1, &["1 of 4 files failed"], "present");
    assert!(
        text(&output.stderr).contains("failed: out/a.yaml.svg: is there already; `--force` overwrites it")
    );
    assert_eq!((w.read("out/a.yaml.svg"), w.tree("out").len()), (b"mine".to_vec(), 2));
    w.refuses(
        "batch in -o out --to svg",
        1,
        &["journal.sqlite: is the journal of a former run", "--resume", "--force"],
    );
    w.does("batch in -o out --to svg --resume --force -q");
    assert!(w.read("out/a.yaml.svg").starts_with(b"<"));
    // What a user made of an output is the user's.
    w.write("out/a.yaml.svg", "mine again");
    let output = w.run("batch in -o out --to svg --resume");
    assert!(text(&output.stderr).contains("out/a.yaml.svg: was changed since planform wrote it"));
    assert_eq!(w.read("out/a.yaml.svg"), b"mine again");
}

#[test]
fn command_lines_that_make_no_sense_are_refused() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put("other/a.yaml", "x");
    for (args, code, words) in [
        ("batch in -o out", 2, ["--to", ""]),
        ("batch -o out --to svg", 2, ["INPUT", ""]),
        ("batch in -o out --to docx", 2, ["there is no format `docx`", "svg"]),
        ("batch in -o in --to svg", 2, ["in: the outputs would lie among the documents", "--output"]),
        ("batch in -o . --to svg", 2, ["in: the outputs would lie among the documents", ""]),
        ("batch in/a.yaml other/a.yaml -o out --to svg", 2, ["would be written where", "manifest"]),
        ("batch in -o out --to svg --set colour=red", 2, ["--set colour=red", "no plugin"]),
        ("batch in -o out --to svg --from guess", 2, ["--from: there is no input adapter `guess`", ""]),
        ("batch in -o out --to svg --retry-failed", 2, ["--resume", ""]),
        ("batch in -o out --to svg --workers 0", 2, ["--workers", ""]),
        ("batch nowhere/*.pdf -o out --to svg", 1, ["nowhere/*.pdf: there is no such file", ""]),
    ] {
        let output = w.run(args);
        let err = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "planform {args}\n{err}");
        assert!(words.iter().all(|word| err.contains(word)), "planform {args}\n{err}");
        assert!(w.tree("out").is_empty(), "planform {args}");
        let _ = fs::remove_dir_all(w.path("out"));
    }
}

#[test]
fn several_inputs_lie_under_their_names() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put("more/sub/b.pgm", pgm(200, 120, two_rooms));
    w.put("c.pgm", pgm(200, 120, two_rooms));
    w.does("batch in more/**/*.pgm c.pgm -o out --to svg --resolution 0.05");
    assert_eq!(
        w.tree("out").into_keys().collect::<Vec<_>>(),
        ["c.pgm.svg", "in/a.yaml.svg", "more/sub/b.pgm.svg"]
    );
}

#[cfg(unix)]
#[test]
fn names_need_not_be_utf8() {
    use std::os::unix::ffi::OsStrExt;
    let w = Workshop::empty();
    fs::create_dir(w.path("in")).unwrap();
    let name = |bytes: &[u8]| std::ffi::OsStr::from_bytes(bytes).to_owned();
    fs::write(w.path("in").join(name(b"caf\xe9.pgm")), pgm(200, 120, two_rooms)).unwrap();
    let (_, err) = w.does("batch in -o out --to svg --resolution 0.05");
    assert!(err.contains("in/caf\\xE9.pgm: 2 rooms"), "{err}");
    assert!(w.path("out").join(name(b"caf\xe9.pgm.svg")).exists());
    let (_, err) = w.does("batch in -o out --to svg --resolution 0.05 --resume");
    assert!(!err.contains("rooms"), "{err}");
}
