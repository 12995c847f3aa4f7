//! What a colour is: how light, and how much of a colour.

/// A colour is called so from here on; 0 is grey, 1 a pure colour. The measure is the colour's strength
/// relative to its darkness, which stays the same when an edge mixes the colour with white paper.
const PURE: f32 = 0.3;
/// Weaker casts come from noise and from JPEG's coarse colours.
const CAST: u8 = 30;
/// How many hues are told apart.
pub const HUES: usize = 12;

/// How light a colour looks: 0 black, 255 white (ITU-R BT.601).
pub fn luma([r, g, b]: [u8; 3]) -> u8 {
    ((u32::from(r) * 77 + u32::from(g) * 150 + u32::from(b) * 29 + 128) >> 8) as u8
}

/// Which of the hues a colour has, 0 around red, then counted over yellow, green and blue; none if it is a
/// grey.
pub fn hue([r, g, b]: [u8; 3]) -> Option<usize> {
    let (high, low) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = high - low;
    if chroma < CAST || f32::from(chroma) < PURE * f32::from(255 - low) {
        return None;
    }
    let part = |p: u8, q: u8| (f32::from(p) - f32::from(q)) / f32::from(chroma);
    let sixth = match high {
        _ if high == r => part(g, b).rem_euclid(6.0),
        _ if high == g => part(b, r) + 2.0,
        _ => part(r, g) + 4.0,
    };
    Some((sixth * HUES as f32 / 6.0).round() as usize % HUES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greys_have_no_hue() {
        for grey in [[0, 0, 0], [128, 128, 128], [255, 255, 255], [58, 63, 69], [90, 80, 82]] {
            assert_eq!(hue(grey), None, "{grey:?}");
        }
    }

    #[test]
    fn hues_are_told_apart_and_survive_mixing_with_white() {
        for (colour, expected) in
            [([200, 10, 10], 0), ([240, 240, 60], 2), ([0, 130, 0], 4), ([20, 20, 200], 8)]
        {
            assert_eq!(hue(colour), Some(expected), "{colour:?}");
            let pale = colour.map(|c: u8| (u16::from(c) / 2 + 127) as u8);
            assert_eq!(hue(pale), Some(expected), "{pale:?}");
        }
    }

    #[test]
    fn lightness_is_that_of_the_eye() {
        assert_eq!([luma([0; 3]), luma([255; 3])], [0, 255]);
        assert!(luma([0, 255, 0]) > luma([255, 0, 0]) && luma([255, 0, 0]) > luma([0, 0, 255]));
    }
}
