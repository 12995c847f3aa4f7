//! `planform plugins new`: what it makes builds, passes the checks and converts, right away and outside of this
//! workspace; what it refuses, it leaves alone.

mod cli_support;

use cli_support::Workshop;

#[test]
fn bad_names_are_refused() {
    let w = Workshop::empty();
    let long = "a".repeat(65);
    for (name, words) in [
        ("My_Plan", "lower-case letters"),
        ("2d-plan", "a letter comes first"),
        ("../plan", "lower-case letters"),
        (long.as_str(), "1 to 64"),
        ("fn", "keeps this word"),
        ("slam-grid", "built-in plugin slam-grid"),
        ("dxf", "built-in plugin dxf"),
        ("png", "built-in plugin slam-grid"),
    ] {
        w.refuses(&format!("plugins new {name} --kind input --lang rust"), 2, &[name, words]);
    }
    w.refuses("plugins new my-plan --kind input --lang cobol", 2, &["cobol"]);
}

#[test]
fn folders_that_hold_something_are_left_alone() {
    let w = Workshop::empty();
    w.does("plugins new my-plan --kind input --lang c --dir made");
    w.refuses("plugins new my-plan --kind input --lang rust --dir made", 1, &["made", "not empty", "--dir"]);
    w.write("my-plan", "a file");
    w.refuses("plugins new my-plan --kind input --lang c", 1, &["my-plan", "not a folder"]);
    assert!(w.path("made/my-plan.c").is_file() && !w.path("made/Cargo.toml").exists());
}
