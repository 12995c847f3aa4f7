//! One made-up map in the conventions of many programs, with lines drawn over it.

use super::{Lines, PictureParams, look, probe, read};
use image::{ImageFormat, Rgb, RgbImage};
use planform_sdk::{Cell, ErrorKind, Kept, Probe, Source};
use std::io::Cursor;
use std::path::PathBuf;

type Colour = [u8; 3];

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

const PARAMS: PictureParams =
    PictureParams { resolution: 0.05, free: None, unknown: None, wall: None, lines: Lines::Remove };

/// Two rooms with a door between them, and nothing known around them; from above.
fn truth(x: u32, y: u32) -> Cell {
    let inside = (30..130).contains(&x) && (25..95).contains(&y);
    let outline = inside && !((33..127).contains(&x) && (28..92).contains(&y));
    let between = (78..81).contains(&x) && !(50..68).contains(&y);
    match (inside, outline || between) {
        (false, _) => Cell::UNKNOWN,
        (true, true) => Cell::OCCUPIED,
        (true, false) => Cell::FREE,
    }
}

/// The map in these colours.
fn map(free: Colour, unknown: Colour, wall: Colour) -> RgbImage {
    RgbImage::from_fn(WIDTH, HEIGHT, |x, y| {
        Rgb(match truth(x, y) {
            Cell::FREE => free,
            Cell::OCCUPIED => wall,
            _ => unknown,
        })
    })
}

fn grey(free: u8, unknown: u8, wall: u8) -> RgbImage {
    map([free; 3], [unknown; 3], [wall; 3])
}

/// A way through both rooms, this many pixels wide.
fn with_way(mut picture: RgbImage, colour: Colour, width: u32) -> RgbImage {
    for x in 40..120 {
        let y = 58 + (8.0 * (f64::from(x) / 9.0).sin()) as u32 / 2;
        (0..width).for_each(|d| picture.put_pixel(x, y + d, Rgb(colour)));
    }
    (35..60).for_each(|y| (0..width).for_each(|d| picture.put_pixel(44 + d, y, Rgb(colour))));
    picture
}

fn encoded(picture: &RgbImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(vec![]);
    if format == ImageFormat::Gif {
        image::DynamicImage::ImageRgb8(picture.clone()).into_rgba8().write_to(&mut bytes, format).unwrap();
    } else {
        picture.write_to(&mut bytes, format).unwrap();
    }
    bytes.into_inner()
}

/// The share of cells that are as they should be.
fn agreement(bytes: &[u8], params: &PictureParams) -> f64 {
    let (grid, words) = read(bytes, params).unwrap();
    assert!(words.contains("is taken for free"), "{words}");
    let kind = |cell: Cell| cell.occupancy().map(|percent| percent > 50);
    let same = |i: &usize| {
        let (x, y) = (*i as u32 % WIDTH, HEIGHT - 1 - *i as u32 / WIDTH);
        kind(grid.cells()[*i]) == kind(truth(x, y))
    };
    (0..grid.cells().len()).filter(same).count() as f64 / grid.cells().len() as f64
}

fn png(picture: &RgbImage) -> Vec<u8> {
    encoded(picture, ImageFormat::Png)
}

#[test]
fn conventions_are_found() {
    for (free, unknown, wall) in [
        (254, 205, 0),
        (255, 128, 0),
        (200, 230, 0),
        (200, 255, 0),
        (255, 180, 60),
        (0, 100, 255),
        (240, 100, 0),
    ] {
        let drawn = with_way(grey(free, unknown, wall), [255, 0, 0], 2);
        assert_eq!(agreement(&png(&drawn), &PARAMS), 1.0, "{free} {unknown} {wall}");
    }
}

#[test]
fn lines_of_any_colour_and_width_vanish() {
    for colour in [[255, 0, 0], [0, 0, 255], [0, 160, 0], [255, 140, 0]] {
        for width in 1..5 {
            let drawn = with_way(grey(254, 205, 0), colour, width);
            assert_eq!(agreement(&png(&drawn), &PARAMS), 1.0, "{colour:?} {width}");
        }
    }
}

