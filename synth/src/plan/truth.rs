//! What is true of a plan.

use image::GrayImage;
use planform_sdk::{Layout, Point, Pose, RoomId};
use serde::Serialize;

/// The truth about a plan's picture. Every coordinate is in metres of the building, x to the right, y up, the origin at
/// the lower left corner of the picture as it is: where the sheet was scanned askew, walls and words lie askew here too.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanTruth {
    /// Metres of the building for each pixel.
    pub metres_per_pixel: f64,
    /// By this angle the sheet lies turned, radians counter-clockwise, about the middle of the picture.
    pub skew: f64,
    /// Whether the picture tells its scale, beside the width of its doors: in the title block (and then the picture has
    /// its `dpi`), by a scale bar, by dimensions or by areas.
    pub tells_scale: bool,
    /// The building. Its rooms have the names that are written in them.
    pub layout: Layout,
    /// What is written in the rooms, for those in which something is.
    pub names: Vec<PlanName>,
    /// Everything that is written, line by line.
    pub texts: Vec<PlanText>,
    /// All symbols that stand for something in the building; those of a legend do not.
    pub symbols: Vec<PlanSymbol>,
    /// 255 where a wall's ink is, the picture's size: the fill, the hatching or the two lines, whatever walls are drawn
    /// with, columns and short walls included, windows not.
    #[serde(skip)]
    pub walls: GrayImage,
    /// 255 where a letter's ink is, the picture's size.
    #[serde(skip)]
    pub letters: GrayImage,
}

/// What is written in a room.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PlanName {
    /// The room.
    pub room: RoomId,
    /// What it is called, in one line.
    pub name: Option<String>,
    /// Its number.
    pub number: Option<String>,
    /// Its area or its measures, as written.
    pub area: Option<String>,
}

/// What a line of text is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlanTextRole {
    /// A room's name, or a line of it.
    Name,
    /// A room's number.
    Number,
    /// A room's area or its measures.
    Area,
    /// The length beside a dimension line.
    Dimension,
    /// Title block, header, legend, scale bar, north arrow.
    Aside,
    /// Words at other places on the plan.
    Remark,
}

/// A line of text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanText {
    /// What it says.
    pub content: String,
    /// What it is for.
    pub role: PlanTextRole,
    /// The room that it is written in.
    pub room: Option<RoomId>,
    /// The middle of its ink, and its reading direction.
    pub pose: Pose,
    /// Length of its ink along the reading direction, metres.
    pub width: f64,
    /// Height of its ink, metres.
    pub height: f64,
}

/// A symbol.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanSymbol {
    /// What it means, as the table of the templates names it.
    pub kind: String,
    /// Its middle and direction. Of doors and windows: the middle of the opening, and along the wall.
    pub pose: Pose,
    /// Length along its direction, metres; of a door the width of its opening.
    pub width: f64,
    /// Extent across its direction, metres; of a door or window the thickness of the wall.
    pub height: f64,
    /// The leaves of a door that swings.
    pub leaves: Vec<PlanLeaf>,
}

/// One leaf of a door that swings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlanLeaf {
    /// Where it turns.
    pub hinge: Point,
    /// Where its free end is when it is closed.
    pub closed: Point,
    /// Where its free end is as drawn, open.
    pub open: Point,
}
