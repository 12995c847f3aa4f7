//! Which colours of a page are ground (paper and painted floors) and which are ink.

use super::{morphology, negative, tone};
use crate::mask::Mask;
use image::RgbImage;

/// The page is looked at in about this many samples along its longer side.
const SAMPLES: u32 = 1000;
/// Samples around which a channel varies by more lie on an edge.
const FLAT: u8 = 40;
/// Colours that differ by less in every channel are one.
const ALIKE: u8 = 20;
/// A colour that covers less of the page is no floor's.
const LEAST_SHARE: f32 = 0.001;
/// At most so many floors are told apart.
const MOST: usize = 24;
/// Greys darker than this are ink, however thick they lie: poured walls, pillars.
const DARK: u8 = 100;
/// Greys lighter than this are a fill between outlines, if they lie between darker ones.
const LIGHT: u8 = 150;
/// A floor has at least so much of its area in places thicker than a wall.
const THICK_SHARE: f32 = 0.3;
/// A band is filled between outlines if so much of its rim is darker.
const OUTLINED_SHARE: f32 = 0.6;

/// What a colour is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    /// As dark as it looks.
    Plain,
    /// A sign, a route or a marking: not of the drawing.
    Coloured,
    /// That of the floor of this number: what is drawn on it is seen against it.
    Ground(u8),
}

/// The meaning of every colour, looked up by the upper five bits of each channel.
pub struct Palette {
    meanings: Vec<Meaning>,
    grounds: Vec<[u8; 3]>,
    inks: [bool; tone::HUES],
}

impl Palette {
    /// Reads a page that is drawn in dark on light.
    pub fn read(page: &RgbImage) -> Self {
        let samples = Samples::take(page);
        let inks = samples.coloured_inks();
        let mut grounds = samples.classes();
        grounds.retain(|&c| samples.is_ground(c, &inks));
        grounds.sort_by_key(|&c| (tone::luma(c), c));
        let mut palette = Self { meanings: vec![], grounds, inks };
        palette.meanings = (0..1 << 15).map(|cell| palette.find(centre(cell))).collect();
        palette
    }

    /// What this colour is.
    pub fn meaning(&self, colour: [u8; 3]) -> Meaning {
        self.meanings[cell(colour)]
    }

    /// The floors' colours, the darkest first.
    pub fn grounds(&self) -> &[[u8; 3]] {
        &self.grounds
    }

    /// Whether a colour, wherever it is, is none of the drawing's inks.
    pub fn is_foreign(&self, colour: [u8; 3]) -> bool {
        tone::hue(colour).is_some_and(|hue| !self.inks[hue])
    }

    fn find(&self, colour: [u8; 3]) -> Meaning {
        let nearest = (0..self.grounds.len()).min_by_key(|&g| distance(colour, self.grounds[g]));
        match nearest {
            Some(ground) if distance(colour, self.grounds[ground]) <= ALIKE => Meaning::Ground(ground as u8),
            _ if self.is_foreign(colour) => Meaning::Coloured,
            _ => Meaning::Plain,
        }
    }
}

fn cell(colour: [u8; 3]) -> usize {
    colour.iter().fold(0, |cell, &c| cell << 5 | usize::from(c >> 3))
}

fn centre(cell: usize) -> [u8; 3] {
    [cell >> 10, cell >> 5 & 31, cell & 31].map(|c| (c * 255 / 31) as u8)
}

fn distance(a: [u8; 3], b: [u8; 3]) -> u8 {
    a.iter().zip(b).map(|(&p, q)| p.abs_diff(q)).max().unwrap_or(0)
}

/// A page seen through a coarse grid of points.
struct Samples {
    width: u32,
    height: u32,
    colours: Vec<[u8; 3]>,
    flat: Vec<bool>,
}

impl Samples {
    fn take(page: &RgbImage) -> Self {
        let step = page.width().max(page.height()).div_ceil(SAMPLES).max(1);
        let (width, height) = (page.width().div_ceil(step), page.height().div_ceil(step));
        let places = (0..width * height).map(|i| (i % width * step, i / width * step));
        let (colours, flat) = places.map(|(x, y)| look(page, x, y)).unzip();
        Self { width, height, colours, flat }
    }

    fn mask(&self, set: impl Fn(usize) -> bool) -> Mask {
        Mask { width: self.width, height: self.height, set: (0..self.colours.len()).map(set).collect() }
    }

