//! Words drawn as strokes, found and read with Tesseract. Where it is missing these tests fail.

use super::*;
use crate::stages::Unwatched;
use image::{GrayImage, Luma, RgbImage};
use std::path::PathBuf;

/// A sheet on which one can draw.
struct Drawing(GrayImage);

/// The strokes of a letter in a box of 4 x 6, the origin at its upper left corner.
fn strokes(letter: char) -> &'static [&'static [(f64, f64)]] {
    match letter {
        'K' => &[&[(0., 0.), (0., 6.)], &[(4., 0.), (0., 3.6), (1.2, 2.6), (4., 6.)]],
        'I' => &[&[(2., 0.), (2., 6.)], &[(0.8, 0.), (3.2, 0.)], &[(0.8, 6.), (3.2, 6.)]],
        'T' => &[&[(0., 0.), (4., 0.)], &[(2., 0.), (2., 6.)]],
        'C' => &[&[(4., 1.), (3., 0.), (1., 0.), (0., 1.), (0., 5.), (1., 6.), (3., 6.), (4., 5.)]],
        'H' => &[&[(0., 0.), (0., 6.)], &[(4., 0.), (4., 6.)], &[(0., 3.), (4., 3.)]],
        'E' => &[&[(4., 0.), (0., 0.), (0., 6.), (4., 6.)], &[(0., 3.), (3.4, 3.)]],
        'N' => &[&[(0., 6.), (0., 0.), (4., 6.), (4., 0.)]],
        'L' => &[&[(0., 0.), (0., 6.), (4., 6.)]],
        'A' => &[&[(0., 6.), (2., 0.), (4., 6.)], &[(0.7, 4.), (3.3, 4.)]],
        'M' => &[&[(0., 6.), (0., 0.), (2., 4.), (4., 0.), (4., 6.)]],
        'F' => &[&[(4., 0.), (0., 0.), (0., 6.)], &[(0., 3.), (3.4, 3.)]],
        'W' => &[&[(0., 0.), (1., 6.), (2., 2.), (3., 6.), (4., 0.)]],
        'Y' => &[&[(0., 0.), (2., 3.), (4., 0.)], &[(2., 3.), (2., 6.)]],
        _ => &[],
    }
}

impl Drawing {
    fn new() -> Self {
        Self(GrayImage::from_pixel(700, 500, Luma([255])))
    }

    /// A stroke with round ends.
    fn stroke(&mut self, from: [f64; 2], to: [f64; 2], width: f64) -> &mut Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length2 = (dx * dx + dy * dy).max(1e-9);
        for (x, y, pixel) in self.0.enumerate_pixels_mut() {
            let (px, py) = (f64::from(x) + 0.5 - from[0], f64::from(y) + 0.5 - from[1]);
            let t = ((px * dx + py * dy) / length2).clamp(0.0, 1.0);
            let distance = (px - t * dx).hypot(py - t * dy) - width / 2.0;
            let value = ((distance + 0.5).clamp(0.0, 1.0) * 255.0) as u8;
            pixel.0[0] = pixel.0[0].min(value);
        }
        self
    }

    /// A word that begins at this corner of its first letter and reads in this direction.
    fn word(&mut self, word: &str, [x, y]: [f64; 2], angle: f64, height: f64) -> &mut Self {
        let (sin, cos) = angle.sin_cos();
        let scale = height / 6.0;
        for (i, letter) in word.chars().enumerate() {
            let place = |&(a, b): &(f64, f64)| {
                let (a, b) = ((a + 5.8 * i as f64) * scale, b * scale);
                [x + cos * a - sin * b, y + sin * a + cos * b]
            };
            for line in strokes(letter) {
                let points: Vec<_> = line.iter().map(place).collect();
                points.windows(2).for_each(|p| {
                    self.stroke(p[0], p[1], height / 8.0);
                });
            }
        }
        self
    }

    fn sheet(&self) -> Sheet {
        let (width, height) = self.0.dimensions();
        let ink = Mask { width, height, set: self.0.pixels().map(|p| p.0[0] < 128).collect() };
        let colour = RgbImage::from_fn(width, height, |x, y| image::Rgb([self.0.get_pixel(x, y).0[0]; 3]));
        Sheet {
            colour,
            grey: self.0.clone(),
            aside: Mask::empty(width, height),
            ink,
            turned: 0.0,
            page_size: [width, height],
        }
    }
}

fn walls() -> Drawing {
    let mut drawing = Drawing::new();
    for side in [
        [[40., 40.], [660., 40.]],
        [[660., 40.], [660., 460.]],
        [[660., 460.], [40., 460.]],
        [[40., 460.], [40., 40.]],
    ] {
        drawing.stroke(side[0], side[1], 12.0);
    }
    drawing.stroke([350., 40.], [350., 460.], 8.0);
    drawing
}

fn options(ocr: OcrMode, lang: &str) -> WordOptions {
    WordOptions { ocr, lang: lang.into(), tessdata: None }
}

fn read(drawing: &Drawing) -> Words {
    find(&drawing.sheet(), &[], &options(OcrMode::On, "eng"), &mut Unwatched).unwrap()
}

fn contents(words: &Words) -> Vec<&str> {
    words.texts.iter().map(|t| t.content.as_str()).collect()
}

/// How many pixels of the walls alone are erased.
fn lost(words: &Words) -> usize {
    let walls = walls().sheet().ink;
    walls.set.iter().zip(&words.erase.set).filter(|(w, e)| **w && **e).count()
}

