//! The layers, named after the AIA CAD Layer Guidelines.

/// A layer of the drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layer {
    Wall,
    WallCentre,
    Door,
    Window,
    Stairs,
    Lift,
    Fixture,
    Area,
    AreaLabel,
    Frontier,
    Annotation,
    Symbol,
}

/// How a layer looks.
pub struct Style {
    pub name: &'static str,
    /// AutoCAD Color Index.
    pub colour: i64,
    pub linetype: &'static str,
    /// Hundredths of a millimetre on paper.
    pub lineweight: i64,
}

impl Layer {
    /// All layers, in the order of the layer table.
    pub const ALL: [Self; 12] = [
        Self::Wall,
        Self::WallCentre,
        Self::Door,
        Self::Window,
        Self::Stairs,
        Self::Lift,
        Self::Fixture,
        Self::Area,
        Self::AreaLabel,
        Self::Frontier,
        Self::Annotation,
        Self::Symbol,
    ];

    /// How the layer looks. Colour 7 is black on white and white on black.
    pub const fn style(self) -> Style {
        let (name, colour, linetype, lineweight) = match self {
            Self::Wall => ("A-WALL", 7, "Continuous", 50),
            Self::WallCentre => ("A-WALL-CNTR", 8, "CENTER", 13),
            Self::Door => ("A-DOOR", 30, "Continuous", 25),
            Self::Window => ("A-GLAZ", 150, "Continuous", 18),
            Self::Stairs => ("A-FLOR-STRS", 8, "Continuous", 18),
            Self::Lift => ("A-FLOR-EVTR", 8, "Continuous", 18),
            Self::Fixture => ("A-FLOR-PFIX", 8, "Continuous", 18),
            Self::Area => ("A-AREA", 4, "Continuous", 18),
            Self::AreaLabel => ("A-AREA-IDEN", 7, "Continuous", 18),
            Self::Frontier => ("A-AREA-PRTL", 1, "DASHED", 25),
            Self::Annotation => ("A-ANNO-TEXT", 94, "Continuous", 18),
            Self::Symbol => ("A-ANNO-SYMB", 94, "Continuous", 18),
        };
        Style { name, colour, linetype, lineweight }
    }
}
