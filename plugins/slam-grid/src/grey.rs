//! What a pixel of a bare picture shows.

/// A grey from 0, black, to 255, white, or nothing where the picture is transparent. Small, so that tables of what
/// becomes of each are short.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd)]
pub struct Grey(u16);

impl Grey {
    /// How many there are.
    pub const COUNT: usize = 257;
    /// Nothing.
    pub const CLEAR: Self = Self(256);

    /// This grey.
    pub fn of(shade: u8) -> Self {
        Self(shade.into())
    }

    /// The one of this index: those from [`Self::COUNT`] on are [`Self::CLEAR`].
    pub fn at(index: usize) -> Self {
        Self(index.min(256) as u16)
    }

    /// Its place in a table of [`Self::COUNT`].
    pub fn index(self) -> usize {
        self.0.into()
    }

    /// The grey, if it is one.
    pub fn shade(self) -> Option<u8> {
        u8::try_from(self.0).ok()
    }
}
