//! The measures of Bormann et al. and their relatives.
//!
//! For a predicted room r, FC(r) is the true room that it overlaps most; for a true room r', BC(r') is the predicted
//! one. Both kinds of rooms count only above the smallest room.
//!
//! | measure | meaning |
//! | --- | --- |
//! | A_FC | sum of area(r and FC(r)) over sum of area(r): low when rooms are merged |
//! | A_BC | sum of area(BC(r') and r') over sum of area(r'): low when rooms are split or missed |
//! | P, precision | mean over r of area(r and FC(r)) / area(r) |
//! | R, recall | mean over r' of area(BC(r') and r') / area(r') |
//! | mIoU | mean over r' of the intersection over union in a one-to-one matching, the best pairs first |
//! | M50 | matched pairs with an intersection over union of at least one half |
//! | spill | share of the predicted area that lies in no true room |

use super::overlap::{Overlap, PredictedRoom};
use serde::Serialize;

/// What becomes of predicted pixels that lie in no true room: walls, and what the truth does not know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Clip {
    /// They are ignored. A predicted room of which no more than the smallest room is left is a phantom: its precision
    /// is 0, and its whole area counts in the denominator of A_FC.
    #[default]
    Known,
    /// They count, as in Bormann et al.
    None,
}

/// The measures of one comparison, as shares of 1, and counts. `N` is the type of the counts.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Measures<N = u64> {
    /// Area-weighted share of the predicted rooms that lies in their best true room.
    #[serde(rename = "A_FC")]
    pub a_fc: f64,
    /// Area-weighted share of the true rooms that their best predicted room covers.
    #[serde(rename = "A_BC")]
    pub a_bc: f64,
    /// Precision: the mean over predicted rooms.
    #[serde(rename = "P")]
    pub precision: f64,
    /// Recall: the mean over true rooms.
    #[serde(rename = "R")]
    pub recall: f64,
    /// Mean intersection over union of the true rooms with their matches.
    #[serde(rename = "mIoU")]
    pub miou: f64,
    /// Matches with an intersection over union of at least one half.
    #[serde(rename = "M50")]
    pub m50: N,
    /// Predicted rooms.
    pub n_pred: N,
    /// True rooms.
    pub n_gt: N,
    /// Predicted rooms where the truth shows none.
    pub n_phantom: N,
    /// Share of the predicted area that lies in no true room.
    pub spill: f64,
}

/// How well one true room was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoomScore {
    /// The true room.
    pub room: String,
    /// Its pixels.
    pub pixels: u64,
    /// The predicted room matched with it.
    pub prediction: Option<String>,
    /// Intersection over union with the match; 0 without one.
    pub iou: f64,
    /// Share of it that the predicted room with the largest overlap covers.
    pub covered: f64,
}

/// The measures of one comparison, and of each true room.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Score {
    /// Over all rooms.
    #[serde(flatten)]
    pub measures: Measures,
    /// Each true room.
    pub rooms: Vec<RoomScore>,
}

/// Measures an overlap. Predicted rooms of at most `min_px` pixels do not count.
pub fn measure(overlap: &Overlap, clip: Clip, min_px: f64) -> Score {
    let large: Vec<_> = overlap.predicted.iter().filter(|r| r.pixels as f64 > min_px).collect();
    let counted: Vec<_> = large.iter().map(|r| Counted::new(r, clip, min_px)).collect();
    let covered = best_cover(&counted, overlap.truth.len());
    let matches = matches(&counted, overlap);
    let found = rooms(overlap, &counted, &covered, &matches);
    let mut measures = Measures {
        n_pred: counted.len() as u64,
        n_gt: overlap.truth.len() as u64,
        n_phantom: counted.iter().filter(|c| c.phantom).count() as u64,
        ..Measures::default()
    };
    if !counted.is_empty() && !found.is_empty() {
        forward(&mut measures, &counted);
        backward(&mut measures, &found, &covered);
        measures.spill = spill(&large);
    }
    Score { measures, rooms: found }
}

/// A predicted room as the clipping leaves it.
struct Counted<'a> {
    name: &'a str,
    area: f64,
    shared: &'a [(usize, u64)],
    phantom: bool,
}

impl<'a> Counted<'a> {
    fn new(room: &'a PredictedRoom, clip: Clip, min_px: f64) -> Self {
        let (whole, known) = (room.pixels as f64, known(room) as f64);
        let phantom = clip == Clip::Known && known <= min_px;
        let area = if clip == Clip::Known && !phantom { known } else { whole };
        Self { name: &room.name, area, shared: if phantom { &[] } else { &room.shared }, phantom }
    }

