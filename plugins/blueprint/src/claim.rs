//! Whether a document is a drawing: by its first bytes, and for pictures, which may be robots' maps as well, by a look at
//! the whole.

use crate::inputs::{self, Kind};
use crate::recognise;
use image::DynamicImage;
use image::ImageFormat;
use planform_sdk::{Confidence, Kept, Probe, Source};

/// How sure the adapter is by the first bytes and the name.
pub fn probe(probe: &Probe<'_>) -> Confidence {
    match inputs::kind(probe.path, probe.head) {
        Some(Kind::Pdf) => Confidence::because(95, "a PDF by its first bytes"),
        Some(Kind::Svg) => Confidence::because(90, "an SVG drawing by its first bytes"),
        Some(Kind::Dxf) => Confidence::because(90, "a DXF drawing by its first lines"),
        // Only robots save their maps in these formats.
        Some(Kind::Picture(ImageFormat::Pnm)) | None => Confidence::no(),
        Some(Kind::Picture(_)) => Confidence::because(55, "a picture, which may be a drawing"),
    }
}

/// How sure the adapter is of a picture by all of it. Keeps the picture for others.
pub fn look(source: &Source, kept: &mut Kept) -> Option<Confidence> {
    let Kind::Picture(_) = inputs::kind(&source.path, &source.bytes)? else { return None };
    let picture = inputs::glance(source).ok()?;
    let judgement = recognise::is_drawing(&picture);
    kept.put::<DynamicImage>(picture);
    Some(Confidence::because(judgement.percent, format!("it shows {}", judgement.reason)))
}
