//! What is drawn, and how one entity is written.

use crate::layer::Layer;
use crate::pairs::{Handle, Pairs};
use crate::text::{one_line, without_codes};
use planform_sdk::{DoorLeaf, Point, RoomId, Segment};

/// The application under which extended data are registered.
pub const APPLICATION: &str = "PLANFORM";

/// The most bytes of a text in extended data.
const DATA_TEXT_LIMIT: usize = 255;

/// Width of a letter for a height of 1, generously.
pub const LETTER_WIDTH: f64 = 0.85;

/// One thing drawn: where, what, and what is known of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Entity {
    pub layer: Layer,
    pub shape: Shape,
    /// Keys and values, written as extended data.
    pub data: Vec<(&'static str, Value)>,
}

/// The geometry of an entity, metres.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A closed polyline; the first point is not repeated.
    Ring(Vec<Point>),
    Line(Segment),
    /// The way of a door's leaf: an arc about the hinge.
    Swing(DoorLeaf),
    /// A block, stretched to this width and height.
    Insert {
        block: &'static str,
        middle: Point,
        /// Radians, counter-clockwise from the x axis.
        yaw: f64,
        size: [f64; 2],
    },
    /// One line of text, centred.
    Text {
        middle: Point,
        /// Radians, counter-clockwise from the x axis.
        yaw: f64,
        height: f64,
        content: String,
    },
}

/// A value of extended data.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Word(String),
    Whole(u32),
    Real(f64),
}

impl From<&str> for Value {
    fn from(word: &str) -> Self {
        Self::Word(word.into())
    }
}

impl From<RoomId> for Value {
    fn from(number: RoomId) -> Self {
        Self::Whole(number)
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Real(number)
    }
}

impl Shape {
    /// Points whose bounds hold the shape; those of a text are an estimate, since its font is the reader's.
    pub fn corners(&self) -> Vec<Point> {
        match self {
            Self::Ring(points) => points.clone(),
            Self::Line(s) => vec![s.a, s.b],
            Self::Swing(leaf) => (0..=8).map(|i| leaf.at(f64::from(i) / 8.0)).collect(),
            Self::Insert { middle: m, size: [width, height], .. } => {
                let reach = width.hypot(*height) / 2.0;
                vec![Point::new(m.x - reach, m.y - reach), Point::new(m.x + reach, m.y + reach)]
            }
            Self::Text { middle: m, height, content, .. } => {
                let reach = height * LETTER_WIDTH * content.chars().count().max(1) as f64 / 2.0;
                vec![Point::new(m.x - reach, m.y - reach), Point::new(m.x + reach, m.y + reach)]
            }
        }
    }
}

impl Entity {
    /// Writes the entity as a part of the block record `owner`.
    pub fn write(&self, pairs: &mut Pairs, owner: Handle) {
        match &self.shape {
            Shape::Ring(points) if pairs.version().has_objects() => {
                self.write_light_ring(pairs, owner, points)
            }
            Shape::Ring(points) => self.write_heavy_ring(pairs, owner, points),
            Shape::Line(segment) => self.write_line(pairs, owner, segment),
            Shape::Swing(leaf) => self.write_arc(pairs, owner, leaf),
            Shape::Insert { block, middle, yaw, size } => {
                self.begin(pairs, "INSERT", owner);
                write_insert(pairs, block, *middle, *yaw, *size);
                self.write_data(pairs);
            }
            Shape::Text { middle, yaw, height, content } => {
                self.begin(pairs, "TEXT", owner);
                write_text(pairs, *middle, *yaw, *height, content);
                self.write_data(pairs);
            }
        }
    }

    fn begin(&self, pairs: &mut Pairs, kind: &str, owner: Handle) {
        pairs.word(0, kind);
        let handle = pairs.new_handle();
        pairs.handle(5, handle);
        pairs.owner(owner);
        pairs.subclass("AcDbEntity");
        pairs.word(8, self.layer.style().name);
    }