    fn best(&self) -> f64 {
        self.shared.iter().map(|&(_, pixels)| pixels).max().unwrap_or(0) as f64
    }
}

/// The pixels that lie in true rooms.
fn known(room: &PredictedRoom) -> u64 {
    room.shared.iter().map(|&(_, pixels)| pixels).sum()
}

/// The most pixels of each true room that one predicted room covers.
fn best_cover(counted: &[Counted<'_>], rooms: usize) -> Vec<u64> {
    let mut best = vec![0; rooms];
    for &(room, pixels) in counted.iter().flat_map(|c| c.shared) {
        best[room] = pixels.max(best[room]);
    }
    best
}

/// The match of each true room: the index of a predicted room and the intersection over union.
///
/// The pair with the largest value is matched first; of equals, the one that is first in the prediction and then in
/// the truth.
fn matches(counted: &[Counted<'_>], overlap: &Overlap) -> Vec<Option<(usize, f64)>> {
    let mut pairs: Vec<_> = counted
        .iter()
        .enumerate()
        .flat_map(|(i, c)| {
            c.shared.iter().map(move |&(j, pixels)| (iou(c, overlap.truth[j].1, pixels), i, j))
        })
        .collect();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut taken = vec![false; counted.len()];
    let mut matches = vec![None; overlap.truth.len()];
    for (iou, i, j) in pairs {
        if !taken[i] && matches[j].is_none() {
            taken[i] = true;
            matches[j] = Some((i, iou));
        }
    }
    matches
}

fn iou(room: &Counted<'_>, truth: u64, shared: u64) -> f64 {
    shared as f64 / (room.area + truth as f64 - shared as f64)
}

fn rooms(
    overlap: &Overlap,
    counted: &[Counted<'_>],
    covered: &[u64],
    matches: &[Option<(usize, f64)>],
) -> Vec<RoomScore> {
    let mut rooms = vec![];
    for (((name, pixels), covered), found) in overlap.truth.iter().zip(covered).zip(matches) {
        rooms.push(RoomScore {
            room: name.clone(),
            pixels: *pixels,
            prediction: found.map(|(i, _)| counted[i].name.into()),
            iou: found.map_or(0.0, |(_, iou)| iou),
            covered: *covered as f64 / *pixels as f64,
        });
    }
    rooms
}

/// The measures over predicted rooms.
fn forward(measures: &mut Measures, counted: &[Counted<'_>]) {
    let best: f64 = counted.iter().map(Counted::best).sum();
    measures.a_fc = best / counted.iter().map(|c| c.area).sum::<f64>();
    measures.precision = mean(counted.iter().map(|c| c.best() / c.area));
}

/// The measures over true rooms.
fn backward(measures: &mut Measures, rooms: &[RoomScore], covered: &[u64]) {
    measures.a_bc = covered.iter().sum::<u64>() as f64 / rooms.iter().map(|r| r.pixels).sum::<u64>() as f64;
    measures.recall = mean(rooms.iter().map(|r| r.covered));
    measures.miou = mean(rooms.iter().map(|r| r.iou));
    measures.m50 = rooms.iter().filter(|r| r.iou >= 0.5).count() as u64;
}

fn spill(rooms: &[&PredictedRoom]) -> f64 {
    let all: u64 = rooms.iter().map(|r| r.pixels).sum();
    1.0 - rooms.iter().map(|r| known(r)).sum::<u64>() as f64 / all as f64
}

/// The mean of at least one value.
pub(super) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = values.len() as f64;
    values.sum::<f64>() / n
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two true rooms of 600 and 200 pixels, and predicted rooms: pixels, shared with each.
    fn overlap(predicted: &[(u64, [u64; 2])]) -> Overlap {
        let room = |&(pixels, shared): &(u64, [u64; 2])| PredictedRoom {
            name: format!("{pixels}"),
            pixels,
            shared: shared.into_iter().enumerate().filter(|&(_, n)| n > 0).collect(),
        };
        Overlap {
            truth: vec![("a".into(), 600), ("b".into(), 200)],
            predicted: predicted.iter().map(room).collect(),
        }
    }

    fn known(predicted: &[(u64, [u64; 2])]) -> Measures {
        measure(&overlap(predicted), Clip::Known, 100.0).measures
    }

    fn raw(predicted: &[(u64, [u64; 2])]) -> Measures {
        measure(&overlap(predicted), Clip::None, 100.0).measures
    }

    #[test]
    fn perfect_rooms_score_1() {
        let all =
            Measures { a_fc: 1.0, a_bc: 1.0, precision: 1.0, recall: 1.0, miou: 1.0, ..Measures::default() };
        let expected = Measures { m50: 2, n_pred: 2, n_gt: 2, ..all };
        assert_eq!(known(&[(600, [600, 0]), (200, [0, 200])]), expected);
        assert_eq!(raw(&[(600, [600, 0]), (200, [0, 200])]), expected);
    }

    #[test]
    fn merged_rooms_lose_precision() {
        let m = known(&[(1000, [600, 200])]);
        assert_eq!((m.a_fc, m.precision, m.a_bc, m.recall), (0.75, 0.75, 1.0, 1.0));
        assert_eq!((m.miou, m.m50), (0.375, 1));
        let m = raw(&[(1000, [600, 200])]);
        assert_eq!((m.a_fc, m.precision, m.recall, m.miou), (0.6, 0.6, 1.0, 0.3));
        assert!((m.spill - 0.2).abs() < 1e-15);
    }

    #[test]
    fn split_rooms_lose_recall() {
        let m = known(&[(300, [300, 0]), (300, [300, 0]), (200, [0, 200])]);
        assert_eq!((m.a_fc, m.precision), (1.0, 1.0));
        assert_eq!((m.a_bc, m.recall, m.miou, m.m50), (500.0 / 800.0, 0.75, 0.75, 2));
    }

    #[test]
    fn a_phantom_counts_with_its_whole_area() {
        let m = known(&[(600, [600, 0]), (200, [0, 200]), (800, [100, 0])]);
        assert_eq!((m.n_phantom, m.n_pred, m.a_fc, m.precision), (1, 3, 0.5, 2.0 / 3.0));
        assert_eq!((m.a_bc, m.miou), (1.0, 1.0));
        assert_eq!(known(&[(800, [101, 0])]).n_phantom, 0);
        assert_eq!(raw(&[(800, [100, 0])]).n_phantom, 0);
    }

    #[test]
    fn a_missed_room_counts_0() {
        let m = known(&[(600, [600, 0])]);
        assert_eq!((m.a_fc, m.a_bc, m.recall, m.miou), (1.0, 0.75, 0.5, 0.5));
    }

    #[test]
    fn overlapping_predictions_match_one_to_one() {
        let score = measure(&overlap(&[(600, [500, 100]), (700, [600, 100])]), Clip::Known, 100.0);
        let found: Vec<_> = score.rooms.iter().map(|r| (r.prediction.as_deref(), r.iou, r.covered)).collect();
        assert_eq!(found, [(Some("700"), 600.0 / 700.0, 1.0), (Some("600"), 100.0 / 700.0, 0.5)]);
    }

    #[test]
    fn of_equal_pairs_the_first_is_matched() {
        let score = measure(&overlap(&[(300, [300, 0]), (300, [300, 100])]), Clip::None, 100.0);
        assert_eq!(score.rooms[0].prediction.as_deref(), Some("300"));
        let mut twins = overlap(&[(200, [100, 100]), (200, [100, 100])]);
        twins.truth[0].1 = 200;
        twins.predicted[1].name = "second".into();
        let score = measure(&twins, Clip::None, 10.0);
        assert_eq!(score.rooms[0].prediction.as_deref(), Some("200"));
        assert_eq!(score.rooms[1].prediction.as_deref(), Some("second"));
    }

    #[test]
    fn small_predictions_do_not_count() {
        let m = known(&[(600, [600, 0]), (100, [0, 100])]);
        assert_eq!((m.n_pred, m.recall), (1, 0.5));
        assert_eq!(known(&[(101, [0, 101])]).n_pred, 1);
    }

    #[test]
    fn nothing_predicted_scores_0() {
        assert_eq!(known(&[]), Measures { n_gt: 2, ..Measures::default() });
        assert_eq!(measure(&Overlap::default(), Clip::Known, 0.0), Score::default());
    }

    #[test]
    fn a_prediction_without_any_overlap_is_all_spill() {
        let m = known(&[(400, [0, 0])]);
        assert_eq!((m.a_fc, m.spill, m.n_phantom), (0.0, 1.0, 1));
    }
}
