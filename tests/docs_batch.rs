//! The commands of `docs/batch.md` do what the page says, as they stand, in their order, in an empty folder; and its table of
//! limits is that of the program.
#![cfg(unix)]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod cli_support;

use cli_support::Workshop;
use std::env;
use std::path::Path;
use std::process::Command;

const PAGE: &str = include_str!("../docs/batch.md");

#[test]
fn the_commands_of_the_page_work() {
    let w = Workshop::empty();
    let blocks =
        PAGE.split("```sh\n").skip(1).map(|rest| rest.split_once("```").expect("the block has an end").0);
    let commands: String = blocks.collect();
    assert!(commands.lines().count() > 20, "{commands}");
    let program = Path::new(env!("CARGO_BIN_EXE_planform")).parent().unwrap().to_owned();
    let path =
        env::join_paths(std::iter::once(program).chain(env::split_paths(&env::var_os("PATH").unwrap())));
    // Each command is printed before it is run, together with what it prints, so that the last one is the culprit.
    let script = format!("exec 2>&1\nset -x\n{commands}");
    let output = Command::new("sh")
        .args(["-eu", "-c", &script])
        .current_dir(w.path(""))
        .env("PATH", path.unwrap())
        .output();
    let output = output.unwrap();
    let told = cli_support::text(&output.stdout);
    assert!(output.status.success(), "{told}");
    for words in [
        "4 files: 3 converted, 1 skipped; the report is rooms/planform-batch/report.html",
        "skipped: maps/west/notes.txt: is no document that planform knows",
        "convert maps/east/1.pgm -> elsewhere/east/1.pgm.dxf",
    ] {
        assert!(told.contains(words), "`{words}` is not in\n{told}");
    }
    assert!(
        w.path("rooms/planform-batch/report.html").exists() && w.path("rooms/east/1.pgm.geojson").exists()
    );
    assert!(cli_support::text(&w.read("events.jsonl")).contains("\"event\":\"summary\""));
}

#[test]
fn the_limits_of_the_page_are_those_of_the_program() {
    let (_, table) = PAGE.split_once("| option | default |").unwrap();
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split('|').map(str::trim).collect()).collect();
    assert_eq!(rows.len(), 12);
    let w = Workshop::empty();
    let (help, _) = w.does("batch --help");
    let (params, _) = w.does("params");
    let help: Vec<_> = help.split_whitespace().collect();
    let help = help.join(" ");
    for row in rows {
        let (flag, default) = (row[1].trim_matches('`'), row[2]);
        let about =
            help.split(&format!("{flag} <")).nth(1).unwrap_or_else(|| panic!("{flag} is not in the help"));
        match flag {
            "--max-lines" => assert!(params.contains(&format!("max_count = {default}")), "{flag}"),
            "--max-faces" => assert!(params.contains(&format!("max_count = {default}")), "{flag}"),
            _ => {
                let told = about.split("[default: ").nth(1).unwrap().split(']').next().unwrap();
                let same = told == default
                    || default.contains("one for each core")
                    || told == "three quarters of what is free";
                assert!(same, "{flag}: {told}");
            }
        }
    }
}