#[test]
fn unknown_may_have_a_colour() {
    for unknown in [[0, 0, 255], [180, 140, 90], [150, 200, 255]] {
        let plain = map([255; 3], unknown, [0; 3]);
        assert_eq!(agreement(&png(&plain), &PARAMS), 1.0, "{unknown:?}");
        assert_eq!(agreement(&png(&with_way(plain, [255, 0, 0], 2)), &PARAMS), 1.0, "{unknown:?} with a way");
    }
}

#[test]
fn formats_are_the_same_map() {
    let drawn = with_way(grey(255, 180, 0), [255, 0, 0], 2);
    for format in [ImageFormat::Gif, ImageFormat::Bmp, ImageFormat::Tiff, ImageFormat::Pnm] {
        assert_eq!(agreement(&encoded(&drawn, format), &PARAMS), 1.0, "{format:?}");
    }
    assert!(agreement(&encoded(&drawn, ImageFormat::Jpeg), &PARAMS) > 0.99);
}

#[test]
fn what_is_given_is_not_looked_for() {
    // Nothing tells these free and unknown greys apart but the user.
    let odd = grey(90, 254, 0);
    let params = PictureParams { free: Some(90), unknown: Some(254), wall: Some(0), ..PARAMS };
    assert_eq!(agreement(&png(&odd), &params), 1.0);
    let kept = with_way(grey(254, 205, 0), [0, 0, 160], 2);
    assert!(agreement(&png(&kept), &PictureParams { lines: Lines::Keep, ..PARAMS }) < 1.0);
    let same = PictureParams { free: Some(7), wall: Some(7), ..PARAMS };
    assert_eq!(read(&png(&odd), &same).unwrap_err().kind, ErrorKind::BadOption);
}

fn claim(bytes: Vec<u8>) -> u8 {
    let source = Source { path: PathBuf::from("map.png"), bytes, byte_limit: Source::BYTE_LIMIT };
    assert!((50..60).contains(&probe(&Probe::of(&source)).percent));
    look(&source, &Kept::default()).unwrap().percent
}

#[test]
fn only_maps_with_colours_are_claimed() {
    assert!(claim(png(&with_way(grey(254, 205, 0), [255, 0, 0], 1))) > 90);
    assert!(claim(png(&map([255; 3], [0, 0, 255], [0; 3]))) > 90);
    assert!(claim(png(&grey(254, 205, 0))) < 50, "a plain map");
    assert!(claim(png(&with_way(grey(255, 255, 0), [255, 0, 0], 1))) < 50, "lines on white paper");
    let mut photographed = with_way(grey(245, 245, 0), [0, 150, 0], 2);
    for (x, y, p) in photographed.enumerate_pixels_mut() {
        p.0 = p.0.map(|v| v.saturating_sub((x / 4 + y / 8) as u8));
    }
    assert!(claim(png(&photographed)) < 50, "a plan with a route on paper that is lit unevenly");
    assert!(claim(png(&with_way(grey(235, 235, 0), [0, 150, 0], 2))) < 50, "a plan on greyish paper");
    let strokes = map([0, 0, 160], [0, 0, 160], [255; 3]);
    assert!(claim(png(&strokes)) < 50, "white lines on blue paper");
    let motley = RgbImage::from_fn(WIDTH, HEIGHT, |x, y| Rgb([x as u8, (y * 2) as u8, (x * y) as u8]));
    assert!(claim(png(&motley)) < 50, "a photo");
}

#[test]
fn damaged_and_empty_pictures_get_their_sentence() {
    let whole = png(&grey(254, 205, 0));
    for bytes in
        [&whole[..60], &whole[..0], b"GIF89a\xff\xff\xff\xff", b"P6\n70000 70000\n255\n", b"no picture"]
    {
        let error = read(bytes, &PARAMS).unwrap_err();
        assert!(error.advice.is_some(), "{error}");
    }
    for side in [1, 2, 3] {
        for colour in [[0; 3], [255; 3], [128; 3], [255, 0, 0]] {
            let tiny = RgbImage::from_pixel(side, side, Rgb(colour));
            assert!(read(&png(&tiny), &PARAMS).is_ok(), "{side} {colour:?}");
            let source = Source { path: PathBuf::new(), bytes: png(&tiny), byte_limit: 1 << 20 };
            assert!(look(&source, &Kept::default()).unwrap().percent < 50);
        }
    }
}
