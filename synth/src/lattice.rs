//! A drawing board of 0.1 m cells on which rooms are painted without gap or overlap, and traced as rings.

use planform_sdk::Point;
use std::collections::BTreeMap;

/// Side of one cell, metres.
pub(crate) const CELL: f64 = 0.1;

/// Cells `x0..x1` by `y0..y1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Rect {
    pub(crate) x0: i32,
    pub(crate) y0: i32,
    pub(crate) x1: i32,
    pub(crate) y1: i32,
}

impl Rect {
    pub(crate) const fn new(x0: i32, y0: i32, x1: i32, y1: i32) -> Self {
        Self { x0, y0, x1, y1 }
    }

    pub(crate) const fn width(self) -> i32 {
        self.x1 - self.x0
    }

    pub(crate) const fn height(self) -> i32 {
        self.y1 - self.y0
    }

    fn cells(self) -> impl Iterator<Item = (i32, i32)> {
        (self.y0..self.y1).flat_map(move |y| (self.x0..self.x1).map(move |x| (x, y)))
    }
}

/// A closed chain of lattice corners, the interior to its left.
pub(crate) type LatticeRing = Vec<(i32, i32)>;

/// The board. Label 0 is empty.
pub(crate) struct Lattice {
    width: i32,
    height: i32,
    labels: Vec<u16>,
}

impl Lattice {
    pub(crate) fn new(width: i32, height: i32) -> Self {
        Self { width, height, labels: vec![0; (width.max(0) as usize) * (height.max(0) as usize)] }
    }

    fn index(&self, x: i32, y: i32) -> Option<usize> {
        let inside = (0..self.width).contains(&x) && (0..self.height).contains(&y);
        inside.then(|| y as usize * self.width as usize + x as usize)
    }

    /// The label of a cell; off the board nothing is empty, so that nothing is painted there.
    pub(crate) fn label(&self, x: i32, y: i32) -> u16 {
        self.index(x, y).map_or(u16::MAX, |i| self.labels[i])
    }

    /// Whether no cell of the rectangle is painted.
    pub(crate) fn is_empty(&self, rect: Rect) -> bool {
        rect.cells().all(|(x, y)| self.label(x, y) == 0)
    }

    /// Changes the label `from` to `to` inside the rectangle.
    pub(crate) fn repaint(&mut self, rect: Rect, from: u16, to: u16) {
        for (x, y) in rect.cells() {
            if let Some(i) = self.index(x, y).filter(|&i| self.labels[i] == from) {
                self.labels[i] = to;
            }
        }
    }

    /// Whether the label's cells within `rect` make one piece that is at least `least` cells wide everywhere, has no
    /// side shorter than that, and has no hole.
    pub(crate) fn is_sound(&self, rect: Rect, label: u16, least: i32) -> bool {
        let rings = self.trace(rect, label);
        rings.len() == 1
            && rings.iter().all(|ring| shortest_side(ring) >= least)
            && self.least_run(rect, label) >= least
    }

    fn least_run(&self, rect: Rect, label: u16) -> i32 {
        let is = |x, y| self.label(x, y) == label;
        let rows = (rect.y0..rect.y1).map(|y| least_run((rect.x0..rect.x1).map(|x| is(x, y))));
        let columns = (rect.x0..rect.x1).map(|x| least_run((rect.y0..rect.y1).map(|y| is(x, y))));
        rows.chain(columns).min().unwrap_or(0)
    }

    /// The rings around the label's cells within `rect`: corners only, exteriors counter-clockwise, holes clockwise.
    pub(crate) fn trace(&self, rect: Rect, label: u16) -> Vec<LatticeRing> {
        let mut steps = self.boundary(rect, label);
        let mut rings = Vec::new();
        while let Some((&start, _)) = steps.first_key_value() {
            rings.push(corners(&take_ring(&mut steps, start)));
        }
        rings
    }

