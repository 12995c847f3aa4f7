//! Scale from doors: most openings are about as wide.

use super::Estimate;
use crate::doorways::{USUAL_WIDTH, Widths};
use crate::found::SheetSymbol;

/// Metres per pixel by the median width of the single doors.
pub fn estimate(symbols: &[SheetSymbol]) -> Option<Estimate> {
    let widths = Widths::of_single(symbols)?;
    let confidence = if widths.count < 3 { 0.2 } else { 0.45 };
    let source = format!("door widths ({} taken for {USUAL_WIDTH} m)", widths.count);
    Some(Estimate { metres_per_pixel: widths.metres_per_pixel(), source, confidence })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_doors_are_surer_than_one() {
        let (kind, centre) = ("door".to_owned(), [0.0; 2]);
        let door =
            SheetSymbol { kind, centre, angle: 0.0, width: 45.0, height: 5.0, score: 1.0, leaves: vec![] };
        let one = estimate(std::slice::from_ref(&door)).unwrap();
        let three = estimate(&[door.clone(), door.clone(), door]).unwrap();
        assert!((one.metres_per_pixel - 0.02).abs() < 1e-9 && one.confidence < three.confidence);
        assert_eq!(estimate(&[]), None);
    }
}
