//! Which of many things lie near a place, without a look at all of them.

use super::plane::Vec2;
use std::collections::BTreeMap;

/// The places of things, in square cells.
pub struct Near {
    cell: f64,
    cells: BTreeMap<[i64; 2], Vec<usize>>,
}

impl Near {
    /// Things at these places that are looked for within `reach`.
    pub fn of(places: impl Iterator<Item = Vec2>, reach: f64) -> Self {
        let mut near = Self { cell: reach.max(1.0), cells: BTreeMap::new() };
        for (i, place) in places.enumerate() {
            near.cells.entry(near.cell_of(place)).or_default().push(i);
        }
        near
    }

    fn cell_of(&self, place: Vec2) -> [i64; 2] {
        place.map(|v| (v / self.cell).floor() as i64)
    }

    /// The numbers of all things within reach of a place, and of some beyond, in rising order.
    pub fn around(&self, place: Vec2) -> Vec<usize> {
        let [x, y] = self.cell_of(place);
        let cells =
            (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x.saturating_add(dx), y.saturating_add(dy)]));
        let mut found: Vec<usize> = cells.filter_map(|c| self.cells.get(&c)).flatten().copied().collect();
        found.sort_unstable();
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_within_reach_are_found_and_none_far_away() {
        let places = [[5.0, 5.0], [14.0, 5.0], [-3.0, 5.0], [40.0, 5.0]];
        let near = Near::of(places.into_iter(), 10.0);
        assert_eq!(near.around([5.0, 5.0]), [0, 1, 2]);
        assert_eq!(near.around([41.0, -2.0]), [3]);
        assert!(near.around([f64::NAN, 1e300]).is_empty());
    }
}
