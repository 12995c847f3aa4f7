//! What an input adapter reads out of a document.

use crate::{Grid, OpeningKind, Point, Pose, Segment};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The normalised form of every document: one grid and what else the document showed.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The occupancy grid.
    pub grid: Grid,
    /// The texts found, in the map frame.
    pub texts: Vec<Text>,
    /// The symbols found, in the map frame.
    pub symbols: Vec<Symbol>,
    /// All openings between rooms, if the document states them: where there is none, no room ends.
    pub openings: Option<Vec<StatedOpening>>,
    /// Where the map frame lies on the Earth, if the document says so.
    pub anchor: Option<GeoAnchor>,
    /// How large the document shows the building, for documents whose cells were not measured, such as plans.
    pub scale: Option<Scale>,
    /// Where it all came from.
    pub provenance: Provenance,
    /// What the reader should know: one sentence each, for the user's eyes.
    pub warnings: Vec<String>,
}

impl Scene {
    /// A scene of nothing but a grid.
    pub fn of_grid(grid: Grid, provenance: Provenance) -> Self {
        Self::new(grid, Annotations { provenance, ..Annotations::default() })
    }

    /// A scene of a grid and these annotations.
    pub fn new(grid: Grid, annotations: Annotations) -> Self {
        let Annotations { texts, symbols, openings, anchor, scale, provenance, warnings } = annotations;
        Self { grid, texts, symbols, openings, anchor, scale, provenance, warnings }
    }

    /// All but the grid.
    pub fn annotations(&self) -> Annotations {
        let Self { grid: _, texts, symbols, openings, anchor, scale, provenance, warnings } = self;
        Annotations {
            texts: texts.clone(),
            symbols: symbols.clone(),
            openings: openings.clone(),
            anchor: *anchor,
            scale: scale.clone(),
            provenance: provenance.clone(),
            warnings: warnings.clone(),
        }
    }
}

/// All of a scene but its grid: what crosses to plugins and between processes as JSON.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Annotations {
    /// The texts found, in the map frame.
    pub texts: Vec<Text>,
    /// The symbols found, in the map frame.
    pub symbols: Vec<Symbol>,
    /// All openings between rooms, if the document states them: where there is none, no room ends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub openings: Option<Vec<StatedOpening>>,
    /// Where the map frame lies on the Earth, if the document says so.
    pub anchor: Option<GeoAnchor>,
    /// How large the document shows the building, for documents whose cells were not measured, such as plans.
    #[serde(default)]
    pub scale: Option<Scale>,
    /// Where it all came from.
    pub provenance: Provenance,
    /// What the reader should know: one sentence each, for the user's eyes.
    pub warnings: Vec<String>,
}

/// Where a scene came from.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Provenance {
    /// The document's file name without its folder.
    pub source: String,
    /// The name of the input adapter.
    pub adapter: String,
}

/// A text found in a document.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Text {
    /// What it says.
    pub content: String,
    /// Middle of its box, metres in the map frame; `yaw` is the reading direction.
    pub pose: Pose,
    /// Length along the reading direction, metres.
    pub width: f64,
    /// Height of the box, metres.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub confidence: f64,
}

/// A symbol found in a document, such as a fire extinguisher or a door.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Symbol {
    /// What it means, as the templates' table names it.
    pub kind: String,
    /// Its middle and direction, metres in the map frame.
    pub pose: Pose,
    /// Length along its direction, metres.
    pub width: f64,
    /// Extent across its direction, metres.
    pub height: f64,
    /// From 0 (a guess) to 1 (certain).
    pub score: f64,
    /// The leaves of a door that swings, as drawn; of everything else none.
    #[serde(default)]
    pub leaves: Vec<DoorLeaf>,
}

/// Depth of a step, metres.
const TREAD: f64 = 0.28;

/// The most steps of a flight: more are a blur, or no stairs.
const MOST_STEPS: f64 = 100.0;

/// The kinds of symbols that are doors.
pub const DOOR_KINDS: [&str; 3] = ["door", "double-door", "sliding-door"];

impl Symbol {
    /// Whether it is a door.
    pub fn is_door(&self) -> bool {
        DOOR_KINDS.contains(&self.kind.as_str())
    }

    /// How many steps a flight of this length has, as it is drawn: at least 1, at most 100.
    pub fn steps(&self) -> u32 {
        (self.width / TREAD).round().clamp(1.0, MOST_STEPS) as u32
    }

    /// Whether it is a window.
    pub fn is_window(&self) -> bool {
        self.kind == "window"
    }
}

/// A leaf of a door as a plan draws it, in the map frame: a line for the open leaf and an arc for its way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DoorLeaf {
    /// The point that it turns about, metres.
    pub hinge: Point,
    /// Where its free end lies when it is closed, metres.
    pub closed: Point,
    /// Where its free end lies when it is as far open as drawn, metres.
    pub open: Point,
}

impl DoorLeaf {
    /// Its length, metres.
    pub fn length(&self) -> f64 {
        self.hinge.distance(self.closed)
    }

    /// How far it turns to be open, radians in [-pi, pi], counter-clockwise.
    ///
    /// ```
    /// # use planform_sdk::{DoorLeaf, Point};
    /// let hinge = Point::new(1.0, 1.0);
    /// let leaf = DoorLeaf { hinge, closed: Point::new(2.0, 1.0), open: Point::new(1.0, 0.0) };
    /// assert_eq!(leaf.swing(), -std::f64::consts::FRAC_PI_2);
    /// assert!(leaf.at(1.0).distance(leaf.open) < 1e-9);
    /// ```
    pub fn swing(&self) -> f64 {
        let turned = self.bearing(self.open) - self.bearing(self.closed);
        turned.sin().atan2(turned.cos())
    }

    /// Where its free end is on its way, from 0 (closed) to 1 (open), on the circle about the hinge.
    pub fn at(&self, share: f64) -> Point {
        let (sin, cos) = (self.bearing(self.closed) + share * self.swing()).sin_cos();
        Point::new(self.hinge.x + self.length() * cos, self.hinge.y + self.length() * sin)
    }

    fn bearing(&self, end: Point) -> f64 {
        (end.y - self.hinge.y).atan2(end.x - self.hinge.x)
    }
}

/// An opening between two rooms as a document states it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StatedOpening {
    /// Door or passage.
    pub kind: OpeningKind,
    /// From one end to the other, in the middle of the wall, metres in the map frame.
    pub segment: Segment,
    /// Thickness of the wall, metres, if that is stated too; 0 where the rooms' floors meet.
    #[serde(default)]
    #[schemars(range(min = 0))]
    pub depth: Option<f64>,
}

/// How large a document shows the building.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Scale {
    /// Length in the building of a pixel of the document, metres.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub metres_per_pixel: f64,
    /// What it was found by, for the user's eyes: "written scale 1:100".
    pub source: String,
    /// From 0 (a guess) to 1 (certain).
    #[schemars(range(min = 0, max = 1))]
    pub confidence: f64,
}

impl Scale {
    /// How it was found, as one says it after a number: "by door widths", or "as given".
    pub fn told(&self) -> String {
        let by = if self.source.starts_with("given") { "as" } else { "by" };
        format!("{by} {}", self.source)
    }
}

/// Where the map frame lies on the Earth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct GeoAnchor {
    /// WGS 84 latitude of `at`, degrees north.
    pub latitude: f64,
    /// WGS 84 longitude of `at`, degrees east.
    pub longitude: f64,
    /// Direction of the map's y axis, degrees clockwise from true north.
    pub bearing: f64,
    /// The point of the map frame that lies there, metres.
    pub at: Point,
}
