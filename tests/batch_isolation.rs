//! A document that crashes, hangs, takes all memory or cannot be written costs itself alone.
#![cfg(target_os = "linux")]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod batch_support;
mod cli_support;
mod plugin_support;

use cli_support::{UNKNOWN, Workshop, pgm, refused, text, two_rooms};
use plugin_support::bad_plugin;
use std::fs;
use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A folder with two maps, and with documents whose plugins misbehave in these ways.
fn workshop(misdeeds: &[&str]) -> Workshop {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put_map("z", 1);
    fs::create_dir(w.path("p")).unwrap();
    for misdeed in misdeeds {
        bad_plugin(&w.path("p"), misdeed, "read", &[]);
        w.put(&format!("in/m.{misdeed}"), misdeed);
    }
    w
}

#[test]
fn plugins_that_misbehave_cost_their_documents_alone() {
    let w = workshop(&["segfault", "loop", "exhaust", "exit"]);
    let args = "batch in -o out --to svg --plugin-dir p --plugin-timeout 10 --plugin-memory 300";
    let output = w.run(args);
    refused(&output, 1, &["4 of 8 files failed"], args);
    let err = text(&output.stderr);
    for sentence in [
        "failed: in/m.segfault: plugin `segfault` failed: it crashed (segmentation fault)",
        "failed: in/m.loop: plugin `loop` failed: it took longer than the 10 s that it may",
        "failed: in/m.exhaust: plugin `exhaust` failed: it took more than the 300 MiB of memory that it may",
        "failed: in/m.exit: plugin `exit` failed: it ended its process with the status 3",
    ] {
        assert!(err.contains(sentence), "`{sentence}` is not in\n{err}");
    }
    assert_eq!(w.tree("out").into_keys().collect::<Vec<_>>(), ["a.yaml.svg", "z.yaml.svg"]);
}

#[test]
fn plugins_that_are_trusted_cost_no_more() {
    let w = workshop(&["segfault", "sleep", "exhaust"]);
    let args = "batch in -o out --to svg --plugin-dir p --trust-plugins --timeout 8 --document-memory 300";
    let start = Instant::now();
    let output = w.run(args);
    refused(&output, 1, &["3 of 7 files failed"], args);
    let err = text(&output.stderr);
    for sentence in [
        "trying again: in/m.segfault: its process failed",
        "failed: in/m.segfault: its process failed: it crashed (segmentation fault)",
        "trying again: in/m.sleep: took longer",
        "failed: in/m.sleep: took longer than the 8 s that it may; `--timeout SECONDS` allows more",
        // Which of the two it is told by is a matter of luck.
        "failed: in/m.exhaust: ",
    ] {
        assert!(err.contains(sentence), "`{sentence}` is not in\n{err}");
    }
    assert!(start.elapsed() < Duration::from_secs(60));
    assert_eq!(w.tree("out").len(), 2);
    let rows = w.report("out/planform-batch");
    assert_eq!((&rows["m.sleep"]["attempts"], &rows["m.sleep"]["cause"]), (&2.into(), &"time".into()));
}

#[test]
fn nobody_is_left_behind_by_a_batch_that_is_killed() {
    let w = workshop(&["loop"]);
    let mut child = w.start("batch in -o out --to svg --plugin-dir p");
    let stands_here = |id: &u32| {
        fs::read_link(format!("/proc/{id}/cwd")).is_ok_and(|cwd| cwd == w.path("in").parent().unwrap())
    };
    let ours = || plugin_support::processes_with("-process").into_iter().filter(|id| stands_here(id)).count();
    let wait = |what: &str, is: &dyn Fn() -> bool| {
        let start = Instant::now();
        while !is() {
            assert!(start.elapsed() < Duration::from_secs(20), "{what} never happens");
            sleep(Duration::from_millis(10));
        }
    };
    wait("the plugin", &|| ours() >= 2);
    child.kill().unwrap();
    child.wait().unwrap();
    wait("the end", &|| ours() == 0);
}

#[test]
fn a_document_that_needs_more_memory_than_it_may_have_fails_alone() {
    let w = Workshop::empty();
    let yaml = cli_support::YAML.replace("map.pgm", "large.pgm").replace("0.05", "0.004");
    w.put("in/large.yaml", yaml);
    let grey = |x: u32, y: u32| if x < 2400 { two_rooms(x / 12, y / 17) } else { UNKNOWN };
    w.put("in/large.pgm", pgm(2500, 2000, grey));
    w.put_map("a", 0);
    w.put_map("b", 0);
    let output = w.run("batch in -o out --to svg --memory 1200 -j 4");
    let err = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{err}");
    let rows = w.report("out/planform-batch");
    assert!(rows["large.yaml"]["memory_mib"].as_u64().unwrap() > 64, "{}", rows["large.yaml"]);
    let output = w.run("batch in -o small --to svg --memory 64 -j 1");
    refused(&output, 1, &["1 of 6 files failed"], "small");
    let err = text(&output.stderr);
    let words = "failed: in/large.yaml: took more than the 64 MiB of memory that it may; `--document-memory MIB` allows";
    assert!(err.contains(words), "{err}");
    assert_eq!(w.tree("small").len(), 2);
}

