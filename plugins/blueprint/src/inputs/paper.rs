//! Puts pixels with transparency on white paper.

use image::{DynamicImage, RgbImage};

/// A picture of 8 bit samples in rows from the top, of grey, grey and alpha, RGB, or RGB and alpha by the number of
/// channels. `None` if the samples are too few for its size.
pub fn on_paper(width: u32, height: u32, channels: usize, samples: Vec<u8>) -> Option<RgbImage> {
    let needed = width as usize * height as usize;
    if channels == 3 {
        return RgbImage::from_raw(width, height, samples);
    }
    if channels == 0 || samples.len() / channels < needed {
        return None;
    }
    let mut rgb = Vec::with_capacity(needed * 3);
    for pixel in samples.chunks_exact(channels).take(needed) {
        rgb.extend_from_slice(&blend(pixel));
    }
    RgbImage::from_raw(width, height, rgb)
}

/// The decoded picture on paper, with as few copies as its format allows.
pub fn dynamic_on_paper(picture: DynamicImage) -> Option<RgbImage> {
    let (width, height) = (picture.width(), picture.height());
    match picture {
        DynamicImage::ImageRgb8(rgb) => Some(rgb),
        DynamicImage::ImageLuma8(grey) => on_paper(width, height, 1, grey.into_raw()),
        DynamicImage::ImageLumaA8(grey) => on_paper(width, height, 2, grey.into_raw()),
        DynamicImage::ImageRgba8(rgba) => on_paper(width, height, 4, rgba.into_raw()),
        other if other.color().has_alpha() => on_paper(width, height, 4, other.into_rgba8().into_raw()),
        other => Some(other.into_rgb8()),
    }
}

fn blend(pixel: &[u8]) -> [u8; 3] {
    match *pixel {
        [grey] => [grey; 3],
        [grey, alpha] => [over_white(grey, alpha); 3],
        [r, g, b, alpha, ..] => [r, g, b].map(|c| over_white(c, alpha)),
        _ => [255; 3],
    }
}

fn over_white(colour: u8, alpha: u8) -> u8 {
    let (colour, alpha) = (u32::from(colour), u32::from(alpha));
    ((colour * alpha + 255 * (255 - alpha) + 127) / 255) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transparent_is_white_and_half_is_half() {
        let rgba = vec![9, 9, 9, 0, 0, 100, 200, 128, 1, 2, 3, 255];
        let picture = on_paper(3, 1, 4, rgba).unwrap();
        assert_eq!(picture.into_raw(), [255, 255, 255, 127, 177, 227, 1, 2, 3]);
        assert_eq!(on_paper(2, 1, 2, vec![0, 0, 0, 255]).unwrap().into_raw(), [255, 255, 255, 0, 0, 0]);
        assert_eq!(on_paper(1, 1, 1, vec![7]).unwrap().into_raw(), [7, 7, 7]);
    }

    #[test]
    fn too_few_samples_make_no_picture() {
        assert!(on_paper(2, 1, 3, vec![0; 5]).is_none());
        assert!(on_paper(2, 1, 4, vec![0; 7]).is_none());
    }

    #[test]
    fn sixteen_bits_keep_their_tone() {
        let deep = image::ImageBuffer::from_raw(1, 1, vec![0x8080_u16, 0xffff]).unwrap();
        let picture = dynamic_on_paper(DynamicImage::ImageLumaA16(deep)).unwrap();
        assert_eq!(picture.into_raw(), [128; 3]);
    }
}
