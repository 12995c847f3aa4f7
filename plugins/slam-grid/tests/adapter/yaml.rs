//! Sound YAML files, in all the shapes they are found in.

use crate::support::*;
use image::{DynamicImage, ImageBuffer, ImageFormat, LumaA, Rgb};
use planform_sdk::Pose;

const CELLS: [i16; 4] = [100, -1, 0, -1];

#[test]
fn plain_map_is_upright_and_in_its_place() {
    let scene = read_yaml(YAML).unwrap();
    assert_eq!(cells(&scene), CELLS);
    assert_eq!(scene.grid.origin(), Pose { x: -1.5, y: 2.0, yaw: 0.5 });
    assert_eq!((scene.grid.resolution(), scene.grid.width(), scene.grid.height()), (0.05, 2, 2));
    assert_eq!(
        (scene.provenance.source.as_str(), scene.provenance.adapter.as_str()),
        ("map.yaml", "slam-grid")
    );
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
}

#[test]
fn shapes_of_the_file_do_not_matter() {
    let turned: String = YAML.lines().rev().map(|l| format!("{l}\n")).collect();
    let shapes = [
        YAML.replace('\n', "\r\n"),
        format!("\u{feff}{YAML}"),
        YAML.trim_end().to_owned(),
        format!("# a map\n{}", YAML.replace("0.5]", "0.5]   # pose of the corner")),
        YAML.replace("map.pgm", "\"map.pgm\"").replace("0.05", "'0.05'"),
        format!("{YAML}frame_id: map\nextra: {{a: [1, 2, .nan]}}\n"),
        format!("---\n{YAML}...\n"),
        YAML.replace("[-1.5, 2.0, 0.5]", "\n  - -1.5\n  - 2\n  - 5e-1"),
        YAML.replace("map.pgm", "./map.pgm"),
        format!("{YAML}mode: trinary\n"),
        format!("{YAML}mode: Trinary\n"),
        turned,
    ];
    for yaml in shapes {
        let scene = read_yaml(&yaml).unwrap_or_else(|e| panic!("{e}\n{yaml}"));
        assert_eq!(cells(&scene), CELLS, "{yaml}");
        assert_eq!(scene.grid.origin(), Pose { x: -1.5, y: 2.0, yaw: 0.5 }, "{yaml}");
        assert!(scene.warnings.is_empty(), "{:?}\n{yaml}", scene.warnings);
    }
}

#[test]
fn comments_may_be_in_latin_1() {
    let mut yaml = b"# gr\xfc\xdfe\n".to_vec();
    yaml.extend(YAML.as_bytes());
    let pgm = encode(&picture(1, &[0]), ImageFormat::Pnm);
    let folder = folder(&[("map.yaml", &yaml), ("map.pgm", &pgm)]);
    assert_eq!(cells(&read_in(folder.path(), "map.yaml", &[]).unwrap()), [100]);
}

#[test]
fn negate_is_a_number_or_a_word() {
    for (word, expected) in [("0", CELLS), ("false", CELLS), ("no", CELLS)] {
        let scene = read_yaml(&YAML.replace("negate: 0", &format!("negate: {word}"))).unwrap();
        assert_eq!(cells(&scene), expected, "{word}");
    }
    for word in ["1", "true", "True", "yes", "'1'"] {
        let scene = read_yaml(&YAML.replace("negate: 0", &format!("negate: {word}"))).unwrap();
        assert_eq!(cells(&scene), [0, -1, 100, 100], "{word}");
    }
}

#[test]
fn modes_scale_and_raw() {
    // 100 is 0.6078 dark: (0.6078 - 0.196) / (0.65 - 0.196) of the way.
    assert_eq!(cells(&read_yaml(&format!("{YAML}mode: scale\n")).unwrap()), [100, 91, 0, 0]);
    assert_eq!(cells(&read_yaml(&format!("{YAML}mode: raw\n")).unwrap()), [0, 100, -1, -1]);
}

#[test]
fn broken_yaw_is_no_yaw_but_told() {
    for nan in ["nan", "-nan", ".nan", "\"-nan\"", ".NaN"] {
        let scene = read_yaml(&YAML.replace("0.5]", &format!("{nan}]"))).unwrap();
        assert_eq!(scene.grid.origin().yaw, 0.0, "{nan}");
        assert_eq!(
            scene.warnings,
            ["line 3: the yaw of `origin` is not a number; it is taken as 0"],
            "{nan}"
        );
    }
}

