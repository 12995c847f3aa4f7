//! What adapters are given: documents of every kind, sound and damaged.

use image::{DynamicImage, GrayAlphaImage, GrayImage, ImageBuffer, ImageFormat, Luma, LumaA, RgbImage};
use planform_sdk::Source;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use tempfile::TempDir;

const WIDTH: u32 = 24;
const HEIGHT: u32 = 17;

/// A room with a wall around it within unknown space, as greys.
fn grey(x: u32, y: u32) -> u8 {
    let (outside, inside) =
        (!(2..22).contains(&x) || !(2..15).contains(&y), (3..21).contains(&x) && (3..14).contains(&y));
    match (outside, inside) {
        (true, _) => 205,
        (_, true) => 254,
        _ => (x * 3 % 7) as u8,
    }
}

fn encoded(picture: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
    let mut out = Cursor::new(vec![]);
    picture.into().write_to(&mut out, format).unwrap();
    out.into_inner()
}

fn pictures() -> Vec<(&'static str, Vec<u8>)> {
    let plain = || GrayImage::from_fn(WIDTH, HEIGHT, |x, y| Luma([grey(x, y)]));
    let deep = || ImageBuffer::from_fn(WIDTH, HEIGHT, |x, y| Luma([u16::from(grey(x, y)) * 257 + x as u16]));
    let clear =
        GrayAlphaImage::from_fn(WIDTH, HEIGHT, |x, y| LumaA([grey(x, y), if x < 5 { 0 } else { 255 }]));
    let coloured = RgbImage::from_fn(WIDTH, HEIGHT, |x, y| image::Rgb([grey(x, y), 200, (x * y) as u8]));
    vec![
        ("map.pgm", encoded(plain(), ImageFormat::Pnm)),
        ("map.png", encoded(plain(), ImageFormat::Png)),
        ("map.tiff", encoded(plain(), ImageFormat::Tiff)),
        ("map.bmp", encoded(plain(), ImageFormat::Bmp)),
        ("map.jpg", encoded(plain(), ImageFormat::Jpeg)),
        ("deep.pgm", encoded(DynamicImage::ImageLuma16(deep()), ImageFormat::Pnm)),
        ("deep.png", encoded(DynamicImage::ImageLuma16(deep()), ImageFormat::Png)),
        ("deep.tif", encoded(DynamicImage::ImageLuma16(deep()), ImageFormat::Tiff)),
        ("clear.png", encoded(clear, ImageFormat::Png)),
        ("coloured.png", encoded(coloured, ImageFormat::Png)),
        ("lying.pgm", b"P5\n60000 60000\n255\n".to_vec()),
        ("not a picture.png", b"no picture at all".to_vec()),
        ("empty.png", vec![]),
    ]
}

/// A YAML file of a map with these lines instead of the usual ones, or beside them.
fn yaml(lines: &[&str]) -> Vec<u8> {
    let usual = [
        "image: map.pgm",
        "resolution: 0.05",
        "origin: [-1.5, 2.0, 0.5]",
        "negate: 0",
        "occupied_thresh: 0.65",
        "free_thresh: 0.196",
    ];
    let key = |line: &str| line.split(':').next().unwrap_or_default().to_owned();
    let kept = usual.iter().filter(|u| !lines.iter().any(|l| key(l) == key(u)));
    kept.chain(lines).map(|line| format!("{line}\n")).collect::<String>().into_bytes()
}

fn yamls() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("rotated.yaml", yaml(&[])),
        ("far.yaml", yaml(&["origin: [-123456.789, 0.1, -3.0]"])),
        ("scale.yml", yaml(&["mode: scale", "image: deep.tif"])),
        ("raw.yaml", yaml(&["mode: raw"])),
        ("negated.yaml", yaml(&["negate: 1", "image: clear.png"])),
        ("no-picture.yaml", yaml(&["image: nowhere.pgm"])),
        ("folder.yaml", yaml(&["image: ."])),
        ("damaged-picture.yaml", yaml(&["image: not a picture.png"])),
        ("huge-picture.yaml", yaml(&["image: lying.pgm"])),
        ("no-resolution.yaml", yaml(&["resolution: none"])),
        ("negative.yaml", yaml(&["resolution: -1"])),
        ("odd-origin.yaml", yaml(&["origin: [.nan, 0, 0]"])),
        ("thresholds.yaml", yaml(&["free_thresh: 0.9"])),
        ("mode.yaml", yaml(&["mode: guess"])),
        ("broken.yaml", yaml(&["origin: [1, 2"])),
        ("latin.yaml", b"image: caf\xe9.pgm\n".to_vec()),
        ("empty.yaml", vec![]),
    ]
}

/// A folder with all documents.
pub fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in pictures().into_iter().chain(yamls()) {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

/// A log of a laser that turns in a room which is a square of 4 m, sound and damaged, and what is no log.
pub fn logs() -> Vec<Source> {
    let range = |direction: f64| 2.0 / direction.cos().abs().max(direction.sin().abs());
    let scan = |i: u32| {
        let heading = f64::from(i) * 0.3;
        let beam = |j: u32| format!("{:.2} ", range(heading + (f64::from(j) - 90.0).to_radians()));
        let ranges: String = (0..181).map(beam).collect();
        format!("FLASER 181 {ranges}0 0 {heading} 0 0 {heading} {i} host {i}\nNEFF 10\n")
    };
    let source =
        |bytes: Vec<u8>| Source { path: "turning.log".into(), bytes, byte_limit: Source::BYTE_LIMIT };
    let sound = source((0..20).map(scan).collect::<String>().into_bytes());
    let mut all = damaged(&sound);
    all.extend([sound, source(vec![]), source(b"no log\n".to_vec())]);
    all
}

/// The document cut short, and with a byte changed, at several places.
fn damaged(source: &Source) -> Vec<Source> {
    let length = source.bytes.len();
    let places = (1..8).map(|i| i * length / 8).filter(|place| *place < length);
    let with = |bytes: Vec<u8>| Source { bytes, ..source.clone() };
    places
        .flat_map(|place| {
            let mut changed = source.bytes.clone();
            changed[place] ^= 0x55;
            [with(source.bytes[..place].to_vec()), with(changed)]
        })
        .collect()
}

/// Every document in the folder, sound and damaged, and some under other conditions.
pub fn all(folder: &TempDir) -> Vec<Source> {
    let names = pictures().into_iter().chain(yamls()).map(|(name, _)| name);
    let open = |name: &str| Source::open(folder.path().join(name), Source::BYTE_LIMIT).unwrap();
    let mut all: Vec<Source> = names.map(open).collect();
    let harmed = ["map.png", "deep.tif", "deep.pgm", "map.jpg", "rotated.yaml"];
    all.extend(harmed.iter().flat_map(|name| damaged(&open(name))));
    all.push(Source { byte_limit: 100, ..open("rotated.yaml") });
    all.extend(["map.png", "rotated.yaml"].map(|name| Source { path: PathBuf::new(), ..open(name) }));
    all.extend(not_utf8().map(|name| Source { path: folder.path().join(name), ..open("map.png") }));
    all
}

/// A name that is not UTF-8, where there can be one.
#[cfg(unix)]
fn not_utf8() -> Option<PathBuf> {
    use std::os::unix::ffi::OsStringExt;
    Some(std::ffi::OsString::from_vec(b"caf\xe9.png".to_vec()).into())
}

#[cfg(not(unix))]
fn not_utf8() -> Option<PathBuf> {
    None
}
