//! How a plan is drawn: what one office's hand differs in from another's.

use super::PlanStyle;
use super::letters::Face;
use super::surface::Colour;
use crate::rng::Rng;

/// How walls are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum WallStyle {
    /// Filled with the colour of the lines, or a dark one.
    Solid(Colour),
    /// Two thin lines.
    Lines,
    /// Two lines, a light colour between them.
    Filled(Colour),
    /// Two lines, hatching between them.
    Hatched,
}

/// How the leaf of a door is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LeafStyle {
    Line,
    /// A narrow box as thick as this, metres.
    Panel(f64),
}

/// How a room's number stands there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Numbers {
    None,
    Plain,
    Circled,
    Boxed,
    /// The number is all that is written.
    Alone,
}

/// What is written of a room's size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sizes {
    None,
    /// "23.4 m²"
    Area,
    /// "13'6 x 11'"
    Feet,
    /// "4.10 x 3.35"
    Sides,
}

/// How lengths are written at dimension lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Units {
    Millimetres,
    Metres,
    Feet,
}

/// How a dimension line ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ends {
    Ticks,
    Arrows,
    Dots,
}

/// How a plan is drawn. Lengths are millimetres of paper unless it is said otherwise.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Look {
    pub(super) style: PlanStyle,
    pub(super) wall: WallStyle,
    /// The colour of lines and letters.
    pub(super) ink: Colour,
    /// The line of furniture, doors, dimensions.
    pub(super) thin: f64,
    /// The line along walls.
    pub(super) outline: f64,
    pub(super) leaf: LeafStyle,
    /// Whether a line shows the threshold of a door.
    pub(super) thresholds: bool,
    /// Share of the single doors that slide.
    pub(super) sliding: f64,
    /// Lines in a window: two or three.
    pub(super) panes: u32,
    /// Share of the places for windows that have one.
    pub(super) windows: f64,
    pub(super) face: Face,
    /// Height of a capital letter in a room's name.
    pub(super) capital: f64,
    pub(super) upper_case: bool,
    pub(super) numbers: Numbers,
    pub(super) sizes: Sizes,
    /// How square metres are written.
    pub(super) area_unit: &'static str,
    /// Share of the rooms whose words run up, down or upside down although they need not.
    pub(super) turned_words: f64,
    /// Share of the rooms whose words touch a wall.
    pub(super) touching: f64,
    pub(super) furniture: f64,
    /// Share of the rooms with a coloured floor.
    pub(super) floors: f64,
    pub(super) dimensions: Option<(Units, Ends)>,
    pub(super) scale_bar: bool,
    /// Whether the sheet has a frame, and a title block in it.
    pub(super) framed: bool,
    pub(super) north: bool,
    /// Whether the file says how many pixels make an inch.
    pub(super) says_dpi: bool,
    pub(super) evacuation: Evacuation,
}

/// What only evacuation plans have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Evacuation {
    /// The floor of escape routes, if it is coloured.
    pub(super) route: Option<Colour>,
    pub(super) arrow: Colour,
    /// Side of a sign, millimetres of paper.
    pub(super) sign: f64,
    pub(super) header: bool,
    pub(super) legend: bool,
}

const BLACK: Colour = [0, 0, 0];

impl Look {
    pub(super) fn draw(style: PlanStyle, rng: &mut Rng) -> Self {
        let evacuation = style == PlanStyle::Evacuation;
        let framed = !evacuation && rng.chance(0.65);
        let mut look = Self {
            style,
            wall: wall(evacuation, rng),
            ink: [BLACK, BLACK, [30, 30, 30], [60, 60, 66]][rng.index(4)],
            thin: rng.range((0.13, 0.25)),
            outline: rng.range((0.22, 0.4)),
            leaf: if rng.chance(0.5) { LeafStyle::Line } else { LeafStyle::Panel(rng.range((0.04, 0.07))) },
            thresholds: rng.chance(0.15),
            sliding: if rng.chance(0.4) { rng.range((0.05, 0.2)) } else { 0.0 },
            panes: if rng.chance(0.5) { 2 } else { 3 },
            windows: rng.range((0.45, 0.95)),
            face: Face::PLAIN[rng.index(4)],
            capital: rng.range((1.7, 2.6)),
            upper_case: rng.chance(0.4),
            numbers: numbers(evacuation, rng),
            sizes: if evacuation { Sizes::None } else { sizes(rng) },
            area_unit: ["m²", "m²", "m2", "sqm"][rng.index(4)],
            turned_words: if rng.chance(0.4) { rng.range((0.1, 0.5)) } else { 0.0 },
            touching: if rng.chance(0.3) { rng.range((0.05, 0.2)) } else { 0.0 },
            furniture: if evacuation { rng.range((-0.6, 0.5)).max(0.0) } else { rng.range((0.2, 1.0)) },
            floors: if rng.chance(0.3) { rng.range((0.3, 0.9)) } else { 0.0 },
            dimensions: (!evacuation && rng.chance(0.65)).then(|| dimensions(rng)),
            scale_bar: rng.chance(if evacuation { 0.25 } else { 0.4 }),
            framed,
            north: rng.chance(if framed { 0.8 } else { 0.3 }),
            says_dpi: framed || rng.chance(0.5),
            evacuation: Evacuation::draw(rng),
        };
        if look.wall == WallStyle::Lines {
            look.panes = 3;
        }
        look
    }

    /// Whether the scale is told otherwise than by the width of the doors.
    pub(super) fn tells_scale(&self) -> bool {
        self.framed || self.scale_bar || self.dimensions.is_some() || self.sizes != Sizes::None
    }
}

fn wall(evacuation: bool, rng: &mut Rng) -> WallStyle {
    let dark =
        [BLACK, [40, 40, 44], [70, 72, 78], [105, 105, 105]][rng.index(if evacuation { 4 } else { 3 })];
    let light = 150 + rng.index(70) as u8;
    match rng.index(if evacuation { 6 } else { 8 }) {
        0..=2 => WallStyle::Solid(dark),
        3 => WallStyle::Filled([light; 3]),
        4 | 5 => WallStyle::Lines,
        6 => WallStyle::Filled([light; 3]),
        _ => WallStyle::Hatched,
    }
}

fn numbers(evacuation: bool, rng: &mut Rng) -> Numbers {
    match rng.index(8) {
        0 if evacuation => Numbers::Alone,
        0 | 1 => Numbers::Circled,
        2 => Numbers::Boxed,
        3 | 4 => Numbers::Plain,
        _ => Numbers::None,
    }
}

fn sizes(rng: &mut Rng) -> Sizes {
    [Sizes::None, Sizes::Area, Sizes::Area, Sizes::Feet, Sizes::Sides][rng.index(5)]
}

fn dimensions(rng: &mut Rng) -> (Units, Ends) {
    let units = [Units::Millimetres, Units::Metres, Units::Feet][rng.index(3)];
    (units, [Ends::Ticks, Ends::Ticks, Ends::Arrows, Ends::Dots][rng.index(4)])
}

impl Evacuation {
    fn draw(rng: &mut Rng) -> Self {
        let greens = [[130, 228, 160], [150, 220, 150], [64, 190, 110], [190, 235, 190]];
        Self {
            route: rng.chance(0.75).then(|| greens[rng.index(4)]),
            arrow: [[0, 120, 60], [20, 100, 50], [0, 132, 79]][rng.index(3)],
            sign: rng.range((4.5, 7.5)),
            header: rng.chance(0.6),
            legend: rng.chance(0.7),
        }
    }
}