    /// The colours that lie flat somewhere, the most frequent first.
    fn classes(&self) -> Vec<[u8; 3]> {
        let mut counts = vec![0usize; 1 << 15];
        self.colours.iter().zip(&self.flat).filter(|&(_, &f)| f).for_each(|(&c, _)| counts[cell(c)] += 1);
        let mut found = vec![];
        while found.len() < MOST {
            let near = |c: usize, peak: usize| distance(centre(c), centre(peak)) <= ALIKE;
            let Some(peak) = (0..counts.len()).max_by_key(|&c| (counts[c], std::cmp::Reverse(c))) else {
                break;
            };
            let members: Vec<_> = (0..counts.len()).filter(|&c| counts[c] > 0 && near(c, peak)).collect();
            let sum: usize = members.iter().map(|&c| counts[c]).sum();
            if counts[peak] == 0 || (sum as f32) < LEAST_SHARE * self.colours.len() as f32 {
                break;
            }
            found.push(self.middle(centre(peak)));
            members.into_iter().for_each(|c| counts[c] = 0);
        }
        found
    }

    /// The mean of the flat samples alike to a colour.
    fn middle(&self, colour: [u8; 3]) -> [u8; 3] {
        let alike =
            self.colours.iter().zip(&self.flat).filter(|&(&c, &f)| f && distance(c, colour) <= ALIKE / 2);
        let (mut sum, mut count) = ([0u64; 3], 0);
        alike.for_each(|(c, _)| {
            sum.iter_mut().zip(c).for_each(|(s, &v)| *s += u64::from(v));
            count += 1;
        });
        if count == 0 { colour } else { sum.map(|s| (s / count) as u8) }
    }

    /// Whether a colour is that of a floor: light or strongly coloured, and thicker than walls are.
    fn is_ground(&self, colour: [u8; 3], inks: &[bool; tone::HUES]) -> bool {
        let light = tone::luma(colour);
        let mask = self.mask(|i| self.flat[i] && distance(self.colours[i], colour) <= ALIKE);
        let thick = || self.thick(&mask).count() as f32 >= THICK_SHARE * mask.count() as f32;
        match tone::hue(colour) {
            Some(hue) if !inks[hue] => true,
            _ if light < DARK => false,
            _ => thick() || (light >= LIGHT && self.is_outlined(&mask, light)),
        }
    }

    /// What is thicker than walls are, small holes closed first.
    fn thick(&self, mask: &Mask) -> Mask {
        let closed = morphology::shrunk(&morphology::grown(mask, 1), 1);
        let reach = (self.width.min(self.height) as f32 * negative::THICK / 2.0).ceil() as u32;
        morphology::opened(&closed, reach)
    }

    fn is_outlined(&self, mask: &Mask, light: u8) -> bool {
        // An outline of a fine drawing is less than a sample wide, and mixed with what is beside it.
        let darker = self.mask(|i| tone::luma(self.colours[i]) < light - light / 8);
        let near = morphology::grown(&darker, 2);
        let inner = morphology::shrunk(mask, 1);
        let rim = mask.set.iter().zip(&inner.set).zip(&near.set).filter(|&((&m, &i), _)| m && !i);
        let (all, dark) = rim.fold((0, 0), |(all, dark), (_, &n)| (all + 1, dark + u32::from(n)));
        dark as f32 >= OUTLINED_SHARE * all as f32
    }

    /// The hues in which the building itself is drawn: those that make up more ink than black does, all over
    /// the drawing.
    fn coloured_inks(&self) -> [bool; tone::HUES] {
        let tones: Vec<_> = self.colours.iter().map(|&c| (tone::hue(c), tone::luma(c))).collect();
        let mid = self.mask(|i| tones[i].1 < LIGHT && tones[i].1 >= DARK - DARK / 4);
        let floors = self.thick(&mid);
        let ink: Vec<_> = (0..tones.len()).filter(|&i| tones[i].1 < LIGHT && !floors.set[i]).collect();
        let black: Vec<_> = ink.iter().copied().filter(|&i| tones[i].0.is_none()).collect();
        std::array::from_fn(|hue| {
            let near = |h: usize| [0, 1, tone::HUES - 1].contains(&((h + tone::HUES - hue) % tone::HUES));
            let of_hue: Vec<_> = ink.iter().copied().filter(|&i| tones[i].0.is_some_and(near)).collect();
            of_hue.len() > black.len() * needed(hue) && self.is_all_over(&of_hue, &ink)
        })
    }

    /// Whether these samples reach over most of what those cover.
    fn is_all_over(&self, part: &[usize], all: &[usize]) -> bool {
        let (part, all) = (self.extent(part), self.extent(all));
        part.iter().zip(all).all(|(&p, a)| p as f32 >= 0.6 * a as f32)
    }

