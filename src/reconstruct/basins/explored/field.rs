//! The raster seen along a direction.

use super::super::super::straight::{Labelled, floor};
use planform_sdk::Point;

/// Axes turned by an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    sin: f64,
    cos: f64,
}

/// A side of a box in a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Side {
    /// 0 is along the first axis, 1 along the second one.
    pub axis: usize,
    /// Whether it is the upper one.
    pub up: bool,
}

impl Side {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self { axis: 0, up: false },
        Self { axis: 0, up: true },
        Self { axis: 1, up: false },
        Self { axis: 1, up: true },
    ];

    /// 1 outwards if it is the upper one, or -1.
    pub fn sense(self) -> f64 {
        if self.up { 1.0 } else { -1.0 }
    }

    /// Its place in a table of all sides.
    pub fn index(self) -> usize {
        2 * self.axis + usize::from(self.up)
    }
}

impl Frame {
    /// Axes turned counter-clockwise, radians.
    pub fn new(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin, cos }
    }

    /// Coordinates along the axes.
    pub fn of(self, p: Point) -> [f64; 2] {
        [p.x * self.cos + p.y * self.sin, p.y * self.cos - p.x * self.sin]
    }

    /// The point with these coordinates.
    pub fn point(self, [u, v]: [f64; 2]) -> Point {
        Point::new(u * self.cos - v * self.sin, u * self.sin + v * self.cos)
    }
}

/// What a place shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// A room, by its label.
    Room(u32),
    /// An obstacle.
    Obstacle,
    /// Nothing that is known, or the outside of the grid.
    Unknown,
}

/// A raster with labels that change, seen in a frame.
pub struct Field<'a> {
    pub input: &'a Labelled<'a>,
    pub label: &'a [u32],
    pub frame: Frame,
}

impl Field<'_> {
    /// The middle of a cell in the frame.
    pub fn middle(&self, cell: usize) -> [f64; 2] {
        self.frame.of(middle(self.input, cell))
    }

    /// What a cell shows.
    pub fn cell(&self, column: i64, row: i64) -> Shown {
        let Some(i) = self.input.free.index(column, row) else { return Shown::Unknown };
        match self.label[i] {
            0 if self.input.obstacles.bits()[i] => Shown::Obstacle,
            0 => Shown::Unknown,
            l => Shown::Room(l),
        }
    }

    /// What a place in the frame shows.
    pub fn at(&self, place: [f64; 2]) -> Shown {
        let p = self.frame.point(place);
        let cell = |v: f64| floor(v / self.input.resolution);
        self.cell(cell(p.x), cell(p.y))
    }

    /// How far it is unknown from a place outwards, up to `most` metres, and what is there.
    pub fn depth(&self, mut place: [f64; 2], side: Side, most: f64) -> (f64, Shown) {
        let step = self.input.resolution / 2.0;
        let count = (most / step).ceil() as usize;
        for i in 0..count {
            place[side.axis] += side.sense() * step;
            let shown = self.at(place);
            if shown != Shown::Unknown {
                return (i as f64 * step, shown);
            }
        }
        (most, Shown::Unknown)
    }
}

/// The middle of a cell, metres.
pub fn middle(input: &Labelled<'_>, cell: usize) -> Point {
    let width = input.free.width();
    let at = |v: usize| (v as f64 + 0.5) * input.resolution;
    Point::new(at(cell % width), at(cell / width))
}
