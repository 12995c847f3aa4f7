//! Faces merged to rooms: what thin lines enclose is furniture if it is too small for a room, and it belongs to the
//! face beside that the least straight line parts it from.

use super::faces::{Boundary, Face, Faces};
use std::collections::{BTreeMap, BTreeSet};

/// A room has at least this inscribed radius, metres,
const RADIUS: f64 = 0.65;

/// and this area, square metres, unless walls enclose it.
const AREA: f64 = 3.0;

/// Lines along a boundary that on average are longer than this are a wall, metres,
const STRAIGHT: f64 = 4.0;

/// unless the face is a strip no wider than twice this, metres: stairs and hatching.
const STRIP: f64 = 0.4;

/// No wall parts two faces where less than this share of their boundary is ink,
const INKED: f64 = 0.5;

/// and at least this length of it is not, metres.
const OPEN: f64 = 0.3;

/// What faces became.
pub struct Rooms {
    /// For every face the least number among those that it is one with.
    group: Vec<u32>,
    /// The pairs of them that lines part.
    parted: BTreeSet<(u32, u32)>,
}

impl Rooms {
    /// Merges the faces that are too small for rooms or open to each other.
    pub fn find(faces: &Faces, boundaries: &BTreeMap<(u32, u32), Boundary>) -> Self {
        let (parent, all) = ((0..faces.all.len() as u32).collect(), faces.all.clone());
        let mut groups = Groups { parent, all, between: boundaries.clone() };
        while groups.merge() {
            groups.gather();
        }
        let parted = groups.between.iter().filter(|(_, b)| b.line() > 0.0).map(|(pair, _)| *pair).collect();
        Self { group: (0..faces.all.len() as u32).map(|f| groups.root(f)).collect(), parted }
    }

    /// Whether the line between two faces is a wall. Where two rooms have more gap than line between them, the lines
    /// are none, though the rooms may be two: what stands about between them is furniture.
    pub fn parts(&self, a: u32, b: u32) -> bool {
        let (a, b) = (self.group[a as usize], self.group[b as usize]);
        self.parted.contains(&(a.min(b), a.max(b)))
    }
}

struct Groups {
    parent: Vec<u32>,
    all: Vec<Face>,
    between: BTreeMap<(u32, u32), Boundary>,
}

/// One face wants to be one with another; the weaker the line between, the sooner.
struct Wish {
    line: f64,
    face: u32,
    with: u32,
}

impl Groups {
    fn root(&self, mut of: u32) -> u32 {
        while self.parent[of as usize] != of {
            of = self.parent[of as usize];
        }
        of
    }

    /// Grants the weaker half of all wishes; whether there was one. In one go a face either takes others in or is
    /// taken in, lest a doorway join the rooms on its two sides.
    fn merge(&mut self) -> bool {
        let mut wishes: Vec<Wish> = self.wishes().into_values().filter(|w| self.may(w)).collect();
        wishes.sort_by(|a, b| a.line.total_cmp(&b.line).then(a.face.cmp(&b.face)));
        wishes.truncate(wishes.len().div_ceil(2));
        let (mut taken, mut taking) = (BTreeSet::new(), BTreeSet::new());
        for wish in &wishes {
            if !taken.contains(&wish.face) && !taking.contains(&wish.face) && !taken.contains(&wish.with) {
                taken.insert(wish.face);
                taking.insert(wish.with);
                self.join(wish.face, wish.with);
            }
        }
        !taken.is_empty()
    }

    /// Of every face too small for a room, and of those that are open to another one, the weakest boundary.
    fn wishes(&self) -> BTreeMap<u32, Wish> {
        let mut out: BTreeMap<u32, Wish> = BTreeMap::new();
        for (&(a, b), boundary) in &self.between {
            let line = boundary.line();
            for (face, with) in [(a, b), (b, a)] {
                let wants = line == 0.0 || self.all[face as usize].is_small();
                if wants && out.get(&face).is_none_or(|w| line < w.line) {
                    out.insert(face, Wish { line, face, with });
                }
            }
        }
        out
    }

    fn may(&self, wish: &Wish) -> bool {
        wish.line <= STRAIGHT || self.all[wish.face as usize].radius <= STRIP
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        let (low, high) = (a.min(b), a.max(b));
        self.parent[high as usize] = low;
        let other = self.all[high as usize];
        let face = &mut self.all[low as usize];
        face.area += other.area;
        face.radius = face.radius.max(other.radius);
        face.open |= other.open;
    }

    /// Adds up the boundaries of what has become one.
    fn gather(&mut self) {
        let mut out: BTreeMap<(u32, u32), Boundary> = BTreeMap::new();
        for (&(a, b), boundary) in &self.between {
            let (a, b) = (self.root(a), self.root(b));
            if a != b {
                out.entry((a.min(b), a.max(b))).or_default().add(boundary);
            }
        }
        self.between = out;
    }
}

impl Face {
    fn is_small(&self) -> bool {
        !self.open && (self.radius < RADIUS || self.area < AREA)
    }
}

impl Boundary {
    fn add(&mut self, other: &Self) {
        self.length += other.length;
        self.inked += other.inked;
        self.straight += other.straight;
    }

    /// How long the lines along it are on average, metres; 0 if it is more gap than line.
    fn line(&self) -> f64 {
        let is_gap = self.inked < INKED * self.length && self.length - self.inked > OPEN;
        if is_gap { 0.0 } else { self.straight / self.length }
    }
}
