//! Connected components of a picture.

/// The components of what is set.
pub struct Components {
    /// For every pixel the number of its component, from 1; 0 where nothing is set.
    pub label: Vec<u32>,
    /// Of every component what it covers; the first one, of number 0, is empty.
    pub all: Vec<Extent>,
}

/// What a component covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// Its pixels.
    pub area: usize,
    /// Its leftmost and uppermost pixels.
    pub low: [usize; 2],
    /// Its rightmost and lowest pixels.
    pub high: [usize; 2],
}

impl Extent {
    /// No pixel.
    pub const NOTHING: Self = Self { area: 0, low: [usize::MAX; 2], high: [0; 2] };

    /// Covers one pixel more.
    pub fn add(&mut self, x: usize, y: usize) {
        self.area += 1;
        self.low = [self.low[0].min(x), self.low[1].min(y)];
        self.high = [self.high[0].max(x), self.high[1].max(y)];
    }
}

/// Which pixels are neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Neighbours {
    /// Those that share a side.
    Four,
    /// Those that share a corner as well.
    Eight,
}

const STEPS: [(i64, i64); 8] = [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)];

impl Neighbours {
    /// The pixels beside this one.
    pub fn of(self, at: usize, width: usize, height: usize) -> impl Iterator<Item = usize> {
        let steps = if self == Self::Four { &STEPS[..4] } else { &STEPS[..] };
        let (x, y) = ((at % width) as i64, (at / width) as i64);
        steps.iter().filter_map(move |(dx, dy)| {
            let (x, y) = (x + dx, y + dy);
            let inside = x >= 0 && y >= 0 && x < width as i64 && y < height as i64;
            inside.then(|| y as usize * width + x as usize)
        })
    }
}

/// The components of what is set, numbered by their first pixel.
pub fn find(set: &[bool], width: usize, neighbours: Neighbours) -> Components {
    let height = set.len().checked_div(width).unwrap_or(0);
    let mut found = Components { label: vec![0; set.len()], all: vec![Extent::NOTHING] };
    let mut queue = Vec::new();
    for start in 0..set.len() {
        if !set[start] || found.label[start] != 0 {
            continue;
        }
        let number = found.all.len() as u32;
        let mut extent = Extent::NOTHING;
        found.label[start] = number;
        queue.push(start);
        while let Some(at) = queue.pop() {
            extent.add(at % width, at / width);
            for next in neighbours.of(at, width, height) {
                if set[next] && found.label[next] == 0 {
                    found.label[next] = number;
                    queue.push(next);
                }
            }
        }
        found.all.push(extent);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_join_only_if_asked() {
        let set = [true, false, false, true];
        assert_eq!(find(&set, 2, Neighbours::Four).label, [1, 0, 0, 2]);
        let whole = find(&set, 2, Neighbours::Eight);
        assert_eq!(whole.label, [1, 0, 0, 1]);
        assert_eq!(whole.all[1], Extent { area: 2, low: [0, 0], high: [1, 1] });
    }
}
