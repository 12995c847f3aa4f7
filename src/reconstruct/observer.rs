//! What the reconstruction tells of its steps: progress, and drawings of what each step found.

use planform_sdk::{Polygon, Segment};

/// The steps of all methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// Isolated obstacle cells are removed.
    Clutter,
    /// Canny edges.
    Edges,
    /// Segments by the probabilistic Hough transform.
    Segments,
    /// The outline of what was seen.
    Contour,
    /// Segments clustered by angle.
    Directions,
    /// Segments clustered by distance.
    Collinear,
    /// One representative line for each cluster.
    Lines,
    /// The faces between the lines.
    Faces,
    /// Affinity of neighbouring faces.
    Affinity,
    /// Faces merged to rooms.
    Rooms,
    /// Partial rooms and their frontiers.
    Partial,
    /// Inner rings, walls' thickness, openings.
    Walls,
    /// Free space cut into basins.
    Basins,
}

impl Step {
    /// The steps of the paper's method, in order.
    pub const PAPER: [Self; 12] = [
        Self::Clutter,
        Self::Edges,
        Self::Segments,
        Self::Contour,
        Self::Directions,
        Self::Collinear,
        Self::Lines,
        Self::Faces,
        Self::Affinity,
        Self::Rooms,
        Self::Partial,
        Self::Walls,
    ];

    /// The steps of the method `basins`, in order.
    pub const BASINS: [Self; 5] = [Self::Clutter, Self::Basins, Self::Rooms, Self::Partial, Self::Walls];

    /// The name, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Clutter => "clutter",
            Self::Edges => "edges",
            Self::Segments => "segments",
            Self::Contour => "contour",
            Self::Directions => "directions",
            Self::Collinear => "collinear",
            Self::Lines => "lines",
            Self::Faces => "faces",
            Self::Affinity => "affinity",
            Self::Rooms => "rooms",
            Self::Partial => "partial",
            Self::Walls => "walls",
            Self::Basins => "basins",
        }
    }
}

/// What a step found, as shapes to be painted in their order over the grid. Coordinates are cells: x to the right,
/// y up, (0, 0) the outer corner of the lower left cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// The shapes, the lowest first.
    pub shapes: Vec<Shape>,
}

/// One shape of a drawing. Colours are red, green, blue.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Cells (column, row) painted whole.
    Cells {
        /// The cells.
        cells: Vec<(u32, u32)>,
        /// Their colour.
        colour: [u8; 3],
    },
    /// A line.
    Line {
        /// Where it runs, in cells.
        segment: Segment,
        /// Its colour.
        colour: [u8; 3],
        /// Its width, in pixels of the picture.
        width: f64,
    },
    /// A filled area, half transparent.
    Area {
        /// Its outline, in cells.
        polygon: Polygon,
        /// Its colour.
        colour: [u8; 3],
    },
}

/// Looks on while a layout is reconstructed.
pub trait Observer {
    /// A step begins.
    fn step(&mut self, step: Step);

    /// Whether [`Observer::drawing`] is worth the work.
    fn wants_drawings(&self) -> bool;

    /// What the step found.
    fn drawing(&mut self, step: Step, drawing: Drawing);
}

/// Looks away.
impl Observer for () {
    fn step(&mut self, _: Step) {}

    fn wants_drawings(&self) -> bool {
        false
    }

    fn drawing(&mut self, _: Step, _: Drawing) {}
}
