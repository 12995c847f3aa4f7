//! The faces of the drawing: what ink and walls enclose, with the gaps in line closed.

use super::components::{self, Neighbours};
use super::distance;
use super::drawing::Drawing;
use super::straight::Straight;
use std::collections::BTreeMap;

/// Faces hang together only where they are wider than twice this, metres: lines have small gaps.
const GAP: f64 = 0.06;

/// A door stands in a wall: along it a boundary counts as a line of this length, metres.
const DOOR_LINE: f64 = 1.0;

/// The faces, and what of the drawing belongs to which.
pub struct Faces {
    /// For every pixel that is no wall its face, from 1: of a line the nearest one's. 0 where there is none.
    pub label: Vec<u32>,
    /// What every face is; number 0 is none.
    pub all: Vec<Face>,
}

/// One face.
#[derive(Debug, Clone, Copy, Default)]
pub struct Face {
    /// Square metres.
    pub area: f64,
    /// Radius of the largest disc in it, metres.
    pub radius: f64,
    /// Whether it reaches the drawing's edge.
    pub open: bool,
}

/// The boundary of two faces.
#[derive(Debug, Clone, Copy, Default)]
pub struct Boundary {
    /// How long it is, metres.
    pub length: f64,
    /// How much of it is ink, metres.
    pub inked: f64,
    /// The lengths of the straight lines along it, times the length that each has of it.
    pub straight: f64,
}

impl Faces {
    /// Finds the faces between walls, ink and bridges.
    pub fn find(drawing: &Drawing, wall: &[bool], bridge: &[bool]) -> Self {
        let free: Vec<bool> = (0..wall.len()).map(|i| !drawing.ink[i] && !wall[i] && !bridge[i]).collect();
        let clear = distance::squared(&free, drawing.width);
        let least = (GAP * drawing.metre).max(1.0).powi(2);
        let core: Vec<bool> = clear.iter().map(|&d| f64::from(d) > least).collect();
        let found = components::find(&core, drawing.width, Neighbours::Four);
        let mut faces = Self { label: found.label, all: vec![Face::default(); found.all.len()] };
        faces.spread(drawing, |i| free[i]);
        faces.measure(drawing, &clear);
        faces.spread(drawing, |i| !drawing.ink[i] && !wall[i]);
        faces.spread(drawing, |i| !wall[i]);
        faces
    }

    /// Lets all faces grow by the same steps over what is open to them.
    fn spread(&mut self, drawing: &Drawing, open: impl Fn(usize) -> bool) {
        let mut layer: Vec<usize> = (0..self.label.len()).filter(|&i| self.label[i] != 0).collect();
        while !layer.is_empty() {
            let mut next = Vec::new();
            for &at in &layer {
                for beside in Neighbours::Four.of(at, drawing.width, drawing.height) {
                    if self.label[beside] == 0 && open(beside) {
                        self.label[beside] = self.label[at];
                        next.push(beside);
                    }
                }
            }
            layer = next;
        }
    }

    fn measure(&mut self, drawing: &Drawing, clear: &[u32]) {
        for (at, &label) in self.label.iter().enumerate().filter(|(_, l)| **l != 0) {
            let face = &mut self.all[label as usize];
            face.area += drawing.metre.powi(-2);
            face.radius = face.radius.max(f64::from(clear[at]).sqrt() / drawing.metre);
            face.open |= drawing.is_edge(at);
        }
    }

    /// The boundaries of all pairs of faces that meet on a line or a bridge.
    pub fn boundaries(
        &self,
        drawing: &Drawing,
        lines: &Straight,
        doors: &[bool],
    ) -> BTreeMap<(u32, u32), Boundary> {
        let mut out: BTreeMap<(u32, u32), Boundary> = BTreeMap::new();
        let pixel = 1.0 / drawing.metre;
        self.contacts(drawing, |at, beside| {
            let (a, b) = (self.label[at], self.label[beside]);
            let line = f64::from(lines.length[at].max(lines.length[beside])) * pixel;
            let run = if doors[at] || doors[beside] { line.max(DOOR_LINE) } else { line };
            let boundary = out.entry((a.min(b), a.max(b))).or_default();
            boundary.length += pixel;
            boundary.inked += if run > 0.0 { pixel } else { 0.0 };
            boundary.straight += run * pixel;
        });
        out
    }

    /// Visits all neighbouring pixels of two different faces.
    pub fn contacts(&self, drawing: &Drawing, mut visit: impl FnMut(usize, usize)) {
        for at in 0..self.label.len() {
            for beside in drawing.after(at) {
                let (a, b) = (self.label[at], self.label[beside]);
                if a != b && a != 0 && b != 0 {
                    visit(at, beside);
                }
            }
        }
    }
}
