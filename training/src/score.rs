//! How good the rooms of a model are.

use crate::samples::Lesson;
use planform::evaluate::measures::measure;
use planform::evaluate::{Clip, LabelImage, Measures, Overlap};
use planform::reconstruct::Params;
use planform::reconstruct::basins::merge;
use planform::reconstruct::basins::model::Model;
use planform::reconstruct::basins::regions::Regions;

/// The room of each cell of the map's grid.
pub fn rooms(lesson: &Lesson<'_>, model: &Model, params: &Params) -> Vec<u32> {
    let view = lesson.cut.view();
    let mut regions = Regions::of_basins(&view, &lesson.cut.basins);
    merge::rooms(&mut regions, model, &params.merge);
    let labels = lesson.cut.grown_labels(&regions);
    lesson.cut.on_grid(&lesson.map.grid, |i| labels[i])
}

/// The measures of a model's rooms on a map.
pub fn score(lesson: &Lesson<'_>, model: &Model, params: &Params) -> Measures {
    let truth = &lesson.map.truth;
    let rooms = rooms(lesson, model, params);
    let count = rooms.iter().max().copied().unwrap_or(0);
    let labels = rooms.chunks(truth.width).rev().flatten().copied().collect();
    let names = (1..=count).map(|n| n.to_string()).collect();
    let found = LabelImage { width: truth.width, height: truth.height, labels, names };
    let overlap = Overlap::of_images(&found, truth).unwrap_or_default();
    measure(&overlap, Clip::Known, lesson.map.min_px as f64).measures
}
