//! Looking on while a document is read.

use crate::Grid;

/// Looks on while a document is read, and is told of every stage of it. Nothing that is told changes what is read.
pub trait ReadWatcher: Send {
    /// Whether the stages' pictures are worth the work.
    fn wants_pictures(&self) -> bool;

    /// A stage is done, such as `deskew`, and this is what it found: a picture if they are wanted and it has one. Names
    /// are of lower-case letters, digits and hyphens.
    fn stage(&mut self, name: &str, picture: Option<Picture<'_>>);
}

/// Looks away.
impl ReadWatcher for () {
    fn wants_pictures(&self) -> bool {
        false
    }

    fn stage(&mut self, _: &str, _: Option<Picture<'_>>) {}
}

/// A picture: three bytes for each pixel, red, green and blue; row by row from the top, each from left to right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Picture<'a> {
    width: u32,
    height: u32,
    rgb: &'a [u8],
}

impl<'a> Picture<'a> {
    /// The picture of these bytes; none if it has no pixel or is larger than a grid may be, or if there are not as many
    /// bytes as its sides demand.
    pub fn new(width: u32, height: u32, rgb: &'a [u8]) -> Option<Self> {
        let pixels = Grid::check_size(width, height).ok()?;
        (rgb.len() == pixels.checked_mul(3)?).then_some(Self { width, height, rgb })
    }

    /// Pixels from left to right.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Pixels from top to bottom.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The bytes.
    pub fn rgb(&self) -> &'a [u8] {
        self.rgb
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_have_as_many_bytes_as_they_say() {
        assert!(Picture::new(2, 1, &[0; 6]).is_some());
        for (width, height, bytes) in [(2, 1, 5), (2, 1, 7), (0, 1, 0), (u32::MAX, u32::MAX, 3)] {
            assert_eq!(Picture::new(width, height, &vec![0; bytes]), None);
        }
    }
}
