//! A picture of yes and no.

/// One flag for every pixel of a picture, row by row from the **top**.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mask {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The flags, `width * height` of them.
    pub set: Vec<bool>,
}

impl Mask {
    /// A mask of this size in which nothing is set.
    pub fn empty(width: u32, height: u32) -> Self {
        Self { width, height, set: vec![false; width as usize * height as usize] }
    }

    /// Whether the pixel is set; what lies outside is not.
    pub fn get(&self, x: i64, y: i64) -> bool {
        let inside = x >= 0 && y >= 0 && x < i64::from(self.width) && y < i64::from(self.height);
        inside && self.set[y as usize * self.width as usize + x as usize]
    }

    /// How many pixels are set.
    pub fn count(&self) -> usize {
        self.set.iter().filter(|&&s| s).count()
    }

    /// This mask without what is set in the other one, which must be of the same size.
    pub fn without(mut self, other: &Self) -> Self {
        self.set.iter_mut().zip(&other.set).for_each(|(s, &o)| *s &= !o);
        self
    }

    /// This mask with what is set in the other one, which must be of the same size.
    pub fn with(mut self, other: &Self) -> Self {
        self.set.iter_mut().zip(&other.set).for_each(|(s, &o)| *s |= o);
        self
    }
}
