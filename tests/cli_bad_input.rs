//! Documents that cannot be read: one sentence each, exit status 1, nothing left behind.

mod cli_support;

use cli_support::{FREE, UNKNOWN, WALL, Workshop, YAML, pgm};

/// Converts a map of this description and picture.
fn refuses(yaml: &str, picture: &[u8], words: &[&str]) {
    let w = Workshop::empty();
    w.write("map.yaml", yaml);
    w.write("map.pgm", picture);
    w.refuses("convert map.yaml -o a.svg", 1, &[&["map.yaml: "], words].concat());
}

fn plain(width: u32, height: u32, grey: u8) -> Vec<u8> {
    pgm(width, height, |_, _| grey)
}

#[test]
fn missing_file() {
    Workshop::empty().refuses("convert map.yaml -o a.svg", 1, &["map.yaml: ", "no such file"]);
}

#[test]
fn folder() {
    let w = Workshop::empty();
    std::fs::create_dir(w.path("maps")).unwrap();
    w.refuses("convert maps -o a.svg", 1, &["maps: ", "folder"]);
}

#[test]
fn empty_file() {
    let w = Workshop::empty();
    for name in ["map.yaml", "map.pgm", "map.png"] {
        w.write(name, "");
        w.refuses(&format!("convert {name} -o a.svg"), 1, &[name, "is empty"]);
    }
}

#[test]
fn empty_standard_input() {
    Workshop::empty().refuses("convert - -o a.svg", 1, &["standard input: is empty"]);
}

#[test]
fn something_else() {
    let w = Workshop::empty();
    w.write("letter.odt", "Dear all");
    w.refuses("convert letter.odt -o a.svg", 1, &["letter.odt: ", "--from"]);
    w.refuses("inspect letter.odt", 1, &["letter.odt: "]);
}

#[test]
fn truncated_image() {
    let whole = plain(50, 50, FREE);
    refuses(YAML, &whole[..whole.len() / 2], &["map.pgm"]);
    refuses(YAML, b"P5\n50 ", &["map.pgm"]);
    refuses(YAML, b"", &["map.pgm"]);
}

#[test]
fn no_image() {
    refuses("resolution: 0.05\norigin: [0, 0, 0]\n", b"", &["image"]);
    refuses(&YAML.replace("map.pgm", "gone.pgm"), b"", &["gone.pgm", "no such file"]);
}

#[test]
fn claims_too_many_pixels() {
    refuses(YAML, b"P5\n60000 60000\n255\n", &["60000"]);
    let w = Workshop::empty();
    w.write("big.pgm", b"P5\n60000 60000\n255\n");
    w.refuses("convert big.pgm --resolution 0.05 -o a.svg", 1, &["big.pgm: ", "60000"]);
}

#[test]
fn bad_resolution_in_the_file() {
    for bad in ["0", "0.0", "-0.05", ".nan", ".inf", "wide"] {
        refuses(&YAML.replace("0.05", bad), &plain(50, 50, FREE), &["resolution"]);
    }
}

#[test]
fn thresholds_swapped() {
    let swapped = YAML.replace("0.65", "0.1").replace("0.196", "0.9");
    refuses(&swapped, &plain(50, 50, FREE), &["thresh"]);
}

#[test]
fn broken_yaml() {
    refuses("image: [map.pgm\nresolution: 0.05\n", b"", &["line "]);
}

#[test]
fn a_single_cell() {
    for grey in [FREE, WALL, UNKNOWN] {
        refuses(YAML, &plain(1, 1, grey), &["no room"]);
    }
}

#[test]
fn nothing_but_free_space() {
    refuses(YAML, &plain(50, 50, FREE), &["no walls"]);
}

#[test]
fn nothing_known() {
    refuses(YAML, &plain(50, 50, UNKNOWN), &["no free space"]);
}

#[test]
fn nothing_but_walls() {
    refuses(YAML, &plain(50, 50, WALL), &["no free space"]);
}
