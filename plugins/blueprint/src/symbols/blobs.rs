//! Connected pixels.

use crate::mask::Mask;

/// Pixels of a mask that hang together, corners included.
#[derive(Debug, Clone, PartialEq)]
pub struct Blob {
    /// Left, top, right and bottom; the last two are one past.
    pub bounds: [u32; 4],
    /// How many pixels.
    pub count: u32,
}

impl Blob {
    /// Columns and rows of its bounds.
    pub fn size(&self) -> [u32; 2] {
        let [left, top, right, bottom] = self.bounds;
        [right - left, bottom - top]
    }
}

/// All blobs of a mask, by where their first pixel lies, row by row.
pub fn blobs(mask: &Mask) -> Vec<Blob> {
    let mut left = mask.clone();
    let mut found = Vec::new();
    for i in 0..left.set.len() {
        if left.set[i] {
            found.push(take(&mut left, i));
        }
    }
    found
}

/// Takes the blob that holds this pixel off the mask.
fn take(mask: &mut Mask, start: usize) -> Blob {
    let width = mask.width as usize;
    let mut blob = Blob { bounds: [u32::MAX, u32::MAX, 0, 0], count: 0 };
    let mut open = vec![start];
    mask.set[start] = false;
    while let Some(i) = open.pop() {
        let (x, y) = ((i % width) as i64, (i / width) as i64);
        grow(&mut blob, x as u32, y as u32);
        for (nx, ny) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy))) {
            if mask.get(nx, ny) {
                let n = ny as usize * width + nx as usize;
                mask.set[n] = false;
                open.push(n);
            }
        }
    }
    blob
}

fn grow(blob: &mut Blob, x: u32, y: u32) {
    let [left, top, right, bottom] = blob.bounds;
    blob.bounds = [left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)];
    blob.count += 1;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_hang_together() {
        let mut mask = Mask::empty(6, 4);
        for i in [0, 7, 14, 5, 23] {
            mask.set[i] = true;
        }
        let found: Vec<_> = blobs(&mask).into_iter().map(|b| (b.bounds, b.count)).collect();
        assert_eq!(found, [([0, 0, 3, 3], 3), ([5, 0, 6, 1], 1), ([5, 3, 6, 4], 1)]);
    }
}
