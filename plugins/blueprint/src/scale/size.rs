//! Whether a building is as large as buildings are.

use super::Estimate;
use crate::mask::Mask;

/// The longer side of a building, metres: from a cabin to a row of terminals.
const BUILDINGS: std::ops::RangeInclusive<f64> = 2.0..=1500.0;

/// A sentence if by this scale the building is none.
pub fn doubt(inside: &Mask, scale: &Estimate) -> Option<String> {
    let metres = longer_side(inside) as f64 * scale.metres_per_pixel;
    (!BUILDINGS.contains(&metres)).then(|| {
        format!(
            "the building would be {metres:.3} m long at {} metres per pixel ({}); give the right scale with `--set \
             metres-per-pixel`",
            scale.metres_per_pixel, scale.source
        )
    })
}

/// Pixels of the longer side of what is set.
fn longer_side(mask: &Mask) -> usize {
    let width = mask.width.max(1) as usize;
    let has_rows = mask.set.chunks(width).map(|row| row.contains(&true));
    let rows: Vec<usize> = has_rows.enumerate().filter_map(|(y, has)| has.then_some(y)).collect();
    let first = |row: &[bool]| row.iter().position(|&s| s);
    let last = |row: &[bool]| row.iter().rposition(|&s| s);
    let left = mask.set.chunks(width).filter_map(first).min();
    let right = mask.set.chunks(width).filter_map(last).max();
    let across = left.zip(right).map_or(0, |(l, r)| r + 1 - l);
    let down = rows.first().zip(rows.last()).map_or(0, |(t, b)| b + 1 - t);
    across.max(down)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_town_and_a_matchbox_are_no_buildings() {
        let mut inside = Mask::empty(300, 200);
        inside.set[10 * 300 + 20..10 * 300 + 220].fill(true);
        let by = |metres_per_pixel| Estimate { metres_per_pixel, source: "given".into(), confidence: 1.0 };
        assert_eq!(doubt(&inside, &by(0.05)), None);
        assert!(
            doubt(&inside, &by(50.0)).unwrap().contains("would be 10000.000 m long at 50 metres per pixel")
        );
        assert!(doubt(&inside, &by(0.001)).unwrap().contains("would be 0.200 m"));
        assert_eq!(longer_side(&Mask::empty(0, 0)), 0);
    }
}
