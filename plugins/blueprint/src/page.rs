//! One page of a document as it was drawn, before anything is understood.

use crate::found::{SheetSymbol, SheetText};
use image::RgbImage;

/// A page: its picture, and what the document itself says of it.
#[derive(Debug, Clone)]
pub struct Page {
    /// The page as seen; where the document is transparent there is white paper.
    pub picture: RgbImage,
    /// Pixels per inch of paper, if the document says so.
    pub dpi: Option<f64>,
    /// Metres per pixel, if the document itself is to scale (a CAD drawing with units).
    pub metres_per_pixel: Option<f64>,
    /// Where the picture's lower left corner lies in the document's own frame, metres; (0, 0) if it has none.
    pub origin: [f64; 2],
    /// Texts that the document holds as texts.
    pub texts: Vec<SheetText>,
    /// Whether the picture holds words: these texts as well, or others.
    pub drawn: bool,
    /// Symbols that the document holds as such (blocks of a CAD drawing).
    pub symbols: Vec<SheetSymbol>,
    /// Whether the picture holds walls alone, because the document says which of its lines are walls (a CAD drawing
    /// with layers): then nothing has to be cleaned away.
    pub walls_only: bool,
    /// What the reader should know, one sentence each.
    pub warnings: Vec<String>,
}
