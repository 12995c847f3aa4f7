//! Label images: which room a pixel belongs to.

use super::MAX_ROOMS;
use super::components::components;
use super::error::limit;
use super::picture::Picture;
use planform_sdk::PluginError;
use serde::Deserialize;
use std::collections::BTreeMap;

/// The room of each pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelImage {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row by row from the top: 0 for no room, else the room's number, from 1.
    pub labels: Vec<u32>,
    /// What to call each room, the first being room 1: its colour, number or place.
    pub names: Vec<String>,
}

/// How an image shows rooms. A room of at most `min_px` pixels is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LabelMode {
    /// `White` for a grey image with more than 5 % white, else `Labels`.
    #[default]
    Auto,
    /// A room is an 8-connected component of pixels with every channel above 250, as in Bormann et al.
    White,
    /// A room is a colour; black and white are background. A colour that nowhere fills 3 x 3 pixels is an antialiased
    /// boundary and no room.
    Labels,
    /// As `Labels`, but white is a room as well.
    Ids,
}

const BLACK: u32 = 0;
const WHITE: u32 = 0xFF_FF_FF;

impl LabelImage {
    /// Reads an image file.
    pub fn decode(bytes: &[u8], mode: LabelMode, min_px: u64) -> Result<Self, PluginError> {
        Self::of_picture(Picture::decode(bytes)?, mode, min_px)
    }

    fn of_picture(picture: Picture, mode: LabelMode, min_px: u64) -> Result<Self, PluginError> {
        match mode {
            LabelMode::Auto => {
                let mode = guess(&picture);
                Self::of_picture(picture, mode, min_px)
            }
            LabelMode::White => of_components(&picture, min_px),
            LabelMode::Labels => of_colours(picture, &[BLACK, WHITE], min_px),
            LabelMode::Ids => of_colours(picture, &[BLACK], min_px),
        }
    }

    /// The rows, from the top.
    pub fn rows(&self) -> impl Iterator<Item = &[u32]> {
        self.labels.chunks(self.width.max(1))
    }

    /// How many pixels each room has, the first being room 1.
    pub fn areas(&self) -> Vec<u64> {
        let mut areas = vec![0; self.names.len()];
        for &label in self.labels.iter().filter(|&&l| l > 0) {
            areas[label as usize - 1] += 1;
        }
        areas
    }
}

fn channels(colour: u32) -> [u32; 3] {
    [colour >> 16, colour >> 8 & 255, colour & 255]
}

fn is_white(colour: u32) -> bool {
    channels(colour).into_iter().all(|v| v > 250)
}

fn is_coloured(colour: u32) -> bool {
    let [r, g, b] = channels(colour);
    r.max(g).max(b) - r.min(g).min(b) > 16
}

fn guess(picture: &Picture) -> LabelMode {
    let share = |wanted: fn(u32) -> bool| {
        picture.colours.iter().filter(|&&c| wanted(c)).count() as f64 / picture.colours.len() as f64
    };
    let grey = !picture.numbers && share(is_coloured) < 0.005;
    if grey && share(is_white) > 0.05 { LabelMode::White } else { LabelMode::Labels }
}

fn of_components(picture: &Picture, min_px: u64) -> Result<LabelImage, PluginError> {
    let mask: Vec<_> = picture.colours.iter().map(|&c| !picture.numbers && is_white(c)).collect();
    let labels = components(&mask, picture.width);
    let mut found: BTreeMap<u32, Found> = BTreeMap::new();
    for (at, &label) in labels.iter().enumerate().filter(|(_, l)| **l > 0) {
        found.entry(label).or_insert(Found { at, ..Found::default() }).pixels += 1;
    }
    found.retain(|_, f| f.pixels > min_px);
    let name = |_, f: &Found| format!("at {},{}", f.at % picture.width, f.at / picture.width);
    number(labels, picture, &found, name)
}

fn of_colours(picture: Picture, background: &[u32], min_px: u64) -> Result<LabelImage, PluginError> {
    let mut found = find_colours(&picture);
    found.retain(|colour, f| !background.contains(colour) && f.pixels > min_px && f.interior);
    let name =
        |colour, _: &Found| if picture.numbers { format!("{colour}") } else { format!("#{colour:06x}") };
    number(picture.colours.clone(), &picture, &found, name)
}

/// What is known of a colour or component.
#[derive(Default)]
struct Found {
    pixels: u64,
    /// Index of the first pixel.
    at: usize,
    /// Whether it fills 3 x 3 pixels somewhere.
    interior: bool,
}

fn find_colours(picture: &Picture) -> BTreeMap<u32, Found> {
    let mut found: BTreeMap<u32, Found> = BTreeMap::new();
    let mut at = 0;
    for row in picture.colours.chunks(picture.width.max(1)) {
        for run in row.chunk_by(|a, b| a == b) {
            let colour = found.entry(run[0]).or_insert(Found { at, ..Found::default() });
            colour.pixels += run.len() as u64;
            colour.interior |= has_interior(picture, at, run.len());
            at += run.len();
        }
    }
    found
}

