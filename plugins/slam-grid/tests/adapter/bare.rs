//! Bare pictures of every type.

use crate::support::*;
use image::{DynamicImage, ImageFormat};
use planform_sdk::Pose;

/// Black, white; middle greys that no rule takes for unknown; row 0 of the result is the bottom.
const GREYS: [u8; 6] = [0, 255, 51, 204, 102, 153];
const CELLS: [i16; 6] = [20, 60, 40, 100, 0, 80];

#[test]
fn every_type_of_picture_gives_the_same_cells() {
    let grey = picture(3, &GREYS);
    let depths: [(&str, DynamicImage); 8] = [
        ("L8", grey.clone()),
        ("LA8", grey.to_luma_alpha8().into()),
        ("RGB8", grey.to_rgb8().into()),
        ("RGBA8", grey.to_rgba8().into()),
        ("L16", grey.to_luma16().into()),
        ("LA16", grey.to_luma_alpha16().into()),
        ("RGB16", grey.to_rgb16().into()),
        ("RGBA16", grey.to_rgba16().into()),
    ];
    let formats = [ImageFormat::Png, ImageFormat::Pnm, ImageFormat::Bmp, ImageFormat::Tiff];
    let mut read = 0;
    for (depth, picture) in depths {
        for format in formats {
            let mut out = std::io::Cursor::new(vec![]);
            if picture.write_to(&mut out, format).is_err() {
                continue;
            }
            let scene = read_bytes("map", &out.into_inner(), &[("resolution", "0.05")])
                .unwrap_or_else(|e| panic!("{depth} {format:?}: {e}"));
            assert_eq!(cells(&scene), CELLS, "{depth} {format:?}");
            assert!(scene.warnings.is_empty());
            read += 1;
        }
    }
    assert!(read >= 20, "only {read} of the types could be written");
}

#[test]
fn jpeg_is_nearly_the_same() {
    let jpeg = encode(&picture(16, &[[255; 128], [0; 128]].concat()), ImageFormat::Jpeg);
    let cells = cells(&read_bytes("a.jpg", &jpeg, &[]).unwrap());
    assert!(cells[..128].iter().all(|&c| c > 95) && cells[128..].iter().all(|&c| c < 5), "{cells:?}");
}

#[test]
fn anymaps_in_text_and_bits() {
    let read = |bytes: &[u8]| cells(&read_bytes("a.pgm", bytes, &[]).unwrap());
    assert_eq!(read(b"P2\n# by hand\n3 2\n255\n0 255 51\n204 102 153\n"), CELLS);
    assert_eq!(read(b"P1\n3 2\n1 0 1\n0 0 0\n"), [0, 0, 0, 100, 0, 100]);
    assert_eq!(read(b"P4\n3 2\n\xa0\x00"), [0, 0, 0, 100, 0, 100]);
    assert_eq!(read(b"P3\n1 1\n255\n255 0 0\n"), [67]);
    assert_eq!(read(b"P2\n2 1\n100\n0 100\n"), [100, 0], "greys are counted up to the file's own white");
    assert_eq!(read(b"P5\n2 1\n15\n\x00\x0f"), [100, 0]);
}

#[test]
fn palettes_are_looked_up() {
    // 2 x 1 pixels of 4 bits with a palette of white and black, as paint programs write.
    let mut bmp = b"BM".to_vec();
    bmp.extend(66_u32.to_le_bytes());
    bmp.extend([0; 4]);
    bmp.extend(62_u32.to_le_bytes());
    bmp.extend(40_u32.to_le_bytes());
    bmp.extend(2_i32.to_le_bytes());
    bmp.extend(1_i32.to_le_bytes());
    bmp.extend([1, 0, 4, 0]);
    bmp.extend([0; 16]);
    bmp.extend(2_u32.to_le_bytes());
    bmp.extend([0; 4]);
    bmp.extend([255, 255, 255, 0, 0, 0, 0, 0]);
    bmp.extend([0x01, 0, 0, 0]);
    assert_eq!(cells(&read_bytes("a.bmp", &bmp, &[]).unwrap()), [0, 100]);
}

#[test]
fn place_and_size_of_the_pixels() {
    let png = encode(&picture(1, &[255]), ImageFormat::Png);
    let scene = read_bytes("a.png", &png, &[]).unwrap();
    assert_eq!((scene.grid.origin(), scene.grid.resolution()), (Pose::default(), 0.05));
    assert_eq!(cells(&scene), [0]);
    assert_eq!(read_bytes("", &png, &[("resolution", "0.1")]).unwrap().grid.resolution(), 0.1);
    assert!(read_bytes("", &png, &[("resolution", "0")]).is_err());
}

