use super::*;
use image::{ColorType, GrayImage, ImageEncoder, Rgb};
use std::io::Write;

fn png_of(width: u32, height: u32, colour: ::png::ColorType, depth: ::png::BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = vec![];
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    if colour == ::png::ColorType::Indexed {
        encoder.set_palette(vec![255, 0, 0, 0, 0, 255]);
        encoder.set_trns(vec![255, 0]);
    }
    let unit = ::png::Unit::Meter;
    encoder.set_pixel_dims(Some(::png::PixelDimensions { xppu: 11_811, yppu: 11_811, unit }));
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    bytes
}

fn pixels(bytes: &[u8], format: ImageFormat) -> Vec<u8> {
    page(bytes, format, 1).unwrap().picture.into_raw()
}

#[test]
fn png_of_all_kinds_lies_on_white_paper() {
    use ::png::{BitDepth, ColorType};
    for (colour, depth, data, expected) in [
        (ColorType::Grayscale, BitDepth::One, &[0b0100_0000_u8][..], [0, 0, 0, 255, 255, 255]),
        (ColorType::GrayscaleAlpha, BitDepth::Eight, &[0, 0, 80, 255], [255, 255, 255, 80, 80, 80]),
        (
            ColorType::GrayscaleAlpha,
            BitDepth::Sixteen,
            &[0, 0, 0, 0, 80, 0, 255, 255],
            [255, 255, 255, 80, 80, 80],
        ),
        (ColorType::Indexed, BitDepth::One, &[0b0100_0000], [255, 0, 0, 255, 255, 255]),
        (ColorType::Rgb, BitDepth::Sixteen, &[1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0], [1, 2, 3, 4, 5, 6]),
        (ColorType::Rgba, BitDepth::Eight, &[1, 2, 3, 255, 4, 5, 6, 0], [1, 2, 3, 255, 255, 255]),
    ] {
        let bytes = png_of(2, 1, colour, depth, data);
        assert_eq!(pixels(&bytes, ImageFormat::Png), expected, "{colour:?} {depth:?}");
        let dpi = page(&bytes, ImageFormat::Png, 1).unwrap().dpi.unwrap();
        assert!((dpi - 300.0).abs() < 0.1, "{dpi}");
    }
}

/// A TIFF whose pages are as wide as their number, each of another density.
fn tiff_of(pages: u32) -> Vec<u8> {
    use ::tiff::encoder::{Rational, TiffEncoder, colortype::Gray8};
    use ::tiff::tags::ResolutionUnit;
    let mut bytes = Cursor::new(vec![]);
    let mut encoder = TiffEncoder::new(&mut bytes).unwrap();
    for n in 1..=pages {
        let mut image = encoder.new_image::<Gray8>(n, 1).unwrap();
        image.resolution(ResolutionUnit::Centimeter, Rational { n: 100 * n, d: 1 });
        image.write_data(&vec![n as u8; n as usize]).unwrap();
    }
    bytes.into_inner()
}

#[test]
fn tiff_has_pages() {
    let bytes = tiff_of(3);
    for n in 1..=3 {
        let page = page(&bytes, ImageFormat::Tiff, n).unwrap();
        assert_eq!(page.picture.dimensions(), (n, 1));
        assert_eq!(page.picture.get_pixel(0, 0), &Rgb([n as u8; 3]));
        assert_eq!(page.dpi, Some(254.0 * f64::from(n)));
    }
    let message = page(&bytes, ImageFormat::Tiff, 4).unwrap_err().to_string();
    assert_eq!(message, "there is no page 4: the document has 3 pages; give page=1 to page=3");
}

fn entry(tag: u16, kind: u16, count: u32, value: u32) -> Vec<u8> {
    let mut bytes = tag.to_le_bytes().to_vec();
    bytes.extend(kind.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend(value.to_le_bytes());
    bytes
}

/// A TIFF of one uncompressed strip, whose data fit into four bytes.
fn bare_tiff(width: u32, height: u32, bits: u32, photometric: u32, samples: u32, data: [u8; 4]) -> Vec<u8> {
    let entries = [
        entry(256, 3, 1, width),
        entry(257, 3, 1, height),
        entry(258, 3, 1, bits),
        entry(259, 3, 1, 1),
        entry(262, 3, 1, photometric),
        entry(273, 4, 1, 8),
        entry(277, 3, 1, samples),
        entry(278, 3, 1, height),
        entry(279, 4, 1, 4),
    ];
    let mut bytes = b"II\x2a\0\x0c\0\0\0".to_vec();
    bytes.extend(data);
    bytes.extend((entries.len() as u16).to_le_bytes());
    bytes.extend(entries.concat());
    bytes.extend([0; 4]);
    bytes
}

#[test]
fn tiff_of_few_bits_and_inverted_is_read() {
    let bits = [0b1010_0000, 0b0100_0000, 0, 0];
    let black_is_zero = pixels(&bare_tiff(3, 2, 1, 1, 1, bits), ImageFormat::Tiff);
    let grey: Vec<_> = black_is_zero.chunks(3).map(|p| p[0]).collect();
    assert_eq!(grey, [255, 0, 255, 0, 255, 0]);
    let white_is_zero = pixels(&bare_tiff(3, 2, 1, 0, 1, bits), ImageFormat::Tiff);
    assert!(black_is_zero.iter().zip(&white_is_zero).all(|(a, b)| *a == 255 - *b));
    let four = pixels(&bare_tiff(2, 1, 4, 1, 1, [0x3f, 0, 0, 0]), ImageFormat::Tiff);
    assert_eq!(four, [51, 51, 51, 255, 255, 255]);
    let cmyk = pixels(&bare_tiff(1, 1, 8, 5, 4, [255, 0, 0, 51]), ImageFormat::Tiff);
    assert_eq!(cmyk, [0, 204, 204]);
}

fn jpeg_of(picture: &GrayImage) -> Vec<u8> {
    let mut bytes = vec![];
    let (w, h) = picture.dimensions();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, 95);
    encoder.write_image(picture, w, h, ColorType::L8.into()).unwrap();
    bytes
}

