//! Straight strokes that lie beside each other.

use super::plane::{Vec2, dot, moved};
use super::strokes::Segment;

/// Strokes are parallel within this angle, radians.
const PARALLEL: f64 = 0.06;

/// A frame along and across a segment, its origin in the segment's middle.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    origin: Vec2,
    /// The unit vector along.
    pub along: Vec2,
    /// The unit vector across.
    pub across: Vec2,
}

/// A segment as seen in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lying {
    /// Where it begins, along.
    pub from: f64,
    /// Where it ends, along.
    pub to: f64,
    /// How far across it lies.
    pub off: f64,
}

impl Frame {
    /// The frame of a segment.
    pub fn of(segment: &Segment) -> Self {
        let along = segment.along();
        Self { origin: segment.middle(), along, across: [-along[1], along[0]] }
    }

    /// The point so far along and across.
    pub fn at(&self, along: f64, across: f64) -> Vec2 {
        moved(moved(self.origin, self.along, along), self.across, across)
    }

    fn see(&self, p: Vec2) -> Vec2 {
        let d = [p[0] - self.origin[0], p[1] - self.origin[1]];
        [dot(d, self.along), dot(d, self.across)]
    }

    /// How a segment lies in this frame, if it is parallel to it.
    pub fn lying(&self, other: &Segment) -> Option<Lying> {
        let slope = dot(other.along(), self.across).abs();
        let (a, b) = (self.see(other.a), self.see(other.b));
        let lying = Lying { from: a[0].min(b[0]), to: a[0].max(b[0]), off: (a[1] + b[1]) / 2.0 };
        (slope < PARALLEL).then_some(lying)
    }
}

/// Which of the segments, by index, are parallel to this one, as long, and not further beside it than `reach`; how
/// they lie, ordered across. The segment itself is among them.
pub fn beside(segments: &[Segment], own: usize, reach: f64, slack: f64) -> (Frame, Vec<(usize, Lying)>) {
    let frame = Frame::of(&segments[own]);
    let half = segments[own].length() / 2.0;
    let same =
        |l: &Lying| (l.from + half).abs() <= slack && (l.to - half).abs() <= slack && l.off.abs() <= reach;
    let near = |s: &Segment| {
        let [x, y] = [0, 1].map(|i| (s.middle()[i] - segments[own].middle()[i]).abs());
        x.max(y) <= reach + slack
    };
    let candidates = segments.iter().enumerate().filter(|(_, s)| near(s));
    let mut found: Vec<_> =
        candidates.filter_map(|(i, s)| frame.lying(s).map(|l| (i, l))).filter(|(_, l)| same(l)).collect();
    found.sort_by(|a, b| a.1.off.total_cmp(&b.1.off));
    (frame, found)
}
