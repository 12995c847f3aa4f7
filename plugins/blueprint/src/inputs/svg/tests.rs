use super::*;
use flate2::{Compression, write::GzEncoder};
use image::ImageFormat;
use std::f64::consts::FRAC_PI_2;
use std::io::{Cursor, Write};

fn svg(attributes: &str, content: &str) -> Vec<u8> {
    let names = "xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink'";
    format!("<svg {names} {attributes}>{content}</svg>").into_bytes()
}

fn draw(attributes: &str, content: &str) -> Page {
    page(&svg(attributes, content), &PageRequest::default()).unwrap()
}

fn complaint(bytes: &[u8]) -> String {
    page(bytes, &PageRequest::default()).unwrap_err().to_string()
}

const BOX: &str = "<rect x='10' y='10' width='20' height='30'/>";

#[test]
fn drawings_are_three_thousand_pixels_long_on_white() {
    let page = draw("viewBox='0 0 100 50'", BOX);
    assert_eq!((page.picture.dimensions(), page.dpi), ((3000, 1500), None));
    for (x, y, value) in [(303, 303, 0), (897, 1197, 0), (295, 400, 255), (905, 400, 255), (500, 1205, 255)] {
        assert_eq!(page.picture.get_pixel(x, y).0, [value; 3], "{x} {y}");
    }
}

#[test]
fn drawings_with_a_size_on_paper_have_a_density() {
    let page = draw("width='254mm' height='127mm' viewBox='0 0 100 50'", BOX);
    assert_eq!(page.picture.dimensions(), (2000, 1000));
    assert!((page.dpi.unwrap() - 200.0).abs() < 1e-3, "{:?}", page.dpi);
    let large = draw("width='20m' height='2000cm' viewBox='0 0 100 100'", BOX);
    assert_eq!(large.dpi, None);
    let large = draw("width='2000cm' height='2000cm' viewBox='0 0 100 100'", BOX);
    assert!(large.warnings[0].contains("since at most 100 million are read"), "{:?}", large.warnings);
    assert!(u64::from(large.picture.width()).pow(2) <= MAX_PIXELS);
}

#[test]
fn words_are_taken_from_the_document() {
    let content = "<g transform='translate(10 20)' style='font-size:10px'><text>Room <tspan>12</tspan></text>\
                   <text transform='rotate(90)' text-anchor='middle'>Hall</text></g>\
                   <text x='50' y='40'><tspan x='50'>one</tspan><tspan x='50' y='45'>two</tspan></text>\
                   <defs><text>never</text></defs>";
    let page = draw("viewBox='0 0 100 50'", content);
    let contents: Vec<_> = page.texts.iter().map(|t| t.content.as_str()).collect();
    assert_eq!(contents, ["Room 12", "Hall", "one", "two"]);
    let [room, hall] = [&page.texts[0], &page.texts[1]];
    assert!((room.centre[0] - room.width / 2.0 - 300.0).abs() < 1e-3 && room.angle == 0.0, "{room:?}");
    assert!(
        (room.centre[1] - 600.0 + room.height / 2.0).abs() < 1e-3 && (room.height - 216.0).abs() < 1e-3,
        "{room:?}"
    );
    assert!((hall.centre[1] - 600.0).abs() < 1e-3 && (hall.angle - FRAC_PI_2).abs() < 1e-9, "{hall:?}");
    assert!(hall.centre[0] > 300.0);
}

#[test]
fn compressed_drawings_are_unpacked() {
    let mut packed = GzEncoder::new(vec![], Compression::default());
    packed.write_all(&svg("viewBox='0 0 100 50'", BOX)).unwrap();
    let packed = packed.finish().unwrap();
    assert_eq!(page(&packed, &PageRequest::default()).unwrap().picture.dimensions(), (3000, 1500));
    let message = complaint(&packed[..packed.len() / 2]);
    assert!(message.starts_with("the compressed SVG cannot be unpacked"), "{message}");
}

#[test]
fn a_gzip_bomb_is_refused() {
    let mut packed = GzEncoder::new(vec![], Compression::best());
    for _ in 0..257 {
        packed.write_all(&vec![b' '; 1 << 20]).unwrap();
    }
    let message = complaint(&packed.finish().unwrap());
    assert_eq!(message, "the SVG is larger than 256 MiB; simplify it, or save it as a picture");
}

#[test]
fn nothing_outside_is_loaded() {
    let page = draw("viewBox='0 0 10 10'", "<image href='/etc/hostname' width='9' height='9'/>");
    assert!(page.warnings[0].starts_with("a picture of the SVG is not drawn") && !page.drawn);
    let entity =
        b"<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/hostname'>]><svg viewBox='0 0 1 1'>&x;</svg>";
    let _ = super::page(entity, &PageRequest::default());
}

