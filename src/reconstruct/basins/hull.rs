//! Convex hulls of cells.

/// A convex hull: its corners counter-clockwise, in cells.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Hull {
    corners: Vec<(f64, f64)>,
}

/// A row of cells: its edges, in cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Its middle.
    pub row: f64,
    /// The left edge of its first cell.
    pub from: f64,
    /// The right edge of its last cell.
    pub to: f64,
}

impl Hull {
    /// The hull of some points: Andrew's monotone chain, 1979.
    pub fn of(mut points: Vec<(f64, f64)>) -> Self {
        points.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        points.dedup();
        if points.len() < 3 {
            return Self { corners: points };
        }
        let mut corners = chain(points.iter());
        corners.pop();
        let mut upper = chain(points.iter().rev());
        upper.pop();
        corners.append(&mut upper);
        Self { corners }
    }

    /// The hull of rows of cells, rising; each with the edges of its first and its last cell.
    pub fn of_rows(rows: &[Row]) -> Self {
        // Along the rows nothing has to be sorted, and few corners are left.
        let ends = rows.iter().flat_map(|r| {
            let (low, high) = (r.row - 0.5, r.row + 0.5);
            [(low, r.from), (low, r.to), (high, r.from), (high, r.to)]
        });
        let mut ends: Vec<(f64, f64)> = ends.collect();
        // The upper edge of a row is the lower one of the next.
        for pair in 0..(ends.len() / 4).saturating_sub(1) {
            let edge = 4 * pair + 2;
            if ends[edge].0 == ends[edge + 2].0 {
                ends[edge..edge + 4].sort_by(|a, b| a.1.total_cmp(&b.1));
            }
        }
        let corners = chain(ends.iter()).into_iter().chain(chain(ends.iter().rev()));
        Self::of(corners.map(|(row, column)| (column, row)).collect())
    }

    /// The hull of both.
    pub fn join(&self, other: &Self) -> Self {
        Self::of(self.corners.iter().chain(&other.corners).copied().collect())
    }

    /// Its area, in cells.
    pub fn area(&self) -> f64 {
        let n = self.corners.len();
        let cross = |i: usize| {
            let (a, b) = (self.corners[i], self.corners[(i + 1) % n]);
            a.0 * b.1 - a.1 * b.0
        };
        (0..n).map(cross).sum::<f64>() / 2.0
    }

    /// Its length in a direction, in cells.
    pub fn extent(&self, angle: f64) -> f64 {
        let (sin, cos) = angle.sin_cos();
        let along = self.corners.iter().map(|c| c.0 * cos + c.1 * sin);
        let (low, high) = along.fold((f64::MAX, f64::MIN), |(l, h), t| (l.min(t), h.max(t)));
        (high - low).max(0.0)
    }
}

/// The lower chain of points that are sorted by their first coordinate.
fn chain<'a>(points: impl Iterator<Item = &'a (f64, f64)>) -> Vec<(f64, f64)> {
    let mut chain: Vec<(f64, f64)> = Vec::new();
    for &p in points {
        while let [.., a, b] = chain[..]
            && (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0) <= 0.0
        {
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_with_points_inside() {
        let hull = Hull::of(vec![
            (0.0, 0.0),
            (2.0, 0.0),
            (1.0, 1.0),
            (2.0, 2.0),
            (0.0, 2.0),
            (1.0, 0.0),
            (0.5, 1.5),
        ]);
        assert_eq!(hull.corners.len(), 4);
        assert_eq!((hull.area(), hull.extent(0.0)), (4.0, 2.0));
        assert!((hull.extent(std::f64::consts::FRAC_PI_4) - 8f64.sqrt()).abs() < 1e-9);
        assert_eq!(hull.join(&Hull::of(vec![(4.0, 0.0), (4.0, 2.0)])).area(), 8.0);
    }

    proptest::proptest! {
        #[test]
        fn rows_have_the_hull_of_their_corners(
            cells in proptest::collection::btree_map(0..12u8, (0..20u8, 1..20u8), 0..12)
        ) {
            let row = |(row, (from, length)): (&u8, &(u8, u8))| {
                let from = f64::from(*from);
                Row { row: f64::from(*row), from, to: from + f64::from(*length) }
            };
            let rows: Vec<Row> = cells.iter().map(row).collect();
            let corners = rows.iter().flat_map(|r| {
                let (low, high) = (r.row - 0.5, r.row + 0.5);
                [(r.from, low), (r.to, low), (r.from, high), (r.to, high)]
            });
            proptest::prop_assert_eq!(Hull::of_rows(&rows), Hull::of(corners.collect()));
        }
    }

    #[test]
    fn few_points_have_no_area() {
        assert_eq!(Hull::of(vec![]).area(), 0.0);
        assert_eq!(Hull::of(vec![(1.0, 1.0), (1.0, 1.0)]).area(), 0.0);
        assert_eq!(Hull::of(vec![(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]).area(), 0.0);
    }
}
