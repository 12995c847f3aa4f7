//! What is found on a sheet. Coordinates are pixels of the sheet: x to the right, y **down**, (0, 0) the upper left
//! corner of the upper left pixel. Angles are radians, clockwise as seen: the direction (cos, sin) in these coordinates.

/// A text.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetText {
    /// What it says, in one line.
    pub content: String,
    /// The middle of its box.
    pub centre: [f64; 2],
    /// Its reading direction.
    pub angle: f64,
    /// Length along the reading direction.
    pub width: f64,
    /// Height of the box, across the reading direction.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// A symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetSymbol {
    /// What it means, as the templates' table names it: `door`, `window`, `fire-extinguisher`.
    pub kind: String,
    /// Its middle. Of doors and windows: the middle of the opening, on the wall's middle line.
    pub centre: [f64; 2],
    /// Its direction: of doors and windows along the wall, of others how far their drawing is turned.
    pub angle: f64,
    /// Length along its direction; of a door the width of its opening, from jamb to jamb.
    pub width: f64,
    /// Extent across its direction; of a door or window the thickness of the wall.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub score: f64,
    /// The leaves of a door that swings.
    pub leaves: Vec<SheetLeaf>,
}

/// One leaf of a door that swings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetLeaf {
    /// Where it turns.
    pub hinge: [f64; 2],
    /// Where its free end is when it is closed.
    pub closed: [f64; 2],
    /// Where its free end is as drawn, open.
    pub open: [f64; 2],
}
