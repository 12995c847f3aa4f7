//! From what was read of a page to the scene: from pixels of the sheet to metres of the map frame.

use crate::found::{SheetLeaf, SheetSymbol, SheetText};
use crate::options::NAME;
use crate::pipeline::Reading;
use crate::walls;
use planform_sdk::{
    Annotations, DoorLeaf, ErrorKind, Grid, PluginError, Point, Pose, Provenance, Scale, Scene, Symbol, Text,
};

/// Where the page lies in the map frame: y up, the page's lower left corner at `origin`.
#[derive(Debug, Clone, Copy)]
pub struct PageFrame {
    /// The page's height, pixels.
    pub height: f64,
    /// The lower left corner, metres.
    pub origin: [f64; 2],
}

/// The map frame's view of a sheet.
struct Frame<'a> {
    reading: &'a Reading,
    page: PageFrame,
}

/// The scene of a reading.
///
/// # Errors
/// When the building is too large for a grid.
pub fn scene(reading: &Reading, page: PageFrame, source: String) -> Result<Scene, PluginError> {
    let frame = Frame { reading, page };
    let scale = &reading.scale;
    let annotations = Annotations {
        texts: reading.words.texts.iter().map(|t| frame.text(t)).collect(),
        symbols: reading.symbols.symbols.iter().map(|s| frame.symbol(s)).collect(),
        provenance: Provenance { source, adapter: NAME.into() },
        warnings: reading.warnings.clone(),
        scale: Some(Scale {
            metres_per_pixel: scale.metres_per_pixel,
            source: scale.source.clone(),
            confidence: scale.confidence,
        }),
        ..Annotations::default()
    };
    Ok(Scene::new(frame.grid()?, annotations))
}

impl Frame<'_> {
    fn metres(&self) -> f64 {
        self.reading.scale.metres_per_pixel
    }

    /// A point of the sheet in the map frame.
    fn point(&self, p: [f64; 2]) -> Point {
        let [x, y] = self.reading.sheet.to_page(p);
        let [left, bottom] = self.page.origin;
        Point::new(left + x * self.metres(), bottom + (self.page.height - y) * self.metres())
    }

    /// An angle clockwise on the sheet as one counter-clockwise in the map frame, within half a turn either way.
    fn yaw(&self, angle: f64) -> f64 {
        let yaw = self.reading.sheet.turned - angle;
        yaw.sin().atan2(yaw.cos())
    }

    fn pose(&self, centre: [f64; 2], angle: f64) -> Pose {
        let Point { x, y } = self.point(centre);
        Pose { x, y, yaw: self.yaw(angle) }
    }

    fn text(&self, text: &SheetText) -> Text {
        Text {
            content: text.content.clone(),
            pose: self.pose(text.centre, text.angle),
            width: text.width * self.metres(),
            height: text.height * self.metres(),
            confidence: text.confidence.clamp(0.0, 1.0),
        }
    }

    fn symbol(&self, symbol: &SheetSymbol) -> Symbol {
        Symbol {
            kind: symbol.kind.clone(),
            pose: self.pose(symbol.centre, symbol.angle),
            width: symbol.width * self.metres(),
            height: symbol.height * self.metres(),
            score: symbol.score.clamp(0.0, 1.0),
            leaves: symbol.leaves.iter().map(|l| self.leaf(l)).collect(),
        }
    }

    fn leaf(&self, leaf: &SheetLeaf) -> DoorLeaf {
        let [hinge, closed, open] = [leaf.hinge, leaf.closed, leaf.open].map(|p| self.point(p));
        DoorLeaf { hinge, closed, open }
    }

    fn grid(&self) -> Result<Grid, PluginError> {
        let cells = walls::cells(&self.reading.walls, self.metres());
        let corner = self.point([0.0, f64::from(self.reading.sheet.ink.height)]);
        let origin = Pose { x: corner.x, y: corner.y, yaw: self.yaw(0.0) };
        Grid::new(cells.columns, cells.rows, cells.resolution, origin, cells.cells).map_err(|e| {
            PluginError::new(ErrorKind::Limit, e.to_string())
                .advise("check the scale, or give a smaller picture or `dpi`")
        })
    }
}