/// 40 x 40 pixels: unknown around a walled room.
fn room(unknown: u8, wall: u8, free: u8) -> Vec<u8> {
    let inside = |x: usize, y: usize, margin: usize| {
        (margin..40 - margin).contains(&x) && (margin..40 - margin).contains(&y)
    };
    let grey = |x, y| {
        if inside(x, y, 10) {
            free
        } else if inside(x, y, 9) {
            wall
        } else {
            unknown
        }
    };
    (0..1600).map(|i| grey(i % 40, i / 40)).collect()
}

#[test]
fn unknown_is_found_given_or_denied() {
    let corner = |unknown: u8, set: &[(&str, &str)]| {
        let png = encode(&picture(40, &room(unknown, 0, 255)), ImageFormat::Png);
        let cells = cells(&read_bytes("a.png", &png, set).unwrap());
        assert_eq!((cells[9 * 40 + 9], cells[20 * 40 + 20]), (100, 0));
        cells[0]
    };
    for grey in [128, 153, 178, 205, 230] {
        assert_eq!(corner(grey, &[]), -1, "{grey}");
        assert_eq!(
            corner(grey, &[("unknown", "none")]),
            i16::from((f64::from(255 - grey) / 2.55).round() as u8)
        );
    }
    assert_eq!(corner(50, &[]), 80);
    assert_eq!(corner(50, &[("unknown", "51")]), -1);
    assert!(read_bytes("", &encode(&picture(1, &[0]), ImageFormat::Png), &[("unknown", "grey")]).is_err());
}

#[test]
fn jpeg_noise_does_not_hide_unknown() {
    let mut out = std::io::Cursor::new(vec![]);
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut out, 60);
    picture(40, &room(178, 0, 255)).write_with_encoder(encoder).unwrap();
    let cells = cells(&read_bytes("a.jpg", &out.into_inner(), &[]).unwrap());
    // All that is 4 pixels from an edge.
    for row in (0..5).chain(35..40) {
        assert!(cells[row * 40..][..40].iter().all(|&c| c == -1), "row {row}");
    }
    assert!(cells[20 * 40 + 15..][..10].iter().all(|&c| (0..10).contains(&c)));
}

#[test]
fn negate_turns_the_picture() {
    let png = encode(&picture(40, &room(60, 255, 0)), ImageFormat::Png);
    let cells = cells(&read_bytes("a.png", &png, &[("negate", "true")]).unwrap());
    assert_eq!((cells[0], cells[9 * 40 + 9], cells[20 * 40 + 20]), (-1, 100, 0));
    let png = encode(&picture(1, &[10]), ImageFormat::Png);
    let given = read_bytes("a.png", &png, &[("negate", "true"), ("unknown", "10")]).unwrap();
    assert!(given.grid.cells()[0].is_unknown());
}

#[test]
fn saved_maps_mean_the_same_with_and_without_yaml() {
    let greys = [254, 254, 205, 0, 254, 0];
    let pgm = encode(&picture(3, &greys), ImageFormat::Pnm);
    let bare = read_bytes("map.pgm", &pgm, &[]).unwrap();
    let folder = folder(&[("map.yaml", YAML.as_bytes()), ("map.pgm", &pgm)]);
    assert_eq!(cells(&bare), cells(&read_in(folder.path(), "map.yaml", &[]).unwrap()));
}

#[test]
fn transparent_is_unknown() {
    let pixels = [[255_u8, 0], [255, 255], [0, 255], [0, 100]];
    let image = image::ImageBuffer::from_fn(4, 1, |x, _| image::LumaA(pixels[x as usize]));
    let png = encode(&image.into(), ImageFormat::Png);
    assert_eq!(cells(&read_bytes("a.png", &png, &[]).unwrap()), [-1, 0, 100, -1]);
}

#[test]
fn an_assumed_resolution_is_said() {
    let pgm = b"P5\n2 1\n255\n\x00\xff";
    let warnings = |options: &[(&str, &str)]| read_bytes("map.pgm", pgm, options).unwrap().warnings;
    assert!(warnings(&[])[0].contains("0.05 m wide"));
    assert_eq!(warnings(&[("resolution", "0.02")]), Vec::<String>::new());
}