#[test]
fn limits_hold() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    for (limit, words) in [
        (
            "--max-pixels 20000",
            "a.pgm: the picture has 200 x 120 pixels; the most are 20000; `--max-pixels` allows more",
        ),
        ("--max-bytes 100", "is larger than the limit of 100 bytes; `--max-bytes` allows more"),
        ("--max-faces 2 --method paper", "part it into more than 2 faces; `--max-faces` allows more"),
    ] {
        let output = w.run(&format!("batch in/a.yaml -o out --to svg --force {limit}"));
        let err = text(&output.stderr);
        assert!(output.status.code() == Some(1) && err.contains(words), "{err}");
        let document = if limit.contains("pixels") { "in/a.pgm" } else { "in/a.yaml" };
        let output = w.run(&format!("convert {document} -o one.svg {limit}"));
        refused(
            &output,
            1,
            &[words.split("; `--max-bytes").next().unwrap().trim_start_matches("a.pgm: ")],
            limit,
        );
    }
    w.refuses("convert in/a.yaml -o one.svg --max-faces 0", 2, &["faces.max_count"]);
}

#[test]
fn a_full_disk_stops_the_batch_and_loses_nothing() {
    let w = Workshop::empty();
    (0..12).for_each(|n| w.put_map(&format!("{n:02}"), n));
    w.does("batch in -o whole --to svg,json,dxf -q");
    // A file system of its own that is too small, which only this shell and what it starts sees.
    let planform = env!("CARGO_BIN_EXE_planform");
    let script = format!(
        "mkdir out && mount -t tmpfs -o size=600k none out || exit 99
        {planform} batch in -o out --to svg,json,dxf; echo \"exit $?\"
        mount -o remount,size=60m out
        {planform} batch in -o out --to svg,json,dxf --resume -q; echo \"exit $?\"
        cp -r out/. saved"
    );
    fs::create_dir(w.path("saved")).unwrap();
    let mut unshare = Command::new("unshare");
    unshare.args(["--map-root-user", "--mount", "sh", "-c", &script]).current_dir(w.path(""));
    let output = unshare.output().expect("`unshare` is on every Linux system");
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert_ne!(
        output.status.code(),
        Some(99),
        "this test needs to mount a file system in a namespace of its own\n{err}"
    );
    assert_eq!(out, "exit 1\nexit 0\n", "{err}");
    let errors: Vec<_> = err.lines().filter(|l| l.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "{err}");
    assert!(errors[0].contains("the disk is full; make room and run again with `--resume`"), "{err}");
    assert_eq!(w.tree("saved"), w.tree("whole"));
}

#[test]
fn an_output_folder_that_goes_away_stops_the_batch() {
    let w = Workshop::empty();
    (0..40).for_each(|n| w.put_map(&format!("{n:02}"), n));
    let mut child = w.start("batch in -o out --to svg");
    let start = Instant::now();
    while !w.path("out/00.yaml.svg").exists() {
        assert!(start.elapsed() < Duration::from_secs(30));
        sleep(Duration::from_millis(2));
    }
    fs::rename(w.path("out"), w.path("elsewhere")).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(1));
    let err = std::io::read_to_string(child.stderr.take().unwrap()).unwrap();
    assert!(err.contains("error: out: the output folder, or a part of it, is gone; bring it back"), "{err}");
    assert!(!w.path("out").exists(), "nothing is made in its place");
    fs::rename(w.path("elsewhere"), w.path("out")).unwrap();
    w.does("batch in -o out --to svg --resume");
    assert_eq!(w.tree("out").len(), 40);
}

#[test]
fn a_document_that_changes_meanwhile_is_told() {
    let w = Workshop::empty();
    w.put("in/large.pgm", pgm(2000, 1200, |x, y| two_rooms(x / 10, y / 10)));
    let file = fs::File::options().write(true).open(w.path("in/large.pgm")).unwrap();
    let args = "batch in -o out --to svg --resolution 0.005 --retries 0";
    let mut child = w.start(args);
    while child.try_wait().unwrap().is_none() {
        file.set_modified(std::time::SystemTime::now()).unwrap();
        sleep(Duration::from_millis(5));
    }
    let err = std::io::read_to_string(child.stderr.take().unwrap()).unwrap();
    let words = "failed: in/large.pgm: was changed while it was converted; `--resume` converts it again when it is whole";
    assert!(err.contains(words), "{err}");
    assert!(w.tree("out").is_empty(), "{err}");
    w.does(&format!("{args} --resume"));
    assert_eq!(w.tree("out").len(), 1);
}
