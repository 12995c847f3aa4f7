//! The plugins to copy from are built as their README says, stand every check, and convert.
#![cfg(target_os = "linux")]
// Clippy knows the tests themselves, but not what they call.
#![allow(clippy::unwrap_used)]

mod cli_support;
mod plugin_support;

use cli_support::{Workshop, text};
use plugin_support::{build, root};
use std::fs;
use std::process::Command;

/// A folder with `movingai.so`, made by its own Makefile, and its sample.
fn movingai() -> Workshop {
    let w = Workshop::new();
    fs::create_dir_all(w.path("plugins/examples/movingai")).unwrap();
    for file in ["Makefile", "movingai.c", "flat.map"] {
        let path = format!("plugins/examples/movingai/{file}");
        fs::copy(root().join(&path), w.path(&path)).unwrap();
    }
    fs::create_dir_all(w.path("plugins/sdk/include")).unwrap();
    let header = "plugins/sdk/include/planform.h";
    fs::copy(root().join(header), w.path(header)).unwrap();
    let made = Command::new("make").arg("-C").arg(w.path("plugins/examples/movingai")).output().unwrap();
    assert!(made.status.success(), "{}", text(&made.stderr));
    w
}

const FLAT: &str = "plugins/examples/movingai/flat.map";
const FOLDER: &str = "--plugin-dir plugins/examples/movingai";

#[test]
fn movingai_stands_every_check() {
    let w = movingai();
    let (out, _) = w.does(&format!("plugins check plugins/examples/movingai/movingai.so --sample {FLAT}"));
    assert!(out.lines().count() >= 11 && out.lines().all(|l| l.starts_with("ok ")), "{out}");
}

#[test]
fn movingai_reads_its_sample() {
    let w = movingai();
    let (_, err) = w.does(&format!("convert {FLAT} {FOLDER} -o flat.svg -o flat.dxf -o flat.geojson"));
    assert!(err.contains("5 rooms, 20 walls, 4 doors"), "{err}");
    let (_, err) = w.does(&format!("convert {FLAT} {FOLDER} --trust-plugins -o trusted.geojson"));
    assert!(err.contains("5 rooms"), "{err}");
    assert_eq!(w.read("flat.geojson"), w.read("trusted.geojson"));
    let (out, _) = w.does(&format!("inspect {FLAT} {FOLDER} --resolution 0.1"));
    assert!(out.contains("movingai is") && out.contains("0.1 m per cell"), "{out}");
}

#[test]
fn movingai_says_what_is_wrong_and_where() {
    let w = movingai();
    for (document, words) in [
        ("type octile\nheight 3\nwidth 4\nmap\n....\n..", ["line 6: ", ""]),
        ("type octile\nheight 99999999999999999999\nwidth 4\nmap\n", ["line 2: ", ""]),
        ("type octile\nheight 2\nwidth 2\nmap\n..\n.x\n", ["line 6: ", "x"]),
    ] {
        w.write("bad.map", document);
        w.refuses(&format!("convert bad.map {FOLDER} -o bad.svg"), 1, &["bad.map: ", words[0], words[1]]);
    }
    let refused = format!("convert {FLAT} {FOLDER} -o a.svg --set resolution=0");
    w.refuses(
        &refused,
        2,
        &["option `resolution` cannot be `0`; give a number of at least 0.0001 and of at most 1000"],
    );
}

/// A folder with a map of two rooms, and with the library of osm-indoor.
fn osm_indoor() -> Workshop {
    let w = Workshop::new();
    fs::create_dir(w.path("p")).unwrap();
    fs::copy(build("planform-osm-indoor"), w.path("p/osm.so")).unwrap();
    w
}

#[test]
fn osm_indoor_stands_every_check() {
    let (out, _) = osm_indoor().does("plugins check p/osm.so");
    assert!(out.lines().count() >= 6 && out.lines().all(|l| l.starts_with("ok ")), "{out}");
}

#[test]
fn osm_indoor_writes_a_building_on_the_earth() {
    let w = osm_indoor();
    let convert =
        "convert map.yaml --plugin-dir p --anchor 47.3769,8.5417,12.5 --set level=2 -o rooms.osm --force";
    w.does(convert);
    let first = w.read("rooms.osm");
    let osm = text(&first);
    let count = |tag: &str| osm.matches(tag).count();
    assert_eq!(count(r#"k="indoor" v="room""#), 2, "{osm}");
    assert_eq!(count(r#"k="indoor" v="door""#), 1, "{osm}");
    assert!(count(r#"k="indoor" v="wall""#) >= 7 && count(r#"k="level" v="2""#) >= 10, "{osm}");
    assert!(osm.contains("lat=\"47.37") && osm.contains("lon=\"8.54"), "{osm}");
    w.does(&format!("{convert} --trust-plugins"));
    assert_eq!(w.read("rooms.osm"), first);
    w.refuses("convert map.yaml --plugin-dir p -o other.osm -q", 2, &["other.osm: ", "anchor"]);
}