/// An `image` element that holds a black picture of this size, of the format that it has.
fn picture(width: u32, height: u32, format: ImageFormat) -> String {
    let mut bytes = vec![];
    RgbImage::new(width, height).write_to(&mut Cursor::new(&mut bytes), format).unwrap();
    let hex: String = bytes.iter().map(|b| format!("%{b:02x}")).collect();
    format!("<image x='2' y='2' width='4' height='4' href='data:image/png,{hex}'/>")
}

#[test]
fn pictures_in_the_file_are_drawn() {
    for format in [ImageFormat::Png, ImageFormat::Jpeg] {
        let page = draw("viewBox='0 0 10 10'", &picture(8, 8, format));
        let at = |x, y| page.picture.get_pixel(x, y).0[0];
        assert!(at(1200, 1200) < 30 && at(300, 300) > 240 && at(2400, 1200) > 240, "{format:?}");
        assert!(page.drawn && page.warnings.is_empty(), "{:?}", page.warnings);
    }
    let other = draw("viewBox='0 0 10 10'", &picture(8, 8, ImageFormat::Bmp));
    assert!(!other.drawn && other.warnings.len() == 1);
}

#[test]
fn pictures_take_no_more_room_than_a_page() {
    // 25 million pixels, used five times.
    let content = format!("<g id='g'>{}</g>", picture(5000, 5000, ImageFormat::Png));
    let pictures = Pictures::default();
    let text =
        String::from_utf8(svg("viewBox='0 0 10 10'", &(content + &"<use xlink:href='#g'/>".repeat(4))));
    Tree::from_str(&text.unwrap(), &sealed(&pictures)).unwrap();
    assert!(pictures.are_drawn() && pictures.are_refused());
}

/// Ten groups, each of which uses the one before ten times.
fn nested_uses() -> String {
    let mut content = "<g id='g0'><rect width='1' height='1'/></g>".to_owned();
    for i in 1..=10 {
        let use_one = format!("<use xlink:href='#g{}'/>", i - 1);
        content += &format!("<g id='g{i}'>{}</g>", use_one.repeat(10));
    }
    content
}

#[test]
fn bombs_are_refused() {
    let deep = format!("{}{}", "<g>".repeat(1000), "</g>".repeat(1000));
    let layers = format!("{}{BOX}{}", "<g opacity='0.5'>".repeat(100), "</g>".repeat(100));
    let corners = "1 1 ".repeat(200_000);
    let markers = format!(
        "<marker id='m'>{}</marker><polyline marker-mid='url(#m)' points='{corners}'/>",
        "<rect width='1' height='1'/>".repeat(50)
    );
    for content in [nested_uses(), deep, layers, markers, "<g id='a'><use href='#a'/></g>".to_owned()] {
        let message = complaint(&svg("viewBox='0 0 100 100'", &content));
        assert!(message.starts_with("the SVG is too complex to be drawn: it has "), "{message}");
    }
    let lol: String =
        (1..9).map(|i| format!("<!ENTITY l{i} '{}'>", format!("&l{};", i - 1).repeat(10))).collect();
    let laughs =
        format!("<!DOCTYPE svg [<!ENTITY l0 'lol'>{lol}]><svg viewBox='0 0 1 1'><text>&l8;</text></svg>");
    let message = complaint(laughs.as_bytes());
    assert!(message.starts_with("the SVG is too complex to be drawn: it has entities"), "{message}");
}

#[test]
fn broken_documents_have_their_sentences() {
    assert!(complaint(b"<svg>\n<g>").contains("the SVG is no sound XML"));
    assert!(complaint(&svg("width='0' height='0'", BOX)).starts_with("the SVG has no size"));
    assert!(complaint(b"<svg>\xff\xfe</svg>").starts_with("the SVG is not text in UTF-8"));
    let second = PageRequest { page: 2, ..PageRequest::default() };
    assert!(page(&svg("", BOX), &second).unwrap_err().to_string().starts_with("there is no page 2"));
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(48))]
    #[test]
    fn damage_never_panics(at in proptest::collection::vec((0..2000_usize, 0..=255_u8), 1..6)) {
        let mut bytes = svg("width='30px' viewBox='0 0 1 2'", "<g transform='scale(2)'><text x='1 2'>a</text></g>");
        let length = bytes.len();
        at.into_iter().for_each(|(i, b)| bytes[i % length] = b);
        if let Err(e) = page(&bytes, &PageRequest::default()) {
            proptest::prop_assert!(!e.message.contains("its reader cannot handle"), "{}", e);
        }
    }
}
