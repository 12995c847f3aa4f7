//! Scale from doors: most openings are about as wide.

use super::Estimate;
use crate::found::SheetSymbol;

/// The usual clear opening of a single leaf, metres.
const OPENING: f64 = 0.9;

/// Metres per pixel by the median width of the single doors.
pub fn estimate(symbols: &[SheetSymbol]) -> Option<Estimate> {
    let mut widths: Vec<f64> = symbols.iter().filter(|s| s.kind == "door").map(|s| s.width).collect();
    widths.sort_by(f64::total_cmp);
    let median = *widths.get(widths.len() / 2)?;
    let confidence = if widths.len() < 3 { 0.2 } else { 0.45 };
    let source = format!("door widths ({} taken for {OPENING} m)", widths.len());
    (median > 0.0).then(|| Estimate { metres_per_pixel: OPENING / median, source, confidence })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn door(width: f64) -> SheetSymbol {
        let kind = "door".into();
        SheetSymbol { kind, centre: [0.0; 2], angle: 0.0, width, height: 5.0, score: 1.0, leaves: vec![] }
    }

    #[test]
    fn the_median_door_is_ninety_centimetres_wide() {
        let found = estimate(&[door(45.0), door(44.0), door(90.0)]).unwrap();
        assert!((found.metres_per_pixel - 0.02).abs() < 1e-9);
        assert_eq!(estimate(&[]), None);
    }
}
