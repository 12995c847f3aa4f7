//! What was found, as tables for people and as JSON for programs.

use super::manifest::SetScores;
use super::measures::{Clip, Measures, RoomScore};
use super::pair::Scores;
use serde::Serialize;

const COLUMNS: [&str; 10] = ["A_FC", "A_BC", "Prec", "Rec", "mIoU", "M50", "nPred", "nGT", "phant", "spill"];

/// A table of one comparison: the measures in percent, then each true room.
pub fn pair_table(name: &str, scores: &Scores, clip: Clip) -> String {
    let score = scores.get(clip);
    let width = name.chars().count().max(3);
    let rooms = rooms_table(&score.rooms, scores.resolution);
    format!("{}{}\n{rooms}", header(width), row(name, &score.measures.values(), width, 0))
}

/// A table of all maps: the measures in percent, their mean and their standard deviation.
pub fn set_table(scores: &SetScores, clip: Clip) -> String {
    let spread = match clip {
        Clip::Known => &scores.summary.clipped,
        Clip::None => &scores.summary.raw,
    };
    let names: Vec<_> = scores.maps.iter().map(|(name, s)| row_name(name, s)).collect();
    let mean = format!("mean of {}", names.len());
    let width = names.iter().map(|n| n.chars().count()).max().unwrap_or(0).max(mean.len());
    let maps = scores.maps.iter().zip(&names);
    let rows: String =
        maps.map(|((_, s), name)| row(name, &s.get(clip).measures.values(), width, 0)).collect();
    let mean = row(&mean, &spread.mean.values(), width, 1);
    let std = row("  +- std", &spread.std.values(), width, 1);
    format!("{}{rows}{mean}{std}{}", header(width), skipped(&scores.skipped))
}

/// The same for programs.
pub fn json(scores: &impl Serialize) -> serde_json::Result<String> {
    Ok(serde_json::to_string_pretty(scores)? + "\n")
}

fn row_name(name: &str, scores: &Scores) -> String {
    let missing = if scores.prediction.is_none() { " (no prediction)" } else { "" };
    printable(name) + missing
}

fn skipped(names: &[String]) -> String {
    match names {
        [] => String::new(),
        names => format!("skipped, having no truth: {}\n", printable(&names.join(", "))),
    }
}

fn header(width: usize) -> String {
    let columns: String = COLUMNS.iter().map(|c| format!(" {c:>6}")).collect();
    format!("{:<width$}{columns}\n", "map")
}

/// One line. Shares are percent with one digit after the point, counts have `digits`.
fn row(name: &str, values: &[f64; 10], width: usize, digits: usize) -> String {
    let cell = |(i, v): (usize, &f64)| match COLUMNS[i] {
        "M50" | "nPred" | "nGT" | "phant" => format!(" {v:>6.digits$}"),
        _ => format!(" {:>6.1}", 100.0 * v),
    };
    let cells: String = values.iter().enumerate().map(cell).collect();
    format!("{:<width$}{cells}\n", printable(name))
}

fn rooms_table(rooms: &[RoomScore], resolution: f64) -> String {
    let longest = rooms.iter().map(|r| r.room.chars().count()).max().unwrap_or(0);
    let width = longest.clamp(9, 40);
    let line = |r: &RoomScore| {
        let area = r.pixels as f64 * resolution * resolution;
        let prediction = r.prediction.as_deref().map_or("-".into(), printable);
        let (iou, covered) = (100.0 * r.iou, 100.0 * r.covered);
        format!("{:<width$} {area:>8.2} {covered:>7.1} {iou:>6.1}  {prediction}\n", printable(&r.room))
    };
    let lines: String = rooms.iter().map(line).collect();
    format!("{:<width$} {:>8} {:>7} {:>6}  matched with\n{lines}", "true room", "m2", "covered", "IoU")
}

/// What a file says must not steer the terminal.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '?' } else { c }).collect()
}

impl Measures {
    /// All values in the order of the tables.
    pub fn values(&self) -> [f64; 10] {
        self.as_f64().values()
    }

    fn as_f64(&self) -> Measures<f64> {
        let [m50, n_pred, n_gt, n_phantom] =
            [self.m50, self.n_pred, self.n_gt, self.n_phantom].map(|n| n as f64);
        let Self { a_fc, a_bc, precision, recall, miou, spill, .. } = *self;
        Measures { a_fc, a_bc, precision, recall, miou, m50, n_pred, n_gt, n_phantom, spill }
    }
}

impl Measures<f64> {
    /// All values in the order of the tables.
    pub fn values(&self) -> [f64; 10] {
        let Self { a_fc, a_bc, precision, recall, miou, m50, n_pred, n_gt, n_phantom, spill } = *self;
        [a_fc, a_bc, precision, recall, miou, m50, n_pred, n_gt, n_phantom, spill]
    }

    /// The measures with these values.
    pub fn from_values(values: [f64; 10]) -> Self {
        let [a_fc, a_bc, precision, recall, miou, m50, n_pred, n_gt, n_phantom, spill] = values;
        Self { a_fc, a_bc, precision, recall, miou, m50, n_pred, n_gt, n_phantom, spill }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_line_up_with_the_header() {
        let values = [1.0, 0.5, 0.25, 0.125, 0.0, 3.0, 12.0, 400.0, 0.0, 0.999];
        let line = row("a\u{1b}b", &values, 5, 0);
        assert_eq!(line.chars().count(), header(5).chars().count());
        assert!(line.starts_with("a?b    100.0   50.0"), "{line}");
        assert!(line.contains("     3     12    400      0   99.9"), "{line}");
    }
}
