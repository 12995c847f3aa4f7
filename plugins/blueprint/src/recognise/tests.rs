use super::is_drawing;
use image::codecs::jpeg::JpegEncoder;
use image::imageops::FilterType;
use image::{DynamicImage, GrayImage, ImageFormat, Luma, LumaA, Rgb, RgbImage, Rgba};
use planform_synth::Sample;

/// Around this one hardly anything is unknown: rays pass its glass walls.
const GLASS: u64 = 3;

/// White, with the walls, letters and a table of a plan of 12 x 9 m at 0.02 m.
fn plan() -> GrayImage {
    let mut picture = GrayImage::from_pixel(640, 500, Luma([255]));
    let mut bar = |x: u32, y: u32, width: u32, height: u32| {
        for (x, y) in (y..y + height).flat_map(|y| (x..x + width).map(move |x| (x, y))) {
            picture.put_pixel(x, y, Luma([0]));
        }
    };
    for y in [30, 240, 460] {
        bar(30, y, 580, 8);
    }
    for x in [30, 220, 410, 602] {
        bar(x, 30, 8, 438);
    }
    for letter in 0..40 {
        bar(60 + letter * 12, 120 + letter % 2 * 200, 2, 10);
        bar(60 + letter * 12, 120 + letter % 2 * 200, 7, 2);
    }
    picture
}

fn tones(of: &GrayImage, tone: impl Fn(u32, u32, u8) -> u8) -> DynamicImage {
    let mut picture = of.clone();
    picture.enumerate_pixels_mut().for_each(|(x, y, p)| p.0[0] = tone(x, y, p.0[0]));
    picture.into()
}

fn coloured(of: &GrayImage, colour: impl Fn(u8) -> [u8; 3]) -> DynamicImage {
    let pixel = |x, y| Rgb(colour(of.get_pixel(x, y).0[0]));
    RgbImage::from_fn(of.width(), of.height(), pixel).into()
}

/// The plan in the middle of a larger picture.
fn framed(border: u8) -> DynamicImage {
    let mut picture = GrayImage::from_pixel(760, 620, Luma([border]));
    image::imageops::replace(&mut picture, &plan(), 60, 60);
    picture.into()
}

/// A picture of a made-up building's map, `unknown` all around it.
fn map(seed: u64, unknown: u8) -> GrayImage {
    let grid = Sample::draw(seed).unwrap().grid;
    let tone = |x, y: u32| match grid.cell(i64::from(x), i64::from(grid.height() - 1 - y)).occupancy() {
        None => unknown,
        Some(occupancy) => 254 - (2.54 * f64::from(occupancy)) as u8,
    };
    GrayImage::from_fn(grid.width(), grid.height(), |x, y| Luma([tone(x, y)]))
}

fn compressed(picture: &DynamicImage) -> DynamicImage {
    let mut bytes = Vec::new();
    picture.write_with_encoder(JpegEncoder::new_with_quality(&mut bytes, 50)).unwrap();
    image::load_from_memory_with_format(&bytes, ImageFormat::Jpeg).unwrap()
}

fn check(picture: &DynamicImage, drawing: bool, what: &str) {
    let judgement = is_drawing(picture);
    assert_eq!(judgement.percent > 60, drawing, "{what}: {judgement:?}");
}

#[test]
fn made_up_maps_are_maps_whatever_their_unknown() {
    for seed in [0, 1, 2, 4, 5, 6] {
        for unknown in [205, 128, 230, 0] {
            let what = format!("map {seed} with {unknown}");
            let map = DynamicImage::from(map(seed, unknown));
            check(&map, false, &what);
            let (width, height) = (map.width() * 2 / 5 + 1, map.height() * 2 / 5 + 1);
            check(&map.resize_exact(width, height, FilterType::Triangle), false, &format!("small {what}"));
            check(&compressed(&map), false, &format!("compressed {what}"));
        }
    }
}

#[test]
fn a_map_that_was_seen_through_glass_walls_is_a_map() {
    check(&map(GLASS, 205).into(), false, "glass");
}

#[test]
fn maps_with_transparent_or_padded_surroundings_are_maps() {
    for seed in [0, 1, 2, 5, 6] {
        let map = map(seed, 205);
        let clear = image::ImageBuffer::from_fn(map.width(), map.height(), |x, y| {
            let tone = map.get_pixel(x, y).0[0];
            LumaA([tone, if tone == 205 { 0 } else { 255 }])
        });
        check(&clear.into(), false, &format!("transparent {seed}"));
        let mut padded = GrayImage::from_pixel(map.width() + 60, map.height() + 60, Luma([255]));
        image::imageops::replace(&mut padded, &map, 30, 30);
        check(&padded.into(), false, &format!("padded {seed}"));
        let mut path = DynamicImage::from(map).to_rgb8();
        let diagonal = path.width().min(path.height());
        (0..diagonal).for_each(|i| path.put_pixel(i, i, Rgb([255, 0, 0])));
        check(&path.into(), false, &format!("with a path {seed}"));
    }
}

#[test]
fn drawings_are_drawings_on_any_paper() {
    let plan = plan();
    let noise = |x: u32, y: u32| (x * 7919 + y * 104_729) % 7;
    let lit =
        |x: u32, y: u32, t: u8| ((u32::from(t) * (70 + x * 28 / 640) / 100).min(240) + noise(x, y)) as u8;
    let on_clear = DynamicImage::from(image::ImageBuffer::from_fn(640, 500, |x, y| {
        Rgba([0, 0, 0, 255 - plan.get_pixel(x, y).0[0]])
    }));
    for (what, picture) in [
        ("white", plan.clone().into()),
        ("off-white", tones(&plan, |_, _, t| (u32::from(t) * 235 / 255) as u8)),
        ("scanned", tones(&plan, |x, y, t| (u32::from(t) * 230 / 255 + noise(x, y)) as u8)),
        ("photographed", tones(&plan, lit)),
        ("inverted", tones(&plan, |_, _, t| 255 - t)),
        ("blue", coloured(&plan, |t| if t > 128 { [20, 60, 140] } else { [240, 240, 255] })),
        ("transparent", on_clear),
        ("scanned with black borders", framed(0)),
        ("shown on a screen", framed(82)),
        ("compressed", compressed(&plan.clone().into())),
        (
            "rooms filled grey",
            tones(&plan, |x, y, t| if t > 0 && x > 38 && x < 602 && y > 38 && y < 460 { 208 } else { t }),
        ),
    ] {
        check(&picture, true, what);
    }
}

#[test]
fn colours_make_a_drawing() {
    let green = |t: u8| if t > 128 { [90, 200, 120] } else { [0, 0, 0] };
    check(&coloured(&plan(), green), true, "green paper");
}

#[test]
fn any_picture_is_judged() {
    for (width, height) in [(1, 1), (1, 3000), (3000, 1), (3, 2)] {
        for tone in [0, 128, 255] {
            is_drawing(&GrayImage::from_pixel(width, height, Luma([tone])).into());
            is_drawing(&image::ImageBuffer::from_pixel(width, height, LumaA([tone, 0])).into());
        }
    }
    is_drawing(&DynamicImage::new_rgb32f(5, 5));
    is_drawing(&DynamicImage::new_luma8(0, 0));
}

#[test]
fn a_large_picture_takes_no_longer() {
    let large = GrayImage::from_pixel(9000, 7000, Luma([255]));
    let start = std::time::Instant::now();
    check(&large.into(), true, "paper");
    assert!(start.elapsed().as_secs_f64() < 5.0);
}
