//! Plugins that misbehave take their own document down, with one sentence, and nothing else.
#![cfg(target_os = "linux")]

mod cli_support;
mod plugin_support;

use cli_support::{Workshop, refused};
use plugin_support::{bad_plugin, build};
use std::collections::BTreeSet;
use std::fs;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A folder with a map, and with a plugin in the folder `p` that misbehaves at this moment.
fn workshop(misdeed: &str, when: &str, arguments: &[&str]) -> Workshop {
    let w = Workshop::new();
    bad_plugin(&w.path("p"), misdeed, when, arguments);
    w.write("doc.x", misdeed);
    w
}

/// Limits that a plugin meets soon if it never ends, and late if it is only slow on a busy machine.
fn limits(misdeed: &str) -> &'static str {
    match misdeed {
        "loop" | "sleep" => "--plugin-timeout 2 --plugin-memory 300",
        _ => "--plugin-timeout 100 --plugin-memory 300",
    }
}

/// Reads the document.
fn reading(misdeed: &str) -> String {
    format!("convert doc.x -o out.svg --plugin-dir p {}", limits(misdeed))
}

fn shared_memory() -> BTreeSet<String> {
    let files = fs::read_dir("/dev/shm").into_iter().flatten().flatten();
    files.map(|f| f.file_name().to_string_lossy().into_owned()).collect()
}

/// Runs the program, which must fail over a plugin with one sentence, leave no file, and no process.
fn fails(w: &Workshop, args: &str, words: &[&str]) {
    let (shared, files) = (shared_memory(), w.files());
    let output = w.run(args);
    refused(&output, 1, words, args);
    assert_eq!(w.files(), files, "planform {args} left files behind");
    assert_eq!(String::from_utf8_lossy(&output.stderr).lines().count(), 1);
    assert_eq!(shared_memory(), shared);
    assert_gone(&w.path("p"));
}

/// Whether a process works on a library of this folder: it stands in the folder above.
fn is_served(folder: &Path) -> bool {
    let above = folder.parent().expect("a workshop is above it");
    let stands_there = |id: &u32| fs::read_link(format!("/proc/{id}/cwd")).is_ok_and(|cwd| cwd == above);
    plugin_support::processes_with("plugin-process").iter().any(stands_there)
}

/// Fails if a process that serves a library of this folder is still there.
fn assert_gone(folder: &Path) {
    let start = Instant::now();
    while is_served(folder) {
        assert!(start.elapsed() < Duration::from_secs(5), "a process is left behind");
        sleep(Duration::from_millis(10));
    }
}

#[test]
fn at_reading() {
    for (misdeed, words) in [
        ("segfault", "it crashed (segmentation fault)"),
        ("abort", "it crashed (abort)"),
        ("divide", "it crashed (arithmetic error)"),
        ("loop", "it took longer than the 2 s that it may; `--plugin-timeout SECONDS` allows more"),
        ("sleep", "it took longer than the 2 s"),
        (
            "allocate",
            "it took more than the 300 MiB of memory that it may; `--plugin-memory MIB` allows more",
        ),
        ("exhaust", "it took more than the 300 MiB of memory"),
        ("overflow", "it ran out of stack"),
        ("exit", "it ended its process with the status 3"),
        // Which of the two ends notices first is a matter of luck.
        ("close", "it "),
        ("orphan", "it crashed (segmentation fault)"),
    ] {
        let w = workshop(misdeed, "read", &[]);
        fails(&w, &reading(misdeed), &["doc.x: ", &format!("plugin `{misdeed}` failed: "), words]);
    }
}

#[test]
fn at_writing() {
    for misdeed in ["segfault", "loop", "allocate", "exit"] {
        let w = workshop(misdeed, "write", &[]);
        let limits = limits(misdeed);
        let args = format!("convert map.yaml -o out.svg -o out.{misdeed} --plugin-dir p {limits} -q");
        fails(&w, &args, &[&format!("out.{misdeed}: "), &format!("plugin `{misdeed}` failed: it ")]);
    }
}

#[test]
fn at_probing() {
    for misdeed in ["segfault", "loop", "exit"] {
        let w = workshop(misdeed, "probe", &[]);
        let probing = format!("plugin `{misdeed}`: it cannot tell whose document this is: it ");
        fails(&w, &reading(misdeed), &["is no kind of document", &probing]);
    }
}

#[test]
fn at_loading() {
    for misdeed in ["segfault", "loop", "exit", "orphan", "exhaust", "allocate"] {
        let w = workshop(misdeed, "load", &[]);
        fails(
            &w,
            &reading(misdeed),
            &["is no kind of document", &format!("p/{misdeed}.so` is not used: it ")],
        );
    }
}

#[test]
fn tables_that_do_not_fit() {
    for (when, arguments, words) in [
        (
            "never",
            ["-DMAJOR=2"].as_slice(),
            "version 2 of the plugin interface, and this planform has version 1",
        ),
        ("never", &["-DSIZE=12"], "is cut short: it says that it has 12 bytes where 32 are needed"),
        ("refuse", &[], "it refuses to work with this planform"),
    ] {
        let w = workshop("exit", when, arguments);
        fails(&w, &reading(when), &["`p/exit.so` is not used: ", words]);
        fails(&w, &format!("{} --trust-plugins", reading(when)), &["`p/exit.so` is not used: ", words]);
    }
}

