//! The option that every exporter of rooms takes: which outline of a room it writes.

use crate::{OptionSpec, Options, Polygon, Room};

/// Which outline of a room is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// Along the inner faces of its walls.
    #[default]
    Inner,
    /// Along the centre lines of its walls.
    Centre,
}

impl Boundary {
    /// The option `boundary` with the words `inner`, the default, and `centre`.
    pub fn option() -> OptionSpec {
        let help = "outline of a room: along its walls' inner faces or along their centre lines";
        OptionSpec::choice("boundary", help, &["inner", "centre"], "inner")
    }

    /// What the user chose.
    ///
    /// ```
    /// # use planform_sdk::{Boundary, Options};
    /// let options = Options::parse(&[Boundary::option()], [("boundary", "centre")])?;
    /// assert_eq!(Boundary::chosen(&options), Boundary::Centre);
    /// # Ok::<(), planform_sdk::PluginError>(())
    /// ```
    pub fn chosen(options: &Options) -> Self {
        if options.text("boundary") == Some("centre") { Self::Centre } else { Self::Inner }
    }

    /// This outline of a room.
    pub fn of(self, room: &Room) -> &Polygon {
        match self {
            Self::Inner => &room.inner,
            Self::Centre => &room.centre,
        }
    }
}
