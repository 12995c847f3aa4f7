//! The outline of what was seen: the borders of the free space (Suzuki and Abe, "Topological Structural Analysis of
//! Digitized Binary Images by Border Following", 1985), taken as the area that they enclose.
//!
//! A border encloses the walls and obstacles in its midst, but not a courtyard: a hole too large for those lies
//! outside.

use super::raster::Mask;
use super::runs::Components;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What belongs to the inner area.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Contour {
    /// The threshold q of the paper: a cell of this occupancy or more is an obstacle. Percent; 41 is grey 150 of 255.
    pub obstacle: u8,
    /// A cell of this occupancy or less is free. Percent; 10 is grey 230 of 255.
    pub free: u8,
    /// A free region smaller than this is no part of the building. Square metres.
    pub min_area: f64,
    /// A hole in a free region up to this size belongs to the inner area. Square metres.
    pub max_hole: f64,
}

impl Default for Contour {
    fn default() -> Self {
        Self { obstacle: 41, free: 10, min_area: 1.0, max_hole: 2.0 }
    }
}

/// The inner area. `free` are the free cells, `resolution` in metres per cell.
pub fn inner_area(free: &Mask, resolution: f64, params: &Contour) -> Mask {
    let cell = resolution * resolution;
    let regions = free.components(false);
    let large = keep(&regions, |size| size as f64 * cell >= params.min_area);
    let free = free.with_bits(large);
    let holes = free.with_bits(free.bits().iter().map(|b| !b).collect()).components(true);
    let outside = outside(&free, &holes);
    let small = keep(&holes, |size| size as f64 * cell <= params.max_hole);
    let bits = (0..free.bits().len())
        .map(|i| free.bits()[i] || (small[i] && !outside[holes.label[i] as usize]))
        .collect();
    free.with_bits(bits)
}

fn keep(components: &Components, large: impl Fn(usize) -> bool) -> Vec<bool> {
    components.label.iter().map(|&l| l != Components::NONE && large(components.sizes[l as usize])).collect()
}

/// For each component whether it touches the border of the grid.
fn outside(mask: &Mask, components: &Components) -> Vec<bool> {
    let (width, height) = (mask.width(), mask.height());
    let rows = (0..width).flat_map(|c| [c, (height - 1) * width + c]);
    let columns = (0..height).flat_map(|r| [r * width, r * width + width - 1]);
    let mut touches = vec![false; components.sizes.len()];
    for label in rows.chain(columns).map(|i| components.label[i]).filter(|&l| l != Components::NONE) {
        touches[label as usize] = true;
    }
    touches
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::mask;
    use super::*;

    #[test]
    fn small_holes_are_inside_and_courtyards_not() {
        let free = mask(&[
            ".........",
            ".#######.",
            ".#.#...#.",
            ".###...#.",
            ".###...#.",
            ".#######.",
            ".........",
        ]);
        let params = Contour { min_area: 2.0, max_hole: 2.0, ..Contour::default() };
        let inner = inner_area(&free, 1.0, &params);
        assert!(inner.get(2, 4));
        assert!(!inner.get(5, 3) && !inner.get(0, 0));
    }

    #[test]
    fn specks_are_no_building() {
        let free = mask(&["#....", "..###", "..###"]);
        let inner = inner_area(&free, 1.0, &Contour { min_area: 2.0, ..Contour::default() });
        assert_eq!(inner.count(), 6);
    }
}