#[test]
fn photos_are_turned_upright() {
    let half_dark = GrayImage::from_fn(32, 16, |x, _| image::Luma([if x < 16 { 0 } else { 255 }]));
    let plain = jpeg_of(&half_dark);
    // Exif data with the one entry: orientation 6, to be turned clockwise.
    let exif = b"Exif\0\0II\x2a\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
    let mut turned = vec![0xff, 0xd8, 0xff, 0xe1];
    turned.extend((exif.len() as u16 + 2).to_be_bytes());
    turned.write_all(exif).unwrap();
    turned.extend(&plain[2..]);
    assert_eq!(page(&plain, ImageFormat::Jpeg, 1).unwrap().picture.dimensions(), (32, 16));
    let upright = page(&turned, ImageFormat::Jpeg, 1).unwrap().picture;
    assert_eq!(upright.dimensions(), (16, 32));
    assert!(upright.get_pixel(8, 2)[0] < 10 && upright.get_pixel(8, 30)[0] > 245);
}

/// The bytes of a JPEG with its size overwritten: high and low byte of the height and of the width follow the length and
/// the precision of the frame's header.
fn resized(mut jpeg: Vec<u8>, width: u16, height: u16) -> Vec<u8> {
    let frame = jpeg.windows(2).position(|w| w == [0xff, 0xc0]).unwrap();
    jpeg[frame + 5..frame + 7].copy_from_slice(&height.to_be_bytes());
    jpeg[frame + 7..frame + 9].copy_from_slice(&width.to_be_bytes());
    jpeg
}

#[test]
fn a_giant_is_refused_by_its_header() {
    let giant = resized(jpeg_of(&GrayImage::new(8, 8)), 30_000, 30_000);
    let error = page(&giant, ImageFormat::Jpeg, 1).unwrap_err();
    assert_eq!(error.kind, ErrorKind::Limit);
    assert!(
        error.to_string().starts_with("the picture has 30000 x 30000 pixels; at most 100 million"),
        "{error}"
    );
    let pgm = page(b"P5 20000 20000 255\n", ImageFormat::Pnm, 1).unwrap_err();
    assert_eq!(pgm.kind, ErrorKind::Limit);
}

#[test]
fn other_formats_have_one_page() {
    let message = page(b"P5 1 1 255\n\0", ImageFormat::Pnm, 2).unwrap_err().to_string();
    assert_eq!(message, "there is no page 2: the document has one page; give page=1, or leave it away");
    assert_eq!(pixels(b"P5 1 1 65535\n\x80\0", ImageFormat::Pnm), [128; 3]);
}

fn samples() -> Vec<(ImageFormat, Vec<u8>)> {
    let grey = GrayImage::from_fn(19, 11, |x, y| image::Luma([(x * y) as u8]));
    let mut bmp = Cursor::new(vec![]);
    grey.write_to(&mut bmp, ImageFormat::Bmp).unwrap();
    let png = png_of(5, 4, ::png::ColorType::Rgba, ::png::BitDepth::Eight, &[77; 80]);
    vec![
        (ImageFormat::Png, png),
        (ImageFormat::Jpeg, jpeg_of(&grey)),
        (ImageFormat::Tiff, tiff_of(2)),
        (ImageFormat::Tiff, bare_tiff(3, 2, 1, 1, 1, [0b1010_0000, 0, 0, 0])),
        (ImageFormat::Bmp, bmp.into_inner()),
        (ImageFormat::Pnm, b"P2 3 2 15\n1 2 3\n4 5 6\n".to_vec()),
    ]
}

#[test]
fn cut_short_is_an_error_or_a_picture_but_no_panic() {
    for (format, bytes) in samples() {
        assert!(page(&bytes, format, 1).is_ok());
        for length in 0..bytes.len() {
            let _ = page(&bytes[..length], format, 1);
        }
        assert_eq!(page(&bytes[..8.min(bytes.len())], format, 1).unwrap_err().kind, ErrorKind::BadInput);
    }
}

proptest::proptest! {
    #[test]
    fn damage_never_panics(which in 0..6_usize, at in proptest::collection::vec((0..5000_usize, 0..=255_u8), 1..6)) {
        let (format, mut bytes) = samples().swap_remove(which);
        let length = bytes.len();
        at.into_iter().for_each(|(i, b)| bytes[i % length] = b);
        let _ = page(&bytes, format, 1);
    }
}
