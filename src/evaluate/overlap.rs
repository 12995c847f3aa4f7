//! How many pixels each predicted room shares with each true one.

use super::budget::Budget;
use super::error::{bad, limit};
use super::labels::LabelImage;
use super::raster::{Size, scan};
use super::rooms::RoomShape;
use planform_sdk::PluginError;
use std::collections::BTreeMap;

/// The pixels that predicted and true rooms share. All that the measures need.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Overlap {
    /// Name and pixels of each true room.
    pub truth: Vec<(String, u64)>,
    /// The predicted rooms.
    pub predicted: Vec<PredictedRoom>,
}

/// A predicted room, counted on its own: predicted rooms may overlap.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PredictedRoom {
    /// What to call it.
    pub name: String,
    /// The pixels that it covers.
    pub pixels: u64,
    /// The true rooms that it overlaps, as indices into [`Overlap::truth`] in rising order, and the pixels shared.
    pub shared: Vec<(usize, u64)>,
}

/// The most pairs of rooms that overlap.
const MAX_PAIRS: usize = 1 << 24;

impl Overlap {
    /// The overlap of rooms, in pixels of the truth, y down. Pixels outside the truth's image are lost.
    pub fn of_rooms(rooms: &[RoomShape], truth: &LabelImage) -> Result<Self, PluginError> {
        let size = Size { width: truth.width, height: truth.height };
        let mut budget = Budget::new(Budget::STEPS);
        let mut counts = vec![0; truth.names.len()];
        let mut pairs = 0;
        let mut overlap = Self::of_nothing(truth);
        for room in rooms {
            let mut pixels = 0;
            let mut touched = vec![];
            scan(&room.parts, size, &mut budget, |row, columns| {
                pixels += columns.len() as u64;
                let start = row * truth.width;
                count(&truth.labels[start + columns.start..start + columns.end], &mut counts, &mut touched);
            })?;
            let shared = take(&mut counts, touched);
            overlap.push(PredictedRoom { name: room.name.clone(), pixels, shared }, &mut pairs)?;
        }
        Ok(overlap)
    }

    /// The overlap of the rooms of a label image of the same size.
    pub fn of_images(prediction: &LabelImage, truth: &LabelImage) -> Result<Self, PluginError> {
        let (p, t) = (prediction, truth);
        if (p.width, p.height) != (t.width, t.height) {
            let message = format!(
                "has {} x {} pixels, but its truth has {} x {}",
                p.width, p.height, t.width, t.height
            );
            return Err(bad(message).advise("give an image of the same size"));
        }
        let mut shared = vec![BTreeMap::new(); p.names.len()];
        for (&room, &other) in p.labels.iter().zip(&t.labels).filter(|(p, t)| **p > 0 && **t > 0) {
            *shared[room as usize - 1].entry(other as usize - 1).or_insert(0) += 1;
        }
        let mut pairs = 0;
        let mut overlap = Self::of_nothing(t);
        for ((name, pixels), shared) in p.names.iter().cloned().zip(p.areas()).zip(shared) {
            overlap.push(PredictedRoom { name, pixels, shared: shared.into_iter().collect() }, &mut pairs)?;
        }
        Ok(overlap)
    }

    /// The overlap of no rooms: that of a prediction that is missing.
    pub fn of_nothing(truth: &LabelImage) -> Self {
        Self { truth: truth.names.iter().cloned().zip(truth.areas()).collect(), predicted: vec![] }
    }

    fn push(&mut self, room: PredictedRoom, pairs: &mut usize) -> Result<(), PluginError> {
        *pairs += room.shared.len();
        self.predicted.push(room);
        if *pairs > MAX_PAIRS { Err(limit("overlaps too many rooms of the truth")) } else { Ok(()) }
    }
}

/// Counts the pixels of each true room, and notes which ones were met.
fn count(labels: &[u32], counts: &mut [u64], touched: &mut Vec<usize>) {
    for run in labels.chunk_by(|a, b| a == b) {
        let Some(room) = (run[0] as usize).checked_sub(1) else { continue };
        if counts[room] == 0 {
            touched.push(room);
        }
        counts[room] += run.len() as u64;
    }
}

/// The counts of the rooms met, which are set back to zero.
fn take(counts: &mut [u64], mut touched: Vec<usize>) -> Vec<(usize, u64)> {
    touched.sort_unstable();
    touched.into_iter().map(|room| (room, std::mem::take(&mut counts[room]))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use planform_sdk::{Point, Polygon};

    /// 1 1 0
    /// 1 2 2
    fn truth() -> LabelImage {
        LabelImage {
            width: 3,
            height: 2,
            labels: vec![1, 1, 0, 1, 2, 2],
            names: vec!["a".into(), "b".into()],
        }
    }

    fn square(x0: f64, y0: f64, x1: f64, y1: f64) -> RoomShape {
        let ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(Point::from).to_vec();
        RoomShape { name: "r".into(), parts: vec![Polygon::new(ring, vec![])] }
    }

    fn shared(rooms: &[RoomShape]) -> Vec<(u64, Vec<(usize, u64)>)> {
        let overlap = Overlap::of_rooms(rooms, &truth()).unwrap();
        overlap.predicted.into_iter().map(|r| (r.pixels, r.shared)).collect()
    }

    #[test]
    fn overlapping_predictions_count_each_on_its_own() {
        let rooms = [square(0.0, 0.0, 2.0, 2.0), square(1.0, 0.0, 3.0, 2.0), square(2.0, 0.0, 9.0, 1.0)];
        let expected = [(4, vec![(0, 3), (1, 1)]), (4, vec![(0, 1), (1, 2)]), (1, vec![])];
        assert_eq!(shared(&rooms), expected);
    }

    #[test]
    fn images_must_have_one_size() {
        let mut other = truth();
        assert_eq!(Overlap::of_images(&other, &truth()).unwrap().predicted[1].shared, [(1, 2)]);
        (other.width, other.height) = (2, 3);
        assert!(Overlap::of_images(&other, &truth()).is_err());
    }
}
