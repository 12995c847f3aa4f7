//! `--set`, `--resolution`, `--params`, `--param`.

mod cli_support;

use cli_support::{Workshop, text};

#[test]
fn settings_that_no_plugin_takes() {
    let w = Workshop::new();
    w.refuses("convert map.yaml -o a.svg --set colour=red", 2, &["`colour`", "slam-grid takes", "svg takes"]);
    w.refuses("convert map.yaml -o a.svg --set geojson.boundary=centre", 2, &["`geojson` takes no part"]);
    w.refuses("convert map.yaml -o a.svg --set svg.colour=red", 2, &["svg: ", "`colour`"]);
    w.refuses("convert map.yaml -o a.dxf --set version=R14", 2, &["error: --set version=R14: ", "dxf: "]);
    w.refuses("convert map.yaml -o a.svg --set colour", 2, &["NAME=VALUE"]);
}

#[test]
fn resolutions_that_are_none() {
    let w = Workshop::new();
    for bad in ["0", "-0.05", "NaN", "inf", "wide"] {
        w.refuses(
            &format!("convert map.pgm -o a.svg --resolution {bad}"),
            2,
            &[&format!("error: --resolution {bad}: ")],
        );
    }
}

#[test]
fn a_setting_reaches_the_exporter() {
    let w = Workshop::new();
    w.does("convert map.yaml -o inner.geojson");
    w.does("convert map.yaml -o centre.geojson --set geojson.boundary=centre");
    assert_ne!(w.read("inner.geojson"), w.read("centre.geojson"));
}

#[test]
fn printed_parameters_read_back() {
    let w = Workshop::new();
    let (params, _) = w.does("params");
    w.write("mine.toml", &params);
    w.does("convert map.yaml -o a.svg");
    w.does("convert map.yaml -o b.svg --params mine.toml");
    assert_eq!(text(&w.read("a.svg")), text(&w.read("b.svg")));
}

#[test]
fn bad_files_of_parameters() {
    let w = Workshop::new();
    w.write("mine.toml", "# mine\nmethodd = \"paper\"\n");
    w.refuses(
        "convert map.yaml -o a.svg --params mine.toml",
        1,
        &["mine.toml: line 2: ", "`methodd`", "`method`"],
    );
    w.write("mine.toml", "method = \n");
    w.refuses("convert map.yaml -o a.svg --params mine.toml", 1, &["mine.toml: line 1: "]);
    w.write("mine.toml", [0xff, 0xfe]);
    w.refuses("convert map.yaml -o a.svg --params mine.toml", 1, &["mine.toml: ", "UTF-8"]);
    w.write("mine.toml", "[clutter]\nradius = -1.0\n");
    w.refuses("convert gone.yaml -o a.svg --params mine.toml", 1, &["mine.toml: parameter `clutter.radius`"]);
    w.refuses("convert map.yaml -o a.svg --params gone.toml", 1, &["gone.toml: ", "no such file"]);
}

#[test]
fn single_parameters() {
    let w = Workshop::new();
    w.does("convert map.yaml -o a.svg --param method=paper");
    w.refuses("convert map.yaml -o b.svg --param size=3", 2, &["--param size=3", "planform params"]);
    w.refuses("convert map.yaml -o b.svg --param method=guess", 2, &["--param method=guess", "paper"]);
    w.refuses("convert map.yaml -o b.svg --method guess", 2, &["guess"]);
}