    fn write_light_ring(&self, pairs: &mut Pairs, owner: Handle, points: &[Point]) {
        self.begin(pairs, "LWPOLYLINE", owner);
        pairs.subclass("AcDbPolyline");
        pairs.integer(90, points.len() as i64);
        pairs.integer(70, 1);
        points.iter().for_each(|&p| pairs.point_2d(10, p));
        self.write_data(pairs);
    }

    fn write_heavy_ring(&self, pairs: &mut Pairs, owner: Handle, points: &[Point]) {
        self.begin(pairs, "POLYLINE", owner);
        pairs.integer(66, 1);
        pairs.point_3d(10, Point::default());
        pairs.integer(70, 1);
        self.write_data(pairs);
        for &p in points {
            self.begin(pairs, "VERTEX", owner);
            pairs.point_3d(10, p);
        }
        self.begin(pairs, "SEQEND", owner);
    }

    fn write_line(&self, pairs: &mut Pairs, owner: Handle, segment: &Segment) {
        self.begin(pairs, "LINE", owner);
        pairs.subclass("AcDbLine");
        pairs.point_3d(10, segment.a);
        pairs.point_3d(11, segment.b);
        self.write_data(pairs);
    }

    /// Arcs run counter-clockwise.
    fn write_arc(&self, pairs: &mut Pairs, owner: Handle, leaf: &DoorLeaf) {
        self.begin(pairs, "ARC", owner);
        pairs.subclass("AcDbCircle");
        pairs.point_3d(10, leaf.hinge);
        pairs.real(40, leaf.length());
        pairs.subclass("AcDbArc");
        let [closed, open] = [0.0, 1.0].map(|share| Segment::new(leaf.hinge, leaf.at(share)).angle());
        let [from, to] = if leaf.swing() > 0.0 { [closed, open] } else { [open, closed] };
        pairs.real(50, degrees(from));
        pairs.real(51, degrees(to));
        self.write_data(pairs);
    }

    /// Extended data; what stands in a block has none.
    fn write_data(&self, pairs: &mut Pairs) {
        if self.data.is_empty() {
            return;
        }
        pairs.word(1001, APPLICATION);
        for (key, value) in &self.data {
            pairs.word(1000, key);
            match value {
                Value::Word(text) => pairs.text(1000, &one_line(text), DATA_TEXT_LIMIT),
                // Group 1071 is signed, of 32 bits.
                Value::Whole(n) if i32::try_from(*n).is_ok() => pairs.integer(1071, i64::from(*n)),
                Value::Whole(n) => pairs.word(1000, &n.to_string()),
                Value::Real(v) => pairs.real(1040, *v),
            }
        }
    }
}

fn write_text(pairs: &mut Pairs, middle: Point, yaw: f64, height: f64, content: &str) {
    pairs.subclass("AcDbText");
    pairs.point_3d(10, middle);
    pairs.real(40, height);
    let limit = pairs.version().text_limit();
    pairs.text(1, &without_codes(&one_line(content)), limit);
    pairs.real(50, degrees(yaw));
    pairs.word(7, "Standard");
    // Centred in both directions about the second point.
    pairs.integer(72, 1);
    pairs.point_3d(11, middle);
    pairs.subclass("AcDbText");
    pairs.integer(73, 2);
}

fn write_insert(pairs: &mut Pairs, block: &str, middle: Point, yaw: f64, [width, height]: [f64; 2]) {
    pairs.subclass("AcDbBlockReference");
    pairs.word(2, block);
    pairs.point_3d(10, middle);
    pairs.real(41, width);
    pairs.real(42, height);
    pairs.real(43, 1.0);
    pairs.real(50, degrees(yaw));
}

/// An angle in radians as the format has it.
fn degrees(angle: f64) -> f64 {
    angle.to_degrees().rem_euclid(360.0)
}