/// Whether a run of one colour, seen as the middle row, contains 3 x 3 pixels of it.
fn has_interior(picture: &Picture, at: usize, len: usize) -> bool {
    let (colours, width) = (&picture.colours, picture.width);
    if at < width || at + len + width > colours.len() {
        return false;
    }
    let same = |i: usize| colours[i - width] == colours[at] && colours[i + width] == colours[at];
    let mut column = 0;
    (at..at + len).any(|i| {
        column = if same(i) { column + 1 } else { 0 };
        column == 3
    })
}

/// Numbers the found ones from 1 in rising order and makes everything else background.
fn number(
    mut labels: Vec<u32>,
    picture: &Picture,
    found: &BTreeMap<u32, Found>,
    name: impl Fn(u32, &Found) -> String,
) -> Result<LabelImage, PluginError> {
    if found.len() > MAX_ROOMS {
        return Err(limit(format!("shows {} rooms, and {MAX_ROOMS} are the most", found.len()))
            .advise("check the mode of the labels and the smallest room"));
    }
    let numbers: BTreeMap<_, _> = found.keys().zip(1..).map(|(&code, n)| (code, n)).collect();
    for run in labels.chunk_by_mut(|a, b| a == b) {
        let number = numbers.get(&run[0]).copied().unwrap_or(0);
        run.fill(number);
    }
    let names = found.iter().map(|(&code, f)| name(code, f)).collect();
    Ok(LabelImage { width: picture.width, height: picture.height, labels, names })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of single letters; a digit is that colour number.
    fn picture(rows: &[&str]) -> Picture {
        let colour = |c| match c {
            b'W' => WHITE,
            b'w' => 0xFB_FB_FB,
            b'g' => 0xFA_FA_FA,
            b'.' => BLACK,
            digit => u32::from(digit - b'0') << 16,
        };
        Picture {
            width: rows[0].len(),
            height: rows.len(),
            colours: rows.iter().flat_map(|r| r.bytes().map(colour)).collect(),
            numbers: false,
        }
    }

    fn labels(rows: &[&str], mode: LabelMode, min_px: u64) -> Vec<u32> {
        LabelImage::of_picture(picture(rows), mode, min_px).unwrap().labels
    }

    #[test]
    fn white_is_above_250_and_connects_at_corners() {
        let found = labels(&["Wg.W", "gw.W"], LabelMode::White, 0);
        assert_eq!(found, [1, 0, 0, 2, 0, 1, 0, 2]);
    }

    #[test]
    fn rooms_of_just_min_px_are_dropped() {
        assert_eq!(labels(&["WW.WWW"], LabelMode::White, 2), [0, 0, 0, 1, 1, 1]);
        let square = ["111", "111", "111"];
        assert_eq!(labels(&square, LabelMode::Labels, 9), [0; 9]);
        assert_eq!(labels(&square, LabelMode::Labels, 8), [1; 9]);
    }

    #[test]
    fn a_colour_is_one_room_wherever_it_lies() {
        let found = labels(&["222.2", "222..", "222.1"], LabelMode::Labels, 0);
        assert_eq!(found, [1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 0, 0]);
    }

    #[test]
    fn colours_without_an_interior_are_boundaries() {
        assert_eq!(labels(&["111222", "111222"], LabelMode::Labels, 0), [0; 12]);
        assert_eq!(labels(&["1112", "1112", "1112"], LabelMode::Labels, 0)[..4], [1, 1, 1, 0]);
        // A run that is three wide only across the edge of the image fills nothing.
        assert_eq!(labels(&["11.1", "11.1", "11.1"], LabelMode::Labels, 0), [0; 12]);
    }

    #[test]
    fn white_is_a_room_only_among_ids() {
        let rows = ["WWW", "WWW", "WWW"];
        assert_eq!(labels(&rows, LabelMode::Labels, 0), [0; 9]);
        assert_eq!(labels(&rows, LabelMode::Ids, 0), [1; 9]);
    }

    #[test]
    fn auto_tells_white_rooms_from_labels() {
        assert_eq!(guess(&picture(&["W..................."])), LabelMode::Labels);
        assert_eq!(guess(&picture(&["WW.................."])), LabelMode::White);
        // 0x11 of red alone is a spread of 17 and thus a colour.
        let coloured = Picture { colours: vec![0x11_00_00, WHITE], width: 2, ..picture(&["."]) };
        assert_eq!(guess(&coloured), LabelMode::Labels);
        assert_eq!(guess(&Picture { numbers: true, ..picture(&["W"]) }), LabelMode::Labels);
    }

    #[test]
    fn rooms_are_named() {
        let image = LabelImage::of_picture(picture(&["..WW", "W.WW"]), LabelMode::White, 0).unwrap();
        assert_eq!((image.names, image.labels[4]), (vec!["at 2,0".to_string(), "at 0,1".to_string()], 2));
        let image = LabelImage::of_picture(picture(&["111", "111", "111"]), LabelMode::Labels, 0).unwrap();
        assert_eq!((image.areas(), image.names), (vec![9], vec!["#010000".to_string()]));
    }

    #[test]
    fn too_many_rooms_are_refused() {
        let width = 2 * MAX_ROOMS + 2;
        let colours = (0..width).map(|i| if i % 2 == 0 { WHITE } else { BLACK }).collect();
        let dots = Picture { width, height: 1, colours, numbers: false };
        assert!(LabelImage::of_picture(dots, LabelMode::White, 0).is_err());
    }
}
