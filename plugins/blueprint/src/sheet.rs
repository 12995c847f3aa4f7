//! A page made ready for reading: upright, evenly lit, paper told from ink.

use crate::mask::Mask;
use image::{GrayImage, RgbImage};

/// A sheet. All pictures and masks are of the same size; coordinates are those of [`found`](crate::found).
#[derive(Debug, Clone)]
pub struct Sheet {
    /// The page as seen, deskewed.
    pub colour: RgbImage,
    /// How dark every pixel is, the paper evenly 255, dark on light whatever the document was; coloured fills
    /// and routes are paper here, lines and letters on them are not.
    pub grey: GrayImage,
    /// The ink of the drawing itself: without frame, title block, legend, north arrow, coloured fills and
    /// routes.
    pub ink: Mask,
    /// The ink of what was set aside (frame, title block, legend, north arrow): nothing to build walls of,
    /// but its words are read.
    pub aside: Mask,
    /// By this angle, radians clockwise as seen, the page was turned about its middle to become the sheet;
    /// both have the same middle, the sheet may be larger.
    pub turned: f64,
    /// Width and height of the page, pixels.
    pub page_size: [u32; 2],
}

impl Sheet {
    /// Where on the page a point of the sheet lies, pixels.
    pub fn to_page(&self, point: [f64; 2]) -> [f64; 2] {
        turn(point, -self.turned, self.middle(), self.middle_of_page())
    }

    /// Where on the sheet a point of the page lies, pixels.
    pub fn from_page(&self, point: [f64; 2]) -> [f64; 2] {
        turn(point, self.turned, self.middle_of_page(), self.middle())
    }

    fn middle(&self) -> [f64; 2] {
        [f64::from(self.ink.width) / 2.0, f64::from(self.ink.height) / 2.0]
    }

    fn middle_of_page(&self) -> [f64; 2] {
        self.page_size.map(|s| f64::from(s) / 2.0)
    }
}

/// Turns a point clockwise, as seen, about a middle that comes to lie at another one.
fn turn([x, y]: [f64; 2], angle: f64, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    let (dx, dy) = (x - from[0], y - from[1]);
    [cos * dx - sin * dy + to[0], sin * dx + cos * dy + to[1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sheet(turned: f64, page_size: [u32; 2], width: u32, height: u32) -> Sheet {
        Sheet {
            colour: RgbImage::new(width, height),
            grey: GrayImage::new(width, height),
            ink: Mask::empty(width, height),
            aside: Mask::empty(width, height),
            turned,
            page_size,
        }
    }

    proptest! {
        #[test]
        fn page_and_sheet_are_mapped_back_and_forth(
            turned in -0.2..0.2f64, w in 1u32..90, h in 1u32..90, more in 0u32..20,
            x in -50.0..150.0f64, y in -50.0..150.0f64,
        ) {
            let sheet = sheet(turned, [w, h], w + more, h + more);
            let [bx, by] = sheet.from_page(sheet.to_page([x, y]));
            prop_assert!((bx - x).abs() < 1e-9 && (by - y).abs() < 1e-9);
            let middle = sheet.to_page([f64::from(w + more) / 2.0, f64::from(h + more) / 2.0]);
            prop_assert!((middle[0] - f64::from(w) / 2.0).abs() < 1e-9);
            prop_assert!((middle[1] - f64::from(h) / 2.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_page_turned_clockwise_has_its_right_side_lower() {
        let [x, y] = sheet(0.1, [80, 60], 100, 80).from_page([80.0, 30.0]);
        assert!(y > 40.0 && x > 50.0);
    }
}
