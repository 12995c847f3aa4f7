//! Connected components of a mask, by runs and union-find (Rosenfeld and Pfaltz 1966).

use std::ops::Range;

/// Numbers the 8-connected components of a mask, row by row: 0 outside, and for each component one number above it.
/// The numbers have gaps.
pub(super) fn components(mask: &[bool], width: usize) -> Vec<u32> {
    let mut labels = vec![0; mask.len()];
    if width == 0 {
        return labels;
    }
    let mut parents = vec![0];
    let mut above = vec![];
    for (mask, labels) in mask.chunks(width).zip(labels.chunks_mut(width)) {
        let runs: Vec<Run> = runs(mask).map(|run| (run.clone(), join(&mut parents, &above, &run))).collect();
        for (run, root) in &runs {
            labels[run.clone()].fill(*root);
        }
        above = runs;
    }
    for label in &mut labels {
        *label = find(&mut parents, *label);
    }
    labels
}

/// A stretch of a row and the component that it was put in.
type Run = (Range<usize>, u32);

fn runs(mask: &[bool]) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut end = 0;
    mask.chunk_by(|a, b| a == b).filter_map(move |chunk| {
        let run = end..end + chunk.len();
        end = run.end;
        chunk[0].then_some(run)
    })
}

/// Joins all components of the row above that the run touches, corners included, and returns their number. The first
/// from the left gives it its number; a run that touches none begins a component.
fn join(parents: &mut Vec<u32>, above: &[Run], run: &Range<usize>) -> u32 {
    let first = above.partition_point(|(other, _)| other.end < run.start);
    let touched = above[first..].iter().take_while(|(other, _)| other.start <= run.end);
    let mut root = 0;
    for (_, label) in touched {
        let other = find(parents, *label);
        if root == 0 {
            root = other;
        }
        parents[other as usize] = root;
    }
    if root == 0 {
        root = parents.len() as u32;
        parents.push(root);
    }
    root
}

fn find(parents: &mut [u32], mut label: u32) -> u32 {
    while parents[label as usize] != label {
        parents[label as usize] = parents[parents[label as usize] as usize];
        label = parents[label as usize];
    }
    label
}

#[cfg(test)]
mod tests {
    use super::*;

    fn label(rows: &[&str]) -> Vec<u32> {
        let mask: Vec<_> = rows.iter().flat_map(|r| r.bytes().map(|c| c == b'#')).collect();
        components(&mask, rows[0].len())
    }

    fn count(rows: &[&str]) -> usize {
        let mut labels = label(rows);
        labels.retain(|&l| l > 0);
        labels.sort_unstable();
        labels.dedup();
        labels.len()
    }

    #[test]
    fn corners_connect() {
        assert_eq!(count(&["#.#...", ".#....", "......", "......", "....#.", "#....."]), 3);
        assert_eq!(count(&[".#", "#."]), 1);
        assert_eq!(count(&["#..#", ".##."]), 1);
    }

    #[test]
    fn rows_do_not_wrap_around() {
        assert_eq!(count(&["...#", "#..."]), 2);
    }

    #[test]
    fn arms_join_below() {
        assert_eq!(count(&["#.#.#", "#.#.#", "#####"]), 1);
        assert_eq!(label(&["..#", "#.#", "###"]), [0, 0, 2, 2, 0, 2, 2, 2, 2]);
    }

    #[test]
    fn nothing_and_everything() {
        assert_eq!(count(&["..", ".."]), 0);
        assert_eq!(count(&["##", "##"]), 1);
        assert!(components(&[], 0).is_empty());
    }
}