#[test]
fn left_out_keys_are_told() {
    let yaml = "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n";
    let scene = read_yaml(yaml).unwrap();
    assert_eq!(cells(&scene), CELLS);
    assert_eq!(scene.warnings.len(), 3, "{:?}", scene.warnings);
}

#[test]
fn explicit_resolution_wins_and_is_told() {
    let pgm = encode(&picture(1, &[0]), ImageFormat::Pnm);
    let folder = folder(&[("map.yaml", YAML.as_bytes()), ("map.pgm", &pgm)]);
    let scene = read_in(folder.path(), "map.yaml", &[("resolution", "0.1")]).unwrap();
    assert_eq!(scene.grid.resolution(), 0.1);
    assert_eq!(scene.warnings, ["the option `resolution` 0.1 is used instead of the YAML file's 0.05"]);
    let scene = read_in(folder.path(), "map.yaml", &[("resolution", "0.05")]).unwrap();
    assert!(scene.warnings.is_empty());
    let scene = read_in(folder.path(), "map.yaml", &[("negate", "true"), ("unknown", "none")]).unwrap();
    assert_eq!(scene.warnings.len(), 2, "{:?}", scene.warnings);
}

#[test]
fn unknown_grey_that_becomes_free_is_told() {
    let scene = read_yaml(&YAML.replace("0.196", "0.25")).unwrap();
    assert_eq!(cells(&scene), [100, -1, 0, 0]);
    assert!(scene.warnings[0].contains("205"), "{:?}", scene.warnings);
}

#[test]
fn colours_are_averaged() {
    let rgb = DynamicImage::from(ImageBuffer::from_fn(2, 1, |x, _| {
        // The mean of the first is 80 (dark: 0.69), that of the second 81.
        if x == 0 { Rgb([240_u8, 0, 0]) } else { Rgb([90, 90, 93]) }
    }));
    let yaml = YAML.replace("map.pgm", "map.png").replace("0.65", "0.6824");
    let folder = folder(&[("map.yaml", yaml.as_bytes()), ("map.png", &encode(&rgb, ImageFormat::Png))]);
    assert_eq!(cells(&read_in(folder.path(), "map.yaml", &[]).unwrap()), [100, -1]);
}

#[test]
fn alpha_is_treated_as_map_servers_do() {
    let pixels = [[255_u8, 255], [255, 0], [0, 255], [205, 255]];
    let image = DynamicImage::from(ImageBuffer::from_fn(4, 1, |x, _| LumaA(pixels[x as usize])));
    let png = encode(&image, ImageFormat::Png);
    let read = |mode: &str| {
        let yaml = format!("{}mode: {mode}\n", YAML.replace("map.pgm", "map.png"));
        let folder = folder(&[("map.yaml", yaml.as_bytes()), ("map.png", &png)]);
        read_in(folder.path(), "map.yaml", &[]).unwrap()
    };
    let trinary = read("trinary");
    assert_eq!(cells(&trinary), [0, -1, 100, 0]);
    assert_eq!(trinary.warnings.len(), 2, "{:?}", trinary.warnings);
    assert_eq!(cells(&read("scale")), [0, -1, 100, 0]);
    assert_eq!(cells(&read("raw")), [-1, -1, 0, -1]);
}

#[test]
fn picture_may_be_anywhere() {
    let pgm = encode(&picture(1, &[0]), ImageFormat::Pnm);
    let folder = folder(&[]);
    std::fs::create_dir(folder.path().join("maps")).unwrap();
    std::fs::write(folder.path().join("a map.pgm"), &pgm).unwrap();
    let absolute = folder.path().join("a map.pgm").display().to_string();
    for image in ["../a map.pgm", &absolute] {
        std::fs::write(folder.path().join("maps/map.yaml"), YAML.replace("map.pgm", image)).unwrap();
        assert_eq!(cells(&read_in(folder.path(), "maps/map.yaml", &[]).unwrap()), [100], "{image}");
    }
}

#[test]
fn yaml_from_standard_input_finds_its_picture() {
    let folder = folder(&[("map.pgm", &encode(&picture(1, &[0]), ImageFormat::Pnm))]);
    let yaml = YAML.replace("map.pgm", &folder.path().join("map.pgm").display().to_string());
    let scene = read_bytes("", yaml.as_bytes(), &[]).unwrap();
    assert_eq!((cells(&scene), scene.provenance.source.as_str()), (vec![100], "standard input"));
}