#[test]
fn words_are_read_at_all_four_angles() {
    use std::f64::consts::{FRAC_PI_2, PI};
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0).word("HALL", [420., 300.], -FRAC_PI_2, 18.0);
    drawing.word("FAMILY", [560., 120.], FRAC_PI_2, 18.0).word("LINEN", [300., 400.], PI, 18.0);
    let words = read(&drawing);
    let mut found: Vec<_> =
        words.texts.iter().map(|t| (t.content.as_str(), t.angle.to_degrees().round())).collect();
    found.sort_by(|a, b| a.0.cmp(b.0));
    assert_eq!(found, [("FAMILY", 90.0), ("HALL", -90.0), ("KITCHEN", 0.0), ("LINEN", 180.0)]);
    assert!(
        words.texts.iter().all(|t| t.confidence > 0.5 && t.width > t.height && (t.height - 20.0).abs() < 4.0)
    );
    assert_eq!(drawing.sheet().ink.without(&words.erase), walls().sheet().ink);
}

#[test]
fn a_word_that_touches_a_wall_goes_and_the_wall_stays() {
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0).word("FAMILY", [100., 200.], 0.0, 18.0);
    // The first letter's stroke lies on the wall's edge.
    drawing.word("LINEN", [356., 250.], 0.0, 18.0);
    let words = read(&drawing);
    let left = drawing.sheet().ink.without(&words.erase).without(&walls().sheet().ink).count();
    assert!(left < 60, "{left} pixels of words are left; read: {:?}", contents(&words));
    assert!(lost(&words) < 10, "{} pixels of walls are lost", lost(&words));
}

#[test]
fn furniture_is_no_word() {
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0);
    for i in 0..6 {
        let x = 80.0 + 40.0 * f64::from(i);
        // Chairs, and the treads of stairs.
        for [a, b] in
            [[[0., 0.], [18., 0.]], [[18., 0.], [18., 18.]], [[18., 18.], [0., 18.]], [[0., 18.], [0., 0.]]]
        {
            drawing.stroke([x + a[0], 200. + a[1]], [x + b[0], 200. + b[1]], 2.0);
        }
        drawing.stroke([400. + 9.0 * f64::from(i), 300.], [400. + 9.0 * f64::from(i), 320.], 2.0);
    }
    let words = read(&drawing);
    assert_eq!(contents(&words), ["KITCHEN"]);
    assert_eq!(lost(&words), 0);
}

#[test]
fn hatching_between_two_lines_is_no_word() {
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0);
    let plain = drawing.sheet().ink;
    drawing.stroke([80., 300.], [300., 300.], 2.0).stroke([80., 318.], [300., 318.], 2.0);
    for i in 0..22 {
        let x = 80.0 + 9.0 * f64::from(i);
        drawing.stroke([x, 318.], [x + 18.0, 300.], 1.5);
    }
    let words = read(&drawing);
    assert_eq!(contents(&words), ["KITCHEN"]);
    assert_eq!(
        drawing.sheet().ink.without(&plain).without(&words.erase).count(),
        drawing.sheet().ink.without(&plain).count()
    );
}

#[test]
fn without_reading_words_go_by_their_shape() {
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0);
    let words = find(&drawing.sheet(), &[], &options(OcrMode::Off, "eng"), &mut Unwatched).unwrap();
    assert!(words.texts.is_empty() && words.warnings.is_empty());
    assert_eq!(drawing.sheet().ink.without(&words.erase), walls().sheet().ink);
}

#[test]
fn known_texts_are_erased_unread() {
    let mut drawing = walls();
    drawing.word("KITCHEN", [80., 90.], 0.0, 18.0);
    let known = SheetText {
        content: "Küche".into(),
        centre: [138.0, 99.0],
        angle: 0.0,
        width: 120.0,
        height: 20.0,
        confidence: 1.0,
    };
    let words = find_with(&drawing.sheet(), std::slice::from_ref(&known), None).unwrap();
    assert_eq!(words.texts, [known]);
    assert_eq!(drawing.sheet().ink.without(&words.erase), walls().sheet().ink);
}

#[test]
fn a_language_without_data_is_named_with_what_installs_it() {
    let sheet = walls().sheet();
    let error = find(&sheet, &[], &options(OcrMode::On, "eng+xyz"), &mut Unwatched).unwrap_err().to_string();
    assert!(error.contains("language `xyz`") && error.contains("install"), "{error}");
    let words = find(&sheet, &[], &options(OcrMode::Auto, "eng+xyz"), &mut Unwatched).unwrap();
    assert_eq!(words.warnings.len(), 1);
}

#[test]
fn a_folder_without_data_is_refused() {
    let request = WordOptions { tessdata: Some(PathBuf::from("no-such-folder")), ..WordOptions::default() };
    let error = find(&walls().sheet(), &[], &request, &mut Unwatched).unwrap_err();
    assert_eq!(error.kind, planform_sdk::ErrorKind::BadOption);
    assert!(error.to_string().contains("no-such-folder"), "{error}");
}

#[test]
fn an_empty_sheet_has_no_words() {
    let words = find_with(&Drawing(GrayImage::new(0, 0)).sheet(), &[], None).unwrap();
    assert!(words.texts.is_empty() && words.erase.set.is_empty());
}
