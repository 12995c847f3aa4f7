//! What it costs to run a plugin in a process of its own: the same documents read and converted with and without
//! `--trust-plugins`, in turn, in the same run. Printed as a table of ratios.
//!
//! The plugin is the MovingAI example, which does little but read: what a real plugin does besides is not slower in a
//! process of its own.
#![allow(clippy::unwrap_used)]

use std::env::consts::DLL_EXTENSION;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How often each is timed.
const ROUNDS: usize = 15;

fn main() {
    // `cargo test` runs benchmarks as well, and they prove nothing there.
    if !std::env::args().any(|a| a == "--bench") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    compile(&folder.path().join(format!("movingai.{DLL_EXTENSION}")));
    println!(
        "median of {ROUNDS} runs each, whole process; ratio: in a process of its own / within planform\n"
    );
    println!("{:<24} {:>10} {:>10} {:>7}", "", "own, ms", "within, ms", "ratio");
    for side in [100, 1000, 4000] {
        let map = folder.path().join(format!("{side}.map"));
        fs::write(&map, rooms(side)).unwrap();
        compare(&format!("inspect {side} x {side}"), &["inspect"], &map, folder.path());
        let out = folder.path().join("out.geojson");
        let convert = ["convert", "--force", "--quiet", "-o", out.to_str().unwrap()];
        compare(&format!("convert {side} x {side}"), &convert, &map, folder.path());
    }
}

fn compile(library: &Path) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut cc = Command::new("cc");
    cc.args(["-std=c99", "-O2", "-shared", "-fPIC", "-I"]).arg(root.join("plugins/sdk/include"));
    cc.arg(root.join("plugins/examples/movingai/movingai.c")).arg("-o").arg(library);
    assert!(cc.status().expect("`cc` compiles C").success());
}

/// A map of this many cells a side: rooms of 80 x 80 cells with a door to each neighbour.
fn rooms(side: usize) -> String {
    let wall = |i: usize| i % 80 < 3 || i + 3 >= side;
    let door = |i: usize| (30..50).contains(&(i % 80));
    let inner = |i: usize| i > 40 && i + 40 < side;
    let cell = |x: usize, y: usize| {
        let open = (door(x) && inner(y)) || (door(y) && inner(x));
        if (wall(x) || wall(y)) && !open { '@' } else { '.' }
    };
    let row = |y: usize| (0..side).map(|x| cell(x, y)).chain(['\n']).collect::<String>();
    let rows: String = (0..side).map(row).collect();
    format!("type octile\nheight {side}\nwidth {side}\nmap\n{rows}")
}

fn compare(what: &str, arguments: &[&str], map: &Path, plugins: &Path) {
    let mut times = [vec![], vec![]];
    for _ in 0..ROUNDS {
        times[0].push(time(arguments, map, plugins, false));
        times[1].push(time(arguments, map, plugins, true));
    }
    let [own, within] = times.map(median);
    println!("{what:<24} {own:>10.1} {within:>10.1} {:>7.2}", own / within);
}

fn time(arguments: &[&str], map: &Path, plugins: &Path, trusted: bool) -> Duration {
    let mut planform = Command::new(env!("CARGO_BIN_EXE_planform"));
    planform.args(arguments).arg(map).arg("--plugin-dir").arg(plugins).stdout(Stdio::null());
    if trusted {
        planform.arg("--trust-plugins");
    }
    let start = Instant::now();
    assert!(planform.status().unwrap().success());
    start.elapsed()
}

/// Milliseconds.
fn median(mut times: Vec<Duration>) -> f64 {
    times.sort();
    times[times.len() / 2].as_secs_f64() * 1e3
}
