//! Without Tesseract, drawings are read all the same. The library is looked up once in a process, so that hiding it takes
//! a process of its own: the test runs itself again with another environment.
//! A program that was linked with Tesseract has it always.
#![cfg(not(feature = "linked-tesseract"))]

use image::{GrayImage, RgbImage};
use planform_blueprint::mask::Mask;
use planform_blueprint::sheet::Sheet;
use planform_blueprint::stages::Unwatched;
use planform_blueprint::words::{OcrMode, WordOptions, find};
use std::process::Command;

/// Set in the process in which Tesseract is hidden.
const INNER: &str = "PLANFORM_TEST_WITHOUT_TESSERACT";

fn sheet() -> Sheet {
    let empty = Mask::empty(60, 40);
    let (colour, grey) = (RgbImage::new(60, 40), GrayImage::new(60, 40));
    Sheet { colour, grey, ink: empty.clone(), aside: empty, turned: 0.0, page_size: [60, 40] }
}

#[test]
fn a_hidden_library_gives_one_sentence() {
    if std::env::var_os(INNER).is_none() {
        let mut again = Command::new(std::env::current_exe().unwrap());
        again.env("PLANFORM_TESSERACT", "no-such-library").env(INNER, "1");
        let output = again.args(["--exact", "a_hidden_library_gives_one_sentence"]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
        return;
    }
    let request = |ocr| WordOptions { ocr, ..WordOptions::default() };
    let words = find(&sheet(), &[], &request(OcrMode::Auto), &mut Unwatched).unwrap();
    assert_eq!(words.warnings.len(), 1);
    assert!(words.warnings[0].contains("install"), "{}", words.warnings[0]);
    let error = find(&sheet(), &[], &request(OcrMode::On), &mut Unwatched).unwrap_err().to_string();
    assert!(error.contains("not installed"), "{error}");
    assert!(find(&sheet(), &[], &request(OcrMode::Off), &mut Unwatched).unwrap().warnings.is_empty());
}
