//! `planform convert` when all is well.

mod cli_support;

use cli_support::{Workshop, text};

#[test]
fn writes_every_output_and_says_what_was_found() {
    let w = Workshop::new();
    let (out, err) = w.does("convert map.yaml -o a.svg -o a.dxf -o a.geojson");
    assert_eq!(out, "");
    assert!(err.lines().last().unwrap().starts_with("map.yaml: "), "{err}");
    assert!(err.ends_with(" -> a.svg, a.dxf, a.geojson\n"), "{err}");
    assert!(text(&w.read("a.svg")).contains("<svg"));
    assert!(text(&w.read("a.dxf")).contains("SECTION"));
    assert!(text(&w.read("a.geojson")).contains("FeatureCollection"));
    assert_eq!(w.files().len(), 5, "{:?}", w.files());
}

#[test]
fn finds_two_rooms_and_a_door() {
    let w = Workshop::new();
    let (_, err) = w.does("convert map.yaml -o a.svg");
    assert!(err.contains("map.yaml: 2 rooms, ") && err.contains(", 1 door"), "{err}");
}

#[test]
fn gives_the_same_bytes_every_time() {
    let w = Workshop::new();
    w.does("convert map.yaml -o a.svg -o a.dxf -o a.geojson");
    w.does("convert map.yaml -o b.svg -o b.dxf -o b.geojson");
    for extension in ["svg", "dxf", "geojson"] {
        assert!(
            w.read(&format!("a.{extension}")) == w.read(&format!("b.{extension}")),
            "{extension} differs"
        );
    }
}

#[test]
fn reads_standard_input_and_writes_standard_output() {
    let w = Workshop::new();
    let output = w
        .command("convert - --resolution 0.05 -o - --to svg --quiet")
        .write_stdin(w.read("map.pgm"))
        .output()
        .unwrap();
    assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
    assert!(text(&output.stdout).contains("<svg"));
}

#[test]
fn quiet_says_nothing() {
    let w = Workshop::new();
    assert_eq!(w.does("convert map.yaml -o a.svg --quiet"), (String::new(), String::new()));
}

#[test]
fn verbose_tells_the_steps() {
    let (_, err) = Workshop::new().does("convert map.yaml -o a.svg -v");
    for step in ["reading ", "basins ", "rooms ", "writing "] {
        assert!(err.lines().any(|l| l.starts_with(step) && l.ends_with(" s")), "{step} is not in\n{err}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn verbose_tells_the_peak_of_memory_after_the_steps() {
    let w = Workshop::new();
    let (_, err) = w.does("convert map.yaml -o a.svg -v");
    let lines: Vec<_> = err.lines().rev().take(3).collect();
    let [summary, memory, writing] = lines[..] else { panic!("{err}") };
    assert!(summary.starts_with("map.yaml: ") && writing.starts_with("writing "), "{err}");
    let told = memory.strip_prefix("peak memory ").and_then(|m| m.strip_suffix(" MiB"));
    let mib: u64 = told.and_then(|m| m.trim().parse().ok()).unwrap_or_else(|| panic!("{err}"));
    assert!((2..1000).contains(&mib), "{err}");
    assert!(!w.does("convert map.yaml -o b.svg").1.contains("memory"));
}

#[test]
fn a_pipe_sees_no_progress_line() {
    let (_, err) = Workshop::new().does("convert map.yaml -o a.svg");
    assert!(!err.contains(['\r', '\x1b']), "{err:?}");
}

#[test]
fn force_overwrites() {
    let w = Workshop::new();
    w.write("a.svg", "mine");
    w.does("convert map.yaml -o a.svg --force");
    assert!(text(&w.read("a.svg")).contains("<svg"));
}

#[test]
fn to_names_the_format_that_the_extension_does_not() {
    let w = Workshop::new();
    w.does("convert map.yaml -o rooms.drawing -o rooms.geojson --to svg");
    assert!(text(&w.read("rooms.drawing")).contains("<svg"));
    assert!(text(&w.read("rooms.geojson")).contains("FeatureCollection"));
}

#[test]
fn the_extension_counts_in_any_case() {
    let w = Workshop::new();
    w.does("convert map.yaml -o ROOMS.SVG");
    assert!(text(&w.read("ROOMS.SVG")).contains("<svg"));
}

#[test]
fn debug_pictures_show_the_steps() {
    let w = Workshop::new();
    w.does("convert map.yaml -o a.svg --debug-dir deep/steps");
    let basins = image::open(w.path("deep/steps/02-basins.png")).unwrap();
    // Of 200 x 120 cells 184 x 104 are known, with 5 around them; 9 pixels each.
    assert_eq!((basins.width(), basins.height()), (194 * 9, 114 * 9));
    w.refuses("convert map.yaml -o b.svg --debug-dir deep/steps", 1, &[".png", "--force"]);
    w.does("convert map.yaml -o b.svg --debug-dir deep/steps --force");
    w.does("convert map.yaml -o c.svg --debug-dir paper --method paper");
    assert!(w.path("paper/02-edges.png").is_file() && w.path("paper/12-walls.png").is_file());
}

#[cfg(unix)]
#[test]
fn outputs_have_the_permissions_of_any_new_file() {
    use std::os::unix::fs::MetadataExt;
    let w = Workshop::new();
    w.does("convert map.yaml -o a.svg");
    w.write("other", "");
    let mode = |name| std::fs::metadata(w.path(name)).unwrap().mode();
    assert_eq!(mode("a.svg"), mode("other"));
}