    /// Width and height of the middle 96 % of some samples.
    fn extent(&self, samples: &[usize]) -> [usize; 2] {
        let spread = |mut places: Vec<usize>| {
            places.sort_unstable();
            let end = places.len() / 50;
            places.get(places.len().saturating_sub(end + 1)).map_or(0, |last| last - places[end] + 1)
        };
        let width = self.width as usize;
        [
            spread(samples.iter().map(|i| i % width).collect()),
            spread(samples.iter().map(|i| i / width).collect()),
        ]
    }
}

/// How many times as much as of black must be of a hue to be the walls'. Escape routes are green by law and
/// run all over a plan; there is no such use of other colours.
fn needed(hue: usize) -> usize {
    let green = 4 * tone::HUES / 12..=5 * tone::HUES / 12;
    if green.contains(&hue) { 5 } else { 1 }
}

/// The mean colour around a pixel, and whether it is much the same there.
fn look(page: &RgbImage, x: u32, y: u32) -> ([u8; 3], bool) {
    let (mut low, mut high) = ([255u8; 3], [0u8; 3]);
    for ny in y.saturating_sub(1)..(y + 2).min(page.height()) {
        for nx in x.saturating_sub(1)..(x + 2).min(page.width()) {
            let colour = page.get_pixel(nx, ny).0;
            low.iter_mut().zip(colour).for_each(|(l, c)| *l = c.min(*l));
            high.iter_mut().zip(colour).for_each(|(h, c)| *h = c.max(*h));
        }
    }
    let flat = low.iter().zip(high).all(|(&l, h)| h - l <= FLAT);
    let middle = std::array::from_fn(|c| low[c].midpoint(high[c]));
    (if flat { middle } else { page.get_pixel(x, y).0 }, flat)
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::Rgb;

    /// Whether a colour is that of a floor.
    fn is_floor(palette: &Palette, colour: [u8; 3]) -> bool {
        let alike = |ground: u8| distance(palette.grounds()[ground as usize], colour) <= ALIKE;
        matches!(palette.meaning(colour), Meaning::Ground(ground) if alike(ground))
    }

    /// Two rooms side by side: walls of one colour, floors of two others, paper around.
    fn rooms(wall: [u8; 3], left: [u8; 3], right: [u8; 3]) -> RgbImage {
        RgbImage::from_fn(300, 200, |x, y| {
            let out = x.min(299 - x).min(y).min(199 - y);
            Rgb(match out {
                0..20 => [255; 3],
                20..25 => wall,
                _ if (148..153).contains(&x) => wall,
                _ if x < 150 => left,
                _ => right,
            })
        })
    }

    #[test]
    fn floors_are_ground_and_walls_are_ink() {
        for wall in [[0; 3], [58, 63, 69], [128; 3], [130, 0, 40], [20, 30, 140]] {
            let palette = Palette::read(&rooms(wall, [192; 3], [243, 233, 230]));
            assert_eq!(palette.meaning(wall), Meaning::Plain, "{wall:?}");
            assert!(is_floor(&palette, [192; 3]), "{wall:?}");
            assert!(is_floor(&palette, [243, 233, 230]), "{wall:?}");
            assert!(is_floor(&palette, [255; 3]), "{wall:?}");
        }
    }

    #[test]
    fn routes_and_signs_are_coloured_on_a_black_plan() {
        let mut page = rooms([0; 3], [140, 220, 160], [255; 3]);
        (0..400).for_each(|i| page.put_pixel(200 + i % 20, 80 + i / 20, Rgb([200, 20, 30])));
        let palette = Palette::read(&page);
        assert!(is_floor(&palette, [140, 220, 160]));
        assert_ne!(palette.meaning([200, 20, 30]), Meaning::Plain);
        assert_eq!(palette.meaning([0, 110, 60]), Meaning::Coloured);
        assert_eq!(palette.meaning([0; 3]), Meaning::Plain);
    }

    #[test]
    fn light_fills_between_outlines_are_ground_and_light_walls_without_are_ink() {
        let outlined = |outline: [u8; 3]| {
            RgbImage::from_fn(300, 200, |x, y| {
                let out = x.min(299 - x).min(y).min(199 - y);
                Rgb(match out {
                    30 | 34 => outline,
                    31..34 => [180; 3],
                    _ => [255; 3],
                })
            })
        };
        assert!(is_floor(&Palette::read(&outlined([0; 3])), [180; 3]));
        assert_eq!(Palette::read(&outlined([180; 3])).meaning([180; 3]), Meaning::Plain);
    }

    #[test]
    fn an_empty_page_has_a_palette() {
        assert_eq!(Palette::read(&RgbImage::new(0, 0)).meaning([0; 3]), Meaning::Plain);
    }
}