    /// Unit steps along the boundary, the label to their left, by their start.
    fn boundary(&self, rect: Rect, label: u16) -> BTreeMap<(i32, i32), Vec<(i32, i32)>> {
        let mut steps: BTreeMap<(i32, i32), Vec<(i32, i32)>> = BTreeMap::new();
        for (x, y) in rect.cells().filter(|&(x, y)| self.label(x, y) == label) {
            let sides = [
                ((x, y - 1), (x, y), (x + 1, y)),
                ((x + 1, y), (x + 1, y), (x + 1, y + 1)),
                ((x, y + 1), (x + 1, y + 1), (x, y + 1)),
                ((x - 1, y), (x, y + 1), (x, y)),
            ];
            for ((nx, ny), from, to) in sides {
                if self.label(nx, ny) != label {
                    steps.entry(from).or_default().push(to);
                }
            }
        }
        steps
    }
}

fn least_run(cells: impl Iterator<Item = bool>) -> i32 {
    let mut least = i32::MAX;
    let mut run = 0;
    for inside in cells.chain([false]) {
        if inside {
            run += 1;
        } else if run > 0 {
            least = least.min(run);
            run = 0;
        }
    }
    least
}

fn shortest_side(ring: &[(i32, i32)]) -> i32 {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).map(|(a, b)| (a.0 - b.0).abs() + (a.1 - b.1).abs()).min().unwrap_or(0)
}

fn take_ring(steps: &mut BTreeMap<(i32, i32), Vec<(i32, i32)>>, start: (i32, i32)) -> LatticeRing {
    let mut ring = vec![start];
    let mut at = start;
    while let Some(next) = steps.get_mut(&at).and_then(Vec::pop) {
        if steps.get(&at).is_some_and(Vec::is_empty) {
            steps.remove(&at);
        }
        if next == start {
            break;
        }
        ring.push(next);
        at = next;
    }
    ring
}

fn corners(ring: &[(i32, i32)]) -> LatticeRing {
    let n = ring.len();
    let turns = |i: usize| {
        let (a, b, c) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
        (b.0 - a.0, b.1 - a.1) != (c.0 - b.0, c.1 - b.1)
    };
    (0..n).filter(|&i| turns(i)).map(|i| ring[i]).collect()
}

/// A lattice corner in metres. Divides, since 3 * 0.1 is not 0.3.
pub(crate) fn metres((x, y): (i32, i32)) -> Point {
    Point::new(f64::from(x) / 10.0, f64::from(y) / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn board() -> (Lattice, Rect) {
        (Lattice::new(20, 20), Rect::new(0, 0, 20, 20))
    }

    #[test]
    fn traces_an_l_shape() {
        let (mut lattice, all) = board();
        lattice.repaint(Rect::new(2, 2, 10, 6), 0, 1);
        lattice.repaint(Rect::new(2, 6, 6, 12), 0, 1);
        assert_eq!(lattice.trace(all, 1), [vec![(2, 2), (10, 2), (10, 6), (6, 6), (6, 12), (2, 12)]]);
        assert!(lattice.is_sound(all, 1, 4));
        assert!(!lattice.is_sound(all, 1, 5));
    }

    #[test]
    fn a_hole_or_a_second_piece_is_not_sound() {
        let (mut lattice, all) = board();
        lattice.repaint(Rect::new(0, 0, 12, 12), 0, 1);
        lattice.repaint(Rect::new(5, 5, 7, 7), 1, 2);
        assert_eq!(lattice.trace(all, 1).len(), 2);
        assert!(!lattice.is_sound(all, 1, 1));
        assert!(lattice.is_sound(all, 2, 2));
        lattice.repaint(Rect::new(14, 14, 16, 16), 0, 2);
        assert!(!lattice.is_sound(all, 2, 1));
    }

    #[test]
    fn off_the_board_nothing_is_empty() {
        let (lattice, all) = board();
        assert!(lattice.is_empty(all));
        assert!(!lattice.is_empty(Rect::new(-1, 0, 3, 3)));
    }
}
