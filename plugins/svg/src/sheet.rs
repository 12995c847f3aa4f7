//! The sheet: which part of the map frame it shows, and how map points lie on it.

use crate::element::number;
use planform_sdk::{ErrorKind, Layout, PluginError, Point, Pose, bounds};

/// Side of the sheet of a layout without anything in it, metres.
const EMPTY: f64 = 10.0;

/// A rectangle of the map frame with its upper left corner on whole metres. On the sheet x runs right and y runs
/// down from that corner, in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// The upper left corner in the map frame.
    pub origin: Point,
    /// Metres.
    pub width: f64,
    /// Metres.
    pub height: f64,
}

impl Sheet {
    /// A sheet with room for all of the layout, these further points, a margin and the scale bar.
    pub fn around(layout: &Layout, further: &[Point]) -> Result<Self, PluginError> {
        let points = || points(layout).chain(further.iter().copied());
        if let Some(p) = points().find(|p| !(p.x.is_finite() && p.y.is_finite())) {
            return Err(unusable(format!("the layout has a point at ({}, {})", p.x, p.y)));
        }
        let (lo, hi) = bounds(points()).unwrap_or((Point::default(), Point::new(EMPTY, EMPTY)));
        Self::with_margin(lo, hi)
    }

    fn with_margin(lo: Point, hi: Point) -> Result<Self, PluginError> {
        let margin = 0.5 + 0.03 * (hi.x - lo.x).max(hi.y - lo.y);
        // The scale bar lies in the lower margin.
        let below = 2.5 * margin;
        let origin = Point::new((lo.x - margin).floor(), (hi.y + margin).ceil());
        let width = (hi.x + margin - origin.x).ceil();
        let height = (origin.y - (lo.y - below)).ceil();
        if !(width.is_finite() && height.is_finite() && origin.x.is_finite() && origin.y.is_finite()) {
            return Err(unusable(format!("the layout spans ({}, {}) to ({}, {})", lo.x, lo.y, hi.x, hi.y)));
        }
        Ok(Self { origin, width, height })
    }

    /// A point of the map frame, on the sheet.
    pub fn place(&self, p: Point) -> Point {
        Point::new(p.x - self.origin.x, self.origin.y - p.y)
    }

    /// The sheet's longer side, metres: what lettering that is not of the building is measured by.
    pub fn size(&self) -> f64 {
        self.width.max(self.height)
    }

    /// Path data of straight lines through map points.
    pub fn path(&self, points: &[Point], closed: bool) -> String {
        let mut data = String::new();
        for (i, &p) in points.iter().enumerate() {
            let p = self.place(p);
            data.push_str(if i == 0 { "M" } else { "L" });
            data.push_str(&format!("{} {}", number(p.x), number(p.y)));
        }
        if closed && !points.is_empty() {
            data.push('Z');
        }
        data
    }
}

fn unusable(what: String) -> PluginError {
    PluginError::new(ErrorKind::BadInput, format!("{what}, which cannot be drawn"))
        .advise("correct the layout")
}

/// Every point that is drawn.
fn points(layout: &Layout) -> impl Iterator<Item = Point> {
    let rooms = layout.rooms.iter().flat_map(|r| r.inner.rings().chain(r.centre.rings())).flatten().copied();
    let walls = layout.walls.iter().map(|w| w.line);
    let segments = walls
        .chain(layout.openings.iter().map(|o| o.segment))
        .chain(layout.frontiers.iter().map(|f| f.segment))
        .flat_map(|s| [s.a, s.b]);
    let texts = layout.texts.iter().flat_map(|t| corners(&t.pose, t.width, t.height));
    let symbols = layout.symbols.iter().flat_map(|s| corners(&s.pose, s.width, s.height));
    let leaves = layout.symbols.iter().flat_map(|s| &s.leaves);
    let swings = leaves.flat_map(|l| [l.hinge, l.open, l.closed, l.at(0.5), l.at(1.0)]);
    rooms.chain(segments).chain(texts).chain(symbols).chain(swings)
}

/// The corners of a box about its middle, in the map frame.
pub fn corners(pose: &Pose, width: f64, height: f64) -> [Point; 4] {
    let (sin, cos) = pose.yaw.sin_cos();
    [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(u, v)| {
        let (u, v) = (u * width, v * height);
        Point::new(pose.x + cos * u - sin * v, pose.y + sin * u + cos * v)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Segment, Wall};

    fn wall(a: Point, b: Point) -> Layout {
        let walls = vec![Wall { line: Segment::new(a, b), thickness: 0.2, weight: 1.0, rooms: [None, None] }];
        Layout { walls, ..Layout::default() }
    }

    #[test]
    fn sheet_holds_everything_with_a_margin() {
        let sheet = Sheet::around(&wall(Point::new(-3.2, 1.1), Point::new(8.0, 4.0)), &[]).unwrap();
        assert_eq!(sheet.origin, Point::new(-5.0, 5.0));
        let far = sheet.place(Point::new(8.0, 1.1));
        assert!(far.x > 0.0 && far.x < sheet.width - 0.5 && far.y > 0.0 && far.y < sheet.height - 0.5);
    }

    #[test]
    fn empty_layout_has_a_sheet() {
        assert!(Sheet::around(&Layout::default(), &[]).unwrap().width > EMPTY);
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        for far in [f64::NAN, f64::INFINITY, f64::MAX] {
            let layout = wall(Point::new(-far, 0.0), Point::new(far, 0.0));
            assert_eq!(Sheet::around(&layout, &[]).unwrap_err().kind, ErrorKind::BadInput);
        }
    }

    #[test]
    fn path_closes_and_may_be_empty() {
        let sheet = Sheet { origin: Point::new(0.0, 10.0), width: 10.0, height: 10.0 };
        let points = [[1.0, 2.0], [3.0, 2.5]].map(Point::from);
        assert_eq!(sheet.path(&points, true), "M1 8L3 7.5Z");
        assert_eq!(sheet.path(&[], true), "");
    }
}
