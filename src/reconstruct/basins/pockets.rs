//! Cabinets: furniture that stands against a wall.
//!
//! A robot sees the front and the sides of a cabinet, never what is in it: a pocket of unknown cells, closed in by a
//! thin outline. It stands in the room from which it is seen, and that room's floor goes on beneath it. What is thinner
//! than a cabinet is the inside of a hollow wall.

use super::super::raster::Mask;
use super::super::runs::Parts;
use super::space::Furniture;
use std::collections::BTreeMap;

/// The thickest outline of a cabinet, metres.
const OUTLINE: f64 = 0.15;

/// A cabinet has a cell this far from its outline, metres.
const DEPTH: f64 = 0.15;

/// Gives the cells of cabinets, with their outlines, to the rooms that they stand in. `closed` are the cells neither
/// free nor occupied; `label` holds the room of every cell, 0 for none.
pub fn fill(label: &mut [u32], closed: &Mask, resolution: f64, furniture: &Furniture) {
    let parts = Parts::of(closed.bits(), closed.width(), true, false);
    let mut cells: Vec<Vec<usize>> = vec![Vec::new(); parts.sizes.len()];
    let most = furniture.area / (resolution * resolution);
    for (run, part) in parts.runs.iter().filter(|(_, part)| parts.sizes[*part as usize] as f64 <= most) {
        cells[*part as usize].extend(run.cells(closed.width()).filter(|&i| label[i] == 0));
    }
    let field = Field { width: closed.width(), outline: (OUTLINE / resolution).ceil().max(1.0) as u32 };
    let depth = (DEPTH / resolution).round().max(1.0) as usize;
    for pocket in cells.iter().filter(|c| !c.is_empty()) {
        if field.extent(pocket) * resolution < furniture.extent && field.is_deep(pocket, depth) {
            field.give(pocket, label);
        }
    }
}

struct Field {
    width: usize,
    /// Steps through an outline.
    outline: u32,
}

impl Field {
    /// The four cells beside one, as far as there are cells.
    fn around(&self, cell: usize, count: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, column) = (self.width, cell % self.width);
        let steps = [
            (column > 0).then(|| cell - 1),
            (column + 1 < width).then_some(cell + 1),
            cell.checked_sub(width),
            Some(cell + width).filter(|&c| c < count),
        ];
        steps.into_iter().flatten()
    }

    /// The longer side of the box around some cells, in cells.
    fn extent(&self, cells: &[usize]) -> f64 {
        let side = |of: fn(usize, usize) -> usize| {
            let along = cells.iter().map(|&c| of(c, self.width));
            let (low, high) = along.fold((usize::MAX, 0), |(l, h), v| (l.min(v), h.max(v)));
            (high - low + 1) as f64
        };
        side(|c, w| c % w).max(side(|c, w| c / w))
    }

    /// Whether some cell is left when the outermost cells are taken away this many times.
    fn is_deep(&self, cells: &[usize], times: usize) -> bool {
        let mut left: Vec<usize> = cells.to_vec();
        for _ in 0..times {
            let inside = |c: usize| left.binary_search(&c).is_ok();
            left = left
                .iter()
                .copied()
                .filter(|&c| self.around(c, usize::MAX).filter(|&n| inside(n)).count() == 4)
                .collect();
        }
        !left.is_empty()
    }

    /// Labels a pocket and its outline with the room that is seen most through the outline.
    fn give(&self, pocket: &[usize], label: &mut [u32]) {
        let reached = self.reach(pocket.iter().copied(), |c| label[c] == 0, label.len());
        let mut seen: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for &c in reached.keys() {
            for beside in self.around(c, label.len()).filter(|&b| label[b] != 0) {
                seen.entry(label[beside]).or_default().push(beside);
            }
        }
        let best = seen.into_iter().max_by_key(|(room, cells)| (cells.len(), std::cmp::Reverse(*room)));
        let Some((room, cells)) = best else { return };
        let between = self.reach(cells.into_iter(), |c| reached.contains_key(&c), label.len());
        for c in between.into_keys().filter(|c| reached.contains_key(c)).chain(pocket.iter().copied()) {
            label[c] = room;
        }
    }

    /// The cells within an outline's thickness of some cells, over cells that may be entered; with their distance.
    fn reach(
        &self,
        from: impl Iterator<Item = usize>,
        may: impl Fn(usize) -> bool,
        count: usize,
    ) -> BTreeMap<usize, u32> {
        let mut distance: BTreeMap<usize, u32> = from.map(|c| (c, 0)).collect();
        let mut front: Vec<usize> = distance.keys().copied().collect();
        for d in 1..=self.outline {
            let mut next = Vec::new();
            for c in front {
                for n in self.around(c, count).filter(|&n| may(n)) {
                    distance.entry(n).or_insert_with(|| {
                        next.push(n);
                        d
                    });
                }
            }
            front = next;
        }
        distance
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::raster::tests::mask;
    use super::*;

    /// `.` is free, `#` occupied, `?` unknown; the label of free cells is 1 in the left half, 2 in the right one.
    fn filled(rows: &[&str]) -> Vec<String> {
        let closed: Vec<String> = rows.iter().map(|r| r.replace(['.', '#'], " ").replace('?', "#")).collect();
        let closed = mask(&closed.iter().map(String::as_str).collect::<Vec<_>>());
        let width = rows[0].len();
        let mut label: Vec<u32> = rows
            .iter()
            .rev()
            .flat_map(|r| r.bytes().enumerate())
            .map(|(c, b)| if b == b'.' { 1 + u32::from(c >= width / 2) } else { 0 })
            .collect();
        fill(&mut label, &closed, 0.1, &Furniture::default());
        let row = |r: &[u32]| r.iter().map(|l| char::from(b'0' + *l as u8)).collect();
        label.chunks(width).rev().map(row).collect()
    }

    #[test]
    fn a_cabinet_is_part_of_its_room() {
        let found = filled(&[
            "##########",
            "#????#...#",
            "#????#...#",
            "#????#...#",
            "######...#",
            "#........#",
            "##########",
        ]);
        // The room on the right sees more of it.
        assert!(found[1..4].iter().all(|r| r.starts_with("0222222")), "{found:?}");
    }

    #[test]
    fn the_inside_of_a_hollow_wall_is_no_cabinet() {
        let found = filled(&["..####..", "..#??#..", "..#??#..", "..#??#..", "..####.."]);
        assert!(found.iter().all(|r| r.contains("0000")), "{found:?}");
    }
}
