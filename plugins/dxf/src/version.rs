//! The versions of DXF that can be written.

/// A version of DXF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    R12,
    R2000,
    R2013,
    R2018,
}

impl Version {
    /// All of them, oldest first.
    pub const ALL: [Self; 4] = [Self::R12, Self::R2000, Self::R2013, Self::R2018];
    /// What is written unless the user says otherwise; the crate's documentation gives the reason.
    pub const DEFAULT: Self = Self::R2000;

    /// The name that users type.
    pub fn name(self) -> &'static str {
        match self {
            Self::R12 => "R12",
            Self::R2000 => "R2000",
            Self::R2013 => "R2013",
            Self::R2018 => "R2018",
        }
    }

    /// The value of `$ACADVER`.
    pub fn code(self) -> &'static str {
        match self {
            Self::R12 => "AC1009",
            Self::R2000 => "AC1015",
            Self::R2013 => "AC1027",
            Self::R2018 => "AC1032",
        }
    }

    /// Whether the file has owners, subclasses, block records and objects.
    pub fn has_objects(self) -> bool {
        self > Self::R12
    }

    /// Whether the file is UTF-8; otherwise it is pure ASCII with escapes.
    pub fn is_utf8(self) -> bool {
        self >= Self::R2013
    }

    /// The most bytes of a drawn text.
    pub fn text_limit(self) -> usize {
        if self.has_objects() { 2049 } else { 255 }
    }
}
