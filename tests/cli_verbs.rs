//! The verbs beside `convert`.

mod cli_support;

use cli_support::Workshop;
use serde_json::Value;

#[test]
fn alone_it_prints_help() {
    let output = Workshop::empty().run("");
    assert_eq!(output.status.code(), Some(2));
    assert!(cli_support::text(&output.stderr).contains("Usage: planform"));
}

#[test]
fn version() {
    let (out, _) = Workshop::empty().does("--version");
    assert_eq!(out, format!("planform {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn help_is_a_verb_as_well() {
    let w = Workshop::empty();
    assert_eq!(w.does("help").0, w.does("--help").0);
    assert_eq!(w.does("help convert").0, w.does("convert --help").0);
}

#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_printed_is_a_failure() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let mut planform = std::process::Command::new(env!("CARGO_BIN_EXE_planform"));
    let output = planform.arg("--help").stdout(full).stderr(std::process::Stdio::piped()).output().unwrap();
    cli_support::refused(&output, 1, &["standard output: the disk is full"], "--help > /dev/full");
}

#[test]
fn every_verb_has_help_with_an_example() {
    for verb in [
        "convert",
        "batch",
        "inspect",
        "evaluate",
        "plugins",
        "plugins list",
        "plugins info",
        "plugins new",
        "params",
        "completions",
        "man",
    ] {
        let (out, _) = Workshop::empty().does(&format!("{verb} --help"));
        assert!(out.contains(&format!("  planform {verb}")) && out.contains("Example"), "{out}");
    }
}

#[test]
fn inspect_tells_what_the_map_is() {
    let w = Workshop::new();
    let (out, _) = w.does("inspect map.yaml");
    for line in
        ["200 x 120 cells, 10.00 x 6.00 m", "0.05 m per cell", "x -1 m, y 2 m, yaw 0 rad", "slam-grid is"]
    {
        assert!(out.contains(line), "{line} is not in\n{out}");
    }
}

#[test]
fn inspect_as_json() {
    let (out, _) = Workshop::new().does("inspect map.yaml --json");
    let report: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(report["cells"], serde_json::json!([200, 120]));
    let shares = report["shares"].as_object().unwrap().values();
    assert!((shares.map(|v| v.as_f64().unwrap()).sum::<f64>() - 1.0).abs() < 1e-9);
}

#[test]
fn plugins_are_listed_with_their_options() {
    let w = Workshop::empty();
    let (table, _) = w.does("plugins");
    for name in ["slam-grid", "svg", "dxf", "geojson"] {
        assert!(table.lines().any(|l| l.starts_with(name)), "{table}");
    }
    assert_eq!(w.does("plugins list").0, table);
    assert!(w.does("plugins info geojson").0.contains("boundary"));
    let all: Value = serde_json::from_str(&w.does("plugins --json").0).unwrap();
    assert_eq!(all.as_array().unwrap().len(), table.lines().count() - 1);
    assert_eq!(w.does("plugins list --json").0, w.does("plugins --json").0);
    let one: Value = serde_json::from_str(&w.does("plugins info svg --json").0).unwrap();
    assert_eq!((one.as_array().unwrap().len(), &one[0]["kind"]), (1, &Value::from("write")));
    assert_eq!(w.does("plugins info GeoJSON").0, w.does("plugins info geojson").0);
    w.refuses("plugins info docx", 2, &["docx"]);
}

#[test]
fn schemas_are_those_that_are_published() {
    let published = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    for what in ["layout", "scene", "options"] {
        let (printed, _) = Workshop::empty().does(&format!("plugins schema {what}"));
        let file = std::fs::read_to_string(published.join(format!("{what}.schema.json"))).unwrap();
        let [printed, file] = [&printed, &file].map(|text| serde_json::from_str::<Value>(text).unwrap());
        assert_eq!(printed, file);
    }
}

#[test]
fn completions_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (script, _) = Workshop::empty().does(&format!("completions {shell}"));
        assert!(script.contains("convert") && script.contains("debug-dir"), "{shell}");
    }
}

#[test]
fn the_manual_page_holds_every_verb() {
    let (page, _) = Workshop::empty().does("man");
    assert!(page.starts_with(".ie") || page.starts_with(".TH"), "{page}");
    for verb in ["CONVERT", "BATCH", "INSPECT", "PLUGINS", "PARAMS", "COMPLETIONS", "MAN"] {
        assert!(page.contains(&format!("PLANFORM {verb}")), "{verb}");
    }
}
