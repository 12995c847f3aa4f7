//! A batch that is ended in any way is carried on: nothing is lost, nothing done twice, and the outputs are those of a run
//! that nobody disturbed.
#![cfg(unix)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod batch_support;
mod cli_support;

use batch_support::{PLAN, signal};
use cli_support::{Workshop, refused, text};
use std::fs;
use std::process::Child;
use std::thread::sleep;
use std::time::{Duration, Instant};

const RUN: &str = "batch in -o out --to svg,ros-map --set metres-per-pixel=0.01 --resume -j 2";

/// Numbers that look random.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, below: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % below
    }
}

/// Waits until something is there.
fn until(what: &str, is: impl Fn() -> bool) {
    let start = Instant::now();
    while !is() {
        assert!(start.elapsed() < Duration::from_secs(60), "{what} never happens");
        sleep(Duration::from_millis(2));
    }
}

fn end(mut child: Child) -> (Option<i32>, String) {
    let code = child.wait().unwrap().code();
    (code, std::io::read_to_string(child.stderr.take().unwrap()).unwrap())
}

#[test]
fn a_batch_that_is_killed_again_and_again_ends_as_if_nothing_had_been() {
    let w = Workshop::empty();
    w.put_documents(16);
    let start = Instant::now();
    w.run(&RUN.replace("-o out", "-o whole"));
    let usual = start.elapsed().as_millis() as u64;
    let mut numbers = Numbers(8);
    for _ in 0..8 {
        let mut child = w.start(RUN);
        sleep(Duration::from_millis(numbers.next(usual / 3)));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let output = w.run(RUN);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert_eq!(w.tree("out"), w.tree("whole"));
    let states = |folder| -> Vec<_> {
        let rows = w.report(&format!("{folder}/planform-batch"));
        rows.into_iter().map(|(name, row)| (name, row["state"].clone(), row["reason"].clone())).collect()
    };
    assert_eq!(states("out"), states("whole"));
    let left: Vec<_> =
        w.tree("out/planform-batch").into_keys().filter(|name| name.contains("staging")).collect();
    assert_eq!(left, Vec::<String>::new());
}

#[test]
fn what_is_done_is_not_done_again() {
    let w = Workshop::empty();
    w.put_documents(3);
    w.run(RUN);
    let written = |w: &Workshop| fs::metadata(w.path("out/maps/0/0.yaml.svg")).unwrap().modified().unwrap();
    let before = written(&w);
    let err = text(&w.run(RUN).stderr);
    assert!(!err.contains("rooms") && err.contains("13 files: 5 converted, 4 skipped, 4 failed"), "{err}");
    assert_eq!(written(&w), before);
    let again = text(&w.run(&format!("{RUN} --retry-failed")).stderr);
    assert!(
        again.contains("again: broken/empty.png: it failed before") && !again.contains("rooms"),
        "{again}"
    );
}

#[test]
fn what_changed_is_done_again_and_said() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    w.put_map("b", 0);
    w.put("in/plan.svg", PLAN);
    w.does(RUN);
    w.put_map("a", 9);
    fs::remove_file(w.path("out/plan.svg.svg")).unwrap();
    // Written anew, but the same.
    w.put_map("b", 0);
    let (_, err) = w.does(RUN);
    assert!(err.contains("again: a.yaml: the document changed\n"), "{err}");
    assert!(err.contains("again: plan.svg: its output out/plan.svg.svg is missing\n"), "{err}");
    assert!(!err.contains("again: b.yaml"), "{err}");
    let (_, err) = w.does(&RUN.replace("-j 2", "--set svg.scale=50"));
    assert!(err.contains("again: b.yaml: its options or outputs changed\n"), "{err}");
    assert!(text(&w.read("out/b.yaml.svg")).contains("<svg"));
    fs::remove_file(w.path("in/b.pgm")).unwrap();
    let output = w.run(&RUN.replace("-j 2", "--set svg.scale=50"));
    assert!(
        text(&output.stderr).contains("again: b.yaml: the document changed\n"),
        "{}",
        text(&output.stderr)
    );
}

#[test]
fn two_runs_on_one_journal_are_refused() {
    let w = Workshop::empty();
    w.put_documents(24);
    let child = w.start(RUN);
    until("the first output", || w.path("out/maps").exists());
    let output = w.run(RUN);
    refused(&output, 1, &["out/planform-batch: another run of planform works on this batch"], "twice");
    let (code, err) = end(child);
    assert_eq!(code, Some(1), "{err}");
    assert_eq!(w.tree("out").len(), 3 * 26);
}

#[test]
fn an_interrupt_undoes_what_is_in_work_and_says_what_is_done() {
    for name in ["INT", "TERM"] {
        let w = Workshop::empty();
        w.put_documents(24);
        let child = w.start(RUN);
        until("the first output", || w.path("out/maps").exists());
        signal(&child, name);
        let start = Instant::now();
        let (code, err) = end(child);
        assert!(start.elapsed() < Duration::from_secs(5));
        assert_eq!(code, Some(130), "{err}");
        assert!(
            err.contains("error: interrupted; 55 files: ") && err.contains("`--resume` carries on"),
            "{err}"
        );
        assert!(err.contains(" converted") && err.contains(" not done yet"), "{err}");
        assert!(!w.path("out/planform-batch/staging").exists());
        let done = w.report("out/planform-batch").values().filter(|r| r["state"] == "converted").count();
        assert_eq!(w.tree("out").len(), 3 * done, "{:?}", w.tree("out").keys());
        w.run(RUN);
        assert_eq!(w.tree("out").len(), 3 * 26);
    }
}

#[test]
fn a_damaged_journal_is_told_and_kept() {
    let w = Workshop::empty();
    w.put_documents(3);
    w.run(RUN);
    let outputs = w.tree("out");
    let mut journal = w.read("out/planform-batch/journal.sqlite");
    journal[4096..9000].fill(0x55);
    w.write("out/planform-batch/journal.sqlite", &journal);
    for args in [RUN.to_owned(), RUN.replace("--resume", "--force")] {
        let words =
            ["out/planform-batch/journal.sqlite: is damaged; move it away and run again with `--force`"];
        refused(&w.run(&args), 1, &words, &args);
        assert_eq!(w.read("out/planform-batch/journal.sqlite"), journal);
    }
    assert_eq!(w.tree("out"), outputs);
    fs::remove_file(w.path("out/planform-batch/journal.sqlite")).unwrap();
    assert_eq!(w.run(&RUN.replace("--resume", "--force")).status.code(), Some(1));
    assert_eq!(w.tree("out"), outputs);
}

#[test]
fn documents_that_are_dropped_into_a_folder_are_converted() {
    let w = Workshop::empty();
    w.put_map("a", 0);
    let child = w.start("batch in -o out --to svg --watch");
    until("the first document", || w.path("out/a.yaml.svg").exists());
    w.put_map("sub/b", 1);
    until("the second document", || w.path("out/sub/b.yaml.svg").exists());
    let first = w.read("out/a.yaml.svg");
    w.put_map("a", 17);
    until("the changed document", || w.read("out/a.yaml.svg") != first);
    sleep(Duration::from_millis(300));
    signal(&child, "INT");
    let (code, err) = end(child);
    assert_eq!(code, Some(130), "{err}");
    assert!(
        err.contains("waiting for documents; Ctrl-C ends it") && err.contains("4 files: 2 converted"),
        "{err}"
    );
    assert!(err.contains("again: a.yaml: the document changed"), "{err}");
    assert_eq!(w.report("out/planform-batch").len(), 4);
}