#[test]
fn what_is_no_library_of_plugins() {
    let w = workshop("exit", "never", &[]);
    let (whole, read) = (w.read("p/exit.so"), reading("exit"));
    w.write("p/exit.so", "hello");
    fails(&w, &read, &["`p/exit.so` is not used: it is no shared library of this system"]);
    w.write("p/exit.so", &whole[..whole.len() / 2]);
    fails(&w, &read, &["`p/exit.so` is not used: it "]);
    w.write("empty.c", "int nothing;\n");
    plugin_support::compile(&w.path("empty.c"), &w.path("p/exit.so"), &[]);
    fails(&w, &read, &["it has no function `planform_plugin`; it is no plugin of planform"]);
}

#[test]
fn panics() {
    let w = Workshop::new();
    fs::create_dir(w.path("p")).unwrap();
    fs::copy(build("planform-test-panics"), w.path("p/panics.so")).unwrap();
    w.write("doc.panics", "hello");
    let panics = ["plugin `panics` failed: it has a bug at ", "lib.rs:", "no plan has 5 bytes"];
    fails(&w, "convert doc.panics -o out.svg --plugin-dir p", &panics);
    fails(&w, "convert doc.panics -o out.svg --plugin-dir p --trust-plugins", &panics);
    let at_writing = ["out.panics: plugin `panics` failed: it has a bug at ", "index out of bounds"];
    fails(&w, "convert map.yaml -o out.panics --plugin-dir p -q", &at_writing);
    w.write("doc.panics", "stack");
    fails(
        &w,
        "convert doc.panics -o out.svg --plugin-dir p",
        &["plugin `panics` failed: it ran out of stack"],
    );
}

#[test]
fn what_a_plugin_prints_is_no_answer() {
    let w = workshop("chatter", "read", &[]);
    let (out, err) = w.does("convert doc.x -o - --to svg --plugin-dir p");
    assert!(out.contains("<svg") && !out.contains("hello") && !err.contains("complain"), "{out}{err}");
    let (_, err) = w.does("convert doc.x -o out.svg --plugin-dir p --verbose");
    assert!(err.contains("hello, I am a plugin") && err.contains("and I complain"), "{err}");
}

/// Starts a conversion whose plugin never comes back, and waits until it is at it.
fn hang(w: &Workshop) -> std::process::Child {
    let mut planform = Command::new(env!("CARGO_BIN_EXE_planform"));
    planform.current_dir(w.path("")).args("convert doc.x -o out.svg --plugin-dir p".split(' '));
    // A group of its own, as a shell gives it: signals of this test reach nobody else.
    let child = planform.process_group(0).stderr(Stdio::null()).spawn().expect("planform starts");
    let start = Instant::now();
    while !is_served(&w.path("p")) {
        assert!(start.elapsed() < Duration::from_secs(10), "the plugin is never loaded");
        sleep(Duration::from_millis(10));
    }
    child
}

#[test]
fn nothing_outlives_the_program() {
    for (signal, when) in
        [("KILL", "read"), ("INT", "read"), ("TERM", "read"), ("KILL", "load"), ("INT", "load")]
    {
        let w = workshop("loop", when, &[]);
        let mut child = hang(&w);
        let killed =
            Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status().unwrap();
        assert!(killed.success() && !child.wait().unwrap().success());
        assert_gone(&w.path("p"));
        assert_eq!(w.files().len(), 4, "{:?}", w.files());
    }
}

#[test]
fn what_a_plugin_said_last_is_told_when_it_crashes() {
    let w = workshop("complain", "read", &[]);
    fails(&w, &reading("complain"), &["it crashed (abort), after saying `bad.c: this cannot be`"]);
}

#[test]
fn libraries_of_other_systems() {
    let w = workshop("exit", "never", &[]);
    let mut library = w.read("p/exit.so");
    // The machine of an ELF file, here that of a PDP-11.
    library[18] = 65;
    w.write("p/exit.so", &library);
    fails(&w, &reading("exit"), &["`p/exit.so` is not used: it was built for another kind of machine"]);
}

#[test]
fn an_error_of_a_good_plugin_names_the_document_alone() {
    let w = workshop("exit", "never", &[]);
    w.does("convert doc.x -o out.svg --plugin-dir p");
    let output = w.run("convert doc.x -o out.svg --plugin-dir p");
    refused(&output, 1, &["out.svg: is there already"], "twice");
}

#[test]
fn a_check_finds_what_is_wrong() {
    for (misdeed, when, words) in [
        (
            "segfault",
            "read",
            "reads garbage without harm\n         an empty document: it crashed (segmentation fault)",
        ),
        (
            "loop",
            "probe",
            "probes garbage, and paths of every kind\n         an empty document: it took longer than",
        ),
        ("abort", "write", "writes a layout\n         two rooms: it crashed (abort)"),
    ] {
        let w = workshop(misdeed, when, &[]);
        let output = w.run(&format!("plugins check p/{misdeed}.so --plugin-timeout 2"));
        let out = cli_support::text(&output.stdout);
        assert!(out.contains(&format!("FAILED   it {words}")), "{out}");
        refused(&output, 1, &[&format!("p/{misdeed}.so: "), " checks failed"], "check");
    }
    let w = workshop("segfault", "load", &[]);
    w.refuses("plugins check p/segfault.so", 1, &["p/segfault.so: it crashed (segmentation fault)"]);
}
