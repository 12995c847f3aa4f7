//! Tells a drawing of a building from a robot's map, where both are bare pictures.
//!
//! What surrounds the building tells them apart. Around a drawing there is paper, the lightest tone of all, or, where
//! it is inverted, the darkest, on which all else is strokes. Around a robot's map lies what the robot does not know:
//! one flat tone, be it grey, black or transparent, and within it areas that are lighter, which are free. A photo of a drawing
//! has no flat tone at all.
//!
//! Where the two cannot be told apart, the harm decides: a drawing read as a map is all scribbles, which people see at
//! once, and a map read as a drawing loses what its robot saw, which they may not see. So a flat surrounding with lighter
//! areas is a map, whatever else is there. A map whose unknown space is painted white, however, is a drawing: it shows
//! nothing else, and read as a map its surroundings would be one large room.

mod areas;
mod counts;
mod facts;
mod sample;

use facts::{Facts, Surround};
use image::DynamicImage;
use sample::Sample;

/// Whether a picture is a drawing, and how that shows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Judgement {
    /// How sure it is, from 0, a robot's map, to 100, a drawing.
    pub percent: u8,
    /// What speaks for it, to follow "because it shows".
    pub reason: String,
}

/// With more colour than this share of the picture it is a drawing: only a path or a pose may be drawn into a map.
const COLOURFUL: f64 = 0.05;

/// The least share of the picture that is free in a map.
const LEAST_FREE: f64 = 0.001;

/// The least share of what is light that lies in areas in a map; strokes and letters have none.
const IN_AREAS: f64 = 0.4;

/// Judges a picture. Takes about as long as to look at a million pixels, however large it is.
pub fn is_drawing(picture: &DynamicImage) -> Judgement {
    judge(&Facts::of(&Sample::of(picture)))
}

impl Facts {
    /// Whether what is light lies in strokes, or nothing is.
    fn is_strokes(&self) -> bool {
        self.light < LEAST_FREE || self.light_areas < IN_AREAS * self.light
    }
}

fn judge(facts: &Facts) -> Judgement {
    let told = |percent, reason: &str| Judgement { percent, reason: reason.into() };
    match facts.surround {
        Surround::Paper => told(90, "light paper around it"),
        Surround::Uneven => told(75, "no flat tone around it, as in a photo"),
        _ if facts.colour > COLOURFUL => told(90, "colours"),
        Surround::Transparent if facts.is_strokes() => told(90, "strokes on transparent paper"),
        Surround::Transparent => told(10, "free areas, and transparent unknown space around them"),
        Surround::Flat(_) if facts.page => told(80, "a sheet of light paper"),
        Surround::Flat(_) if facts.is_strokes() => told(85, "strokes on even paper"),
        Surround::Flat(_) | Surround::Inside(_) => {
            told(5, "free areas, and one flat tone around them, which is unknown space")
        }
    }
}

#[cfg(test)]
mod tests;
