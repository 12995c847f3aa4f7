//! Leads lines through the nodes that lie on them.

use crate::grain::Grain;
use std::collections::BTreeSet;

/// How far a node may lie off a line that is led through it, millimetres: more than the rounding of two grains.
pub const TOLERANCE: f64 = 2.0;

/// All nodes of a map, by their x.
pub struct Nodes(BTreeSet<Grain>);

impl Nodes {
    /// These nodes.
    pub fn new(nodes: impl IntoIterator<Item = Grain>) -> Self {
        Self(nodes.into_iter().collect())
    }

    /// The closed ring through every node that lies on it; its first node is not repeated.
    pub fn ring(&self, corners: &[Grain]) -> Vec<Grain> {
        let ends = corners.iter().copied().cycle().skip(1);
        let mut ring: Vec<Grain> = corners.iter().zip(ends).flat_map(|(&a, b)| self.leg(a, b)).collect();
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }

    /// The line through every node that lies on it.
    pub fn line(&self, [a, b]: [Grain; 2]) -> Vec<Grain> {
        let mut line = self.leg(a, b);
        line.push(b);
        line.dedup();
        line
    }

    /// The nodes from `a` up to, but without, `b`.
    fn leg(&self, a: Grain, b: Grain) -> Vec<Grain> {
        let margin = TOLERANCE as i64;
        let west = Grain { x: a.x.min(b.x) - margin, y: i64::MIN };
        let east = Grain { x: a.x.max(b.x) + margin, y: i64::MAX };
        let mut on_it: Vec<(f64, Grain)> = self.0.range(west..=east).filter_map(|&p| on(p, a, b)).collect();
        on_it.sort_by(|p, q| p.0.total_cmp(&q.0));
        std::iter::once(a).chain(on_it.into_iter().map(|(_, p)| p)).collect()
    }
}

/// How far along the segment the node lies, if it lies on it and between its ends.
fn on(p: Grain, a: Grain, b: Grain) -> Option<(f64, Grain)> {
    let length = b.beside(a, b)?.0;
    let (along, off) = p.beside(a, b)?;
    (p != a && p != b && along > 0.0 && along < length && off <= TOLERANCE).then_some((along, p))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grains<const N: usize>(points: [[i64; 2]; N]) -> Vec<Grain> {
        points.map(|[x, y]| Grain { x, y }).to_vec()
    }

    #[test]
    fn a_ring_goes_through_what_lies_on_it_and_through_nothing_else() {
        let square = grains([[0, 0], [1000, 0], [1000, 1000], [0, 1000]]);
        let beside = grains([[-1, 0], [-500, 0], [500, 500]]);
        let on_it = grains([[500, 1], [250, -2], [1000, 700], [300, 1000], [600, 1000]]);
        let nodes = Nodes::new(square.iter().chain(&beside).chain(&on_it).copied());
        let bottom = [[0, 0], [250, -2], [500, 1]];
        let rest = [[1000, 0], [1000, 700], [1000, 1000], [600, 1000], [300, 1000], [0, 1000]];
        let expected = [grains(bottom), grains(rest)].concat();
        assert_eq!(nodes.ring(&square), expected);
    }

    #[test]
    fn a_line_without_length_is_one_node() {
        let [a] = [Grain { x: 1, y: 2 }];
        assert_eq!(Nodes::new([a]).line([a, a]), [a]);
        assert_eq!(Nodes::new([a]).ring(&[a, a, a]), [a]);
    }
}
