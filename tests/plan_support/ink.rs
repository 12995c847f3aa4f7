//! What the removal of words did to the ink.

use image::GrayImage;
use planform_blueprint::mask::Mask;
use planform_blueprint::pipeline::Reading;
use planform_synth::PlanTruth;

/// Pixels around letters that count to neither letters nor walls: the ink of both runs together there.
const BETWEEN: i64 = 1;

/// Of the letters' pixels the share that is no ink of the drawing any more, and of the walls' pixels the share that
/// went with them.
pub fn removed_and_lost(reading: &Reading, truth: &PlanTruth) -> (f64, f64) {
    let (ink, erased) = (&reading.sheet.ink, &reading.words.erase);
    let stays = |x, y| at(reading, ink, x, y) && !at(reading, erased, x, y);
    let goes = |x, y| at(reading, ink, x, y) && at(reading, erased, x, y);
    let [mut letters, mut left, mut walls, mut lost] = [0u64; 4];
    for (x, y, letter) in truth.letters.enumerate_pixels() {
        let wall = truth.walls.get_pixel(x, y).0[0] > 0;
        if letter.0[0] > 0 && !wall {
            letters += 1;
            left += u64::from(stays(x, y));
        } else if wall && !near(&truth.letters, x, y) {
            walls += 1;
            lost += u64::from(goes(x, y));
        }
    }
    (1.0 - left as f64 / letters.max(1) as f64, lost as f64 / walls.max(1) as f64)
}

/// The mask of the sheet at a pixel of the page.
fn at(reading: &Reading, mask: &Mask, x: u32, y: u32) -> bool {
    let [x, y] = reading.sheet.from_page([f64::from(x) + 0.5, f64::from(y) + 0.5]);
    mask.get(x.floor() as i64, y.floor() as i64)
}

fn near(letters: &GrayImage, x: u32, y: u32) -> bool {
    let (w, h) = (i64::from(letters.width()), i64::from(letters.height()));
    let around = |v: u32, size: i64| (i64::from(v) - BETWEEN).max(0)..=(i64::from(v) + BETWEEN).min(size - 1);
    around(y, h).any(|y| around(x, w).any(|x| letters.get_pixel(x as u32, y as u32).0[0] > 0))
}
