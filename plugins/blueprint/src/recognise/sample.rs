//! A picture looked at in places: enough to tell what it is, and quick however large it is.

use image::{DynamicImage, GenericImageView};

/// The most columns or rows of a sample.
const SIDE: u32 = 1000;

/// The least difference between the colour channels of what is coloured.
const CHROMA: u8 = 32;

/// Grey from 0 to 255; nothing where the picture is rather transparent than not.
pub type Tone = Option<u8>;

/// Pixels at even distances, row by row from the top.
#[derive(Debug)]
pub struct Sample {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// How light each pixel is.
    pub tones: Vec<Tone>,
    /// Which pixels are coloured.
    pub coloured: Vec<bool>,
}

impl Sample {
    /// Looks at a picture.
    pub fn of(picture: &DynamicImage) -> Self {
        let (columns, rows) = picture.dimensions();
        let step = columns.max(rows).div_ceil(SIDE).max(1);
        let (width, height) = (columns.div_ceil(step) as usize, rows.div_ceil(step) as usize);
        let mut sample = Self { width, height, tones: Vec::new(), coloured: Vec::new() };
        for y in 0..height as u32 {
            for x in 0..width as u32 {
                let [red, green, blue, alpha] = picture.get_pixel(x * step, y * step).0;
                let (low, high) = (red.min(green).min(blue), red.max(green).max(blue));
                let mean = (u16::from(red) + u16::from(green) + u16::from(blue)) / 3;
                sample.tones.push((alpha >= 128).then_some(mean as u8));
                sample.coloured.push(alpha >= 128 && high - low > CHROMA);
            }
        }
        sample
    }

    /// The tone at a place inside.
    pub fn tone(&self, x: usize, y: usize) -> Tone {
        self.tones[y * self.width + x]
    }

    /// The longer side.
    pub fn side(&self) -> usize {
        self.width.max(self.height)
    }

    /// The share of pixels for which this holds.
    pub fn share(&self, holds: impl Fn(usize) -> bool) -> f64 {
        (0..self.tones.len()).filter(|&i| holds(i)).count() as f64 / self.tones.len().max(1) as f64
    }

    /// Which pixels lie where this holds over at least `size` pixels in a row and in a column: in areas, not in strokes.
    pub fn areas(&self, size: usize, holds: impl Fn(usize) -> bool) -> Vec<bool> {
        let mut areas: Vec<bool> = (0..self.tones.len()).map(holds).collect();
        let along: Vec<bool> = long_runs(&areas, size, self.height, |y, x| y * self.width + x, self.width);
        let down = long_runs(&areas, size, self.width, |x, y| y * self.width + x, self.height);
        areas.iter_mut().zip(along.iter().zip(&down)).for_each(|(area, (&a, &d))| *area = a && d);
        areas
    }
}

/// What is set in runs of at least `size` along lines; `at` tells where a line's pixels are.
fn long_runs(
    set: &[bool],
    size: usize,
    lines: usize,
    at: impl Fn(usize, usize) -> usize,
    length: usize,
) -> Vec<bool> {
    let mut long = vec![false; set.len()];
    for line in 0..lines {
        let mut start = 0;
        for end in 0..=length {
            if end == length || !set[at(line, end)] {
                if end - start >= size {
                    (start..end).for_each(|i| long[at(line, i)] = true);
                }
                start = end + 1;
            }
        }
    }
    long
}
