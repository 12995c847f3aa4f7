//! Safety signs, drawn by the templates that the program comes with.

use super::drawing::{Drawing, block};
use crate::rng::Rng;
use planform_sdk::Point;
use resvg::usvg::{Options, Tree};
use tiny_skia::Transform;

/// The drawings of each kind.
const FILES: [(&str, &[&str]); 7] = [
    ("fire-extinguisher", &["fire-extinguisher.svg"]),
    ("fire-hose-reel", &["fire-hose-reel.svg", "fire-hose-reel-spiral.svg"]),
    ("fire-alarm-call-point", &["fire-alarm-call-point.svg"]),
    ("first-aid", &["first-aid.svg"]),
    (
        "emergency-exit",
        &[
            "emergency-exit-left.svg",
            "emergency-exit-right.svg",
            "emergency-exit-arrow-left.svg",
            "emergency-exit-arrow-right.svg",
        ],
    ),
    ("assembly-point", &["assembly-point.svg"]),
    ("you-are-here", &["you-are-here-dot.svg", "you-are-here-ring.svg", "you-are-here-pin.svg"]),
];

/// A sign.
pub(super) struct Sign {
    kind: &'static str,
    tree: Tree,
}

impl Sign {
    /// One of the drawings of this kind; `None` if there is none.
    pub(super) fn draw(kind: &str, rng: &mut Rng) -> Option<Self> {
        let (kind, files) = FILES.iter().find(|(k, _)| *k == kind)?;
        let svg = planform_templates::drawing(files[rng.index(files.len())])?;
        Some(Self { kind, tree: Tree::from_str(svg, &Options::default()).ok()? })
    }

    /// Width and height of the sign where it is so high.
    pub(super) fn size(&self, high: f64) -> (f64, f64) {
        let size = self.tree.size();
        (high * f64::from(size.width() / size.height()), high)
    }
}

/// Draws the sign so high around the point, and tells of it if it stands for something there.
pub(super) fn stamp(drawing: &mut Drawing, sign: &Sign, middle: Point, high: f64, stands: bool) {
    let scale = high as f32 / sign.tree.size().height();
    let (wide, _) = sign.size(high);
    let (left, top) = ((middle.x - wide / 2.0) as f32, (middle.y + high / 2.0) as f32);
    let place = Transform::from_row(scale, 0.0, 0.0, -scale, left, top).post_concat(drawing.view.transform());
    resvg::render(&sign.tree, place, &mut drawing.picture.pixmap().as_mut());
    if stands {
        drawing.tell(sign.kind, &block(middle, (1.0, 0.0), wide, high), vec![]);
    }
}
