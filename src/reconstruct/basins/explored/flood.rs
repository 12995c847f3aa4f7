//! Cells that hang together.

use super::super::super::straight::Labelled;

/// Finds the cells that hang together over their sides. It remembers which cells it has been to, so that it is made once
/// for all floods of a grid.
pub struct Flood {
    width: usize,
    been: Vec<bool>,
}

impl Flood {
    /// For the cells of a grid.
    pub fn new(input: &Labelled<'_>) -> Self {
        Self { width: input.free.width(), been: vec![false; input.label.len()] }
    }

    /// The cells that hang together with some cells, over cells that may be entered; those cells included. Rising. None
    /// if `goes_on` ends it: it is told of each cell.
    pub fn run(
        &mut self,
        from: &[usize],
        may: impl Fn(usize) -> bool,
        mut goes_on: impl FnMut(usize) -> bool,
    ) -> Option<Vec<usize>> {
        let mut found = from.to_vec();
        from.iter().for_each(|&i| self.been[i] = true);
        let mut next = 0;
        let mut whole = true;
        while let Some(&at) = found.get(next).filter(|_| whole) {
            next += 1;
            whole = goes_on(at);
            for i in self.beside(at) {
                if !self.been[i] && may(i) {
                    self.been[i] = true;
                    found.push(i);
                }
            }
        }
        found.iter().for_each(|&i| self.been[i] = false);
        found.sort_unstable();
        found.dedup();
        whole.then_some(found)
    }

    fn beside(&self, at: usize) -> impl Iterator<Item = usize> + use<> {
        let (column, width, count) = (at % self.width, self.width, self.been.len());
        let left = (column > 0).then(|| at - 1);
        let right = (column + 1 < width).then_some(at + 1);
        [left, right, at.checked_sub(width), Some(at + width).filter(|&i| i < count)].into_iter().flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_where_it_may_and_no_farther() {
        let mut flood = Flood { width: 4, been: vec![false; 12] };
        let wall = [2, 6, 10];
        let may = |i: usize| !wall.contains(&i);
        assert_eq!(flood.run(&[0], may, |_| true), Some(vec![0, 1, 4, 5, 8, 9]));
        assert_eq!(flood.run(&[3], may, |_| true), Some(vec![3, 7, 11]));
        assert_eq!(flood.run(&[0], may, |i| i != 5), None);
        assert_eq!(flood.run(&[0], may, |_| true), Some(vec![0, 1, 4, 5, 8, 9]));
    }
}
